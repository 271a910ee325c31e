// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "samples.h"

namespace aresta {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// '=' same point set and direction, 'r' same but reversed, '.' different, within 1e-6.
char curves(const Curve& a, Range range, const Curve& b) {
  bool same = false;
  if (!coincident(a, range, b, 1e-6, &same)) return '.';
  return same ? '=' : 'r';
}
char surfaces(const Surface& a, const Range2& piece, const Surface& b) {
  bool same = false;
  if (!coincident(a, piece, b, 1e-6, &same)) return '.';
  return same ? '=' : 'r';
}

TEST(Coincident, TableOfCurves) {
  const Frame f = samples::crooked();
  Frame back = f, shifted = f, near = f, turned = f;
  back.y = -f.y, back.z = -f.z;
  shifted.origin = f.origin + Vec3{1e-3, 0, 0};
  near.origin = f.origin + Vec3{3e-7, 0, 0};
  turned.x = f.y, turned.y = -f.x;
  const std::vector<std::pair<Curve, Range>> all = {
      {Line{f.origin, f.x}, {0, 5}},             // 0
      {Line{f.origin + 7 * f.x, -f.x}, {0, 5}},  // 1 the same line the other way
      {Line{shifted.origin, f.x}, {0, 5}},       // 2 beside
      {Line{near.origin, f.x}, {0, 5}},          // 3 within tolerance
      {Circle{f, 2}, {0, 3}},                    // 4
      {Circle{back, 2}, {0, 3}},                 // 5 turning the other way
      {Circle{turned, 2}, {0, 3}},               // 6 other seam
      {Circle{near, 2}, {0, 3}},                 // 7 within tolerance
      {Circle{f, 2.01}, {0, 3}},                 // 8 larger
      {Ellipse{f, 2, 1.5}, {0, 3}},              // 9
      {Ellipse{f, 2, 2 - 1e-7}, {0, 3}},         // 10 nearly the circle
  };
  const std::vector<std::string> expected = {
      "=r.=.......",  // 0
      "r=.r.......",  // 1
      "..=........",  // 2
      "=r.=.......",  // 3
      "....=r==..=",  // 4
      "....r=rr..r",  // 5
      "....=r==..=",  // 6
      "....=r==..=",  // 7
      "........=..",  // 8
      ".........=.",  // 9
      "....=r==..=",  // 10
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string row;
    for (const auto& [b, range_b] : all) row += curves(all[i].first, all[i].second, b);
    EXPECT_EQ(row, expected[i]) << "row " << i;
  }
}

TEST(Coincident, FreeFormCurves) {
  const Curve circle(Circle{samples::crooked(), 2});
  const Curve nurbs(*FreeCurve::from_nurbs(circle.to_nurbs({0, 2 * samples::pi})));
  EXPECT_EQ(curves(nurbs, nurbs.domain(), circle), '=');
  EXPECT_EQ(curves(circle, {0, 6}, nurbs), '=');
  const Curve half(*FreeCurve::from_nurbs(circle.to_nurbs({0, 3})));
  EXPECT_EQ(curves(half, half.domain(), nurbs), '=');
  EXPECT_EQ(curves(nurbs, nurbs.domain(), half), '.');  // the whole is not in the half
  const Curve free(samples::free_curve());
  EXPECT_EQ(curves(free, {0, 4}, free), '=');
  EXPECT_EQ(curves(free, {0, 4}, *free.transformed(Transform::translation({1e-7, 0, 0}))), '=');
  EXPECT_EQ(curves(free, {0, 4}, *free.transformed(Transform::translation({0, 0, 1e-5}))), '.');
}

TEST(Coincident, UnboundedLinesMustBeParallel) {
  const Curve a(Line{{}, {1, 0, 0}});
  EXPECT_TRUE(coincident(a, {-inf, inf}, a, 1e-9));
  EXPECT_FALSE(coincident(a, {-inf, inf}, Curve(Line{{}, normalized(Vec3{1, 1e-9, 0})}), 1e-6));
  EXPECT_TRUE(coincident(a, {-1, 1}, Curve(Line{{}, normalized(Vec3{1, 1e-9, 0})}), 1e-6));
}

TEST(Coincident, TableOfSurfaces) {
  const Frame f = samples::crooked();
  Frame flipped = f, mirrored = samples::crooked(true), higher = f;
  flipped.y = -f.y, flipped.z = -f.z;
  higher.origin = f.origin + 2 * f.z;
  const Range2 piece{{0, 2}, {0.5, 1.5}};
  const std::vector<Surface> all = {
      Plane{f},                                  // 0
      Plane{flipped},                            // 1 the other way up
      Plane{higher},                             // 2
      Cylinder{f, 2},                            // 3
      Cylinder{flipped, 2},                      // 4 the axis reversed: still outwards
      Cylinder{mirrored, 2},                     // 5 left-handed: inwards
      Cylinder{higher, 2},                       // 6 moved along its axis
      Cylinder{f, 2.1},                          // 7
      Cone{f, 1, 0.5},                           // 8
      Cone{higher, 1 + 2 * std::tan(0.5), 0.5},  // 9 the same cone from farther up
      Cone{flipped, 1, -0.5},                    // 10 the same cone seen from the other end
      Sphere{f, 2},                              // 11
      Sphere{mirrored, 2},                       // 12
      Torus{f, 3, 1},                            // 13
      Torus{flipped, 3, 1},                      // 14
  };
  const std::vector<std::string> expected = {
      "=r.............",  // 0
      "r=.............",  // 1
      "..=............",  // 2
      "...==r=........",  // 3
      "...==r=........",  // 4
      "...rr=r........",  // 5
      "...==r=........",  // 6
      ".......=.......",  // 7
      "........===....",  // 8
      "........===....",  // 9
      "........===....",  // 10
      "...........=r..",  // 11
      "...........r=..",  // 12
      ".............==",  // 13
      ".............==",  // 14
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string row;
    for (const Surface& b : all) row += surfaces(all[i], piece, b);
    EXPECT_EQ(row, expected[i]) << "row " << i;
  }
}

TEST(Coincident, UnboundedAndFreeFormSurfaces) {
  const Frame f = samples::crooked();
  const Range2 unbounded{{0, 2 * samples::pi}, {-inf, inf}};
  EXPECT_TRUE(coincident(Cylinder{f, 2}, unbounded, Cylinder{f, 2}, 1e-9));
  Frame tilted = Frame::along(f.origin, f.z + 1e-9 * f.x, f.x);
  EXPECT_FALSE(coincident(Cylinder{f, 2}, unbounded, Cylinder{tilted, 2}, 1e-6));
  EXPECT_TRUE(coincident(Cylinder{f, 2}, {{0, 6}, {-1, 1}}, Cylinder{tilted, 2}, 1e-6));
  const Surface torus(Torus{f, 3, 1});
  const Range2 turn{{0, 2 * samples::pi}, {0, 2 * samples::pi}};
  const Surface nurbs(*FreeSurface::from_nurbs(torus.to_nurbs(turn)));
  bool same = false;
  EXPECT_TRUE(coincident(nurbs, nurbs.domain(), torus, 1e-9, &same));
  EXPECT_TRUE(same);
  EXPECT_TRUE(coincident(torus, turn, nurbs, 1e-9));
  EXPECT_FALSE(coincident(torus, turn, Surface(Torus{f, 3, 1.001}), 1e-6));
}

}  // namespace
}  // namespace aresta
