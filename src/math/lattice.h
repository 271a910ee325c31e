// SPDX-License-Identifier: Apache-2.0
// A lattice of points whose coordinates are whole multiples of a power of two: the points that exact arithmetic takes.
//
// Guarantees: within a lattice's range, 2^51 steps in each direction, a point of the lattice has one Vec3 and the way
// there and back gives the same point; to_lattice rounds each coordinate to the nearest multiple, ties to even, so that
// it moves by half a step at most (for the lattice of a box less than 2^-51 of the box's largest coordinate).
// Units: a Vec3 is in the document's units, a LatticePoint in steps.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "math/box.h"
#include "math/vec.h"

namespace aresta {

/// Coordinates in steps of a lattice.
using LatticePoint = std::array<std::int64_t, 3>;

class Lattice {
 public:
  /// The largest coordinate, in steps: one bit less than doubles hold, so that differences of points are exact too.
  static constexpr std::int64_t range = std::int64_t{1} << 51;
  /// Steps from 2^-500 to 2^500: points computed from lattice points neither overflow nor lose bits to underflow.
  static constexpr int max_exponent = 500;

  /// Of step 2^exponent.
  explicit Lattice(int exponent) : step_(std::ldexp(1.0, exponent)), inverse_(std::ldexp(1.0, -exponent)) {
    assert(exponent >= -max_exponent && exponent <= max_exponent);
  }
  /// The finest lattice that holds the box, which is finite and within 2^551 of the origin. An empty box is as one at
  /// the origin, where any step will do: the lattice of step 1.
  static Lattice holding(const Box3& box) {
    double reach = 0;
    if (!box.empty()) {
      for (int i = 0; i < 3; ++i) reach = std::max({reach, std::abs(box.low[i]), std::abs(box.high[i])});
    }
    assert(std::isfinite(reach));
    if (reach == 0) return Lattice(0);
    int exponent = 0;  // reach = fraction * 2^exponent, 1/2 <= fraction < 1
    const double fraction = std::frexp(reach, &exponent);
    return Lattice(std::max((fraction == 0.5 ? exponent - 1 : exponent) - 51, -max_exponent));
  }

  /// The length of a step.
  double step() const { return step_; }
  /// A length in steps; exact, but for lengths that are next to nothing (underflow).
  double in_steps(double length) const { return length * inverse_; }

  bool holds(Vec3 p) const {
    const double reach = static_cast<double>(range) * step_;
    return std::abs(p.x) <= reach && std::abs(p.y) <= reach && std::abs(p.z) <= reach;
  }
  /// The nearest point of the lattice, which must hold p.
  LatticePoint to_lattice(Vec3 p) const {
    assert(holds(p));
    const auto nearest = [this](double x) { return static_cast<std::int64_t>(std::nearbyint(in_steps(x))); };
    return {nearest(p.x), nearest(p.y), nearest(p.z)};
  }
  /// Exact.
  Vec3 from_lattice(const LatticePoint& p) const {
    return step_ * Vec3{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }

 private:
  double step_, inverse_;
};

/// Is each coordinate within the range of a lattice?
constexpr bool in_lattice_range(const LatticePoint& p) {
  for (const std::int64_t x : p) {
    if (x < -Lattice::range || x > Lattice::range) return false;
  }
  return true;
}

}  // namespace aresta
