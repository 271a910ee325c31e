// SPDX-License-Identifier: Apache-2.0
#include "draw/shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aresta::draw {

Shadow::Shadow(const std::array<Vec3, 3>& corners, const Projector& projector, double eps)
    : corners_(corners), eps_(eps) {
  const auto& [a, b, c] = corners;
  normal_ = normalized(cross(b - a, c - a));
  const double facing = projector.perspective() ? dot(normal_, a - projector.eye()) : dot(normal_, projector.forward());
  if (facing > 0) normal_ = -normal_;
  for (int i = 0; i < 3 && !thin_; ++i) {
    const Vec3 p = corners[i], q = corners[(i + 1) % 3], other = corners[(i + 2) % 3];
    const Vec3 n = projector.perspective() ? cross(q - p, p - projector.eye()) : cross(q - p, projector.forward());
    const double length = norm(n);
    if (!(length > 0)) {
      thin_ = true;
      break;
    }
    side_normals_[i] = n / length;
    double height = dot(side_normals_[i], other - p);
    if (height < 0) {
      side_normals_[i] = -side_normals_[i];
      height = -height;
    }
    thin_ = height <= eps;
  }
}

Interval Shadow::hidden(Vec3 a, Vec3 b) const {
  Interval result{0, 1};
  for (int i = 0; i < 3; ++i) {
    const double fa = dot(side_normals_[i], a - corners_[i]), fb = dot(side_normals_[i], b - corners_[i]);
    if (fa <= eps_ && fb <= eps_) {
      if (fa >= -eps_ && fb >= -eps_) continue;  // runs along the side: covered
      return {};
    }
    if (fa < 0) result.from = std::max(result.from, fa / (fa - fb));
    if (fb < 0) result.to = std::min(result.to, fa / (fa - fb));
  }
  if ((result.to - result.from) * distance(a, b) <= eps_) return {};
  const double ga = dot(normal_, lerp(a, b, result.from) - corners_[0]);
  const double gb = dot(normal_, lerp(a, b, result.to) - corners_[0]);
  if (ga >= -eps_ && gb >= -eps_) return {};
  if (ga > eps_ || gb > eps_) {
    const double pierced = result.from + (result.to - result.from) * (ga / (ga - gb));
    (ga > eps_ ? result.from : result.to) = pierced;
  }
  return result;
}

bool Shadow::hides(Vec3 p) const {
  for (int i = 0; i < 3; ++i) {
    if (dot(side_normals_[i], p - corners_[i]) < -eps_) return false;
  }
  return dot(normal_, p - corners_[0]) < -eps_;
}

FootprintTree::FootprintTree(std::vector<Footprint> items) : items_(std::move(items)) {
  if (items_.empty()) return;
  double low_z = std::numeric_limits<double>::infinity(), high_z = -low_z, low_x = low_z, high_x = -low_z;
  for (const Footprint& f : items_) {
    low_z = std::min(low_z, f.near), high_z = std::max(high_z, f.near);
    low_x = std::min({low_x, f.low_x, f.low_y}), high_x = std::max({high_x, f.high_x, f.high_y});
  }
  depth_scale_ = high_z > low_z ? (high_x - low_x) / (high_z - low_z) : 0;
  order_.resize(items_.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
  nodes_.reserve(items_.size());
  nodes_.push_back({});
  build(0, 0, std::uint32_t(order_.size()));
}

void FootprintTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t last) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Footprint box{inf, inf, -inf, -inf, inf};
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};  // of middles
  const auto middle = [&](std::uint32_t i) {
    const Footprint& f = items_[i];
    return Vec3{0.5 * (f.low_x + f.high_x), 0.5 * (f.low_y + f.high_y), depth_scale_ * f.near};
  };
  for (std::uint32_t i = first; i < last; ++i) {
    const Footprint& f = items_[order_[i]];
    box.low_x = std::min(box.low_x, f.low_x), box.high_x = std::max(box.high_x, f.high_x);
    box.low_y = std::min(box.low_y, f.low_y), box.high_y = std::max(box.high_y, f.high_y);
    box.near = std::min(box.near, f.near);
    const Vec3 m = middle(order_[i]);
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], m[k]), high[k] = std::max(high[k], m[k]);
  }
  nodes_[node].box = box;
  if (last - first <= 4) {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  const Vec3 extent = high - low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t half = (first + last) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                   [&](std::uint32_t i, std::uint32_t j) {
                     const double a = middle(i)[axis], b = middle(j)[axis];
                     return a != b ? a < b : i < j;
                   });
  const auto children = std::uint32_t(nodes_.size());
  nodes_.push_back({});
  nodes_.push_back({});
  nodes_[node].first = children;
  build(children, first, half);
  build(children + 1, half, last);
}

}  // namespace aresta::draw
