// SPDX-License-Identifier: Apache-2.0
// What the planar engine takes: operands of straight edges and plane faces in one set of arrays.
#pragma once

#include "math/vec.h"
#include "planar/pair_map.h"
#include "topology/assemble.h"

namespace aresta::planar {

/// Vertices, straight edges and plane polygons with holes, loose edges and points in them, of any number of operands
/// side by side. `shape` needs neither a radial order nor regions. Loops run counterclockwise about the face's normal.
struct Soup {
  std::vector<Vec3> points;
  Incidence shape;  ///< shape.vertex_count is points.size()
  std::vector<Index> vertex_operand, edge_operand, face_operand;
  /// Per operand: do its entities meet only in what they share? Then they are not compared with each other.
  std::vector<bool> stitched;
};

}  // namespace aresta::planar
