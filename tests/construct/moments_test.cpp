// SPDX-License-Identifier: Apache-2.0
// Volume, area, centroid and inertia of every primitive against closed forms, under random motions and mirrors.
#include <cmath>
#include <numbers>

#include "audit.h"
#include "construct/move.h"
#include "construct/primitives.h"
#include "model/measure.h"
#include "motions.h"

namespace aresta {
namespace {

constexpr double pi = std::numbers::pi;

/// A shape with its axes along the coordinate axes.
struct Shape {
  const char* name;
  Model model;
  double volume, area;
  Vec3 centroid;
  Vec3 inertia;  ///< about the centroid: xx, yy, zz; products vanish
};

Model made(Result<Model> result) {
  EXPECT_TRUE(result.ok()) << result.error().to_line();
  return std::move(result).value();
}

std::vector<Shape> shapes(int patches, double seam) {
  const Patches p{patches, seam};
  std::vector<Shape> all;
  const auto round = [](double m, double across, double along) { return Vec3{m * across, m * across, m * along}; };
  all.push_back({"block",
                 made(block(3, 5, 7, {1, 2, 3})),
                 105,
                 142,
                 {2.5, 4.5, 6.5},
                 105.0 / 12 * Vec3{25 + 49, 9 + 49, 9 + 25}});
  {
    const double r = 2, h = 5, m = pi * r * r * h;
    all.push_back({"cylinder",
                   made(cylinder(r, h, {}, p)),
                   m,
                   2 * pi * r * (r + h),
                   {0, 0, h / 2},
                   round(m, (3 * r * r + h * h) / 12, r * r / 2)});
  }
  {
    const double r = 2, h = 5, m = pi * r * r * h / 3, slant = std::hypot(r, h);
    const Vec3 inertia = round(m, 3.0 / 80 * (4 * r * r + h * h), 0.3 * r * r);
    all.push_back({"cone", made(cone(r, 0, h, {}, p)), m, pi * r * (r + slant), {0, 0, h / 4}, inertia});
    all.push_back(
        {"cone on its apex", made(cone(0, r, h, {}, p)), m, pi * r * (r + slant), {0, 0, 3 * h / 4}, inertia});
  }
  {
    // A frustum is a cone of height 10 less its upper half.
    const double r = 2, whole = pi * r * r * 10 / 3, tip = whole / 8, m = whole - tip;
    const double z = (whole * 2.5 - tip * 6.25) / m;
    const auto about_z = [&](double mass, double radius) { return mass * 0.3 * radius * radius; };
    const auto across = [&](double mass, double radius, double h, double at) {
      return mass * (3.0 / 80 * (4 * radius * radius + h * h) + (at - z) * (at - z));
    };
    const double x = across(whole, 2, 10, 2.5) - across(tip, 1, 5, 6.25);
    all.push_back({"frustum",
                   made(cone(2, 1, 5, {}, p)),
                   m,
                   pi * (3 * std::hypot(1, 5) + 4 + 1),
                   {0, 0, z},
                   {x, x, about_z(whole, 2) - about_z(tip, 1)}});
  }
  {
    const double r = 1.5, m = 4.0 / 3 * pi * r * r * r;
    all.push_back({"sphere",
                   made(sphere(r, {{1, 0, -1}}, p)),
                   m,
                   4 * pi * r * r,
                   {1, 0, -1},
                   round(m, 0.4 * r * r, 0.4 * r * r)});
  }
  {
    const double R = 4, r = 1, m = 2 * pi * pi * R * r * r;
    all.push_back({"torus",
                   made(torus(R, r, {}, p)),
                   m,
                   4 * pi * pi * R * r,
                   {},
                   round(m, R * R / 2 + 0.625 * r * r, R * R + 0.75 * r * r)});
  }
  {
    const int n = 7;
    const double r = 2, h = 3, turn = 2 * pi / n, base = 0.5 * n * r * r * std::sin(turn),
                 side = 2 * r * std::sin(turn / 2);
    const double polar = r * r * (2 + std::cos(turn)) / 6;  // per unit of base area
    const double m = base * h;
    all.push_back({"prism",
                   made(prism(n, r, h)),
                   m,
                   2 * base + n * side * h,
                   {0, 0, h / 2},
                   round(m, polar / 2 + h * h / 12, polar)});
    const double slant = std::hypot(h, r * std::cos(turn / 2)), v = base * h / 3;
    const double z2 = base * h * h * h / 30 - v * h * h / 16;  // of z about the centroid
    all.push_back({"pyramid",
                   made(pyramid(n, r, h)),
                   v,
                   base + 0.5 * n * side * slant,
                   {0, 0, h / 4},
                   {base * h / 5 * polar / 2 + z2, base * h / 5 * polar / 2 + z2, base * h / 5 * polar}});
  }
  return all;
}

void expect_near(double value, double expected, double scale, const std::string& what) {
  EXPECT_NEAR(value, expected, 1e-9 * scale) << what;
}

void expect_moments(const Model& m, const Shape& s, const Transform& map, const std::string& what) {
  const auto regions = m.regions();
  ASSERT_EQ(regions.size(), 1u) << what;
  const auto moments = measure(m, regions[0]);
  ASSERT_TRUE(moments.ok()) << what << moments.error().to_line();
  expect_near(moments->measure, s.volume, s.volume, what + " volume");
  const auto area = total_area(m);
  ASSERT_TRUE(area.ok()) << what;
  expect_near(*area, s.area, s.area, what + " area");
  const Vec3 centroid = map.point(s.centroid);
  expect_near(distance(moments->centroid(), centroid), 0, 1 + norm(centroid), what + " centroid");
  // The inertia tensor turns with the shape.
  const Vec3 axes[] = {map.vector({1, 0, 0}), map.vector({0, 1, 0}), map.vector({0, 0, 1})};
  const auto tensor = [&](int i, int j) {
    return s.inertia.x * axes[0][i] * axes[0][j] + s.inertia.y * axes[1][i] * axes[1][j] +
           s.inertia.z * axes[2][i] * axes[2][j];
  };
  const auto inertia = moments->inertia();
  const double scale = s.inertia.x + s.inertia.y + s.inertia.z + s.volume * norm2(centroid);
  const std::array<std::array<int, 2>, 6> which{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  for (std::size_t i = 0; i < 6; ++i)
    expect_near(inertia[i], tensor(which[i][0], which[i][1]), scale, what + " inertia " + std::to_string(i));
}

TEST(PrimitiveMoments, ClosedFormsForAnyPatchesAndSeam) {
  for (const int patches : {1, 2, 4}) {
    for (const Shape& s : shapes(patches, 25.0 * patches)) expect_moments(s.model, s, {}, s.name);
  }
}

TEST(PrimitiveMoments, FollowRandomMotionsAndMirrors) {
  Motions motions(20260101);
  for (const Shape& s : shapes(1, 0)) {
    for (int i = 0; i < 3; ++i) {
      for (const bool mirrored : {false, true}) {
        const Transform map = mirrored ? motions.mirrored() : motions.rigid();
        const auto moved = transform(s.model, map);
        ASSERT_BUILT(moved);
        expect_moments(*moved, s, map, std::string(s.name) + (mirrored ? " mirrored" : " moved"));
        EXPECT_TRUE(loops_enclose(*moved)) << s.name;
        EXPECT_TRUE(looks_outward(*moved)) << s.name;
        EXPECT_LT(largest_gap(*moved), 1e-12) << s.name;
      }
    }
  }
}

TEST(PrimitiveMoments, ScaleByPowers) {
  for (const Shape& s : shapes(2, 10)) {
    for (const double factor : {0.125, 3.0}) {
      const auto scaled = scale(s.model, factor, {1, 2, 3});
      ASSERT_BUILT(scaled);
      const double volume = total_volume(*scaled).value(), area = total_area(*scaled).value();
      EXPECT_NEAR(volume / (s.volume * factor * factor * factor), 1, 1e-10) << s.name;
      EXPECT_NEAR(area / (s.area * factor * factor), 1, 1e-10) << s.name;
      EXPECT_LT(largest_gap(*scaled), 1e-13 * factor * 100) << s.name;
      EXPECT_TRUE(loops_enclose(*scaled)) << s.name;
    }
  }
}

TEST(PrimitiveMoments, WedgeAndPlacements) {
  Motions motions(7);
  for (int i = 0; i < 5; ++i) {
    const Placement placement{motions.vector(10), motions.vector(1)};
    EXPECT_NEAR(total_volume(*wedge(4, 2, 3, 1, placement)).value(), 15, 1e-10);
    EXPECT_NEAR(total_volume(*wedge(4, 2, 3, 0, placement)).value(), 12, 1e-10);
    EXPECT_NEAR(total_volume(*torus(3, 1, placement, {3, 17})).value(), 6 * pi * pi, 1e-8);
    EXPECT_NEAR(total_volume(*cone(3, 1, 2, placement, {5, 17})).value(), 2 * pi / 3 * 13, 1e-8);
  }
}

}  // namespace
}  // namespace aresta
