// SPDX-License-Identifier: Apache-2.0
// When two pictures of an example count as the same.
//
// Pictures are the same bytes on one machine; on another the last digits of sines and of OCCT's curves may differ,
// which moves what is on the border of a pixel. So a channel may be off by 24 of 255, and 1 pixel of 2000 by any
// amount: with 480 x 360 pixels as many as a square of 9 x 9, less than any edge, hole or face that is seen covers.
#pragma once

#include <string>

#include "draw/image.h"

namespace aresta::test {

struct PictureTolerance {
  int channel = 24;
  double part = 0.0005;
};

/// Empty when they are the same, else what differs.
inline std::string picture_difference(const draw::Image& stored, const draw::Image& found,
                                      const PictureTolerance& tolerance = {}) {
  if (draw::drawn_part(found) == 0) return "the picture is blank";
  const draw::ImageDifference d = draw::compare_images(stored, found, tolerance.channel);
  if (!d.same_size) {
    return "the picture has " + std::to_string(found.width) + " x " + std::to_string(found.height) +
           " pixels, the stored one " + std::to_string(stored.width) + " x " + std::to_string(stored.height);
  }
  if (d.within(tolerance.part)) return {};
  return std::to_string(d.differing_pixels) + " pixels differ by more than " + std::to_string(tolerance.channel) +
         " of 255, " + std::to_string(int(tolerance.part * stored.width * stored.height)) + " may";
}

}  // namespace aresta::test
