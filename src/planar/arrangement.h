// SPDX-License-Identifier: Apache-2.0
// One face divided by the pieces that lie in it.
//
// Contract. Given the pieces of the face's own boundary with their sense, the pieces inside it and its vertices, each
// connected part of the face minus pieces and vertices is one cell: an outer loop counterclockwise about the normal,
// inner loops, and vertices alone. A cell belongs to the face when the boundary winds round it once; a boundary that
// winds otherwise is refused. Pieces that dangle are run through twice.
// Method: half-edges sorted about each vertex, next one clockwise; components nested by point in polygon. n log n in
// the face's pieces, plus the pairs of components whose boxes lie in each other.
#pragma once

#include "base/result.h"
#include "math/vec.h"
#include "planar/pair_map.h"

namespace aresta::planar {

struct FaceDrawing {
  struct Line {
    Index piece = none;
    Index a = none, b = none;  ///< local vertices
    int winding = 0;           ///< times that the boundary runs from a to b, less the times from b to a
  };
  std::vector<Vec2> points;  ///< of local vertices, in the plane, counterclockwise
  std::vector<Line> lines;   ///< none twice
};

/// Coedges are 2 * piece + reversed, against the direction that the line gave.
struct FaceCell {
  std::vector<std::vector<Index>> loops;  ///< the outer one first
  std::vector<Index> points;              ///< local vertices alone inside
};

/// Errors: planar_unresolved.
Result<std::vector<FaceCell>> arrange(const FaceDrawing& drawing);

}  // namespace aresta::planar
