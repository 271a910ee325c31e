// SPDX-License-Identifier: Apache-2.0
// Identity first: the soup's vertices, edges and faces, each once.
//
// Contract. Vertices nearer than the tolerance are one; edges with the same ends are one; faces with the same edges are
// one (principle 1: tolerance is asked once, then names decide). The first of the soup's entities gives the place and
// the direction. A cluster of vertices that hangs together link by link but is wider than the tolerance is refused
// (cluster_too_wide) with its members named. Edges shorter than the tolerance vanish; so do faces
// thinner than it, whose vertices then lie on their edges. A face whose vertices are off its plane by more than twice
// the tolerance is refused (face_not_planar). Deterministic; cost n log n.
#pragma once

#include "math/exact_points.h"
#include "planar/errors.h"
#include "planar/plane_faces.h"
#include "planar/soup.h"

namespace aresta::planar {

struct Entities {
  double tolerance = 0;
  Lattice lattice{0};  ///< on which exact constructions stand; its step is far below the tolerance
  std::vector<Vec3> points;
  Incidence shape;  ///< faces of loops of coedges; vertex_count is what the soup gave
  std::vector<Plane> planes;
  std::vector<Box3> boxes;                ///< of faces
  std::vector<IndexPair> vertex_on_edge;  ///< (edge, vertex): of faces thinner than the tolerance
  std::vector<IndexPair> vertex_in_face;  ///< (face, vertex): the vertex loops of all members

  Lists vertex_members, edge_members, face_members;     ///< the soup's entities that each of ours is, sorted
  Lists vertex_operands, edge_operands, face_operands;  ///< sorted, none twice
  std::vector<bool> stitched;                           ///< per operand
  Lists faces_of_edge;                                  ///< sorted, none twice

  PlaneFaces faces() const { return {points, shape, planes, tolerance}; }
  Index edge_count() const { return shape.edge_count(); }
  Index face_count() const { return shape.face_count(); }
  std::span<const Index> coedges_of(Index face) const { return faces().coedges_of(face); }
  LatticePoint lattice_point(Index vertex) const { return lattice.to_lattice(points[vertex]); }
  /// Through vertices of the face, never without one for a face that is kept; made anew each time.
  std::optional<ExactPlane> exact_plane(Index face) const;
  /// Is some operand that knows how its entities meet in both lists?
  bool share_operand(std::span<const Index> a, std::span<const Index> b) const;
};

/// `tolerance` > 0, absolute.
Result<Entities> unite(const Soup& soup, double tolerance);

}  // namespace aresta::planar
