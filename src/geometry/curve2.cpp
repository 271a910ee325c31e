// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve2.h"

#include "geometry/analytic.h"
#include "geometry/free_eval.h"

namespace aresta {

Vec2 Curve2::point(double t) const {
  if (const auto* c = get_if<Line2>()) return c->origin + t * c->direction;
  if (const auto* c = get_if<Ellipse2>()) {
    return c->origin + c->major * std::cos(t) * c->x + c->minor * std::sin(t) * c->y;
  }
  return free_form::point(*get_if<FreeCurve2>(), t);
}

Curve2Jet Curve2::jet(double t) const {
  if (const auto* c = get_if<Line2>()) return {c->origin + t * c->direction, c->direction, {}};
  if (const auto* c = get_if<Ellipse2>()) {
    const double cs = std::cos(t), sn = std::sin(t);
    const Vec2 out = c->major * cs * c->x + c->minor * sn * c->y;
    return {c->origin + out, c->minor * cs * c->y - c->major * sn * c->x, -out};
  }
  return free_form::jet(*get_if<FreeCurve2>(), t);
}

Range Curve2::domain() const {
  if (get_if<Line2>() != nullptr) return {-analytic::infinity, analytic::infinity};
  if (get_if<Ellipse2>() != nullptr) return {0, analytic::two_pi};
  return free_form::domain(*get_if<FreeCurve2>());
}

double Curve2::period() const {
  if (get_if<Line2>() != nullptr) return 0;
  if (get_if<Ellipse2>() != nullptr) return analytic::two_pi;
  return free_form::period(*get_if<FreeCurve2>());
}

Curve2 Curve2::translated(Vec2 by) const {
  if (by == Vec2{}) return *this;
  if (const auto* line = get_if<Line2>()) return Line2{line->origin + by, line->direction};
  if (const auto* c = get_if<Ellipse2>()) return Ellipse2{c->origin + by, c->x, c->y, c->major, c->minor};
  return free_form::translated(*get_if<FreeCurve2>(), by);
}

const char* Curve2::kind() const {
  if (get_if<Line2>() != nullptr) return "line";
  if (const auto* c = get_if<Ellipse2>()) return c->major == c->minor ? "circle" : "ellipse";
  return free_form::kind(*get_if<FreeCurve2>());
}

}  // namespace aresta
