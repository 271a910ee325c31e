// SPDX-License-Identifier: Apache-2.0
// Models whose every curve and surface a file stores as a B-spline come back in their true forms.
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepTools.hxx>
#include <fstream>
#include <map>
#include <numbers>
#include <set>

#include "construct/move.h"
#include "construct/primitives.h"
#include "files.h"
#include "fragment/fragment.h"
#include "model/check.h"
#include "occt/shape_data.h"
#include "occt/to_shape.h"
#include "support/ellipsoid.h"

namespace aresta::test {
namespace {

constexpr double pi = std::numbers::pi;

Model take(Result<Model> model) {
  EXPECT_TRUE(model.ok()) << model.error().to_line();
  return model.ok() ? std::move(model).value() : Model();
}

std::string notes(const ImportReport& report) {
  std::string all;
  for (const std::string& note : report.notes) all += note + "; ";
  return all;
}

/// Written with all geometry turned into B-splines, and read again.
Model through_splines(const Model& model, const std::string& name, ImportReport& report) {
  auto shape = to_shape(model);
  EXPECT_TRUE(shape.ok()) << shape.error().to_line();
  const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(shape->whole().data().shape, true).Shape();
  const std::string path = (own_folder("recognize_" + name) / "splines.brep").string();
  {
    std::ofstream out(path);
    BRepTools::Write(splines, out);
  }
  ImportOptions options;
  options.report = &report;
  options.level = CheckLevel::full;
  return take(import_file(path, options));
}

std::map<std::string, int> kinds(const Model& model) {
  std::map<std::string, int> count;
  for (const FaceId f : model.topology().faces()) ++count[model.surface(f).kind()];
  return count;
}

std::set<std::string> curve_kinds(const Model& model) {
  std::set<std::string> found;
  for (const EdgeId e : model.topology().edges()) found.insert(model.curve(e).kind());
  return found;
}

TEST(RecognizeForms, EveryAnalyticSurfaceIsFoundAgain) {
  const Placement tilted{{3, -2, 5}, {1, 2, 3}};
  struct Case {
    const char* name;
    Model model;
  };
  const Case cases[] = {
      {"block", take(block(2, 3, 4))},
      {"cylinder", take(cylinder(2, 5, tilted))},
      {"cylinder_in_patches", take(cylinder(2, 5, tilted, {3, 20}))},
      {"frustum", take(cone(3, 1, 4, tilted))},
      {"cone", take(cone(3, 0, 4, tilted))},
      {"sphere", take(sphere(2, tilted))},
      {"sphere_in_patches", take(sphere(2, tilted, {2, 0}))},
      {"torus", take(torus(5, 1, tilted))},
      {"mirrored_cylinder", take(mirror(take(cylinder(2, 5, tilted)), {0, 0, 0}, {1, 1, 0}))},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    ImportReport report;
    const Model again = through_splines(c.model, c.name, report);
    EXPECT_EQ(kinds(again), kinds(c.model)) << notes(report);
    EXPECT_EQ(curve_kinds(again), curve_kinds(c.model));
    EXPECT_EQ(counts(again), counts(c.model));
    EXPECT_NEAR(volume(again), volume(c.model), 1e-8 * volume(c.model));
    EXPECT_NE(notes(report).find("planes, cylinders, cones, spheres or tori"), std::string::npos) << notes(report);
  }
}

TEST(RecognizeForms, FacesWithHolesAndCutSides) {
  // A drilled block, and a rod cut by a slanting plane of another block: an ellipse, and its image in the side.
  const auto keep = [](Result<Model> model) { return std::make_shared<const Model>(take(std::move(model))); };
  const auto drilled = fragment({keep(block(4, 4, 2)), keep(cylinder(1, 4, {{2, 2, -1}, {0, 0, 1}}))}, {}, {});
  const auto cut =
      fragment({keep(cylinder(1, 6)), keep(rotate(take(block(8, 8, 8, {-4, -4, 3})), 30, {1, 0, 0}))}, {}, {});
  ASSERT_TRUE(drilled.ok() && cut.ok());
  for (const auto& model : {drilled->model, cut->model}) {
    ImportReport report;
    const Model again = through_splines(*model, "cut", report);
    EXPECT_EQ(kinds(again), kinds(*model)) << notes(report);
    EXPECT_EQ(counts(again), counts(*model));
    EXPECT_NEAR(volume(again), volume(*model), 1e-8 * volume(*model));
  }
}

TEST(RecognizeForms, WhatIsNoAnalyticFormStays) {
  ModelBuilder b;
  add_ellipsoid(b, {2, 1});
  const Model ellipsoid = take(b.build(Context{}));
  ImportReport report;
  const Model again = through_splines(ellipsoid, "ellipsoid", report);
  EXPECT_EQ(kinds(again), (std::map<std::string, int>{{"nurbs", 1}}));
  EXPECT_NEAR(volume(again), 16 * pi / 3, 1e-6);
  // Of equal half axes it is a sphere, whose poles and seam stay where they were.
  ModelBuilder round;
  add_ellipsoid(round, {1, 1});
  const Model ball = through_splines(take(round.build(Context{})), "ball", report);
  EXPECT_EQ(kinds(ball), (std::map<std::string, int>{{"sphere", 1}})) << notes(report);
  EXPECT_EQ(counts(ball), "1/1/1/2");
  EXPECT_NEAR(volume(ball), 4 * pi / 3, 1e-9);
}

}  // namespace
}  // namespace aresta::test
