// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "audit.h"
#include "construct/move.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "construct/sweep.h"
#include "model/measure.h"
#include "motions.h"

namespace aresta {
namespace {

constexpr double pi = std::numbers::pi;

Result<Model> face(const std::vector<Model>& wires) {
  std::vector<const Model*> pointers;
  for (const Model& w : wires) pointers.push_back(&w);
  return planar_face(pointers);
}

/// A stadium: half discs of radius 1 about (0, 0) and (4, 0), joined; with a round hole.
std::vector<Model> stadium() {
  return {*line({0, -1, 0}, {4, -1, 0}), *arc_through({4, 1, 0}, {5, 0, 0}, {4, -1, 0}), *line({4, 1, 0}, {0, 1, 0}),
          *arc_through({0, 1, 0}, {-1, 0, 0}, {0, -1, 0}), *circle(0.5)};
}

TEST(PlanarFace, JoinsLinesAndArcsInAnyDirection) {
  const auto m = face(stadium());
  ASSERT_BUILT(m);
  EXPECT_EQ(counts(*m), (Counts{5, 5, 1, 0}));
  EXPECT_EQ(m->topology().loop_count(), 2u);
  EXPECT_NEAR(total_area(*m).value(), 8 + pi - pi / 4, 1e-10);
  EXPECT_NEAR(norm(m->normal(FaceId(0), {0, 0}) - Vec3{0, 0, 1}), 0, 1e-14);
  EXPECT_TRUE(loops_enclose(*m));
}

TEST(PlanarFace, SweepsToSolidsWithRoundSides) {
  Motions motions(5);
  const Model flat = *face(stadium());
  for (int i = 0; i < 3; ++i) {
    const Transform map = motions.rigid();
    const auto profile = std::make_shared<const Model>(*transform(flat, map));
    const auto slot = extrude(profile, 3 * map.vector({0, 0, 1}));
    ASSERT_BUILT(slot);
    EXPECT_EQ(counts(*slot), (Counts{10, 15, 7, 1}));
    EXPECT_NEAR(total_volume(*slot).value(), 3 * (8 + pi - pi / 4), 1e-8);
    EXPECT_TRUE(looks_outward(*slot));
    for (const FaceId f : slot->topology().faces()) EXPECT_STRNE(slot->surface(f).kind(), "extrusion");
    // About the line x = -3: Pappus with the centroid at 2 (stadium) and 0 (hole).
    const auto ring = revolve(profile, -90, map.point({-3, 0, 0}), map.vector({0, 1, 0}));
    ASSERT_BUILT(ring);
    EXPECT_NEAR(total_volume(*ring).value(), pi / 2 * ((8 + pi) * 5 - pi / 4 * 3), 1e-7);
    EXPECT_LT(largest_gap(*ring), 1e-12);
    EXPECT_TRUE(looks_outward(*ring));
  }
}

TEST(PlanarFace, SplineOutline) {
  const auto m = face({*spline(std::vector<Vec3>{{1, 0, 2}, {0, 1, 2}, {-1, 0, 2}, {0, -1, 2}}, true)});
  ASSERT_BUILT(m);
  EXPECT_EQ(counts(*m), (Counts{1, 1, 1, 0}));
  EXPECT_NEAR(total_area(*m).value(), pi, 0.1);
  const auto rod = extrude(std::make_shared<const Model>(*m), {0, 1, 1});
  ASSERT_BUILT(rod);
  EXPECT_NEAR(total_volume(*rod).value(), total_area(*m).value(), 1e-8);
}

TEST(PlanarFace, WrongOutlinesAreNamed) {
  expect_error(face({*line({0, 0, 0}, {1, 0, 0}), *line({1, 0, 0}, {1, 1, 0})}), errors::not_closed, "1 edge ends");
  expect_error(face({*circle(1), *line({1, 0, 0}, {2, 0, 0})}), errors::not_closed, "3 edges end");
  expect_error(face({*polyline(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, true)}),
               errors::not_planar, "do not lie in one plane");
  expect_error(face({*circle(1), *circle(0.2, {{3, 0, 0}})}), errors::bad_profile, "lies outside");
  expect_error(face({*block(1, 1, 1)}), errors::bad_size, "made of edges only");
  expect_error(face({}), errors::bad_size, "wires must be a list");
}

}  // namespace
}  // namespace aresta
