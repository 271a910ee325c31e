// SPDX-License-Identifier: Apache-2.0
// Directions for rays that are to meet nothing in a special way.
#pragma once

#include <cmath>

#include "math/vec.h"

namespace aresta {

/// Unit vector number i of `count`, spread over the sphere on a golden spiral that is turned by an irrational amount:
/// none of them is special for boxes and axes.
inline Vec3 general_direction(int i, int count) {
  const double z = 1 - (2 * i + 1) / static_cast<double>(count), angle = 2.399963229728653 * i + 0.7390851332151607;
  const double r = std::sqrt(1 - z * z);
  return normalized(Vec3{r * std::cos(angle) + 0.01337, r * std::sin(angle) - 0.00931, z + 0.00717});
}

}  // namespace aresta
