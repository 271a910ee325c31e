// SPDX-License-Identifier: Apache-2.0
// The loops of one library face: its wires, the edges inside it and its poles brought into cyclic order. Include only
// where OCCT may be seen.
//
// Contract. Given the face FORWARD, each edge use of its wires once in its own sense, INTERNAL and EXTERNAL edges in
// both senses; the result is what one traces with the face to the left: at every corner (vertex and image) the next
// edge is the first one clockwise from the edge that arrives. So wires may be unordered, may touch themselves, and
// inner edges join the loop that they hang on (a chain between two loops makes them one). Edges without extent only
// lead from image to image and are left out of the result. Not guaranteed: inner edges that close a cycle would cut the
// face in two; that is an error. n log n in the face's edges.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

#include "base/result.h"
#include "geometry/curve.h"

namespace aresta {

struct LoopEdge {
  int edge = 0;  ///< index into the map of edges
  bool reversed = false;
  Handle(Geom2d_Curve) image;  ///< null on planes
};

struct FaceLoop {
  std::vector<LoopEdge> edges;
  int vertex = 0;   ///< for a loop that is one vertex: its index into the map of vertices
  double area = 0;  ///< signed, in the parameter plane
};

/// Outer loop first; loops of single vertices last. Errors: to_model_failed.
Result<std::vector<FaceLoop>> find_face_loops(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& vertices,
                                              const TopTools_IndexedMapOfShape& edges);

}  // namespace aresta
