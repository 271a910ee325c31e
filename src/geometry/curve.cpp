// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve.h"

#include "geometry/analytic.h"
#include "geometry/analytic_nurbs.h"
#include "geometry/free_eval.h"

namespace aresta {

namespace {

/// Axes made orthonormal again after a map, right-handed: for a curve only x and y matter.
Frame curve_frame(Vec3 origin, Vec3 x, Vec3 y) {
  Frame f;
  f.origin = origin;
  f.x = normalized(x);
  f.y = normalized(y - dot(y, f.x) * f.x);
  f.z = cross(f.x, f.y);
  return f;
}

Error no_such_form(const char* what) {
  return {errors::bad_transform,
          std::string("this transformation turns a ") + what +
              " into a curve that cannot keep its parameters; only similarities (moves, turns, "
              "mirrors, uniform scalings) and scalings along its axes can",
          {},
          {},
          "convert the curve to NURBS first"};
}

/// o + cos t A + sin t B with A and B at right angles and A no shorter is an ellipse with the same parameters.
Result<Curve> mapped_ellipse(const Frame& f, double a, double b, const Transform& t, const char* what) {
  const Vec3 x = t.vector(f.x), y = t.vector(f.y);
  const double la = a * norm(x), lb = b * norm(y);
  if (!(la > 0) || !(lb > 0) || !std::isfinite(la) || !std::isfinite(lb)) {
    return Error{errors::bad_transform, std::string("this transformation makes a ") + what + " degenerate"};
  }
  constexpr double tolerance = 4e-12;
  if (std::abs(dot(x, y)) > tolerance * norm(x) * norm(y)) return no_such_form(what);
  const Frame frame = curve_frame(t.point(f.origin), x, y);
  // The same radius when they differ by rounding alone: a circle stays a circle.
  if (std::abs(la - lb) <= tolerance * la && std::abs(a - b) <= tolerance * a) {
    return Curve(a == b ? Curve::Form(Circle{frame, la}) : Curve::Form(Ellipse{frame, la, std::min(la, lb)}));
  }
  if (la < lb) return no_such_form(what);
  return Curve(Ellipse{frame, la, lb});
}

}  // namespace

const char* Curve::kind() const {
  static constexpr const char* names[] = {"line", "circle", "ellipse"};
  if (const auto* f = get_if<FreeCurve>()) return free_form::kind(*f);
  return names[form_.index()];
}

Vec3 Curve::point(double t) const {
  switch (form_.index()) {
    case 0:
      return analytic::point(std::get<0>(form_), t);
    case 1:
      return analytic::point(std::get<1>(form_), t);
    case 2:
      return analytic::point(std::get<2>(form_), t);
    default:
      return free_form::point(std::get<3>(form_), t);
  }
}

CurveJet Curve::jet(double t) const {
  switch (form_.index()) {
    case 0:
      return analytic::jet(std::get<0>(form_), t);
    case 1:
      return analytic::jet(std::get<1>(form_), t);
    case 2:
      return analytic::jet(std::get<2>(form_), t);
    default:
      return free_form::jet(std::get<3>(form_), t);
  }
}

double Curve::period() const {
  if (const auto* f = get_if<FreeCurve>()) return free_form::period(*f);
  return is_line() ? 0 : analytic::two_pi;
}

Range Curve::domain() const {
  if (const auto* f = get_if<FreeCurve>()) return free_form::domain(*f);
  return is_line() ? Range{-analytic::infinity, analytic::infinity} : Range{0, analytic::two_pi};
}

CurveProjection Curve::project(Vec3 p, Range range) const {
  if (const auto* c = get_if<Line>()) return analytic::project(*c, p, range);
  if (const auto* c = get_if<Circle>()) return analytic::project(*c, p, range);
  if (const auto* c = get_if<Ellipse>()) return analytic::project(*c, p, range);
  return free_form::project(*get_if<FreeCurve>(), p, range);
}

Box3 Curve::bounds(Range range) const {
  if (const auto* c = get_if<Line>()) return analytic::bounds(*c, range);
  if (const auto* c = get_if<Circle>()) return analytic::bounds(*c, range);
  if (const auto* c = get_if<Ellipse>()) return analytic::bounds(*c, range);
  return free_form::bounds(*get_if<FreeCurve>(), range);
}

double Curve::length(Range range, double relative) const {
  if (is_line()) return range.length();
  if (const auto* c = get_if<Circle>()) return c->radius * range.length();
  if (const auto* c = get_if<Ellipse>()) return analytic::length(*c, range, relative);
  return free_form::length(*get_if<FreeCurve>(), range, relative);
}

double Curve::parameter_factor(const Transform& t) const {
  if (const auto* c = get_if<Line>()) return norm(t.vector(c->direction));
  if (const auto* c = get_if<FreeCurve>()) return free_form::parameter_factor(*c, t);
  return 1;
}

Result<Curve> Curve::transformed(const Transform& t) const {
  if (const auto* c = get_if<Line>()) {
    const Vec3 direction = t.vector(c->direction);
    const double n = norm(direction);
    if (!(n > 0) || !std::isfinite(n))
      return Error{errors::bad_transform, "this transformation flattens a line to a point"};
    return Curve(Line{t.point(c->origin), direction / n});
  }
  if (const auto* c = get_if<Circle>()) return mapped_ellipse(c->frame, c->radius, c->radius, t, "circle");
  if (const auto* c = get_if<Ellipse>()) return mapped_ellipse(c->frame, c->major, c->minor, t, "ellipse");
  return free_form::transformed(*get_if<FreeCurve>(), t);
}

NurbsCurveData Curve::to_nurbs(Range range) const {
  if (const auto* c = get_if<FreeCurve>()) return free_form::to_nurbs(*c, range);
  return analytic::to_nurbs(*this, range);
}

}  // namespace aresta
