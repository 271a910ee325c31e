// SPDX-License-Identifier: Apache-2.0
// Radial order, shells, nesting and regions, on models written down by hand.
#include "model/builder.h"

#include <gtest/gtest.h>

#include "model/extract.h"
#include "model/inherit.h"
#include "model/measure.h"
#include "support/stitched.h"

namespace aresta {
namespace {

using test::Stitched;

RegionId behind(const Model& m, FaceId f) {
  return m.topology().region(FaceUse(f, 1));
}
RegionId before(const Model& m, FaceId f) {
  return m.topology().region(FaceUse(f, 0));
}
double volume(const Model& m, RegionId r) {
  const auto moments = measure(m, r);
  return moments.ok() ? moments->measure : -1;
}

TEST(Builder, BoxesInBoxesNestAndSideBySideOnesDoNot) {
  Stitched s;
  const auto outer = s.box({0, 0, 0}, {9, 9, 9}), middle = s.box({1, 1, 1}, {5, 5, 5}),
             inner = s.box({2, 2, 2}, {3, 3, 3});
  const auto beside = s.box({6, 6, 6}, {8, 8, 8}), apart = s.box({20, 0, 0}, {21, 1, 1});
  const auto model = s.build_all_filled();
  ASSERT_TRUE(model);
  EXPECT_EQ(model->regions().size(), 5u);
  EXPECT_EQ(before(*model, middle[0]), behind(*model, outer[0]));
  EXPECT_EQ(before(*model, beside[0]), behind(*model, outer[0]));
  EXPECT_EQ(before(*model, inner[0]), behind(*model, middle[0]));
  EXPECT_EQ(before(*model, apart[0]), Complex::infinite_region());
  EXPECT_EQ(before(*model, outer[0]), Complex::infinite_region());
  EXPECT_DOUBLE_EQ(volume(*model, behind(*model, outer[0])), 729 - 64 - 8);
  EXPECT_DOUBLE_EQ(volume(*model, behind(*model, middle[0])), 63);
  EXPECT_EQ(model->topology().shells(behind(*model, outer[0])).count(), 3u);
}

TEST(Builder, SheetsWiresAndPointsLieInTheirCells) {
  Stitched s;
  const auto outer = s.box({0, 0, 0}, {9, 9, 9});
  const auto inner = s.box({1, 1, 1}, {5, 5, 5});
  const FaceId sheet = s.face({{{2, 2, 2}, {4, 2, 2}, {4, 4, 2}, {2, 4, 2}}});
  const EdgeId wire_between = s.edge({6, 6, 6}, {7, 7, 7}), wire_out = s.edge({9, 9, 9}, {10, 10, 10}),
               wire_in = s.edge({9, 9, 0}, {8, 7, 1});
  const VertexId point_inner = s.vertex({3, 3, 3}), point_out = s.vertex({-1, 4, 4});
  const auto model = s.build_all_filled();
  ASSERT_TRUE(model);
  const Complex& k = model->topology();
  const RegionId shell = behind(*model, outer[0]), core = behind(*model, inner[0]);
  EXPECT_EQ(before(*model, sheet), core);
  EXPECT_EQ(behind(*model, sheet), core);
  EXPECT_EQ(k.region(k.wire_shell(wire_between)), shell);
  EXPECT_EQ(k.region(k.wire_shell(wire_in)), shell);
  EXPECT_EQ(k.region(k.wire_shell(wire_out)), Complex::infinite_region());
  EXPECT_EQ(k.region(k.isolated_in_shell(point_inner)), core);
  EXPECT_EQ(k.region(k.isolated_in_shell(point_out)), Complex::infinite_region());
  EXPECT_EQ(k.wire_shell(wire_out), k.shell(FaceUse(outer[0], 0)));  // it hangs on the box
  EXPECT_EQ(model->listed().size(), 2u + 3u + 1u + 2u);
}

TEST(Builder, FourBoxesAroundOneEdge) {
  Stitched s;
  const double c[] = {0, 1, 2};
  // Quarter boxes about the z axis through (1, 1), walls shared.
  for (int i = 0; i < 2; ++i) {
    s.face({{{c[i], 1, 0}, {c[i + 1], 1, 0}, {c[i + 1], 1, 1}, {c[i], 1, 1}}});
    s.face({{{1, c[i], 0}, {1, c[i + 1], 0}, {1, c[i + 1], 1}, {1, c[i], 1}}});
    for (int j = 0; j < 2; ++j) {
      for (const double z : {0.0, 1.0})
        s.face({{{c[i], c[j], z}, {c[i + 1], c[j], z}, {c[i + 1], c[j + 1], z}, {c[i], c[j + 1], z}}});
    }
    for (const double side : {0.0, 2.0}) {
      s.face({{{side, c[i], 0}, {side, c[i + 1], 0}, {side, c[i + 1], 1}, {side, c[i], 1}}});
      s.face({{{c[i], side, 0}, {c[i + 1], side, 0}, {c[i + 1], side, 1}, {c[i], side, 1}}});
    }
  }
  const auto model = s.build_all_filled();
  ASSERT_TRUE(model);
  EXPECT_EQ(model->regions().size(), 4u);
  for (const RegionId r : model->regions()) EXPECT_DOUBLE_EQ(volume(*model, r), 1);
  EXPECT_EQ(model->topology().coedges(s.edge({1, 1, 0}, {1, 1, 1})).count(), 4u);
}

TEST(Builder, MoebiusStripEnclosesNothing) {
  Stitched s;
  const auto ring = [](int i, double height) {
    const double a = 2 * M_PI * i / 3, half_turn = M_PI * i / 3, r = 3 + height * std::cos(half_turn);
    return Vec3{r * std::cos(a), r * std::sin(a), height * std::sin(half_turn)};
  };
  const auto corner = [&](int i, double h) { return i == 3 ? ring(0, -h) : ring(i, h); };
  for (int i = 0; i < 3; ++i) {  // triangles: quadrilaterals of a twisted strip are not plane
    s.face({{corner(i, 1), corner(i + 1, 1), corner(i, -1)}});
    s.face({{corner(i + 1, 1), corner(i + 1, -1), corner(i, -1)}});
  }
  const auto model = s.build_all_filled();
  ASSERT_TRUE(model);
  EXPECT_TRUE(model->regions().empty());
  EXPECT_EQ(model->topology().shell_count(), 1u);  // one-sided: both sides of every face hang together
}

TEST(Builder, TouchingInAVertexIsOneOuterShell) {
  Stitched s;
  s.box({0, 0, 0}, {1, 1, 1});
  s.box({1, 1, 1}, {2, 2, 2});
  const auto model = s.build_all_filled();
  ASSERT_TRUE(model);
  EXPECT_EQ(model->regions().size(), 2u);
  EXPECT_EQ(model->topology().shells(Complex::infinite_region()).count(), 1u);
}

TEST(Builder, RefusesWhatItCannotKnow) {
  {
    Stitched s;  // two faces with the same four edges, on top of each other, and a third below
    s.face({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
    s.face({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
    s.face({{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}});
    const auto cells = s.builder.find_cells({});
    ASSERT_FALSE(cells.ok());
    EXPECT_EQ(cells.error().code, errors::ambiguous_radial_order);
  }
  {
    Stitched s;  // an open solid
    s.face({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}});
    s.builder.set_fill(Fill::empty, Fill::filled);
    const auto model = s.builder.build({});
    ASSERT_FALSE(model.ok());
    EXPECT_EQ(model.error().code, errors::open_solid);
  }
  {
    Stitched s;  // a box whose last face says that its inside is empty
    s.box({0, 0, 0}, {1, 1, 1});
    s.builder.set_fill(Fill::empty, Fill::empty);
    s.box({3, 0, 0}, {4, 1, 1});
    s.builder.set_fill(Fill::empty, Fill::filled);
    const auto model = s.builder.build({});
    ASSERT_TRUE(model.ok());
    EXPECT_EQ(model->regions().size(), 1u);
  }
  {
    Stitched s;
    s.vertex({0, 0, std::nan("")});
    EXPECT_EQ(s.builder.build({}).error().code, errors::invalid_model);
  }
}

TEST(Builder, FacesTangentToAPlaneAreOrderedByCurvature) {
  // About the z axis: a plane sheet y = 0 (x > 0), and two quarter cylinders that leave it tangentially, above and
  // below.
  ModelBuilder b;
  const VertexId o0 = b.add_vertex({0, 0, 0}), o1 = b.add_vertex({0, 0, 1});
  const EdgeId axis = b.add_edge(o0, o1);
  const auto strip = [&](Surface surface, bool reversed, Vec3 far_low, Vec3 far_high,
                         std::optional<std::array<Curve2, 4>> images, std::optional<std::array<Curve, 2>> arcs) {
    const VertexId f0 = b.add_vertex(far_low), f1 = b.add_vertex(far_high);
    const EdgeId low = arcs ? b.add_edge(o0, f0, b.add_curve((*arcs)[0]), {0, M_PI / 2}) : b.add_edge(o0, f0);
    const EdgeId high = arcs ? b.add_edge(o1, f1, b.add_curve((*arcs)[1]), {0, M_PI / 2}) : b.add_edge(o1, f1);
    const EdgeId far = b.add_edge(f0, f1);
    const FaceId face = b.begin_face(b.add_surface(std::move(surface)), reversed);
    const EdgeId edges[] = {low, far, high, axis};
    const bool against[] = {false, false, true, true};
    for (int i = 0; i < 4; ++i)
      images ? b.add_coedge(edges[i], against[i], (*images)[i]) : b.add_coedge(edges[i], against[i]);
    b.close_loop();
    b.end_face();
    return face;
  };
  const FaceId plane =
      strip(Plane{Frame{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}, false, {2, 0, 0}, {2, 0, 1}, {}, {});
  // Cylinder of radius 1 about (0, 1): from (0, 0) to (1, 1), u = 0 at the axis edge.
  const Frame up{{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  const auto images = std::array<Curve2, 4>{Line2{{0, 0}, {1, 0}}, Line2{{M_PI / 2, 0}, {0, 1}}, Line2{{0, 1}, {1, 0}},
                                            Line2{{0, 0}, {0, 1}}};
  const auto lifted = [](Frame f) {
    f.origin.z = 1;
    return f;
  };
  const FaceId above = strip(Cylinder{up, 1}, false, {1, 1, 0}, {1, 1, 1}, images,
                             std::array<Curve, 2>{Circle{up, 1}, Circle{lifted(up), 1}});
  // Radius 2 about (0, 2): lies between the plane and the first cylinder.
  const Frame wide{{0, 2, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  const FaceId between = strip(Cylinder{wide, 2}, false, {2, 2, 0}, {2, 2, 1}, images,
                               std::array<Curve, 2>{Circle{wide, 2}, Circle{lifted(wide), 2}});
  auto model = b.build({});
  ASSERT_TRUE(model.ok()) << model.error().to_line();
  std::vector<FaceId> order;
  for (const CoedgeId c : model->topology().coedges(axis)) order.push_back(model->topology().face(c));
  EXPECT_EQ(order, (std::vector<FaceId>{plane, between, above}));
}

TEST(Extract, DroppedLooseEdgeLeavesItsFaceWhole) {
  Stitched s;
  const std::vector<Vec3> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  s.face({square, {{1, 1, 0}, {3, 1, 0}}, {{2, 2, 0}}});
  const auto model = s.build_all_filled();
  ASSERT_TRUE(model);
  Selection keep = empty_selection(*model);
  keep.faces[0] = true;
  close_downwards(*model, keep, false);
  const auto clean = extract(*model, keep);
  ASSERT_TRUE(clean.ok()) << clean.error().to_line();
  EXPECT_EQ(clean->model.topology().loops(FaceId(std::size_t{0})).count(), 1u);
  EXPECT_EQ(clean->model.topology().edge_count(), 4u);
  close_downwards(*model, keep, true);
  const auto whole = extract(*model, keep);
  ASSERT_TRUE(whole.ok());
  EXPECT_EQ(whole->model.topology().loops(FaceId(std::size_t{0})).count(), 3u);
}

TEST(Extract, DroppedBridgeSplitsALoopAndItsEndStaysAsAPoint) {
  Stitched s;  // outer loop, a dangling edge from its corner, whose tip is kept as a vertex
  const Vec3 tip{1, 1, 0};
  s.face({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, tip}});
  const auto model = s.build_all_filled();
  ASSERT_TRUE(model);
  ASSERT_EQ(model->topology().edge_count(), 5u);
  Selection keep = empty_selection(*model);
  keep.faces[0] = true;
  close_downwards(*model, keep, false);
  keep.vertices[s.vertex(tip).index()] = true;
  const auto result = extract(*model, keep);
  ASSERT_TRUE(result.ok()) << result.error().to_line();
  const Complex& k = result->model.topology();
  EXPECT_EQ(k.edge_count(), 4u);
  EXPECT_EQ(k.loops(FaceId(std::size_t{0})).count(), 2u);
  EXPECT_EQ(k.vertex_loops(VertexId(4)).size(), 1u);
}

TEST(Extract, AWallBetweenVolumeAndNothingMustBeKept) {
  Stitched s;
  s.box({0, 0, 0}, {1, 1, 1});
  const auto model = s.build_all_filled();
  Selection keep = empty_selection(*model);
  keep.filled[1] = true;
  const auto result = extract(*model, keep);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::ambiguous_fill);
}

TEST(InheritLabels, PriorityDecidesAndDisagreementIsReported) {
  Model a, b;
  const RegionId r(std::size_t{1});
  a.labels.attributes[r] = {{"material", std::string("steel")}, {"priority", 1.0}, {"name", std::string("shaft")}};
  b.labels.attributes[r] = {{"material", std::string("copper")}, {"priority", 2.0}};
  const auto merged = [&](bool with_priority) {
    if (!with_priority) b.labels.attributes[r].erase("priority");
    auto provenance = std::make_shared<Provenance>();
    provenance->sources = {std::make_shared<const Model>(a), std::make_shared<const Model>(b)};
    provenance->parents[r] = {{0, r}, {1, r}};
    Model result;
    result.provenance = provenance;
    const auto conflicts = inherit_labels(result);
    return std::pair(result.labels.attributes[r], conflicts.size());
  };
  auto [decided, none] = merged(true);
  EXPECT_EQ(std::get<std::string>(decided["material"]), "copper");
  EXPECT_EQ(none, 0u);
  auto [open, one] = merged(false);
  EXPECT_EQ(open.count("material"), 0u);
  EXPECT_EQ(std::get<std::string>(open["name"]), "shaft");
  EXPECT_EQ(one, 1u);
}

}  // namespace
}  // namespace aresta
