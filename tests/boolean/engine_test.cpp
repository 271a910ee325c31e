// SPDX-License-Identifier: Apache-2.0
// Booleans through the whole pipeline, against closed forms.
#include <gtest/gtest.h>

#include <numbers>

#include "boolean/boolean.h"
#include "boolean/simplify.h"
#include "construct/primitives.h"
#include "model/measure.h"

namespace aresta {
namespace {

constexpr double pi = std::numbers::pi;

std::shared_ptr<const Model> take(Result<Model> model) {
  if (!model.ok()) throw std::runtime_error(model.error().to_line());
  return std::make_shared<const Model>(std::move(*model));
}

BooleanResult run(const std::shared_ptr<const Model>& a, const std::shared_ptr<const Model>& b, BooleanKind kind,
                  bool regularise = true) {
  BooleanOptions options;
  options.kind = kind;
  options.regularise = regularise;
  auto result = boolean({a, b}, {whole_operand("A", 0, *a), whole_operand("B", 1, *b)}, options, {});
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(*result);
}

double volume(const Model& m) {
  return *total_volume(m);
}

struct Expected {
  double volume;
  std::size_t regions;
};

void expect(const char* what, const BooleanResult& r, const Expected& e, double relative = 1e-7) {
  EXPECT_NEAR(volume(r.model), e.volume, relative * std::max(1.0, e.volume)) << what;
  EXPECT_EQ(r.model.regions().size(), e.regions) << what;
}

Placement along(Vec3 at, Vec3 axis) {
  Placement p;
  p.at = at;
  p.axis = axis;
  return p;
}

TEST(BooleanEngine, OverlappingBlocks) {
  const auto a = take(block(2, 2, 2)), b = take(block(2, 2, 2, {1, 1, 1}));
  expect("union", run(a, b, BooleanKind::unite), {15, 1}, 1e-12);
  expect("intersection", run(a, b, BooleanKind::intersect), {1, 1}, 1e-12);
  expect("difference", run(a, b, BooleanKind::subtract), {7, 1}, 1e-12);
  expect("symmetric", run(a, b, BooleanKind::symmetric_difference), {14, 2}, 1e-12);
}

TEST(BooleanEngine, CrossingCylinders) {
  const auto z = take(cylinder(2, 10, along({0, 0, -5}, {0, 0, 1}))),
             x = take(cylinder(2, 10, along({-5, 0, 0}, {1, 0, 0})));
  expect("union", run(z, x, BooleanKind::unite), {80 * pi - 128.0 / 3, 1});
  expect("intersection", run(z, x, BooleanKind::intersect), {128.0 / 3, 1});
}

TEST(BooleanEngine, TangentBlockAndCylinders) {  // 5.3, 5.4
  const auto z = take(cylinder(1, 6, along({0, 0, -3}, {0, 0, 1}))),
             x = take(cylinder(1, 6, along({-3, 0, 0}, {1, 0, 0})));
  const auto c = run(z, x, BooleanKind::unite);
  expect("C", c, {12 * pi - 16.0 / 3, 1});
  const auto cross = std::make_shared<const Model>(c.model);
  const auto d = take(block(2, 2, 2, {0.5, -1, -1}));
  expect("C & D", run(cross, d, BooleanKind::intersect), {6.393689, 1}, 2e-7);
  expect("C - D", run(cross, d, BooleanKind::subtract), {25.972089, 2}, 1e-7);
  expect("D - C", run(d, cross, BooleanKind::subtract), {1.606311, 4}, 1e-6);
}

TEST(BooleanEngine, CylinderTangentInsideCube) {  // 5.18
  for (const int patches : {1, 2, 4}) {
    for (const double seam : {0.0, 30.0, 45.0}) {
      Patches p;
      p.count = patches;
      p.seam = seam;
      const auto cube = take(block(2, 2, 2, {-1, -1, -1})),
                 tube = take(cylinder(1, 4, along({0, 0, -2}, {0, 0, 1}), p));
      expect("union", run(cube, tube, BooleanKind::unite), {8 + 2 * pi, 1});
      expect("intersection", run(cube, tube, BooleanKind::intersect), {2 * pi, 1});
      expect("cube - cylinder", run(cube, tube, BooleanKind::subtract), {8 - 2 * pi, 4});
      expect("cylinder - cube", run(tube, cube, BooleanKind::subtract), {2 * pi, 2});
    }
  }
}

TEST(BooleanEngine, BasesOverlapAndSidesTouch) {  // 5.19-5.23
  const auto bar = take(block(5, 2, 1, {0, -1, 0})), eye = take(cylinder(1, 1));
  const auto joined = run(bar, eye, BooleanKind::unite);
  expect("union", joined, {10 + pi / 2, 1});
  const auto link = std::make_shared<const Model>(joined.model);
  const auto drilled = run(link, take(cylinder(0.5, 1)), BooleanKind::subtract);
  expect("drilled", drilled, {10 + pi / 2 - pi / 4, 1});
}

TEST(BooleanEngine, SheetThroughCube) {  // 5.11
  const auto cube = take(block(2, 2, 2));
  ModelBuilder builder;
  const Vec3 corners[] = {{-1, -1, 1}, {3, -1, 1}, {3, 3, 1}, {-1, 3, 1}};
  for (const Vec3 c : corners) builder.add_vertex(c);
  for (std::size_t i = 0; i < 4; ++i) builder.add_edge(VertexId(i), VertexId((i + 1) % 4));
  builder.begin_face(builder.add_surface(Plane{Frame{{0, 0, 1}}}), false);
  for (std::size_t i = 0; i < 4; ++i) builder.add_coedge(EdgeId(i), false);
  builder.close_loop();
  builder.end_face();
  const auto sheet = take(builder.build({}));
  const auto count = [](const BooleanResult& r) {
    return std::pair(r.model.regions().size(), r.model.topology().face_count());
  };
  EXPECT_EQ(count(run(sheet, cube, BooleanKind::intersect, false)), (std::pair<std::size_t, std::size_t>{0, 1}));
  const auto ring = run(sheet, cube, BooleanKind::subtract, false);
  EXPECT_EQ(count(ring), (std::pair<std::size_t, std::size_t>{0, 1}));
  EXPECT_NEAR(*total_area(ring.model), 12, 1e-12);
  const auto rest = run(cube, sheet, BooleanKind::subtract, false);
  EXPECT_EQ(count(rest), (std::pair<std::size_t, std::size_t>{1, 10}));
  const auto clean = simplify(rest.model);
  ASSERT_TRUE(clean.ok()) << clean.error().to_line();
  EXPECT_EQ(clean->model.topology().face_count(), 6u);
  EXPECT_EQ(clean->model.topology().edge_count(), 12u);
  EXPECT_EQ(clean->model.topology().vertex_count(), 8u);
  EXPECT_EQ(count(run(sheet, cube, BooleanKind::unite, false)), (std::pair<std::size_t, std::size_t>{2, 12}));
}

}  // namespace
}  // namespace aresta
