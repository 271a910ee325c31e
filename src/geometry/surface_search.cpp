// SPDX-License-Identifier: Apache-2.0
// Nearest points on free-form surfaces, and where straight lines meet them.
#include <Geom_BSplineSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <algorithm>
#include <optional>
#include <string_view>

#include "geometry/analytic.h"
#include "geometry/bezier_patches.h"
#include "geometry/free_eval.h"
#include "geometry/nearest.h"
#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"

namespace aresta {

struct SurfaceSamples {
  std::vector<double> u, v;
  std::vector<Vec3> points;  ///< points[i * v.size() + j]
};

struct SurfacePatches {
  std::vector<BezierPatch> patches;
  std::optional<FreeSurface> nurbs;  ///< where the surface itself has other parameters than the patches
  Box3 box;
};

namespace free_form {

namespace {

const Handle(Geom_Surface) & of(const FreeSurface& s) {
  return s.handle().surface;
}

/// Parameters of the samples in one direction: a few per span of the knots inside the range.
std::vector<double> sample_line(const std::vector<double>& breaks, Range range) {
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

/// Does the line stay in the surface to one side of the hit? Then it is not isolated.
bool runs_inside(const Surface& s, const Line& line, const PatchHit& hit, double step, double noise) {
  for (const double side : {-1.0, 1.0}) {
    bool inside = true;
    for (const double part : {0.5, 1.0}) {
      const Vec3 p = line.origin + (hit.t + side * part * step) * line.direction;
      inside = inside && s.project(p, &hit.uv).distance <= 4 * noise;
    }
    if (inside) return true;
  }
  return false;
}

/// Are two hits close together one touch: does the line stay within rounding of the surface between them?
bool flat_between(const Surface& s, const Line& line, const LineHit& a, const LineHit& b, double noise) {
  const Vec3 p = line.origin + 0.5 * (a.t + b.t) * line.direction;
  // At a pole a local search may stick.
  return s.project(p, &a.uv).distance <= 4 * noise || s.project(p).distance <= 4 * noise;
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
  const Range2 whole = domain(s);
  const bool bounded = std::isfinite(whole.u.length()) && std::isfinite(whole.v.length());
  if (!bounded && !(std::isfinite(near.u.length()) && std::isfinite(near.v.length()))) return {};
  const auto prepare = [&] {
    SurfacePatches p{bezier_patches(s, bounded ? whole : near), std::nullopt, {}};
    for (const BezierPatch& patch : p.patches) p.box.add(patch.box);
    // Other forms than splines have parameters of their own: hits are found on the NURBS form and carried over.
    if (std::string_view(kind(s)) != "nurbs") {
      const auto made = FreeSurface::from_nurbs(to_nurbs(s, bounded ? whole : near));
      if (made.ok()) p.nurbs = *made;
    }
    return p;
  };
  SurfacePatches own;
  if (!bounded) own = prepare();
  const SurfacePatches& p = bounded ? s.handle().patches.get(prepare) : own;
  const double size = p.box.diagonal();
  const double noise = 1e-13 * size + 8 * analytic::epsilon * (norm(line.origin) + norm(p.box.low) + norm(p.box.high));
  const Surface self(s), evaluate(p.nurbs ? *p.nurbs : s);
  std::vector<PatchHit> found;
  for (const BezierPatch& patch : p.patches) line_meets_patch(patch, evaluate, line, noise, found);

  std::vector<LineHit> hits;
  const Vec2 turn = period(s);
  const double slack_u = 1e-9 * std::max(1e-9, whole.u.length() < 1e100 ? whole.u.length() : near.u.length());
  const double slack_v = 1e-9 * std::max(1e-9, whole.v.length() < 1e100 ? whole.v.length() : near.v.length());
  for (const PatchHit& f : found) {
    if (f.touch && runs_inside(evaluate, line, f, 1e-2 * size, noise)) continue;
    Vec2 uv = f.uv;
    if (p.nurbs) {
      const SurfaceProjection q = project(s, evaluate.point(f.uv), nullptr);
      if (!(q.distance <= 1e-6 * size)) continue;
      uv = q.uv;
    }
    if (turn.x > 0) uv.x -= turn.x * std::floor((uv.x - near.u.low + slack_u) / turn.x);
    if (turn.y > 0) uv.y -= turn.y * std::floor((uv.y - near.v.low + slack_v) / turn.y);
    if (uv.x < near.u.low - slack_u || uv.x > near.u.high + slack_u) continue;
    if (uv.y < near.v.low - slack_v || uv.y > near.v.high + slack_v) continue;
    hits.push_back({f.t, uv});
  }
  std::sort(hits.begin(), hits.end(), [](const LineHit& a, const LineHit& b) {
    return a.t != b.t ? a.t < b.t : a.uv.x != b.uv.x ? a.uv.x < b.uv.x : a.uv.y < b.uv.y;
  });
  // One meeting found from two patches, or a touch from several cells. Hits that are near in space but far in
  // parameters are two only when the surface passes there twice: never told apart below the rounding of a touch.
  std::vector<LineHit> distinct;
  for (const LineHit& h : hits) {
    const bool again = !distinct.empty() && h.t - distinct.back().t <= 1e-6 * size &&
                       (h.t - distinct.back().t <= 1e-10 * size || flat_between(self, line, distinct.back(), h, noise));
    if (!again) distinct.push_back(h);
  }
  return distinct;
}

}  // namespace free_form
}  // namespace aresta
