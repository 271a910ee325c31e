// SPDX-License-Identifier: Apache-2.0
// Problems of set operations: one solid, and what is united with it or taken from it, step by step. Coordinates are
// floats, so that libraries that take nothing longer have the same problem; faces are convex and exactly plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace aresta::bench {

/// The boundary of a solid: faces run counterclockwise seen from outside.
struct PolygonMesh {
  std::vector<Vec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

using Triangle = std::array<std::uint32_t, 3>;
std::vector<Triangle> triangles_of(const PolygonMesh& mesh);
double volume_of(const PolygonMesh& mesh);

struct Chain {
  bool is_difference = false;  ///< else union
  PolygonMesh first;
  std::vector<std::vector<PolygonMesh>> steps;  ///< the solids of one step do not meet each other
  double volume = 0;                            ///< of the result, from a formula; 0 where there is none
};

/// Spheres of 20 n^2 triangles each, overlapping, one turned; united.
Chain two_spheres(std::uint32_t n);
/// A plate minus count x count prisms of 32 sides, in one step.
Chain plate_with_holes(int count);
/// A cube minus the bars of a Menger sponge, three steps for each level.
Chain sponge(int level);
/// A height field of size x size cells minus 200 blocks whose sides are in common planes and contain edges of it.
Chain terrain(int size);

}  // namespace aresta::bench
