// SPDX-License-Identifier: Apache-2.0
// Free-form curves in the parameter plane, on the hidden library.
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>

#include "geometry/analytic.h"
#include "geometry/free_eval.h"
#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"

namespace aresta::free_form {

using occt::guarded;

namespace {

const Handle(Geom2d_Curve) & of(const FreeCurve2& c) {
  return c.handle().curve;
}
double opened(double t) {
  return std::abs(t) >= 1e100 ? std::copysign(analytic::infinity, t) : t;
}
constexpr Vec2 nowhere2{occt::nan, occt::nan};

}  // namespace

const char* kind(const FreeCurve2& c) {
  const Handle(Geom2d_Curve)& g = of(c);
  if (g->IsKind(STANDARD_TYPE(Geom2d_BSplineCurve))) return "nurbs";
  if (g->IsKind(STANDARD_TYPE(Geom2d_BezierCurve))) return "bezier";
  if (g->IsKind(STANDARD_TYPE(Geom2d_Hyperbola))) return "hyperbola";
  if (g->IsKind(STANDARD_TYPE(Geom2d_Parabola))) return "parabola";
  if (g->IsKind(STANDARD_TYPE(Geom2d_OffsetCurve))) return "offset";
  return "other";
}

Vec2 point(const FreeCurve2& c, double t) {
  return guarded(
      [&] {
        const gp_Pnt2d p = of(c)->Value(t);
        return Vec2{p.X(), p.Y()};
      },
      nowhere2);
}

Curve2Jet jet(const FreeCurve2& c, double t) {
  return guarded(
      [&] {
        gp_Pnt2d p;
        gp_Vec2d d1, d2;
        of(c)->D2(t, p, d1, d2);
        return Curve2Jet{{p.X(), p.Y()}, {d1.X(), d1.Y()}, {d2.X(), d2.Y()}};
      },
      Curve2Jet{nowhere2, nowhere2, nowhere2});
}

FreeCurve2 translated(const FreeCurve2& c, Vec2 by) {
  auto moved = std::make_shared<OcctCurve2>();
  moved->curve = Handle(Geom2d_Curve)::DownCast(of(c)->Translated(gp_Vec2d(by.x, by.y)));
  return FreeCurve2(std::move(moved));
}

double period(const FreeCurve2& c) {
  return guarded([&] { return of(c)->IsPeriodic() ? of(c)->Period() : 0.0; }, 0.0);
}

Range domain(const FreeCurve2& c) {
  return {opened(of(c)->FirstParameter()), opened(of(c)->LastParameter())};
}

}  // namespace aresta::free_form
