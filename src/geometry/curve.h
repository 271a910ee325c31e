// SPDX-License-Identifier: Apache-2.0
// Curves in space: a value type over exact analytic forms and free-form curves.
//
// Parametrisation is fixed by the form and equals that of the STEP standard (and of OCCT), so that parameters and
// parameter-space images survive exchange unchanged:
//   Line     p(t) = origin + t direction                      direction is a unit vector, t a length
//   Circle   p(t) = origin + r (cos t x + sin t y)            t in radians, period 2 pi
//   Ellipse  p(t) = origin + a cos t x + b sin t y            t in radians, period 2 pi, a >= b > 0
//   FreeCurve anything else (NURBS, hyperbola, parabola, offset), evaluated by the library hidden in free_form.h
#pragma once

#include <variant>

#include "base/result.h"
#include "geometry/free_form.h"
#include "math/box.h"
#include "math/transform.h"

namespace aresta {

struct Range {
  double low = 0, high = 0;
  constexpr double length() const { return high - low; }
  constexpr double at(double fraction) const { return low + fraction * (high - low); }
  constexpr double middle() const { return 0.5 * (low + high); }
  constexpr double clamp(double t) const { return t < low ? low : t > high ? high : t; }
  constexpr bool operator==(const Range&) const = default;
};

struct Line {
  Vec3 origin;
  Vec3 direction;
};

struct Circle {
  Frame frame;
  double radius = 0;
};

struct Ellipse {
  Frame frame;
  double major = 0, minor = 0;
};

/// Point and derivatives at a parameter.
struct CurveJet {
  Vec3 point, d1, d2;
};

struct CurveProjection {
  double parameter = 0;
  Vec3 point;
  double distance = 0;
};

class Curve {
 public:
  using Form = std::variant<Line, Circle, Ellipse, FreeCurve>;

  Curve(Form form) : form_(std::move(form)) {}
  template <class T>
  requires std::constructible_from<Form, T> Curve(T form) : form_(std::move(form)) {}

  const Form& form() const { return form_; }
  template <class T>
  const T* get_if() const {
    return std::get_if<T>(&form_);
  }
  bool is_line() const { return get_if<Line>() != nullptr; }
  const char* kind() const;  ///< "line", "circle", "ellipse", "nurbs", ...

  Vec3 point(double t) const;
  CurveJet jet(double t) const;
  /// 0 when not periodic.
  double period() const;
  /// Where the curve is defined; infinite for a line.
  Range domain() const;

  /// Nearest point of the piece `range`; ends included. Exact for analytic forms, to 1e-12 of the curve's size
  /// otherwise.
  CurveProjection project(Vec3 p, Range range) const;
  /// Contains the piece `range`; tight for analytic forms.
  Box3 bounds(Range range) const;
  /// Length of the piece: closed form or adaptive quadrature to `relative` error.
  double length(Range range, double relative = 1e-12) const;

  /// The curve moved by `t`; the parameter of an old point is multiplied by parameter_factor(t). Every form takes any
  /// similarity; a line and a NURBS take any affine map, a circle and an ellipse those that leave x and y at right
  /// angles and x the longer. Others, and maps that flatten the curve, are errors (geometry.transform).
  Result<Curve> transformed(const Transform& t) const;
  /// The stretch of a line's direction (and of a parabola's), else 1.
  double parameter_factor(const Transform& t) const;
  /// Exact NURBS form of the piece `range`, which must be finite; its parameters are its own (for arcs they agree at
  /// the knots), and it is never periodic. An offset has no exact form and is approximated to 1e-9 of its size. Degree
  /// 0 and no poles when there is none.
  NurbsCurveData to_nurbs(Range range) const;

 private:
  Form form_;
};

/// Are these the same point set near each other, within `tolerance` over `range` of `a`? `same_direction` gets the
/// sense.
bool coincident(const Curve& a, Range range, const Curve& b, double tolerance, bool* same_direction = nullptr);

}  // namespace aresta
