// SPDX-License-Identifier: Apache-2.0
// Exact ranges of the terms that analytic forms are sums of; a few ulps are added so that every evaluated point is
// inside.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/analytic.h"
#include "geometry/curve.h"
#include "math/box.h"

namespace aresta::analytic {

/// Range of s -> coefficient * s, an infinite end times zero being zero.
inline Range scaled(Range r, double coefficient) {
  if (coefficient == 0) return {0, 0};
  const double a = coefficient * r.low, b = coefficient * r.high;
  return {std::min(a, b), std::max(a, b)};
}

inline Range hull(Range a, Range b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// Range of t -> a cos t + b sin t over `range`.
inline Range turn_range(double a, double b, Range range) {
  const double amplitude = std::hypot(a, b);
  if (amplitude == 0) return {0, 0};
  if (!(range.length() < two_pi)) return {-amplitude, amplitude};
  const double v0 = a * std::cos(range.low) + b * std::sin(range.low);
  const double v1 = a * std::cos(range.high) + b * std::sin(range.high);
  Range result{std::min(v0, v1), std::max(v0, v1)};
  const double top = std::atan2(b, a);
  if (angle_from(top, range.low) <= range.high) result.high = amplitude;
  if (angle_from(top + pi, range.low) <= range.high) result.low = -amplitude;
  return result;
}

/// Adds up independent terms per coordinate.
class BoxSum {
 public:
  explicit BoxSum(Vec3 origin) {
    for (int i = 0; i < 3; ++i) add(i, {origin[i], origin[i]});
  }
  void add(int coordinate, Range r) {
    low_[coordinate] += r.low;
    high_[coordinate] += r.high;
    double m = 0;
    if (std::isfinite(r.low)) m = std::max(m, std::abs(r.low));
    if (std::isfinite(r.high)) m = std::max(m, std::abs(r.high));
    magnitude_[coordinate] += m;
  }
  void add(Vec3 direction, Range r) {
    for (int i = 0; i < 3; ++i) add(i, scaled(r, direction[i]));
  }
  void add_turn(Vec3 x, Vec3 y, Range angles) {
    for (int i = 0; i < 3; ++i) add(i, turn_range(x[i], y[i], angles));
  }
  Box3 box() const {
    const Vec3 slack = 8 * epsilon * magnitude_;
    return {low_ - slack, high_ + slack};
  }

 private:
  Vec3 low_, high_, magnitude_;
};

}  // namespace aresta::analytic
