// SPDX-License-Identifier: Apache-2.0
// Booleans on models that are stitched already: every decision without an engine, from the worked cases of the table.
#include <gtest/gtest.h>

#include <algorithm>

#include "boolean/boolean.h"
#include "model/measure.h"
#include "support/stitched.h"

namespace aresta {
namespace {

using test::Stitched;

GroupSpec regions_of(std::string name, std::vector<RegionId> regions) {
  GroupSpec spec{std::move(name), {}};
  for (const RegionId r : regions) spec.members.push_back({0, r});
  return spec;
}

BooleanResult run(const std::shared_ptr<const Model>& model, const std::vector<GroupSpec>& groups, BooleanKind kind,
                  bool regularise = false) {
  BooleanOptions options;
  options.kind = kind;
  options.regularise = regularise;
  auto result = boolean({model}, groups, options, {});
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(*result);
}

/// Numbers (from 1) of the source's faces that were kept.
std::vector<int> kept_faces(const BooleanResult& result) {
  std::vector<int> numbers;
  for (const FaceId f : result.from.faces) numbers.push_back(static_cast<int>(f.index()) + 1);
  return numbers;
}

std::vector<int> range(std::initializer_list<std::pair<int, int>> pieces) {
  std::vector<int> numbers;
  for (const auto& [a, b] : pieces) {
    for (int i = a; i <= b; ++i) numbers.push_back(i);
  }
  return numbers;
}

double volume(const Model& model) {
  return *total_volume(model);
}

/// Regions, volume, faces, edges.
std::array<double, 4> summary(const BooleanResult& r) {
  const Complex& k = r.model.topology();
  return {double(r.model.regions().size()), std::round(1e9 * volume(r.model)) / 1e9, double(k.face_count()),
          double(k.edge_count())};
}

/// Example 5.8: big1, small1, small2, big2 with the faces numbered as in the table of the specification.
struct Example58 {
  std::shared_ptr<const Model> model;
  RegionId big1, small1, small2, big2;

  Example58() {
    Stitched s;
    const auto side = [&](double lo, double hi, double z0, double z1, int which) {
      const Vec3 c[4] = {{lo, lo, 0}, {hi, lo, 0}, {hi, hi, 0}, {lo, hi, 0}};
      const Vec3 a = c[which], b = c[(which + 1) % 4];
      return s.face({{{a.x, a.y, z0}, {b.x, b.y, z0}, {b.x, b.y, z1}, {a.x, a.y, z1}}});
    };
    const auto square = [](double lo, double hi, double z) {
      return std::vector<Vec3>{{lo, lo, z}, {hi, lo, z}, {hi, hi, z}, {lo, hi, z}};
    };
    s.face({square(0, 4, 0)});                        // 1, normal up
    for (int i = 0; i < 4; ++i) side(0, 4, 0, 4, i);  // 2-5, outward
    s.face({square(1, 3, 2)});                        // 6
    for (int i = 0; i < 4; ++i) side(1, 3, 2, 4, i);  // 7-10, away from small1
    s.face({square(1, 3, 4)});                        // 11
    for (int i = 0; i < 4; ++i) side(1, 3, 4, 6, i);  // 12-15
    s.face({square(1, 3, 6)});                        // 16
    auto hole = square(1, 3, 4);
    std::reverse(hole.begin(), hole.end());
    s.face({square(0, 4, 4), hole});                  // 17
    for (int i = 0; i < 4; ++i) side(0, 4, 4, 8, i);  // 18-21
    s.face({square(0, 4, 8)});                        // 22
    model = s.build_all_filled();
    const Complex& k = model->topology();
    big1 = k.region(FaceUse(FaceId(0), 0));
    small1 = k.region(FaceUse(FaceId(5), 0));
    small2 = k.region(FaceUse(FaceId(10), 0));
    big2 = k.region(FaceUse(FaceId(21), 1));
  }
  std::vector<GroupSpec> groups() const {
    return {regions_of("A", {big1, small1, small2}), regions_of("B", {big2, small1, small2})};
  }
};

TEST(Boolean58, ClassesAreThoseOfTheTable) {
  const Example58 e;
  const auto classes = classify({e.model}, e.groups(), {}, {});
  ASSERT_TRUE(classes.ok()) << classes.error().to_line();
  int faces = 0;
  for (const auto& [entity, cls] : classes->classes) {
    if (entity.kind != EntityKind::face) continue;
    ++faces;
    const int number = static_cast<int>(entity.index) + 1;
    const Class expected = number <= 5 ? Class::a_out_b : number <= 17 ? Class::shared : Class::b_out_a;
    EXPECT_EQ(cls, expected) << "face " << number;
  }
  EXPECT_EQ(faces, 22);
}

TEST(Boolean58, FourOperations) {
  const Example58 e;
  const auto united = run(e.model, e.groups(), BooleanKind::unite);
  EXPECT_EQ(kept_faces(united), range({{1, 5}, {18, 22}}));
  EXPECT_EQ(united.model.regions().size(), 1u);
  EXPECT_NEAR(volume(united.model), 128, 1e-10);

  const auto common = run(e.model, e.groups(), BooleanKind::intersect);
  EXPECT_EQ(kept_faces(common), range({{6, 10}, {12, 17}}));
  EXPECT_EQ(common.model.regions().size(), 1u);
  EXPECT_NEAR(volume(common.model), 16, 1e-12);
  const auto clean = run(e.model, e.groups(), BooleanKind::intersect, true);
  EXPECT_EQ(kept_faces(clean), range({{6, 10}, {12, 16}}));

  const auto rest = run(e.model, e.groups(), BooleanKind::subtract);
  EXPECT_EQ(kept_faces(rest), range({{1, 5}, {6, 10}, {17, 17}}));
  EXPECT_EQ(rest.model.regions().size(), 1u);
  EXPECT_NEAR(volume(rest.model), 56, 1e-11);

  // (A - B) and (B - A): big1 and big2, which meet in face 17 from opposite sides: it goes.
  const auto either = run(e.model, e.groups(), BooleanKind::symmetric_difference);
  EXPECT_NEAR(volume(either.model), 112, 1e-10);
  EXPECT_EQ(kept_faces(either), range({{1, 10}, {12, 16}, {18, 22}}));
}

/// Two unit cubes side by side along x, sharing the right face of the first.
struct TwoCubes {
  Stitched s;
  std::array<FaceId, 6> first = s.box({0, 0, 0}, {1, 1, 1});
  std::vector<FaceId> second;
  TwoCubes() {
    second.push_back(s.face({{{1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}}}));
    second.push_back(s.face({{{1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}}}));
    second.push_back(s.face({{{1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}}}));
    second.push_back(s.face({{{1, 1, 0}, {1, 1, 1}, {2, 1, 1}, {2, 1, 0}}}));
    second.push_back(s.face({{{2, 0, 0}, {2, 1, 0}, {2, 1, 1}, {2, 0, 1}}}));
  }
};

TEST(BooleanTouching, CubesThatShareAFace) {
  TwoCubes cubes;
  const auto model = cubes.s.build_all_filled();
  const RegionId a = model->topology().region(FaceUse(cubes.first[0], 1));
  const RegionId b = model->topology().region(FaceUse(cubes.second[0], 1));
  const std::vector<GroupSpec> groups{regions_of("A", {a}), regions_of("B", {b})};
  EXPECT_EQ(summary(run(model, groups, BooleanKind::unite)), (std::array{1.0, 2.0, 10.0, 20.0}));
  EXPECT_EQ(summary(run(model, groups, BooleanKind::intersect)), (std::array{0.0, 0.0, 1.0, 4.0}));
  EXPECT_EQ(summary(run(model, groups, BooleanKind::subtract)), (std::array{1.0, 1.0, 6.0, 12.0}));
  // A group of two touching regions united with itself has no wall between them; with nothing, it keeps the wall.
  const GroupSpec both = regions_of("AB", {a, b});
  EXPECT_EQ(summary(run(model, {both, both}, BooleanKind::unite)), (std::array{1.0, 2.0, 10.0, 20.0}));
  EXPECT_EQ(summary(run(model, {both, GroupSpec{"empty", {}}}, BooleanKind::unite)),
            (std::array{2.0, 2.0, 11.0, 20.0}));
}

TEST(BooleanDangling, Example517) {
  // Two cubes that share a wall; each has an internal face hanging on that wall.
  Stitched s;
  const std::vector<Vec3> wall{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}};
  const FaceId left = s.face({{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}});
  s.face({{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}});
  s.face({{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}});
  s.face({{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}});
  s.face({{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}});
  const FaceId shared = s.face({wall, {{1, 0.25, 0.5}, {1, 0.75, 0.5}}});
  const FaceId in_first = s.face({{{1, 0.25, 0.5}, {1, 0.75, 0.5}, {0.5, 0.75, 0.5}, {0.5, 0.25, 0.5}}});
  const FaceId in_second = s.face({{{1, 0.25, 0.5}, {1.5, 0.25, 0.5}, {1.5, 0.75, 0.5}, {1, 0.75, 0.5}}});
  s.face({{{1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}}});
  s.face({{{1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}}});
  s.face({{{1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}}});
  s.face({{{1, 1, 0}, {1, 1, 1}, {2, 1, 1}, {2, 1, 0}}});
  const FaceId right = s.face({{{2, 0, 0}, {2, 1, 0}, {2, 1, 1}, {2, 0, 1}}});
  const auto model = s.build_all_filled();
  ASSERT_EQ(model->regions().size(), 2u);
  const RegionId a = model->topology().region(FaceUse(left, 1)), b = model->topology().region(FaceUse(right, 1));
  GroupSpec group_a = regions_of("A", {a});
  group_a.internals = false;
  group_a.members.push_back({0, in_first});
  group_a.members.push_back({0, in_second});
  GroupSpec group_b = regions_of("B", {b});
  group_b.internals = false;

  const auto holds = [&](const BooleanResult& r, FaceId f) {
    return std::find(r.from.faces.begin(), r.from.faces.end(), f) != r.from.faces.end();
  };
  const auto united = run(model, {group_a, group_b}, BooleanKind::unite);
  EXPECT_FALSE(holds(united, shared));
  EXPECT_TRUE(holds(united, in_first) && holds(united, in_second));
  EXPECT_EQ(united.model.regions().size(), 1u);
  const auto common = run(model, {group_a, group_b}, BooleanKind::intersect);
  EXPECT_EQ(common.from.faces, (std::vector<FaceId>{shared, in_second}));
  EXPECT_EQ(common.model.regions().size(), 0u);
  const auto rest = run(model, {group_a, group_b}, BooleanKind::subtract);
  EXPECT_TRUE(holds(rest, shared) && holds(rest, in_first) && !holds(rest, in_second));
  EXPECT_EQ(rest.model.topology().face_count(), 7u);
  EXPECT_EQ(run(model, {group_a, group_b}, BooleanKind::unite, true).model.topology().face_count(), 10u);
  EXPECT_EQ(run(model, {group_a, group_b}, BooleanKind::intersect, true).model.topology().face_count(), 0u);
  EXPECT_EQ(run(model, {group_a, group_b}, BooleanKind::subtract, true).model.topology().face_count(), 6u);
}

TEST(BooleanWires, CrossingEdgesMeetInTheirVertex) {
  Stitched s;
  const EdgeId a0 = s.edge({-1, 0, 0}, {0, 0, 0}), a1 = s.edge({0, 0, 0}, {1, 0, 0});
  const EdgeId b0 = s.edge({0, -1, 0}, {0, 0, 0}), b1 = s.edge({0, 0, 0}, {0, 1, 0});
  const auto model = s.build_all_filled();
  const std::vector<GroupSpec> groups{{"A", {{0, a0}, {0, a1}}}, {"B", {{0, b0}, {0, b1}}}};
  const auto common = run(model, groups, BooleanKind::intersect);
  EXPECT_EQ(common.model.topology().vertex_count(), 1u);
  EXPECT_EQ(common.model.topology().edge_count(), 0u);
  EXPECT_EQ(common.model.point(VertexId(0)), (Vec3{0, 0, 0}));
  EXPECT_EQ(run(model, groups, BooleanKind::subtract).model.topology().edge_count(), 2u);
  EXPECT_EQ(run(model, groups, BooleanKind::unite).model.topology().edge_count(), 4u);
}

TEST(BooleanVoid, CubeWithVoidAndItsFillingMeetInAShellWithoutRegion) {
  Stitched s;
  s.box({0, 0, 0}, {3, 3, 3});
  const auto inner = s.box({1, 1, 1}, {2, 2, 2});
  const auto model = s.build_all_filled();
  ASSERT_EQ(model->regions().size(), 2u);
  const RegionId filling = model->topology().region(FaceUse(inner[0], 1)),
                 around = model->topology().region(FaceUse(inner[0], 0));
  const std::vector<GroupSpec> groups{regions_of("A", {around}), regions_of("B", {filling})};
  EXPECT_NEAR(*total_volume(*model), 27, 1e-12);
  EXPECT_EQ(summary(run(model, groups, BooleanKind::intersect)), (std::array{0.0, 0.0, 6.0, 12.0}));
  EXPECT_EQ(summary(run(model, groups, BooleanKind::unite)), (std::array{1.0, 27.0, 6.0, 12.0}));
  EXPECT_EQ(summary(run(model, groups, BooleanKind::subtract)), (std::array{1.0, 26.0, 12.0, 24.0}));
  EXPECT_EQ(run(model, groups, BooleanKind::intersect, true).model.topology().face_count(), 0u);
}

TEST(BooleanWires, WireFromTheOuterCubeIntoTheInnerOne) {
  // After example 5.13, with the space between the cubes listed in A.
  Stitched s;
  const Vec3 on_edge{2, 0, 0}, pierced{2, 1, 1}, tip{2, 2, 2};
  s.face({{{0, 0, 0}, {0, 4, 0}, {4, 4, 0}, {4, 0, 0}, on_edge}});
  s.face({{{0, 0, 4}, {4, 0, 4}, {4, 4, 4}, {0, 4, 4}}});
  s.face({{{0, 0, 0}, on_edge, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}}});
  s.face({{{0, 4, 0}, {0, 4, 4}, {4, 4, 4}, {4, 4, 0}}});
  s.face({{{0, 0, 0}, {0, 0, 4}, {0, 4, 4}, {0, 4, 0}}});
  const FaceId right = s.face({{{4, 0, 0}, {4, 4, 0}, {4, 4, 4}, {4, 0, 4}}});
  s.face({{{1, 1, 1}, {1, 3, 1}, {3, 3, 1}, {3, 1, 1}, pierced}});
  s.face({{{1, 1, 3}, {3, 1, 3}, {3, 3, 3}, {1, 3, 3}}});
  s.face({{{1, 1, 1}, pierced, {3, 1, 1}, {3, 1, 3}, {1, 1, 3}}});
  s.face({{{1, 3, 1}, {1, 3, 3}, {3, 3, 3}, {3, 3, 1}}});
  s.face({{{1, 1, 1}, {1, 1, 3}, {1, 3, 3}, {1, 3, 1}}});
  const FaceId inner_right = s.face({{{3, 1, 1}, {3, 3, 1}, {3, 3, 3}, {3, 1, 3}}});
  const EdgeId wire_out = s.edge(on_edge, pierced), wire_in = s.edge(pierced, tip);
  const auto model = s.build_all_filled();
  ASSERT_EQ(model->regions().size(), 2u);
  const Complex& k = model->topology();
  const RegionId shell = k.region(FaceUse(right, 1)), core = k.region(FaceUse(inner_right, 1));
  EXPECT_EQ(k.region(k.wire_shell(wire_out)), shell);
  EXPECT_EQ(k.region(k.wire_shell(wire_in)), core);
  GroupSpec a = regions_of("A", {shell});
  a.members.push_back({0, wire_out});
  a.members.push_back({0, wire_in});
  const GroupSpec b = regions_of("B", {core});
  const auto united = run(model, {a, b}, BooleanKind::unite);
  EXPECT_EQ(united.model.topology().face_count(), 6u);
  EXPECT_EQ(united.model.topology().edge_count(), 13u + 2u);
  EXPECT_NEAR(volume(united.model), 64, 1e-11);
  const auto rest = run(model, {a, b}, BooleanKind::subtract);
  EXPECT_NEAR(volume(rest.model), 56, 1e-11);
  EXPECT_EQ(rest.model.topology().edge_count(), 13u + 13u + 1u);
}

TEST(BooleanErrors, GroupsAreChecked) {
  TwoCubes cubes;
  const auto model = cubes.s.build_all_filled();
  const GroupSpec a = regions_of("A", {RegionId(1)});
  const BooleanOptions options;
  EXPECT_EQ(boolean({model}, {a}, options, {}).error().code.number, 650);
  EXPECT_EQ(boolean({model}, {a, regions_of("B", {RegionId(77)})}, options, {}).error().code.number, 652);
  EXPECT_EQ(boolean({model}, {a, regions_of("B", {RegionId(std::size_t{0})})}, options, {}).error().code.number, 652);
  EXPECT_EQ(boolean({}, {a, a}, options, {}).error().code.number, 550);
  std::atomic<bool> stop = true;
  Context context;
  context.cancel = &stop;
  EXPECT_EQ(boolean({model}, {a, a}, options, context).error().code, errors::cancelled);
}

}  // namespace
}  // namespace aresta
