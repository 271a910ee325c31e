// SPDX-License-Identifier: Apache-2.0
// Which faces have the same edges: sets given one after the other, each compared with those of its hash.
#pragma once

#include <algorithm>
#include <array>

#include "planar/pair_map.h"

namespace aresta::planar {

/// A hash of an edge that may be summed over a set: no order, and a sum of few of them is hardly ever another's.
inline std::uint64_t edge_hash(std::uint64_t edge) {
  std::uint64_t h = (edge + 1) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 31)) * 0xbf58476d1ce4e5b9u;
  return h ^ (h >> 32);
}

class EdgeSets {
 public:
  explicit EdgeSets(std::size_t expected) : known_(expected) {}

  /// The number of the earlier set with the same edges, or none: then this one gets the next number, from 0 on. Edges
  /// are given as coedges, 2 * edge + reversed; coedges_of(i) gives those of set number i again.
  template <class CoedgesOf>
  Index add(std::span<const Index> coedges, CoedgesOf&& coedges_of) {
    std::uint64_t hash = 0;
    for (const Index c : coedges) hash += edge_hash(c / 2);
    const auto fresh = static_cast<Index>(next_.size());
    Index last = known_.add(static_cast<Index>(hash >> 32), static_cast<Index>(hash), fresh);
    if (last != fresh) {
      sort(coedges, sorted_[0]);
      for (Index i = last; i != none; i = next_[i]) {
        sort(coedges_of(i), sorted_[1]);
        if (sorted_[0] == sorted_[1]) return i;
        last = i;
      }
      next_[last] = fresh;
    }
    next_.push_back(none);
    return none;
  }

 private:
  static void sort(std::span<const Index> coedges, std::vector<Index>& edges) {
    edges.clear();
    for (const Index c : coedges) edges.push_back(c / 2);
    std::sort(edges.begin(), edges.end());
  }

  PairMap known_;            // from a hash to the first set with it
  std::vector<Index> next_;  // per set: the next one with its hash
  std::array<std::vector<Index>, 2> sorted_;
};

}  // namespace aresta::planar
