// SPDX-License-Identifier: Apache-2.0
// The whole of a complex as text that people read.
//
// Regions with their shells, faces with their loops and coedges, edges with their ends and uses, vertices with the
// edges there. Canonical: complexes that are the same up to ids of shells and up to the order and start of linked lists
// give the same bytes. Lists grow by id; a loop and the uses of an edge begin at their smallest coedge and keep their
// cyclic order; shells come by their smallest item (sides before wires before points).
//
//   dump     = "aresta complex 1" NEWLINE {region} {face} {edge} {vertex}
//   region   = "region" R ":" ("infinite" | "filled" | "empty") NEWLINE {shell}
//   shell    = "shell" item {item} NEWLINE
//   item     = "+"F | "-"F | E | V                                     front or back of a face, a wire, a point
//   face     = "face" F ":" "front" R "," "back" R NEWLINE loop {loop}
//   loop     = "loop" L NEWLINE coedge {coedge} | "loop" L ":" V NEWLINE
//   coedge   = "coedge" C ":" sense E "," V "to" V "," "radial" C NEWLINE
//   edge     = "edge" E ":" V "to" V "," ("radial" C {C} | "wire" "in" R) NEWLINE
//   vertex   = "vertex" V ":" ({sense E} {L} | "in" R) NEWLINE
//   sense    = "+" | "-"                                               along the edge, against it
//
// R, F, L, C, E, V are ids: r0, f12, l3, c40, e7, v5. The edges of a vertex are seen from it: "-" where the edge ends
// there. "radial" names the next use counterclockwise about the edge; in an edge all uses in that order. Words are set
// apart by blanks, "#" begins a comment that ends with the line, empty lines and indentation mean nothing.
#pragma once

#include <string>

#include "topology/complex.h"

namespace aresta {

/// The text of a valid complex. Linear, but for sorting.
std::string dump(const Complex& k);

}  // namespace aresta
