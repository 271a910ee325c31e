// SPDX-License-Identifier: Apache-2.0
// Differences between states, by the definition in difference.h and with all entities looked at.
#include "topology/difference.h"

#include <gtest/gtest.h>

#include <map>

#include "random_operators.h"
#include "topology/canonical.h"
#include "topology/item.h"

namespace aresta {
namespace {

/// What each entity consists of or bounds, as numbers; entities of a kind by id.
template <class IdType>
using Told = std::map<IdType, std::vector<std::uint32_t>>;

struct Everything {
  Told<VertexId> vertices;
  Told<EdgeId> edges;
  Told<CoedgeId> coedges;
  Told<LoopId> loops;
  Told<FaceId> faces;
  Told<RegionId> regions;

  explicit Everything(const Complex& k) {
    const std::uint32_t mark = 0xfffffff0u;
    for (const VertexId v : k.vertices()) {
      auto& said = vertices[v];
      for (const EdgeEnd e : canonical_edge_ends(k, v)) said.push_back(2 * e.edge.value + (e.end == 1 ? 1 : 0));
      said.push_back(mark);
      for (const LoopId l : canonical_vertex_loops(k, v)) said.push_back(l.value);
      said.push_back(mark);
      if (k.isolated_in_shell(v).valid()) said.push_back(k.region(k.isolated_in_shell(v)).value);
    }
    for (const EdgeId e : k.edges()) {
      auto& said = edges[e];
      said = {k.start(e).value, k.end(e).value, mark};
      for (const CoedgeId c : canonical_coedges(k, e)) said.push_back(2 * c.value + (k.reversed(c) ? 1 : 0));
      if (k.is_wire(e)) said.insert(said.end(), {mark, k.region(k.wire_shell(e)).value});
    }
    for (const CoedgeId c : k.coedges()) {
      coedges[c] = {k.edge(c).value, k.reversed(c) ? 1u : 0u, k.loop(c).value, k.next(c).value};
    }
    for (const LoopId l : k.loops()) {
      auto& said = loops[l];
      said = {k.face(l).value, k.loop_vertex(l).value};
      for (const CoedgeId c : canonical_coedges(k, l)) {
        said.push_back(c.value);
        said.insert(said.end(), coedges[c].begin(), coedges[c].end());
      }
    }
    for (const FaceId f : k.faces()) {
      auto& said = faces[f];
      said = {k.region(FaceUse(f, 0)).value, k.region(FaceUse(f, 1)).value};
      for (const LoopId l : canonical_loops(k, f)) {
        said.insert(said.end(), {mark, l.value});
        said.insert(said.end(), loops[l].begin(), loops[l].end());
      }
    }
    for (const RegionId r : k.regions()) {
      std::vector<Item> items;
      for (const ShellId s : k.shells(r)) {
        for (const FaceUse u : k.face_uses(s)) items.push_back(u);
        for (const EdgeId e : k.wires(s)) items.push_back(e);
        if (k.shell_vertex(s).valid()) items.push_back(k.shell_vertex(s));
      }
      std::sort(items.begin(), items.end());
      auto& said = regions[r];
      said = {k.is_filled(r) ? 1u : 0u};
      for (const Item item : items) said.insert(said.end(), {static_cast<std::uint32_t>(item.kind), item.index});
    }
  }
};

template <class IdType>
Changes<IdType> compare(const Told<IdType>& before, const Told<IdType>& after) {
  Changes<IdType> result;
  for (const auto& [id, said] : before) {
    const auto now = after.find(id);
    if (now == after.end()) {
      result.removed.push_back(id);
    } else if (now->second != said) {
      result.changed.push_back(id);
    }
  }
  for (const auto& [id, said] : after) {
    if (!before.contains(id)) result.made.push_back(id);
  }
  return result;
}

void expect_exact(const Complex& before, const Complex& after, const std::string& where) {
  const Difference d = difference(before, after);
  const Everything a(before), b(after);
  ASSERT_EQ(d.vertices, compare(a.vertices, b.vertices)) << where;
  ASSERT_EQ(d.edges, compare(a.edges, b.edges)) << where;
  ASSERT_EQ(d.coedges, compare(a.coedges, b.coedges)) << where;
  ASSERT_EQ(d.loops, compare(a.loops, b.loops)) << where;
  ASSERT_EQ(d.faces, compare(a.faces, b.faces)) << where;
  ASSERT_EQ(d.regions, compare(a.regions, b.regions)) << where;
}

TEST(Difference, OfOneOperator) {
  Complex k = m_mr();
  const VertexId v = m_sv(k, RegionId(0)).value().vertex;
  const Complex before = k;
  EXPECT_TRUE(difference(before, k).empty());
  ASSERT_TRUE(m_ev(k, v).ok());
  const Difference d = difference(before, k);
  EXPECT_EQ(d.vertices.made, std::vector{VertexId(1)});
  EXPECT_EQ(d.vertices.changed, std::vector{v});
  EXPECT_EQ(d.edges.made, std::vector{EdgeId(0)});
  EXPECT_EQ(d.regions.changed, std::vector{RegionId(0)});
  EXPECT_TRUE(d.faces.empty());
}

TEST(Difference, IsExactAlongRandomOperators) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Complex k = m_mr();
    RandomOperators random(seed);
    const std::string where = "seed " + std::to_string(seed) + ": ";
    std::vector<Applied> history;
    Complex far = k;
    for (int i = 0; i < 120; ++i) {
      const Complex before = k;
      auto applied = random.apply(k);
      expect_exact(before, k, where + random.tried());
      if (applied) history.push_back(std::move(*applied));
      if (i % 10 == 9) {
        expect_exact(far, k, where + "ten operators");
        expect_exact(k, far, where + "ten operators back");
        far = k;
      }
      if (HasFatalFailure()) return;
    }
    const Complex last = k;
    for (; !history.empty(); history.pop_back()) take_back(k, history.back());
    expect_exact(last, k, where + "all taken back");
  }
}

}  // namespace
}  // namespace aresta
