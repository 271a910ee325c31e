// SPDX-License-Identifier: Apache-2.0
// Last stage: shells, the order about vertices, and regions.
#include <algorithm>
#include <optional>
#include <utility>

#include "topology/check_detail.h"
#include "topology/fans.h"

namespace aresta::check_detail {

namespace {

using namespace structure;

/// Calls visit(v, item) for every vertex of every item; in total as often as there are uses.
template <class Visit>
void for_each_tie(const Complex& k, Visit&& visit) {
  for (const VertexId v : k.vertices()) {
    for_each_item_at(k, v, [&](Item item) { visit(v, item); });
  }
}

VertexId a_vertex_of(const Complex& k, ShellId s) {
  VertexId found = k.shell_vertex(s);
  if (!k.face_uses(s).empty()) {
    const LoopId l = k.first_loop((*k.face_uses(s).begin()).face());
    found = k.is_vertex_loop(l) ? k.loop_vertex(l) : k.start(k.first_coedge(l));
  } else if (!k.wires(s).empty()) {
    found = k.start(*k.wires(s).begin());
  }
  return found;
}

}  // namespace

void check_shells(const Complex& k, Findings& findings) {
  // Items as nodes: sides, then wires; isolated vertices are alone in their shells by now.
  const std::size_t sides = 2 * k.face_bound();
  const auto node = [&](Item item) { return item.kind == Item::Kind::side ? item.index : sides + item.index; };
  UnionFind nodes(sides + k.edge_bound());
  // The last item seen of each shell and the last shell seen of each region, with the vertex that it was seen at.
  std::vector<std::pair<VertexId, Item>> item_at(k.shell_bound());
  std::vector<std::pair<VertexId, ShellId>> shell_at(k.region_bound());
  for_each_tie(k, [&](VertexId v, Item item) {
    if (item.kind == Item::Kind::point) return;
    const ShellId s = shell_of(k, item);
    auto& beside = item_at[s.index()];
    if (beside.first == v) nodes.unite(node(beside.second), node(item));
    beside = {v, item};
    auto& other = shell_at[k.region(s).index()];
    if (other.first == v && other.second != s) {
      findings.push_back(ShellsTouch{v, std::min(s, other.second), std::max(s, other.second)});
    }
    other = {v, s};
  });
  for (const ShellId s : k.shells()) {
    std::optional<Item> first;
    bool reported = false;
    const auto join = [&](Item item) {
      if (!first.has_value()) first = item;
      if (reported || nodes.find(node(*first)) == nodes.find(node(item))) return;
      findings.push_back(ShellDisconnected{s, *first, item});
      reported = true;
    };
    for (const FaceUse u : k.face_uses(s)) join(u);
    for (const EdgeId e : k.wires(s)) join(e);
  }
}

void check_fans(const Complex& k, Findings& findings) {
  // On the sphere about a vertex, edge ends are nodes and corners are arcs between them; fans are the faces of this
  // graph. Each connected part of it must be planar: nodes - arcs + fans = 2.
  UnionFind parts(2 * k.edge_bound());
  const auto end_at_start = [&](CoedgeId c) { return 2 * k.edge(c).index() + (k.reversed(c) ? 1 : 0); };
  for (const CoedgeId c : k.coedges()) parts.unite(end_at_start(c), end_at_start(k.prev(c)) ^ 1u);
  std::vector<int> euler(2 * k.edge_bound(), 0);
  for (const EdgeId e : k.edges()) {
    if (k.is_wire(e)) continue;
    for (std::size_t end = 2 * e.index(); end < 2 * e.index() + 2; ++end) ++euler[parts.find(end)];
  }
  UnionFind corners = fans(k);
  for (const CoedgeId c : k.coedges()) {
    auto& sum = euler[parts.find(end_at_start(c))];
    --sum;
    for (std::size_t corner = 2 * c.index(); corner < 2 * c.index() + 2; ++corner)
      sum += corners.find(corner) == corner;
  }
  for (const EdgeId e : k.edges()) {
    if (k.is_wire(e)) continue;
    for (int end = 0; end < 2; ++end) {
      const std::size_t node = 2 * e.index() + static_cast<std::size_t>(end);
      if (parts.find(node) == node && euler[node] != 2) findings.push_back(FansNotPlanar{k.vertex(EdgeEnd{e, end})});
    }
  }
}

void check_regions(const Complex& k, Findings& findings) {
  UnionFind reached(k.region_bound());
  for (const FaceId f : k.faces()) reached.unite(k.region(FaceUse(f, 0)).index(), k.region(FaceUse(f, 1)).index());
  for (const RegionId r : k.regions()) {
    if (reached.find(r.index()) != 0) findings.push_back(RegionUnreached{r});
  }
  if (!findings.empty()) return;

  // Parts of faces and regions, linked by surfaces of sides; then components and regions, linked by shells.
  UnionFind surfaces = side_surfaces(k), parts = face_parts(k), by_surfaces(k.region_bound() + k.face_bound());
  for (const FaceId f : k.faces()) {
    for (int side = 0; side < 2; ++side) {
      const FaceUse u(f, side);
      if (surfaces.find(u.index()) != u.index()) continue;
      if (!by_surfaces.unite(k.region(u).index(), k.region_bound() + parts.find(f.index()))) {
        findings.push_back(RegionDivided{k.region(u), u});
      }
    }
  }
  if (!findings.empty()) return;
  UnionFind connected = components(k), by_shells(k.region_bound() + k.vertex_bound());
  for (const ShellId s : k.shells()) {
    if (!by_shells.unite(k.region(s).index(), k.region_bound() + connected.find(a_vertex_of(k, s).index()))) {
      findings.push_back(ShellApart{k.region(s), s});
    }
  }
}

}  // namespace aresta::check_detail
