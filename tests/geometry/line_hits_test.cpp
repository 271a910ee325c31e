// SPDX-License-Identifier: Apache-2.0
// Lines against surfaces: crossings, touches, misses, and lines inside.
#include <gtest/gtest.h>

#include "samples.h"

namespace aresta {
namespace {

const Range2 wide{{-10, 10}, {-10, 10}};

std::vector<double> hits(const Surface& s, Vec3 origin, Vec3 direction) {
  std::vector<double> t;
  for (const LineHit& h : s.intersect({origin, normalized(direction)}, wide)) t.push_back(h.t);
  return t;
}

void expect_hits(const Surface& s, Vec3 origin, Vec3 direction, const std::vector<double>& expected) {
  const std::vector<double> t = hits(s, origin, direction);
  ASSERT_EQ(t.size(), expected.size()) << s.kind();
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(t[i], expected[i], 4e-15 * (1 + std::abs(t[i]))) << s.kind();
}

TEST(LineHits, Plane) {
  expect_hits(Plane{}, {1, 2, 3}, {0, 0, -1}, {3});
  expect_hits(Plane{}, {1, 2, 3}, {1, 0, 0}, {});
  expect_hits(Plane{}, {1, 2, 0}, {1, 0, 0}, {});  // in the plane: no isolated meeting
}

TEST(LineHits, CylinderCrossTouchMissRuling) {
  const Surface s(Cylinder{{}, 2});
  expect_hits(s, {-5, 0, 1}, {1, 0, 0}, {3, 7});
  expect_hits(s, {-5, 2, 1}, {1, 0, 0}, {5});
  expect_hits(s, {-5, 2.001, 1}, {1, 0, 0}, {});
  expect_hits(s, {2, 0, 0}, {0, 0, 1}, {});
  expect_hits(s, {0, 0, 0}, {0, 0, 1}, {});
}

TEST(LineHits, Sphere) {
  const Surface s(Sphere{{}, 2});
  expect_hits(s, {0, 0, -5}, {0, 0, 1}, {3, 7});
  expect_hits(s, {-5, 0, 2}, {1, 0, 0}, {5});
  expect_hits(s, {-5, 0, 2.0001}, {1, 0, 0}, {});
  expect_hits(s, {1e5, 0, 0}, {-1, 0, 0}, {1e5 - 2, 1e5 + 2});
}

TEST(LineHits, ConeAndItsApex) {
  const Surface s(Cone{{}, 1, samples::pi / 4});  // apex at (0, 0, -1)
  expect_hits(s, {-5, 0, 1}, {1, 0, 0}, {3, 7});
  expect_hits(s, {-5, 0, -1}, {1, 0, 0}, {5});                     // through the apex
  expect_hits(s, {0, 0, 5}, {0, 0, -1}, {6});                      // along the axis: the apex alone
  expect_hits(s, {1, 0, 0}, {1, 0, 1}, {});                        // a ruling
  expect_hits(s, {3, 0, -1}, {1, 0, 1}, {-1.5 * std::sqrt(2.0)});  // parallel to a ruling: the other nappe once
  expect_hits(s, {0, 1, 0}, {1, 0, 0}, {0});                       // touches the circle of radius 1
  expect_hits(s, {0.5, 0, 5}, {0, 0, -1}, {5.5, 6.5});             // both nappes
}

TEST(LineHits, Torus) {
  const Surface s(Torus{{}, 3, 1});
  expect_hits(s, {-10, 0, 0}, {1, 0, 0}, {6, 8, 12, 14});
  expect_hits(s, {-10, 2, 0}, {1, 0, 0},
              {10 - std::sqrt(12.0), 10, 10 + std::sqrt(12.0)});  // touches the inner equator
  expect_hits(s, {-10, 4, 0}, {1, 0, 0}, {10});                   // touches the outer one
  expect_hits(s, {-10, 0, 1}, {1, 0, 0}, {7, 13});                // along the top circle's plane
  expect_hits(s, {-10, 3, 1}, {1, 0, 0}, {10});                   // a touch of fourth order
  expect_hits(s, {0, 0, 0}, {0, 0, 1}, {});
  expect_hits(s, {2, 0, 0}, {0, 0, 1}, {0});
  expect_hits(s, {3, 0, 0}, {0, 0, 1}, {-1, 1});
  expect_hits(s, {-10, 4.0001, 0}, {1, 0, 0}, {});
  // A spindle: outer and inner sheet.
  expect_hits(Torus{{}, 1, 2}, {-10, 0, 0}, {1, 0, 0}, {7, 9, 11, 13});
}

/// Every hit lies on both; between hits the distance to the surface does not change sign as sampling can see.
TEST(LineHits, RandomLinesAgainstSampling) {
  std::mt19937 random(5);
  std::normal_distribution<double> d;
  for (const bool left : {false, true}) {
    const Frame f = samples::crooked(left);
    for (const Surface& s : {Surface(Cylinder{f, 1.5}), Surface(Cone{f, 1, 0.5}), Surface(Cone{f, 2, -0.9}),
                             Surface(Sphere{f, 2}), Surface(Torus{f, 3, 1}), Surface(Torus{f, 2, 0.05})}) {
      const auto side = [&](Vec3 p) {
        const Vec3 l = f.to_local(p);
        const double rho = std::hypot(l.x, l.y);
        if (const auto* c = s.get_if<Cylinder>()) return rho - c->radius;
        if (const auto* c = s.get_if<Cone>()) return rho - std::abs(c->radius + l.z * std::tan(c->half_angle));
        if (const auto* c = s.get_if<Sphere>()) return norm(l) - c->radius;
        const auto* t = s.get_if<Torus>();
        return std::hypot(rho - t->major, l.z) - t->minor;
      };
      for (int round = 0; round < 300; ++round) {
        const Line line{f.origin + Vec3{3 * d(random), 3 * d(random), 3 * d(random)},
                        normalized(Vec3{d(random), d(random), d(random)})};
        const std::vector<LineHit> found = s.intersect(line, wide);
        const auto at = [&](double t) { return line.origin + t * line.direction; };
        for (std::size_t i = 0; i < found.size(); ++i) {
          const Vec3 p = at(found[i].t);
          EXPECT_LT(distance(p, s.point(found[i].uv)), 1e-14 * (1 + norm(p))) << s.kind();
          if (i > 0) {
            EXPECT_LT(found[i - 1].t, found[i].t);
          }
        }
        // Signs change exactly at the hits.
        int changes = 0, inside_hits = 0;
        constexpr int steps = 4000;
        double before = side(at(-20));
        for (int i = 1; i <= steps; ++i) {
          const double now = side(at(-20 + 40.0 * i / steps));
          changes += (now > 0) != (before > 0);
          before = now;
        }
        for (const LineHit& h : found) inside_hits += std::abs(h.t) < 20;
        EXPECT_GE(inside_hits, changes) << s.kind() << " " << round;
        EXPECT_EQ((inside_hits - changes) % 2, 0) << s.kind() << " " << round;
      }
    }
  }
}

TEST(LineHits, TouchesInCrookedFramesAreFoundOnce) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> angle(0, 2 * samples::pi);
  for (const bool left : {false, true}) {
    const Frame f = samples::crooked(left);
    const std::vector<Surface> all = {Cylinder{f, 1.5}, Sphere{f, 2}, Torus{f, 3, 1}};
    for (const Surface& s : all) {
      for (int round = 0; round < 200; ++round) {
        // Tangent lines with the surface on one side of them: on a torus, those of the outer half.
        const Vec2 uv{angle(random),
                      s.get_if<Torus>() != nullptr ? 1.2 * std::sin(angle(random)) : std::sin(angle(random))};
        const SurfaceJet j = s.jet(uv);
        const double a = angle(random);
        if (s.get_if<Cylinder>() != nullptr && std::abs(std::cos(a)) < 0.05) continue;
        const Vec3 along = normalized(std::cos(a) * normalized(j.du) + std::sin(a) * normalized(j.dv));
        const auto found = s.intersect({j.point - 3.7 * along, along}, wide);
        ASSERT_EQ(found.size(), 1u) << s.kind() << " " << round;
        EXPECT_NEAR(found[0].t, 3.7, 1e-6) << s.kind();
      }
    }
  }
}

TEST(LineHits, NotANumberGivesNothing) {
  EXPECT_TRUE(Surface(Torus{{}, 3, 1}).intersect({{std::nan(""), 0, 0}, {1, 0, 0}}, wide).empty());
}

TEST(LineHits, FreeFormAgreesWithTheFormItCameFrom) {
  const Surface torus(Torus{samples::crooked(), 3, 1});
  const Surface nurbs(*FreeSurface::from_nurbs(torus.to_nurbs({{0, 2 * samples::pi}, {0, 2 * samples::pi}})));
  std::mt19937 random(5);
  std::normal_distribution<double> d;
  for (int round = 0; round < 100; ++round) {
    const Line line{samples::crooked().origin + Vec3{2 * d(random), 2 * d(random), 2 * d(random)},
                    normalized(Vec3{d(random), d(random), d(random)})};
    const auto expected = torus.intersect(line, wide), found = nurbs.intersect(line, nurbs.domain());
    ASSERT_EQ(found.size(), expected.size()) << round;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].t, expected[i].t, 1e-9);
      EXPECT_LT(distance(nurbs.point(found[i].uv), line.origin + found[i].t * line.direction), 1e-9);
    }
  }
}

}  // namespace
}  // namespace aresta
