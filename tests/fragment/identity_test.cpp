// SPDX-License-Identifier: Apache-2.0
#include "fragment/identity.h"

#include <gtest/gtest.h>

#include <numbers>

#include "construct/move.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "fragment/fragment.h"
#include "model/check.h"
#include "model/copy.h"
#include "model/measure.h"
#include "support/ellipsoid.h"

namespace aresta {
namespace {

using ModelPtr = std::shared_ptr<const Model>;
constexpr double pi = std::numbers::pi;

ModelPtr take(Result<Model> model) {
  if (!model.ok()) throw std::runtime_error(model.error().to_line());
  return std::make_shared<const Model>(std::move(*model));
}

template <class T>
T take(Result<T> result) {
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(*result);
}

Identity unite(const std::vector<ModelPtr>& operands, double tolerance = 0) {
  return take(unite_coincident(operands, tolerance, {}));
}

std::string united(const std::vector<ModelPtr>& operands, double tolerance = 0) {
  const Identity found = unite(operands, tolerance);
  return std::to_string(found.united[0]) + "/" + std::to_string(found.united[1]) + "/" +
         std::to_string(found.united[2]);
}

/// The fragment by identity alone; it must pass the full checker.
Fragment joined(const std::vector<ModelPtr>& operands) {
  FragmentOptions options;
  options.engine = &identity_engine();
  Fragment result = take(fragment(operands, options, {}));
  const Status valid = require_valid(*result.model, CheckLevel::full);
  EXPECT_TRUE(valid.ok()) << valid.error().to_line();
  return result;
}

std::string counts(const Model& model) {
  const Complex& k = model.topology();
  return std::to_string(model.regions().size()) + "/" + std::to_string(k.face_count()) + "/" +
         std::to_string(k.edge_count()) + "/" + std::to_string(k.vertex_count());
}

TEST(Identity, WhatCoincidesAsAWholeIsOne) {
  const ModelPtr a = take(block(1, 1, 1));
  EXPECT_EQ(united({a, take(block(1, 1, 1))}), "8/12/6");
  EXPECT_EQ(united({a, take(block(1, 1, 1, {1, 0, 0}))}), "4/4/1");    // side by side
  EXPECT_EQ(united({a, take(block(1, 1, 1, {1, 1, 0}))}), "2/1/0");    // along an edge
  EXPECT_EQ(united({a, take(block(1, 1, 2, {1, 0, 0}))}), "2/1/0");    // in part: two corners below, an edge between
  EXPECT_EQ(united({a, take(block(1, 1, 1, {0.5, 0, 0}))}), "0/0/0");  // overlapping
  EXPECT_EQ(counts(*joined({a, take(block(1, 1, 1, {1, 0, 0}))}).model), "2/11/20/12");
}

TEST(Identity, ParentsSayWhoIsWhoAndWhichWayTheyLook) {
  const ModelPtr a = take(block(1, 1, 1));
  const Identity same = unite({a, a}), beside = unite({a, take(block(1, 1, 1, {1, 0, 0}))});
  for (std::size_t f = 0; f < same.imprint.face_parents.size(); ++f) {
    ASSERT_EQ(same.imprint.face_parents[f], (std::vector<Parent>{{0, FaceId(f)}, {1, FaceId(f)}}));
    EXPECT_EQ(same.opposite[f], (std::vector<bool>{false, false}));
  }
  int shared = 0;
  for (std::size_t f = 0; f < beside.imprint.face_parents.size(); ++f) {
    if (beside.imprint.face_parents[f].size() < 2) continue;
    ++shared;
    EXPECT_EQ(beside.opposite[f], (std::vector<bool>{false, true}));
  }
  EXPECT_EQ(shared, 1);
}

TEST(Identity, TheToleranceOfTheOneCoversTheOthers) {
  const ModelPtr a = take(point({0, 0, 0})), b = take(point({8e-4, 0, 0}));
  EXPECT_EQ(united({a, b}), "0/0/0");
  const Identity found = unite({a, b}, 1e-3);
  ASSERT_EQ(found.united[0], 1u);
  ModelBuilder builder = found.imprint.builder;
  const ModelPtr one = take(builder.build(Context{}));
  EXPECT_EQ(one->point(VertexId(std::size_t{0})), (Vec3{0, 0, 0}));
  EXPECT_NEAR(one->tolerance(VertexId(std::size_t{0})), 8e-4, 1e-15);
}

TEST(Identity, AClusterWiderThanItsToleranceIsNamed) {
  const std::vector<ModelPtr> chain{take(point({0, 0, 0})), take(point({8e-4, 0, 0})), take(point({16e-4, 0, 0}))};
  const auto refused = unite_coincident(chain, 1e-3, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, errors::cluster_too_wide);
  EXPECT_EQ(refused.error().entities.size(), 3u);
  EXPECT_NE(refused.error().message.find("operand 3"), std::string::npos) << refused.error().message;
  EXPECT_TRUE(refused.error().place.has_value());
  EXPECT_EQ(fragment(chain, {.tolerance = 1e-3}, {}).error().code, errors::cluster_too_wide);
  EXPECT_EQ(united(chain, 2e-3), "2/0/0");
}

TEST(Identity, EntitiesOfOneOperandNeverBecomeOne) {
  const ModelPtr two = take(line({0, 0, 0}, {8e-4, 0, 0}));
  EXPECT_EQ(united({two, take(point({4e-4, 0, 0}))}, 1e-3), "0/0/0");
}

TEST(Identity, ArcsOnOneCircleAreNotOneWhenTheyGoApart) {
  const ModelPtr upper = take(arc_through({-1, 0, 0}, {0, 1, 0}, {1, 0, 0}));
  EXPECT_EQ(united({upper, take(arc_through({-1, 0, 0}, {0, -1, 0}, {1, 0, 0}))}), "2/0/0");
  EXPECT_EQ(united({upper, take(arc_through({1, 0, 0}, {std::sqrt(0.5), std::sqrt(0.5), 0}, {-1, 0, 0}))}), "2/1/0");
  EXPECT_EQ(united({upper, take(line({-1, 0, 0}, {1, 0, 0}))}), "2/0/0");
}

TEST(Identity, CapsOfOneSphereAreNotOne) {
  // Both have the equator for boundary.
  const auto cap = [](double side) {
    ModelBuilder b;
    const VertexId v = b.add_vertex({1, 0, 0});
    const Frame frame{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const EdgeId e = b.add_edge(v, v, b.add_curve(Circle{frame, 1}), {0, 2 * pi});
    b.begin_face(b.add_surface(Sphere{frame, 1}), side < 0);
    b.add_coedge(e, false, Line2{{0, 0}, {1, 0}});
    b.close_loop();
    b.end_face();
    return take(b.build(Context{}));
  };
  EXPECT_EQ(united({cap(1), cap(1)}), "1/1/1");
  EXPECT_EQ(united({cap(1), cap(-1)}), "1/1/0");
}

TEST(Identity, AnEdgeThatGivesWayLeavesItsFaceANewImage) {
  // A rod on a rod, the upper one upside down: its rim runs the other way round and begins elsewhere on its own side.
  const ModelPtr lower = take(cylinder(1, 2));
  for (const double seam : {0.0, 40.0}) {
    const ModelPtr below = take(cylinder(1, 2, {}, {1, seam}));
    const ModelPtr upper = take(translate(*take(mirror(*below, {0, 0, 0}, {0, 0, 1})), {0, 0, 4}));
    const Fragment f = joined({below, upper});
    EXPECT_EQ(counts(*f.model), "2/5/5/3") << seam;
    EXPECT_NEAR(*total_volume(*f.model), 4 * pi, 1e-10);
  }
  // Two rims that are splines for one and arcs for the other have other parameters.
  const Fragment mixed = joined({take(disk(1)), take(rotate(*lower, 180, {1, 0, 0}))});
  EXPECT_EQ(counts(*mixed.model), "1/3/3/2");
}

TEST(Identity, NestedEllipsoidsOfRevolutionShareTheirFaces) {
  // As in an assembly: a hollow body, and what fills it, twice.
  const auto solid = [](std::initializer_list<test::EllipsoidShape> faces) {
    ModelBuilder b;
    for (const auto& face : faces) test::add_ellipsoid(b, face);
    return take(b.build(Context{}));
  };
  const ModelPtr outer = solid({{3, 2}, {2, 1, 0, false}}), middle = solid({{2, 1}, {1, 0.5, 0, false}}),
                 inner = solid({{1, 0.5}});
  const double unit = 4 * pi / 3;
  EXPECT_NEAR(*total_volume(*outer), unit * (18 - 4), 1e-6);
  const Fragment f = joined({outer, middle, inner});
  EXPECT_EQ(counts(*f.model), "3/3/3/6");
  EXPECT_NEAR(*total_volume(*f.model), unit * 18, 1e-6);
  // The general fuse gets what is known to be one, and leaves it alone.
  EXPECT_EQ(counts(*take(fragment({outer, middle, inner}, {}, {})).model), "3/3/3/6");
}

// --- One operand whose parts do not know of each other ---------------------------------------------------------------

/// Blocks in one model, each a region, nothing shared; and wires.
ModelPtr unshared(const std::vector<ModelPtr>& solids, const std::vector<ModelPtr>& wires = {}) {
  ModelBuilder b;
  Cells cells;
  std::vector<bool> filled{false};
  for (const ModelPtr& solid : solids) {
    append(b, *solid);
    for (std::size_t f = 0; f < solid->topology().face_count(); ++f) {
      cells.of_face_use.push_back(0);
      cells.of_face_use.push_back(cells.count);
    }
    ++cells.count;
    filled.push_back(true);
    cells.of_edge.resize(b.edge_count(), Incidence::none);
  }
  for (const ModelPtr& wire : wires) append(b, *wire);
  cells.of_edge.resize(b.edge_count(), 0);
  cells.of_vertex.assign(b.vertex_count(), Incidence::none);
  return take(b.build(cells, filled));
}

TEST(FragmentOfOne, TouchingPartsShareTheirFace) {
  const ModelPtr a = unshared({take(block(1, 1, 1)), take(block(1, 1, 1, {1, 0, 0}))});
  ASSERT_EQ(counts(*a), "2/12/24/16");
  const Fragment f = take(fragment({a}, {}, {}));
  EXPECT_EQ(counts(*f.model), "2/11/20/12");
  ASSERT_EQ(f.operands.size(), 1u);
  EXPECT_EQ(f.operands[0], a);
  std::set<RegionId> regions;
  for (const RegionId r : f.model->regions()) regions.insert(f.labels.region_of(0, r));
  EXPECT_EQ(regions.size(), 2u);
  int shared = 0;
  for (const FaceId face : f.model->topology().faces()) {
    const auto parents = f.parents(face);
    ASSERT_EQ(f.same_sense[face.index()].size(), parents.size());
    shared += parents.size() == 2 ? 1 : 0;
  }
  EXPECT_EQ(shared, 1);
}

TEST(FragmentOfOne, PartsThatTouchInPartOrOverlapAreCut) {
  const ModelPtr touching = unshared({take(block(1, 1, 1)), take(block(1, 1, 1, {1, 0.5, 0}))});
  const Fragment f = take(fragment({touching}, {}, {}));
  EXPECT_EQ(f.model->regions().size(), 2u);
  EXPECT_EQ(f.model->topology().face_count(), 13u);  // the common piece, and one more of each
  EXPECT_TRUE(require_valid(*f.model, CheckLevel::full).ok());
  const ModelPtr overlapping = unshared({take(block(2, 2, 2)), take(block(2, 2, 2, {1, 1, 1}))});
  const Fragment g = take(fragment({overlapping}, {}, {}));
  EXPECT_EQ(counts(*g.model), "3/18/36/22");
  EXPECT_NEAR(*total_volume(*g.model), 15, 1e-12);
  std::size_t of_both = 0;
  for (const RegionId r : g.model->regions()) of_both += g.parents(r).size() == 2 ? 1 : 0;
  EXPECT_EQ(of_both, 1u);
}

TEST(FragmentOfOne, WiresOnASolidsEdgesBecomeTheEdges) {
  // One along a whole edge, one along a half, one from the other half on and out, one across a face.
  const ModelPtr a =
      unshared({take(block(2, 2, 2))}, {take(line({0, 0, 0}, {2, 0, 0})), take(line({0, 2, 0}, {1, 2, 0})),
                                        take(line({1, 2, 2}, {3, 2, 2})), take(line({0, 0, 2}, {2, 2, 2}))});
  ASSERT_FALSE(require_valid(*a, CheckLevel::full).ok());
  const Fragment f = take(fragment({a}, {}, {}));
  EXPECT_TRUE(require_valid(*f.model, CheckLevel::full).ok());
  // Edges: 12, two of them cut in two, the piece that sticks out, the diagonal. Vertices: 8, two cuts, one end.
  EXPECT_EQ(counts(*f.model), "1/7/16/11");
}

TEST(FragmentOfOne, LabelsOfThePartsStay) {
  Model a = *unshared({take(block(1, 1, 1)), take(block(1, 1, 1, {1, 0, 0}))});
  a.labels.set_name(a.regions()[0], "left");
  a.labels.set_name(a.regions()[1], "right");
  const Fragment f = take(fragment({std::make_shared<const Model>(a)}, {}, {}));
  std::set<std::string> names;
  for (const RegionId r : f.model->regions()) names.insert(f.model->labels.name(r));
  EXPECT_EQ(names, (std::set<std::string>{"left", "right"}));
}

}  // namespace
}  // namespace aresta
