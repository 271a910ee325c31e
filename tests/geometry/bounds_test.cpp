// SPDX-License-Identifier: Apache-2.0
// Bounds, lengths and maps.
#include <gtest/gtest.h>

#include "samples.h"

namespace aresta {
namespace {

TEST(Bounds, CurvesAreInsideAndAnalyticOnesTight) {
  for (const auto& [name, curve, range] : samples::curves()) {
    const Box3 box = curve.bounds(range);
    Box3 seen;
    for (int i = 0; i <= 4000; ++i) {
      const Vec3 p = curve.point(range.at(i / 4000.0));
      ASSERT_TRUE(box.contains(p)) << name;
      seen.add(p);
    }
    if (name != "nurbs") {
      EXPECT_LT(distance(box.low, seen.low) + distance(box.high, seen.high), 1e-5) << name;
    }
  }
}

TEST(Bounds, SurfacesAreInsideAndAnalyticOnesTight) {
  for (const auto& [name, s, piece] : samples::surfaces()) {
    const Box3 box = s.bounds(piece);
    Box3 seen;
    for (int i = 0; i <= 400; ++i) {
      for (int j = 0; j <= 400; ++j) {
        const Vec3 p = s.point({piece.u.at(i / 400.0), piece.v.at(j / 400.0)});
        ASSERT_TRUE(box.contains(p)) << name;
        seen.add(p);
      }
    }
    if (name != "nurbs") {
      EXPECT_LT(distance(box.low, seen.low) + distance(box.high, seen.high), 1e-3) << name;
    }
  }
}

TEST(Bounds, ByHand) {
  const Box3 b = Surface(Torus{{}, 3, 1}).bounds({{0, 2 * samples::pi}, {0, 2 * samples::pi}});
  EXPECT_LT(distance(b.low, {-4, -4, -1}) + distance(b.high, {4, 4, 1}), 1e-13);
  const Box3 q = Curve(Circle{{}, 2}).bounds({0, samples::pi / 2});
  EXPECT_LT(distance(q.low, {0, 0, 0}) + distance(q.high, {2, 2, 0}), 1e-14);
  // Infinite ends give infinite boxes without NaN.
  const Box3 line = Curve(Line{{1, 2, 3}, {1, 0, 0}}).bounds({0, std::numeric_limits<double>::infinity()});
  EXPECT_TRUE(std::isinf(line.high.x));
  EXPECT_NEAR(line.high.y, 2, 1e-14);
}

TEST(Length, ClosedFormsAndQuadrature) {
  EXPECT_EQ(Curve(Line{{}, {1, 0, 0}}).length({-1, 4}), 5);
  EXPECT_EQ(Curve(Circle{{}, 2}).length({0, 3}), 6);
  // Complete elliptic integral: 4 a E(e) with a = 2, b = 1.
  EXPECT_NEAR(Curve(Ellipse{{}, 2, 1}).length({0, 2 * samples::pi}), 9.688448220547674, 1e-13);
  EXPECT_NEAR(Curve(Ellipse{{}, 2, 1}).length({0.5, 0.5 + 6 * samples::pi}), 3 * 9.688448220547674, 1e-12);
  EXPECT_NEAR(Curve(Ellipse{{}, 1, 1e-6}).length({0, 2 * samples::pi}), 4, 1e-10);
  // A rational arc has the arc's length.
  const Curve arc(*FreeCurve::from_nurbs(Curve(Circle{{}, 2}).to_nurbs({0.3, 4})));
  EXPECT_NEAR(arc.length(arc.domain()), 7.4, 1e-12);
}

TEST(Transform, PointsOfMovedCurvesAreMovedPoints) {
  const std::vector<Transform> maps = {
      Transform::translation({1, 2, 3}),
      Transform::rotation(33, {1, 1, 0}, {4, 0, 1}),
      Transform::reflection({1, 1, 1}, {1, 2, -1}),
      Transform::scaling(2.5, {1, 0, 0}),
      Transform::scaling(-0.4),
      Transform::rotation(70, {0, 1, 2}) * Transform::reflection({}, {1, 0, 3}) * Transform::scaling(7)};
  for (const Transform& t : maps) {
    for (const auto& [name, curve, range] : samples::curves()) {
      const auto moved = curve.transformed(t);
      ASSERT_TRUE(moved.ok()) << name;
      EXPECT_STREQ(moved->kind(), curve.kind());
      const double factor = curve.parameter_factor(t);
      for (int i = 0; i <= 10; ++i) {
        const double s = range.at(i / 10.0);
        EXPECT_LT(distance(moved->point(s * factor), t.point(curve.point(s))), 1e-13) << name;
      }
    }
    for (const auto& [name, s, piece] : samples::surfaces()) {
      Vec2 scale;
      const auto moved = s.transformed(t, &scale);
      ASSERT_TRUE(moved.ok()) << name;
      EXPECT_STREQ(moved->kind(), s.kind());
      for (int i = 0; i <= 10; ++i) {
        const Vec2 uv{piece.u.at(i / 10.0), piece.v.at((3 * i % 11) / 11.0)};
        const Vec2 there{uv.x * scale.x, uv.y * scale.y};
        EXPECT_LT(distance(moved->point(there), t.point(s.point(uv))), 2e-13) << name;
        // du x dv follows the cofactors of the map: reversed when the determinant is negative.
        const Vec3 n = normalized(t.vector(s.normal(uv))) * (t.determinant() < 0 ? -1 : 1);
        EXPECT_LT(distance(moved->normal(there), n), 1e-12) << name;
      }
    }
  }
}

TEST(Transform, ScalingsAlongAxes) {
  const Transform t = Transform::from_rows({2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 5, 1});
  Vec2 scale;
  const auto cylinder = Surface(Cylinder{{}, 1}).transformed(t, &scale);
  ASSERT_TRUE(cylinder.ok());
  EXPECT_EQ(cylinder->get_if<Cylinder>()->radius, 2);
  EXPECT_EQ(scale, (Vec2{1, 5}));
  const auto cone = Surface(Cone{{}, 1, samples::pi / 4}).transformed(t, &scale);
  ASSERT_TRUE(cone.ok());
  EXPECT_LT(distance(cone->point({0.3, 2 * scale.y}), t.point(Surface(Cone{{}, 1, samples::pi / 4}).point({0.3, 2}))),
            1e-14);
  const auto plane = Surface(Plane{Frame::along({1, 2, 3}, {0, 1, 0}, {1, 0, 0})}).transformed(t, &scale);
  ASSERT_TRUE(plane.ok());
  EXPECT_LT(distance(plane->point({3 * scale.x, 4 * scale.y}),
                     t.point(Surface(Plane{Frame::along({1, 2, 3}, {0, 1, 0}, {1, 0, 0})}).point({3, 4}))),
            1e-14);
  const auto ellipse = Curve(Circle{{}, 1}).transformed(Transform::from_rows({3, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0}));
  ASSERT_TRUE(ellipse.ok());
  EXPECT_STREQ(ellipse->kind(), "ellipse");
  EXPECT_LT(distance(ellipse->point(0.7), {3 * std::cos(0.7), 2 * std::sin(0.7), 0}), 1e-15);
  EXPECT_EQ(Surface(Sphere{{}, 1}).transformed(t).error().code, errors::bad_transform);
  const Transform shear = Transform::from_rows({1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  EXPECT_EQ(Curve(Circle{{}, 1}).transformed(shear).error().code, errors::bad_transform);
  EXPECT_EQ(Surface(Plane{{}}).transformed(shear).error().code, errors::bad_transform);
  EXPECT_EQ(Surface(Cylinder{{}, 1}).transformed(shear).error().code, errors::bad_transform);
  const auto nurbs = Curve(samples::free_curve()).transformed(shear);
  ASSERT_TRUE(nurbs.ok());
  EXPECT_LT(distance(nurbs->point(1.3), shear.point(Curve(samples::free_curve()).point(1.3))), 1e-14);
  const Transform flat = Transform::from_rows({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(Curve(samples::free_curve()).transformed(flat).error().code, errors::bad_transform);
  EXPECT_EQ(Curve(Line{{}, {0, 0, 1}}).transformed(flat).error().code, errors::bad_transform);
  EXPECT_EQ(Surface(Sphere{{}, 1}).transformed(flat).error().code, errors::bad_transform);
}

TEST(Transform, ACircleStaysACircleUnderManyTurns) {
  Curve c(Circle{samples::crooked(), 2});
  for (int i = 0; i < 360; ++i) c = *c.transformed(Transform::rotation(1, {1, 2, 3}));
  ASSERT_NE(c.get_if<Circle>(), nullptr);
  EXPECT_NEAR(c.get_if<Circle>()->radius, 2, 1e-12);
  const Frame& f = c.get_if<Circle>()->frame;
  EXPECT_NEAR(norm(f.x), 1, 1e-15);
  EXPECT_NEAR(dot(f.x, f.y), 0, 1e-15);
}

}  // namespace
}  // namespace aresta
