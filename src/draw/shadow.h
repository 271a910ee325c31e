// SPDX-License-Identifier: Apache-2.0
// Internal to draw: the shadow volume of one triangle, and the hierarchy that finds triangles which may cover a
// segment.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "draw/camera.h"

namespace aresta::draw {

struct Interval {
  double from = 0, to = 0;
  bool empty() const { return !(from < to); }
};

/// The space behind a triangle as seen from an eye or along a direction.
class Shadow {
 public:
  Shadow(const std::array<Vec3, 3>& corners, const Projector& projector, double eps);
  /// Seen edge-on, thinner than eps: hides nothing.
  bool thin() const { return thin_; }
  /// The part of a -> b that it hides, ends as parameters in [0, 1]; see hidden_lines.h for tolerances.
  Interval hidden(Vec3 a, Vec3 b) const;
  bool hides(Vec3 p) const;

 private:
  std::array<Vec3, 3> side_normals_, corners_;  ///< unit, inwards; a point of each side plane
  Vec3 normal_;                                 ///< unit, towards the eye
  double eps_;
  bool thin_ = false;
};

/// What a segment or triangle occupies in the picture (view coordinates; divided by depth in perspective), and its
/// least depth.
struct Footprint {
  double low_x, low_y, high_x, high_y, near;
};

/// Triangles by where they are seen, near ones first.
class FootprintTree {
 public:
  explicit FootprintTree(std::vector<Footprint> items);

  /// visit(item) for each item that may cover the segment p -> q of the picture and is not wholly deeper than `far`;
  /// stops when visit answers false.
  template <class Visit>
  void along(Vec2 p, Vec2 q, double far, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::uint32_t stack[128];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (node.box.near > far || !meets(node.box, p, q)) continue;
      if (node.count == 0) {
        const std::uint32_t left = node.first, right = node.first + 1;
        const bool left_nearer = nodes_[left].box.near <= nodes_[right].box.near;
        stack[top++] = left_nearer ? right : left;
        stack[top++] = left_nearer ? left : right;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Footprint& box = items_[order_[i]];
        if (box.near <= far && meets(box, p, q) && !visit(order_[i])) return;
      }
    }
  }

 private:
  struct Node {
    Footprint box;
    std::uint32_t first = 0, count = 0;  ///< items, or with count 0 two children
  };
  static bool meets(const Footprint& b, Vec2 p, Vec2 q) {
    if (std::min(p.x, q.x) > b.high_x || std::max(p.x, q.x) < b.low_x || std::min(p.y, q.y) > b.high_y ||
        std::max(p.y, q.y) < b.low_y) {
      return false;
    }
    // The line through p and q passes the box on one side when all corners lie there.
    const Vec2 d = q - p;
    const double cx = 0.5 * (b.low_x + b.high_x), cy = 0.5 * (b.low_y + b.high_y);
    const double hx = 0.5 * (b.high_x - b.low_x), hy = 0.5 * (b.high_y - b.low_y);
    const double away = std::abs(d.x * (cy - p.y) - d.y * (cx - p.x));
    const double reach = std::abs(d.x) * hy + std::abs(d.y) * hx;
    return away <= reach * (1 + 1e-12) + 1e-300;
  }
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last);

  std::vector<Footprint> items_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  double depth_scale_ = 1;  ///< for comparing extents in depth with those in the picture
};

}  // namespace aresta::draw
