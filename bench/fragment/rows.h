// SPDX-License-Identifier: Apache-2.0
// The problems, and what is asked of them.
#pragma once

#include "fragment/table.h"

namespace aresta::bench {

void grid_rows(Table& table);   ///< a grid of blocks and a block across it
void block_rows(Table& table);  ///< random blocks, axis-parallel and turned

}  // namespace aresta::bench
