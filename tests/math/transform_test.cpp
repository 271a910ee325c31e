// SPDX-License-Identifier: Apache-2.0
#include "math/transform.h"

#include <gtest/gtest.h>

namespace aresta {
namespace {

TEST(Transform, QuarterTurnIsExact) {
  const Transform t = Transform::rotation(90, {0, 0, 1});
  EXPECT_EQ(t.point({1, 0, 0}), (Vec3{0, 1, 0}));
}

TEST(Transform, RotationAboutALineFixesTheLine) {
  const Transform t = Transform::rotation(37, {1, 2, 3}, {4, 5, 6});
  const Vec3 on_axis{5, 7, 9};
  EXPECT_LT(distance(t.point(on_axis), on_axis), 1e-14);
  EXPECT_TRUE(t.is_rigid());
}

TEST(Transform, ReflectionIsASimilarityButNotRigid) {
  const Transform t = Transform::reflection({0, 0, 4}, {0, 0, 1});
  EXPECT_EQ(t.point({1, 2, 3}), (Vec3{1, 2, 5}));
  EXPECT_TRUE(t.is_similarity());
  EXPECT_FALSE(t.is_rigid());
}

TEST(Transform, ShearIsNotASimilarity) {
  EXPECT_FALSE(Transform::from_rows({1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}).is_similarity());
}

TEST(Frame, WorldAndLocalAreInverse) {
  const Frame f = Frame::along({1, 2, 3}, {1, 1, 1});
  EXPECT_TRUE(f.right_handed());
  EXPECT_LT(distance(f.to_world(f.to_local({7, 8, 9})), {7, 8, 9}), 1e-14);
}

}  // namespace
}  // namespace aresta
