// SPDX-License-Identifier: Apache-2.0
#include "draw/image.h"

#include <gtest/gtest.h>

#include "draw/errors.h"

namespace aresta::draw {
namespace {

TEST(Image, PngKeepsEveryPixel) {
  for (const bool opaque : {true, false}) {
    Image image = Image::filled(7, 5, {10, 20, 30, 255});
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 7; ++x) {
        image.set(
            x, y,
            {std::uint8_t(30 * x), std::uint8_t(40 * y), std::uint8_t(x * y), std::uint8_t(opaque ? 255 : 20 * x)});
      }
    }
    const auto bytes = encode_png(image);
    ASSERT_TRUE(bytes.ok());
    EXPECT_EQ(bytes->substr(1, 3), "PNG");
    EXPECT_EQ((*bytes)[25], opaque ? 2 : 6);  // colour type of the header chunk: RGB or RGBA
    const auto back = decode_png(*bytes);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->rgba, image.rgba);
  }
}

TEST(Image, WhatIsNotAPngIsRefused) {
  EXPECT_EQ(decode_png("").error().code, errors::draw_bad_png);
  EXPECT_EQ(decode_png("GIF89a and more").error().code, errors::draw_bad_png);
  const std::string good = *encode_png(Image::filled(20, 20, {1, 2, 3, 255}));
  EXPECT_EQ(decode_png(std::string_view(good).substr(0, good.size() / 2)).error().code, errors::draw_bad_png);
  EXPECT_EQ(read_png("/nonexistent.png").error().code, errors::file_unreadable);
  EXPECT_EQ(encode_png(Image{}).error().code, errors::draw_bad_size);
}

TEST(Image, ComparisonCountsPixels) {
  const Image a = Image::filled(10, 10, {100, 100, 100, 255});
  Image b = a;
  b.set(3, 4, {105, 100, 100, 255});
  b.set(5, 5, {100, 60, 100, 255});
  const ImageDifference strict = compare_images(a, b), loose = compare_images(a, b, 5);
  EXPECT_EQ(strict.differing_pixels, 2u);
  EXPECT_EQ(strict.largest, 40);
  EXPECT_DOUBLE_EQ(strict.differing_part, 0.02);
  EXPECT_DOUBLE_EQ(strict.mean, 45.0 / 400);
  EXPECT_EQ(loose.differing_pixels, 1u);
  EXPECT_TRUE(loose.within(0.01));
  EXPECT_FALSE(strict.within(0.01));
  const ImageDifference size = compare_images(a, Image::filled(10, 11, {100, 100, 100, 255}), 255);
  EXPECT_FALSE(size.same_size);
  EXPECT_FALSE(size.within(1));
}

TEST(Image, BlankIsSeen) {
  Image a = Image::filled(10, 10, {255, 255, 255, 255});
  EXPECT_EQ(drawn_part(a), 0);
  a.set(9, 9, {0, 0, 0, 255});
  EXPECT_DOUBLE_EQ(drawn_part(a), 0.01);
}

}  // namespace
}  // namespace aresta::draw
