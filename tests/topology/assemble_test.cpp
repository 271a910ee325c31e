// SPDX-License-Identifier: Apache-2.0
#include "topology/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "topology/dump.h"

namespace aresta {
namespace {

constexpr std::uint32_t none = Incidence::none;

std::uint32_t edge_between(Incidence& in, std::uint32_t a, std::uint32_t b) {
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (in.edges[e] == std::array{a, b} || in.edges[e] == std::array{b, a}) return e;
  }
  in.edges.push_back({a, b});
  return in.edge_count() - 1;
}

void add_polygon(Incidence& in, const std::vector<std::uint32_t>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint32_t a = vertices[i], b = vertices[(i + 1) % vertices.size()];
    const std::uint32_t e = edge_between(in, a, b);
    in.add_coedge(e, in.edges[e][0] != a);
  }
  in.close_loop();
  in.close_face();
}

/// A cube whose faces look outward; front sides in region 0, back sides in region 1.
Incidence cube() {
  Incidence in;
  in.vertex_count = 8;  // bit 0: x, bit 1: y, bit 2: z
  for (const auto& face :
       {std::vector<std::uint32_t>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    add_polygon(in, face);
  }
  in.radial_next.assign(in.coedges.size(), none);
  for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
    for (std::uint32_t d = 0; d < in.coedges.size(); ++d) {
      if (c != d && in.coedges[c] / 2 == in.coedges[d] / 2) in.radial_next[c] = d;
    }
  }
  in.region_count = 2;
  in.region_filled = {false, true};
  for (std::uint32_t f = 0; f < 6; ++f) {
    in.face_use_region.push_back(0);
    in.face_use_region.push_back(1);
  }
  in.edge_region.assign(in.edge_count(), none);
  in.vertex_region.assign(in.vertex_count, none);
  return in;
}

TEST(Assemble, CubeHasTwoShellsAndEveryTraversalAgrees) {
  const auto result = assemble(cube());
  ASSERT_TRUE(result.ok()) << result.error().to_line();
  const Complex& k = *result;
  EXPECT_EQ(k.vertex_count(), 8u);
  EXPECT_EQ(k.edge_count(), 12u);
  EXPECT_EQ(k.face_count(), 6u);
  EXPECT_EQ(k.shell_count(), 2u);
  for (const VertexId v : k.vertices()) EXPECT_EQ(k.edge_ends(v).count(), 3u);
  for (const EdgeId e : k.edges()) {
    EXPECT_EQ(k.use_kind(e), EdgeUseKind::manifold);
    for (const CoedgeId c : k.coedges(e)) EXPECT_EQ(k.edge(c), e);
  }
  for (const FaceId f : k.faces()) {
    EXPECT_EQ(k.region(FaceUse(f, 1)), RegionId(1));
    for (const LoopId l : k.loops(f)) EXPECT_EQ(k.coedges(l).count(), 4u);
  }
  for (const RegionId r : k.regions()) {
    std::size_t uses = 0;
    for (const ShellId s : k.shells(r)) uses += k.face_uses(s).count();
    EXPECT_EQ(uses, 6u);
  }
}

TEST(Assemble, ArraysOfWhatDoesNotOccurMayBeEmpty) {
  Incidence in = cube();
  const auto full = assemble(in);
  in.loop_vertex.clear();
  in.edge_region.clear();
  in.vertex_region.clear();
  const auto k = assemble(in);
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  EXPECT_EQ(dump(*k), dump(*full));
  in.edges.push_back({0, 7});  // a wire without a region
  EXPECT_FALSE(assemble(in).ok());
  in.edges.pop_back();
  ++in.vertex_count;  // an isolated vertex without one
  EXPECT_FALSE(assemble(in).ok());
  --in.vertex_count;
  in.loop_vertex.assign(2, none);
  EXPECT_FALSE(assemble(in).ok());
}

TEST(Assemble, SideComponentsOfACubeAreInsideAndOutside) {
  const auto component = side_components(cube());
  for (std::uint32_t u = 0; u < component.size(); ++u) EXPECT_EQ(component[u], u % 2);
}

TEST(Assemble, WireAndPointAreShellsOfTheirRegion) {
  Incidence in = cube();
  in.vertex_count += 3;  // a wire from corner 0 to 8 inside, then 9 alone inside, 10 alone outside
  in.edges.push_back({0, 8});
  in.edge_region.push_back(1);
  in.vertex_region.insert(in.vertex_region.end(), {none, 1, 0});
  const auto result = assemble(in);
  ASSERT_TRUE(result.ok()) << result.error().to_line();
  const Complex& k = *result;
  EXPECT_EQ(k.shell_count(), 4u);  // the wire hangs on the cube's inner shell
  EXPECT_TRUE(k.is_wire(EdgeId(12)));
  EXPECT_EQ(k.wire_shell(EdgeId(12)), k.shell(FaceUse(FaceId(0), 1)));
  EXPECT_EQ(k.region(k.isolated_in_shell(VertexId(9))), RegionId(1));
  EXPECT_EQ(k.region(k.isolated_in_shell(VertexId(10))), RegionId(0));
  EXPECT_EQ(k.edge_ends(VertexId(0)).count(), 4u);
}

TEST(Assemble, VertexInsideTwoFacesIsALoopOfBoth) {
  Incidence in = cube();
  in.vertex_count += 1;
  in.vertex_region.push_back(none);
  Incidence with_points = in;
  with_points.loop_begin = {0};
  with_points.loop_vertex.clear();
  with_points.face_begin = {0};
  for (std::uint32_t f = 0; f < 6; ++f) {
    with_points.loop_begin.push_back(4 * (f + 1));
    with_points.loop_vertex.push_back(none);
    if (f < 2) with_points.add_vertex_loop(8), with_points.loop_begin.back() = 4 * (f + 1);
    with_points.close_face();
  }
  const auto result = assemble(with_points);
  ASSERT_TRUE(result.ok()) << result.error().to_line();
  EXPECT_EQ(result->vertex_loops(VertexId(8)).size(), 2u);
  EXPECT_EQ(result->loops(FaceId(0)).count(), 2u);
}

TEST(Assemble, RefusesBrokenIncidence) {
  struct Case {
    const char* what;
    void (*spoil)(Incidence&);
  };
  const Case cases[] = {
      {"open loop", [](Incidence& in) { in.coedges[0] ^= 1u; }},
      {"unknown vertex", [](Incidence& in) { in.edges[0][0] = 99; }},
      {"unknown edge", [](Incidence& in) { in.coedges[3] = 99; }},
      {"radial cycle too short", [](Incidence& in) { in.radial_next[0] = 0; }},
      {"one sector in two regions", [](Incidence& in) { in.face_use_region[0] = 1; }},
      {"side without region", [](Incidence& in) { in.face_use_region[0] = 7; }},
      {"edge of a face with a region", [](Incidence& in) { in.edge_region[0] = 0; }},
      {"isolated vertex without region",
       [](Incidence& in) {
         ++in.vertex_count;
         in.vertex_region.push_back(none);
       }},
      {"face without loop", [](Incidence& in) { in.face_begin.push_back(in.face_begin.back()); }},
  };
  for (const Case& c : cases) {
    Incidence in = cube();
    c.spoil(in);
    const auto result = assemble(in);
    ASSERT_FALSE(result.ok()) << c.what;
    EXPECT_EQ(result.error().code, errors::bad_incidence) << c.what;
  }
}

}  // namespace
}  // namespace aresta
