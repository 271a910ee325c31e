// SPDX-License-Identifier: Apache-2.0
// The corners and sides of a box, for tests that make boxes of something.
#pragma once

#include <array>

#include "math/vec.h"

namespace aresta::test {

/// Corner i has the high x when bit 0 of i is set, the high y for bit 1, the high z for bit 2.
inline std::array<Vec3, 8> box_corners(Vec3 low, Vec3 high) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
  return corners;
}

/// Corners of each side, counterclockwise seen from outside.
inline constexpr std::array<std::array<unsigned, 4>, 6> box_sides{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

}  // namespace aresta::test
