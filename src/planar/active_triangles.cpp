// SPDX-License-Identifier: Apache-2.0
#include "planar/active_triangles.h"

#include <algorithm>
#include <cmath>

#include "math/box.h"

namespace aresta::planar {

namespace {

constexpr double most_cells = 1 << 27;

Box3 bounds(const TriangleMesh& mesh) {
  Box3 box;
  for (const Vec3 p : mesh.points) box.add(p);
  return box;
}

Box3 box_of(const TriangleMesh& mesh, Index t, double grow) {
  Box3 box;
  for (const Index v : mesh.triangles[t]) box.add(mesh.points[v]);
  return box.grown(grow);
}

/// Bits over a box, at most `most_cells` of about the given width.
class BitGrid {
 public:
  BitGrid(const Box3& box, double width) : low_(box.low) {
    const Vec3 size = box.high - box.low;
    const auto cells = [&](double w) {
      double product = 1;
      for (int i = 0; i < 3; ++i) product *= std::floor(size[i] / w) + 1;
      return product;
    };
    while (cells(width) > most_cells) width *= 1.25;
    scale_ = 1 / width;
    for (int i = 0; i < 3; ++i) count_[i] = static_cast<std::int64_t>(size[i] * scale_) + 1;
    bits_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2] + 63) / 64);
  }

  void clear() { std::fill(bits_.begin(), bits_.end(), 0); }
  void mark(const Box3& box) {
    visit(box, [&](std::int64_t i) {
      bits_[static_cast<std::size_t>(i) / 64] |= std::uint64_t{1} << (i % 64);
      return false;
    });
  }
  bool is_marked(const Box3& box) const {
    return visit(box, [&](std::int64_t i) { return (bits_[static_cast<std::size_t>(i) / 64] >> (i % 64) & 1) != 0; });
  }

 private:
  /// Until `found` says true.
  template <class Found>
  bool visit(const Box3& box, Found&& found) const {
    std::int64_t from[3], to[3];
    for (int i = 0; i < 3; ++i) {
      from[i] = std::clamp(static_cast<std::int64_t>((box.low[i] - low_[i]) * scale_), std::int64_t{0}, count_[i] - 1);
      to[i] = std::clamp(static_cast<std::int64_t>((box.high[i] - low_[i]) * scale_), std::int64_t{0}, count_[i] - 1);
    }
    for (std::int64_t z = from[2]; z <= to[2]; ++z) {
      for (std::int64_t y = from[1]; y <= to[1]; ++y) {
        const std::int64_t row = (z * count_[1] + y) * count_[0];
        for (std::int64_t x = from[0]; x <= to[0]; ++x) {
          if (found(row + x)) return true;
        }
      }
    }
    return false;
  }

  Vec3 low_;
  double scale_ = 1;
  std::int64_t count_[3]{};
  std::vector<std::uint64_t> bits_;
};

}  // namespace

ActiveTriangles active_triangles(const TriangleMesh& a, const TriangleMesh& b, double tolerance) {
  ActiveTriangles active;
  const Box3 one = bounds(a).grown(2 * tolerance), two = bounds(b).grown(2 * tolerance);
  if (one.empty() || two.empty() || !one.overlaps(two)) return active;
  Box3 common;
  for (int i = 0; i < 3; ++i) {
    common.low[i] = std::max(one.low[i], two.low[i]);
    common.high[i] = std::min(one.high[i], two.high[i]);
  }
  // Those that reach into the common box, and how wide they are.
  std::array<std::vector<Index>, 2> near;
  double width = 0;
  for (std::size_t m = 0; m < 2; ++m) {
    const TriangleMesh& mesh = m == 0 ? a : b;
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
      const Box3 box = box_of(mesh, t, tolerance);
      if (!box.overlaps(common)) continue;
      near[m].push_back(t);
      const Vec3 size = box.high - box.low;
      width += std::max({size.x, size.y, size.z});
    }
  }
  if (near[0].empty() || near[1].empty()) return active;
  width /= static_cast<double>(near[0].size() + near[1].size());
  BitGrid grid(common, std::max(width, 4 * tolerance));
  for (const Index t : near[0]) grid.mark(box_of(a, t, tolerance));
  for (const Index t : near[1]) {
    if (grid.is_marked(box_of(b, t, tolerance))) active[1].push_back(t);
  }
  grid.clear();
  for (const Index t : active[1]) grid.mark(box_of(b, t, tolerance));
  for (const Index t : near[0]) {
    if (grid.is_marked(box_of(a, t, tolerance))) active[0].push_back(t);
  }
  return active;
}

}  // namespace aresta::planar
