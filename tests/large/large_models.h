// SPDX-License-Identifier: Apache-2.0
// Large models for measuring: made in no time, known to the last count.
#pragma once

#include <array>
#include <vector>

#include "topology/assemble.h"

namespace aresta::test {

struct TriangleMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise seen from outside
};

/// A sphere of 20 n^2 triangles: an icosahedron, each edge in n parts. 10 n^2 + 2 vertices, 30 n^2 edges.
TriangleMesh sphere_of_triangles(std::uint32_t n);

/// n^3 filled cubes that share their faces: (n + 1)^3 vertices, 3 n (n + 1)^2 edges, 3 n^2 (n + 1) faces.
Incidence grid_of_cubes(std::uint32_t n);

}  // namespace aresta::test
