// SPDX-License-Identifier: Apache-2.0
// How sides of faces hang together: around edges they make closed surfaces, around a vertex they make fans.
//
// A corner is where a face comes to a vertex between two coedges of a loop; it is named by the coedge that starts there
// and, seen from one side of the face, by 2 * coedge + side. A sector about an edge joins two sides of faces, and at
// either end of the edge one corner of each. The corners of a side that are joined at a vertex make a closed ring, the
// fan: on a small sphere about the vertex, a boundary of one of the parts into which edges and faces divide it.
//
// The complex must pass the fast check (check.h). Linear, but for the inverse Ackermann function.
#pragma once

#include "base/union_find.h"
#include "topology/complex.h"

namespace aresta {

/// Visits every sector as (coedge before it, coedge behind it), counterclockwise about its edge.
template <class Visit>
void for_each_sector(const Complex& k, Visit&& visit) {
  for (const CoedgeId c : k.coedges()) visit(c, k.radial(c));
}

/// The corner of c's face at an end of c's edge, as the coedge that starts there.
inline CoedgeId corner_at(const Complex& k, CoedgeId c, int edge_end) {
  return k.reversed(c) == (edge_end == 1) ? c : k.next(c);
}

/// The sides that are connected through sectors, as sets of face-use indices.
UnionFind side_surfaces(const Complex& k);
/// The faces that are connected through edges, as sets of face indices.
UnionFind face_parts(const Complex& k);
/// The corners of sides that are connected through sectors, as sets of 2 * coedge + side.
UnionFind fans(const Complex& k);
/// The vertices that are connected through edges and faces, as sets of vertex indices.
UnionFind components(const Complex& k);

}  // namespace aresta
