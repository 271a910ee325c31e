// SPDX-License-Identifier: Apache-2.0
// The checker of the structure: every invariant of the radial edge complex (complex.h), tested on the records alone.
//
// Stages, each relying on those before it; the first one with findings is the last one run, as what follows would
// mostly say the same again:
//   rows    free rows are listed once and counted; every link leads to a row in use
//   lists   cycles and chains close, their links answer each other, each member is in the list of its owner
//   cells   loops close; no cell is empty or unused; the sides of a sector lie in one region, and so do wires and what
//           they hang on
//   shells  (not fast) a shell is what is connected in a region
//   space   (full only) the cells at a vertex fit on a sphere about it; regions are reached and connected, as far as
//   can
//           be told without coordinates
//
// The last follows from duality in space. Take the parts of faces that are connected through edges, and the regions:
// each closed surface of sides (connected through sectors) links one part to one region, and these links make a tree:
// two surfaces of one part are divided by its faces. In the same way the connected parts of the whole complex and the
// regions are linked by shells, so that shells = components + regions - 1. Closed sheets with one side (as the Klein
// bottle) have no place in space but one surface, and pass.
//
// Guarantees: never crashes and always ends, whatever the records hold. Findings are sorted, and depend on the complex
// only. Linear time and memory, but for the sorting of what is found and the inverse Ackermann function.
#pragma once

#include <vector>

#include "topology/finding.h"

namespace aresta {

enum class StructureLevel {
  fast,    ///< links and what can be seen about one cell
  shells,  ///< also shells
  full     ///< also what must hold in space: the order about vertices, regions
};

/// All findings; an empty list is the only good answer.
std::vector<StructuralFinding> check_structure(const Complex& complex, StructureLevel level = StructureLevel::full);

}  // namespace aresta
