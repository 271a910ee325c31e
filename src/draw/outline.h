// SPDX-License-Identifier: Apache-2.0
// Internal to draw: points of equal coordinates given one number, and the silhouettes of patches.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "draw/camera.h"
#include "draw/hidden_lines.h"

namespace aresta::draw {

/// Numbers for places: equal coordinates, equal number (0 and -0 are equal). In the order of first use.
class PointNumbers {
 public:
  std::uint32_t number(Vec3 p);
  static constexpr std::uint32_t unknown = 0xffffffffu;
  /// `unknown` for a place never numbered.
  std::uint32_t find(Vec3 p) const;
  std::size_t size() const { return points_.size(); }
  Vec3 place(std::uint32_t number) const { return points_[number]; }

 private:
  void grow();
  std::size_t slot(Vec3 p) const;
  std::vector<Vec3> points_;
  std::vector<std::uint32_t> table_;
};

/// All triangles of a scene by numbers of their corners.
struct TriangleSoup {
  PointNumbers numbers;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint32_t> patch;
  std::vector<std::uint32_t> first;  ///< triangle of each patch
};
TriangleSoup triangle_soup(const Scene& scene);

/// The silhouettes of a scene's patches, chained, by patch. Where a silhouette ends in a cusp, as that of the hole of a
/// torus does, it turns back behind the surface. Triangles know the cusp no better than to their own size, and the
/// sides of those just behind it would be seen as a hook. The normals tell: where the surface curves towards the eye
/// along the sight (negative radial curvature: Koenderink, What Does the Occluding Contour Tell Us about Solid Shape?,
/// 1984), a fold that the triangles take for the near one is `behind`.
std::vector<DrawnLine> silhouettes(const Scene& scene, const TriangleSoup& soup, const Projector& projector);

}  // namespace aresta::draw
