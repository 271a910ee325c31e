// SPDX-License-Identifier: Apache-2.0
// Curves in the parameter plane of a surface (the image of an edge in a face).
#pragma once

#include <variant>

#include "geometry/curve.h"

namespace aresta {

/// p(t) = origin + t direction (a unit vector).
struct Line2 {
  Vec2 origin, direction;
};

/// p(t) = origin + a cos t x + b sin t y with orthonormal x, y (left-handed pairs allowed); a circle when a = b.
struct Ellipse2 {
  Vec2 origin, x, y;
  double major = 0, minor = 0;
};

struct Curve2Jet {
  Vec2 point, d1, d2;
};

class Curve2 {
 public:
  using Form = std::variant<Line2, Ellipse2, FreeCurve2>;

  Curve2(Form form) : form_(std::move(form)) {}
  template <class T>
  requires std::constructible_from<Form, T> Curve2(T form) : form_(std::move(form)) {}

  const Form& form() const { return form_; }
  template <class T>
  const T* get_if() const {
    return std::get_if<T>(&form_);
  }

  Vec2 point(double t) const;
  Curve2Jet jet(double t) const;
  Range domain() const;
  /// 0 when not periodic.
  double period() const;
  const char* kind() const;  ///< "line", "circle", "ellipse", "nurbs", ...
  /// The curve moved by a vector, as an image continued in another period of its surface.
  Curve2 translated(Vec2 by) const;

 private:
  Form form_;
};

}  // namespace aresta
