// SPDX-License-Identifier: Apache-2.0
// Measures of faces on free-form surfaces.
#include <gtest/gtest.h>

#include "model/measure.h"
#include "model/measure_shapes.h"
#include "model/query.h"

using namespace aresta;
using namespace aresta::testing;

namespace {

Model built(Draft& d) {
  auto model = d.builder.build(Context{});
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().to_line());
  return model.ok() ? std::move(model).value() : Model{};
}

/// A cylinder of radius 2 and height 5 whose side is the NURBS form of the cylinder, with a seam.
void add_nurbs_cylinder(Draft& d, double factor, bool images) {
  const double r = 2, h = 5;
  const Frame base;
  const auto nurbs = FreeSurface::from_nurbs(Surface(Cylinder{base, r}).to_nurbs({{0, 2 * pi}, {0, h}}));
  ASSERT_TRUE(nurbs.ok());
  const VertexId a = d.vertex({r, 0, 0}), b = d.vertex({r, 0, h});
  const EdgeId bottom = d.arc(a, a, Circle{base, r}, 0, 2 * pi);
  const EdgeId top = d.arc(b, b, Circle{{{0, 0, h}}, r}, 0, 2 * pi), s = d.segment(a, b);
  if (!images) {
    d.face(*nurbs, false, {{along(bottom), along(s), against(top), against(s)}});
  } else {
    // The NURBS form has the cylinder's angles at its knots only; images are inverted anyway. Its v stays when the
    // model is scaled, the seam's parameter does not.
    const auto seam = [&](double u) {
      NurbsCurve2Data image{1, false, {0, h * factor}, {2, 2}, {{u, 0}, {u, h}}, {}};
      return Curve2(*FreeCurve2::from_nurbs(image));
    };
    d.face(*nurbs, false,
           {{along(bottom, {0, 0}, {1, 0}), Use{s, false, seam(2 * pi)}, against(top, {0, h}, {1, 0}),
             Use{s, true, seam(0)}}});
  }
  d.face(Plane{{{}, base.x, -base.y, -base.z}}, false, {{against(bottom)}});
  d.face(Plane{{{0, 0, h}}}, false, {{along(top)}});
}

/// The unit square column up to z = 1 + x y: a bilinear face between four straight edges.
void add_saddle_column(Draft& d) {
  const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}};
  std::vector<VertexId> v;
  for (const Vec3 q : p) v.push_back(d.vertex(q));
  const auto edge = [&](int a, int b) {
    return d.segment(v[static_cast<std::size_t>(a)], v[static_cast<std::size_t>(b)]);
  };
  const EdgeId b0 = edge(0, 1), b1 = edge(1, 2), b2 = edge(2, 3), b3 = edge(3, 0), t0 = edge(4, 5), t1 = edge(5, 6),
               t2 = edge(6, 7), t3 = edge(7, 4), u0 = edge(0, 4), u1 = edge(1, 5), u2 = edge(2, 6), u3 = edge(3, 7);
  NurbsSurfaceData data;
  data.degree_u = data.degree_v = 1;
  data.knots_u = data.knots_v = {0, 1};
  data.multiplicities_u = data.multiplicities_v = {2, 2};
  data.count_u = data.count_v = 2;
  for (const Vec3 q : {p[4], p[7], p[5], p[6]}) data.poles.push_back(q);  // v runs along y
  const auto nurbs = FreeSurface::from_nurbs(data);
  ASSERT_TRUE(nurbs.ok());
  d.face(*nurbs, false, {{along(t0), along(t1), along(t2), along(t3)}});
  d.face(Plane{{{}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}}}, false, {{against(b0), against(b3), against(b2), against(b1)}});
  d.face(Plane{Frame::along({}, {0, -1, 0})}, false, {{along(b0), along(u1), against(t0), against(u0)}});
  d.face(Plane{Frame::along({1, 0, 0}, {1, 0, 0})}, false, {{along(b1), along(u2), against(t1), against(u1)}});
  d.face(Plane{Frame::along({0, 1, 0}, {0, 1, 0})}, false, {{along(b2), along(u3), against(t2), against(u2)}});
  d.face(Plane{Frame::along({}, {-1, 0, 0})}, false, {{along(b3), along(u0), against(t3), against(u3)}});
}

}  // namespace

TEST(MeasureFreeForm, NurbsCylinder) {
  for (const double factor : {1.0, 1e-5, 1e5}) {
    Draft d(Transform::scaling(factor));
    add_nurbs_cylinder(d, factor, true);
    const Model m = built(d);
    ASSERT_EQ(m.regions().size(), 1u);
    const auto volume = measure(m, m.regions()[0]);
    ASSERT_TRUE(volume.ok()) << volume.error().to_line();
    const double expected = 20 * pi * factor * factor * factor;
    EXPECT_NEAR(volume->measure / expected, 1, 1e-9);
    EXPECT_LE(std::abs(volume->measure - expected), volume->error);
    EXPECT_LE(volume->error, 1e-7 * expected);
    const auto area = measure(m, FaceId(0));
    ASSERT_TRUE(area.ok());
    EXPECT_NEAR(area->measure / (20 * pi * factor * factor), 1, 1e-9);
  }
}

TEST(MeasureFreeForm, SeamWithoutImagesIsRefused) {
  // On a closed surface that is not periodic nothing but its images tells the sides of a seam apart.
  Draft d;
  add_nurbs_cylinder(d, 1, false);
  const auto model = d.builder.build(Context{});
  ASSERT_FALSE(model.ok());
  EXPECT_EQ(model.error().code, errors::measure_failed);
  EXPECT_EQ(model.error().entities, std::vector<EntityRef>{FaceId(0)});
}

TEST(MeasureFreeForm, SaddleColumn) {
  Draft d(Transform::rotation(20, {1, 1, 3}));
  add_saddle_column(d);
  const Model m = built(d);
  ASSERT_EQ(m.regions().size(), 1u);
  const auto volume = measure(m, m.regions()[0]);
  ASSERT_TRUE(volume.ok()) << volume.error().to_line();
  EXPECT_NEAR(volume->measure, 1.25, 1e-9);
  EXPECT_LE(std::abs(volume->measure - 1.25), volume->error);
  // Centroid: integrals of x (1 + x y), y (1 + x y) and (1 + x y)^2 / 2 over the square.
  const Vec3 centroid = Transform::rotation(20, {1, 1, 3})
                            .point({(0.5 + 1.0 / 6) / 1.25, (0.5 + 1.0 / 6) / 1.25, (1 + 0.5 + 1.0 / 9) / 2 / 1.25});
  EXPECT_LE(distance(volume->centroid(), centroid), 1e-9);
  const auto area = measure(m, FaceId(0));
  ASSERT_TRUE(area.ok());
  EXPECT_NEAR(area->measure, 1.2807892752734, 1e-9);  // integral of sqrt(1 + x^2 + y^2)
}

TEST(MeasureFreeForm, TrimAndRays) {
  Draft d;
  add_saddle_column(d);
  const Model m = built(d);
  const FaceTrim trim(m, FaceId(0));
  EXPECT_EQ(trim.locate({0.5, 0.5}, 1e-9), Position::inside);
  EXPECT_EQ(trim.locate({0.001, 0.999}, 1e-9), Position::inside);
  EXPECT_EQ(trim.locate({1, 0.3}, 1e-9), Position::boundary);
  EXPECT_EQ(trim.locate({1.001, 0.3}, 1e-9), Position::outside);
  const auto hits = RayCaster(m).cast({0.25, 0.75, -1}, {0, 0, 1});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].t, 1, 1e-12);
  EXPECT_NEAR(hits[1].t, 2 + 0.25 * 0.75, 1e-9);
  EXPECT_EQ(hits[1].facing, FaceUse(FaceId(0), 1));
}
