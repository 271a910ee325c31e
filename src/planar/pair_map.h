// SPDX-License-Identifier: Apache-2.0
// A table from pairs of indices to an index.
#pragma once

#include "base/lists.h"

namespace aresta::planar {

using Index = std::uint32_t;
inline constexpr Index none = 0xffffffffu;

/// From a pair of indices to an index: open addressing, at most half full. Nothing depends on the order inside.
class PairMap {
 public:
  explicit PairMap(std::size_t expected = 0) {
    std::size_t slots = 16;
    while (slots < 2 * expected) slots *= 2;
    slots_.resize(slots);
  }

  /// The index stored for (a, b), storing `fresh` if there is none.
  Index add(Index a, Index b, Index fresh) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = find_slot(key(a, b));
    if (slot.value == none) {
      slot = {key(a, b), fresh};
      ++count_;
    }
    return slot.value;
  }
  Index find(Index a, Index b) const { return const_cast<PairMap*>(this)->find_slot(key(a, b)).value; }
  bool contains(Index a, Index b) const { return find(a, b) != none; }
  std::size_t size() const { return count_; }

 private:
  struct Slot {
    std::uint64_t key = 0;
    Index value = none;
  };

  static std::uint64_t key(Index a, Index b) { return std::uint64_t{a} << 32 | b; }

  Slot& find_slot(std::uint64_t k) {
    std::uint64_t h = k * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
    for (std::size_t i = h & (slots_.size() - 1);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].value == none || slots_[i].key == k) return slots_[i];
    }
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.value != none) find_slot(slot.key) = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace aresta::planar
