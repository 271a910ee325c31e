// SPDX-License-Identifier: Apache-2.0
#include "draw/image.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "base/files.h"
#include "draw/errors.h"

namespace aresta::draw {
namespace {

constexpr int largest_side = 32768;

}  // namespace

Image Image::filled(int width, int height, Color color) {
  Image image{width, height, std::vector<std::uint8_t>(std::size_t(4) * width * height)};
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    image.rgba[i] = color.r, image.rgba[i + 1] = color.g, image.rgba[i + 2] = color.b, image.rgba[i + 3] = color.a;
  }
  return image;
}

Result<std::string> encode_png(const Image& image) {
  if (image.width < 1 || image.height < 1 || image.rgba.size() != std::size_t(4) * image.width * image.height) {
    return Error{errors::draw_bad_size, "a picture without pixels cannot be stored"};
  }
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;
  const int channels = opaque ? 3 : 4;
  std::vector<std::uint8_t> packed;
  packed.reserve(image.rgba.size() / 4 * channels);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    packed.insert(packed.end(), image.rgba.begin() + i, image.rgba.begin() + i + channels);
  }
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  if (!png_image_write_get_memory_size(header, size, 0, packed.data(), 0, nullptr)) {
    return Error{errors::internal, std::string("the picture cannot be encoded: ") + header.message};
  }
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, packed.data(), 0, nullptr)) {
    return Error{errors::internal, std::string("the picture cannot be encoded: ") + header.message};
  }
  bytes.resize(size);
  return bytes;
}

Result<Image> decode_png(std::string_view bytes) {
  const auto bad = [](const std::string& why) {
    return Error{errors::draw_bad_png, "not a readable PNG picture: " + why};
  };
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size())) return bad(header.message);
  if (header.width > largest_side || header.height > largest_side) {
    png_image_free(&header);
    return bad("more than " + std::to_string(largest_side) + " pixels a side");
  }
  header.format = PNG_FORMAT_RGBA;
  Image image{int(header.width), int(header.height), std::vector<std::uint8_t>(PNG_IMAGE_SIZE(header))};
  if (!png_image_finish_read(&header, nullptr, image.rgba.data(), 0, nullptr)) return bad(header.message);
  return image;
}

Status write_png(const Image& image, const std::string& path) {
  ARESTA_TRY(const std::string bytes, encode_png(image));
  return write_file(path, bytes);
}

Result<Image> read_png(const std::string& path) {
  ARESTA_TRY(const std::string bytes, read_file(path));
  Result<Image> image = decode_png(bytes);
  if (!image.ok()) image.error().message += " (" + path + ")";
  return image;
}

ImageDifference compare_images(const Image& a, const Image& b, int tolerance) {
  ImageDifference result;
  if (a.width != b.width || a.height != b.height) {
    result.same_size = false;
    result.differing_part = 1;
    result.largest = 255;
    result.mean = 255;
    return result;
  }
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int worst = 0;
    for (std::size_t c = i; c < i + 4; ++c) {
      const int d = std::abs(int(a.rgba[c]) - int(b.rgba[c]));
      worst = std::max(worst, d);
      sum += d;
    }
    result.largest = std::max(result.largest, worst);
    result.differing_pixels += worst > tolerance;
  }
  if (!a.rgba.empty()) {
    result.mean = sum / double(a.rgba.size());
    result.differing_part = double(result.differing_pixels) * 4 / double(a.rgba.size());
  }
  return result;
}

double drawn_part(const Image& image) {
  if (image.rgba.empty()) return 0;
  std::size_t count = 0;
  for (std::size_t i = 4; i < image.rgba.size(); i += 4) {
    count += std::memcmp(&image.rgba[i], image.rgba.data(), 4) != 0;
  }
  return double(count) * 4 / double(image.rgba.size());
}

}  // namespace aresta::draw
