// SPDX-License-Identifier: Apache-2.0
#include "topology/betti.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "catalogue.h"
#include "sketch.h"
#include "topology/item.h"

namespace aresta {
namespace {

/// The rank of a matrix over the field of two elements; its columns are sets of rows.
std::size_t rank(std::vector<std::set<std::size_t>> columns) {
  std::map<std::size_t, std::set<std::size_t>> by_lowest;
  for (auto& column : columns) {
    while (!column.empty()) {
      const auto [pivot, fresh] = by_lowest.emplace(*column.rbegin(), column);
      if (fresh) break;
      for (const std::size_t row : pivot->second) {
        if (!column.erase(row)) column.insert(row);
      }
    }
  }
  return by_lowest.size();
}

void flip(std::set<std::size_t>& column, std::size_t row) {
  if (!column.erase(row)) column.insert(row);
}

struct Betti {
  std::size_t b0 = 0, b1 = 0, b2 = 0;
  bool operator==(const Betti&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Betti& b) {
  return out << b.b0 << ' ' << b.b1 << ' ' << b.b2;
}

/// A complex of discs: edges by their two vertices, discs by the edges that they run along.
struct Discs {
  std::size_t vertices = 0;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::vector<std::size_t>> discs;

  Betti betti() const {
    std::vector<std::set<std::size_t>> of_edges, of_discs;
    for (const auto& e : edges) {
      of_edges.emplace_back();
      for (const std::size_t v : e) flip(of_edges.back(), v);
    }
    for (const auto& disc : discs) {
      of_discs.emplace_back();
      for (const std::size_t e : disc) flip(of_discs.back(), e);
    }
    const std::size_t r1 = rank(of_edges), r2 = rank(of_discs);
    return {vertices - r1, edges.size() - r1 - r2, discs.size() - r2};
  }

  /// Every edge is cut in two, every disc into triangles about a new vertex, three for each step along its boundary:
  /// what comes out is a simplicial complex.
  Discs triangulated() const {
    Discs result;
    result.vertices = vertices + edges.size() + discs.size();
    std::map<std::array<std::size_t, 2>, std::size_t> half;  // by edge and end
    const auto add_edge = [&](std::size_t a, std::size_t b) {
      result.edges.push_back({a, b});
      return result.edges.size() - 1;
    };
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (std::size_t end = 0; end < 2; ++end) half[{e, end}] = add_edge(edges[e][end], vertices + e);
    }
    for (std::size_t d = 0; d < discs.size(); ++d) {
      // Round the disc over halves of edges: each step gets a triangle with the centre.
      const std::size_t centre = vertices + edges.size() + d;
      std::vector<std::pair<std::size_t, std::size_t>> around;  // where a half begins, and the half
      for (const auto& [e, end] : ends_along(d)) {
        around.emplace_back(edges[e][end], half.at({e, end}));
        around.emplace_back(vertices + e, half.at({e, 1 - end}));
      }
      if (around.empty()) return {};  // a sphere on a vertex has no boundary to run along
      std::vector<std::size_t> spokes;
      for (const auto& step : around) spokes.push_back(add_edge(step.first, centre));
      for (std::size_t i = 0; i < around.size(); ++i) {
        result.discs.push_back({spokes[i], around[i].second, spokes[(i + 1) % around.size()]});
      }
    }
    return result;
  }

  std::vector<std::vector<std::size_t>> senses;  ///< of the discs: the end of each edge that the disc comes to first

 private:
  std::vector<std::array<std::size_t, 2>> ends_along(std::size_t d) const {
    std::vector<std::array<std::size_t, 2>> result;
    for (std::size_t i = 0; i < discs[d].size(); ++i) result.push_back({discs[d][i], senses[d][i]});
    return result;
  }
};

/// The same subset of space: faces with several loops are cut open along new edges between their loops.
Discs as_discs(const Complex& k) {
  Discs result;
  result.vertices = k.vertex_count();
  for (const EdgeId e : k.edges()) result.edges.push_back({k.start(e).index(), k.end(e).index()});
  for (const FaceId f : k.faces()) {
    std::vector<std::size_t> edges, senses;
    const auto start_of = [&](LoopId l) {
      return k.is_vertex_loop(l) ? k.loop_vertex(l).index() : k.start(k.first_coedge(l)).index();
    };
    std::vector<std::size_t> way_back;
    const std::size_t from = start_of(k.first_loop(f));
    for (const LoopId l : k.loops(f)) {
      // All loops hang on the first one's start: there along a new edge, round the loop, and back.
      const bool is_first = l == k.first_loop(f);
      if (!is_first) {
        result.edges.push_back({from, start_of(l)});
        edges.push_back(result.edges.size() - 1);
        senses.push_back(0);
      }
      for (const CoedgeId c : k.coedges(l)) {
        edges.push_back(k.edge(c).index());
        senses.push_back(k.reversed(c) ? 1 : 0);
      }
      if (!is_first) {
        edges.push_back(result.edges.size() - 1);
        senses.push_back(1);
      }
    }
    result.discs.push_back(edges);
    result.senses.push_back(senses);
  }
  return result;
}

Betti betti_of(const Complex& k) {
  const ComplexCounts n = counts(k);
  return {n.components, n.tunnels, n.voids};
}

TEST(Betti, AgreesWithRanksOfBoundariesOverTheCatalogue) {
  for (const CatalogueModel& model : catalogue()) {
    if (model.name == std::string("klein bottle")) continue;
    const Discs discs = as_discs(model.complex);
    EXPECT_EQ(betti_of(model.complex), discs.betti()) << model.name;
    const Discs triangles = discs.triangulated();
    if (triangles.vertices == 0 && discs.vertices != 0) continue;
    EXPECT_EQ(betti_of(model.complex), triangles.betti()) << model.name;
  }
}

TEST(Betti, KnownShapes) {
  const std::pair<const char*, Betti> expected[] = {
      {"nothing", {0, 0, 0}},
      {"three points", {3, 0, 0}},
      {"closed edge", {1, 1, 0}},
      {"theta", {1, 2, 0}},
      {"tree", {1, 0, 0}},
      {"triangle", {1, 0, 0}},
      {"square with hole", {1, 1, 0}},
      {"square with two holes", {1, 2, 0}},
      {"square with point", {1, 0, 0}},
      {"moebius strip", {1, 1, 0}},
      {"book of three", {1, 0, 0}},
      {"tetrahedron", {1, 0, 1}},
      {"cube", {1, 0, 1}},
      {"torus", {1, 2, 1}},
      {"torus of one face", {1, 2, 1}},
      {"genus two", {1, 4, 1}},
      {"cube with through hole", {1, 2, 1}},
      {"cube with blind hole", {1, 0, 1}},
      {"sphere on vertex", {1, 0, 1}},
      {"sphere on two vertices", {1, 0, 1}},
      {"cube with handle", {1, 1, 1}},
      {"cube with wire inside", {1, 0, 1}},
      {"torus with membrane inside", {1, 1, 1}},
      {"torus with membrane across hole", {1, 1, 1}},
      {"two cubes with common face", {1, 0, 2}},
      {"eight cubes", {1, 0, 8}},
      {"cube standing on cube", {1, 0, 2}},
      {"cube with void", {2, 0, 2}},
      {"cube with toroidal void", {2, 2, 2}},
      {"cube with wire to its void", {1, 0, 2}},
      {"two tetrahedra with common vertex", {1, 0, 2}},
      {"two tetrahedra with common edge", {1, 0, 2}},
      {"two tetrahedra with common face", {1, 0, 2}},
      {"ring of three tetrahedra", {1, 1, 3}},
      {"touching itself in an edge", {1, 0, 1}},
      {"touching itself in a vertex", {1, 1, 1}},
      {"klein bottle", {1, 1, 0}},
  };
  for (const auto& [name, betti] : expected) EXPECT_EQ(betti_of(catalogue_model(name)), betti) << name;
}

TEST(Betti, CountsEdgesByTheirUses) {
  const ComplexCounts n = counts(catalogue_model("book of three"));
  EXPECT_EQ(n.non_manifold_edges, 1u);
  EXPECT_EQ(n.laminas, 9u);
  EXPECT_EQ(n.manifold_edges + n.wires, 0u);
  EXPECT_EQ(n.euler_characteristic(), 1);
  const ComplexCounts mixed = counts(catalogue_model("cube with points"));
  EXPECT_EQ(mixed.isolated_vertices, 2u);
  EXPECT_EQ(mixed.manifold_edges, 12u);
  EXPECT_EQ(mixed.components, 3u);
  EXPECT_EQ(counts(catalogue_model("cube with wires on both sides")).wires, 2u);
  EXPECT_EQ(counts(catalogue_model("cube with void")).filled_regions, 1u);
  EXPECT_EQ(counts(catalogue_model("cube with void")).regions, 3u);
}

/// Shells, components and regions make a tree, as do surfaces of sides; so two more ways to count agree.
TEST(Betti, ShellsAreComponentsAndRegionsLessOne) {
  for (const CatalogueModel& model : catalogue()) {
    const ComplexCounts n = counts(model.complex);
    EXPECT_EQ(n.shells + 1, n.components + n.regions) << model.name;
  }
}

std::string surfaces_of(const char* name) {
  std::string text;
  for (const SideSurface& surface : side_surfaces_of(catalogue_model(name))) {
    text += (text.empty() ? "" : " ") + std::to_string(surface.sides) + ':' + std::to_string(surface.genus());
  }
  return text;
}

TEST(Betti, SidesMakeClosedSurfaces) {
  EXPECT_EQ(surfaces_of("triangle"), "2:0");
  EXPECT_EQ(surfaces_of("square with hole"), "2:1");
  EXPECT_EQ(surfaces_of("square with two holes"), "2:2");
  EXPECT_EQ(surfaces_of("square with strut"), "2:0");
  EXPECT_EQ(surfaces_of("moebius strip"), "10:1");
  EXPECT_EQ(surfaces_of("klein bottle"), "18:1");
  EXPECT_EQ(surfaces_of("book of three"), "6:0");
  EXPECT_EQ(surfaces_of("sphere on vertex"), "1:0 1:0");
  EXPECT_EQ(surfaces_of("sphere on two vertices"), "1:0 1:0");
  EXPECT_EQ(surfaces_of("cube"), "6:0 6:0");
  EXPECT_EQ(surfaces_of("cube with fin"), "8:0 6:0");
  EXPECT_EQ(surfaces_of("torus"), "9:1 9:1");
  EXPECT_EQ(surfaces_of("torus with membrane inside"), "9:1 11:0");
  EXPECT_EQ(surfaces_of("two tetrahedra with common edge"), "8:0 4:0 4:0");
  EXPECT_EQ(surfaces_of("two tetrahedra with common vertex"), "4:0 4:0 4:0 4:0");
  for (const CatalogueModel& model : catalogue()) {
    for (const SideSurface& surface : side_surfaces_of(model.complex)) {
      EXPECT_EQ(surface.euler_characteristic() % 2, 0) << model.name;
      EXPECT_LE(surface.euler_characteristic(), 2) << model.name;
    }
  }
}

/// V E F L S G of each region whose boundary is manifold.
std::string terms_of(const char* name) {
  std::string text;
  for (const EulerPoincare& x : euler_poincare(catalogue_model(name))) {
    text += text.empty() ? "" : "; ";
    text += std::to_string(x.region.value) + ':';
    for (const long term : {x.vertices, x.edges, x.faces, x.loops, x.shells, x.genus})
      text += ' ' + std::to_string(term);
  }
  return text;
}

TEST(Betti, EulerPoincareOfSolids) {
  EXPECT_EQ(terms_of("cube"), "0: 8 12 6 6 1 0; 1: 8 12 6 6 1 0");
  EXPECT_EQ(terms_of("torus of one face"), "0: 1 2 1 1 1 1; 1: 1 2 1 1 1 1");
  EXPECT_EQ(terms_of("cube with through hole"), "0: 16 24 10 12 1 1; 1: 16 24 10 12 1 1");
  EXPECT_EQ(terms_of("cube with point in face"), "0: 9 12 6 7 1 0; 1: 9 12 6 7 1 0");
  EXPECT_EQ(terms_of("sphere on two vertices"), "0: 2 0 1 2 1 0; 1: 2 0 1 2 1 0");
  EXPECT_EQ(terms_of("cube with void"), "0: 8 12 6 6 1 0; 1: 16 24 12 12 2 0; 2: 8 12 6 6 1 0");
  EXPECT_EQ(terms_of("cube with toroidal void"), "0: 8 12 6 6 1 0; 1: 17 30 15 15 2 1; 2: 9 18 9 9 1 1");
  EXPECT_EQ(terms_of("two tetrahedra with common edge"), "1: 4 6 4 4 1 0; 2: 4 6 4 4 1 0");
  EXPECT_EQ(terms_of("cube with wire inside"), "0: 8 12 6 6 1 0");
  EXPECT_EQ(terms_of("cube with fin"), "1: 8 12 6 6 1 0");
  EXPECT_EQ(terms_of("touching itself in an edge"), "");
  EXPECT_EQ(terms_of("triangle"), "");
  EXPECT_EQ(terms_of("nothing"), "");
  std::size_t regions = 0;
  for (const CatalogueModel& model : catalogue()) {
    for (const EulerPoincare& x : euler_poincare(model.complex)) {
      EXPECT_EQ(x.residual(), 0) << model.name << ", region " << x.region.value;
      ++regions;
    }
  }
  EXPECT_GT(regions, 80u);
}

}  // namespace
}  // namespace aresta
