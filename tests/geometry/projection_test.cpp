// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "samples.h"

namespace aresta {
namespace {

/// Points around a place, some of them far away.
std::vector<Vec3> around(Vec3 c, double reach, int n) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> d(-reach, reach);
  std::vector<Vec3> all;
  for (int i = 0; i < n; ++i) all.push_back(c + Vec3{d(random), d(random), d(random)});
  return all;
}

TEST(Projection, PointsOfCurvesProjectToTheirParameter) {
  for (const auto& [name, curve, range] : samples::curves()) {
    for (int i = 0; i <= 40; ++i) {
      const double t = range.at(i / 40.0);
      const CurveProjection r = curve.project(curve.point(t), range);
      EXPECT_LT(r.distance, 4e-15) << name;
      if (i == 0 || i == 40) continue;  // the ends of a closed curve are one point
      EXPECT_NEAR(r.parameter, t, 4e-15 * 8) << name;
    }
  }
}

TEST(Projection, NoSampleOfTheCurveIsNearer) {
  for (const auto& [name, curve, range] : samples::curves()) {
    for (const Vec3 p : around(curve.point(range.middle()), 4, 60)) {
      const CurveProjection r = curve.project(p, range);
      EXPECT_GE(r.parameter, range.low);
      EXPECT_LE(r.parameter, range.high);
      EXPECT_NEAR(r.distance, distance(curve.point(r.parameter), p), 1e-14);
      for (int i = 0; i <= 1000; ++i) {
        ASSERT_LE(r.distance, distance(curve.point(range.at(i / 1000.0)), p) + 1e-14) << name;
      }
    }
  }
}

TEST(Projection, EllipseInsideTheEvoluteAndOnItsAxes) {
  const Curve e(Ellipse{{}, 5, 1});
  const Range whole{0, 2 * samples::pi};
  EXPECT_NEAR(e.project({0, 0, 0}, whole).distance, 1, 1e-15);
  EXPECT_NEAR(e.project({0, 0, 3}, whole).distance, std::sqrt(10), 1e-15);
  EXPECT_NEAR(e.project({4.9, 0, 0}, whole).distance, 0.1, 1e-15);
  // On the major axis inside the evolute: cos t = a x / (a^2 - b^2).
  EXPECT_NEAR(e.project({2.4, 0, 0}, whole).parameter, std::acos(0.5), 1e-15);
  EXPECT_NEAR(e.project({0, 0.4, 0}, whole).parameter, samples::pi / 2, 1e-15);
  // The nearest point of the whole is left out of this arc; the local minimum of the lower half is its nearest.
  const CurveProjection low = e.project({2.4, 1e-3, 0}, {samples::pi, 2 * samples::pi});
  EXPECT_NEAR(low.parameter, 2 * samples::pi - std::acos(0.5), 2e-3);
  EXPECT_LT(low.distance, 0.95);
}

TEST(Projection, EllipseAgreesWithFineSamplingOnArcs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> d(-1, 1);
  for (int round = 0; round < 400; ++round) {
    const double b = std::pow(10, -2 * std::abs(d(random)));
    const Curve e(Ellipse{samples::crooked(round % 2 == 1), 1, b});
    const double low = 4 * d(random);
    const Range range{low, low + 3.1 * (1 + d(random)) + 0.01};
    const Vec3 p = samples::crooked().origin + Vec3{1.5 * d(random), 1.5 * d(random), 1.5 * d(random)};
    const double found = e.project(p, range).distance;
    double sampled = 1e9;
    for (int i = 0; i <= 2000; ++i) sampled = std::min(sampled, distance(p, e.point(range.at(i / 2000.0))));
    ASSERT_LE(found, sampled + 1e-14) << round;
    ASSERT_GE(found, sampled - 1e-5) << round;
  }
}

TEST(Projection, CircleCentreAndEndsOfArcs) {
  const Curve c(Circle{{}, 2});
  EXPECT_EQ(c.project({0, 0, 0}, {1, 2}).parameter, 1);
  EXPECT_EQ(c.project({3, -0.1, 0}, {0, 1}).parameter, 0);
  EXPECT_EQ(c.project({0, 3, 0}, {0, 1}).parameter, 1);
  // Ranges that start anywhere.
  EXPECT_NEAR(c.project({3, 0, 0}, {6, 7}).parameter, 2 * samples::pi, 1e-15);
  EXPECT_NEAR(c.project({3, 0, 0}, {-7, -6}).parameter, -2 * samples::pi, 1e-15);
}

TEST(Projection, PointsOfSurfacesProjectToTheirParameters) {
  for (const auto& [name, s, piece] : samples::surfaces()) {
    for (int i = 1; i < 10; ++i) {
      for (int j = 1; j < 10; ++j) {
        const Vec2 uv{piece.u.at(i / 10.0), piece.v.at(j / 10.0 + 0.007)};
        const SurfaceProjection hinted = s.project(s.point(uv), &uv);
        EXPECT_LT(hinted.distance, 8e-15) << name;
        if (name.find("spindle") == std::string::npos) {
          EXPECT_LT(distance(hinted.uv, uv), 5e-14) << name << " " << uv.x << " " << uv.y;
        }
        const SurfaceProjection free = s.project(s.point(uv));
        EXPECT_LT(free.distance, 8e-15) << name;
        // Far branches: the answer follows the hint by whole periods.
        const Vec2 period = s.period();
        const Vec2 far{uv.x + 3 * period.x + 0.1, uv.y - 2 * period.y + 0.1};
        const SurfaceProjection turned = s.project(s.point(uv), &far);
        if (period.x > 0) {
          EXPECT_LE(std::abs(turned.uv.x - far.x), period.x / 2) << name;
        }
        if (period.y > 0) {
          EXPECT_LE(std::abs(turned.uv.y - far.y), period.y / 2) << name;
        }
      }
    }
  }
}

TEST(Projection, NoSampleOfTheSurfaceIsNearer) {
  for (const auto& [name, s, piece] : samples::surfaces()) {
    const Range2 domain = s.domain();
    const Range u = std::isfinite(domain.u.length()) ? domain.u : Range{-8, 8};
    const Range v = std::isfinite(domain.v.length()) ? domain.v : Range{-8, 8};
    for (const Vec3 p : around(s.point({u.middle(), v.middle()}), 4, 25)) {
      const SurfaceProjection r = s.project(p);
      EXPECT_NEAR(r.distance, distance(s.point(r.uv), p), 1e-14) << name;
      for (int i = 0; i <= 60; ++i) {
        for (int j = 0; j <= 60; ++j) {
          ASSERT_LE(r.distance, distance(s.point({u.at(i / 60.0), v.at(j / 60.0)}), p) + 1e-13) << name;
        }
      }
    }
  }
}

TEST(Projection, SingularPoints) {
  const Vec2 hint{2.5, 0.3};
  // On the axis every azimuth is as near: the hint decides.
  EXPECT_EQ(Surface(Cylinder{{}, 2}).project({0, 0, 7}, &hint).uv, (Vec2{2.5, 7}));
  EXPECT_EQ(Surface(Cylinder{{}, 2}).project({0, 0, 7}).distance, 2);
  const SurfaceProjection pole = Surface(Sphere{{}, 2}).project({0, 0, 3}, &hint);
  EXPECT_DOUBLE_EQ(pole.uv.y, samples::pi / 2);
  EXPECT_EQ(pole.uv.x, 2.5);
  EXPECT_DOUBLE_EQ(pole.distance, 1);
  EXPECT_EQ(Surface(Sphere{{}, 2}).project({0, 0, 0}).distance, 2);
  const SurfaceProjection apex = Surface(Cone{{}, 0, 0.5}).project({0, 0, 0}, &hint);
  EXPECT_EQ(apex.uv.x, 2.5);
  EXPECT_EQ(apex.distance, 0);
  // Beyond the apex the other nappe is nearer than the first.
  const SurfaceProjection below = Surface(Cone{{}, 0, 0.5}).project({0.3, 0, -2});
  EXPECT_LT(below.uv.y, 0);
  EXPECT_NEAR(below.distance, std::abs(2 * std::sin(0.5) - 0.3 * std::cos(0.5)), 1e-15);
  EXPECT_NEAR(Surface(Torus{{}, 3, 1}).project({0, 0, 0}).distance, 2, 1e-15);
  EXPECT_NEAR(Surface(Torus{{}, 3, 1}).project({3, 0, 0}).distance, 1, 1e-15);
}

TEST(Projection, FarOriginCostsUlpsOfItOnly) {
  const Vec3 far{1e6, -2e6, 5e5};
  Frame f = samples::crooked();
  f.origin = f.origin + far;
  for (const Surface& s : {Surface(Cylinder{f, 1}), Surface(Sphere{f, 1}), Surface(Torus{f, 3, 1})}) {
    for (const Vec3 p : around(f.origin, 5, 50)) {
      const SurfaceProjection r = s.project(p);
      EXPECT_LT(std::abs(r.distance - norm(p - s.point(r.uv))), 1e-15);
      const Vec3 n = s.normal(r.uv);
      // The residual is along the normal to ulps of the origin.
      EXPECT_LT(norm(cross(p - r.point, n)), 3e-9);
    }
  }
}

TEST(Projection, FreeFormSurfaceIsStationary) {
  const Surface s(samples::free_surface());
  for (const Vec3 p : around({2, 2, 0}, 2, 100)) {
    const SurfaceProjection r = s.project(p);
    const Range2 d = s.domain();
    const SurfaceJet j = s.jet(r.uv);
    if (r.uv.x > d.u.low && r.uv.x < d.u.high) {
      EXPECT_LT(std::abs(dot(p - r.point, normalized(j.du))), 1e-11);
    }
    if (r.uv.y > d.v.low && r.uv.y < d.v.high) {
      EXPECT_LT(std::abs(dot(p - r.point, normalized(j.dv))), 1e-11);
    }
  }
}

TEST(Projection, NotANumberStaysOne) {
  EXPECT_TRUE(std::isnan(Curve(samples::free_curve()).project({std::nan(""), 0, 0}, {0, 4}).distance));
  EXPECT_TRUE(std::isnan(Surface(samples::free_surface()).project({std::nan(""), 0, 0}).distance));
}

}  // namespace
}  // namespace aresta
