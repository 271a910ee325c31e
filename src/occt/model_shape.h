// SPDX-License-Identifier: Apache-2.0
// The library's shapes of a model's entities. Include only where OCCT may be seen.
#pragma once

#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

#include "occt/to_shape.h"

namespace aresta {

struct ModelShape::Data {
  TopoDS_Compound whole;
  std::vector<TopoDS_Vertex> vertices;  ///< by VertexId; FORWARD
  std::vector<TopoDS_Edge> edges;       ///< by EdgeId; FORWARD
  std::vector<TopoDS_Face> faces;       ///< by FaceId; REVERSED when the model's face is
  std::vector<TopoDS_Shape> regions;    ///< by RegionId; null where there is no solid
};

}  // namespace aresta
