// SPDX-License-Identifier: Apache-2.0
// Reading a library shape into a builder, with the maps between subshapes and entities. Include only where OCCT may be
// seen.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "occt/to_model.h"

namespace aresta {

struct VoidSides {
  TopoDS_Shape shell;            ///< as part of the solid: its faces look into the void
  std::vector<FaceUse> outside;  ///< the sides of faces that look into the void
};

struct SolidSides {
  std::vector<FaceUse> inside;  ///< the sides of faces that look into the solid
  std::vector<VoidSides> voids;
};

struct ShapeMaps {
  TopTools_IndexedMapOfShape vertices, edges, faces, solids;  ///< entity id = index - 1; edges without extent left out
  std::vector<SolidSides> sides;                              ///< per solid
};

struct ModelOfShape::Data {
  ShapeMaps maps;
  std::vector<RegionId> regions;  ///< per solid
};

/// Adds every vertex, edge and face of the shape to an empty builder; fills follow from the solids. Repairs the shape's
/// representation where needed (see to_model.h).
Status read_shape(const TopoDS_Shape& shape, ModelBuilder& builder, ShapeMaps& maps, const Context& context);

}  // namespace aresta
