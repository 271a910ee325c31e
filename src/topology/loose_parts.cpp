// SPDX-License-Identifier: Apache-2.0
#include "topology/loose_parts.h"

#include "base/union_find.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;

}  // namespace

std::vector<std::uint32_t> wire_groups(const Incidence& in) {
  std::vector<bool> edge_used(in.edge_count(), false), vertex_on_face(in.vertex_count, false);
  for (const std::uint32_t code : in.coedges) edge_used[code >> 1] = true;
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (edge_used[e]) vertex_on_face[in.edges[e][0]] = vertex_on_face[in.edges[e][1]] = true;
  }
  for (const std::uint32_t v : in.loop_vertex) {
    if (v != none) vertex_on_face[v] = true;
  }
  UnionFind sets(in.edge_count());
  std::vector<std::uint32_t> first(in.vertex_count, none);
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (edge_used[e]) continue;
    for (const std::uint32_t v : in.edges[e]) {
      if (vertex_on_face[v]) continue;
      if (first[v] == none) first[v] = e;
      sets.unite(first[v], e);
    }
  }
  std::vector<std::uint32_t> groups(in.edge_count(), none);
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (!edge_used[e]) groups[e] = sets.find(e);
  }
  return groups;
}

std::vector<std::uint32_t> isolated_vertices(const Incidence& in) {
  std::vector<bool> used(in.vertex_count, false);
  for (const auto& e : in.edges) used[e[0]] = used[e[1]] = true;
  for (const std::uint32_t v : in.loop_vertex) {
    if (v != none) used[v] = true;
  }
  std::vector<std::uint32_t> isolated;
  for (std::uint32_t v = 0; v < in.vertex_count; ++v) {
    if (!used[v]) isolated.push_back(v);
  }
  return isolated;
}

}  // namespace aresta
