// SPDX-License-Identifier: Apache-2.0
// Internal to draw: a scene projected to the screen, for the rasterizer.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "draw/hidden_lines.h"
#include "draw/view.h"

namespace aresta::draw {

/// A triangle on the screen: sample x, sample y, depth; cut at the near plane in perspective.
struct ScreenTriangle {
  std::array<Vec3, 3> p;
  std::uint32_t patch = 0, triangle = 0;
};

/// A stroke or, when both ends are one, a dot.
struct ScreenLine {
  Vec3 a, b;  ///< sample x, sample y, depth
  double radius = 0;
  Color color;
  static constexpr std::uint32_t no_source = 0xffffffffu;
  std::uint32_t source = no_source;  ///< among the lines that were projected; none for a mark
};

struct ScreenScene {
  std::vector<ScreenTriangle> triangles;
  std::vector<ScreenLine> lines;
};

/// The nearest depth that is drawn in perspective.
double near_depth(const View& view);

/// `samples`: screen units a pixel; radii in screen units.
ScreenScene project(const View& view, const Projector& projector, int samples, bool faces,
                    const std::vector<DrawnLine>& lines, double edge_radius, double point_radius);

}  // namespace aresta::draw
