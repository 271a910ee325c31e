// SPDX-License-Identifier: Apache-2.0
// Nearest points on free-form surfaces, and where straight lines meet them.
#include <GeomAPI_IntCS.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <algorithm>

#include "geometry/analytic.h"
#include "geometry/free_eval.h"
#include "geometry/nearest.h"
#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"

namespace aresta {

struct SurfaceSamples {
  std::vector<double> u, v;
  std::vector<Vec3> points;  ///< points[i * v.size() + j]
};

namespace free_form {

using occt::vec;

namespace {

const Handle(Geom_Surface) & of(const FreeSurface& s) {
  return s.handle().surface;
}

/// Parameters of the samples in one direction: a few per span of the knots inside the range.
std::vector<double> sample_line(std::vector<double> breaks, Range range) {
  std::vector<double> at{range.low};
  for (const double b : breaks) {
    if (b > at.back() && b < range.high) at.push_back(b);
  }
  at.push_back(range.high);
  const std::size_t spans = at.size() - 1;
  const std::size_t each = spans > 60 ? 2 : spans > 12 ? 4 : spans > 3 ? 7 : 16;
  std::vector<double> result;
  for (std::size_t i = 0; i < spans; ++i) {
    for (std::size_t k = 0; k < each; ++k) {
      result.push_back(at[i] + (at[i + 1] - at[i]) * static_cast<double>(k) / static_cast<double>(each));
    }
  }
  result.push_back(range.high);
  return result;
}

SurfaceSamples sampled(const FreeSurface& s, const Range2& box) {
  std::vector<double> breaks_u, breaks_v;
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(of(s))) {
    for (int i = 1; i <= spline->NbUKnots(); ++i) breaks_u.push_back(spline->UKnot(i));
    for (int i = 1; i <= spline->NbVKnots(); ++i) breaks_v.push_back(spline->VKnot(i));
  }
  SurfaceSamples g{sample_line(breaks_u, box.u), sample_line(breaks_v, box.v), {}};
  g.points.reserve(g.u.size() * g.v.size());
  for (const double u : g.u) {
    for (const double v : g.v) g.points.push_back(point(s, {u, v}));
  }
  return g;
}

/// An unbounded direction cut where the surface is farther from its middle than p is, twice over.
Range finite_part(const FreeSurface& s, Range range, Range other, bool along_u, Vec3 p) {
  if (std::isfinite(range.low) && std::isfinite(range.high)) return range;
  const double fixed = std::isfinite(other.low) && std::isfinite(other.high) ? other.middle() : other.clamp(0);
  const auto at = [&](double t) { return point(s, along_u ? Vec2{t, fixed} : Vec2{fixed, t}); };
  const double start = range.clamp(0);
  const Vec3 origin = at(start);
  const double reach = 4 * distance(origin, p) + 1e-9;
  const auto end = [&](double sign) {
    double step = 1;
    while (step < 1e30 && distance(at(start + sign * step), origin) < reach) step *= 2;
    return start + sign * step;
  };
  return {std::isfinite(range.low) ? range.low : end(-1), std::isfinite(range.high) ? range.high : end(1)};
}

/// A parameter moved by whole periods to within half a period of the hint, or into the domain.
double unwrapped(double x, double period, const double* hint, double low) {
  if (period <= 0) return x;
  if (hint != nullptr) return x - period * std::round((x - *hint) / period);
  return x - period * std::floor((x - low) / period);
}

SurfaceProjection with_branch(SurfaceProjection r, const FreeSurface& s, const Vec2* hint) {
  const Vec2 p = period(s);
  const Range2 d = domain(s);
  r.uv.x = unwrapped(r.uv.x, p.x, hint != nullptr ? &hint->x : nullptr, d.u.low);
  r.uv.y = unwrapped(r.uv.y, p.y, hint != nullptr ? &hint->y : nullptr, d.v.low);
  return r;
}

/// Local searches may cross a seam: a periodic direction is open.
Range2 search_box(const FreeSurface& s) {
  Range2 box = domain(s);
  const Vec2 p = period(s);
  if (p.x > 0) box.u = {-analytic::infinity, analytic::infinity};
  if (p.y > 0) box.v = {-analytic::infinity, analytic::infinity};
  return box;
}

/// p moved along the direction of extrusion onto the basis curve's nearest point: one search in u, then v in closed
/// form.
SurfaceProjection project_extrusion(const Handle(Geom_SurfaceOfLinearExtrusion) & s, Vec3 p, const Vec2* hint) {
  const Curve basis = from_occt(s->BasisCurve());
  const gp_Dir dd = s->Direction();
  const Vec3 d{dd.X(), dd.Y(), dd.Z()};
  const auto flat = [&](Vec3 a) { return a - dot(a, d) * d; };
  const auto jet_of = [&](double t) {
    const CurveJet j = basis.jet(t);
    return CurveJet{flat(j.point), flat(j.d1), flat(j.d2)};
  };
  const Vec3 target = flat(p);
  Range range = basis.domain();
  CurveProjection best;
  best.distance = analytic::infinity;
  const auto consider = [&](double start, double low, double high) {
    const CurveProjection c = nearest::on_curve(jet_of, target, start, low, high);
    if (c.distance < best.distance) best = c;
  };
  for (double reach = 1; !std::isfinite(range.length()) && reach < 1e30; reach *= 2) {
    const double far = 2 * distance(target, flat(basis.point(0))) + 1e-9;
    const bool low_done = std::isfinite(range.low) || distance(flat(basis.point(-reach)), flat(basis.point(0))) > far;
    const bool high_done = std::isfinite(range.high) || distance(flat(basis.point(reach)), flat(basis.point(0))) > far;
    if (low_done && high_done) {
      if (!std::isfinite(range.low)) range.low = -reach;
      if (!std::isfinite(range.high)) range.high = reach;
    }
  }
  std::vector<double> at{range.low, range.high};
  if (const auto* free = basis.get_if<FreeCurve>()) at = smooth_breaks(*free, range);
  constexpr int per_span = 16;
  std::vector<double> t;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    for (int k = 0; k < per_span; ++k) t.push_back(at[i] + (at[i + 1] - at[i]) * k / per_span);
  }
  t.push_back(range.high);
  std::vector<double> dist;
  for (const double x : t) dist.push_back(distance(flat(basis.point(x)), target));
  for (std::size_t i = 0; i < t.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, t.size() - 1);
    if (dist[i] <= dist[before] && dist[i] <= dist[after]) consider(t[i], t[before], t[after]);
  }
  const double u = unwrapped(best.parameter, basis.period(), hint != nullptr ? &hint->x : nullptr, range.low);
  const Vec3 foot = basis.point(u);
  const double v = dot(p - foot, d);
  const Vec3 q = foot + v * d;
  return {{u, v}, q, distance(p, q)};
}

}  // namespace

SurfaceProjection project(const FreeSurface& s, Vec3 p, const Vec2* hint) {
  if (!is_finite(p)) return {{}, occt::nowhere, occt::nan};
  const auto eval = [&](Vec2 uv) { return jet(s, uv); };
  if (hint != nullptr && std::isfinite(hint->x) && std::isfinite(hint->y)) {
    const nearest::OnSurface local = nearest::on_surface(eval, p, *hint, search_box(s));
    if (local.converged && local.projection.distance <= distance(point(s, *hint), p)) {
      return with_branch(local.projection, s, hint);
    }
  }
  if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(of(s))) {
    return project_extrusion(extrusion, p, hint);
  }
  Range2 box = domain(s);
  const bool bounded = std::isfinite(box.u.length()) && std::isfinite(box.v.length());
  SurfaceSamples own;
  if (!bounded) {
    const Range2 whole = box;
    box.u = finite_part(s, whole.u, whole.v, true, p);
    box.v = finite_part(s, whole.v, whole.u, false, p);
    own = sampled(s, box);
  }
  const SurfaceSamples& grid = bounded ? s.handle().samples.get([&] { return sampled(s, box); }) : own;
  const std::size_t nu = grid.u.size(), nv = grid.v.size();
  std::vector<double> d(grid.points.size());
  for (std::size_t k = 0; k < d.size(); ++k) d[k] = norm2(grid.points[k] - p);
  std::vector<std::size_t> minima;
  for (std::size_t i = 0; i < nu; ++i) {
    for (std::size_t j = 0; j < nv; ++j) {
      bool least = true;
      for (std::size_t a = i == 0 ? 0 : i - 1; a <= std::min(i + 1, nu - 1) && least; ++a) {
        for (std::size_t b = j == 0 ? 0 : j - 1; b <= std::min(j + 1, nv - 1); ++b) {
          if (d[a * nv + b] < d[i * nv + j]) {
            least = false;
            break;
          }
        }
      }
      if (least) minima.push_back(i * nv + j);
    }
  }
  std::stable_sort(minima.begin(), minima.end(), [&](std::size_t a, std::size_t b) { return d[a] < d[b]; });
  if (minima.size() > 8) minima.resize(8);
  SurfaceProjection best;
  best.distance = analytic::infinity;
  const Range2 open = search_box(s);
  for (const std::size_t k : minima) {
    const Vec2 start{grid.u[k / nv], grid.v[k % nv]};
    const nearest::OnSurface local = nearest::on_surface(eval, p, start, open);
    if (local.projection.distance < best.distance) best = local.projection;
  }
  return with_branch(best, s, hint);
}

std::vector<LineHit> intersect(const FreeSurface& s, const Line& line, const Range2& near) {
  std::vector<LineHit> hits;
  if (!std::isfinite(near.u.length()) || !std::isfinite(near.v.length())) return hits;
  return occt::guarded(
      [&] {
        const Box3 box = bounds(s, near);
        const Range reach = [&] {
          Range r{analytic::infinity, -analytic::infinity};
          for (int corner = 0; corner < 8; ++corner) {
            const Vec3 c{corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                         corner & 4 ? box.high.z : box.low.z};
            const double t = dot(c - line.origin, line.direction);
            r = {std::min(r.low, t), std::max(r.high, t)};
          }
          const double slack = 1e-3 * r.length() + 1e-9;
          return Range{r.low - slack, r.high + slack};
        }();
        const Handle(Geom_TrimmedCurve) part = new Geom_TrimmedCurve(to_occt(Curve(line)), reach.low, reach.high);
        const Handle(Geom_RectangularTrimmedSurface) piece =
            new Geom_RectangularTrimmedSurface(of(s), near.u.low, near.u.high, near.v.low, near.v.high);
        GeomAPI_IntCS meet(part, piece);
        for (int i = 1; meet.IsDone() && i <= meet.NbPoints(); ++i) {
          double u, v, t;
          meet.Parameters(i, u, v, t);
          hits.push_back({t, {u, v}});
        }
        std::sort(hits.begin(), hits.end(), [](const LineHit& a, const LineHit& b) { return a.t < b.t; });
        return hits;
      },
      std::vector<LineHit>{});
}

}  // namespace free_form
}  // namespace aresta
