// SPDX-License-Identifier: Apache-2.0
#include "construct/primitives.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "audit.h"

namespace aresta {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const Placement tilted{{3, -4, 5}, {1, 2, -0.5}};

void expect_solid(const Result<Model>& result, Counts expected, long euler_number, const std::string& what) {
  ASSERT_TRUE(result.ok()) << what << ": " << result.error().to_line();
  EXPECT_EQ(counts(*result), expected) << what;
  EXPECT_EQ(euler(*result), euler_number) << what;
  EXPECT_LT(largest_gap(*result), 1e-13 * (1 + result->bounds().diagonal())) << what;
  EXPECT_TRUE(loops_enclose(*result)) << what;
  EXPECT_TRUE(looks_outward(*result)) << what;
}

TEST(Primitives, PlanarSolidsHaveTheirCounts) {
  expect_solid(block(3, 5, 7), {8, 12, 6, 1}, 2, "block");
  expect_solid(wedge(4, 2, 3, 1, tilted), {8, 12, 6, 1}, 2, "wedge");
  expect_solid(wedge(4, 2, 3, 0), {6, 9, 5, 1}, 2, "sharp wedge");
  expect_solid(wedge(4, 2, 3, 6), {8, 12, 6, 1}, 2, "wedge that widens");
  for (const std::size_t n : {3u, 4u, 6u, 17u}) {
    expect_solid(prism(static_cast<int>(n), 2, 3, tilted), {2 * n, 3 * n, n + 2, 1}, 2, "prism");
    expect_solid(pyramid(static_cast<int>(n), 2, 3, tilted), {n + 1, 2 * n, n + 1, 1}, 2, "pyramid");
  }
}

TEST(Primitives, RoundSolidsHaveTheirCountsForAnyPatchesAndSeam) {
  for (const std::size_t n : {1u, 2u, 3u, 4u, 7u}) {
    for (const double seam : {0.0, 30.0, 90.0, -200.0}) {
      for (const Placement& placement : {Placement{}, tilted, Placement{{0, 0, 1}, {0, 0, -2}}}) {
        const Patches patches{static_cast<int>(n), seam};
        const std::string what = std::to_string(n) + " patches, seam " + std::to_string(seam);
        expect_solid(cylinder(2, 5, placement, patches), {2 * n, 3 * n, n + 2, 1}, 2, "cylinder " + what);
        expect_solid(cone(2, 1, 5, placement, patches), {2 * n, 3 * n, n + 2, 1}, 2, "frustum " + what);
        expect_solid(cone(1, 4, 5, placement, patches), {2 * n, 3 * n, n + 2, 1}, 2, "widening frustum " + what);
        expect_solid(cone(2, 0, 5, placement, patches), {n + 1, 2 * n, n + 1, 1}, 2, "cone " + what);
        expect_solid(cone(0, 2, 5, placement, patches), {n + 1, 2 * n, n + 1, 1}, 2, "cone on its apex " + what);
        expect_solid(sphere(2, placement, patches), {2, n, n, 1}, 2, "sphere " + what);
        expect_solid(torus(4, 1, placement, patches), {n, 2 * n, n, 1}, 0, "torus " + what);
      }
    }
  }
}

TEST(Primitives, SeamTurnsTheFirstVertex) {
  const auto c = cylinder(2, 1, {}, {1, 90});
  ASSERT_BUILT(c);
  EXPECT_EQ(c->point(VertexId(0)), (Vec3{0, 2, 0}));
  EXPECT_EQ(c->point(VertexId(1)), (Vec3{0, 2, 1}));
  const auto p = prism(6, 2, 1, {{1, 1, 1}, {0, 0, 5}});
  ASSERT_BUILT(p);
  EXPECT_EQ(p->point(VertexId(0)), (Vec3{3, 1, 1}));
}

TEST(Primitives, SurfacesAreExactForms) {
  const auto kinds = [](const Result<Model>& m) {
    std::string text;
    for (const FaceId f : m->topology().faces()) text += std::string(m->surface(f).kind()) + " ";
    return text;
  };
  EXPECT_EQ(kinds(cylinder(1, 1)), "plane cylinder plane ");
  EXPECT_EQ(kinds(cone(1, 0, 1)), "plane cone ");
  EXPECT_EQ(kinds(cone(1, 1 + 1e-12, 1)), "plane cylinder plane ");
  EXPECT_EQ(kinds(sphere(1)), "sphere ");
  EXPECT_EQ(kinds(torus(2, 1)), "torus ");
}

TEST(Primitives, BoundsAreTight) {
  const auto box = cylinder(2, 5, {{1, 1, 1}})->bounds();
  EXPECT_NEAR(distance(box.low, {-1, -1, 1}), 0, 1e-12);
  EXPECT_NEAR(distance(box.high, {3, 3, 6}), 0, 1e-12);
  EXPECT_EQ(block(1, 2, 3, {-1, 0, 1})->bounds().low, (Vec3{-1, 0, 1}));
  EXPECT_EQ(block(1, 2, 3, {-1, 0, 1})->bounds().high, (Vec3{0, 2, 4}));
}

TEST(Primitives, NamesOnRequest) {
  EXPECT_TRUE(block(1, 1, 1)->labels.attributes.empty());
  const auto b = block(1, 1, 1, {}, {.names = true});
  EXPECT_EQ(b->labels.name(FaceId(4)), "bottom");
  EXPECT_EQ(b->labels.name(FaceId(5)), "top");
  EXPECT_EQ(cylinder(1, 1, {}, {}, {.names = true})->labels.name(FaceId(1)), "side");
}

TEST(Primitives, WrongArgumentsAreNamed) {
  struct Case {
    Result<Model> result;
    const char* says;
  };
  const Case cases[] = {
      {block(0, 1, 1), "block: dx must be positive, not 0"},
      {block(1, -2, 1), "block: dy must be positive, not -2"},
      {block(1, 1, nan), "block: dz must be a finite number, not nan"},
      {block(1, 1, infinity), "block: dz must be a finite number, not inf"},
      {block(1, 1, 1, {nan, 0, 0}), "block: at must be a point with finite coordinates"},
      {block(1, 1, 1e-12), "block: dz must be larger than the tolerance"},
      {block(1, 1, 0.5, {}, {.tolerance = 0.6}), "block: dz must be larger than the tolerance 0.6"},
      {block(1, 1, 1, {1e16, 0, 0}), "larger than the tolerance"},
      {block(1e40, 1, 1), "between 1e-30 and 1e30"},
      {block(1, 1, 1, {}, {.tolerance = -1}), "tolerance must be zero or positive"},
      {block(1, 1, 1, {}, {.length_unit = 0}), "length_unit must be positive"},
      {wedge(1, 1, 1, -1), "wedge: ltx must be zero or positive"},
      {wedge(1, 0, 1, 1), "wedge: dy must be positive"},
      {prism(2, 1, 1), "prism: n must be a whole number between 3 and 100000, not 2"},
      {prism(5, 0, 1), "prism: r must be positive"},
      {pyramid(5, 1, -1), "pyramid: h must be positive"},
      {cylinder(-1, 1), "cylinder: r must be positive, not -1"},
      {cylinder(1, 0), "cylinder: h must be positive, not 0"},
      {cylinder(1, 1, {{}, {0, 0, 0}}), "cylinder: axis must be a direction other than (0, 0, 0)"},
      {cylinder(1, 1, {{}, {0, 0, nan}}), "axis must be a point with finite coordinates"},
      {cylinder(1, 1, {}, {0}), "cylinder: patches must be a whole number between 1 and 100000, not 0"},
      {cylinder(1, 1, {}, {1, infinity}), "seam must be a finite number"},
      {cylinder(1, 1e-10), "cylinder: h must be larger than the tolerance"},
      {cylinder(1e-10, 1), "cylinder: r must be larger than the tolerance"},
      {cone(0, 0, 1), "cone: r1 or r2 must be positive"},
      {cone(-1, 1, 1), "cone: r1 must be zero or positive"},
      {cone(1, 1e-11, 1), "cone: r2 must be larger than the tolerance"},
      {sphere(0), "sphere: r must be positive"},
      {sphere(1e-3, {{1e12, 0, 0}}), "sphere: r must be larger than the tolerance"},
      {torus(1, 1), "torus: r must be smaller than R = 1"},
      {torus(1, 2), "torus: r must be smaller than R = 1"},
      {torus(0, 1), "torus: R must be positive"},
      {torus(1, 0), "torus: r must be positive"},
      {half_space_block({{}, {}}, Box3{{0, 0, 0}, {1, 1, 1}}), "half_space: normal must be a direction"},
      {half_space_block({{}, {0, 0, 1}}, Box3{}), "half_space: box must be a box with some extent"},
  };
  for (const Case& c : cases) expect_error(c.result, errors::bad_size, c.says);
}

TEST(HalfSpace, BlockCoversTheBoxBelowThePlaneOnly) {
  const Box3 box{{-1, -2, -3}, {4, 5, 6}};
  for (const HalfSpace& h : {HalfSpace{{0, 0, 1}, {0, 0, 2}},
                             {{1, 1, 1}, {1, -2, 3}},
                             {{100, 0, 0}, {1, 0, 0}},
                             {{-100, 0, 0}, {1, 0, 0}},
                             {{1e6, -1e6, 1}, {1, 1, 0}}}) {
    const auto b = half_space_block(h, box);
    ASSERT_BUILT(b);
    EXPECT_EQ(counts(*b), (Counts{8, 12, 6, 1}));
    const Vec3 n = normalized(h.normal);
    double highest = -1e300;
    for (const VertexId v : b->topology().vertices()) highest = std::max(highest, dot(b->point(v) - h.point, n));
    EXPECT_NEAR(highest, 0, 1e-9);
    // Every point of the box below the plane is inside all six faces.
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; j <= 10; ++j) {
        for (int k = 0; k <= 10; ++k) {
          const Vec3 p = box.low + Vec3{i * 0.5, j * 0.7, k * 0.9};
          if (dot(p - h.point, n) > -1e-9) continue;
          for (const FaceId f : b->topology().faces()) {
            const Frame& plane = b->surface(f).get_if<Plane>()->frame;
            EXPECT_LT(dot(p - plane.origin, plane.z), 0);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace aresta
