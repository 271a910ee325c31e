// SPDX-License-Identifier: Apache-2.0
#include "geometry/recognize.h"

#include <gtest/gtest.h>
#include <Geom_OffsetSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>

#include "geometry/occt_handles.h"
#include "samples.h"

namespace aresta {
namespace {

Curve nurbs(const Curve& c, Range r) {
  return *FreeCurve::from_nurbs(c.to_nurbs(r));
}
Surface nurbs(const Surface& s, const Range2& r) {
  return *FreeSurface::from_nurbs(s.to_nurbs(r));
}

TEST(RecognizeCurve, EveryFormComesBack) {
  for (const auto& [name, curve, range] : samples::curves()) {
    if (name == "nurbs") continue;
    const Curve free = nurbs(curve, range);
    const auto found = recognize_piece(free, free.domain(), 1e-9);
    ASSERT_TRUE(found.has_value()) << name;
    EXPECT_STREQ(found->curve.kind(), curve.kind());
    EXPECT_LT(found->deviation, 1e-12);
    for (int i = 0; i <= 100; ++i) {
      const Vec3 p = free.point(free.domain().at(i / 100.0));
      EXPECT_LT(found->curve.project(p, found->range).distance, 1e-12) << name;
    }
    // Direction and ends are those of the piece.
    EXPECT_LT(distance(found->curve.point(found->range.low), curve.point(range.low)), 1e-11) << name;
    EXPECT_LT(distance(found->curve.point(found->range.high), curve.point(range.high)), 1e-11) << name;
    EXPECT_GT(dot(found->curve.jet(found->range.low).d1, curve.jet(range.low).d1), 0) << name;
    EXPECT_NEAR(found->curve.length(found->range), curve.length(range), 1e-10) << name;
    EXPECT_EQ(found->same_parameters, name == "line");
    if (const auto* c = curve.get_if<Circle>()) {
      EXPECT_NEAR(found->curve.get_if<Circle>()->radius, c->radius, 1e-12);
    }
    if (const auto* e = curve.get_if<Ellipse>()) {
      EXPECT_NEAR(found->curve.get_if<Ellipse>()->major, e->major, 1e-11);
      EXPECT_NEAR(found->curve.get_if<Ellipse>()->minor, e->minor, 1e-11);
    }
  }
}

TEST(RecognizeCurve, FreeFormsStayFree) {
  const Curve free(samples::free_curve());
  EXPECT_FALSE(recognize(free, {0, 4}, 1e-6).has_value());
  EXPECT_TRUE(recognize(free, {1, 1 + 1e-4}, 1e-3).has_value() == false);  // a piece as small as the tolerance
  EXPECT_FALSE(recognize(free, {0, std::numeric_limits<double>::infinity()}, 1e-6).has_value());
  EXPECT_FALSE(recognize(free, {0, 4}, 0).has_value());
  EXPECT_FALSE(recognize(free, {0, 4}, std::nan("")).has_value());
  EXPECT_FALSE(recognize(free, {3, 1}, 1e-6).has_value());
}

TEST(RecognizeCurve, TheToleranceIsKept) {
  NurbsCurveData d = Curve(Circle{samples::crooked(), 2}).to_nurbs({0, 6});
  const Vec3 z = samples::crooked().z;
  d.poles[3] = d.poles[3] + 1e-4 * z;
  const Curve bent(*FreeCurve::from_nurbs(d));
  EXPECT_FALSE(recognize(bent, bent.domain(), 1e-5).has_value());
  const auto found = recognize_piece(bent, bent.domain(), 1e-3);
  ASSERT_TRUE(found.has_value());
  double farthest = 0;
  for (int i = 0; i <= 5000; ++i) {
    const Vec3 p = bent.point(bent.domain().at(i / 5000.0));
    farthest = std::max(farthest, found->curve.project(p, found->curve.domain()).distance);
  }
  EXPECT_LE(farthest, found->deviation);
  EXPECT_GT(farthest, found->deviation / 10);
}

TEST(RecognizeCurve, ACurveThatTurnsBackIsNoLine) {
  const NurbsCurveData d{2, false, {0, 1}, {3, 3}, {{0, 0, 0}, {3, 0, 0}, {1, 0, 0}}, {}};
  const Curve back(*FreeCurve::from_nurbs(d));
  EXPECT_FALSE(recognize(back, {0, 1}, 1e-6).has_value());
  EXPECT_TRUE(recognize(back, {0, 0.5}, 1e-6).has_value());
}

TEST(RecognizeCurve, AParabolaIsNoEllipse) {
  const NurbsCurveData d{2, false, {0, 1}, {3, 3}, {{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}}, {}};
  EXPECT_FALSE(recognize(*FreeCurve::from_nurbs(d), {0, 1}, 1e-6).has_value());
  // The same poles with a middle weight below one are an ellipse.
  NurbsCurveData e = d;
  e.weights = {1, 0.4, 1};
  const auto found = recognize(*FreeCurve::from_nurbs(e), {0, 1}, 1e-9);
  ASSERT_TRUE(found.has_value());
  EXPECT_STREQ(found->kind(), "ellipse");
}

void expect_form(const std::string& name, const Surface& free, const Range2& piece, const Surface& expected,
                 double tolerance = 1e-8) {
  const auto found = recognize_piece(free, piece, tolerance);
  ASSERT_TRUE(found.has_value()) << name;
  EXPECT_STREQ(found->surface.kind(), expected.kind()) << name;
  EXPECT_LE(found->deviation, tolerance) << name;
  EXPECT_TRUE(coincident(expected, expected.is_plane() ? Range2{{-1, 1}, {-1, 1}} : Range2{{0, 6}, {0.1, 1}},
                         found->surface, 1e-9))
      << name;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const Vec2 uv{piece.u.at(i / 10.0), piece.v.at(j / 10.0)};
      const SurfaceProjection q = found->surface.project(free.point(uv));
      EXPECT_LT(q.distance, 1e-11) << name;
      if (i % 3 == 1 && j % 3 == 1 && i < 10 && j < 10) {
        const double d = dot(found->surface.normal(q.uv), free.normal(uv));
        EXPECT_EQ(d > 0, found->same_normal) << name;
        if (found->same_parameters) {
          EXPECT_LT(distance(found->surface.point(uv), free.point(uv)), 1e-8) << name;
        }
      }
    }
  }
}

TEST(RecognizeSurface, EveryFormComesBack) {
  for (const auto& [name, s, piece] : samples::surfaces()) {
    if (name == "nurbs" || name.find("spindle") != std::string::npos) continue;
    if (name.find("apex") != std::string::npos) continue;  // both nappes in one piece: its normals change sides
    const Surface free = nurbs(s, piece);
    expect_form(name, free, free.domain(), s);
  }
}

TEST(RecognizeSurface, WholeClosedForms) {
  const double half = samples::pi / 2;
  const Range turn{0, 2 * samples::pi};
  for (const bool left : {false, true}) {
    const Frame f = samples::crooked(left);
    const Surface sphere(Sphere{f, 2}), torus(Torus{f, 3, 1}), cylinder(Cylinder{f, 1}), cone(Cone{f, 0, 0.5});
    const Surface whole = nurbs(sphere, {turn, {-half, half}});
    expect_form("sphere", whole, whole.domain(), sphere);
    // Poles and seam are where the degenerate sides and the closing side of the piece are.
    const auto found = recognize_piece(whole, whole.domain(), 1e-8);
    const Sphere* form = found->surface.get_if<Sphere>();
    EXPECT_NEAR(std::abs(dot(form->frame.z, f.z)), 1, 1e-12);
    EXPECT_LT(distance(form->frame.x, f.x), 1e-11);
    EXPECT_TRUE(form->frame.right_handed());
    const Surface ring = nurbs(torus, {turn, turn});
    expect_form("torus", ring, ring.domain(), torus);
    const Surface tube = nurbs(cylinder, {turn, {0, 4}});
    expect_form("cylinder", tube, tube.domain(), cylinder);
    const auto tube_form = recognize(tube, tube.domain(), 1e-8);
    EXPECT_LT(distance(tube_form->get_if<Cylinder>()->frame.x, f.x), 1e-11);
    const Surface hat = nurbs(cone, {turn, {0, 4}});
    expect_form("cone", hat, hat.domain(), cone);
    const auto hat_form = recognize(hat, hat.domain(), 1e-8);
    EXPECT_EQ(hat_form->get_if<Cone>()->radius, 0);
    EXPECT_LT(distance(hat_form->get_if<Cone>()->frame.origin, f.origin), 1e-11);
  }
}

TEST(RecognizeSurface, SmallPatchesOfLargeForms) {
  const Frame f = samples::crooked();
  const std::vector<std::pair<Surface, Range2>> all = {{Cylinder{f, 100}, {{1, 1.05}, {0, 5}}},
                                                       {Sphere{f, 100}, {{1, 1.05}, {0.2, 0.25}}},
                                                       {Torus{f, 100, 20}, {{1, 1.05}, {0.2, 0.4}}},
                                                       {Cone{f, 100, 0.3}, {{1, 1.1}, {0, 5}}}};
  for (const auto& [s, piece] : all) {
    const Surface free = nurbs(s, piece);
    const auto found = recognize_piece(free, free.domain(), 1e-7);
    ASSERT_TRUE(found.has_value()) << s.kind();
    EXPECT_STREQ(found->surface.kind(), s.kind());
    for (int i = 0; i <= 10; ++i) {
      EXPECT_LT(found->surface.project(free.point({free.domain().u.at(i / 10.0), free.domain().v.at(0.3)})).distance,
                1e-9);
    }
  }
}

TEST(RecognizeSurface, RevolutionsExtrusionsAndOffsets) {
  const Frame f = samples::crooked();
  const gp_Ax1 axis(gp_Pnt(f.origin.x, f.origin.y, f.origin.z), gp_Dir(f.z.x, f.z.y, f.z.z));
  const gp_Dir up(f.z.x, f.z.y, f.z.z);
  const Range turn{0, 2 * samples::pi};
  const auto revolved = [&](const Curve& c) {
    return from_occt(Handle(Geom_Surface)(new Geom_SurfaceOfRevolution(to_occt(c), axis)));
  };
  const auto extruded = [&](const Curve& c) {
    return from_occt(Handle(Geom_Surface)(new Geom_SurfaceOfLinearExtrusion(to_occt(c), up)));
  };
  const Surface tube = revolved(Line{f.origin + 2 * f.x, f.z});
  EXPECT_STREQ(tube.kind(), "revolution");
  expect_form("revolved line", tube, {turn, {-1, 4}}, Cylinder{f, 2});
  expect_form("revolved slanting line", revolved(Line{f.origin + 2 * f.x, normalized(f.z + f.x)}), {turn, {0, 4}},
              Cone{f, 2, samples::pi / 4});
  expect_form("revolved line across", revolved(Line{f.origin, f.x}), {turn, {1, 4}}, Plane{f});
  const Frame meridian{f.origin, f.x, f.z, -f.y}, tube_frame{f.origin + 3 * f.x, f.x, f.z, -f.y};
  expect_form("revolved circle", revolved(Circle{tube_frame, 1}), {turn, turn}, Torus{f, 3, 1});
  expect_form("revolved half circle", revolved(Circle{meridian, 2}), {turn, {-samples::pi / 2, samples::pi / 2}},
              Sphere{f, 2});
  const Surface cylinder = extruded(Circle{f, 2});
  EXPECT_STREQ(cylinder.kind(), "extrusion");
  expect_form("extruded circle", cylinder, {turn, {0, 3}}, Cylinder{f, 2});
  expect_form("extruded line", extruded(Line{f.origin, f.x}), {{-1, 2}, {0, 3}}, Plane{{f.origin, f.x, f.z, -f.y}});
  EXPECT_TRUE(recognize_piece(extruded(Line{f.origin, f.x}), {{-1, 2}, {0, 3}}, 1e-8)->same_parameters);
  EXPECT_FALSE(recognize(extruded(Ellipse{f, 3, 1}), {turn, {0, 3}}, 1e-6).has_value());
  // Offsets: outwards is along the natural normal, which a left-handed frame turns inwards.
  for (const bool left : {false, true}) {
    const Frame g = samples::crooked(left);
    const double out = left ? -0.25 : 0.25;
    const std::vector<std::pair<Surface, Surface>> pairs = {{Cylinder{g, 2}, Cylinder{g, 2 + out}},
                                                            {Sphere{g, 2}, Sphere{g, 2 + out}},
                                                            {Torus{g, 3, 1}, Torus{g, 3, 1 + out}}};
    for (const auto& [basis, expected] : pairs) {
      const Surface offset = from_occt(Handle(Geom_Surface)(new Geom_OffsetSurface(to_occt(basis), 0.25)));
      EXPECT_STREQ(offset.kind(), "offset");
      expect_form("offset", offset, {{0.2, 6}, {0.1, 1}}, expected);
      EXPECT_TRUE(recognize_piece(offset, {{0.2, 6}, {0.1, 1}}, 1e-8)->same_parameters);
    }
    const Surface cone(Cone{g, 2, 0.4});
    const Surface offset = from_occt(Handle(Geom_Surface)(new Geom_OffsetSurface(to_occt(cone), 0.25)));
    const auto found = recognize(offset, {{0.2, 6}, {0.1, 1}}, 1e-8);
    ASSERT_TRUE(found.has_value());
    for (int i = 0; i <= 10; ++i)
      EXPECT_LT(distance(found->point({0.6 * i, 0.5}), offset.point({0.6 * i, 0.5})), 1e-14);
  }
}

TEST(RecognizeSurface, EllipsoidsAndFreeFormsStayFree) {
  const Surface sphere = nurbs(Surface(Sphere{{}, 2}), {{0, 2 * samples::pi}, {-samples::pi / 2, samples::pi / 2}});
  const Surface flat = *sphere.transformed(Transform::from_rows({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.9, 0}));
  EXPECT_FALSE(recognize(flat, flat.domain(), 1e-4).has_value());
  const Surface slightly = *sphere.transformed(Transform::from_rows({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.9999, 0}));
  EXPECT_FALSE(recognize(slightly, slightly.domain(), 1e-5).has_value());
  const auto near = recognize_piece(slightly, slightly.domain(), 1e-2);
  ASSERT_TRUE(near.has_value());
  double farthest = 0;
  for (int i = 0; i <= 100; ++i) {
    for (int j = 0; j <= 100; ++j) {
      const Vec2 uv{slightly.domain().u.at(i / 100.0), slightly.domain().v.at(j / 100.0)};
      farthest = std::max(farthest, near->surface.project(slightly.point(uv)).distance);
    }
  }
  EXPECT_LE(farthest, near->deviation);
  EXPECT_GT(farthest, 5e-5);
  const Surface free(samples::free_surface());
  EXPECT_FALSE(recognize(free, free.domain(), 1e-3).has_value());
  EXPECT_FALSE(recognize(free, {{0, 1}, {0, std::numeric_limits<double>::infinity()}}, 1e-3).has_value());
  EXPECT_FALSE(recognize(free, free.domain(), -1).has_value());
}

/// A bump between the samples: the bound sees what the samples do not.
TEST(RecognizeSurface, ABumpBetweenSamplesIsSeen) {
  NurbsSurfaceData d;
  d.degree_u = d.degree_v = 2;
  const int spans = 60;
  for (int i = 0; i <= spans; ++i) {
    d.knots_u.push_back(i);
    d.multiplicities_u.push_back(i == 0 || i == spans ? 3 : 1);
  }
  d.knots_v = d.knots_u;
  d.multiplicities_v = d.multiplicities_u;
  d.count_u = d.count_v = spans + 2;
  const auto greville = [&](std::size_t i) {
    return (std::clamp(static_cast<double>(i) - 1, 0.0, 60.0) + std::clamp(static_cast<double>(i), 0.0, 60.0)) / 2;
  };
  for (std::size_t i = 0; i < d.count_u; ++i) {
    for (std::size_t j = 0; j < d.count_v; ++j) d.poles.push_back({greville(i), greville(j), 0});
  }
  ASSERT_TRUE(recognize(*FreeSurface::from_nurbs(d), {{0, 60}, {0, 60}}, 1e-6).has_value());
  // Samples lie at 2.5, 7.5, ...: this pole moves u, v in [4, 7].
  d.poles[6 * d.count_v + 6].z = 1;
  EXPECT_FALSE(recognize(*FreeSurface::from_nurbs(d), {{0, 60}, {0, 60}}, 1e-6).has_value());
  d.poles[6 * d.count_v + 6].z = 0;
  d.poles[5 * d.count_v + 5].z = 0.01;  // moves [3, 6]: no sample
  EXPECT_FALSE(recognize(*FreeSurface::from_nurbs(d), {{0, 60}, {0, 60}}, 1e-6).has_value());
}

}  // namespace
}  // namespace aresta
