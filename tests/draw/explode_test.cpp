// SPDX-License-Identifier: Apache-2.0
// Regions moved apart: beside one another, and out of one another.
#include "draw/explode.h"

#include <gtest/gtest.h>

#include "draw/scenes.h"

namespace aresta::draw {
namespace {

TEST(Explode, ASharedFaceIsThereTwice) {
  // Two regions that share the face x = 0.
  Scene scene;
  test::add_block(scene, {-2, 0, 0}, {0, 1, 1});
  test::add_block(scene, {0, 0, 0}, {2, 1, 1});
  // Make the two coinciding faces one: the second block's x- face goes, the first one's x+ face gets both regions.
  const FaceId shared = scene.faces[1].face;
  scene.faces[1].regions = {RegionId(1), RegionId(0)};
  scene.faces.erase(scene.faces.begin() + 6);
  ASSERT_EQ(scene.faces.size(), 11u);
  const Scene apart = exploded(scene, 1);
  ASSERT_EQ(apart.faces.size(), 12u);
  int copies = 0;
  for (const FacePatch& f : apart.faces) {
    if (f.face != shared) continue;
    // Centres of the regions are at -1 and 1 and move by as much.
    EXPECT_DOUBLE_EQ(f.points[0].x, f.regions[0].valid() ? 1 : -1);
    ++copies;
  }
  EXPECT_EQ(copies, 2);
  EXPECT_EQ(exploded(scene, 0).faces.size(), 11u);
  EXPECT_DOUBLE_EQ(apart.bounds().low.x, -3);
  EXPECT_DOUBLE_EQ(apart.bounds().high.x, 3);
}

TEST(Explode, NestedRegionsComeOutInOrderOfSize) {
  // A block in a block in a block, the middle one named first, and a free one beside them.
  Scene scene;
  const RegionId middle = test::add_block(scene, {-2, -2, -3}, {2, 2, 3});
  const RegionId inner = test::add_block(scene, {-1, -1, -3}, {1, 1, 3});
  const RegionId outer = test::add_block(scene, {-3, -3, -3}, {3, 3, 3});
  const RegionId beside = test::add_block(scene, {7, -3, -3}, {13, 3, 3});
  const auto ways = ways_apart(scene);
  // The scene's centre is (5, 0, 0).
  EXPECT_EQ(ways.at(outer), Vec3(-5, 0, 0));
  EXPECT_EQ(ways.at(beside), Vec3(5, 0, 0));
  EXPECT_DOUBLE_EQ(ways.at(middle).x, -5);
  EXPECT_DOUBLE_EQ(ways.at(inner).x, -5);
  EXPECT_NEAR(ways.at(middle).z, 6.6, 1e-12);
  EXPECT_NEAR(ways.at(inner).z, 13.2, 1e-12);
  Box3 box;
  for (const FacePatch& f : exploded(scene, 1).faces) {
    if (f.regions[1] != inner) continue;
    for (const Vec3 p : f.points) box.add(p);
  }
  EXPECT_NEAR(box.low.z, 10.2, 1e-12);
}

TEST(Explode, WhatIsAboveANestGoesUpAsFar) {
  // A plate with a pin through it: the part of the pin that is in the plate goes up, and the part above with it.
  Scene scene;
  test::add_block(scene, {-5, -5, -1}, {5, 5, 1});
  const RegionId within = test::add_block(scene, {-1, -1, -1}, {1, 1, 1});
  const RegionId above = test::add_block(scene, {-1, -1, 1}, {1, 1, 3});
  const RegionId below = test::add_block(scene, {-1, -1, -3}, {1, 1, -1});
  const auto ways = ways_apart(scene);
  EXPECT_NEAR(ways.at(within).z, 2.2, 1e-12);
  EXPECT_NEAR(ways.at(above).z, 2 + 2.2, 1e-12);
  EXPECT_NEAR(ways.at(below).z, -2, 1e-12);
}

TEST(Explode, CentresAsGoodAsOneAreOne) {
  // Off by a hundredth of its size the inner block is still inside after any move between centres.
  Scene scene;
  const RegionId outer = test::add_block(scene, {-2, -2, -2}, {2, 2, 2});
  const RegionId inner = test::add_block(scene, {-1, -1, -0.97}, {1, 1, 1.03});
  const auto ways = ways_apart(scene);
  EXPECT_EQ(ways.at(outer), Vec3(0, 0, 0));
  EXPECT_NEAR(ways.at(inner).z, 0.03 + 2.2 + 1.1, 1e-12);
}

TEST(Explode, NeighboursInALatticeAreNoNest) {
  Scene scene;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) test::add_block(scene, {double(i), double(j), 0}, {i + 1.0, j + 1.0, 1});
  }
  for (const auto& [region, way] : ways_apart(scene)) EXPECT_DOUBLE_EQ(way.z, 0) << region.value;
}

}  // namespace
}  // namespace aresta::draw
