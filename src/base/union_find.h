// SPDX-License-Identifier: Apache-2.0
// Disjoint sets whose representative is the smallest member, so that results do not depend on the order of unions.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace aresta {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::size_t size() const { return parent_.size(); }

  std::uint32_t find(std::size_t item) {
    auto i = static_cast<std::uint32_t>(item);
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /// Joins the sets of a and b; false when they were one already.
  bool unite(std::size_t a, std::size_t b) {
    if (parent_[a] == parent_[b]) return false;  // most often, where many join
    std::uint32_t x = find(a), y = find(b);
    if (x == y) return false;
    if (y < x) std::swap(x, y);
    parent_[y] = x;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace aresta
