// SPDX-License-Identifier: Apache-2.0
// A copy of a complex is a snapshot: it shares all pages, and a change afterwards copies those it touches.
#include <gtest/gtest.h>

#include "random_operators.h"
#include "sketch.h"
#include "topology/difference.h"
#include "topology/dump.h"

namespace aresta {
namespace {

TEST(Snapshot, RestoringIsAssignment) {
  Complex k = m_mr();
  RandomOperators random(3);
  std::vector<Complex> states;
  std::vector<std::string> dumps;
  for (int i = 0; i < 200; ++i) {
    states.push_back(k);
    dumps.push_back(dump(k));
    ASSERT_EQ(k.bytes_not_shared_with(states.back()), 0u);
    random.apply(k);
  }
  for (std::size_t i = 0; i < states.size(); ++i) ASSERT_EQ(dump(states[i]), dumps[i]) << i;
  k = states[100];
  for (int i = 0; i < 100; ++i) random.apply(k);
  EXPECT_EQ(dump(states[100]), dumps[100]);
  EXPECT_EQ(dump(states[199]), dumps[199]);
}

TEST(Snapshot, ShellsMergeWhileACopyIsHeld) {
  // Two faces apart; gluing a vertex of each joins their shells, whose rows a copy shares.
  Sketch sketch;
  sketch.add_polygon({0, 1, 2}, {Sketch::outside, Sketch::outside});
  sketch.add_polygon({3, 4, 5}, {Sketch::outside, Sketch::outside});
  Complex k = sketch.complex();
  const Complex before = k;
  const std::string text = dump(k);
  ASSERT_TRUE(g_v(k, VertexId(0), VertexId(3)).ok());
  EXPECT_EQ(k.shell_count(), 1u);
  EXPECT_EQ(dump(before), text);
}

TEST(Snapshot, AnOperatorOnALargeComplexCopiesOnlyThePagesItTouches) {
  Sketch sketch;
  add_polyhedron(sketch, torus(30), {Sketch::outside, sketch.add_region()});
  Complex k = sketch.complex();
  // Faces across faces, and struts in them.
  for (int round = 0; round < 4; ++round) {
    for (std::uint32_t i = 0, n = static_cast<std::uint32_t>(k.face_bound()); i < n; ++i) {
      const CoedgeId c = k.first_coedge(k.first_loop(FaceId(i)));
      ASSERT_TRUE(mm_e(k, {c, {}}, {k.next(k.next(c)), {}}).ok());
      ASSERT_TRUE(mm_ev(k, {c, {}}).ok());
    }
  }
  ASSERT_EQ(k.face_count(), 14400u);
  const std::size_t all = k.allocated_bytes();
  // Of 1024 rows each: a vertex 8, an edge 28, a coedge 20, a loop 16, a face 28 bytes.
  const std::size_t one_page_each = 1024 * (8 + 28 + 20 + 16 + 28);
  const FaceId f(5000);
  const auto corners = [&] {
    std::vector<CoedgeId> c;
    for (const CoedgeId x : k.coedges(k.first_loop(f))) c.push_back(x);
    return c;
  };
  {
    const Complex before = k;
    EXPECT_EQ(k.bytes_not_shared_with(before), 0u);
    const auto c = corners();
    ASSERT_TRUE(mm_e(k, {c[0], {}}, {c[2], {}}).ok());
    const std::size_t bytes = k.bytes_not_shared_with(before);
    std::printf("MM_E copied %zu of %zu bytes\n", bytes, all);
    EXPECT_LE(bytes, 4 * one_page_each);
    const Difference d = difference(before, k);
    EXPECT_EQ(d.faces.made.size(), 1u);
    EXPECT_EQ(d.faces.changed, std::vector{f});
    EXPECT_EQ(d.vertices.changed.size(), k.start(c[0]) == k.start(c[2]) ? 1u : 2u);
    EXPECT_EQ(d.regions.changed.size(), 2u);
  }
  {
    const Complex before = k;
    ASSERT_TRUE(esplit(k, k.edge(corners()[0])).ok());
    const std::size_t bytes = k.bytes_not_shared_with(before);
    std::printf("ESPLIT copied %zu of %zu bytes\n", bytes, all);
    EXPECT_LE(bytes, 4 * one_page_each);
  }
}

}  // namespace
}  // namespace aresta
