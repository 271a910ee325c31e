// SPDX-License-Identifier: Apache-2.0
// The problems, and what is asked of them.
#pragma once

#include "fragment/table.h"

namespace aresta::bench {

void grid_rows(Table& table);   ///< a grid of blocks and a block across it
void block_rows(Table& table);  ///< random blocks, axis-parallel and turned

void sphere_rows(Table& table);   ///< the union of two spheres of triangles
void plate_rows(Table& table);    ///< a plate with holes, in one difference
void sponge_rows(Table& table);   ///< a Menger sponge, by differences
void terrain_rows(Table& table);  ///< a height field minus blocks with sides in common planes

}  // namespace aresta::bench
