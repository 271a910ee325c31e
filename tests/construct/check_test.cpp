// SPDX-License-Identifier: Apache-2.0
// The checker is silent about whatever is constructed, in any position; and what would not pass it is refused.
#include "model/check.h"

#include <numbers>

#include "audit.h"
#include "construct/move.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "construct/select.h"
#include "construct/sweep.h"
#include "model/measure.h"
#include "motions.h"
#include "support/paths.h"

namespace aresta {
namespace {

using Points = std::vector<Vec3>;

std::shared_ptr<const Model> shared(Result<Model> result) {
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().to_line());
  return std::make_shared<const Model>(std::move(result).value());
}

void expect_clean(const Result<Model>& model, const std::string& what) {
  ASSERT_TRUE(model.ok()) << what << ": " << model.error().to_line();
  const auto findings = check(*model, CheckLevel::full);
  ASSERT_TRUE(findings.ok()) << what;
  for (const Finding& f : *findings) ADD_FAILURE() << what << ": " << to_string(f.kind) << ": " << f.message;
}

TEST(Checked, PrimitivesAnywhere) {
  Motions motions(1);
  const Patches patches[] = {{}, {2, 15}, {5, -40}};
  for (const Patches& p : patches) {
    const std::pair<const char*, Model> shapes[] = {
        {"block", *block(1, 2, 3)},
        {"wedge", *wedge(4, 2, 3, 1)},
        {"sharp wedge", *wedge(4, 2, 3, 0)},
        {"prism", *prism(5, 2, 3)},
        {"pyramid", *pyramid(6, 2, 3)},
        {"cylinder", *cylinder(1, 3, {}, p)},
        {"cone", *cone(2, 0, 3, {}, p)},
        {"frustum", *cone(1, 2, 3, {}, p)},
        {"flat cone", *cone(9, 0, 0.1, {}, p)},
        {"sphere", *sphere(2, {}, p)},
        {"torus", *torus(3, 1, {}, p)},
        {"thin torus", *torus(3, 1e-3, {}, p)},
        {"thick torus", *torus(3, 2.99, {}, p)},
    };
    for (const auto& [name, m] : shapes) {
      expect_clean(m, name);
      expect_clean(transform(m, motions.rigid()), std::string(name) + " moved");
      expect_clean(transform(m, motions.mirrored()), std::string(name) + " mirrored");
      expect_clean(scale(m, 1e-3), std::string(name) + " small");
    }
  }
}

TEST(Checked, ProfilesAndSweepsAnywhere) {
  Motions motions(2);
  const std::vector<Points> holes{{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}};
  const auto plate = shared(polygon(Points{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, holes));
  for (int i = 0; i < 3; ++i) {
    const Transform map = motions.rigid();
    const auto moved = shared(transform(*plate, map));
    expect_clean(*moved, "plate");
    expect_clean(extrude(moved, map.vector({1, 2, 3})), "extruded plate");
    expect_clean(revolve(moved, 77, map.point({-1, 0, 0}), map.vector({0, 1, 0})), "turned plate");
    expect_clean(revolve(moved, 360, map.point({0, 0, 0}), map.vector({0, 1, 0})), "plate turned about its side");
    expect_clean(extrude(shared(transform(*disk(2), map)), map.vector({1, 0, 2})), "oblique cylinder");
    expect_clean(
        extrude(shared(transform(*spline(Points{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}), map)), map.vector({0, 0, 1})),
        "wave");
    expect_clean(revolve(shared(transform(*spline(Points{{1, 0, 0}, {2, 0, 1}, {1, 0, 3}}), map)), 360,
                         map.point({0, 0, 0}), map.vector({0, 0, 1})),
                 "vase");
    expect_clean(extract_entities(moved, std::vector<EntityRef>{FaceId(0)}), "extracted plate");
  }
}

TEST(Checked, SweepsThatRunIntoThemselvesAreRefused) {
  // Seen along the vector the wire crosses itself, though in space it does not.
  const auto crossing = shared(polyline(Points{{0, 0, 0}, {4, 0, 0}, {4, 2, 1}, {2, -2, 1}}));
  expect_error(extrude(crossing, {0, 0, 5}), errors::sweep_overlaps, "runs into itself");
  EXPECT_TRUE(extrude(crossing, {0, 0, 0.5}).ok());
  // A wire that turns back to its own height and radius at another angle meets its own way there.
  const auto knee = shared(polyline(Points{{2, 0, 0}, {2, 0, 2}, {0, 2, 2}, {0, 2, 0}}));
  EXPECT_FALSE(revolve(knee, 180).ok());
  // Two faces on top of each other in the vector's direction.
  const Model low = *polygon(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), high = *translate(low, {0, 0, 1});
  const std::vector<const Model*> both{&low, &high};
  const auto stack = shared(merge_disjoint(both));
  EXPECT_TRUE(extrude(stack, {0, 0, 0.5}).ok());
  EXPECT_FALSE(extrude(stack, {0, 0, 2}).ok());
}

TEST(Checked, CurvedFacesSweepWhereTheyFaceTheMotion) {
  constexpr double pi = std::numbers::pi;
  // A cone's side along its axis: the volume of the cylinder over its base.
  const auto side = shared(extract_entities(shared(cone(2, 0, 1)), std::vector<EntityRef>{FaceId(1)}));
  for (const Vec3 vector : {Vec3{0, 0, 3}, {0.1, 0.2, -3}}) {
    const auto hat = extrude(side, vector);
    ASSERT_BUILT(hat);
    EXPECT_NEAR(total_volume(*hat).value(), 4 * pi * 3, 1e-7);
    EXPECT_EQ(counts(*hat).faces, 3u);
    EXPECT_TRUE(looks_outward(*hat));
    expect_clean(hat, "hat");
  }
  // A quarter of a cylinder's side along its radius: 2 by 5 seen that way, for a quarter turned to the vector.
  const auto quarter =
      shared(extract_entities(shared(cylinder(1, 5, {}, {4, -45})), std::vector<EntityRef>{FaceId(1)}));
  const auto tile = extrude(quarter, {3, 0, 0});
  ASSERT_BUILT(tile);
  EXPECT_NEAR(total_volume(*tile).value(), std::sqrt(2) * 5 * 3, 1e-8);
  EXPECT_EQ(counts(*tile), (Counts{8, 12, 6, 1}));
  expect_clean(tile, "tile");
  const auto half = shared(extract_entities(shared(cylinder(1, 5, {}, {2, 0})), std::vector<EntityRef>{FaceId(1)}));
  expect_error(extrude(half, {3, 0, 1}), errors::bad_profile, "turns away from the motion");
  const auto ball = shared(extract_entities(shared(sphere(1)), std::vector<EntityRef>{FaceId(0)}));
  expect_error(extrude(ball, {0, 0, 1}), errors::bad_profile, "turns away from the motion");
}

TEST(Checked, PolyhedraWhoseFacesCrossAreRefused) {
  Points points;
  std::vector<PolyhedronFace> faces;
  for (const Vec3 at : {Vec3{0, 0, 0}, {0.5, 0.5, 0.5}}) {
    const std::size_t first = points.size();
    for (unsigned i = 0; i < 8; ++i) points.push_back(at + Vec3{double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    for (const std::vector<std::size_t>& loop :
         {std::vector<std::size_t>{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
      PolyhedronFace face{{loop}};
      for (std::size_t& i : face.loops[0]) i += first;
      faces.push_back(face);
    }
  }
  EXPECT_FALSE(polyhedron(points, faces).ok());
}

/// A star-shaped polygon about a centre: random radii at growing angles.
Points star(Motions& motions, Vec2 centre, double size) {
  Points points;
  const int n = 3 + static_cast<int>(motions.number(0, 9));
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + motions.number(0, 0.4)) / n, r = size * motions.number(0.3, 1);
    points.push_back({centre.x + r * std::cos(angle), 0, centre.y + r * std::sin(angle)});
  }
  return points;
}

TEST(Checked, RandomSweepsObeyPappus) {
  Motions motions(20260102);
  const int cases = std::max(10, static_cast<int>(1000 * test::scale()));
  for (int i = 0; i < cases; ++i) {
    const auto flat = polygon(star(motions, {3, 0}, 2.5));
    ASSERT_BUILT(flat);
    const Moments area = measure(*flat, FaceId(0)).value();
    const Transform map = i % 2 == 0 ? motions.rigid() : motions.mirrored();
    const auto profile = shared(transform(*flat, map));
    const double angle = i % 3 == 0 ? 360 : motions.number(-350, 350);
    const auto turned = revolve(profile, angle, map.point({0, 0, motions.number(-5, 5)}), map.vector({0, 0, 1}));
    ASSERT_BUILT(turned);
    const double way = std::abs(angle) * std::numbers::pi / 180 * area.centroid().x;
    EXPECT_NEAR(total_volume(*turned).value() / (way * area.measure), 1, 1e-9) << i;
    expect_clean(turned, "revolution " + std::to_string(i));
    const Vec3 vector{motions.number(-2, 2), motions.number(0.5, 3), motions.number(-2, 2)};
    const auto pushed = extrude(profile, map.vector(vector));
    ASSERT_BUILT(pushed);
    EXPECT_NEAR(total_volume(*pushed).value() / (vector.y * area.measure), 1, 1e-10) << i;
    expect_clean(pushed, "extrusion " + std::to_string(i));
    EXPECT_TRUE(looks_outward(*turned) && looks_outward(*pushed));
  }
}

}  // namespace
}  // namespace aresta
