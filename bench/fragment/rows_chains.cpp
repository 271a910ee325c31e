// SPDX-License-Identifier: Apache-2.0
#include "fragment/peers.h"
#include "fragment/rows.h"

namespace aresta::bench {

namespace {

const std::string own = "Aresta " ARESTA_VERSION;
const std::string occt = "OCCT " + occt_version();
const std::string nef = "CGAL " + cgal_version() + " Nef";
const std::string corefinement = "CGAL " + cgal_version() + " corefinement";

const std::string& manifold() {
  static const std::string name = "manifold-3d " + manifold_version();
  return name;
}

/// Meshes of floats come with a tolerance of that size.
void run_manifold(Table& table, const std::function<Chain()>& make) {
  table.run(
      manifold(), [&] { return chain_with_manifold(make()); }, 1e-7);
}

}  // namespace

void sphere_rows(Table& table) {
  for (const std::uint32_t n : {7u, 22u, 71u, 224u}) {
    table.begin("spheres " + std::to_string(20 * n * n), 0);
    table.run(own, [&] { return meshes_with_aresta(two_spheres(n)); });
    table.run(corefinement, [&] { return chain_with_corefinement(two_spheres(n)); });
    run_manifold(table, [&] { return two_spheres(n); });
    if (n < 71) continue;
    table.faster_than(manifold(), 1.5);
    table.faster_than(corefinement, 2);
    if (n == 224) table.at_most("megabytes", table.peak_megabytes(), 800);
  }
}

void plate_rows(Table& table) {
  for (const int count : {10, 20, 40}) {
    const Chain chain = plate_with_holes(count);
    table.begin("plate " + std::to_string(count) + "x" + std::to_string(count), chain.volume);
    table.run(own, [&] { return chain_with_aresta(chain); });
    if (count <= 20) table.run(occt, [&] { return chain_with_occt(chain); });
    table.run(nef, [&] { return chain_with_nef(chain); });
    table.run(corefinement, [&] { return chain_with_corefinement(chain); });
    run_manifold(table, [&] { return chain; });
  }
}

void sponge_rows(Table& table) {
  for (const int level : {1, 2, 3, 4}) {
    const Chain chain = sponge(level);
    table.begin("sponge " + std::to_string(level), chain.volume);
    table.run(own, [&] { return chain_with_aresta(chain); });
    if (level <= 3) table.run(occt, [&] { return chain_with_occt(chain); });
    if (level <= 3) table.run(nef, [&] { return chain_with_nef(chain); });
    if (level <= 2) table.run(corefinement, [&] { return chain_with_corefinement(chain); });
    run_manifold(table, [&] { return chain; });
  }
}

void terrain_rows(Table& table) {
  for (const int size : {100, 500}) {
    const Chain chain = terrain(size);
    table.begin("terrain " + std::to_string(size), chain.volume);
    table.run(own, [&] { return chain_with_aresta(chain); });
    table.run(corefinement, [&] { return chain_with_corefinement(chain); });
    run_manifold(table, [&] { return chain; });
  }
}

}  // namespace aresta::bench
