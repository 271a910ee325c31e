// SPDX-License-Identifier: Apache-2.0
// Internal to draw: the colour of a place of a face, and the obscurance of corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "draw/png.h"

namespace aresta::draw {

struct Rgb {
  float r = 0, g = 0, b = 0;
};
inline Rgb operator+(Rgb a, Rgb b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
inline Rgb operator*(float s, Rgb a) {
  return {s * a.r, s * a.g, s * a.b};
}
inline Rgb to_rgb(Color c) {
  return {float(c.r), float(c.g), float(c.b)};
}

struct Shade {
  Rgb color;  ///< 0 to 255
  float alpha = 1;
  Vec3 normal;  ///< unit, in view coordinates {right, up, towards the eye}, on the side that is seen
};

/// Light and colours of a view.
class Shader {
 public:
  Shader(const View& view, const Projector& projector, Shading shading, Coloring coloring);

  /// Triangle `triangle` of patch `patch` where it is seen at a pixel position and depth.
  Shade at(std::uint32_t patch, std::uint32_t triangle, Vec2 pixel, double depth) const;

 private:
  const Scene& scene_;
  const Projector& projector_;
  Shading shading_;
  std::vector<std::array<Color, 2>> colors_;
};

/// Depth (infinity: nothing) and normal of each pixel.
struct DepthMap {
  int width = 0, height = 0;
  std::vector<float> depth;
  std::vector<std::array<float, 3>> normal;
};

/// How much light reaches each pixel, 0 to 1; rows [first, last).
void obscure_rows(const DepthMap& map, const Projector& projector, double radius, int first, int last,
                  std::vector<float>& light);
/// Removes the grain of obscure_rows, without mixing places of different depth.
void smooth_rows(const DepthMap& map, const Projector& projector, const std::vector<float>& light, int first, int last,
                 std::vector<float>& result);

}  // namespace aresta::draw
