// SPDX-License-Identifier: Apache-2.0
// Every kind of finding has a smallest broken model; good models have none.
#include "model/check.h"

#include <gtest/gtest.h>

#include "model/check_break.h"
#include "model/measure_shapes.h"
#include "support/stitched.h"

using namespace aresta;
using namespace aresta::testing;
using aresta::test::Stitched;

namespace {

Model built(ModelBuilder& b) {
  auto model = b.build(Context{});
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().to_line());
  return model.ok() ? std::move(model).value() : Model{};
}

Model block() {
  Draft d;
  add_block(d, {0, 0, 0}, {1, 2, 3});
  return built(d.builder);
}

std::vector<Finding> found(const Model& m, CheckLevel level = CheckLevel::full) {
  auto findings = check(m, level);
  EXPECT_TRUE(findings.ok());
  return findings.ok() ? *findings : std::vector<Finding>{};
}

std::string list(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) text += std::string(to_string(f.kind)) + ": " + f.message + "\n";
  return text;
}

/// The finding of this kind; its evidence is the caller's to look at.
Finding only(const Model& m, FindingKind kind, CheckLevel level = CheckLevel::fast) {
  const auto findings = found(m, level);
  for (const Finding& f : findings) {
    if (f.kind == kind) return f;
  }
  ADD_FAILURE() << "no finding: " << to_string(kind) << "\n" << list(findings);
  return {};
}

bool names(const Finding& f, EntityRef e) {
  return std::find(f.entities.begin(), f.entities.end(), e) != f.entities.end();
}

void expect_good(const Model& m) {
  EXPECT_EQ(list(found(m)), "");
  EXPECT_TRUE(require_valid(m, CheckLevel::full).ok());
}

}  // namespace

TEST(CheckGood, Solids) {
  for (const Transform& t : {Transform{}, Transform::rotation(33, {1, 2, 3}), Transform::scaling(1e-5),
                             Transform::reflection({}, {1, 0.5, 0}), Transform::translation({1e4, 1e5, -1e4})}) {
    const auto good = [&](auto add) {
      Draft d(t);
      add(d);
      expect_good(built(d.builder));
    };
    good([](Draft& d) { add_block(d, {0, 0, 0}, {1, 2, 3}); });
    good([](Draft& d) { add_frame(d); });
    for (const Seam seam : {Seam::none, Seam::bare, Seam::with_images}) {
      good([&](Draft& d) { add_frustum(d, 2, 2, 5, seam); });
      good([&](Draft& d) { add_frustum(d, 3, 1, 5, seam); });
      good([&](Draft& d) { add_frustum(d, 3, 0, 5, seam); });
      good([&](Draft& d) { add_sphere(d, 3, seam); });
      good([&](Draft& d) { add_torus(d, 5, 2, seam); });
    }
    for (const double c : {-1.5, 0.0, 1.5}) {
      good([&](Draft& d) { add_cap(d, 2, c); });
      good([&](Draft& d) { add_side_cap(d, 2, c); });
    }
    good([](Draft& d) { add_half_torus(d, 5, 2); });
    good([](Draft& d) { add_upper_torus(d, 5, 2); });
    good([](Draft& d) { add_oblique(d, 2, 5, 0.75); });
    good([](Draft& d) { add_steinmetz(d, 2); });
  }
}

TEST(CheckGood, SheetsWiresPointsAndEmptyCells) {
  Stitched s;
  s.box({0, 0, 0}, {9, 9, 9});
  s.box({1, 1, 1}, {5, 5, 5});
  s.face({{{2, 2, 2}, {4, 2, 2}, {4, 4, 2}, {2, 4, 2}}, {{2.5, 2.5, 2}, {3, 3, 2}}, {{3.5, 3.5, 2}}});
  s.face({{{9, 9, 9}, {9, 12, 9}, {9, 12, 12}}});  // hangs on a vertex of the box
  s.edge({6, 6, 6}, {7, 7, 7});
  s.edge({9, 9, 0}, {8, 7, 1});
  s.vertex({8, 1, 1});
  s.vertex({-8, 1, 1});
  auto cells = s.builder.find_cells(Context{});
  ASSERT_TRUE(cells.ok());
  auto empty = s.builder.build(*cells, std::vector<bool>(cells->count, false));
  ASSERT_TRUE(empty.ok());
  expect_good(*empty);
  std::vector<bool> filled(cells->count, true);
  filled[0] = false;
  auto full = s.builder.build(*cells, filled);
  ASSERT_TRUE(full.ok());
  expect_good(*full);
}

TEST(CheckGood, NonManifoldEdgesAndMoebius) {
  Stitched fan;  // five sheets around one edge
  for (int i = 0; i < 5; ++i) {
    const double a = 1.1 * i;
    fan.face({{{0, 0, 0}, {0, 0, 1}, {std::cos(a), std::sin(a), 1}, {std::cos(a), std::sin(a), 0}}});
  }
  expect_good(built(fan.builder));
  // A Moebius band of five plane quadrilaterals cannot be plane; of triangles it can: the five-vertex band, made here
  // of the triangles i, i + 1, i + 2 (mod 5) of points in general position.
  Stitched band;
  const Vec3 p[] = {{1, 0, 0}, {0.3, 0.95, 0.8}, {-0.81, 0.59, -0.3}, {-0.81, -0.59, 1.1}, {0.31, -0.95, -0.9}};
  for (int i = 0; i < 5; ++i) band.face({{p[i], p[(i + 1) % 5], p[(i + 2) % 5]}});
  const Model m = built(band.builder);
  EXPECT_EQ(list(found(m, CheckLevel::fast)), "");
}

TEST(CheckGood, TangentContacts) {
  // A quarter cylinder that leaves a plane tangentially, as a fillet does, both as sheets with a shared edge.
  Draft d;
  const VertexId a = d.vertex({0, 0, 0}), b = d.vertex({0, 4, 0}), c = d.vertex({2, 0, 2}), e = d.vertex({2, 4, 2}),
                 f = d.vertex({-3, 0, 0}), g = d.vertex({-3, 4, 0});
  const Frame axis{{0, 0, 2}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};  // from straight below towards x
  const EdgeId ab = d.segment(a, b), ce = d.segment(c, e), fg = d.segment(f, g), fa = d.segment(f, a),
               gb = d.segment(g, b);
  const EdgeId ac = d.arc(a, c, Circle{axis, 2}, 0, pi / 2);
  const EdgeId be = d.arc(b, e, Circle{{{0, 4, 2}, axis.x, axis.y, axis.z}, 2}, 0, pi / 2);
  d.face(Cylinder{axis, 2}, true, {{along(ac), along(ce), against(be), against(ab)}}, false);
  d.face(Plane{}, false, {{along(fa), along(ab), against(gb), against(fg)}}, false);
  expect_good(built(d.builder));
}

TEST(CheckStructure, OpenLoop) {
  const Model m = with_incidence(block(), [](Incidence& in) { in.coedges[1] ^= 1u; });
  const Finding f = only(m, FindingKind::loop_open);
  EXPECT_TRUE(names(f, FaceId(0))) << f.message;
}

TEST(CheckStructure, BrokenRadialCycle) {
  const Model m = with_incidence(block(), [](Incidence& in) {
    // Coedges 0 and 1 are of different edges: their cycles become one.
    std::swap(in.radial_next[0], in.radial_next[1]);
  });
  const Finding f = only(m, FindingKind::radial_cycle_broken);
  EXPECT_EQ(f.entities.size(), 1u);
}

TEST(CheckStructure, SectorInTwoRegions) {
  Model m = block();
  Complex& k = ModelAccess::topology(m);
  ModelAccess::set_shell(k, FaceUse(FaceId(0), 1), k.shell(FaceUse(FaceId(0), 0)));  // both sides of face 0 outside
  const Finding f = only(m, FindingKind::sector_in_two_regions);
  EXPECT_TRUE(names(f, FaceId(0))) << f.message;
}

TEST(CheckStructure, DisconnectedShell) {
  Draft d;
  add_block(d, {0, 0, 0}, {1, 1, 1});
  add_block(d, {3, 0, 0}, {4, 1, 1});
  Model m = built(d.builder);
  Complex& k = ModelAccess::topology(m);
  const ShellId outside = k.shell(FaceUse(FaceId(0), 0));
  ASSERT_NE(k.shell(FaceUse(FaceId(6), 0)), outside);
  for (std::size_t f = 6; f < 12; ++f) ModelAccess::set_shell(k, FaceUse(FaceId(f), 0), outside);
  const Finding apart = only(m, FindingKind::shell_disconnected);
  EXPECT_TRUE(names(apart, FaceId(0)) && names(apart, FaceId(6))) << apart.message;
}

TEST(CheckStructure, UnboundedRegion) {
  const Model filled = with_incidence(block(), [](Incidence& in) { in.region_filled[0] = true; });
  EXPECT_TRUE(names(only(filled, FindingKind::region_unbounded), Complex::infinite_region()));
  const Model spare = with_incidence(block(), [](Incidence& in) {
    ++in.region_count;
    in.region_filled.push_back(true);
  });
  EXPECT_TRUE(names(only(spare, FindingKind::region_unbounded), RegionId(2)));
}

TEST(CheckStructure, DuplicateEdge) {
  ModelBuilder b;
  const VertexId u = b.add_vertex({0, 0, 0}), v = b.add_vertex({1, 0, 0});
  const EdgeId first = b.add_edge(u, v), second = b.add_edge(v, u);
  const Finding f = only(built(b), FindingKind::duplicate_edge);
  EXPECT_TRUE(names(f, first) && names(f, second));

  ModelBuilder arcs;  // the upper half circle twice, by two curves; the lower one is no duplicate
  const VertexId p = arcs.add_vertex({1, 0, 0}), q = arcs.add_vertex({-1, 0, 0});
  const EdgeId up = arcs.add_edge(p, q, arcs.add_curve(Circle{{}, 1}), {0, pi});
  arcs.add_edge(q, p, arcs.add_curve(Circle{{}, 1}), {pi, 2 * pi});
  const EdgeId again = arcs.add_edge(q, p, arcs.add_curve(Circle{{{}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, 1}), {0, pi});
  const auto findings = found(built(arcs), CheckLevel::fast);
  ASSERT_EQ(findings.size(), 1u) << list(findings);
  EXPECT_EQ(findings[0].entities, (std::vector<EntityRef>{up, again}));
}

TEST(CheckStructure, IsolatedUse) {
  Draft d;
  add_block(d, {0, 0, 0}, {1, 2, 3});
  const VertexId lost = d.vertex({5, 5, 5});
  const Model m =
      with_incidence(built(d.builder), [&](Incidence& in) { in.vertex_region[lost.index()] = Incidence::none; });
  EXPECT_EQ(only(m, FindingKind::isolated_use).entities, std::vector<EntityRef>{lost});
  const Model wire = with_incidence(block(), [](Incidence& in) {
    in.edges.push_back({0, 6});
    in.edge_region.push_back(Incidence::none);  // no loop, no region
  });
  EXPECT_EQ(found(wire, CheckLevel::fast)[0].kind, FindingKind::isolated_use);
}

TEST(CheckGeometry, NotFinite) {
  Model m = block();
  ModelAccess::points(m).edit(3) = {0, std::nan(""), 0};
  EXPECT_TRUE(names(only(m, FindingKind::not_finite), VertexId(3)));
  Model range = block();
  ModelAccess::edges(range).edit(2).range.high = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(names(only(range, FindingKind::not_finite), EdgeId(2)));
  Model surface = block();
  ModelAccess::surfaces(surface)[0] = Plane{{{std::nan(""), 0, 0}}};
  EXPECT_TRUE(names(only(surface, FindingKind::not_finite), FaceId(0)));
}

TEST(CheckGeometry, VertexOffCurve) {
  Draft d;
  add_cap(d, 2, 1);
  Model m = built(d.builder);
  ModelAccess::points(m).edit(0) = m.point(VertexId(0)) + Vec3{1e-4, 0, 0};
  const Finding f = only(m, FindingKind::vertex_off_curve);
  EXPECT_NEAR(f.value, 1e-4, 1e-12);
  EXPECT_LT(f.allowed, 1e-7);
  EXPECT_EQ(f.entities, (std::vector<EntityRef>{VertexId(0), EdgeId(0)}));
  EXPECT_NE(f.message.find("edge 0 starts 0.0001 away from vertex 0"), std::string::npos) << f.message;
  ModelAccess::vertex_tolerance(m).edit(0) = 1.1e-4;
  EXPECT_EQ(list(found(m)), "") << "within its tolerance";
}

TEST(CheckGeometry, VertexOffSurface) {
  Model m = block();
  ModelAccess::points(m).edit(6) = m.point(VertexId(6)) + Vec3{0, 0, 1e-3};  // off the top, along the sides
  const Finding f = only(m, FindingKind::vertex_off_surface);
  EXPECT_EQ(f.entities, (std::vector<EntityRef>{VertexId(6), FaceId(1)}));
  EXPECT_NEAR(f.value, 1e-3, 1e-12);

  Draft ball;
  add_sphere(ball, 2, Seam::none);
  Model loose = built(ball.builder);
  ModelAccess::points(loose).edit(0) = {2.5, 0, 0};
  EXPECT_NEAR(only(loose, FindingKind::vertex_off_surface).value, 0.5, 1e-12);
}

TEST(CheckGeometry, EdgeOffSurfaceAndImageOff) {
  Draft d;
  add_frustum(d, 2, 2, 5, Seam::with_images);
  Model radius = built(d.builder);
  ModelAccess::surfaces(radius)[0] = Cylinder{Frame{}, 2.001};
  const Finding off = only(radius, FindingKind::edge_off_surface);
  EXPECT_NEAR(off.value, 1e-3, 1e-9);
  EXPECT_TRUE(names(off, FaceId(0)));

  Draft e;
  add_frustum(e, 2, 2, 5, Seam::with_images);
  Model image = built(e.builder);
  ModelAccess::pcurves(image)[1] = Line2{{2 * pi, 0.001}, {0, 1}};  // of the seam
  const Finding moved = only(image, FindingKind::pcurve_off);
  EXPECT_NEAR(moved.value, 1e-3, 1e-9);
  EXPECT_EQ(moved.entities.size(), 2u);
}

TEST(CheckGeometry, DegenerateEdge) {
  ModelBuilder b;
  const EdgeId e = b.add_edge(b.add_vertex({0, 0, 0}), b.add_vertex({1e-10, 0, 0}));
  b.add_edge(b.add_vertex({1, 0, 0}), b.add_vertex({1, 1, 0}));
  EXPECT_TRUE(names(only(built(b), FindingKind::edge_degenerate), e));
  Model range = block();
  ModelAccess::edges(range).edit(4).range = {1, 1};
  EXPECT_TRUE(names(only(range, FindingKind::edge_degenerate), EdgeId(4)));
}

TEST(CheckGeometry, LoopNotClosedInSurface) {
  Draft d;
  add_frustum(d, 2, 2, 5, Seam::with_images);
  Model m = built(d.builder);
  // Up to the top circle and back: without the bottom circle's turn the loop does not close in u.
  ModelAccess::pcurves(m)[0] = Ellipse2{{0, 0}, {1, 0}, {0, 1}, 1e-3, 1e-3};
  const auto findings = found(m, CheckLevel::fast);
  EXPECT_NE(list(findings).find("loop not closed in surface"), std::string::npos) << list(findings);
}

TEST(CheckGeometry, FaceInverted) {
  Stitched s;
  s.face({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  Model m = built(s.builder);
  ModelAccess::faces(m).edit(0).reversed = true;
  const Finding f = only(m, FindingKind::face_inverted);
  EXPECT_EQ(f.entities, std::vector<EntityRef>{FaceId(0)});
  EXPECT_DOUBLE_EQ(f.value, -1);
}

TEST(CheckGeometry, FaceDegenerate) {
  Stitched s;
  s.face({{{0, 0, 0}, {1, 0, 0}, {1, 1e-10, 0}, {0, 1e-10, 0}}});
  const Model m = built(s.builder);
  EXPECT_TRUE(names(only(m, FindingKind::face_degenerate), FaceId(0)));
}

TEST(CheckGeometry, LoopsIntersect) {
  Stitched s;  // a hole that reaches across the outer loop, and a bow tie
  s.face({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{3, 1, 0}, {3, 2, 0}, {5, 2, 0}, {5, 1, 0}}});
  s.face({{{0, 0, 9}, {4, 0, 9}, {4, 3, 9}, {1, -1, 9}}});
  const auto findings = found(built(s.builder), CheckLevel::fast);
  int first = 0, second = 0;
  for (const Finding& f : findings) {
    if (f.kind != FindingKind::loops_intersect) continue;
    first += names(f, FaceId(0));
    second += names(f, FaceId(1));
    EXPECT_LT(f.value, 1e-9);
  }
  EXPECT_EQ(first, 2);
  EXPECT_EQ(second, 1);

  Draft d;  // two circles on a plane that cross
  const VertexId a = d.vertex({2, 0, 0}), b = d.vertex({2.5, 0, 0});
  const EdgeId outer = d.arc(a, a, Circle{{}, 2}, 0, 2 * pi);
  const EdgeId inner = d.arc(b, b, Circle{{{1.5, 0, 0}}, 1}, 0, 2 * pi);
  d.face(Plane{}, false, {{along(outer)}, {against(inner)}}, false);
  const Finding f = only(built(d.builder), FindingKind::loops_intersect);
  EXPECT_NEAR(f.place.x, (4 - 1 + 2.25) / 3, 1e-6);
}

TEST(CheckGeometry, RegionInverted) {
  // The filled region is named on the wrong side: cell 1 outside, 0 inside.
  const Model m = with_incidence(block(), [](Incidence& in) {
    for (std::uint32_t& r : in.face_use_region) r = 1 - r;
  });
  const Finding f = only(m, FindingKind::region_inverted);
  EXPECT_EQ(f.entities, std::vector<EntityRef>{RegionId(1)});
  EXPECT_NEAR(f.value, -6, 1e-12);
}

TEST(CheckGeometry, RadialOrderWrong) {
  Stitched fan;
  for (int i = 0; i < 4; ++i) {
    const double a = 1.3 * i;
    fan.face({{{0, 0, 0}, {0, 0, 1}, {std::cos(a), std::sin(a), 1}, {std::cos(a), std::sin(a), 0}}});
  }
  const Model good = built(fan.builder);
  const Model m = with_incidence(good, [&](Incidence& in) {
    // Three of the four uses in another order.
    std::vector<std::uint32_t> uses;
    for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
      if (in.coedges[c] >> 1 == 0) uses.push_back(c);
    }
    ASSERT_EQ(uses.size(), 4u);
    const std::uint32_t order[] = {uses[0], uses[2], uses[1], uses[3]};
    for (int i = 0; i < 4; ++i) in.radial_next[order[i]] = order[(i + 1) % 4];
  });
  EXPECT_TRUE(names(only(m, FindingKind::radial_order_wrong), EdgeId(0)));
  EXPECT_EQ(list(found(good)), "");
}

TEST(CheckGeometry, TolerancesNotNested) {
  Model m = block();
  ModelAccess::edges(m).edit(0).tolerance = 1e-3;
  EXPECT_TRUE(names(only(m, FindingKind::tolerances_not_nested), EdgeId(0)));
  Model face = block();
  ModelAccess::faces(face).edit(0).tolerance = 1e-3;
  EXPECT_TRUE(names(only(face, FindingKind::tolerances_not_nested), FaceId(0)));
  Model negative = block();
  ModelAccess::vertex_tolerance(negative).edit(2) = -1;
  EXPECT_TRUE(names(only(negative, FindingKind::tolerances_not_nested), VertexId(2)));
}

TEST(Check, OrderMessagesAndCancelling) {
  Model m = block();
  ModelAccess::points(m).edit(6) = m.point(VertexId(6)) + Vec3{1e-3, 1e-3, 1e-3};
  const auto findings = found(m, CheckLevel::fast);
  ASSERT_EQ(findings.size(), 3u) << list(findings);
  EXPECT_TRUE(std::is_sorted(findings.begin(), findings.end(),
                             [](const Finding& a, const Finding& b) { return a.entities < b.entities; }));
  const Status status = require_valid(m, CheckLevel::fast);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, errors::invalid_model);
  EXPECT_NE(status.error().message.find("3 defects"), std::string::npos);
  EXPECT_NE(status.error().message.find("vertex 6 is 0.001 away from the surface of face"), std::string::npos);
  EXPECT_TRUE(std::find(status.error().entities.begin(), status.error().entities.end(), EntityRef(VertexId(6))) !=
              status.error().entities.end());
  EXPECT_TRUE(status.error().place.has_value());

  const std::atomic<bool> stop = true;
  Context cancelled;
  cancelled.cancel = &stop;
  EXPECT_EQ(check(m, CheckLevel::full, cancelled).error().code, errors::cancelled);
  EXPECT_TRUE(check(Model(), CheckLevel::full)->empty());
}
