// SPDX-License-Identifier: Apache-2.0
// Free-form curves, on the hidden library.
#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <gp_Trsf.hxx>

#include "geometry/analytic.h"
#include "geometry/free_eval.h"
#include "geometry/nearest.h"
#include "geometry/nurbs_data.h"
#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"
#include "math/quadrature.h"

namespace aresta {

struct CurveSamples {
  std::vector<double> parameters;
  std::vector<Vec3> points;
};

namespace free_form {

using occt::guarded;
using occt::nowhere;
using occt::vec;

namespace {

const Handle(Geom_Curve) & of(const FreeCurve& c) {
  return c.handle().curve;
}

/// OCCT marks an infinite end by 2e100.
double opened(double t) {
  return std::abs(t) >= 1e100 ? std::copysign(analytic::infinity, t) : t;
}

/// A finite part of `range` that holds everything as near to p as its middle is: for parabolas and hyperbolas.
Range finite_part(const FreeCurve& c, Range range, Vec3 p) {
  if (std::isfinite(range.low) && std::isfinite(range.high)) return range;
  const double start = range.clamp(0);
  const Vec3 origin = point(c, start);
  const double reach = 2 * distance(origin, p) + 1e-9;
  const auto end = [&](double sign) {
    double step = 1;
    while (step < 600 && distance(point(c, start + sign * step), origin) < reach) step *= 2;
    return start + sign * step;
  };
  return {std::isfinite(range.low) ? range.low : end(-1), std::isfinite(range.high) ? range.high : end(1)};
}

std::vector<double> sample_parameters(const FreeCurve& c, Range range) {
  const std::vector<double> breaks = smooth_breaks(c, range);
  std::vector<double> result;
  const int per_span = breaks.size() > 200 ? 3 : breaks.size() > 20 ? 6 : breaks.size() > 4 ? 10 : 24;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    for (int k = 0; k < per_span; ++k) {
      result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * k / per_span);
    }
  }
  result.push_back(range.high);
  return result;
}

CurveSamples sampled(const FreeCurve& c, Range range) {
  CurveSamples s;
  s.parameters = sample_parameters(c, range);
  for (const double t : s.parameters) s.points.push_back(point(c, t));
  return s;
}

/// Nearest over the samples with parameters in [low, high], the ends added, then refined.
CurveProjection nearest_from(const FreeCurve& c, Vec3 p, const CurveSamples& samples, double low, double high,
                             double shift) {
  const auto eval = [&](double t) { return jet(c, t); };
  std::vector<double> t{low};
  std::vector<double> d{distance(point(c, low), p)};
  for (std::size_t i = 0; i < samples.parameters.size(); ++i) {
    const double ti = samples.parameters[i] + shift;
    if (ti <= low || ti >= high) continue;
    t.push_back(ti);
    d.push_back(distance(samples.points[i], p));
  }
  t.push_back(high);
  d.push_back(distance(point(c, high), p));
  CurveProjection best{low, point(c, low), d.front()};
  if (d.back() < best.distance) best = {high, point(c, high), d.back()};
  std::vector<std::size_t> minima;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if ((i == 0 || d[i] <= d[i - 1]) && (i + 1 == t.size() || d[i] <= d[i + 1])) minima.push_back(i);
  }
  std::stable_sort(minima.begin(), minima.end(), [&](std::size_t a, std::size_t b) { return d[a] < d[b]; });
  if (minima.size() > 8) minima.resize(8);
  for (const std::size_t i : minima) {
    const double from = t[i == 0 ? 0 : i - 1], to = t[std::min(i + 1, t.size() - 1)];
    const CurveProjection candidate = nearest::on_curve(eval, p, t[i], from, to);
    if (candidate.distance < best.distance) best = candidate;
  }
  return best;
}

}  // namespace

const char* kind(const FreeCurve& c) {
  const Handle(Geom_Curve)& g = of(c);
  if (g->IsKind(STANDARD_TYPE(Geom_BSplineCurve))) return "nurbs";
  if (g->IsKind(STANDARD_TYPE(Geom_BezierCurve))) return "bezier";
  if (g->IsKind(STANDARD_TYPE(Geom_Hyperbola))) return "hyperbola";
  if (g->IsKind(STANDARD_TYPE(Geom_Parabola))) return "parabola";
  if (g->IsKind(STANDARD_TYPE(Geom_OffsetCurve))) return "offset";
  return "other";
}

Vec3 point(const FreeCurve& c, double t) {
  return guarded([&] { return vec(of(c)->Value(t)); }, nowhere);
}

CurveJet jet(const FreeCurve& c, double t) {
  return guarded(
      [&] {
        gp_Pnt p;
        gp_Vec d1, d2;
        of(c)->D2(t, p, d1, d2);
        return CurveJet{vec(p), vec(d1), vec(d2)};
      },
      CurveJet{nowhere, nowhere, nowhere});
}

double period(const FreeCurve& c) {
  return guarded([&] { return of(c)->IsPeriodic() ? of(c)->Period() : 0.0; }, 0.0);
}

Range domain(const FreeCurve& c) {
  return {opened(of(c)->FirstParameter()), opened(of(c)->LastParameter())};
}

std::vector<double> smooth_breaks(const FreeCurve& c, Range range) {
  return guarded(
      [&] {
        GeomAdaptor_Curve adaptor(of(c), range.low, range.high);
        const int n = adaptor.NbIntervals(GeomAbs_CN);
        TColStd_Array1OfReal at(1, n + 1);
        adaptor.Intervals(at, GeomAbs_CN);
        std::vector<double> result{range.low};
        for (int i = 2; i <= n; ++i) {
          if (at(i) > result.back() && at(i) < range.high) result.push_back(at(i));
        }
        result.push_back(range.high);
        return result;
      },
      std::vector<double>{range.low, range.high});
}

CurveProjection project(const FreeCurve& c, Vec3 p, Range range) {
  if (!is_finite(p)) return {range.low, point(c, range.low), occt::nan};
  range = finite_part(c, range, p);
  if (!(range.low < range.high)) return {range.low, point(c, range.low), distance(point(c, range.low), p)};
  const Range whole = domain(c);
  if (!std::isfinite(whole.low) || !std::isfinite(whole.high)) {
    return nearest_from(c, p, sampled(c, range), range.low, range.high, 0);
  }
  const CurveSamples& samples = c.handle().samples.get([&] { return sampled(c, whole); });
  const double period_length = period(c);
  if (period_length <= 0) return nearest_from(c, p, samples, range.low, range.high, 0);
  // One turn after the other, as far as the range goes; a range longer than a turn needs the first turn only.
  const double end = std::min(range.high, range.low + period_length);
  const double first = std::floor((range.low - whole.low) / period_length);
  CurveProjection best;
  best.distance = analytic::infinity;
  double low = range.low;
  for (int turn = 0; turn < 3 && low < end; ++turn) {
    const double shift = (first + turn) * period_length;
    const double high = std::min(end, whole.high + shift);
    if (high <= low) continue;
    const CurveProjection candidate = nearest_from(c, p, samples, low, high, shift);
    if (candidate.distance < best.distance) best = candidate;
    low = high;
  }
  return best;
}

Box3 bounds(const FreeCurve& c, Range range) {
  Box3 box;
  const NurbsCurveData data = kind(c) == std::string_view("offset") ? NurbsCurveData{} : to_nurbs(c, range);
  for (const Vec3 p : data.poles) box.add(p);
  if (box.empty()) {
    if (const auto offset = Handle(Geom_OffsetCurve)::DownCast(of(c))) {
      return from_occt(offset->BasisCurve()).bounds(range).grown(std::abs(offset->Offset()));
    }
    constexpr double inf = analytic::infinity;
    return {{-inf, -inf, -inf}, {inf, inf, inf}};
  }
  return box.grown(8 * analytic::epsilon * (norm(box.low) + norm(box.high)));
}

double length(const FreeCurve& c, Range range, double relative) {
  if (!std::isfinite(range.low) || !std::isfinite(range.high)) return analytic::infinity;
  const std::vector<double> breaks = smooth_breaks(c, range);
  double total = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    total += integrate([&](double t) { return norm(jet(c, t).d1); }, breaks[i], breaks[i + 1], relative).value;
  }
  return total;
}

double parameter_factor(const FreeCurve& c, const Transform& t) {
  double factor = 1;
  if (!t.is_similarity(&factor)) return 1;
  return of(c)->IsKind(STANDARD_TYPE(Geom_Parabola)) ? factor : 1;
}

namespace {

bool similarity_to_occt(const Transform& t, gp_Trsf& out) {
  if (!t.is_similarity()) return false;
  const auto& r = t.rows;
  out.SetValues(r[0].x, r[0].y, r[0].z, t.offset.x, r[1].x, r[1].y, r[1].z, t.offset.y, r[2].x, r[2].y, r[2].z,
                t.offset.z);
  return true;
}

}  // namespace

Result<Curve> transformed(const FreeCurve& c, const Transform& t) {
  if (!std::isfinite(t.determinant()) || t.determinant() == 0 || !is_finite(t.offset)) {
    return Error{errors::bad_transform, "this transformation is singular or not finite"};
  }
  return occt::attempted("transform a curve", [&]() -> Result<Curve> {
    const auto moved = [&](const auto& from, auto to) {
      for (int i = 1; i <= from->NbPoles(); ++i) to->SetPole(i, occt::pnt(t.point(vec(from->Pole(i)))));
      return Curve(FreeCurve(std::make_shared<const OcctCurve>(OcctCurve{to})));
    };
    if (auto spline = Handle(Geom_BSplineCurve)::DownCast(of(c))) {
      return moved(spline, Handle(Geom_BSplineCurve)::DownCast(spline->Copy()));
    }
    if (auto bezier = Handle(Geom_BezierCurve)::DownCast(of(c))) {
      return moved(bezier, Handle(Geom_BezierCurve)::DownCast(bezier->Copy()));
    }
    gp_Trsf trsf;
    if (!similarity_to_occt(t, trsf)) {
      return Error{errors::bad_transform,
                   std::string("a curve of kind ") + kind(c) + " takes moves, turns, mirrors and uniform scalings only",
                   {},
                   {},
                   "convert the curve to NURBS first"};
    }
    const Handle(Geom_Curve) copy = Handle(Geom_Curve)::DownCast(of(c)->Transformed(trsf));
    return Curve(FreeCurve(std::make_shared<const OcctCurve>(OcctCurve{copy})));
  });
}

NurbsCurveData to_nurbs(const FreeCurve& c, Range range) {
  if (!std::isfinite(range.low) || !std::isfinite(range.high) || !(range.low < range.high)) return {};
  return guarded(
      [&] {
        const Handle(Geom_TrimmedCurve) piece = new Geom_TrimmedCurve(of(c), range.low, range.high);
        Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(piece);
        if (spline->IsPeriodic()) {
          spline = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
          spline->SetNotPeriodic();
        }
        return data_of(spline);
      },
      NurbsCurveData{});
}

}  // namespace free_form
}  // namespace aresta
