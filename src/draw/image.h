// SPDX-License-Identifier: Apache-2.0
// Pictures as pixels: PNG files in and out, and the comparison that tests of pictures use.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "draw/scene.h"

namespace aresta::draw {

/// Rows from the top, four bytes (red, green, blue, alpha) a pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  Color at(int x, int y) const {
    const std::uint8_t* p = &rgba[4 * (std::size_t(y) * width + x)];
    return {p[0], p[1], p[2], p[3]};
  }
  void set(int x, int y, Color c) {
    std::uint8_t* p = &rgba[4 * (std::size_t(y) * width + x)];
    p[0] = c.r, p[1] = c.g, p[2] = c.b, p[3] = c.a;
  }
  static Image filled(int width, int height, Color color);
};

/// The bytes of a PNG file; the same for the same pixels. Opaque pictures are stored without alpha.
/// Error: draw_bad_size for a picture without pixels.
Result<std::string> encode_png(const Image& image);
/// Error: draw_bad_png, with the reason; at most 32768 pixels a side.
Result<Image> decode_png(std::string_view bytes);

/// Atomic (see base/files.h). Errors: those of encode_png(); file_unwritable.
Status write_png(const Image& image, const std::string& path);
/// Errors: file_unreadable; draw_bad_png.
Result<Image> read_png(const std::string& path);

/// How two pictures differ.
struct ImageDifference {
  bool same_size = true;
  std::size_t differing_pixels = 0;  ///< pixels with a channel off by more than the tolerance
  double differing_part = 0;         ///< of all pixels; 1 when sizes differ
  int largest = 0;                   ///< largest difference of a channel, 0 to 255
  double mean = 0;                   ///< mean absolute difference of a channel, 0 to 255

  bool within(double part) const { return same_size && differing_part <= part; }
};

/// `tolerance`: the difference of a channel (0 to 255) that still counts as equal.
ImageDifference compare_images(const Image& a, const Image& b, int tolerance = 0);

/// Part of the pixels that differ from the colour of the upper left corner: 0 for a blank picture.
double drawn_part(const Image& image);

}  // namespace aresta::draw
