// SPDX-License-Identifier: Apache-2.0
// Sweeps against Pappus: volume is area times the way of its centroid, area is length times the way of its centroid.
#include "construct/sweep.h"

#include <numbers>

#include "audit.h"
#include "construct/move.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "model/builder.h"
#include "model/measure.h"
#include "motions.h"

namespace aresta {
namespace {

constexpr double pi = std::numbers::pi;
using Points = std::vector<Vec3>;
using ModelPtr = std::shared_ptr<const Model>;

ModelPtr shared(Result<Model> result) {
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().to_line());
  return std::make_shared<const Model>(std::move(result).value());
}

void expect_sound(const Model& m, const std::string& what) {
  EXPECT_LT(largest_gap(m), 1e-12 * (1 + m.bounds().diagonal())) << what;
  for (const FaceId f : m.topology().faces()) EXPECT_GT(image_area(m, f), 0) << what << " face " << f.value;
}

std::string kinds(const Model& m) {
  std::vector<std::string> all;
  for (const FaceId f : m.topology().faces()) all.push_back(m.surface(f).kind());
  std::sort(all.begin(), all.end());
  std::string text;
  for (const std::string& k : all) text += k + " ";
  return text;
}

const Points square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
const std::vector<Points> hole{{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}};

TEST(Extrude, PolygonWithHoleEitherWay) {
  for (const Vec3 vector : {Vec3{0, 0, 3}, {0, 0, -3}, {1, -2, 3}, {1, -2, -3}}) {
    for (const bool flipped : {false, true}) {
      const auto profile = shared(polygon(flipped ? Points(square.rbegin(), square.rend()) : square, hole));
      const auto m = extrude(profile, vector);
      ASSERT_BUILT(m);
      EXPECT_EQ(counts(*m), (Counts{16, 24, 10, 1}));
      EXPECT_EQ(euler(*m), 0);
      EXPECT_TRUE(looks_outward(*m));
      expect_sound(*m, "extrusion");
      EXPECT_NEAR(total_volume(*m).value(), 45, 1e-11);
    }
  }
}

TEST(Extrude, DiskBecomesACylinderOrAnObliqueOne) {
  const auto profile = shared(disk(2, {{1, 2, 3}, {1, 1, 0}}));
  const auto straight = extrude(profile, {-3, -3, 0});
  ASSERT_BUILT(straight);
  EXPECT_EQ(counts(*straight), (Counts{2, 3, 3, 1}));
  EXPECT_EQ(kinds(*straight), "cylinder plane plane ");
  EXPECT_TRUE(looks_outward(*straight));
  EXPECT_NEAR(total_volume(*straight).value(), 4 * pi * std::sqrt(18), 1e-9);
  expect_sound(*straight, "cylinder");
  const auto oblique = extrude(profile, {3, 0, 1});
  ASSERT_BUILT(oblique);
  EXPECT_EQ(kinds(*oblique), "extrusion plane plane ");
  EXPECT_TRUE(looks_outward(*oblique));
  EXPECT_NEAR(total_volume(*oblique).value(), 4 * pi * 3 / std::sqrt(2), 1e-8);
  expect_sound(*oblique, "oblique cylinder");
}

TEST(Extrude, WiresBecomeSheetsAndPointsBecomeLines) {
  const auto sheet = extrude(shared(polyline(square, true)), {0, 0, 2});
  ASSERT_BUILT(sheet);
  EXPECT_EQ(counts(*sheet), (Counts{8, 12, 4, 0}));
  EXPECT_NEAR(total_area(*sheet).value(), 32, 1e-12);
  const auto wave = extrude(shared(spline(Points{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}})), {0, 0, 2});
  ASSERT_BUILT(wave);
  EXPECT_EQ(counts(*wave), (Counts{4, 4, 1, 0}));
  EXPECT_EQ(kinds(*wave), "extrusion ");
  expect_sound(*wave, "wave");
  const auto tube = extrude(shared(circle(1)), {0, 0, 5});
  EXPECT_EQ(counts(*tube), (Counts{2, 3, 1, 0}));
  EXPECT_NEAR(total_area(*tube).value(), 10 * pi, 1e-9);
  const auto rod = extrude(shared(point({1, 1, 1})), {0, 0, 5});
  EXPECT_EQ(counts(*rod), (Counts{2, 1, 0, 0}));
  EXPECT_NEAR(total_length(*rod).value(), 5, 1e-15);
}

TEST(Extrude, NamesAndProvenanceLeadBack) {
  const auto profile = shared(polygon(square));
  const auto m = extrude(profile, {0, 0, 1}, {.names = true});
  ASSERT_BUILT(m);
  int sides = 0;
  for (const FaceId f : m->topology().faces()) {
    const auto parents = m->provenance->of(f);
    ASSERT_EQ(parents.size(), 1u);
    EXPECT_EQ(parents[0].entity.kind, m->labels.name(f) == "side" ? EntityKind::edge : EntityKind::face);
    sides += m->labels.name(f) == "side";
  }
  EXPECT_EQ(sides, 4);
  ASSERT_EQ(m->provenance->of(RegionId(1)).size(), 1u);
  EXPECT_EQ(m->provenance->of(RegionId(1))[0].entity, EntityRef(FaceId(0)));
  EXPECT_EQ(m->provenance->sources[0], profile);
}

TEST(Extrude, WrongArguments) {
  const auto profile = shared(polygon(square));
  expect_error(extrude(profile, {0, 0, 0}), errors::bad_size, "extrude: vector must be a direction");
  expect_error(extrude(profile, {0, NAN, 0}), errors::bad_size, "extrude: vector");
  expect_error(extrude(profile, {0, 0, 1e-12}), errors::bad_size, "length of the vector must be larger");
  expect_error(extrude(profile, {1, 2, 0}), errors::bad_profile, "lies in the plane");
  expect_error(extrude(shared(block(1, 1, 1)), {0, 0, 1}), errors::bad_profile, "has a region");
  expect_error(extrude(shared(line({0, 0, 0}, {0, 0, 1})), {0, 0, 1}), errors::bad_profile, "parallel to the vector");
  expect_error(extrude(shared(circle(1)), {1, 0, 0}), errors::bad_profile, "moves along itself");
}

Model moved(const ModelPtr& m, const Transform& map) {
  return transform(*m, map).value();
}

/// Profiles in the half-plane x >= 0, y = 0, with what revolving them about z gives.
struct Case {
  const char* name;
  ModelPtr profile;
  Counts full, partial;
  const char* kinds_full;
};

double pappus_volume(const Model& face, double degrees) {
  const Moments m = measure(face, FaceId(0)).value();
  return m.measure * m.centroid().x * degrees * pi / 180;
}

ModelPtr in_xz(std::initializer_list<std::array<double, 2>> points) {
  Points p;
  for (const auto& [x, z] : points) p.push_back({x, 0, z});
  return shared(polygon(p));
}

/// The half disc of radius r about (0, 0, 0) at x >= 0.
ModelPtr half_disc(double r) {
  ModelBuilder b;
  const VertexId south = b.add_vertex({0, 0, -r}), north = b.add_vertex({0, 0, r});
  const CurveId circle = b.add_curve(Circle{Frame{{}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, r});
  const EdgeId arc = b.add_edge(south, north, circle, {-pi / 2, pi / 2}), axis = b.add_edge(north, south);
  b.begin_face(b.add_surface(Plane{Frame::along({}, {0, -1, 0})}), false);
  b.add_coedge(arc, false);
  b.add_coedge(axis, false);
  b.close_loop();
  b.end_face();
  return shared(b.build({}));
}

TEST(Revolve, ProfilesGiveExactSolids) {
  const Case cases[] = {
      {"tube", in_xz({{1, 0}, {2, 0}, {2, 3}, {1, 3}}), {4, 6, 4, 1}, {8, 12, 6, 1}, "cylinder cylinder plane plane "},
      {"cylinder", in_xz({{0, 0}, {2, 0}, {2, 3}, {0, 3}}), {2, 3, 3, 1}, {6, 9, 5, 1}, "cylinder plane plane "},
      {"cone", in_xz({{0, 0}, {2, 0}, {0, 3}}), {2, 2, 2, 1}, {4, 6, 4, 1}, "cone plane "},
      {"double cone", in_xz({{0, 0}, {2, 1}, {0, 3}}), {3, 3, 2, 1}, {4, 6, 4, 1}, "cone cone "},
      {"ring", in_xz({{1, 0}, {3, 1}, {2, 4}}), {3, 6, 3, 1}, {6, 9, 5, 1}, "cone cone cone "},
      {"torus", shared(disk(1, {{3, 0, 0}, {0, 1, 0}})), {1, 2, 1, 1}, {2, 3, 3, 1}, "torus "},
      {"ball", half_disc(2), {2, 1, 1, 1}, {2, 3, 3, 1}, "sphere "},
  };
  Motions motions(11);
  for (const Case& c : cases) {
    for (const double angle : {360.0, 90.0, 200.0, -359.0, -360.0, 1.0}) {
      const bool full = std::abs(angle) == 360;
      const std::string what = std::string(c.name) + " by " + std::to_string(angle);
      const auto m = revolve(c.profile, angle);
      ASSERT_TRUE(m.ok()) << what << ": " << m.error().to_line();
      EXPECT_EQ(counts(*m), full ? c.full : c.partial) << what;
      if (full) {
        EXPECT_EQ(kinds(*m), c.kinds_full) << what;
      }
      EXPECT_TRUE(looks_outward(*m)) << what;
      expect_sound(*m, what);
      const double volume = pappus_volume(*c.profile, std::abs(angle));
      EXPECT_NEAR(total_volume(*m).value(), volume, 1e-9 * volume) << what;
      // The same about any axis.
      const Transform map = motions.rigid();
      const auto there = revolve(std::make_shared<const Model>(moved(c.profile, map)), angle, map.point({0, 0, 7}),
                                 3 * map.vector({0, 0, 1}));
      ASSERT_TRUE(there.ok()) << what << ": " << there.error().to_line();
      EXPECT_EQ(counts(*there), counts(*m)) << what;
      EXPECT_EQ(kinds(*there), kinds(*m)) << what;
      EXPECT_NEAR(total_volume(*there).value(), volume, 1e-9 * volume) << what;
      expect_sound(*there, what + " moved");
    }
  }
}

TEST(Revolve, HoleBecomesAVoidWhenTheTurnIsFull) {
  const auto profile = shared(polygon(Points{{1, 0, 0}, {5, 0, 0}, {5, 0, 4}, {1, 0, 4}},
                                      std::vector<Points>{{{2, 0, 1}, {4, 0, 1}, {4, 0, 3}, {2, 0, 3}}}));
  const auto full = revolve(profile);
  ASSERT_BUILT(full);
  EXPECT_EQ(counts(*full), (Counts{8, 12, 8, 1}));
  EXPECT_EQ(full->topology().region_count(), 3u);
  EXPECT_NEAR(total_volume(*full).value(), 2 * pi * 3 * (16 - 4), 1e-9);
  const auto half = revolve(profile, 180);
  ASSERT_BUILT(half);
  EXPECT_EQ(half->topology().region_count(), 2u);
  EXPECT_NEAR(total_volume(*half).value(), pi * 3 * (16 - 4), 1e-9);
}

TEST(Revolve, WiresAndPoints) {
  const auto sheet = revolve(shared(line({1, 0, 0}, {3, 0, 2})));
  ASSERT_BUILT(sheet);
  EXPECT_EQ(counts(*sheet), (Counts{2, 3, 1, 0}));
  EXPECT_NEAR(total_area(*sheet).value(), std::sqrt(8) * 2 * pi * 2, 1e-9);
  const auto disc = revolve(shared(line({0, 0, 1}, {2, 0, 1})));
  ASSERT_BUILT(disc);
  EXPECT_EQ(counts(*disc), (Counts{1, 1, 1, 0}));
  EXPECT_NEAR(total_area(*disc).value(), 4 * pi, 1e-9);
  const auto ring = revolve(shared(line({3, 0, 1}, {2, 0, 1})));
  ASSERT_BUILT(ring);
  EXPECT_EQ(counts(*ring), (Counts{2, 2, 1, 0}));
  EXPECT_NEAR(total_area(*ring).value(), 5 * pi, 1e-9);
  EXPECT_GT(image_area(*ring, FaceId(0)), 0);
  // A skew line sweeps a hyperboloid: between (1, 0, 0) and (1, 1, 1), radius^2 = 1 + z^2, area by quadrature:
  // 2 pi times the integral of sqrt(1 + 2 z^2) over [0, 1].
  const auto hyperboloid = revolve(shared(line({1, 0, 0}, {1, 1, 1})));
  ASSERT_BUILT(hyperboloid);
  EXPECT_EQ(kinds(*hyperboloid), "revolution ");
  const double area = 2 * pi * 0.5 * (std::sqrt(3) + std::asinh(std::sqrt(2)) / std::sqrt(2));
  EXPECT_NEAR(total_area(*hyperboloid).value(), area, 1e-8);
  expect_sound(*hyperboloid, "hyperboloid");
  const auto vase = revolve(shared(spline(Points{{1, 0, 0}, {2, 0, 1}, {1, 0, 2}, {1.5, 0, 3}})), 270);
  ASSERT_BUILT(vase);
  EXPECT_EQ(counts(*vase), (Counts{4, 4, 1, 0}));
  expect_sound(*vase, "vase");
  const auto turn = revolve(shared(point({2, 0, 1})));
  EXPECT_EQ(counts(*turn), (Counts{1, 1, 0, 0}));
  EXPECT_NEAR(total_length(*turn).value(), 4 * pi, 1e-12);
  EXPECT_EQ(counts(*revolve(shared(point({2, 0, 1})), 90)), (Counts{2, 1, 0, 0}));
}

TEST(Revolve, WrongArguments) {
  const auto profile = in_xz({{1, 0}, {2, 0}, {2, 3}, {1, 3}});
  expect_error(revolve(profile, 0), errors::bad_size, "revolve: angle");
  expect_error(revolve(profile, 361), errors::bad_size, "revolve: angle");
  expect_error(revolve(profile, NAN), errors::bad_size, "revolve: angle must be a finite number");
  expect_error(revolve(profile, 1e-12), errors::bad_size, "the way of the profile's outermost point");
  expect_error(revolve(profile, 360 - 2e-9), errors::bad_size, "the gap that the angle leaves");
  expect_error(revolve(profile, 90, {}, {0, 0, 0}), errors::bad_size, "revolve: axis must be a direction");
  expect_error(revolve(profile, 90, {}, {0, 1, 0}), errors::bad_profile, "at right angles to the axis");
  expect_error(revolve(profile, 90, {1.5, 0, 0}), errors::bad_profile, "both sides of the axis");
  expect_error(revolve(shared(sphere(1)), 90), errors::bad_profile, "has a region");
  expect_error(revolve(shared(line({0, 0, 0}, {0, 0, 1}))), errors::bad_profile, "lies on the axis");
  expect_error(revolve(shared(point({0, 0, 3}))), errors::bad_profile, "lies on the axis");
  expect_error(revolve(shared(line({-1, 0, 0}, {1, 0, 1}))), errors::bad_profile, "meets the axis");
  expect_error(revolve(shared(line({-1, 0, 0}, {1, 0, 0}))), errors::bad_profile, "meets the axis");
  expect_error(revolve(shared(line({-1, 1, 0}, {1, 1, 0}))), errors::bad_profile, "sweeps part of a plane twice");
  expect_error(revolve(shared(circle(1))), errors::bad_profile, "moves along itself");
  expect_error(revolve(shared(circle(1, {{0, 0, 0}, {0, 1, 0}}))), errors::bad_profile, "meets the axis");
}

}  // namespace
}  // namespace aresta
