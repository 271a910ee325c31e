// SPDX-License-Identifier: Apache-2.0
// Wires and points inside a region, for a volume mesher that conforms to triangles only: each side of a wire becomes a
// side of a helper triangle, each point a corner of one. The tetrahedra that conform to the helpers conform to the
// wires and points; the helpers themselves are no part of the mesh.
//
// Guarantees: helpers meet the surface triangles and each other in shared nodes only.
// Not guaranteed: that there is room; then an error names the wire or point and the place, and a finer mesh may help.
#pragma once

#include "mesh/volume_input.h"

namespace aresta::mesh {

struct EmbeddedSide {
  std::uint32_t a = 0, b = 0;  ///< nodes
  EntityRef entity;            ///< the wire
  std::uint32_t region = 0;    ///< as in VolumeTriangle
};

struct EmbeddedPoint {
  std::uint32_t node = 0;
  EntityRef entity;
  std::uint32_t region = 0;
  double size = 0;  ///< wished side of elements there
};

struct EmbedInput {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> surface;  ///< all triangles that helpers must keep off
  std::vector<EmbeddedSide> sides;
  std::vector<EmbeddedPoint> isolated;
};

struct Helpers {
  std::vector<Vec3> points;  ///< the input's, then the helpers' own
  std::vector<VolumeTriangle> triangles;
};

/// Error: mesh.embedded_wire.
Result<Helpers> embed(const EmbedInput& input);

}  // namespace aresta::mesh
