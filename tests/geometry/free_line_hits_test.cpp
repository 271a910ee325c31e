// SPDX-License-Identifier: Apache-2.0
// Lines against free-form surfaces.
#include <gtest/gtest.h>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>

#include "geometry/occt_handles.h"
#include "samples.h"

namespace aresta {
namespace {

const Range turn{0, 2 * samples::pi};

Surface nurbs(const Surface& s, const Range2& r) {
  return *FreeSurface::from_nurbs(s.to_nurbs(r));
}

void expect_hits(const char* what, const Surface& s, const Range2& near, Vec3 origin, Vec3 direction,
                 const std::vector<double>& expected, double tolerance = 1e-12) {
  const Line line{origin, normalized(direction)};
  const auto found = s.intersect(line, near);
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].t, expected[i], tolerance) << what;
    EXPECT_LT(distance(s.point(found[i].uv), line.origin + found[i].t * line.direction), 1e-12) << what;
  }
}

TEST(FreeLineHits, PolesSeamsTouchesAndMisses) {
  const Surface sphere = nurbs(Sphere{{}, 2}, {turn, {-samples::pi / 2, samples::pi / 2}});
  const Range2 d = sphere.domain();
  expect_hits("through both poles", sphere, d, {0, 0, -5}, {0, 0, 1}, {3, 7});
  expect_hits("across the seam", sphere, d, {5, 0, 0.5}, {-1, 0, 0}, {5 - std::sqrt(3.75), 5 + std::sqrt(3.75)});
  expect_hits("through corners of patches", sphere, d, {0, -5, 0}, {0, 1, 0}, {3, 7});
  expect_hits("touch", sphere, d, {-5, 2, 0}, {1, 0, 0}, {5}, 1e-6);
  expect_hits("touch inside a patch", sphere, d, {-5, 2 * std::cos(0.4), 2 * std::sin(0.4)}, {1, 0, 0}, {5}, 1e-6);
  expect_hits("touch at a pole", sphere, d, {-5, 0, 2}, {1, 0, 0}, {5}, 1e-6);
  expect_hits("miss", sphere, d, {-5, 2.0001, 0}, {1, 0, 0}, {});
  expect_hits("near miss", sphere, d, {-5, 2 + 1e-9, 0}, {1, 0, 0}, {});
  const double half = std::sqrt(4 - 1.9999 * 1.9999);
  expect_hits("near touch", sphere, d, {-5, 1.9999, 0}, {1, 0, 0}, {5 - half, 5 + half}, 1e-10);
  const Surface torus = nurbs(Torus{{}, 3, 1}, {turn, turn});
  expect_hits("four", torus, torus.domain(), {-10, 0, 0}, {1, 0, 0}, {6, 8, 12, 14});
  expect_hits(
      "four in general place", torus, torus.domain(), {-10, 0.3, 0.2}, {1, 0, 0},
      {10 - std::sqrt(std::pow(3 + std::sqrt(0.96), 2) - 0.09), 10 - std::sqrt(std::pow(3 - std::sqrt(0.96), 2) - 0.09),
       10 + std::sqrt(std::pow(3 - std::sqrt(0.96), 2) - 0.09),
       10 + std::sqrt(std::pow(3 + std::sqrt(0.96), 2) - 0.09)});
}

TEST(FreeLineHits, LinesInsideTheSurfaceHaveNoIsolatedMeeting) {
  const Surface plane = nurbs(Plane{}, {{-1, 1}, {-1, 1}});
  expect_hits("in a plane", plane, plane.domain(), {-3, 0.1, 0}, {1, 0.2, 0}, {});
  expect_hits("through it", plane, plane.domain(), {0.1, 0.1, -2}, {0, 0, 1}, {2});
  const Surface cylinder = nurbs(Cylinder{{}, 1}, {turn, {0, 2}});
  expect_hits("a ruling", cylinder, cylinder.domain(), {std::cos(0.3), std::sin(0.3), -1}, {0, 0, 1}, {});
}

TEST(FreeLineHits, PartsAndPeriods) {
  const Surface sphere = nurbs(Sphere{{}, 2}, {turn, {-samples::pi / 2, samples::pi / 2}});
  expect_hits("beside the seam", sphere, {{-0.1, 0.1}, {-1, 1}}, {-5, 0, 0}, {1, 0, 0}, {7});
  expect_hits("upper half", sphere, {turn, {0.1, samples::pi / 2}}, {0.1, 0, -5}, {0, 0, 1}, {5 + std::sqrt(3.99)});
  const Handle(Geom_Surface) revolved = new Geom_SurfaceOfRevolution(to_occt(Curve(Line{{2, 0, 0}, {0, 0, 1}})),
                                                                     gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  const Surface tube = from_occt(revolved);
  EXPECT_STREQ(tube.kind(), "revolution");
  expect_hits("revolution", tube, {turn, {-3, 3}}, {-5, 0.3, 1}, {1, 0, 0}, {5 - std::sqrt(3.91), 5 + std::sqrt(3.91)});
  // The same with parameters asked for one turn later.
  const auto later = tube.intersect({{-5, 0.3, 1}, {1, 0, 0}}, {{2 * samples::pi, 4 * samples::pi}, {-3, 3}});
  ASSERT_EQ(later.size(), 2u);
  EXPECT_GE(later[0].uv.x, 2 * samples::pi);
  const Handle(Geom_Surface) extruded =
      new Geom_SurfaceOfLinearExtrusion(to_occt(Curve(Ellipse{{}, 3, 1})), gp_Dir(0, 0, 1));
  expect_hits("extrusion", from_occt(extruded), {turn, {-3, 3}}, {0, -5, 1}, {0, 1, 0}, {4, 6});
  expect_hits("outside the piece", from_occt(extruded), {turn, {-3, 0.5}}, {0, -5, 1}, {0, 1, 0}, {});
}

TEST(FreeLineHits, EverySignChangeIsFound) {
  // A bumpy sheet over [0, 9]^2: the height over the line changes sign exactly at the meetings.
  std::mt19937 random(21);
  std::uniform_real_distribution<double> d(-1, 1);
  NurbsSurfaceData data;
  data.degree_u = data.degree_v = 3;
  data.knots_u = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  data.multiplicities_u = {4, 1, 1, 1, 1, 1, 1, 1, 1, 4};
  data.knots_v = data.knots_u;
  data.multiplicities_v = data.multiplicities_u;
  data.count_u = data.count_v = 12;
  const auto greville = [](std::size_t i) {
    const auto knot = [](int k) { return std::clamp(k - 3.0, 0.0, 9.0); };
    const int k = static_cast<int>(i);
    return (knot(k + 1) + knot(k + 2) + knot(k + 3)) / 3;
  };
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j < 12; ++j) data.poles.push_back({greville(i), greville(j), d(random)});
  }
  const Surface s(*FreeSurface::from_nurbs(data));
  int total = 0;
  for (int round = 0; round < 50; ++round) {
    const Line line{{-1, 4.5 + 4 * d(random), 0.3 * d(random)}, normalized(Vec3{1, 0.1 * d(random), 0.03 * d(random)})};
    const auto found = s.intersect(line, s.domain());
    const auto above = [&](double t) {
      const Vec3 p = line.origin + t * line.direction;
      return p.z - s.point({p.x, p.y}).z;
    };
    std::vector<double> changes;
    const auto inside = [&](double t) {
      const Vec3 p = line.origin + t * line.direction;
      return p.x > 0 && p.x < 9 && p.y > 0 && p.y < 9;
    };
    for (int i = 0; i < 12000; ++i) {
      const double t0 = i / 1000.0, t1 = (i + 1) / 1000.0;
      if (inside(t0) && inside(t1) && (above(t0) > 0) != (above(t1) > 0)) changes.push_back(t0);
    }
    ASSERT_EQ(found.size(), changes.size()) << round;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_GE(found[i].t, changes[i]);
      EXPECT_LE(found[i].t, changes[i] + 1e-3);
      EXPECT_NEAR(above(found[i].t), 0, 1e-12);
    }
    total += static_cast<int>(found.size());
  }
  EXPECT_GT(total, 100);
}

}  // namespace
}  // namespace aresta
