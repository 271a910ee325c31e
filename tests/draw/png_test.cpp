// SPDX-License-Identifier: Apache-2.0
#include "draw/png.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "draw/errors.h"
#include "draw/scenes.h"

namespace aresta::draw {
namespace {

namespace fs = std::filesystem;

constexpr Color white{255, 255, 255, 255};

/// A square sheet facing front (-y) at depth y.
void add_sheet(Scene& scene, double low, double high, double y, Color color) {
  const FaceId f = test::add_polygon(scene, {{low, y, low}, {high, y, low}, {high, y, high}, {low, y, high}}, {}, {});
  scene.faces[f.index()].color = color;
}

/// 100 x 100 pixels looking along +y, a unit is 10 pixels, the origin in the middle.
RenderOptions front_options() {
  RenderOptions options;
  Camera camera = standard_camera(StandardView::front);
  camera.eye = {0, -50, 0};
  camera.view_width = 10;
  options.view.camera = camera;
  options.view.width = options.view.height = 100;
  return options;
}

Image image_of(const Scene& scene, const RenderOptions& options) {
  Result<Image> image = render_image(scene, options, {});
  EXPECT_TRUE(image.ok()) << (image.ok() ? "" : image.error().to_line());
  return image.ok() ? *image : Image{};
}

bool reddish(Color c) {
  return c.r > 2 * c.g && c.r > 2 * c.b;
}
bool greenish(Color c) {
  return c.g > 2 * c.r && c.g > 2 * c.b;
}
bool bluish(Color c) {
  return c.b > 2 * c.r && c.b > 2 * c.g;
}
bool dark(Color c) {
  return c.r < 60 && c.g < 60 && c.b < 60;
}

constexpr Color red{200, 0, 0, 255}, green{0, 200, 0, 255}, blue{0, 0, 200, 255};

TEST(Png, KnownPixelsOfASheet) {
  Scene scene;
  add_sheet(scene, -2, 2, 0, red);
  const Image image = image_of(scene, front_options());
  EXPECT_EQ(image.width, 100);
  EXPECT_EQ(image.height, 100);
  // 4 units of 10 pixels: columns and rows 30 to 69.
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool inside = x >= 30 && x < 70 && y >= 30 && y < 70;
      if (inside) {
        ASSERT_TRUE(reddish(image.at(x, y))) << x << ' ' << y;
      } else {
        ASSERT_EQ(image.at(x, y), white) << x << ' ' << y;
      }
    }
  }
}

TEST(Png, HalfCoveredPixelsAreHalfMixed) {
  Scene scene;
  add_sheet(scene, -2.05, 2.05, 0, red);  // half a pixel more on each side
  const Image image = image_of(scene, front_options());
  const Color inside = image.at(50, 50), border = image.at(29, 50);
  EXPECT_NEAR(border.g, 0.5 * (255 + inside.g), 1.5);
  EXPECT_NEAR(border.r, 0.5 * (255 + inside.r), 1.5);
  EXPECT_EQ(image.at(28, 50), white);
}

TEST(Png, NearHidesFarWhateverTheOrder) {
  for (const bool near_first : {false, true}) {
    Scene scene;
    if (near_first) add_sheet(scene, -1, 1, -3, green);
    add_sheet(scene, -2, 2, 0, red);
    if (!near_first) add_sheet(scene, -1, 1, -3, green);
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
      RenderOptions options = front_options();
      options.view.camera->projection = projection;
      options.view.camera->field_of_view = 11.4;
      const Image image = image_of(scene, options);
      EXPECT_TRUE(greenish(image.at(50, 50)));
      EXPECT_TRUE(reddish(image.at(35, 50)));
      EXPECT_EQ(image.at(5, 5), white);
    }
  }
}

TEST(Png, CrossingSheetsMeetInTheMiddle) {
  Scene scene;
  // Both pass through the line x = 0, y = 0; left of it the first is nearer.
  const FaceId a = test::add_polygon(scene, {{-3, -3, -2}, {3, 3, -2}, {3, 3, 2}, {-3, -3, 2}}, {}, {});
  const FaceId b = test::add_polygon(scene, {{-3, 3, -2}, {3, -3, -2}, {3, -3, 2}, {-3, 3, 2}}, {}, {});
  scene.faces[a.index()].color = red;
  scene.faces[b.index()].color = green;
  const Image image = image_of(scene, front_options());
  EXPECT_TRUE(reddish(image.at(48, 50)));
  EXPECT_TRUE(greenish(image.at(51, 50)));
}

TEST(Png, EdgesInFrontAreDrawnAndBehindAreNot) {
  Scene scene;
  add_sheet(scene, -3, 3, 0, red);
  test::add_edge(scene, {{-4, -1, 1}, {4, -1, 1}});    // in front: row 40
  test::add_edge(scene, {{-4, 1, -1}, {4, 1, -1}});    // behind: row 60
  test::add_edge(scene, {{0, 0, -2.5}, {0, 0, 2.5}});  // in the sheet: column 50
  RenderOptions options = front_options();
  options.edge_width = 2;
  const Image image = image_of(scene, options);
  for (const int x : {12, 30, 50, 70, 87}) EXPECT_TRUE(dark(image.at(x, 40))) << x;
  EXPECT_TRUE(dark(image.at(12, 60)));
  EXPECT_TRUE(dark(image.at(87, 60)));
  EXPECT_TRUE(reddish(image.at(30, 60)));
  EXPECT_TRUE(reddish(image.at(70, 60)));
  EXPECT_TRUE(dark(image.at(50, 30)));
  options.edges = false;
  EXPECT_TRUE(reddish(image_of(scene, options).at(50, 30)));
}

TEST(Png, EdgesJustBehindAForeignFaceAreNotDrawn) {
  Scene scene;
  add_sheet(scene, -3, 3, 0, red);
  test::add_edge(scene, {{-4, 0.1, -1}, {4, 0.1, -1}});                 // a pixel behind: row 60
  test::add_edge(scene, {{-4, 0.01, 1}, {4, 0.01, 1}});                 // a tenth of a pixel: row 40
  test::add_edge(scene, {{1, 0.1, -2.5}, {1, 0.1, 2.5}}, {FaceId(0)});  // a pixel behind its own face: column 60
  RenderOptions options = front_options();
  options.edge_width = 2;
  const Image image = image_of(scene, options);
  EXPECT_TRUE(dark(image.at(12, 60)));
  for (const int x : {25, 40, 50, 75}) EXPECT_TRUE(reddish(image.at(x, 60))) << x;
  for (const int x : {25, 40, 50, 75}) EXPECT_TRUE(dark(image.at(x, 40))) << x;
  EXPECT_TRUE(dark(image.at(60, 50)));
}

TEST(Png, OfCoincidingLinesOneIsSeenThroughout) {
  for (const bool wire_first : {false, true}) {
    Scene scene;
    add_sheet(scene, -3, 3, 0, red);
    // A wire along an edge of the sheet, cut otherwise and off it by rounding.
    const auto add_wire = [&] {
      test::add_edge(scene, {{-2, 1e-9, 0}, {-0.7, -1e-9, 1e-9}, {0.1, 1e-9, 0}, {2, -1e-9, 0}});
      scene.edges.back().color = {255, 255, 255, 255};
    };
    if (wire_first) add_wire();
    test::add_edge(scene, {{-2, 0, 0}, {2, 0, 0}}, {FaceId(0)});
    if (!wire_first) add_wire();
    RenderOptions options = front_options();
    options.edge_width = 2;
    const Image image = image_of(scene, options);
    for (int x = 31; x < 69; ++x) EXPECT_TRUE(dark(image.at(x, 50))) << x;
  }
}

TEST(Png, SmoothEdgesAreNotDrawn) {
  Scene scene;
  add_sheet(scene, -3, 3, 0, red);
  test::add_edge(scene, {{0, 0, -2.5}, {0, 0, 2.5}}, {FaceId(0)}, true);
  EXPECT_TRUE(reddish(image_of(scene, front_options()).at(50, 30)));
}

TEST(Png, PointsAreDots) {
  Scene scene;
  scene.points.push_back({VertexId(0), {1, 0, 2}, blue});
  RenderOptions options = front_options();
  options.point_size = 8;
  const Image image = image_of(scene, options);
  EXPECT_TRUE(bluish(image.at(60, 30)));
  EXPECT_TRUE(bluish(image.at(57, 30)));
  EXPECT_EQ(image.at(65, 30), white);
  // A disk 8 pixels across covers 50 of 10000.
  EXPECT_NEAR(drawn_part(image), 0.0050, 0.0015);
}

TEST(Png, FacesAreSeenFromBothSides) {
  Scene scene;
  add_sheet(scene, -2, 2, 0, red);
  RenderOptions options = front_options();
  options.view.camera->eye = {0, 50, 0};
  EXPECT_TRUE(reddish(image_of(scene, options).at(50, 50)));
}

TEST(Png, TransparentFacesLetThroughWhatIsBehind) {
  Scene scene;
  add_sheet(scene, -2, 2, 0, red);
  add_sheet(scene, -1, 1, 3, green);
  RenderOptions options = front_options();
  const Color front = image_of(scene, options).at(35, 50);
  options.opacity = 0.25;
  const Image image = image_of(scene, options);
  // One layer of a quarter over white.
  EXPECT_NEAR(image.at(35, 50).g, 0.75 * 255 + 0.25 * front.g, 1.5);
  EXPECT_NEAR(image.at(35, 50).r, 0.75 * 255 + 0.25 * front.r, 1.5);
  // Two layers: green lets 3/4 of white through, red 3/4 of that.
  EXPECT_NEAR(image.at(50, 50).b, 0.75 * (0.75 * 255 + 0.25 * front.b) + 0.25 * front.b, 2.5);
  EXPECT_GT(image.at(50, 50).g, image.at(50, 50).b);
}

TEST(Png, RegionColoursBelongToWhatIsBehindTheSide) {
  Scene scene;
  test::add_block(scene, {-2, 0, -2}, {0, 1, 2}, red);
  test::add_block(scene, {0, 0, -2}, {2, 1, 2}, green);
  const Image image = image_of(scene, front_options());
  EXPECT_TRUE(reddish(image.at(40, 50)));
  EXPECT_TRUE(greenish(image.at(60, 50)));
  // A face's own colour wins; so do all faces' colours when asked for.
  scene.faces[2].color = blue;  // y- of the first block
  scene.faces[2].own_color = true;
  EXPECT_TRUE(bluish(image_of(scene, front_options()).at(40, 50)));
  scene.faces[8].color = blue;
  RenderOptions options = front_options();
  EXPECT_TRUE(greenish(image_of(scene, options).at(60, 50)));
  options.coloring = Coloring::faces;
  EXPECT_TRUE(bluish(image_of(scene, options).at(60, 50)));
}

TEST(Png, TheSameBytesForOneAndTwoThreads) {
  Scene scene;
  test::add_torus(scene, {0, 0, 0}, 3, 1, 40, 20);
  test::add_block(scene, {-1, -1, -1}, {1, 1, 1});
  RenderOptions options;
  options.view.width = 300;
  options.view.height = 200;
  Context two;
  two.threads = 2;
  for (const double opacity : {1.0, 0.5}) {
    options.opacity = opacity;
    const Image a = image_of(scene, options);
    const Result<Image> b = render_image(scene, options, two);
    ASSERT_TRUE(b.ok());
    EXPECT_EQ(a.rgba, b->rgba);
    EXPECT_EQ(*encode_png(a), *encode_png(*b));
  }
}

TEST(Png, ABodyOnlyPartlyInFrontOfTheEye) {
  Scene scene;
  test::add_block(scene, {-1, -100, -1}, {1, 5, 0});  // the eye is above its middle
  RenderOptions options;
  Camera camera = standard_camera(StandardView::front, Projection::perspective);
  camera.eye = {0, -50, 1};
  camera.target = {0, 0, 1};
  camera.field_of_view = 60;
  options.view.camera = camera;
  options.view.width = options.view.height = 100;
  const Image image = image_of(scene, options);
  EXPECT_NE(image.at(50, 99), white);  // the top face, just before the eye
  EXPECT_EQ(image.at(50, 30), white);  // above the horizon
}

TEST(Png, BadInputIsRefused) {
  Scene scene;
  EXPECT_EQ(render_image(scene, {}, {}).error().code, errors::draw_empty);
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  const auto code_with = [&](auto change) {
    RenderOptions options;
    options.view.width = options.view.height = 20;
    Scene changed = scene;
    change(changed, options);
    const auto r = render_image(changed, options, {});
    return r.ok() ? 0 : r.error().code.number;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_with([](Scene&, RenderOptions&) {}), 0);
  EXPECT_EQ(code_with([&](Scene& s, RenderOptions&) { s.faces[2].points[1].y = nan; }), errors::draw_not_finite.number);
  EXPECT_EQ(code_with([&](Scene& s, RenderOptions&) { s.edges[2].points[1].y = inf; }), errors::draw_not_finite.number);
  EXPECT_EQ(code_with([&](Scene& s, RenderOptions&) { s.faces[0].triangles[0][1] = 77; }),
            errors::draw_malformed.number);
  EXPECT_EQ(code_with([&](Scene& s, RenderOptions&) { s.faces[0].normals.resize(1); }), errors::draw_malformed.number);
  EXPECT_EQ(code_with([&](Scene& s, RenderOptions&) { s.edges[0].points.resize(1); }), errors::draw_malformed.number);
  EXPECT_EQ(code_with([&](Scene&, RenderOptions& o) { o.view.width = 0; }), errors::draw_bad_size.number);
  EXPECT_EQ(code_with([&](Scene&, RenderOptions& o) { o.opacity = 2; }), errors::invalid_argument.number);
  EXPECT_EQ(code_with([&](Scene&, RenderOptions& o) { o.supersampling = 0; }), errors::invalid_argument.number);
  EXPECT_EQ(code_with([&](Scene&, RenderOptions& o) { o.view.explode = -1; }), errors::invalid_argument.number);
  EXPECT_EQ(code_with([&](Scene&, RenderOptions& o) { o.view.margin = 0.5; }), errors::invalid_argument.number);

  const auto named = [&] {
    Scene s = scene;
    s.faces[3].points[0].x = nan;
    return render_image(s, {}, {}).error();
  }();
  ASSERT_EQ(named.entities.size(), 1u);
  EXPECT_EQ(named.entities[0], EntityRef(FaceId(3)));
}

TEST(Png, CanBeCancelled) {
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  EXPECT_EQ(render_image(scene, {}, context).error().code, errors::cancelled);
}

TEST(Png, FilesAreCompleteOrAbsent) {
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  RenderOptions options;
  options.view.width = 64;
  options.view.height = 48;
  const fs::path folder = fs::path(::testing::TempDir()) / ("aresta_png_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string path = (folder / "a.png").string();
  ASSERT_TRUE(render_png(scene, options, path, {}).ok());
  const Result<Image> back = read_png(path);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(compare_images(*back, image_of(scene, options)).differing_pixels, 0u);

  const Status full = render_png(scene, options, "/dev/full", {});
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().code.failure, Failure::file);
  EXPECT_EQ(render_png(scene, options, (folder / "none" / "a.png").string(), {}).error().code, errors::file_unwritable);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace aresta::draw
