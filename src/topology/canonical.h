// SPDX-License-Identifier: Apache-2.0
// The lists of a complex in an order that follows from ids alone, whatever the order in which they are linked and
// wherever a cycle is entered. Two complexes that are the same up to that and to ids of shells give the same lists.
#pragma once

#include <vector>

#include "topology/complex.h"
#include "topology/item.h"

namespace aresta {

/// For each shell of the region its items, growing (sides, then wires, or one point); shells by their smallest item.
std::vector<std::vector<Item>> canonical_shells(const Complex& k, RegionId r);

/// The loops of a face, growing.
std::vector<LoopId> canonical_loops(const Complex& k, FaceId f);

/// The coedges of a loop in its order, and of an edge in theirs about it, both from the smallest on; empty for a vertex
/// loop and for a wire.
std::vector<CoedgeId> canonical_coedges(const Complex& k, LoopId l);
std::vector<CoedgeId> canonical_coedges(const Complex& k, EdgeId e);

/// The edge ends at a vertex, and the loops that are this vertex, both growing.
std::vector<EdgeEnd> canonical_edge_ends(const Complex& k, VertexId v);
std::vector<LoopId> canonical_vertex_loops(const Complex& k, VertexId v);

}  // namespace aresta
