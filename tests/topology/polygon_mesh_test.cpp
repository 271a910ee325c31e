// SPDX-License-Identifier: Apache-2.0
#include "topology/polygon_mesh.h"

#include <gtest/gtest.h>

#include <map>

#include "topology/check.h"

namespace aresta {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(PolygonMesh, EdgesAreNumberedAsTheyOccurAndRunFromTheSmallerVertex) {
  const std::vector<std::uint32_t> corners{3, 1, 2, 0, 2, 1}, begin{0, 4, 6};
  const auto found = edges_of_polygons(4, corners, begin);
  EXPECT_EQ(found.edges, (std::vector<std::array<std::uint32_t, 2>>{{1, 3}, {1, 2}, {0, 2}, {0, 3}}));
  EXPECT_EQ(found.of_corner, (std::vector<std::uint32_t>{0, 1, 2, 3, 1, 1}));
}

/// A vertex of any valence: the tables of short and of long lists must number alike.
TEST(PolygonMesh, EdgesAgreeWithAMapForFansOfEverySize) {
  for (const std::uint32_t n : {1u, 3u, 8u, 9u, 10u, 100u, 5000u}) {
    for (const std::uint32_t stride : {1u, 64u, 4096u}) {
      std::vector<std::uint32_t> corners, begin{0};
      for (std::uint32_t i = 0; i < n; ++i) {
        for (const std::uint32_t v : {0u, 1 + i * stride, 1 + (i + 1) * stride}) corners.push_back(v);
        begin.push_back(static_cast<std::uint32_t>(corners.size()));
      }
      const auto found = edges_of_polygons(2 + n * stride, corners, begin);
      ASSERT_EQ(found.edges.size(), 2 * n + 1);
      std::map<std::array<std::uint32_t, 2>, std::uint32_t> numbers;
      for (std::uint32_t c = 0; c < corners.size(); ++c) {
        const std::uint32_t a = corners[c], b = corners[c % 3 == 2 ? c - 2 : c + 1];
        const auto number = static_cast<std::uint32_t>(numbers.size());
        const auto place = numbers.try_emplace({std::min(a, b), std::max(a, b)}, number).first;
        ASSERT_EQ(found.of_corner[c], place->second) << "n " << n << ", stride " << stride << ", corner " << c;
      }
    }
  }
}

TEST(PolygonMesh, TetrahedronBecomesASoundComplexOfTwoRegions) {
  auto in = incidence_of_triangles(5, Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  ASSERT_TRUE(in.ok());
  enclose_one_region(*in);
  const auto k = assemble(*in);
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  EXPECT_TRUE(check_structure(*k).empty());
  EXPECT_EQ(k->edge_count(), 6u);
  EXPECT_EQ(k->shell_count(), 3u);  // the outside, the inside, and the vertex that no triangle has
  EXPECT_TRUE(k->isolated_in_shell(VertexId(4)).valid());
  for (const EdgeId e : k->edges()) EXPECT_EQ(k->use_kind(e), EdgeUseKind::manifold);
}

/// Tetrahedra that touch in a vertex have one shell outside and one inside: there vertices do join. (That the inside is
/// one region is for the checker to refuse.)
TEST(PolygonMesh, TwoTetrahedraThatTouchInAVertexShareTheirShells) {
  for (const bool touch : {true, false}) {
    Triangles triangles;
    for (const std::uint32_t first : {0u, touch ? 3u : 4u}) {
      for (const auto& t : Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
        triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    auto in = incidence_of_triangles(touch ? 7 : 8, triangles);
    ASSERT_TRUE(in.ok());
    enclose_one_region(*in);
    const auto k = assemble(*in);
    ASSERT_TRUE(k.ok()) << k.error().to_line();
    EXPECT_EQ(k->shell_count(), touch ? 2u : 4u);
  }
}

TEST(PolygonMesh, ThreeTrianglesAtAnEdgeMakeOneRadialCycle) {
  const auto in = incidence_of_triangles(5, Triangles{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
  ASSERT_TRUE(in.ok());
  EXPECT_EQ(in->radial_next[0], 3u);
  EXPECT_EQ(in->radial_next[3], 6u);
  EXPECT_EQ(in->radial_next[6], 0u);
  EXPECT_EQ(in->radial_next[1], 1u);
}

TEST(PolygonMesh, WhatIsNoMeshIsRefused) {
  EXPECT_EQ(incidence_of_triangles(2, Triangles{{0, 1, 2}}).error().code, errors::bad_incidence);
  const std::vector<std::uint32_t> corners{0, 1, 2}, gap{0, 0, 3}, not_all{0, 2};
  EXPECT_EQ(incidence_of_polygons(3, corners, gap).error().code, errors::bad_incidence);
  EXPECT_EQ(incidence_of_polygons(3, corners, not_all).error().code, errors::bad_incidence);
  auto open = incidence_of_triangles(3, Triangles{{0, 1, 2}});
  enclose_one_region(*open);
  EXPECT_EQ(assemble(*open).error().code, errors::bad_incidence);
}

}  // namespace
}  // namespace aresta
