// SPDX-License-Identifier: Apache-2.0
// A fragment against the enumeration, entity by entity.
//
// Compared, each exactly: counts; which lattice points, edges, squares and cells every vertex, edge, face and region
// is; loops of faces, radial order about edges, shells of regions; filled regions; parents of everything, pieces of
// everything, regions of the operands around every cell, senses of faces; areas and volumes (to 1e-9). Counts differ or
// entities are elsewhere: what is built on them is not compared.
#pragma once

#include "fragment/fragment.h"
#include "fragment/oracle/enumeration.h"

namespace aresta::grid {

/// One line for each difference, at most some dozens; empty when all agrees.
std::vector<std::string> compare(const Enumeration& expected, const Fragment& found);

}  // namespace aresta::grid
