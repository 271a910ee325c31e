// SPDX-License-Identifier: Apache-2.0
// The imprint of a soup: everything split where it meets, each piece once, with the names of what it came from.
//
// Contract. The result's vertices, edges and faces meet only in shared entities of lower dimension; coincident pieces
// are one; loose and dangling edges and points inside a face are loops of it. Every entity of the soup that is wider
// than the tolerance is the union of its pieces. Places of the soup's vertices do not change; new ones are within
// rounding of where they belong. Deterministic. See meetings.h for what meets, arrangement.h for the faces.
//
// Sources: principle of identity first; half-edges about vertices as in de Berg et al., Computational Geometry, ch. 2;
// the order of interferences (vertices, edges, faces) is that of every boundary evaluator since Requicha and Voelcker
// 1985.
#pragma once

#include "base/context.h"
#include "planar/entities.h"

namespace aresta::planar {

struct Imprinted {
  double tolerance = 0;
  std::vector<Vec3> points;
  Incidence shape;            ///< without radial order and regions
  std::vector<Plane> planes;  ///< per face: of the soup's face that it is a piece of
  /// What of the soup each entity lies in: all vertices, edges and faces of the soup, numbered through in that order.
  Lists vertex_names, edge_names, face_names;
  Stages stages;  ///< how the decisions were taken

  PlaneFaces faces() const { return {points, shape, planes, tolerance}; }
};

Result<Imprinted> imprint(const Soup& soup, double tolerance, const Context& context);

}  // namespace aresta::planar
