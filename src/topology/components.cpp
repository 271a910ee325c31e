// SPDX-License-Identifier: Apache-2.0
#include "topology/components.h"

#include <algorithm>
#include <unordered_set>

#include "topology/floods.h"

namespace aresta {

ShellId shell_at(const Complex& k, VertexId v, RegionId r) {
  ShellId found;
  for_each_item_at(k, v, [&](Item item) {
    const ShellId s = shell_of(k, item);
    if (!found.valid() && s.valid() && k.region(s) == r) found = s;
  });
  return found;
}

std::vector<FaceUse> side_component(const Complex& k, FaceUse u) {
  std::vector<FaceUse> members{u};
  std::unordered_set<std::size_t> seen{u.index()};
  for (std::size_t i = 0; i < members.size(); ++i) {
    for_each_side_beside(k, members[i], [&](FaceUse beside) {
      if (seen.insert(beside.index()).second) members.push_back(beside);
    });
  }
  std::sort(members.begin(), members.end());
  return members;
}

bool sides_connected(const Complex& k, FaceUse a, FaceUse b, bool of_b, std::vector<FaceUse>* part) {
  if (a == b) return true;
  detail::Floods floods;
  floods.add_seed(a.index());
  floods.add_seed(b.index());
  floods.run([&](detail::Floods::Node node, auto&& reach) {
    for_each_side_beside(k, FaceUse::from_index(node), [&](FaceUse u) { reach(u.index()); });
  });
  if (floods.find(0) == floods.find(1)) return true;
  if (part == nullptr) return false;
  const std::size_t wanted = of_b ? 1 : 0;
  if (floods.is_complete(wanted)) {
    for (const auto node : floods.members(wanted)) part->push_back(FaceUse::from_index(node));
    std::sort(part->begin(), part->end());
  } else {
    *part = side_component(k, of_b ? b : a);
  }
  return false;
}

}  // namespace aresta
