// SPDX-License-Identifier: Apache-2.0
// Candidates come from a tree of boxes, split at medians.
#include "mesh/crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/box.h"

namespace aresta::mesh {

namespace {

using Corners = std::array<std::uint32_t, 3>;

struct Node {
  Box3 box;
  std::uint32_t begin = 0, end = 0;  // of the order
  std::int32_t left = -1, right = -1;
};

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
  return cross(b - a, c - a);
}

/// Looks at one pair of triangles.
class PairTest {
 public:
  PairTest(const std::vector<Vec3>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

  std::optional<Vec3> run(const Corners& s, const Corners& t) {
    int shared = 0;
    for (const std::uint32_t n : s) shared += n == t[0] || n == t[1] || n == t[2] ? 1 : 0;
    if (shared == 3) return (points_[s[0]] + points_[s[1]] + points_[s[2]]) / 3;
    if (shared == 2) {
      test_hinge(s, t);
      return found_;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) break;
    }
    return found_;
  }

 private:
  void report(Vec3 p) { found_ = p; }

  /// Two triangles with a common side overlap when they lie folded onto each other.
  void test_hinge(const Corners& s, const Corners& t) {
    const auto in = [](const Corners& c, std::uint32_t n) { return c[0] == n || c[1] == n || c[2] == n; };
    std::uint32_t common[2] = {0, 0}, apex_s = 0, apex_t = 0;
    int count = 0;
    for (const std::uint32_t n : s) {
      if (in(t, n))
        common[count++] = n;
      else
        apex_s = n;
    }
    for (const std::uint32_t n : t) {
      if (!in(s, n)) apex_t = n;
    }
    const Vec3 a = points_[common[0]], axis = normalized(points_[common[1]] - a);
    const auto across = [&](std::uint32_t n) {
      const Vec3 d = points_[n] - a;
      return normalized(d - dot(d, axis) * axis);
    };
    // Nearly folded counts: less than a thousandth of a radian leaves no room for a tetrahedron.
    const Vec3 x = across(apex_s), y = across(apex_t);
    if (dot(x, y) > 0 && norm(cross(x, y)) < 1e-3) report(0.5 * (points_[apex_s] + points_[apex_t]));
  }

  static double volume(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(cross(b - a, c - a), d - a); }

  /// Does the side pq go through the triangle's plane within the triangle? Sides that end in a corner do not count.
  bool pierces(std::uint32_t pn, std::uint32_t qn, const Corners& t) {
    for (const std::uint32_t n : t) {
      if (n == pn || n == qn) return false;
    }
    const Vec3 p = points_[pn], q = points_[qn], a = points_[t[0]], b = points_[t[1]], c = points_[t[2]];
    const Vec3 normal = normalized(area_vector(a, b, c));
    const double dp = dot(p - a, normal), dq = dot(q - a, normal);
    if ((dp > tolerance_ && dq > tolerance_) || (dp < -tolerance_ && dq < -tolerance_)) return false;
    if (std::abs(dp) <= tolerance_ && std::abs(dq) <= tolerance_) return lies_in(p, q, a, b, c, normal);
    const double x = volume(p, q, a, b), y = volume(p, q, b, c), z = volume(p, q, c, a);
    const bool positive = x >= 0 && y >= 0 && z >= 0, negative = x <= 0 && y <= 0 && z <= 0;
    if (!positive && !negative) return false;
    report(p + dp / (dp - dq) * (q - p));
    return true;
  }

  /// A side in the triangle's plane: does it cross a side of the triangle, or start inside?
  bool lies_in(Vec3 p, Vec3 q, Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
    const auto left = [&](Vec3 u, Vec3 v, Vec3 w) { return dot(cross(v - u, w - u), normal); };
    const Vec3 corners[3] = {a, b, c};
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = corners[k], v = corners[(k + 1) % 3];
      inside = inside && left(u, v, p) > 0;
      if (left(u, v, p) * left(u, v, q) < 0 && left(p, q, u) * left(p, q, v) < 0) inside = true, k = 3;
    }
    if (inside) report(0.5 * (p + q));
    return inside;
  }

  const std::vector<Vec3>& points_;
  double tolerance_;
  std::optional<Vec3> found_;
};

class CrossingFinder {
 public:
  CrossingFinder(const std::vector<Vec3>& points, const std::vector<Corners>& triangles, std::size_t most)
      : points_(points), triangles_(triangles), most_(most) {
    Box3 all;
    for (const auto& t : triangles_) {
      Box3 box;
      for (const std::uint32_t n : t) box.add(points_[n]);
      boxes_.push_back(box);
      all.add(box);
    }
    tolerance_ = 1e-12 * all.diagonal();
    order_.resize(triangles_.size());
    std::iota(order_.begin(), order_.end(), 0u);
  }

  std::vector<Crossing> run() {
    if (triangles_.size() > 1) {
      build(0, static_cast<std::uint32_t>(triangles_.size()));
      meet(0, 0);
    }
    return found_;
  }

 private:
  std::int32_t build(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::int32_t>(tree_.size());
    Node node{{}, begin, end};
    for (std::uint32_t i = begin; i < end; ++i) node.box.add(boxes_[order_[i]]);
    tree_.push_back(node);
    if (end - begin > 4) {
      const Vec3 extent = node.box.high - node.box.low;
      const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
      const std::uint32_t middle = begin + (end - begin) / 2;
      std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                       [&](std::uint32_t a, std::uint32_t b) {
                         const double x = boxes_[a].centre()[axis], y = boxes_[b].centre()[axis];
                         return x != y ? x < y : a < b;
                       });
      const std::int32_t left = build(begin, middle), right = build(middle, end);
      tree_[static_cast<std::size_t>(index)].left = left;
      tree_[static_cast<std::size_t>(index)].right = right;
    }
    return index;
  }

  void meet(std::int32_t a, std::int32_t b) {
    if (found_.size() >= most_) return;
    const Node &x = tree_[static_cast<std::size_t>(a)], &y = tree_[static_cast<std::size_t>(b)];
    if (a != b && !x.box.overlaps(y.box)) return;
    const bool x_leaf = x.left < 0, y_leaf = y.left < 0;
    if (x_leaf && y_leaf) {
      for (std::uint32_t i = x.begin; i < x.end; ++i) {
        for (std::uint32_t j = a == b ? i + 1 : y.begin; j < y.end; ++j) test(order_[i], order_[j]);
      }
    } else if (a == b) {
      meet(x.left, x.left);
      meet(x.right, x.right);
      meet(x.left, x.right);
    } else if (y_leaf || (!x_leaf && x.end - x.begin > y.end - y.begin)) {
      meet(x.left, b);
      meet(x.right, b);
    } else {
      meet(a, y.left);
      meet(a, y.right);
    }
  }

  void test(std::uint32_t i, std::uint32_t j) {
    if (!boxes_[i].overlaps(boxes_[j])) return;
    const auto place = triangles_meet(points_, triangles_[i], triangles_[j], tolerance_);
    if (place) found_.push_back({*place, i, j});
  }

  const std::vector<Vec3>& points_;
  const std::vector<Corners>& triangles_;
  std::size_t most_;
  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> tree_;
  std::vector<Crossing> found_;
  double tolerance_ = 0;
};

}  // namespace

std::optional<Vec3> triangles_meet(const std::vector<Vec3>& points, const Corners& s, const Corners& t,
                                   double tolerance) {
  return PairTest(points, tolerance).run(s, t);
}

std::vector<Crossing> find_crossings(const std::vector<Vec3>& points, const std::vector<Corners>& triangles,
                                     std::size_t most) {
  return CrossingFinder(points, triangles, most).run();
}

}  // namespace aresta::mesh
