// SPDX-License-Identifier: Apache-2.0
// A static tree of boxes: which of them a box, a ray or another tree's boxes touch. Built by halving at the median of
// the longest side; ties by index, so that the tree depends on the boxes alone. Build n log n.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "math/box.h"

namespace aresta {

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::vector<Box3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::erase_if(order_, [&](std::uint32_t i) { return boxes_[i].empty(); });
    nodes_.reserve(2 * order_.size() / leaf_size + 2);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
  }

  const Box3& box(std::uint32_t i) const { return boxes_[i]; }
  std::size_t size() const { return boxes_.size(); }

  /// visit(i) for every box i that overlaps `box`; in the tree's order.
  template <class Visit>
  void overlapping(const Box3& box, Visit&& visit) const {
    descend([&](const Box3& b) { return b.overlaps(box); }, visit);
  }

  /// visit(i) for every box that the ray from `origin` along `direction` meets at t >= 0.
  template <class Visit>
  void along(Vec3 origin, Vec3 direction, Visit&& visit) const {
    descend([&](const Box3& b) { return meets(b, origin, direction); }, visit);
  }

  /// visit(i, d2) with the squared distance of the box from p, nearest subtrees first; visit returns the squared
  /// distance beyond which nothing is of interest any more.
  template <class Visit>
  void nearest(Vec3 p, Visit&& visit) const {
    if (nodes_.empty()) return;
    double limit = std::numeric_limits<double>::infinity();
    nearest(0, p, limit, visit);
  }

  static bool meets(const Box3& b, Vec3 origin, Vec3 direction, double* enter = nullptr, double* leave = nullptr) {
    double low = 0, high = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      if (direction[i] == 0) {
        if (origin[i] < b.low[i] || origin[i] > b.high[i]) return false;
        continue;
      }
      double t0 = (b.low[i] - origin[i]) / direction[i], t1 = (b.high[i] - origin[i]) / direction[i];
      if (t0 > t1) std::swap(t0, t1);
      low = std::max(low, t0);
      high = std::min(high, t1);
    }
    if (enter != nullptr) *enter = low;
    if (leave != nullptr) *leave = high;
    return low <= high;
  }

  static double distance2(const Box3& b, Vec3 p) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = std::max({b.low[i] - p[i], 0.0, p[i] - b.high[i]});
      sum += d * d;
    }
    return sum;
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Node {
    Box3 box;
    std::uint32_t first = 0, count = 0;  // a leaf's items; count 0: an inner node
    std::uint32_t right = 0;             // its second child; the first follows the node
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Box3 box, centres;
    for (std::uint32_t i = first; i < last; ++i) {
      box.add(boxes_[order_[i]]);
      centres.add(boxes_[order_[i]].centre());
    }
    nodes_[index].box = box;
    if (last - first <= leaf_size) {
      nodes_[index].first = first;
      nodes_[index].count = last - first;
      return index;
    }
    const Vec3 extent = centres.high - centres.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::uint32_t middle = (first + last) / 2;
    std::nth_element(
        order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](std::uint32_t a, std::uint32_t b) {
          const double x = boxes_[a].low[axis] + boxes_[a].high[axis], y = boxes_[b].low[axis] + boxes_[b].high[axis];
          return x < y || (x == y && a < b);
        });
    build(first, middle);
    nodes_[index].right = build(middle, last);
    return index;
  }

  template <class Test, class Visit>
  void descend(Test&& test, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::uint32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const std::uint32_t n = stack[--depth];
      const Node& node = nodes_[n];
      if (!test(node.box)) continue;
      if (node.count > 0) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
          if (test(boxes_[order_[i]])) visit(order_[i]);
        }
      } else {
        stack[depth++] = node.right;
        stack[depth++] = n + 1;
      }
    }
  }

  template <class Visit>
  void nearest(std::uint32_t n, Vec3 p, double& limit, Visit& visit) const {
    const Node& node = nodes_[n];
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const double d2 = distance2(boxes_[order_[i]], p);
        if (d2 <= limit) limit = std::min(limit, visit(order_[i], d2));
      }
      return;
    }
    std::uint32_t near = n + 1, far = node.right;
    double near2 = distance2(nodes_[near].box, p), far2 = distance2(nodes_[far].box, p);
    if (far2 < near2) {
      std::swap(near, far);
      std::swap(near2, far2);
    }
    if (near2 <= limit) nearest(near, p, limit, visit);
    if (far2 <= limit) nearest(far, p, limit, visit);
  }

  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace aresta
