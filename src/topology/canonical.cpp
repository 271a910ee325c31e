// SPDX-License-Identifier: Apache-2.0
#include "topology/canonical.h"

#include <algorithm>

namespace aresta {

namespace {

template <class Item, class Range>
std::vector<Item> listed(const Range& range) {
  std::vector<Item> result;
  for (const Item item : range) result.push_back(item);
  return result;
}

template <class Item>
std::vector<Item> sorted(std::vector<Item> items) {
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<CoedgeId> from_smallest(std::vector<CoedgeId> cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

}  // namespace

std::vector<std::vector<Item>> canonical_shells(const Complex& k, RegionId r) {
  std::vector<std::vector<Item>> shells;
  for (const ShellId s : k.shells(r)) {
    auto& items = shells.emplace_back();
    for (const FaceUse u : k.face_uses(s)) items.push_back(u);
    for (const EdgeId e : k.wires(s)) items.push_back(e);
    if (k.shell_vertex(s).valid()) items.push_back(k.shell_vertex(s));
    std::sort(items.begin(), items.end());
  }
  return sorted(std::move(shells));
}

std::vector<LoopId> canonical_loops(const Complex& k, FaceId f) {
  return sorted(listed<LoopId>(k.loops(f)));
}

std::vector<CoedgeId> canonical_coedges(const Complex& k, LoopId l) {
  return from_smallest(listed<CoedgeId>(k.coedges(l)));
}

std::vector<CoedgeId> canonical_coedges(const Complex& k, EdgeId e) {
  return from_smallest(listed<CoedgeId>(k.coedges(e)));
}

std::vector<EdgeEnd> canonical_edge_ends(const Complex& k, VertexId v) {
  return sorted(listed<EdgeEnd>(k.edge_ends(v)));
}

std::vector<LoopId> canonical_vertex_loops(const Complex& k, VertexId v) {
  return sorted(k.vertex_loops(v));
}

}  // namespace aresta
