// SPDX-License-Identifier: Apache-2.0
// Points within a radius of a place, by a hash of cubes four radii wide: most places touch one cube.
#pragma once

#include <cmath>

#include "math/vec.h"
#include "planar/pair_map.h"

namespace aresta::planar {

class PointGrid {
 public:
  PointGrid(double radius, std::size_t expected) : radius_(radius), scale_(1 / (4 * radius)) {
    std::size_t buckets = 64;
    while (buckets < expected) buckets *= 2;
    head_.assign(buckets, none);
    next_.reserve(expected);
  }

  double radius() const { return radius_; }

  /// visit(i) for every point within the radius of p, and some that are farther; by falling index within a cube.
  template <class Visit>
  void near(Vec3 p, Visit&& visit) const {
    std::int64_t low[3], high[3];
    for (int i = 0; i < 3; ++i) {
      low[i] = cell(p[i] - radius_);
      high[i] = cell(p[i] + radius_);
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          for (Index i = head_[bucket(x, y, z)]; i != none; i = next_[i]) visit(i);
        }
      }
    }
  }

  /// Indices are given out in the order of the calls.
  void add(Vec3 p) {
    const auto i = static_cast<Index>(next_.size());
    place_.push_back(hash(cell(p.x), cell(p.y), cell(p.z)));
    next_.push_back(none);
    if (next_.size() > head_.size()) return grow();
    link(i);
  }

 private:
  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x * scale_)); }

  static std::uint64_t hash(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(y)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 29) ^ static_cast<std::uint64_t>(z)) * 0x94d049bb133111ebu;
    return h ^ (h >> 31);
  }
  std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return hash(x, y, z) & (head_.size() - 1);
  }

  void link(Index i) {
    Index& head = head_[place_[i] & (head_.size() - 1)];
    next_[i] = head;
    head = i;
  }
  void grow() {
    head_.assign(2 * head_.size(), none);
    for (Index i = 0; i < next_.size(); ++i) link(i);
  }

  double radius_, scale_;
  std::vector<Index> head_, next_;
  std::vector<std::uint64_t> place_;
};

}  // namespace aresta::planar
