// SPDX-License-Identifier: Apache-2.0
// The volume that two convex polyhedra have in common, by clipping one with the planes of the other in 64-bit
// mantissas: an oracle that shares nothing with the engines.
#pragma once

#include <array>
#include <vector>

#include "math/vec.h"

namespace aresta::sweeps {

using Real = long double;

struct Point {
  Real x = 0, y = 0, z = 0;
};

/// Faces as loops of points, counterclockwise seen from outside.
struct Convex {
  std::vector<std::vector<Point>> faces;
};

/// Corners as in planar/box.h.
Convex hexahedron(const std::array<Vec3, 8>& corners);
Real volume(const Convex& solid);
Real area(const Convex& solid);
Real common_volume(const Convex& a, const Convex& b);

}  // namespace aresta::sweeps
