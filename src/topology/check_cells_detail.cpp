// SPDX-License-Identifier: Apache-2.0
// Third stage: what must hold about one cell and its neighbours. All lists can be walked by now.
#include "topology/check_detail.h"

namespace aresta::check_detail {

namespace {

using namespace structure;

constexpr std::uint32_t none = ComplexRows::none;

void check_uses(const ComplexRows& rows, Findings& findings) {
  const Complex& k = rows.k;
  for (const LoopId l : k.loops()) {
    if (rows.loops()[l.index()].first == none) findings.push_back(LoopEmpty{l});
  }
  for (const FaceId f : k.faces()) {
    if (rows.faces()[f.index()].first_loop == none) findings.push_back(FaceWithoutLoop{f});
  }
  for (const EdgeId e : k.edges()) {
    if (rows.edges()[e.index()].first_use == none) findings.push_back(EdgeUnused{e});
  }
  for (const VertexId v : k.vertices()) {
    const std::uint32_t owner = rows.vertices()[v.index()].owner;
    if (k.has_no_edge(v)) {
      if (owner == none) findings.push_back(VertexUnused{v});
    } else if (k.isolated_in_shell(v).valid()) {
      findings.push_back(IsolatedVertexUsed{v, (*k.edge_ends(v).begin()).edge});
    }
  }
  for (const ShellId s : k.shells()) {
    const auto& shell = rows.shells()[s.index()];
    const bool has_others = shell.first_face_use != none || shell.first_wire != none;
    if (shell.vertex == none && !has_others) findings.push_back(ShellEmpty{s});
    if (shell.vertex != none && has_others) findings.push_back(ShellMixed{s, VertexId(shell.vertex)});
  }
}

void check_loops(const Complex& k, Findings& findings) {
  for (const CoedgeId c : k.coedges()) {
    if (k.end(c) != k.start(k.next(c))) findings.push_back(LoopOpen{k.loop(c), c, k.next(c)});
  }
  // The last face and the loop of it that was seen to be the vertex.
  std::vector<LoopId> loop_of(k.vertex_bound());
  const auto is_in = [&](VertexId v, FaceId f) {
    return loop_of[v.index()].valid() && k.face(loop_of[v.index()]) == f;
  };
  for (const FaceId f : k.faces()) {
    for (const LoopId l : k.loops(f)) {
      if (!k.is_vertex_loop(l)) continue;
      const VertexId v = k.loop_vertex(l);
      if (is_in(v, f)) {
        findings.push_back(VertexTwiceInFace{f, v, loop_of[v.index()], l});
      } else {
        loop_of[v.index()] = l;
      }
    }
    for (const LoopId l : k.loops(f)) {
      for (const CoedgeId c : k.coedges(l)) {
        const VertexId v = k.start(c);
        if (is_in(v, f)) findings.push_back(VertexTwiceInFace{f, v, loop_of[v.index()], l});
      }
    }
  }
}

void check_regions_about(const Complex& k, Findings& findings) {
  if (!k.is_live(Complex::infinite_region())) {
    findings.push_back(InfiniteRegionMissing{});
  } else if (k.is_filled(Complex::infinite_region())) {
    findings.push_back(InfiniteRegionFilled{});
  }
  for (const RegionId r : k.regions()) {
    if (r != Complex::infinite_region() && k.shells(r).empty()) findings.push_back(RegionWithoutShell{r});
  }
  for (const CoedgeId c : k.coedges()) {
    const FaceUse after = k.side_after(c), before = k.side_before(k.radial(c));
    if (k.region(after) != k.region(before)) findings.push_back(SectorInTwoRegions{k.edge(c), after, before});
  }
  // Wires against the regions of the sides at their vertices; `touched` marks these by the vertex.
  std::vector<VertexId> touched(k.region_bound());
  for (const VertexId v : k.vertices()) {
    if (k.isolated_in_shell(v).valid()) continue;
    bool has_faces = false;
    for_each_item_at(k, v, [&](Item item) {
      if (item.kind != Item::Kind::side) return;
      has_faces = true;
      touched[region_of(k, item).index()] = v;
    });
    EdgeId first;
    for (const EdgeEnd end : k.edge_ends(v)) {
      const EdgeId e = end.edge;
      if (!k.is_wire(e)) continue;
      const RegionId r = region_of(k, Item(e));
      if (has_faces) {
        if (touched[r.index()] != v) findings.push_back(WireOutOfReach{e, v, r});
      } else if (!first.valid()) {
        first = e;
      } else if (region_of(k, Item(first)) != r) {
        findings.push_back(WiresInTwoRegions{v, first, e});
      }
    }
  }
}

}  // namespace

void check_cells(const ComplexRows& rows, Findings& findings) {
  check_uses(rows, findings);
  if (!findings.empty()) return;
  check_loops(rows.k, findings);
  check_regions_about(rows.k, findings);
}

}  // namespace aresta::check_detail
