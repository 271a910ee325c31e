// SPDX-License-Identifier: Apache-2.0
// Trims and rays: inside, outside and boundary on every surface, with and without seams.
#include "model/query.h"

#include <gtest/gtest.h>

#include "model/measure_shapes.h"
#include "support/ellipsoid.h"

using namespace aresta;
using namespace aresta::testing;

namespace {

Model built(Draft& d) {
  auto model = d.builder.build(Context{});
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().to_line());
  return model.ok() ? std::move(model).value() : Model{};
}

/// Compares the trim of a face with a condition on points of space, over a grid of its surface's parameters.
template <class Inside>
void compare(const Model& model, FaceId face, Range u, Range v, Inside inside) {
  const FaceTrim trim(model, face);
  const Surface& surface = model.surface(face);
  int in = 0;
  for (int i = 0; i < 37; ++i) {
    for (int j = 0; j < 41; ++j) {
      const Vec2 uv{u.at((i + 0.5137) / 37), v.at((j + 0.4871) / 41)};
      const bool expected = inside(surface.point(uv));
      in += expected;
      ASSERT_EQ(trim.locate(uv, 1e-9), expected ? Position::inside : Position::outside) << "uv " << uv.x << ' ' << uv.y;
      // Another period is the same point.
      const Vec2 period = surface.period();
      ASSERT_EQ(trim.locate(uv + 2 * period, 1e-9), expected ? Position::inside : Position::outside);
      ASSERT_EQ(trim.locate(uv - period, 1e-9), expected ? Position::inside : Position::outside);
    }
  }
  EXPECT_GT(in, 0);
  const auto point = trim.interior_point();
  ASSERT_TRUE(point.ok()) << point.error().to_line();
  EXPECT_TRUE(inside(surface.point(*point)));
}

const Range turn{0, 2 * pi};

}  // namespace

TEST(FaceTrim, PlaneWithHole) {
  Draft d;
  add_frame(d);
  const Model m = built(d);
  compare(m, FaceId(0), {-5, 5}, {-5, 5}, [](Vec3 p) {
    const bool hole = p.x > 1 && p.x < 3 && p.y > 1 && p.y < 3;
    return p.x > 0 && p.x < 4 && p.y > 0 && p.y < 4 && !hole;
  });
  const FaceTrim trim(m, FaceId(1));
  const auto at = [&](Vec3 p, double tolerance) { return trim.locate(m.surface(FaceId(1)).project(p).uv, tolerance); };
  EXPECT_EQ(at({0, 2, 1}, 0), Position::boundary);
  EXPECT_EQ(at({1, 2, 1}, 0), Position::boundary);
  EXPECT_EQ(at({0.009, 2, 1}, 0.01), Position::boundary);
  EXPECT_EQ(at({0.011, 2, 1}, 0.01), Position::inside);
  EXPECT_EQ(at({-0.011, 2, 1}, 0.01), Position::outside);
  EXPECT_EQ(at({4.006, 4.006, 1}, 0.01), Position::boundary) << "distance to the corner";
  EXPECT_EQ(at({4.008, 4.008, 1}, 0.01), Position::outside);
}

TEST(FaceTrim, ThinTriangles) {
  for (const double width : {1e-3, 1e-5, 1e-7}) {
    ModelBuilder b;
    const VertexId v[3] = {b.add_vertex({0, 0, 0}), b.add_vertex({1, 0, 0}), b.add_vertex({1, width, 0})};
    b.begin_face(b.add_surface(Plane{Frame{}}), false);
    for (int i = 0; i < 3; ++i) b.add_coedge(b.add_edge(v[i], v[(i + 1) % 3]), false);
    b.close_loop();
    b.end_face();
    Result<Model> m = b.build({});
    ASSERT_TRUE(m.ok()) << m.error().to_line();
    const FaceTrim trim(*m, FaceId(0));
    const auto at = [&](Vec3 p) { return trim.locate(m->surface(FaceId(0)).project(p).uv, 1e-9); };
    EXPECT_EQ(at({0.7, 0.3 * width, 0}), Position::inside) << width;
    EXPECT_EQ(at({0.7, 2 * width, 0}), Position::outside) << width;
    EXPECT_EQ(at({0.7, -2 * width, 0}), Position::outside) << width;
    EXPECT_EQ(at({0.3, 0.3, 0}), Position::outside) << width;
  }
}

TEST(FaceTrim, CylinderConeSphereTorus) {
  for (const Seam seam : {Seam::none, Seam::bare, Seam::with_images}) {
    SCOPED_TRACE(static_cast<int>(seam));
    Draft cylinder, cone, torus, sphere;
    add_frustum(cylinder, 2, 2, 5, seam);
    compare(built(cylinder), FaceId(0), turn, {-3, 9}, [](Vec3 p) { return p.z > 0 && p.z < 5; });
    add_frustum(cone, 3, 0, 4, seam);
    compare(built(cone), FaceId(0), turn, {-3, 4.99}, [](Vec3 p) { return p.z > 0; });
    add_torus(torus, 5, 2, seam);
    compare(built(torus), FaceId(0), turn, turn, [](Vec3) { return true; });
    add_sphere(sphere, 2, seam);
    compare(built(sphere), FaceId(0), turn, {-pi / 2, pi / 2}, [](Vec3) { return true; });
  }
}

TEST(FaceTrim, CapsAndHalves) {
  const Range latitude{-pi / 2, pi / 2};
  for (const double c : {-1.5, 0.0, 1.5}) {
    for (const bool mirror : {false, true}) {
      SCOPED_TRACE(c);
      const Transform t = mirror ? Transform::reflection({}, {1, 2, 3}) : Transform{};
      const auto back = [&](Vec3 p) { return t.point(p); };  // a reflection is its own inverse
      Draft top(t), side(t);
      add_cap(top, 2, c);
      compare(built(top), FaceId(0), turn, latitude, [&](Vec3 p) { return back(p).z > c; });
      add_side_cap(side, 2, c);
      compare(built(side), FaceId(0), turn, latitude, [&](Vec3 p) { return back(p).x > c; });
    }
  }
  Draft half, upper, oblique;
  add_half_torus(half, 5, 2);
  compare(built(half), FaceId(0), turn, turn, [](Vec3 p) { return p.y > 0; });
  add_upper_torus(upper, 5, 2);
  compare(built(upper), FaceId(0), turn, turn, [](Vec3 p) { return p.z > 0; });
  add_oblique(oblique, 2, 5, 0.75);
  compare(built(oblique), FaceId(0), turn, {-2, 9}, [](Vec3 p) { return p.z > 0 && p.z < 5 + 0.75 * p.x; });
  Draft steinmetz;
  add_steinmetz(steinmetz, 2);
  compare(built(steinmetz), FaceId(0), turn, {-3, 3}, [](Vec3 p) { return p.y > 0 && std::abs(p.x) < p.y; });
}

TEST(FaceTrim, CurvedBoundaryIsAsPreciseAsAsked) {
  Draft d;
  add_cap(d, 2, 0);
  const Model m = built(d);
  const FaceTrim trim(m, FaceId(1));  // the disc of radius 2
  for (int i = 0; i < 100; ++i) {
    const double a = 0.0628 * i + 0.01;
    const auto at = [&](double r) {
      return trim.locate(m.surface(FaceId(1)).project({r * std::cos(a), r * std::sin(a), 0}).uv, 1e-7);
    };
    EXPECT_EQ(at(2 - 2e-7), Position::inside);
    EXPECT_EQ(at(2 - 0.5e-7), Position::boundary);
    EXPECT_EQ(at(2 + 0.5e-7), Position::boundary);
    EXPECT_EQ(at(2 + 2e-7), Position::outside);
  }
}

TEST(FaceTrim, ParametersThatRunRoundTheAxisSecond) {
  // v runs round the axis and u ends in the poles: the seam's two images lie a turn apart, on either side of the poles.
  ModelBuilder b;
  test::add_ellipsoid(b, {3, 2, 0.4});
  test::add_ellipsoid(b, {2, 1, 0.0, false});
  const Model hollow = *b.build(Context{});
  ASSERT_EQ(hollow.regions().size(), 1u) << "the inner face is inside the outer one";
  for (const FaceId f : hollow.topology().faces()) {
    const Range2 box = FaceTrim(hollow, f).box();
    EXPECT_NEAR(box.v.length(), 4, 1e-12);
    compare(hollow, f, {0, 2}, {0, 4}, [](Vec3) { return true; });
  }
  const RayCaster caster(hollow);
  for (const double angle : {0.3, 1.9, 3.6, 5.5}) {
    const auto hits = caster.cast({0.1, 0.05, 0.02}, normalized(Vec3{std::cos(angle), std::sin(angle), 0.2}));
    ASSERT_EQ(hits.size(), 2u) << angle;
    EXPECT_EQ(hits[0].face, FaceId(std::size_t{1}));
    EXPECT_EQ(hits[1].face, FaceId(std::size_t{0}));
  }
}

TEST(RayCaster, BlockAndSphere) {
  Draft d;
  add_block(d, {0, 0, 0}, {2, 3, 4});
  const Model m = built(d);
  const RayCaster caster(m);
  const auto hits = caster.cast({-1, 1, 1.5}, {1, 0, 0});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_DOUBLE_EQ(hits[0].t, 1);
  EXPECT_DOUBLE_EQ(hits[1].t, 3);
  EXPECT_EQ(hits[0].facing.side(), 0);
  EXPECT_EQ(hits[1].facing.side(), 1);
  EXPECT_FALSE(hits[0].doubtful || hits[1].doubtful);
  // Through an edge, and along a face: in doubt.
  const auto edge = caster.cast({-1, 1, 0}, {1, 0, 0});
  ASSERT_FALSE(edge.empty());
  EXPECT_TRUE(edge[0].doubtful);
  const auto along_face = caster.cast({-1, 1, 4}, {1, 0, 0});
  ASSERT_FALSE(along_face.empty());
  for (const RayHit& h : along_face) EXPECT_TRUE(h.doubtful);
  EXPECT_TRUE(caster.cast({-1, 1, 5}, {1, 0, 0}).empty());
  EXPECT_EQ(caster.cast({1, 1, 1}, {1, 0, 0}).size(), 1u);
  EXPECT_TRUE(caster.cast({2, 1, 1}, {1, 0, 0}).empty()) << "a ray that starts on a face does not meet it";

  Draft s;
  add_sphere(s, 2, Seam::none);
  const Model ball = built(s);
  const RayCaster sphere(ball);
  const auto through = sphere.cast({0.5, 0.25, -5}, {0, 0, 1});
  ASSERT_EQ(through.size(), 2u);
  EXPECT_NEAR(through[0].t, 5 - std::sqrt(4 - 0.3125), 1e-12);
  EXPECT_NEAR(through[1].t, 5 + std::sqrt(4 - 0.3125), 1e-12);
  const auto touching = sphere.cast({2, 0, -5}, {0, 0, 1});
  for (const RayHit& h : touching) EXPECT_TRUE(h.doubtful);
}

namespace {

/// A block with a void, a wire and a point inside, and a point outside.
struct Nested {
  Draft d;
  VertexId inner_point, outer_point;
  EdgeId wire;
  Nested() {
    add_block(d, {0, 0, 0}, {10, 10, 10});
    // Inside out: its front looks into the void.
    add_polyhedron(d, {{3, 3, 3}, {6, 3, 3}, {3, 6, 3}, {3, 3, 6}},
                   {{{0, 1, 2}}, {{0, 3, 1}}, {{1, 3, 2}}, {{2, 3, 0}}});
    wire = d.segment(d.vertex({8, 8, 1}), d.vertex({8, 8, 9}));
    inner_point = d.vertex({1, 1, 9});
    outer_point = d.vertex({20, 20, 20});
  }
};

}  // namespace

TEST(Locate, EveryKindOfEntity) {
  Nested n;
  const Model m = built(n.d);
  ASSERT_EQ(m.regions().size(), 1u);
  ASSERT_EQ(m.topology().region_count(), 3u);
  const RegionId solid = m.regions()[0];
  const RegionId empty(3u - solid.index());
  const auto at = [&](Vec3 p) {
    const auto r = locate_point(m, p, 1e-6);
    EXPECT_TRUE(r.ok());
    return r.ok() ? *r : EntityRef();
  };
  EXPECT_EQ(at({0, 0, 0}), EntityRef(VertexId(0)));
  EXPECT_EQ(at({1, 1, 9}), EntityRef(n.inner_point));
  EXPECT_EQ(at({20, 20, 20}), EntityRef(n.outer_point));
  EXPECT_EQ(at({8, 8, 5 + 1e-7}), EntityRef(n.wire));
  EXPECT_EQ(at({0, 5, 0}).kind, EntityKind::edge);
  EXPECT_EQ(at({0, 5, 5}).kind, EntityKind::face);
  EXPECT_EQ(at({4, 4, 3 - 9e-7}).kind, EntityKind::face);
  EXPECT_EQ(at({5, 5, 5}), EntityRef(solid));
  EXPECT_EQ(at({3.5, 3.5, 3.5}), EntityRef(empty));
  EXPECT_EQ(at({-1, 5, 5}), EntityRef(Complex::infinite_region()));
  EXPECT_FALSE(locate_point(m, {std::nan(""), 0, 0}, 1e-6).ok());

  const auto in = [&](RegionId r, Vec3 p) { return *point_in_region(m, r, p, 1e-6); };
  EXPECT_EQ(in(solid, {5, 5, 5}), Position::inside);
  EXPECT_EQ(in(solid, {3.5, 3.5, 3.5}), Position::outside);
  EXPECT_EQ(in(solid, {3.5, 3.5, 3}), Position::boundary);
  EXPECT_EQ(in(empty, {3.5, 3.5, 3.5}), Position::inside);
  EXPECT_EQ(in(solid, {11, 5, 5}), Position::outside);
  EXPECT_EQ(in(solid, {10, 10, 5}), Position::boundary);
  EXPECT_FALSE(point_in_region(m, RegionId(7), {}, 1e-6).ok());
}

TEST(Locate, InteriorPointsDistancesAndNearest) {
  Nested n;
  const Model m = built(n.d);
  const RegionId solid = m.regions()[0];
  for (const RegionId r : m.topology().regions()) {
    const auto p = interior_point(m, r);
    ASSERT_TRUE(p.ok()) << p.error().to_line();
    EXPECT_EQ(*point_in_region(m, r, *p, 1e-3), Position::inside);
  }
  EXPECT_DOUBLE_EQ(*distance_to(m, VertexId(0), {3, 4, 0}), 5);
  EXPECT_DOUBLE_EQ(*distance_to(m, n.wire, {8, 5, 13}), 5);
  EXPECT_DOUBLE_EQ(*distance_to(m, solid, {5, 5, 5}), 0);
  EXPECT_DOUBLE_EQ(*distance_to(m, solid, {5, 5, 12}), 2);
  EXPECT_NEAR(*distance_to(m, solid, {3.1, 3.2, 3.3}), 0.1, 1e-12) << "in the void";
  EXPECT_DOUBLE_EQ(*distance_to(m, solid, {13, 14, 5}), 5);
  EXPECT_EQ(*nearest(m, EntityKind::vertex, {1, 1, 8}), EntityRef(n.inner_point));
  EXPECT_EQ(*nearest(m, EntityKind::edge, {8.1, 8, 5}), EntityRef(n.wire));
  const auto face = nearest(m, EntityKind::face, {5, 5, 10.5});
  ASSERT_TRUE(face.ok());
  EXPECT_DOUBLE_EQ(*distance_to(m, *face, {5, 5, 10}), 0);
  EXPECT_EQ(*nearest(m, EntityKind::region, {100, 0, 0}), EntityRef(solid));
  EXPECT_EQ(nearest(Model(), EntityKind::face, {}).error().code, errors::unknown_entity);
}

TEST(Locate, CurvedFaces) {
  Draft d;
  add_half_torus(d, 5, 2);
  const Model m = built(d);
  const RegionId solid = m.regions()[0];
  EXPECT_EQ(*point_in_region(m, solid, {0, 5, 0}, 1e-6), Position::inside);
  EXPECT_EQ(*point_in_region(m, solid, {0, -5, 0}, 1e-6), Position::outside);
  EXPECT_EQ(*point_in_region(m, solid, {0, 0, 0}, 1e-6), Position::outside);
  EXPECT_EQ(*point_in_region(m, solid, {0, 5, 2}, 1e-6), Position::boundary);
  EXPECT_EQ(*point_in_region(m, solid, {5, 0, 0}, 1e-6), Position::boundary);
  EXPECT_NEAR(*distance_to(m, FaceId(0), {0, 5, 0.5}), 1.5, 1e-12);
  // The nearest point of the whole torus is on the missing half.
  EXPECT_NEAR(*distance_to(m, FaceId(0), {0, -1, 0}), std::hypot(1, 3), 1e-9);
  EXPECT_NEAR(*distance_to(m, FaceId(0), {0, -9, 0}), std::hypot(9, 3), 1e-9);
}
