// SPDX-License-Identifier: Apache-2.0
// Small models as a few readable lines, for tests and for whoever tries something out.
//
//   # two tetrahedra with a common face, a point in the upper one, and a wire
//   base: 0 1 2
//   a: 0 1 3
//   b: 1 2 3
//   c: 2 0 3
//   d: 1 0 4
//   e: 2 1 4
//   f: 0 2 4
//   about 0 1: base a d
//   about 1 2: base b e
//   about 2 0: base c f
//   region upper filled: +base
//   region lower filled: -base
//   point 5 in upper
//   wire 3 6 7
//
// Lines, in any order; names are letters, digits and "_", and "#" begins a comment:
//   FACE: LOOP | LOOP ...            a face; each loop names its vertices counterclockwise seen from the face's front
//   wire STEPS VERTEX [in REGION]    wires from vertex to vertex
//   point VERTEX ... [in REGION]     isolated vertices
//   about STEP VERTEX: USE ...       the uses of an edge, counterclockwise about the direction from STEP to VERTEX
//   region REGION filled: SIDE ...   a region (or `empty`) and its sides: +FACE front, -FACE back
//
// Edges follow from the vertices. A step VERTEX[.SUFFIX][-] stands for an edge from this vertex to the next one:
// several edges between the same vertices are told apart by suffix ("0" when there is none), and "-" runs against an
// edge that is closed. A loop of one vertex is that vertex; with a suffix it is a closed edge:
//   annulus: a b c | p r q           disk: a.0          torus: a.0 a.1 a.0- a.1-          digon: a b.1
//   cylinder: a.0 a b.0- b           with a point in its inside: 0 1 2 | 3
//
// A USE is the name of a face, with a sign when it uses the edge in both senses, and +FACE.1 for its second use in one
// sense (from 0 on). Edges with one or two uses need no `about`. A region takes all sides that are joined to those
// named through sectors about edges, so that one is enough for a body; what no region takes is in the infinite one. Ids
// grow with the lines: regions from 1, faces from 0, edges by their first step, which is their direction. Vertices that
// are named by the numbers 0 to n - 1 have these as ids, others grow with their first mention.
#pragma once

#include <string_view>

#include "base/result.h"
#include "topology/complex.h"
#include "topology/errors.h"

namespace aresta {

/// Any bytes may come; errors say the line. n log n.
Result<Complex> parse_notation(std::string_view text);

}  // namespace aresta
