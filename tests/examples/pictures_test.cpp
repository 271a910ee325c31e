// SPDX-License-Identifier: Apache-2.0
// The comparison of the examples' pictures tells a wrong picture from a right one: blank ones, those of other examples,
// of other views, and of models that lack a region, a face or a hole.
#include "examples/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "support/paths.h"

namespace aresta::test {
namespace {

namespace fs = std::filesystem;
using draw::Image;

fs::path pictures() {
  return source_folder() / "tests/examples/pictures";
}

Image read(const fs::path& file) {
  const Result<Image> image = draw::read_png(file.string());
  EXPECT_TRUE(image.ok()) << (image.ok() ? "" : image.error().to_line());
  return image.ok() ? *image : Image{};
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The stored pictures by name.
std::map<std::string, Image> stored_pictures() {
  std::map<std::string, Image> all;
  for (const auto& entry : fs::directory_iterator(pictures())) all[entry.path().stem()] = read(entry.path());
  return all;
}

/// Runs lines as a script in `folder`.
void run(const fs::path& folder, const std::string& lines) {
  std::ofstream(folder / "script.ars") << lines;
  const std::string command =
      "cd '" + folder.string() + "' && '" + program().string() + "' run script.ars >output.txt 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of(folder / "output.txt");
}

/// An example: what comes before it draws, and how it draws what.
struct Example {
  std::string name, script, shape, picture, options;
};

std::vector<Example> examples() {
  std::vector<Example> all;
  const std::regex line("\nrender\\((.+?), \"([a-z_]+)\\.png\"(.*)\\)\n");
  for (const auto& entry : fs::directory_iterator(source_folder() / "examples")) {
    if (entry.path().extension() != ".ars") continue;
    const std::string text = text_of(entry.path());
    std::smatch found;
    if (!std::regex_search(text, found, line)) {
      ADD_FAILURE() << entry.path() << " draws no picture";
      continue;
    }
    // Files and meshes take time and show nothing.
    std::string before = found.prefix();
    for (const char* call : {"\nexport(", "\nm = mesh(", "\nprint(m)", "\nexpect(volume(m)"}) {
      for (std::size_t at; (at = before.find(call)) != std::string::npos;) {
        before.erase(
            at, before.find('\n', at + 1) == std::string::npos ? std::string::npos : before.find('\n', at + 1) - at);
      }
    }
    all.push_back({entry.path().stem(), before + "\n", found[1], found[2], found[3]});
  }
  std::sort(all.begin(), all.end(), [](const Example& a, const Example& b) { return a.name < b.name; });
  return all;
}

TEST(ExamplePictures, SmallDifferencesAreNone) {
  for (const auto& [name, image] : stored_pictures()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(picture_difference(image, image), "");
    Image other = image;
    for (std::size_t i = 0; i < other.rgba.size(); i += 7) {  // all over the picture, and a few pixels by much
      other.rgba[i] = std::uint8_t(other.rgba[i] > 20 ? other.rgba[i] - 20 : other.rgba[i] + 20);
    }
    for (int k = 0; k < 40; ++k) other.set(10 + 7 * k, 20 + 4 * k, {0, 0, 0, 255});
    EXPECT_EQ(picture_difference(image, other), "");
  }
}

TEST(ExamplePictures, BlankOnesAndThoseOfOtherExamplesDiffer) {
  const auto all = stored_pictures();
  EXPECT_EQ(all.size(), examples().size());
  for (const auto& [name, image] : all) {
    SCOPED_TRACE(name);
    for (const draw::Color c : {draw::Color{255, 255, 255, 255}, draw::Color{0, 0, 0, 255}}) {
      EXPECT_NE(picture_difference(image, Image::filled(image.width, image.height, c)), "");
    }
    EXPECT_NE(picture_difference(image, Image::filled(image.width, image.height / 2, {255, 255, 255, 255})), "");
    for (const auto& [other_name, other] : all) {
      if (other_name != name) {
        EXPECT_NE(picture_difference(image, other), "") << other_name;
      }
    }
  }
}

TEST(ExamplePictures, ModelsThatLackARegionOrAFaceAndOtherViewsDiffer) {
  const auto stored = stored_pictures();
  int without_region = 0;
  for (const Example& e : examples()) {
    SCOPED_TRACE(e.name);
    const fs::path folder = output_folder("examples_pictures_" + e.name);
    const bool large = e.options.find("width") == std::string::npos;  // takes its time
    const std::string options = e.options + (large ? ", width=480, height=360" : "");
    const auto draw = [&](const std::string& shape, const std::string& name, const std::string& more = "") {
      return "render(" + shape + ", \"" + name + ".png\"" + options + more + ")\n";
    };
    run(folder,
        e.script + "shown = " + e.shape + "\n" + draw("shown", "same") + draw("shown", "view", ", view=\"back\"") +
            // The face nearest to the eye.
            "lost = centroid(nearest(shown, (900, -1000, 1100), \"face\"))\n" +
            draw("group([f for f in faces(shown) if centroid(f) != lost])", "face") +
            "for rest in [r for r in [regions(shown)[1:]] if len(r) > 0]:\n    " + draw("group(rest)", "region"));
    const Image image = read(folder / "same.png");
    if (options == e.options) {
      EXPECT_EQ(picture_difference(stored.at(e.picture), image), "");
    }
    EXPECT_NE(picture_difference(image, read(folder / "view.png")), "");
    EXPECT_NE(picture_difference(image, read(folder / "face.png")), "");
    if (fs::exists(folder / "region.png")) {
      ++without_region;
      EXPECT_NE(picture_difference(image, read(folder / "region.png")), "");
    }
  }
  EXPECT_GE(without_region, 9);
}

TEST(ExamplePictures, OneSmallHoleOfFourMatters) {
  for (const Example& e : examples()) {
    if (e.name != "crossing_cylinders") continue;
    const fs::path folder = output_folder("examples_pictures_hole");
    run(folder, e.script + "render(result + (hole & cross), \"hole.png\"" + e.options + ")\n");
    EXPECT_NE(picture_difference(read(pictures() / "crossing_cylinders.png"), read(folder / "hole.png")), "");
    return;
  }
  FAIL() << "the example crossing_cylinders is gone";
}

}  // namespace
}  // namespace aresta::test
