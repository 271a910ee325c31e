// SPDX-License-Identifier: Apache-2.0
// Small soups for tests: boxes, polygons, segments and points, one operand after the other.
#pragma once

#include <vector>

#include "planar/box.h"
#include "planar/imprint.h"

namespace aresta::planar::test {

class SoupMaker {
 public:
  /// Starts the next operand; what follows belongs to it.
  SoupMaker& operand(bool stitched = true) {
    soup_.stitched.push_back(stitched);
    return *this;
  }

  SoupMaker& point(Vec3 p) {
    vertex(p);
    return *this;
  }
  SoupMaker& segment(Vec3 a, Vec3 b) {
    const Index s = vertex(a);
    edge(s, vertex(b));
    return *this;
  }
  /// A polygon, with holes: each loop counterclockwise about the normal, holes clockwise.
  SoupMaker& polygon(const std::vector<std::vector<Vec3>>& loops) {
    for (const auto& loop : loops) {
      const auto first = static_cast<Index>(soup_.points.size());
      for (const Vec3 p : loop) vertex(p);
      const auto n = static_cast<Index>(loop.size());
      for (Index i = 0; i < n; ++i) soup_.shape.add_coedge(edge(first + i, first + (i + 1) % n), false);
      soup_.shape.close_loop();
    }
    return close_face();
  }
  SoupMaker& polygon(const std::vector<Vec3>& loop) { return polygon(std::vector<std::vector<Vec3>>{loop}); }

  SoupMaker& box(Vec3 low, Vec3 high) {
    const auto first = static_cast<Index>(soup_.points.size());
    for (const Vec3 p : aresta::test::box_corners(low, high)) vertex(p);
    std::vector<IndexPair> known;
    const auto first_edge = soup_.shape.edge_count();
    for (const auto& side : aresta::test::box_sides) {
      for (std::size_t i = 0; i < 4; ++i) {
        const Index a = first + side[i], b = first + side[(i + 1) % 4];
        std::size_t e = 0;
        while (e < known.size() && known[e] != IndexPair{a, b} && known[e] != IndexPair{b, a}) ++e;
        if (e == known.size()) {
          known.emplace_back(a, b);
          edge(a, b);
        }
        soup_.shape.add_coedge(first_edge + static_cast<Index>(e), known[e] != IndexPair{a, b});
      }
      soup_.shape.close_loop();
      close_face();
    }
    return *this;
  }

  const Soup& soup() {
    soup_.shape.vertex_count = static_cast<Index>(soup_.points.size());
    return soup_;
  }

 private:
  Index vertex(Vec3 p) {
    soup_.points.push_back(p);
    soup_.vertex_operand.push_back(current());
    return static_cast<Index>(soup_.points.size() - 1);
  }
  Index edge(Index a, Index b) {
    soup_.shape.edges.push_back({a, b});
    soup_.edge_operand.push_back(current());
    return soup_.shape.edge_count() - 1;
  }
  SoupMaker& close_face() {
    soup_.shape.close_face();
    soup_.face_operand.push_back(current());
    return *this;
  }
  Index current() {
    if (soup_.stitched.empty()) operand();
    return static_cast<Index>(soup_.stitched.size() - 1);
  }

  Soup soup_;
};

/// A rectangle in the plane z = `z`, its normal up.
inline std::vector<Vec3> rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

}  // namespace aresta::planar::test
