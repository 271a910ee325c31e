// SPDX-License-Identifier: Apache-2.0
#include "fragment/rows.h"

#include <cstdio>

#include "fragment/peers.h"

namespace aresta::bench {

namespace {

const std::string own = "Aresta " ARESTA_VERSION;
const std::string occt = "OCCT " + occt_version();
const std::string nef = "CGAL " + cgal_version() + " Nef";

void with_peers(Table& table, const std::vector<Block>& blocks) {
  table.run(own, [&] { return cells_with_aresta(blocks); });
  table.run(occt, [&] { return cells_with_occt(blocks); });
  table.run(nef, [&] { return cells_with_nef(blocks); });
}

}  // namespace

void grid_rows(Table& table) {
  double per_cell_at_8 = 0;
  for (const int n : {3, 5, 8, 10, 20, 40}) {
    const auto blocks = grid_of_blocks(n);
    table.begin("grid " + std::to_string(n), volume_of_grid(n));
    if (n <= 10) {
      with_peers(table, blocks);
    } else {
      table.run(own, [&] { return cells_with_aresta(blocks); });
    }
    if (!table.ours()) continue;
    table.at_most("cells too many or too few", std::abs(1. * table.ours()->cells - 1. * cells_of_grid(n)), 0);
    const double per_cell = table.ours()->seconds / static_cast<double>(table.ours()->cells);
    if (n == 8) {
      per_cell_at_8 = per_cell;
      table.faster_than(occt, 300);
      table.faster_than(nef, 100);
    }
    if (n == 40) table.at_most("time per cell, ratio to grid 8", per_cell / per_cell_at_8, 1.5);
  }
}

void block_rows(Table& table) {
  for (const bool turned : {false, true}) {
    for (const int count : {10, 30, 100, 300}) {
      const auto blocks = random_blocks(count, turned);
      table.begin(std::string(turned ? "turned" : "axis-parallel") + " blocks " + std::to_string(count),
                  volume_of_union(blocks));
      if (count <= 100) {
        with_peers(table, blocks);
      } else {
        table.run(own, [&] { return cells_with_aresta(blocks); });
      }
      if (!turned || count != 100) continue;
      table.faster_than(occt, 100);
      table.faster_than(nef, 25);
    }
  }
}

}  // namespace aresta::bench
