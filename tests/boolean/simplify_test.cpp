// SPDX-License-Identifier: Apache-2.0
#include "boolean/simplify.h"

#include <gtest/gtest.h>

#include <numbers>

#include "boolean/boolean.h"
#include "construct/primitives.h"
#include "model/measure.h"

namespace aresta {
namespace {

constexpr double pi = std::numbers::pi;

Model take(Result<Model> model) {
  if (!model.ok()) throw std::runtime_error(model.error().to_line());
  return std::move(*model);
}

using Counts = std::array<std::size_t, 4>;  // vertices, edges, faces, regions

Counts counts(const Model& m) {
  return {m.topology().vertex_count(), m.topology().edge_count(), m.topology().face_count(), m.regions().size()};
}

Model simplified(const Model& model) {
  auto result = simplify(model);
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  EXPECT_NEAR(*total_volume(result->model), *total_volume(model), 1e-9 * std::max(1.0, *total_volume(model)));
  EXPECT_NEAR(*total_area(result->model), *total_area(model), 1e-9 * *total_area(model));
  EXPECT_TRUE(require_valid(result->model, CheckLevel::full).ok());
  return std::move(result->model);
}

Patches patches(int count) {
  Patches p;
  p.count = count;
  return p;
}

TEST(Simplify, RoundSidesKeepOneSeam) {
  EXPECT_EQ(counts(simplified(take(cylinder(1, 2, {}, patches(4))))), (Counts{2, 3, 3, 1}));
  EXPECT_EQ(counts(simplified(take(cone(2, 1, 2, {}, patches(3))))), (Counts{2, 3, 3, 1}));
  EXPECT_EQ(counts(simplified(take(sphere(1, {}, patches(4))))), (Counts{2, 1, 1, 1}));
}

TEST(Simplify, NothingToDoLeavesAsIs) {
  EXPECT_EQ(counts(simplified(take(block(1, 2, 3)))), (Counts{8, 12, 6, 1}));
  EXPECT_EQ(counts(simplified(take(cylinder(1, 2)))), (Counts{2, 3, 3, 1}));
}

TEST(Simplify, UnionOfBlocksInARow) {
  const auto a = std::make_shared<const Model>(take(block(1, 1, 1))),
             b = std::make_shared<const Model>(take(block(2, 1, 1, {1, 0, 0})));
  BooleanOptions options;
  const auto united = boolean({a, b}, {whole_operand("A", 0, *a), whole_operand("B", 1, *b)}, options, {});
  ASSERT_TRUE(united.ok()) << united.error().to_line();
  EXPECT_EQ(counts(united->model), (Counts{12, 20, 10, 1}));
  EXPECT_EQ(counts(simplified(united->model)), (Counts{8, 12, 6, 1}));
}

TEST(Simplify, WhatCarriesALabelStays) {
  const auto a = std::make_shared<const Model>(take(block(1, 1, 1))),
             b = std::make_shared<const Model>(take(block(2, 1, 1, {1, 0, 0})));
  BooleanOptions options;
  auto united = boolean({a, b}, {whole_operand("A", 0, *a), whole_operand("B", 1, *b)}, options, {});
  ASSERT_TRUE(united.ok());
  Model& model = united->model;
  for (const FaceId f : model.topology().faces()) {
    const auto centroid = measure(model, f)->centroid();
    if (centroid.z == 1 && centroid.x < 1) model.labels.set_name(f, "top of the first");
  }
  // The two top faces stay apart, with the edge between them and its ends.
  EXPECT_EQ(counts(simplified(model)), (Counts{10, 15, 7, 1}));
  EXPECT_EQ(simplified(model).labels.attributes.size(), 1u);
}

TEST(Simplify, HoleThroughAPlateKeepsItsRims) {
  const auto plate = std::make_shared<const Model>(take(block(4, 4, 1))),
             drill = std::make_shared<const Model>(take(cylinder(1, 1, {{2, 2, 0}, {0, 0, 1}})));
  BooleanOptions options;
  options.kind = BooleanKind::subtract;
  const auto drilled =
      boolean({plate, drill}, {whole_operand("A", 0, *plate), whole_operand("B", 1, *drill)}, options, {});
  ASSERT_TRUE(drilled.ok()) << drilled.error().to_line();
  const Model clean = simplified(drilled->model);
  EXPECT_EQ(counts(clean), (Counts{10, 15, 7, 1}));  // two closed rims and one seam
  EXPECT_NEAR(*total_volume(clean), 16 - pi, 1e-10);
}

}  // namespace
}  // namespace aresta
