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

TEST(Snapshot, AnOperatorOnALargeComplexCopiesOnlyThePagesItTouches) {
  Sketch sketch;
  add_polyhedron(sketch, torus(100), {Sketch::outside, sketch.add_region()});
  Complex k = sketch.complex();
  ASSERT_EQ(k.face_count(), 10000u);
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
    EXPECT_EQ(d.vertices.changed.size(), 2u);
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
