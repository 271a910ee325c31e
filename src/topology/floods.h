// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace aresta::detail {

/// Grows several sets of nodes in turn until all but one are complete or have met.
/// Node: a vertex or an item of one region, as a number; neighbours are visited by `expand`.
class Floods {
 public:
  using Node = std::uint64_t;

  std::size_t add_seed(Node node) {
    const auto [at, fresh] = owner_.emplace(node, groups_.size());
    if (!fresh) return at->second;
    groups_.push_back({{node}, {node}, groups_.size()});
    return groups_.size() - 1;
  }

  std::size_t find(std::size_t g) {
    while (groups_[g].parent != g) g = groups_[g].parent = groups_[groups_[g].parent].parent;
    return g;
  }

  /// Returns when at most one group has work left.
  template <class Expand>
  void run(Expand&& expand) {
    std::vector<std::size_t> active;
    for (std::size_t g = 0; g < groups_.size(); ++g) active.push_back(g);
    const auto is_done = [&](std::size_t g) { return groups_[g].parent != g || groups_[g].queue.empty(); };
    for (;;) {
      std::erase_if(active, is_done);
      if (active.size() <= 1) return;
      for (const std::size_t g : active) {
        if (is_done(g)) continue;
        const Node node = groups_[g].queue.front();
        groups_[g].queue.pop_front();
        expand(node, [&](Node beside) { reach(g, beside); });
      }
    }
  }

  bool is_root(std::size_t g) const { return groups_[g].parent == g; }
  bool is_complete(std::size_t g) const { return groups_[g].queue.empty(); }
  std::size_t count() const { return groups_.size(); }
  const std::vector<Node>& members(std::size_t g) const { return groups_[g].members; }

 private:
  struct Group {
    std::deque<Node> queue;
    std::vector<Node> members;
    std::size_t parent;
  };

  void reach(std::size_t from, Node node) {
    const std::size_t g = find(from);
    const auto [at, fresh] = owner_.emplace(node, g);
    if (fresh) {
      groups_[g].queue.push_back(node);
      groups_[g].members.push_back(node);
      return;
    }
    const std::size_t other = find(at->second);
    if (other == g) return;
    // The set with fewer members joins the other.
    const bool into_other = groups_[other].members.size() >= groups_[g].members.size();
    Group& to = groups_[into_other ? other : g];
    Group& gone = groups_[into_other ? g : other];
    to.queue.insert(to.queue.end(), gone.queue.begin(), gone.queue.end());
    to.members.insert(to.members.end(), gone.members.begin(), gone.members.end());
    gone.parent = into_other ? other : g;
    gone.queue.clear();
    gone.members.clear();
  }

  std::vector<Group> groups_;
  std::unordered_map<Node, std::size_t> owner_;
};

}  // namespace aresta::detail
