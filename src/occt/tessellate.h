// SPDX-License-Identifier: Apache-2.0
// Triangles and polylines for looking at a model, made by the kernel library's mesher.
//
// Guarantees: every face has triangles, counterclockwise seen from its front; the points of an edge are the same
// numbers in its polyline and in every face that it bounds, so that there are no cracks; ends of polylines are the
// vertices' points. Serial and deterministic. Not guaranteed: the shape of triangles (for analysis use mesh/), nor the
// deflection to the last digit.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/context.h"
#include "model/model.h"

namespace aresta {

struct TessellationOptions {
  double deflection = 0;  ///< greatest distance from the true shape, in document units; 0: 1e-3 of the box's diagonal
  double angle = 15;      ///< degrees between neighbouring pieces, at most
};

struct FaceTriangles {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  ///< unit, one per point, along the face's normal
  std::vector<Vec2> images;   ///< parameters of the points
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct Tessellation {
  std::vector<FaceTriangles> faces;      ///< by FaceId
  std::vector<std::vector<Vec3>> edges;  ///< by EdgeId, from start to end
};

/// Errors: tessellation_failed names the face that the library could not triangulate; those of to_shape; cancelled.
Result<Tessellation> tessellate(const Model& model, const TessellationOptions& options = {},
                                const Context& context = {});

}  // namespace aresta
