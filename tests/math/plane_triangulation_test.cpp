// SPDX-License-Identifier: Apache-2.0
#include "math/plane_triangulation.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace aresta {
namespace {

double total_area(const PlaneInput& input, const PlaneOutput& output) {
  double area = 0;
  for (const auto& t : output.triangles) {
    const double a = 0.5 * cross(input.points[t[1]] - input.points[t[0]], input.points[t[2]] - input.points[t[0]]);
    EXPECT_GT(a, 0);
    area += a;
  }
  return area;
}

/// A closed polygon: its points, and its sides from the point `first` on.
void add_polygon(PlaneInput& input, const std::vector<Vec2>& points, bool reversed = false) {
  const auto first = static_cast<std::uint32_t>(input.points.size()), count = static_cast<std::uint32_t>(points.size());
  input.points.insert(input.points.end(), points.begin(), points.end());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = first + i, b = first + (i + 1) % count;
    input.segments.push_back(reversed ? std::array{b, a} : std::array{a, b});
  }
}

TEST(Orient2d, SignIsExactNearTheLine) {
  // 0.1 + 0.2 and 0.3 differ by one bit: the point is off the line y = x by about 5e-17.
  const Vec2 a{0, 0}, b{1, 1};
  EXPECT_LT(orient2d(a, b, {0.1 + 0.2, 0.3}), 0);
  EXPECT_GT(orient2d(a, b, {0.3, 0.1 + 0.2}), 0);
  EXPECT_EQ(orient2d(a, b, {0.3, 0.3}), 0);
  // Far away in all coordinates, in line up to the last bit.
  const Vec2 c{1e15, 1e15 + 1}, d{1e15 + 2, 1e15 + 3}, e{1e15 + 4, 1e15 + 5};
  EXPECT_EQ(orient2d(c, d, e), 0);
  EXPECT_GT(orient2d(c, d, {e.x, e.y + 1}), 0);
}

TEST(PlaneTriangulation, SquareWithSquareHole) {
  PlaneInput input;
  add_polygon(input, {{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  add_polygon(input, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, true);
  const PlaneOutput output = triangulate_plane(input);
  ASSERT_FALSE(output.bad_point);
  EXPECT_EQ(output.triangles.size(), 8u);  // corners + 2 holes - 2
  EXPECT_NEAR(total_area(input, output), 8, 1e-14);
}

TEST(PlaneTriangulation, SlitAndIsolatedPointAreKept) {
  PlaneInput input;
  add_polygon(input, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  input.points.insert(input.points.end(), {{1, 1}, {3, 2}, {1, 3}});
  input.segments.push_back({4, 5});
  input.segments.push_back({5, 4});
  const PlaneOutput output = triangulate_plane(input);
  ASSERT_FALSE(output.bad_point);
  EXPECT_NEAR(total_area(input, output), 16, 1e-14);
  int slit = 0, isolated = 0;
  for (const auto& t : output.triangles) {
    const auto has = [&](std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
    slit += has(4) && has(5) ? 1 : 0;
    isolated += has(6) ? 1 : 0;
  }
  EXPECT_EQ(slit, 2);
  EXPECT_GE(isolated, 3);
}

TEST(PlaneTriangulation, SegmentThroughManyPointsOfAGrid) {
  PlaneInput input;
  add_polygon(input, {{-1, -1}, {21, -1}, {21, 21}, {-1, 21}});
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) input.points.push_back({double(i), double(j)});
  }
  // From (0, 0) to (20, 19): meets no other grid point.
  const std::uint32_t from = 4, to = 4 + 21 * 20 + 19;
  input.segments.push_back({from, to});
  input.segments.push_back({to, from});
  const PlaneOutput output = triangulate_plane(input);
  ASSERT_FALSE(output.bad_point);
  EXPECT_NEAR(total_area(input, output), 22 * 22, 1e-11);
  EXPECT_EQ(output.triangles.size(), 2u * (441 + 4) - 4 - 2);
}

TEST(PlaneTriangulation, RandomStarsHaveTheirArea) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (int trial = 0; trial < 200; ++trial) {
    PlaneInput input;
    std::vector<Vec2> star;
    const int count = 5 + trial % 40;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count, r = radius(random);
      star.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    double area = 0;
    for (int i = 0; i < count; ++i) area += 0.5 * cross(star[i], star[(i + 1) % count]);
    add_polygon(input, star);
    const PlaneOutput output = triangulate_plane(input);
    ASSERT_FALSE(output.bad_point) << trial;
    EXPECT_EQ(output.triangles.size(), static_cast<std::size_t>(count - 2)) << trial;
    EXPECT_NEAR(total_area(input, output), area, 1e-13) << trial;
  }
}

TEST(PlaneTriangulation, BrokenInputIsReported) {
  PlaneInput bow_tie;
  add_polygon(bow_tie, {{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_TRUE(triangulate_plane(bow_tie).bad_point.has_value());
  PlaneInput touching;
  add_polygon(touching, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  add_polygon(touching, {{2, 0}, {3, 1}, {1, 1}}, true);
  EXPECT_TRUE(triangulate_plane(touching).bad_point.has_value());
  PlaneInput twice;
  add_polygon(twice, {{0, 0}, {1, 0}, {1, 1}, {1, 0}});
  EXPECT_TRUE(triangulate_plane(twice).bad_point.has_value());
}

}  // namespace
}  // namespace aresta
