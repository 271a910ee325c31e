// SPDX-License-Identifier: Apache-2.0
// Projection, bounds and length of line, circle and ellipse.
#include <algorithm>

#include "geometry/analytic.h"
#include "geometry/bounds_parts.h"
#include "math/quadrature.h"
#include "math/roots.h"

namespace aresta::analytic {

namespace {

template <class Form>
CurveProjection at(const Form& c, Vec3 p, double t) {
  const Vec3 q = point(c, t);
  return {t, q, distance(p, q)};
}

/// The better of the ends and, when it falls inside, each of the given angles.
template <class Form>
CurveProjection best_of(const Form& c, Vec3 p, Range range, std::initializer_list<double> angles) {
  CurveProjection best = at(c, p, range.low);
  bool inner = false;
  for (const double angle : angles) {
    double t = angle_from(angle, range.low);
    // An angle a rounding error before the start is the start, not a whole turn later.
    if (t > range.high && t - two_pi >= range.low - 8 * epsilon * std::max(1.0, std::abs(range.low))) t = range.low;
    if (t > range.high) continue;
    const CurveProjection candidate = at(c, p, t);
    if (candidate.distance < best.distance || (!inner && candidate.distance == best.distance)) best = candidate;
    inner = true;
  }
  const CurveProjection end = at(c, p, range.high);
  return end.distance < best.distance ? end : best;
}

/// Nearest and second nearest stationary angle of an ellipse for the point (x, y), x, y >= 0, in its axes; the second
/// (in the fourth quadrant) exists when the point is inside the evolute. c = a^2 - b^2 >= 0. Roots of
///   g(t) = a x sin t - b y cos t - c sin t cos t,
/// half the derivative of the squared distance. In the first quadrant g / (sin cos) is monotone: one root.
struct Stationary {
  double nearest, second;
  bool has_second;
};
Stationary stationary_angles(double a, double b, double x, double y) {
  const double c = (a - b) * (a + b), ax = a * x, by = b * y;
  const auto g = [&](double t) { return ax * std::sin(t) - by * std::cos(t) - c * std::sin(t) * std::cos(t); };
  Stationary result{0, 0, false};
  if (x == 0) {
    result.nearest = pi / 2;
  } else if (y == 0) {
    result.nearest = ax < c ? std::acos(ax / c) : 0;
  } else {
    result.nearest = root_in_bracket(g, 0.0, pi / 2, -by, ax);
  }
  // Fourth quadrant, t = -s: h(s) = c sin s cos s - a x sin s - b y cos s is largest relative to sin s cos s at s0.
  const double s0 = std::atan2(std::cbrt(by), std::cbrt(ax));
  const auto h = [&](double s) { return c * std::sin(s) * std::cos(s) - ax * std::sin(s) - by * std::cos(s); };
  if (x == 0) {
    result.second = -pi / 2;
    result.has_second = by < c;
  } else if (y == 0) {
    result.second = -result.nearest;
    result.has_second = ax < c;
  } else if (const double h0 = h(s0); h0 > 0) {
    result.second = -root_in_bracket(h, s0, pi / 2, h0, -ax);
    result.has_second = true;
  }
  return result;
}

}  // namespace

CurveProjection project(const Line& c, Vec3 p, Range range) {
  return at(c, p, range.clamp(dot(p - c.origin, c.direction)));
}

CurveProjection project(const Circle& c, Vec3 p, Range range) {
  const Vec3 d = p - c.frame.origin;
  return best_of(c, p, range, {std::atan2(dot(d, c.frame.y), dot(d, c.frame.x))});
}

CurveProjection project(const Ellipse& c, Vec3 p, Range range) {
  const Vec3 d = p - c.frame.origin;
  const double x = dot(d, c.frame.x), y = dot(d, c.frame.y);
  const Stationary s = stationary_angles(c.major, c.minor, std::abs(x), std::abs(y));
  const auto mirrored = [&](double t) {
    if (std::signbit(x)) t = pi - t;
    return std::signbit(y) ? -t : t;
  };
  if (!s.has_second) return best_of(c, p, range, {mirrored(s.nearest)});
  return best_of(c, p, range, {mirrored(s.nearest), mirrored(s.second)});
}

Box3 bounds(const Line& c, Range range) {
  BoxSum sum(c.origin);
  sum.add(c.direction, range);
  return sum.box();
}

Box3 bounds(const Circle& c, Range range) {
  BoxSum sum(c.frame.origin);
  sum.add_turn(c.radius * c.frame.x, c.radius * c.frame.y, range);
  return sum.box();
}

Box3 bounds(const Ellipse& c, Range range) {
  BoxSum sum(c.frame.origin);
  sum.add_turn(c.major * c.frame.x, c.minor * c.frame.y, range);
  return sum.box();
}

double length(const Ellipse& c, Range range, double relative) {
  const auto speed = [&](double t) { return std::hypot(c.major * std::sin(t), c.minor * std::cos(t)); };
  // Whole turns once; the rest piece by piece between the axes, where the integrand is smooth and even.
  const auto quarter = [&](double low, double high) {
    return integrate(speed, low, high, std::max(relative, 4e-16)).value;
  };
  double total = 0, low = range.low;
  const double turns = std::floor(range.length() / two_pi);
  if (turns > 0) {
    total = 4 * turns * quarter(0, pi / 2);
    low = range.low + turns * two_pi;
  }
  while (low < range.high) {
    double next = (std::floor(low / (pi / 2)) + 1) * (pi / 2);
    if (next <= low) next = low + pi / 2;
    const double high = std::min(next, range.high);
    total += quarter(low, high);
    low = high;
  }
  return total;
}

}  // namespace aresta::analytic
