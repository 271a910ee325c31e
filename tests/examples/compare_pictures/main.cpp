// SPDX-License-Identifier: Apache-2.0
// compare_pictures STORED.png FOUND.png: ends with 1 when they are not the same (see pictures.h), says what differs and
// leaves FOUND.difference.png, red where they differ.
#include <cstdio>
#include <cstdlib>

#include "examples/pictures.h"

using namespace aresta;

namespace {

draw::Image marked(const draw::Image& stored, const draw::Image& found, int tolerance) {
  draw::Image image = found;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const draw::Color a = stored.at(x, y), b = found.at(x, y);
      const auto off = [&](int p, int q) { return std::abs(p - q) > tolerance; };
      if (off(a.r, b.r) || off(a.g, b.g) || off(a.b, b.b) || off(a.a, b.a)) image.set(x, y, {255, 0, 0, 255});
    }
  }
  return image;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: compare_pictures STORED.png FOUND.png\n");
    return 2;
  }
  const Result<draw::Image> stored = draw::read_png(argv[1]), found = draw::read_png(argv[2]);
  for (const Result<draw::Image>* image : {&stored, &found}) {
    if (image->ok()) continue;
    std::fprintf(stderr, "%s\n", image->error().to_line().c_str());
    return 1;
  }
  const std::string difference = test::picture_difference(*stored, *found);
  if (difference.empty()) return 0;
  std::fprintf(stderr, "%s is not as stored in %s: %s\n", argv[2], argv[1], difference.c_str());
  if (stored->width == found->width && stored->height == found->height) {
    const std::string file = std::string(argv[2]) + ".difference.png";
    const draw::Image image = marked(*stored, *found, test::PictureTolerance{}.channel);
    if (draw::write_png(image, file).ok()) std::fprintf(stderr, "%s shows where\n", file.c_str());
  }
  return 1;
}
