// SPDX-License-Identifier: Apache-2.0
// Lineage: by operator as a table, and against what lives before and after random operators.
#include "topology/lineage.h"

#include <gtest/gtest.h>

#include <set>

#include "random_operators.h"
#include "topology/notation.h"

namespace aresta {
namespace {

std::string text(const std::vector<LineageEvent>& events) {
  std::string all;
  for (const LineageEvent& e : events) all += (all.empty() ? "" : ", ") + describe(e);
  return all;
}

EntityRef at(EntityKind kind, std::uint32_t index) {
  return {kind, index};
}

using Kind = LineageEvent::Kind;

TEST(Lineage, EntitiesMadeAndKilledByOneOperatorDoNotAppear) {
  const EntityRef r0 = at(EntityKind::region, 0), r1 = at(EntityKind::region, 1), r2 = at(EntityKind::region, 2);
  struct Case {
    std::vector<LineageEvent> events;
    std::string net;
  };
  const Case cases[] = {
      {{{Kind::made, r1, {}}, {Kind::killed, r1, {}}}, ""},
      {{{Kind::split, r0, r1}, {Kind::killed, r1, {}}}, ""},
      {{{Kind::split, r0, r1}, {Kind::merged, r1, r0}}, ""},
      // A piece of a piece is a piece of the whole.
      {{{Kind::split, r0, r1}, {Kind::split, r1, r2}, {Kind::killed, r1, {}}}, "split region 0 -> region 2"},
      {{{Kind::made, r1, {}}, {Kind::split, r1, r2}, {Kind::killed, r1, {}}}, "made region 2"},
      // What went into something that died became what that became.
      {{{Kind::made, r2, {}}, {Kind::merged, r1, r2}, {Kind::killed, r2, {}}}, "killed region 1"},
      {{{Kind::made, r2, {}}, {Kind::merged, r1, r2}, {Kind::merged, r2, r0}}, "merged region 1 -> region 0"},
      {{{Kind::merged, r1, r2}, {Kind::killed, r2, {}}}, "killed region 1, killed region 2"},
      // An id used again is another entity.
      {{{Kind::killed, r1, {}}, {Kind::made, r1, {}}}, "killed region 1, made region 1"},
      {{{Kind::killed, r1, {}}, {Kind::split, r0, r1}, {Kind::merged, r1, r0}}, "killed region 1"},
  };
  for (const Case& c : cases) EXPECT_EQ(text(net_effect(c.events)), c.net) << text(c.events);
}

TEST(Lineage, OfEachOperator) {
  Complex k = m_mr();
  const auto expect = [&](Result<Applied> applied, const std::string& done, const std::string& undone) {
    ASSERT_TRUE(applied.ok()) << applied.error().message;
    EXPECT_EQ(text(lineage(*applied)), done) << applied->name;
    EXPECT_EQ(text(lineage_of_take_back(*applied)), undone) << applied->name;
  };
  expect(m_sv(k, RegionId(0)), "made vertex 0", "killed vertex 0");
  expect(m_ev(k, VertexId(0)), "made vertex 1, made edge 0", "killed edge 0, killed vertex 1");
  expect(m_ev(k, VertexId(1)), "made vertex 2, made edge 1", "killed edge 1, killed vertex 2");
  expect(m_e(k, VertexId(2), VertexId(0)), "made edge 2", "killed edge 2");
  FaceSpec spec;
  spec.circuits = {{{{EdgeId(0), false, {}}, {EdgeId(1), false, {}}, {EdgeId(2), false, {}}}, {}}};
  expect(m_f(k, spec), "made face 0", "killed face 0");
  expect(esplit(k, EdgeId(1)), "split edge 1 -> edge 3, made vertex 3", "killed vertex 3, merged edge 3 -> edge 1");
  // Across the face from the new vertex to vertex 0.
  CoedgeId from, to;
  for (const CoedgeId c : k.coedges()) {
    if (k.start(c) == VertexId(3)) from = c;
    if (k.start(c) == VertexId(0)) to = c;
  }
  expect(mm_e(k, {from, {}}, {to, {}}), "made edge 4, split face 0 -> face 1",
         "merged face 1 -> face 0, killed edge 4");
  expect(k_e(k, EdgeId(4)), "merged face 1 -> face 0, killed edge 4", "made edge 4, split face 0 -> face 1");
  expect(esqueeze(k, EdgeId(3), VertexId(3)), "killed edge 3, merged vertex 2 -> vertex 3",
         "split vertex 3 -> vertex 2, made edge 3");
  // A second face on the same edges closes a region off; gluing the two undoes it.
  FaceSpec back;
  back.circuits = {{{{EdgeId(0), false, {}}, {EdgeId(1), false, {}}, {EdgeId(2), false, {}}}, {}}};
  back.region = RegionId(0);
  for (EdgeUseSpec& use : back.circuits[0].uses) use.after = k.first_coedge(use.edge);
  const auto second = m_f(k, back);
  ASSERT_TRUE(second.ok());
  const FaceId f = second->face;
  const RegionId r = second->region;
  ASSERT_TRUE(r.valid());
  const std::string fs = "face " + std::to_string(f.value), rs = "region " + std::to_string(r.value);
  EXPECT_EQ(text(lineage(*second)), "made " + fs + ", split region 0 -> " + rs);
  EXPECT_EQ(text(lineage_of_take_back(*second)), "merged " + rs + " -> region 0, killed " + fs);
  const int side_0 = k.region(FaceUse(FaceId(0), 0)) == r ? 0 : 1, side_f = k.region(FaceUse(f, 0)) == r ? 0 : 1;
  const CoedgeId c = *k.coedges(*k.loops(FaceId(0)).begin()).begin();
  CoedgeId d;
  for (const CoedgeId x : k.coedges(k.edge(c))) {
    if (k.face(x) == f) d = x;
  }
  const std::pair<CoedgeId, CoedgeId> pairs[] = {{c, d}};
  expect(g_f(k, FaceUse(FaceId(0), side_0), FaceUse(f, side_f), pairs),
         "killed " + rs + ", merged " + fs + " -> face 0", "split face 0 -> " + fs + ", made " + rs);
}

std::set<EntityRef> live(const Complex& k) {
  std::set<EntityRef> all;
  for (const VertexId v : k.vertices()) all.insert(v);
  for (const EdgeId e : k.edges()) all.insert(e);
  for (const FaceId f : k.faces()) all.insert(f);
  for (const RegionId r : k.regions()) all.insert(r);
  return all;
}

/// Makes and kills what the events say; each may only name what lives then.
void follow(std::set<EntityRef>& all, const std::vector<LineageEvent>& events) {
  for (const LineageEvent& e : events) {
    const bool is_new = e.kind == Kind::made || e.kind == Kind::split;
    const EntityRef subject = e.kind == Kind::split ? e.other : e.entity;
    if (e.kind == Kind::split) {
      ASSERT_TRUE(all.contains(e.entity)) << text(events);
      ASSERT_EQ(e.entity.kind, e.other.kind);
    }
    if (e.kind == Kind::merged) {
      ASSERT_TRUE(all.contains(e.other)) << text(events);
      ASSERT_EQ(e.entity.kind, e.other.kind);
    }
    if (is_new) {
      ASSERT_TRUE(all.insert(subject).second) << text(events);
    } else {
      ASSERT_EQ(all.erase(subject), 1u) << text(events);
    }
  }
}

TEST(Lineage, SaysWhatLivesAfterRandomOperators) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Complex k = m_mr();
    RandomOperators random(seed);
    std::set<EntityRef> all = live(k);
    std::vector<Applied> history;
    for (int i = 0; i < 120; ++i) {
      auto applied = random.apply(k);
      if (!applied) continue;
      follow(all, lineage(*applied));
      ASSERT_EQ(all, live(k)) << "seed " << seed << ": " << random.tried() << ": " << text(lineage(*applied));
      history.push_back(std::move(*applied));
    }
    for (; !history.empty(); history.pop_back()) {
      take_back(k, history.back());
      follow(all, lineage_of_take_back(history.back()));
      ASSERT_EQ(all, live(k)) << "seed " << seed << ": " << history.back().name;
    }
  }
}

}  // namespace
}  // namespace aresta
