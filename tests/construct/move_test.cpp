// SPDX-License-Identifier: Apache-2.0
#include "construct/move.h"

#include <numbers>

#include "audit.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "model/measure.h"
#include "motions.h"

namespace aresta {
namespace {

TEST(Transform, KeepsIdsLabelsGroupsAndProvenance) {
  Model m = *cylinder(1, 2, {}, {3, 0});
  m.labels.set_name(FaceId(1), "first side");
  m.labels.groups.push_back({"ends", {FaceId(0), FaceId(4)}});
  auto provenance = std::make_shared<Provenance>();
  provenance->parents[FaceId(0)] = {{0, FaceId(9)}};
  m.provenance = provenance;
  Motions motions(3);
  for (const Transform& map : {motions.rigid(), motions.mirrored(), Transform::scaling(2)}) {
    const auto moved = transform(m, map);
    ASSERT_BUILT(moved);
    EXPECT_EQ(counts(*moved), counts(m));
    EXPECT_EQ(moved->labels.name(FaceId(1)), "first side");
    ASSERT_EQ(moved->labels.groups.size(), 1u);
    EXPECT_EQ(moved->labels.groups[0].entities, m.labels.groups[0].entities);
    EXPECT_EQ(moved->provenance, m.provenance);
    for (const VertexId v : m.topology().vertices())
      EXPECT_NEAR(distance(moved->point(v), map.point(m.point(v))), 0, 1e-14 * 50);
    for (const EdgeId e : m.topology().edges()) {
      EXPECT_EQ(moved->topology().start(e), m.topology().start(e));
      const double middle = m.range(e).middle(), there = moved->range(e).middle();
      EXPECT_NEAR(distance(moved->edge_point(e, there), map.point(m.edge_point(e, middle))), 0, 1e-13 * 50);
    }
  }
}

TEST(Transform, MirrorTwiceIsTheModelItself) {
  const Model m = *torus(3, 1, {{1, 2, 3}, {1, 1, 0}}, {2, 30});
  const auto once = mirror(m, {1, 0, 0}, {0, 0, 1});
  const auto twice = mirror(*once, {1, 0, 0}, {0, 0, 1});
  ASSERT_BUILT(twice);
  for (const FaceId f : m.topology().faces()) EXPECT_EQ(twice->is_reversed(f), m.is_reversed(f));
  for (const CoedgeId c : m.topology().coedges()) {
    EXPECT_EQ(twice->topology().edge(c), m.topology().edge(c));
    EXPECT_EQ(twice->topology().reversed(c), m.topology().reversed(c));
  }
  for (const VertexId v : m.topology().vertices()) EXPECT_NEAR(distance(twice->point(v), m.point(v)), 0, 1e-14);
  EXPECT_TRUE(looks_outward(*once));
  EXPECT_NEAR(total_volume(*once).value(), 6 * std::numbers::pi * std::numbers::pi, 1e-8);
}

TEST(Transform, PlaneModelsTakeAnyRegularMap) {
  const Model m = *prism(6, 1, 1);
  const Transform shear = Transform::from_rows({1, 2, 0, 5, 0, 3, 1, 0, 0, 0, -1, 0});  // determinant -3
  const auto moved = transform(m, shear);
  ASSERT_BUILT(moved);
  EXPECT_NEAR(total_volume(*moved).value(), 3 * total_volume(m).value(), 1e-12);
  EXPECT_TRUE(looks_outward(*moved));
  EXPECT_TRUE(loops_enclose(*moved));
  EXPECT_LT(largest_gap(*moved), 1e-13);
}

TEST(Transform, RefusesWhatItCannotDo) {
  const Model round = *cylinder(1, 1);
  expect_error(transform(round, Transform::from_rows({2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0})), errors::not_similar,
               "stretches directions unequally");
  expect_error(transform(round, Transform::from_rows({1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0})), errors::bad_size,
               "must be regular");
  expect_error(transform(round, Transform::from_rows({1, 0, 0, NAN, 0, 1, 0, 0, 0, 0, 1, 0})), errors::bad_size,
               "of finite numbers");
  expect_error(scale(round, 0), errors::bad_size, "scale: factor must be positive");
  expect_error(scale(round, -2), errors::bad_size, "scale: factor must be positive");
  expect_error(rotate(round, NAN), errors::bad_size, "rotate: angle must be a finite number");
  expect_error(rotate(round, 30, {0, 0, 0}), errors::bad_size, "rotate: axis must be a direction");
  expect_error(mirror(round, {}, {}), errors::bad_size, "mirror: normal must be a direction");
  expect_error(translate(round, {INFINITY, 0, 0}), errors::bad_size, "translate: offset");
}

TEST(Transform, WiresFacesAndPointsMoveToo) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 1}};
  const auto map = Transform::rotation(90, {0, 0, 1}) * Transform::scaling(2);
  const auto s = transform(*spline(points), map);
  ASSERT_BUILT(s);
  EXPECT_LT(largest_gap(*s), 1e-13);
  EXPECT_NEAR(total_length(*s).value(), 2 * total_length(*spline(points)).value(), 1e-9);
  EXPECT_NEAR(distance(transform(*point({1, 2, 3}), map)->point(VertexId(0)), {-4, 2, 6}), 0, 1e-15);
  EXPECT_NEAR(total_area(*transform(*disk(1), map)).value(), 4 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(total_length(*transform(*arc({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), map)).value(), std::numbers::pi, 1e-12);
}

TEST(Grid, GivesSeparateCopiesInOrder) {
  const auto copies = grid(*block(1, 1, 1), {2, 3, 1}, {1, 2, 0});
  ASSERT_BUILT(copies);
  ASSERT_EQ(copies->size(), 6u);
  EXPECT_EQ((*copies)[1].bounds().low, (Vec3{1, 0, 0}));
  EXPECT_EQ((*copies)[4].bounds().low, (Vec3{0, 4, 0}));
  expect_error(grid(*block(1, 1, 1), {0, 1, 1}, {1, 1, 1}), errors::bad_size, "grid: n[0]");
  expect_error(grid(*block(1, 1, 1), {1, 2, 1}, {1, 0, 1}), errors::bad_size, "grid: step[1]");
  expect_error(grid(*block(1, 1, 1), {1000, 1000, 2}, {1, 1, 1}), errors::bad_size, "at most a million");
  expect_error(grid(*block(1, 1, 1), {1, 1, 2}, {1, NAN, 1}), errors::bad_size, "grid: step");
}

TEST(Merge, JoinsModelsThatDoNotTouch) {
  Model a = *block(1, 1, 1), b = *sphere(1, {{5, 0, 0}}), c = *polyline(std::vector<Vec3>{{0, 5, 0}, {1, 5, 0}});
  a.labels.set_name(RegionId(1), "cube");
  b.labels.set_name(RegionId(1), "ball");
  a.labels.groups.push_back({"all", {RegionId(1)}});
  b.labels.groups.push_back({"all", {FaceId(0), RegionId(1)}});
  const Model p = *point({0, 0, 9});
  const std::vector<const Model*> models{&a, &b, &c, &p};
  const auto m = merge_disjoint(models);
  ASSERT_BUILT(m);
  EXPECT_EQ(counts(*m), (Counts{8 + 2 + 2 + 1, 12 + 1 + 1, 7, 2}));
  EXPECT_NEAR(total_volume(*m).value(), 1 + 4.0 / 3 * std::numbers::pi, 1e-9);
  EXPECT_EQ(m->labels.name(RegionId(1)), "cube");
  EXPECT_EQ(m->labels.name(RegionId(2)), "ball");
  ASSERT_EQ(m->labels.groups.size(), 1u);
  EXPECT_EQ(m->labels.groups[0].entities, (std::vector<EntityRef>{FaceId(6), RegionId(1), RegionId(2)}));
  EXPECT_TRUE(m->topology().is_wire(EdgeId(13)));
  EXPECT_TRUE(m->topology().isolated_in_shell(VertexId(12)).valid());
}

TEST(Merge, RefusesModelsThatMayTouch) {
  const Model a = *block(1, 1, 1), b = *block(1, 1, 1, {1, 0, 0}), c = *block(1, 1, 1, {5, 0, 0});
  const std::vector<const Model*> touching{&c, &a, &b};
  expect_error(merge_disjoint(touching), errors::not_disjoint, "items 1 and 2");
  const Model inch = *block(1, 1, 1, {9, 9, 9}, {.length_unit = 0.0254});
  const std::vector<const Model*> mixed{&a, &inch};
  expect_error(merge_disjoint(mixed), errors::mixed_units, "length units");
  expect_error(merge_disjoint(std::vector<const Model*>{}), errors::bad_size, "models must be a list");
  const std::atomic<bool> stop{true};
  const std::vector<const Model*> apart{&a, &c};
  EXPECT_EQ(merge_disjoint(apart, {.cancel = &stop}).error().code, errors::cancelled);
}

}  // namespace
}  // namespace aresta
