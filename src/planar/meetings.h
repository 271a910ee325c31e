// SPDX-License-Identifier: Apache-2.0
// Where the entities meet: all vertices of the imprint, which of them lie on which edge and in which face.
//
// Contract. Afterwards a vertex nearer than the tolerance to an edge or a face is on it by name, and every crossing of
// an edge with an edge or a face, and of three faces, is a vertex on all of them. Segments where two faces cross run
// between two vertices that both have. Whatever is nearer than the tolerance is one; every other decision is therefore
// taken with a margin of the tolerance, a million times the rounding of a coordinate. New places come from the
// operands' own vertices and planes, never from new ones, and are right to a thousandth of the tolerance however flat
// the angle: doubles where a bound of their error proves it, integers of a fixed width else (math/exact_points.h).
//
// Method: lowest dimension first. Vertices on edges and in faces; edges across faces and each other; each new vertex is
// asked for all that it lies on; then, until nothing is new, the segments of faces across faces and their crossings
// inside a face. Candidates from one box tree of the faces. A vertex's places follow from the order of the entities,
// not from the order of the work.
// Not guaranteed: where faces run along each other within the tolerance over part of their width only, the segment
// between them is one of several that are right within the tolerance.
#pragma once

#include "base/context.h"
#include "planar/entities.h"

namespace aresta::planar {

/// A straight piece between two vertices with nothing between them.
struct Piece {
  Index a = none, b = none;
  /// The faces that cross here, or none where the piece is one of edges.
  Index face = none, other_face = none;
};

struct Meetings {
  std::vector<Vec3> points;  ///< those of the entities, then what is new
  Lists vertices_of_edge;    ///< per edge: from its start to its end, both among them
  Lists vertices_in_face;    ///< per face: inside, on no edge of it; its vertex loops among them
  Lists faces_of_vertex;     ///< per vertex: faces that have it inside or on their boundary, sorted
  std::vector<Piece> pieces;
  Lists edges_of_piece;  ///< sorted
  Lists pieces_of_vertex;
  Stages stages;  ///< how sides and places were decided: by name, by doubles with a bound, by integers
};

Result<Meetings> find_meetings(const Entities& entities, const Context& context);

}  // namespace aresta::planar
