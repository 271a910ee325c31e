// SPDX-License-Identifier: Apache-2.0
// Which triangles of two meshes may touch the other mesh: the only ones that have to be looked at closely.
//
// Guarantee: triangles whose boxes come nearer than the tolerance are found, on both sides; others may be. So a
// triangle that is not found has neither a vertex nor an edge that the other mesh touches. Method: a grid of bits over
// what both boxes have in common, with cells about as wide as the triangles; one mesh marks its cells, the other is
// asked, then the other way round. Linear; at most 16 MB.
#pragma once

#include <array>
#include <vector>

#include "planar/pair_map.h"
#include "planar/triangle_mesh.h"

namespace aresta::planar {

/// Per mesh, rising.
using ActiveTriangles = std::array<std::vector<Index>, 2>;

ActiveTriangles active_triangles(const TriangleMesh& a, const TriangleMesh& b, double tolerance);

}  // namespace aresta::planar
