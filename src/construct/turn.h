// SPDX-License-Identifier: Apache-2.0
// Parts of a full turn, exact at quarter turns.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "math/transform.h"

namespace aresta {

/// Cosine and sine of i / n of a full turn.
inline std::array<double, 2> part_of_turn(long long i, long long n) {
  i = ((i % n) + n) % n;
  const long long quarter = 4 * i / n;
  if (4 * i == quarter * n) {
    constexpr std::array<double, 2> exact[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return exact[quarter];
  }
  const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
  return {std::cos(angle), std::sin(angle)};
}

/// The frame turned about its own z.
inline Frame turned(const Frame& frame, double degrees) {
  if (degrees == 0) return frame;
  const Transform turn = Transform::rotation(degrees, frame.z);
  return {frame.origin, turn.vector(frame.x), turn.vector(frame.y), frame.z};
}

}  // namespace aresta
