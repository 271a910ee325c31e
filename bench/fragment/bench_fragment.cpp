// SPDX-License-Identifier: Apache-2.0
// Fragments and set operations of planar models beside other libraries, in one run, one thread each.
//
//   bench_fragment [PROBLEM...]     grid blocks spheres plate sponge terrain; default: all
//
// Each library has each problem in a process of its own; times are processor time, the median of up to five rounds. In
// the time of Aresta is all that a user gets: imprint, cells, labels, conservation; operands are made before, for all
// alike. Every answer is held against a volume from elsewhere and against our count of cells. A figure that has a bound
// has a line; the exit status is 1 when one is passed or an answer differs.
#include <algorithm>
#include <cstdio>
#include <string>

#include "fragment/rows.h"

int main(int count, char** arguments) {
  using namespace aresta::bench;
  const std::vector<std::pair<std::string, void (*)(Table&)>> problems{
      {"grid", grid_rows},   {"blocks", block_rows},  {"spheres", sphere_rows},
      {"plate", plate_rows}, {"sponge", sponge_rows}, {"terrain", terrain_rows}};
  std::vector<std::string> chosen(arguments + 1, arguments + count);
  if (chosen.empty()) {
    for (const auto& [name, rows] : problems) chosen.push_back(name);
  }
  Table table;
  for (const std::string& name : chosen) {
    const auto rows = std::find_if(problems.begin(), problems.end(), [&](const auto& p) { return p.first == name; });
    if (rows == problems.end()) {
      std::fprintf(stderr, "bench_fragment: there is no problem '%s'\n", name.c_str());
      return 2;
    }
    rows->second(table);
  }
  return table.all_within() ? 0 : 1;
}
