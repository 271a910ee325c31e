// SPDX-License-Identifier: Apache-2.0
// Axis-parallel boxes; an empty box holds nothing and adds nothing.
#pragma once

#include <limits>

#include "math/vec.h"

namespace aresta {

struct Box3 {
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};

  constexpr bool empty() const { return low.x > high.x; }
  constexpr void add(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  constexpr void add(const Box3& b) {
    if (b.empty()) return;
    add(b.low);
    add(b.high);
  }
  constexpr Box3 grown(double d) const {
    if (empty()) return *this;
    return {low - Vec3{d, d, d}, high + Vec3{d, d, d}};
  }
  constexpr bool overlaps(const Box3& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
           b.low.z <= high.z;
  }
  constexpr bool contains(Vec3 p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z && p.z <= high.z;
  }
  constexpr Vec3 centre() const { return 0.5 * (low + high); }
  double diagonal() const { return empty() ? 0 : distance(low, high); }

 private:
  static constexpr double inf = std::numeric_limits<double>::infinity();
};

}  // namespace aresta
