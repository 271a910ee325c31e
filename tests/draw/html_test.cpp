// SPDX-License-Identifier: Apache-2.0
#include "draw/html.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "base/files.h"
#include "draw/errors.h"
#include "draw/image.h"
#include "draw/scenes.h"

namespace aresta::draw {
namespace {

namespace fs = std::filesystem;

std::string page_of(const Scene& scene, const HtmlOptions& options = {}) {
  Result<std::string> page = html_text(scene, options, {});
  EXPECT_TRUE(page.ok()) << (page.ok() ? "" : page.error().to_line());
  return page.ok() ? *page : "";
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// Three bodies that touch nothing, a wire and a point.
Scene three_bodies() {
  Scene scene;
  scene.title = "Three bodies";
  test::add_block(scene, {0, 0, 0}, {4, 3, 1}, palette(0), "plate");
  test::add_cylinder(scene, {1.2, 1.5, 1.2}, 0.8, 1.5, 48);
  test::add_torus(scene, {3, 1.5, 1.5}, 0.6, 0.25, 48, 24);
  test::add_edge(scene, {{-0.5, -0.5, 0}, {4.5, -0.5, 0}});
  scene.points.push_back({VertexId(0), {4.5, 3.5, 0}, {180, 30, 30, 255}});
  return scene;
}

TEST(Html, NothingComesFromANetwork) {
  const std::string page = page_of(three_bodies());
  for (const char* word :
       {"http:", "https:", "src=", "href=", "import(", "fetch(", "XMLHttpRequest", "@import", "url(", "WebSocket"}) {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("@SCENE@"), std::string::npos);
  EXPECT_EQ(page.find("@SCRIPT@"), std::string::npos);
  EXPECT_EQ(page.find("@TITLE@"), std::string::npos);
}

TEST(Html, NamesAreNeverMarkup) {
  Scene scene;
  scene.title = "</title><script>alert(1)</script> @SCENE@ & \"x\"";
  test::add_block(scene, {0, 0, 0}, {1, 1, 1}, palette(0), "</script><img onerror=alert(2)> \\ \" \xff\n");
  scene.faces[0].name = "<!-- front";
  scene.faces[0].kind = "<b>plane";
  const std::string page = page_of(scene);
  EXPECT_EQ(count(page, "</script"), 2u);
  EXPECT_EQ(count(page, "<script"), 2u);
  EXPECT_EQ(count(page, "<img"), 0u);
  EXPECT_EQ(count(page, "<!--"), 0u);
  EXPECT_EQ(count(page, "<b>"), 0u);
  EXPECT_NE(page.find("\\u003c/script\\u003e\\u003cimg onerror=alert(2)\\u003e \\\\ \\\" \xef\xbf\xbd\\u000a"),
            std::string::npos);
  EXPECT_NE(page.find("<title>&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt; @SCENE@ &amp; &quot;x&quot;</title>"),
            std::string::npos);
}

TEST(Html, DataOfOneTriangle) {
  Scene scene;
  // Middle (1, 1, 0): corners at (-1, -1, 0), (1, -1, 0), (1, 1, 0) from it. -1 is 00 00 80 bf, 1 is 00 00 80 3f.
  test::add_polygon(scene, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, {}, {});
  const std::string page = page_of(scene);
  EXPECT_NE(page.find("\"points\":\"AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAPwAAgD8AAAAA\""), std::string::npos);
  EXPECT_NE(page.find("\"normals\":\"AAAAAAAAAAAAAAAAAAAAAAAA\""), std::string::npos);
  EXPECT_NE(page.find("\"triangles\":\"AAAAAAEAAAACAAAA\""), std::string::npos);
  EXPECT_NE(page.find("\"regions\":[-1,-1]"), std::string::npos);
}

TEST(Html, TheWayOfEachRegionIsThere) {
  Scene scene;
  test::add_block(scene, {-1, -1, -1}, {1, 1, 1});
  test::add_block(scene, {-2, -2, -2}, {2, 2, 2});
  const std::string page = page_of(scene);
  EXPECT_NE(page.find("\"volume\":8,\"way\":[0,0,3.3"), std::string::npos);
  EXPECT_NE(page.find("\"volume\":64,\"way\":[0,0,0]"), std::string::npos);
}

TEST(Html, FilesAndErrors) {
  const std::string path = ::testing::TempDir() + "aresta_page_" + std::to_string(::getpid()) + ".html";
  EXPECT_EQ(write_html({}, {}, path, {}).error().code, errors::draw_empty);
  EXPECT_FALSE(fs::exists(path));
  Scene scene = three_bodies();
  ASSERT_TRUE(write_html(scene, {}, path, {}).ok());
  EXPECT_EQ(*read_file(path), page_of(scene));
  fs::remove(path);
  EXPECT_EQ(write_html(scene, {}, "/nonexistent/a.html", {}).error().code, errors::file_unwritable);
  HtmlOptions options;
  options.explode = std::nan("");
  EXPECT_EQ(html_text(scene, options, {}).error().code, errors::invalid_argument);
  scene.points[0].point.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(html_text(scene, {}, {}).error().code, errors::draw_not_finite);
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  EXPECT_EQ(html_text(three_bodies(), {}, context).error().code, errors::cancelled);
}

/// Opens pages in headless Chromium.
class HtmlPage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium >/dev/null 2>&1") != 0) {
      if (std::getenv("CI") != nullptr) FAIL() << "chromium is not installed: the pages cannot be opened";
      GTEST_SKIP() << "chromium is not installed (apt install chromium): the pages cannot be opened";
    }
    folder_ = fs::path(::testing::TempDir()) / ("aresta_page_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    page_ = (folder_ / "page.html").string();
    ASSERT_TRUE(write_html(three_bodies(), {}, page_, {}).ok());
  }
  void TearDown() override {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }

  /// What Chromium prints.
  std::string run(const std::string& hash, const std::string& action) const {
    const std::string command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --use-gl=swiftshader --enable-unsafe-swiftshader "
        "--disable-quic "
        "--no-first-run --disable-background-networking --disable-component-update --disable-sync "
        "--disable-dev-shm-usage "
        "--hide-scrollbars --window-size=1200,800 --virtual-time-budget=5000 --user-data-dir='" +
        (folder_ / "profile").string() + "' " + action + " 'file://" + page_ + "#" + hash + "' 2>/dev/null";
    std::string text;
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return text;
    std::array<char, 4096> buffer;
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
    ::pclose(pipe);
    return text;
  }
  /// On a busy machine Chromium sometimes ends before it has loaded anything; then it is asked again.
  static constexpr int attempts = 3;
  std::string text(const std::string& hash) const {
    std::string dom;
    for (int i = 0; i < attempts && dom.find("</html>") == std::string::npos; ++i) dom = run(hash, "--dump-dom");
    return dom;
  }
  Image picture(const std::string& hash) const {
    const std::string file = (folder_ / "shot.png").string();
    fs::remove(file);
    for (int i = 0; i < attempts && !fs::exists(file); ++i) run(hash, "--screenshot='" + file + "'");
    const Result<Image> image = read_png(file);
    EXPECT_TRUE(image.ok()) << (image.ok() ? "" : image.error().to_line());
    return image.ok() ? *image : Image{};
  }
  /// The part of the middle of the window, where only the canvas is, that is not white.
  static double drawn(const Image& image) {
    std::size_t inked = 0, all = 0;
    for (int y = 110; y < image.height - 110; ++y) {
      for (int x = 320; x < image.width - 300; ++x, ++all) inked += !(image.at(x, y) == Color{255, 255, 255, 255});
    }
    return all > 0 ? double(inked) / double(all) : 0;
  }
  /// The part of the same window in which a colour like this one is seen, light and shade apart.
  static double tinted(const Image& image, Color c) {
    std::size_t found = 0, all = 0;
    for (int y = 110; y < image.height - 110; ++y) {
      for (int x = 320; x < image.width - 300; ++x, ++all) {
        const Color p = image.at(x, y);
        const double s = (p.r + p.g + p.b) / double(c.r + c.g + c.b);
        found += s > 0.4 && s < 1.2 && std::abs(p.r - s * c.r) < 12 && std::abs(p.g - s * c.g) < 12 &&
                 std::abs(p.b - s * c.b) < 12;
      }
    }
    return all > 0 ? double(found) / double(all) : 0;
  }

  fs::path folder_;
  std::string page_;
};

TEST_F(HtmlPage, CanvasIsNotBlank) {
  for (const std::string how : {"", "canvas=1"}) {
    SCOPED_TRACE(how);
    const std::string dom = text(how);
    EXPECT_NE(dom.find(how.empty() ? "data-renderer=\"webgl\"" : "data-renderer=\"canvas\""), std::string::npos)
        << dom.substr(0, 300) << " ... " << dom.size() << " bytes";
    const Image image = picture(how);
    EXPECT_GT(drawn(image), 0.4);
    EXPECT_LT(drawn(image), 0.95);
    EXPECT_GT(tinted(image, palette(0)), 0.2);   // plate
    EXPECT_GT(tinted(image, palette(1)), 0.05);  // cylinder
    EXPECT_GT(tinted(image, palette(3)), 0.02);  // torus
  }
}

TEST_F(HtmlPage, BothWaysOfDrawingAgree) {
  for (const std::string view : {"view=iso", "view=front&explode=0.5", "view=top&perspective=1"}) {
    SCOPED_TRACE(view);
    const ImageDifference d = compare_images(picture(view + "&edges=0"), picture(view + "&edges=0&canvas=1"), 40);
    EXPECT_TRUE(d.within(0.02)) << d.differing_part;
  }
}

TEST_F(HtmlPage, RegionsHideAndGlassLetsThrough) {
  const Image all = picture("view=iso"), hidden = picture("view=iso&hide=1"), glass = picture("view=iso&glass=1");
  EXPECT_GT(tinted(all, palette(1)), 0.05);
  EXPECT_LT(tinted(hidden, palette(1)), 0.001);
  EXPECT_GT(tinted(hidden, palette(3)), 0.02);
  EXPECT_GT(drawn(glass), 0.3);
  EXPECT_LT(tinted(glass, palette(0)), tinted(all, palette(0)) / 2);
}

TEST_F(HtmlPage, PickingTellsTheRegionAndTheFace) {
  // Seen from the top, the middle of the plate is free between cylinder and torus.
  const Image top = picture("view=top");
  int x = -1, y = -1;
  for (int py = 200; py < 600 && x < 0; ++py) {
    for (int px = 340; px < 880 && x < 0; ++px) {
      const Color c = top.at(px, py);
      if (c.b > c.r + 40 && top.at(px + 8, py + 8) == c && top.at(px + 16, py + 16) == c) x = px + 8, y = py + 8;
    }
  }
  ASSERT_GE(x, 0) << "the plate is not seen";
  const std::string dom = text("view=top&pick=" + std::to_string(x) + "," + std::to_string(y));
  const std::string info = dom.substr(dom.find("id=\"info\""), 600);
  EXPECT_NE(info.find("<dd>plate</dd>"), std::string::npos) << info;
  EXPECT_NE(info.find("<dt>volume</dt><dd>12</dd>"), std::string::npos) << info;
  EXPECT_NE(info.find("<dt>faces</dt><dd>6</dd>"), std::string::npos) << info;
  EXPECT_NE(info.find("<dt>face</dt><dd>5</dd>"), std::string::npos) << info;  // z+
  EXPECT_EQ(count(dom, "class=\"row picked\""), 1u);
  const std::string beside = text("view=top&pick=5,400");
  EXPECT_EQ(count(beside, "class=\"row picked\""), 0u);
  // A picked face changes its colour.
  const Image picked = picture("view=top&pick=" + std::to_string(x) + "," + std::to_string(y));
  EXPECT_GT(picked.at(x, y).r, top.at(x, y).r + 40);
}

}  // namespace
}  // namespace aresta::draw
