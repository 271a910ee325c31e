// SPDX-License-Identifier: Apache-2.0
#include "draw/svg.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <regex>

#include "base/files.h"
#include "draw/errors.h"
#include "draw/scenes.h"
#include "draw/text.h"

namespace aresta::draw {
namespace {

struct SvgSegment {
  std::string entity;
  bool visible;
  Vec2 a, b;
};

/// The straight segments of a drawing, read back from its text.
std::vector<SvgSegment> segments_of(const std::string& svg) {
  std::vector<SvgSegment> result;
  const std::size_t visible_from = svg.find("<g class=\"visible\"");
  const std::regex path("<path data-entity=\"([^\"]*)\"[^>]* d=\"([^\"]*)\"/>"), step("([MLZ])([-0-9.]*) ?([-0-9.]*)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
    const std::string d = (*it)[2];
    Vec2 first, last;
    for (std::sregex_iterator s(d.begin(), d.end(), step); s != end; ++s) {
      Vec2 p = first;
      if ((*s)[1] != "Z") p = {std::stod((*s)[2]), std::stod((*s)[3])};
      if ((*s)[1] == "M")
        first = p;
      else
        result.push_back({(*it)[1], std::size_t(it->position()) > visible_from, last, p});
      last = p;
    }
  }
  return result;
}

std::string svg_of(const Scene& scene, const SvgOptions& options) {
  Result<std::string> text = svg_text(scene, options, {});
  EXPECT_TRUE(text.ok()) << (text.ok() ? "" : text.error().to_line());
  return text.ok() ? *text : "";
}

/// 800 x 600 pixels looking along +y, 100 pixels a unit, the origin in the middle.
SvgOptions front_options() {
  SvgOptions options;
  options.hidden_lines = true;
  Camera camera = standard_camera(StandardView::front);
  camera.eye = {0, -50, 0};
  camera.view_width = 8;
  options.view.camera = camera;
  options.view.width = 800;
  options.view.height = 600;
  return options;
}

/// Is there exactly this list of segments, whatever their order and sense, to 1e-9 of the picture?
void expect_segments(const std::vector<SvgSegment>& actual, const std::vector<SvgSegment>& expected) {
  EXPECT_EQ(actual.size(), expected.size());
  const auto near = [](Vec2 p, Vec2 q) { return distance(p, q) < 800e-9; };
  for (const SvgSegment& e : expected) {
    const auto same = [&](const SvgSegment& s) {
      return s.visible == e.visible && (e.entity.empty() || s.entity == e.entity) &&
             ((near(s.a, e.a) && near(s.b, e.b)) || (near(s.a, e.b) && near(s.b, e.a)));
    };
    EXPECT_EQ(std::count_if(actual.begin(), actual.end(), same), 1)
        << e.entity << ": " << e.a.x << ' ' << e.a.y << " to " << e.b.x << ' ' << e.b.y;
  }
}

TEST(Svg, CubeFromItsCornerHasNineSegments) {
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  SvgOptions options;
  options.hidden_lines = true;
  Camera camera = standard_camera(StandardView::iso);
  camera.target = {0.5, 0.5, 0.5};
  camera.eye = camera.target + Vec3{5, -5, 5};
  camera.view_width = 4;
  options.view.camera = camera;
  options.view.width = 800;
  options.view.height = 600;
  const std::string svg = svg_of(scene, options);
  // 200 pixels a unit; in the picture right is (1, 1, 0) / sqrt 2 and up is (-1, 1, 2) / sqrt 6, from the cube's
  // middle.
  const auto seen = [](double x, double y, double z) {
    x -= 0.5, y -= 0.5, z -= 0.5;
    return Vec2{400 + 200 * (x + y) / std::sqrt(2.0), 300 - 200 * (-x + y + 2 * z) / std::sqrt(6.0)};
  };
  std::vector<SvgSegment> expected;
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 4; ++k) {
      double a[3], b[3];
      a[axis] = 0, b[axis] = 1;
      a[(axis + 1) % 3] = b[(axis + 1) % 3] = k & 1;
      a[(axis + 2) % 3] = b[(axis + 2) % 3] = k >> 1;
      const bool hidden = (a[0] == 0 && a[1] == 1 && a[2] == 0) || (b[0] == 0 && b[1] == 1 && b[2] == 0);
      if (!hidden)
        expected.push_back(
            {"edge " + std::to_string(4 * axis + k), true, seen(a[0], a[1], a[2]), seen(b[0], b[1], b[2])});
    }
  }
  ASSERT_EQ(expected.size(), 9u);
  expect_segments(segments_of(svg), expected);

  options.dashed = true;
  const auto dashed = segments_of(svg_of(scene, options));
  EXPECT_EQ(dashed.size(), 12u);
  EXPECT_EQ(std::count_if(dashed.begin(), dashed.end(), [](const SvgSegment& s) { return !s.visible; }), 3);
  options.hidden_lines = false;
  EXPECT_EQ(segments_of(svg_of(scene, options)).size(), 12u);
}

TEST(Svg, ATowerHidesTheMiddleOfAWall) {
  Scene scene;
  test::add_block(scene, {-1, 0, -2}, {0, 1, 2});
  test::add_block(scene, {-3, 5, -1}, {3, 6, 1});
  // Wall: from x = -3 to 3 in front of pixel 100 to 700, z from -1 to 1 at rows 400 to 200; tower: columns 300 to 400.
  expect_segments(segments_of(svg_of(scene, front_options())), {
                                                                   {"", true, {300, 100}, {400, 100}},
                                                                   {"", true, {300, 500}, {400, 500}},
                                                                   {"", true, {300, 100}, {300, 500}},
                                                                   {"", true, {400, 100}, {400, 500}},
                                                                   {"", true, {100, 200}, {300, 200}},
                                                                   {"", true, {400, 200}, {700, 200}},
                                                                   {"", true, {100, 400}, {300, 400}},
                                                                   {"", true, {400, 400}, {700, 400}},
                                                                   {"", true, {100, 200}, {100, 400}},
                                                                   {"", true, {700, 200}, {700, 400}},
                                                               });
}

TEST(Svg, Perspective) {
  Scene scene;
  const FaceId sheet = test::add_polygon(scene, {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {}, {});
  test::add_edge(scene, {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {-1, 0, -1}}, {sheet});
  test::add_edge(scene, {{-6, 10, 0}, {6, 10, 0}});
  SvgOptions options = front_options();
  options.view.camera->projection = Projection::perspective;
  options.view.camera->field_of_view = 90;
  options.view.camera->eye = {0, -10, 0};
  options.view.camera->target = {0, 0, 0};
  // 400 pixels at depth 1: the sheet at depth 10 is 80 pixels wide, the wire at depth 20 reaches 120 pixels to each
  // side.
  expect_segments(segments_of(svg_of(scene, options)), {
                                                           {"edge 0", true, {360, 260}, {440, 260}},
                                                           {"edge 0", true, {440, 260}, {440, 340}},
                                                           {"edge 0", true, {440, 340}, {360, 340}},
                                                           {"edge 0", true, {360, 340}, {360, 260}},
                                                           {"edge 1", true, {280, 300}, {360, 300}},
                                                           {"edge 1", true, {440, 300}, {520, 300}},
                                                       });
}

TEST(Svg, StraightPiecesAreOneSegmentAndClosedLinesAreClosed) {
  Scene scene;
  test::add_edge(scene, {{-2, 0, 0}, {-1, 0, 0}, {0.5, 0, 0}, {2, 0, 0}, {2, 0, 1}});
  test::add_edge(scene, {{-1, 0, -1}, {1, 0, -1}, {1, 0, -2}, {-1, 0, -1}});
  const std::string svg = svg_of(scene, front_options());
  EXPECT_NE(svg.find("d=\"M200 300 L600 300 L600 200\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("d=\"M300 400 L500 400 L500 500 Z\""), std::string::npos) << svg;
}

TEST(Svg, AClosedLineThatIsPartlyHiddenIsOnePolyline) {
  // The triangle starts in the middle of what is seen; its right half is behind a sheet.
  Scene scene;
  test::add_edge(scene, {{-1, 5, 0}, {-1, 5, -1}, {3, 5, -1}, {3, 5, 1}, {-1, 5, 1}, {-1, 5, 0}});
  test::add_polygon(scene, {{0, 0, -2}, {4, 0, -2}, {4, 0, 2}, {0, 0, 2}}, {}, {});
  const std::string svg = svg_of(scene, front_options());
  EXPECT_NE(svg.find("d=\"M400 200 L300 200 L300 400 L400 400\""), std::string::npos) << svg;
}

TEST(Svg, ClippedToTheView) {
  Scene scene;
  test::add_edge(scene, {{-10, 0, 0}, {10, 0, 0}});
  test::add_edge(scene, {{-10, 0, 5}, {10, 0, 5}});  // above
  test::add_edge(scene, {{-4, 0, 2}, {-2, 0, 4}});   // over the upper left corner: x + 800 / 100 ...
  scene.points.push_back({VertexId(7), {10, 0, 0}, {}});
  scene.points.push_back({VertexId(8), {1, 0, 1}, {}});
  SvgOptions options = front_options();
  for (const bool hidden_lines : {true, false}) {
    options.hidden_lines = hidden_lines;
    const std::string svg = svg_of(scene, options);
    expect_segments(segments_of(svg), {{"edge 0", true, {0, 300}, {800, 300}}, {"edge 2", true, {0, 100}, {100, 0}}});
    EXPECT_EQ(svg.find("vertex 7"), std::string::npos);
    EXPECT_NE(svg.find("data-entity=\"vertex 8\" cx=\"500\" cy=\"200\""), std::string::npos);
  }
}

TEST(Svg, NamesAreEscaped) {
  Scene scene;
  scene.title = "a<b & \"c\" \xff\x01 ok \xe2\x82\xac";
  test::add_edge(scene, {{0, 0, 0}, {1, 0, 0}});
  const std::string svg = svg_of(scene, front_options());
  EXPECT_NE(svg.find("<title>a&lt;b &amp; &quot;c&quot; \xef\xbf\xbd\xef\xbf\xbd ok \xe2\x82\xac</title>"),
            std::string::npos);
}

TEST(Svg, FilesAndErrors) {
  Scene scene;
  const std::string path = ::testing::TempDir() + "aresta_" + std::to_string(::getpid()) + ".svg";
  EXPECT_EQ(write_svg(scene, {}, path, {}).error().code, errors::draw_empty);
  EXPECT_FALSE(std::filesystem::exists(path));
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  ASSERT_TRUE(write_svg(scene, {}, path, {}).ok());
  EXPECT_EQ(*read_file(path), *svg_text(scene, {}, {}));
  std::filesystem::remove(path);
  EXPECT_EQ(write_svg(scene, {}, "/nonexistent/a.svg", {}).error().code, errors::file_unwritable);
  SvgOptions options;
  options.line_width = -1;
  EXPECT_EQ(svg_text(scene, options, {}).error().code, errors::invalid_argument);
  options = {};
  options.view.height = 0;
  EXPECT_EQ(svg_text(scene, options, {}).error().code, errors::draw_bad_size);
}

TEST(Text, NumbersStringsAndBase64) {
  EXPECT_EQ(number_text(1.5, 6), "1.5");
  EXPECT_EQ(number_text(-0.0000001, 6), "0");
  EXPECT_EQ(number_text(100, 6), "100");
  EXPECT_EQ(number_text(1.0 / 3, 6), "0.333333");
  EXPECT_EQ(json_number(0.1), "0.1");
  EXPECT_EQ(json_number(std::nan("")), "null");
  EXPECT_EQ(json_string("a\"b\\</script>\n"), "\"a\\\"b\\\\\\u003c/script\\u003e\\u000a\"");
  EXPECT_EQ(json_string("\xed\xa0\x80"), "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\"");  // half a surrogate pair
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("M"), "TQ==");
  EXPECT_EQ(base64("Ma"), "TWE=");
  EXPECT_EQ(base64("Man"), "TWFu");
}

}  // namespace
}  // namespace aresta::draw
