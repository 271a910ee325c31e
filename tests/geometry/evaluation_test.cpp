// SPDX-License-Identifier: Apache-2.0
// Evaluation: derivatives against differences, and every form against the kernel's own evaluators.
#include <gtest/gtest.h>

#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "geometry/occt_handles.h"
#include "samples.h"

namespace aresta {
namespace {

Vec3 vec(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}
Vec3 vec(const gp_Vec& p) {
  return {p.X(), p.Y(), p.Z()};
}

TEST(Evaluation, ClosedFormsByHand) {
  const Frame f;
  EXPECT_LT(distance(Curve(Circle{f, 2}).point(samples::pi / 2), {0, 2, 0}), 1e-15);
  EXPECT_LT(distance(Curve(Ellipse{f, 3, 2}).point(samples::pi), {-3, 0, 0}), 1e-15);
  EXPECT_EQ(Curve(Line({{1, 1, 1}, {0, 0, 1}})).point(4), (Vec3{1, 1, 5}));
  EXPECT_EQ(Surface(Plane{f}).point({3, 4}), (Vec3{3, 4, 0}));
  EXPECT_LT(distance(Surface(Cylinder{f, 2}).point({samples::pi, 5}), {-2, 0, 5}), 1e-15);
  EXPECT_LT(distance(Surface(Cone{f, 1, samples::pi / 4}).point({0, std::sqrt(2.0)}), {2, 0, 1}), 1e-15);
  EXPECT_LT(distance(Surface(Sphere{f, 2}).point({1, samples::pi / 2}), {0, 0, 2}), 1e-15);
  EXPECT_LT(distance(Surface(Torus{f, 5, 2}).point({samples::pi / 2, samples::pi / 2}), {0, 5, 2}), 1e-14);
}

TEST(Evaluation, CurveDerivativesAgreeWithDifferences) {
  for (const auto& [name, curve, range] : samples::curves()) {
    for (int i = 1; i < 20; ++i) {
      const double t = range.at(i / 20.0), h = 1e-5;
      const CurveJet j = curve.jet(t);
      EXPECT_LT(distance(j.point, curve.point(t)), 1e-14) << name;
      EXPECT_LT(distance(j.d1, (curve.point(t + h) - curve.point(t - h)) / (2 * h)), 1e-8) << name << " " << t;
      EXPECT_LT(distance(j.d2, (curve.jet(t + h).d1 - curve.jet(t - h).d1) / (2 * h)), 1e-6) << name << " " << t;
    }
  }
}

TEST(Evaluation, SurfaceDerivativesAgreeWithDifferences) {
  for (const auto& [name, s, piece] : samples::surfaces()) {
    for (int i = 1; i < 12; ++i) {
      const Vec2 w{piece.u.at(i / 12.0), piece.v.at((i * 5 % 12) / 12.0 + 0.013)};
      const double h = 1e-5;
      const Vec2 hu{h, 0}, hv{0, h};
      const SurfaceJet j = s.jet(w);
      EXPECT_LT(distance(j.point, s.point(w)), 1e-14) << name;
      EXPECT_LT(distance(j.du, (s.point(w + hu) - s.point(w - hu)) / (2 * h)), 1e-8) << name;
      EXPECT_LT(distance(j.dv, (s.point(w + hv) - s.point(w - hv)) / (2 * h)), 1e-8) << name;
      EXPECT_LT(distance(j.duu, (s.jet(w + hu).du - s.jet(w - hu).du) / (2 * h)), 1e-6) << name;
      EXPECT_LT(distance(j.duv, (s.jet(w + hv).du - s.jet(w - hv).du) / (2 * h)), 1e-6) << name;
      EXPECT_LT(distance(j.dvv, (s.jet(w + hv).dv - s.jet(w - hv).dv) / (2 * h)), 1e-6) << name;
      const Vec3 n = s.normal(w);
      EXPECT_NEAR(norm(n), 1, 1e-14) << name;
      EXPECT_LT(distance(n, normalized(cross(j.du, j.dv))), 1e-12) << name;
    }
  }
}

TEST(Evaluation, CurvesAgreeWithTheKernel) {
  for (const auto& [name, curve, range] : samples::curves()) {
    const Handle(Geom_Curve) kernel = to_occt(curve);
    for (int i = 0; i <= 20; ++i) {
      const double t = range.at(i / 20.0);
      gp_Pnt p;
      gp_Vec d1, d2;
      kernel->D2(t, p, d1, d2);
      const CurveJet j = curve.jet(t);
      EXPECT_LT(distance(j.point, vec(p)), 1e-14) << name;
      EXPECT_LT(distance(j.d1, vec(d1)), 1e-14) << name;
      EXPECT_LT(distance(j.d2, vec(d2)), 1e-14) << name;
    }
    EXPECT_STREQ(from_occt(kernel).kind(), curve.kind());
    EXPECT_LT(distance(from_occt(kernel).point(range.middle()), curve.point(range.middle())), 1e-14) << name;
  }
}

TEST(Evaluation, SurfacesAgreeWithTheKernelInBothHands) {
  for (const auto& [name, s, piece] : samples::surfaces()) {
    const Handle(Geom_Surface) kernel = to_occt(s);
    const Surface back = from_occt(kernel);
    EXPECT_STREQ(back.kind(), s.kind());
    for (int i = 0; i <= 10; ++i) {
      const Vec2 w{piece.u.at(i / 10.0), piece.v.at((i * 3 % 11) / 11.0)};
      gp_Pnt p;
      gp_Vec du, dv, duu, dvv, duv;
      kernel->D2(w.x, w.y, p, du, dv, duu, dvv, duv);
      const SurfaceJet j = s.jet(w);
      EXPECT_LT(distance(j.point, vec(p)), 1e-14) << name;
      EXPECT_LT(distance(j.du, vec(du)), 1e-14) << name;
      EXPECT_LT(distance(j.dv, vec(dv)), 1e-14) << name;
      EXPECT_LT(distance(j.duu, vec(duu)), 1e-14) << name;
      EXPECT_LT(distance(j.duv, vec(duv)), 1e-14) << name;
      EXPECT_LT(distance(j.dvv, vec(dvv)), 1e-14) << name;
      EXPECT_LT(distance(back.point(w), j.point), 1e-14) << name;
      EXPECT_LT(distance(back.normal(w), s.normal(w)), 1e-14) << name;
    }
  }
}

TEST(Evaluation, DomainsAndPeriods) {
  EXPECT_EQ(Curve(Line{{}, {1, 0, 0}}).period(), 0);
  EXPECT_EQ(Curve(Circle{{}, 1}).period(), 2 * samples::pi);
  EXPECT_TRUE(std::isinf(Curve(Line{{}, {1, 0, 0}}).domain().high));
  EXPECT_EQ(Curve(samples::free_curve()).domain(), (Range{0, 4}));
  EXPECT_EQ(Surface(Torus{{}, 2, 1}).period(), (Vec2{2 * samples::pi, 2 * samples::pi}));
  EXPECT_EQ(Surface(Sphere{{}, 1}).domain().v, (Range{-samples::pi / 2, samples::pi / 2}));
  EXPECT_EQ(Surface(samples::free_surface()).domain().v, (Range{-1, 3}));
}

TEST(Evaluation, NormalsAtSingularPoints) {
  const double half = samples::pi / 2;
  EXPECT_LT(distance(Surface(Sphere{{}, 2}).normal({0.7, half}), {0, 0, 1}), 1e-15);
  EXPECT_LT(distance(Surface(Sphere{{}, 2}).normal({0.7, -half}), {0, 0, -1}), 1e-15);
  // The apex: along u = const the normal does not change, so that is its limit.
  const Surface cone(Cone{{}, 0, samples::pi / 6});
  EXPECT_LT(distance(cone.normal({0, 0}), {std::cos(samples::pi / 6), 0, -0.5}), 1e-15);
  EXPECT_LT(distance(cone.normal({0, 1e-9}), cone.normal({0, 0})), 1e-15);
  // A NURBS sphere has collapsed rows of poles at its poles.
  const Surface sphere(
      *FreeSurface::from_nurbs(Surface(Sphere{{}, 2}).to_nurbs({{0, 2 * samples::pi}, {-half, half}})));
  EXPECT_LT(distance(sphere.normal({0.7, half}), {0, 0, 1}), 1e-7);
  EXPECT_LT(distance(sphere.normal({0.7, -half}), {0, 0, -1}), 1e-7);
}

}  // namespace
}  // namespace aresta
