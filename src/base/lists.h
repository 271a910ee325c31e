// SPDX-License-Identifier: Apache-2.0
// Lists of indices, one for each of many owners, in two flat arrays.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace aresta {

/// List i is items [begin[i], begin[i + 1]).
struct Lists {
  std::vector<std::uint32_t> begin{0};
  std::vector<std::uint32_t> items;

  std::size_t size() const { return begin.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {items.data() + begin[i], begin[i + 1] - begin[i]};
  }
};

using IndexPair = std::pair<std::uint32_t, std::uint32_t>;

/// The second members by their first, which must be below `count`; members of a list stay in the order of the pairs.
/// Linear.
inline Lists group(std::size_t count, std::span<const IndexPair> pairs) {
  Lists lists;
  lists.begin.assign(count + 1, 0);
  for (const auto& [owner, item] : pairs) ++lists.begin[owner + 1];
  for (std::size_t i = 0; i < count; ++i) lists.begin[i + 1] += lists.begin[i];
  lists.items.resize(pairs.size());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  for (const auto& [owner, item] : pairs) lists.items[next[owner]++] = item;
  return lists;
}

}  // namespace aresta
