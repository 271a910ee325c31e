// SPDX-License-Identifier: Apache-2.0
// Polygons in planes, as the parts of this folder hand them to each other.
#pragma once

#include <span>

#include "math/vec.h"
#include "planar/pair_map.h"
#include "topology/assemble.h"

namespace aresta::planar {

struct Plane {
  Vec3 normal;  ///< unit
  Vec3 origin;
  int axis = 0;  ///< of the normal's largest component

  double distance(Vec3 p) const { return dot(normal, p - origin); }
  /// Two coordinates in the plane, counterclockwise about the normal; not true to scale.
  Vec2 flat(Vec3 p) const {
    const double x = p[(axis + 1) % 3], y = p[(axis + 2) % 3];
    return normal[axis] > 0 ? Vec2{x, y} : Vec2{y, x};
  }
};

/// A view of faces with straight edges. The points may be more than the shape has vertices.
struct PlaneFaces {
  const std::vector<Vec3>& points;
  const Incidence& shape;
  const std::vector<Plane>& planes;  ///< per face
  double tolerance = 0;

  /// The coedges of all loops of a face, in one row.
  std::span<const Index> coedges_of(Index face) const {
    const Index first = shape.loop_begin[shape.face_begin[face]], last = shape.loop_begin[shape.face_begin[face + 1]];
    return {shape.coedges.data() + first, last - first};
  }
};

}  // namespace aresta::planar
