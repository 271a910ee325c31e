// SPDX-License-Identifier: Apache-2.0
// Set operations between closed triangle meshes, without a complex: in time near that of looking at each triangle.
//
// Contract. Each operand is closed, oriented outward and free of meetings with itself (a mesh for which nobody vouches
// goes through imprint.h); one that is not closed is refused (mesh_open). The result is closed, triangles that do not
// touch the other operand are the operands' own, to the last bit and in their order, pieces of the others follow.
// Coincident parts of both surfaces are there once, or not at all, as a regularised operation wants it. Checked before
// it is returned: closedness, labels that agree wherever the surfaces hang together, and V(a) + V(b) = V(a or b) +
// V(a and b); what fails is an error (mesh_inconsistent).
//
// Method: cells of a bit grid tell which triangles may touch the other operand; only these are imprinted (imprint.h).
// Around each edge of the other surface the radial order tells inside from outside; union-find spreads it over all that
// hangs together without crossing the other surface; what hangs on no crossing asks one ray. Linear but for the
// imprint.
#pragma once

#include <array>
#include <vector>

#include "base/context.h"
#include "math/exact_points.h"
#include "planar/errors.h"
#include "planar/pair_map.h"

namespace aresta::planar {

struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise seen from outside
};

enum class MeshOperation : std::uint8_t { unite, intersect, subtract };

struct MeshOptions {
  double tolerance = 0;  ///< absolute; 0: 1e-9 of the diagonal of both boxes
};

struct CombinedMesh {
  TriangleMesh mesh;
  /// Per triangle, the triangle of an operand that it is or is a piece of: of a, or the number of these plus one of b.
  std::vector<Index> source;
  double volume = 0;
  std::size_t imprinted = 0;  ///< how many triangles may touch the other operand
  Stages stages;
};

/// Errors: mesh_open, mesh_inconsistent, those of imprint(), cancelled.
Result<CombinedMesh> combine(const TriangleMesh& a, const TriangleMesh& b, MeshOperation operation,
                             const MeshOptions& options, const Context& context);

}  // namespace aresta::planar
