// SPDX-License-Identifier: Apache-2.0
#include "topology/dump.h"

#include <gtest/gtest.h>

#include "topology/assemble.h"

namespace aresta {
namespace {

constexpr std::uint32_t none = Incidence::none;

/// A triangle in the infinite region, with a point inside it, a wire at its first corner and a point apart.
Incidence triangle() {
  Incidence in;
  in.vertex_count = 6;
  in.edges = {{0, 1}, {2, 1}, {2, 0}, {0, 4}};
  in.add_coedge(0, false);
  in.add_coedge(1, true);
  in.add_coedge(2, false);
  in.close_loop();
  in.add_vertex_loop(3);
  in.close_face();
  in.radial_next = {0, 1, 2};
  in.region_filled = {false};
  in.face_use_region = {0, 0};
  in.edge_region = {none, none, none, 0};
  in.vertex_region = {none, none, none, none, none, 0};
  return in;
}

TEST(Dump, SaysAll) {
  const auto k = assemble(triangle());
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  EXPECT_EQ(dump(*k), R"(aresta complex 1
# regions 1, shells 2, faces 1, loops 2, edges 4, vertices 6
region r0: infinite
  shell +f0 -f0 e3
  shell v5
face f0: front r0, back r0
  loop l0
    coedge c0: +e0, v0 to v1, radial c0
    coedge c1: -e1, v1 to v2, radial c1
    coedge c2: +e2, v2 to v0, radial c2
  loop l1: v3
edge e0: v0 to v1, radial c0
edge e1: v2 to v1, radial c1
edge e2: v2 to v0, radial c2
edge e3: v0 to v4, wire in r0
vertex v0: +e0 -e2 +e3
vertex v1: -e0 -e1
vertex v2: +e1 +e2
vertex v3: l1
vertex v4: -e3
vertex v5: in r0
)");
}

TEST(Dump, OfNothingIsTheInfiniteRegion) {
  EXPECT_EQ(dump(Complex()),
            "aresta complex 1\n"
            "# regions 1, shells 0, faces 0, loops 0, edges 0, vertices 0\n"
            "region r0: infinite\n");
}

}  // namespace
}  // namespace aresta
