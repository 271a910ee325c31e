// SPDX-License-Identifier: Apache-2.0
// Remeshing of a triangulated piece of a surface in space: from any triangulation of the right topology to one of the
// wished size and good shape, all of whose vertices lie on the surface.
//
// Guarantees: fixed vertices and constrained edges stay as they are; the topology stays (every operation keeps a
// manifold triangulation a manifold triangulation: splits always do, collapses and flips are checked by the link
// condition); no operation turns a triangle away from the surface's normal unless one already was.
// Not guaranteed: a given least angle; sharp corners of the fixed boundary bound it.
// Deterministic: edges are visited in an order of indices and lengths.
// Method: M. Botsch, L. Kobbelt, A remeshing approach to multiresolution modeling, SGP 2004 (split, collapse, flip,
// smooth), with a size field; at the end, local search for the worst triangles.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/context.h"
#include "math/vec.h"

namespace aresta::mesh {

struct RemeshVertex {
  Vec3 point;
  Vec2 uv;      ///< on the surface: where projection starts
  Vec3 normal;  ///< of the surface; zero where it has none
  bool fixed = false;
};

struct RemeshInput {
  std::vector<RemeshVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise about the normals
  std::vector<std::array<std::uint32_t, 2>>
      constrained;  ///< edges between fixed vertices; boundary edges may be left out
  /// Nearest point of the surface; `uv` holds where to start and gets where it is.
  std::function<Vec3(Vec3 point, Vec2& uv)> project;
  std::function<Vec3(Vec2 uv)> normal;
  std::function<double(Vec3 point)> size;
};

struct RemeshOutput {
  std::vector<RemeshVertex> vertices;  ///< the fixed ones first, in their order; the free ones after them
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Fixed vertices must come first in the input. Error: cancelled.
Result<RemeshOutput> remesh(const RemeshInput& input, const Context& context);

/// Twice the area vector of a triangle.
inline Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
  return cross(b - a, c - a);
}

/// 1 for the equilateral triangle, 0 for a degenerate one.
inline double triangle_shape(Vec3 a, Vec3 b, Vec3 c) {
  const double sides = norm2(b - a) + norm2(c - b) + norm2(a - c);
  return sides > 0 ? 2 * std::sqrt(3.0) * norm(area_vector(a, b, c)) / sides : 0;
}

}  // namespace aresta::mesh
