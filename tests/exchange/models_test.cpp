// SPDX-License-Identifier: Apache-2.0
// Models through files and back: solids that share faces, sheets, wires, points, names, colours, units.
#include <map>
#include <numbers>

#include "construct/move.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "exchange/errors.h"
#include "files.h"
#include "fragment/fragment.h"

namespace aresta::test {
namespace {

constexpr double pi = std::numbers::pi;

std::string path_of(const std::string& name) {
  static std::map<std::string, std::filesystem::path> folders;  // a folder per test, made once
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto [folder, is_new] = folders.try_emplace(test);
  if (is_new) folder->second = own_folder("models");
  return (folder->second / name).string();
}

std::shared_ptr<const Model> keep(Result<Model> model) {
  EXPECT_TRUE(model.ok()) << model.error().to_line();
  return std::make_shared<const Model>(std::move(model).value());
}

Model joined(std::vector<std::shared_ptr<const Model>> parts) {
  auto result = fragment(std::move(parts), {}, {});
  EXPECT_TRUE(result.ok()) << result.error().to_line();
  return result.ok() ? *result->model : Model();
}

Model two_boxes() {
  Model model = joined({keep(block(1, 1, 1)), keep(translate(*keep(block(1, 1, 1)), {1, 0, 0}))});
  const auto regions = model.regions();
  model.labels.set_name(regions[0], "left");
  model.labels.attributes[regions[0]]["color"] = std::string("#ff8000");
  model.labels.set_name(regions[1], "right/inner");
  model.labels.attributes[regions[1]]["color"] = std::string("#0080ff");
  return model;
}

std::size_t shared_faces(const Model& model) {
  std::size_t n = 0;
  const Complex& k = model.topology();
  for (const FaceId f : k.faces()) {
    n += k.region(FaceUse(f, 0)) != k.region(FaceUse(f, 1)) && model.is_region(k.region(FaceUse(f, 0))) &&
         model.is_region(k.region(FaceUse(f, 1)));
  }
  return n;
}

TEST(StepModels, SolidsThatShareAFaceStaySharedNamedAndColoured) {
  const Model model = two_boxes();
  ASSERT_EQ(counts(model), "2/11/20/12");
  const std::string path = path_of("two.step");
  auto written = export_file(model, path);
  ASSERT_TRUE(written.ok()) << written.error().to_line();
  ImportReport report;
  ImportOptions options;
  options.report = &report;
  auto back = import_file(path, options);
  ASSERT_TRUE(back.ok()) << back.error().to_line();
  EXPECT_EQ(counts(*back), "2/11/20/12");
  EXPECT_EQ(shared_faces(*back), 1u);
  EXPECT_NEAR(volume(*back), 2, 1e-12);
  EXPECT_EQ(back->provenance, nullptr);
  EXPECT_EQ(report.notes.size(), 1u) << notes(report);
  std::map<std::string, std::string> color_of;
  for (const RegionId r : back->regions()) {
    color_of[back->labels.name(r)] = std::get<std::string>(back->labels.attributes.at(r).at("color"));
  }
  EXPECT_EQ(color_of, (std::map<std::string, std::string>{{"left", "#ff8000"}, {"right/inner", "#0080ff"}}));
}

TEST(StepModels, SolidsThatTouchWithoutSharingStayApart) {
  Model apart;
  {
    const Model shared = two_boxes();
    const std::string path = path_of("shared.step");
    ASSERT_TRUE(export_file(shared, path).ok());
    // Without its record the file says two boxes, each with six faces of its own.
    auto text = read_file(path);
    ASSERT_TRUE(text.ok());
    const std::size_t at = text->find("aresta cells=");
    ASSERT_NE(at, std::string::npos);
    text->replace(at, 13, "another text=");
    auto back = import_file(file_with("foreign.step", *text));
    ASSERT_TRUE(back.ok()) << back.error().to_line();
    apart = std::move(back).value();
  }
  EXPECT_EQ(counts(apart), "2/12/24/16");
  EXPECT_NEAR(volume(apart), 2, 1e-12);
  const std::string path = path_of("apart.step");
  ASSERT_TRUE(export_file(apart, path).ok());
  auto again = import_file(path);
  ASSERT_TRUE(again.ok()) << again.error().to_line();
  EXPECT_EQ(counts(*again), "2/12/24/16");
}

/// A box cut by a square that reaches out of it, with a wire and a point on its top, a wire and a point far away.
Model mixture() {
  const std::vector<Vec3> square{{-1, -1, 0.5}, {2, -1, 0.5}, {2, 2, 0.5}, {-1, 2, 0.5}};
  return joined({keep(block(1, 1, 1)), keep(polygon(square)), keep(line({0.2, 0.2, 1}, {0.7, 0.4, 1})),
                 keep(point({0.3, 0.8, 1})), keep(line({5, 0, 0}, {6, 1, 0})), keep(point({7, 7, 7})),
                 keep(circle(0.5, {{9, 0, 0}, {0, 0, 1}}))});
}

TEST(Mixtures, KeepTheirCountsThroughStepAndBrep) {
  const Model model = mixture();
  // Box in two halves: 2 + 4 x 2 + 1 faces, and the square's rest. Edges: 12 + 4 for the halved uprights + 4 in the
  // plane
  // + 4 of the square; on the top a loose edge; apart a line and a circle. Vertices: 8 + 4 + 4 + 2 + 1 and 2 + 1 + 1.
  ASSERT_EQ(counts(model), "2/12/27/23");
  for (const char* name : {"mixture.step", "mixture.brep"}) {
    SCOPED_TRACE(name);
    const std::string path = path_of(name);
    auto written = export_file(model, path);
    ASSERT_TRUE(written.ok()) << written.error().to_line();
    ImportReport report;
    ImportOptions options;
    options.report = &report;
    auto back = import_file(path, options);
    ASSERT_TRUE(back.ok()) << back.error().to_line();
    EXPECT_EQ(counts(*back), counts(model)) << notes(report);
    EXPECT_NEAR(volume(*back), 1, 1e-12);
  }
}

TEST(StepModels, UnitsAreConverted) {
  ConstructOptions inches;
  inches.length_unit = 0.0254;
  const auto model = keep(block(1, 2, 3, {}, inches));
  const std::string path = path_of("inch.step");
  ASSERT_TRUE(export_file(*model, path).ok());
  ImportReport report;
  ImportOptions options;
  options.report = &report;
  auto in_mm = import_file(path, options);
  ASSERT_TRUE(in_mm.ok()) << in_mm.error().to_line();
  EXPECT_NEAR(volume(*in_mm), 6 * 25.4 * 25.4 * 25.4, 1e-7);
  EXPECT_EQ(in_mm->length_unit, 1e-3);
  EXPECT_NE(report.file_unit.find("INCH"), std::string::npos) << report.file_unit;
  options.length_unit = 0.0254;
  auto in_inches = import_file(path, options);
  ASSERT_TRUE(in_inches.ok());
  EXPECT_NEAR(volume(*in_inches), 6, 1e-9);
}

TEST(Exports, TheSameModelGivesTheSameBytes) {
  const Model model = two_boxes();
  for (const char* name : {"a.step", "a.brep", "a.stl", "a.obj"}) {
    SCOPED_TRACE(name);
    ASSERT_TRUE(export_file(model, path_of(name)).ok());
    const auto first = read_file(path_of(name));
    ASSERT_TRUE(export_file(model, path_of(name)).ok());
    const auto second = read_file(path_of(name));
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_EQ(*first, *second);
  }
}

TEST(Triangles, BoxThroughStlAndObj) {
  const auto model = keep(block(1, 2, 3));
  for (const bool ascii : {false, true}) {
    for (const char* name : {"box.stl", "box.obj"}) {
      SCOPED_TRACE(name);
      ExportOptions options;
      options.ascii = ascii;
      ASSERT_TRUE(export_file(*model, path_of(name), options).ok());
      auto back = import_file(path_of(name));
      ASSERT_TRUE(back.ok()) << back.error().to_line();
      EXPECT_EQ(counts(*back), "1/12/18/8");
      EXPECT_NEAR(volume(*back), 6, 1e-12);
    }
  }
}

TEST(Triangles, InterfacesAreLeftOutOfTheSkin) {
  ASSERT_TRUE(export_file(two_boxes(), path_of("union.stl")).ok());
  auto back = import_file(path_of("union.stl"));
  ASSERT_TRUE(back.ok()) << back.error().to_line();
  EXPECT_EQ(counts(*back), "1/20/30/12");
  EXPECT_NEAR(volume(*back), 2, 1e-12);
}

TEST(Triangles, SphereWithinItsDeflection) {
  ExportOptions options;
  options.deflection = 1e-3;
  ASSERT_TRUE(export_file(*keep(sphere(1)), path_of("sphere.stl"), options).ok());
  auto back = import_file(path_of("sphere.stl"));
  ASSERT_TRUE(back.ok()) << back.error().to_line();
  EXPECT_EQ(back->regions().size(), 1u);
  EXPECT_LT(volume(*back), 4 * pi / 3);
  EXPECT_GT(volume(*back), 4 * pi / 3 - 4 * pi * 3e-3);
}

TEST(Triangles, GroupsOfFacesAreKept) {
  const char* text =
      "# a tetrahedron\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng base\nf 1/1/1 3/2/2 2/3/3\ng side wall\nf -4 -3 -1\nf 2 "
      "3 4\n"
      "f 1 4 3\n";
  auto model = import_file(file_with("tetra.obj", text));
  ASSERT_TRUE(model.ok()) << model.error().to_line();
  EXPECT_EQ(counts(*model), "1/4/6/4");
  EXPECT_NEAR(volume(*model), 1.0 / 6, 1e-15);
  ASSERT_EQ(model->labels.groups.size(), 2u);
  EXPECT_EQ(model->labels.groups[0].name, "base");
  EXPECT_EQ(model->labels.groups[1].entities.size(), 3u);
}

TEST(Triangles, PolygonsThatAreNotPlaneAreCut) {
  const char* text =
      "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1.25\n0 1 1\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n"
      "4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  ImportReport report;
  ImportOptions options;
  options.report = &report;
  auto model = import_file(file_with("bent.off", text), options);
  ASSERT_TRUE(model.ok()) << model.error().to_line();
  EXPECT_EQ(counts(*model), "1/7/13/8");
  EXPECT_EQ(report.notes.size(), 1u) << notes(report);
}

TEST(Triangles, InsideOutAndOpenSurfaces) {
  ImportReport report;
  ImportOptions options;
  options.report = &report;
  const char* inside_out = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n";
  auto turned = import_file(file_with("inside_out.obj", inside_out), options);
  ASSERT_TRUE(turned.ok()) << turned.error().to_line();
  EXPECT_NEAR(volume(*turned), 1.0 / 6, 1e-15);
  EXPECT_EQ(report.notes.size(), 1u) << notes(report);
  const char* open = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";
  auto sheets = import_file(file_with("open.obj", open), options);
  ASSERT_TRUE(sheets.ok()) << sheets.error().to_line();
  EXPECT_EQ(counts(*sheets), "0/3/6/4");
  EXPECT_NE(notes(report).find("not closed (3 edges"), std::string::npos) << notes(report);
}

TEST(Triangles, PlyInItsThreeEncodings) {
  const std::string head =
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n";
  const float points[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  std::string text = "ply\nformat ascii 1.0\ncomment made by hand\n" + head;
  for (const auto& p : points) {
    for (const float x : p) text += std::to_string(static_cast<int>(x)) + " ";
    text += "255\n";
  }
  for (const auto& f : faces) {
    text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
  }
  std::vector<std::string> files{text};
  for (const bool big : {false, true}) {
    std::string binary = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + head;
    const auto append = [&](std::uint32_t bits) {
      for (int i = 0; i < 4; ++i) binary.push_back(static_cast<char>(bits >> (big ? 24 - 8 * i : 8 * i)));
    };
    for (const auto& p : points) {
      for (const float x : p) append(std::bit_cast<std::uint32_t>(x));
      binary.push_back('\xff');
    }
    for (const auto& f : faces) {
      binary.push_back(3);
      for (const int i : f) append(static_cast<std::uint32_t>(i));
    }
    files.push_back(binary);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    auto model = import_file(file_with("tetra" + std::to_string(i) + ".ply", files[i]));
    ASSERT_TRUE(model.ok()) << model.error().to_line();
    EXPECT_EQ(counts(*model), "1/4/6/4");
    EXPECT_NEAR(volume(*model), 8.0 / 6, 1e-12);
  }
  auto cut = import_file(file_with("cut.ply", files[1].substr(0, files[1].size() - 3)));
  ASSERT_FALSE(cut.ok());
  EXPECT_EQ(cut.error().code, errors::bad_content);
}

}  // namespace
}  // namespace aresta::test
