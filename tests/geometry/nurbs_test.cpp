// SPDX-License-Identifier: Apache-2.0
// NURBS forms there and back, and bad data refused.
#include <gtest/gtest.h>

#include <limits>

#include "samples.h"

namespace aresta {
namespace {

TEST(Nurbs, CurvesKeepTheirPoints) {
  for (const auto& [name, curve, range] : samples::curves()) {
    const auto back = FreeCurve::from_nurbs(curve.to_nurbs(range));
    ASSERT_TRUE(back.ok()) << name;
    const Curve nurbs(*back);
    EXPECT_STREQ(nurbs.kind(), "nurbs");
    const Range d = nurbs.domain();
    EXPECT_LT(distance(nurbs.point(d.low), curve.point(range.low)), 1e-14) << name;
    EXPECT_LT(distance(nurbs.point(d.high), curve.point(range.high)), 1e-14) << name;
    for (int i = 0; i <= 200; ++i) {
      EXPECT_LT(curve.project(nurbs.point(d.at(i / 200.0)), range).distance, 1e-14) << name;
    }
    EXPECT_NEAR(nurbs.length(d), curve.length(range), 1e-11) << name;
  }
}

TEST(Nurbs, SurfacesKeepTheirPoints) {
  for (const auto& [name, s, piece] : samples::surfaces()) {
    const auto back = FreeSurface::from_nurbs(s.to_nurbs(piece));
    ASSERT_TRUE(back.ok()) << name;
    const Surface nurbs(*back);
    const Range2 d = nurbs.domain();
    for (const Vec2 corner : {Vec2{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
      EXPECT_LT(distance(nurbs.point({d.u.at(corner.x), d.v.at(corner.y)}),
                         s.point({piece.u.at(corner.x), piece.v.at(corner.y)})),
                1e-14)
          << name;
    }
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 20; ++j) {
        const Vec2 uv{d.u.at(i / 20.0), d.v.at(j / 20.0)};
        ASSERT_LT(s.project(nurbs.point(uv)).distance, 1e-14) << name;
        if (i % 5 == 1 && j % 5 == 1) {
          EXPECT_GT(dot(nurbs.normal(uv), s.normal(s.project(nurbs.point(uv)).uv)), 0.99) << name;
        }
      }
    }
  }
}

TEST(Nurbs, InfinitePiecesHaveNone) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Curve(Line{{}, {1, 0, 0}}).to_nurbs({0, inf}).degree, 0);
  EXPECT_TRUE(Surface(Plane{}).to_nurbs({{-inf, inf}, {0, 1}}).poles.empty());
}

TEST(Nurbs, BadCurvesAreRefusedByName) {
  const NurbsCurveData good{2, false, {0, 1, 2}, {3, 1, 3}, {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}}, {1, 2, 1, 1}};
  ASSERT_TRUE(FreeCurve::from_nurbs(good).ok());
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  std::vector<std::pair<NurbsCurveData, std::string>> bad;
  const auto with = [&](auto change, const char* says) {
    NurbsCurveData d = good;
    change(d);
    bad.emplace_back(d, says);
  };
  with([](auto& d) { d.degree = 0; }, "degree is 0");
  with([](auto& d) { d.degree = 26; }, "degree is 26");
  with([](auto& d) { d.degree = -3; }, "degree is -3");
  with([](auto& d) { d.knots = {}; }, "fewer than two");
  with([](auto& d) { d.knots = {0, 1}; }, "multiplicities");
  with([](auto& d) { d.knots = {0, 0, 2}; }, "knot 1 is not larger");
  with([](auto& d) { d.knots = {0, 3, 2}; }, "knot 2 is not larger");
  with([&](auto& d) { d.knots[1] = nan; }, "knot 1 is not a finite");
  with([&](auto& d) { d.knots[2] = inf; }, "knot 2 is not a finite");
  with([](auto& d) { d.multiplicities[1] = 0; }, "multiplicity 0");
  with([](auto& d) { d.multiplicities[1] = 3; }, "multiplicity 3");
  with([](auto& d) { d.multiplicities[0] = 4; }, "multiplicity 4");
  with(
      [](auto& d) {
        d.poles.pop_back();
        d.weights.pop_back();
      },
      "sum to 7");
  with([&](auto& d) { d.poles[2].y = nan; }, "pole 2");
  with([&](auto& d) { d.poles[0].z = -inf; }, "pole 0");
  with([](auto& d) { d.weights.pop_back(); }, "3 weights");
  with([](auto& d) { d.weights[1] = 0; }, "weight 1");
  with([](auto& d) { d.weights[1] = -1; }, "weight 1");
  with([&](auto& d) { d.weights[3] = nan; }, "weight 3");
  with([](auto& d) { d.periodic = true; }, "multiplicity 3");
  with(
      [](auto& d) {
        d.poles = {};
        d.weights = {};
      },
      "fewer than two");
  for (const auto& [data, says] : bad) {
    const auto r = FreeCurve::from_nurbs(data);
    ASSERT_FALSE(r.ok()) << says;
    EXPECT_EQ(r.error().code, errors::bad_geometry);
    EXPECT_NE(r.error().message.find(says), std::string::npos) << r.error().message << " / " << says;
  }
  NurbsCurve2Data flat{1, false, {0, 1}, {2, 2}, {{0, 0}, {1, 1}}, {}};
  EXPECT_TRUE(FreeCurve2::from_nurbs(flat).ok());
  flat.poles[1].x = nan;
  EXPECT_EQ(FreeCurve2::from_nurbs(flat).error().code, errors::bad_geometry);
}

TEST(Nurbs, BadSurfacesAreRefusedByName) {
  NurbsSurfaceData d = Surface(Cylinder{{}, 1}).to_nurbs({{0, 1}, {0, 1}});
  ASSERT_TRUE(FreeSurface::from_nurbs(d).ok());
  NurbsSurfaceData few = d;
  few.poles.pop_back();
  EXPECT_EQ(FreeSurface::from_nurbs(few).error().code, errors::bad_geometry);
  NurbsSurfaceData weights = d;
  weights.weights[2] = -1;
  EXPECT_EQ(FreeSurface::from_nurbs(weights).error().code, errors::bad_geometry);
  NurbsSurfaceData knots = d;
  knots.knots_v = {1, 1};
  EXPECT_NE(FreeSurface::from_nurbs(knots).error().message.find("v knot"), std::string::npos);
  NurbsSurfaceData huge = d;
  huge.count_u = std::numeric_limits<std::size_t>::max() / 2 + 1;
  huge.count_v = 2;
  EXPECT_EQ(FreeSurface::from_nurbs(huge).error().code, errors::bad_geometry);
}

TEST(Nurbs, PeriodicCurvesTurnAround) {
  // A closed uniform cubic: four poles of a square; the period is 4.
  const NurbsCurveData d{3, true, {0, 1, 2, 3, 4}, {1, 1, 1, 1, 1}, {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
                         {}};
  const auto made = FreeCurve::from_nurbs(d);
  ASSERT_TRUE(made.ok()) << made.error().message;
  const Curve c(*made);
  EXPECT_EQ(c.period(), 4);
  EXPECT_LT(distance(c.point(0.3), c.point(4.3)), 1e-15);
  EXPECT_NEAR(c.project(c.point(0.3), {3.5, 5}).parameter, 4.3, 1e-12);
  EXPECT_NEAR(c.project(c.point(0.3), {-4, 0}).parameter, -3.7, 1e-12);
  EXPECT_NEAR(c.length({0, 4}), c.length({1.5, 5.5}), 1e-12);
  const Box3 box = c.bounds({3.2, 4.9});
  for (int i = 0; i <= 100; ++i) EXPECT_TRUE(box.contains(c.point(3.2 + 1.7 * i / 100)));
  const auto piece = FreeCurve::from_nurbs(c.to_nurbs({3.2, 4.9}));
  ASSERT_TRUE(piece.ok());
  const Curve cut(*piece);
  EXPECT_LT(distance(cut.point(cut.domain().low), c.point(3.2)), 1e-14);
  EXPECT_LT(distance(cut.point(cut.domain().high), c.point(4.9)), 1e-14);
}

}  // namespace
}  // namespace aresta
