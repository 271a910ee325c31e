// SPDX-License-Identifier: Apache-2.0
// Items: what the boundary of a region consists of. Each lies in exactly one region and in one shell of it.
#pragma once

#include <compare>

#include "topology/complex.h"

namespace aresta {

/// A side of a face, a wire, or an isolated vertex.
struct Item {
  enum class Kind : std::uint8_t { side, wire, point };
  Kind kind = Kind::side;
  std::uint32_t index = 0xffffffffu;

  constexpr Item() = default;
  constexpr Item(FaceUse u) : kind(Kind::side), index(static_cast<std::uint32_t>(u.index())) {}
  constexpr Item(EdgeId e) : kind(Kind::wire), index(e.value) {}
  constexpr Item(VertexId v) : kind(Kind::point), index(v.value) {}
  constexpr FaceUse side() const { return FaceUse::from_index(index); }
  constexpr EdgeId wire() const { return EdgeId(index); }
  constexpr VertexId point() const { return VertexId(index); }
  constexpr auto operator<=>(const Item&) const = default;
};

inline ShellId shell_of(const Complex& k, Item item) {
  switch (item.kind) {
    case Item::Kind::side:
      return k.shell(item.side());
    case Item::Kind::wire:
      return k.wire_shell(item.wire());
    case Item::Kind::point:
      return k.isolated_in_shell(item.point());
  }
  return {};
}

inline RegionId region_of(const Complex& k, Item item) {
  return k.region(shell_of(k, item));
}

/// Visits the items at a vertex, of all regions; one may come several times. In time proportional to the uses there.
template <class Visit>
void for_each_item_at(const Complex& k, VertexId v, Visit&& visit) {
  for (const EdgeEnd end : k.edge_ends(v)) {
    if (k.is_wire(end.edge)) {
      visit(Item(end.edge));
      continue;
    }
    for (const CoedgeId c : k.coedges(end.edge)) {
      visit(Item(FaceUse(k.face(c), 0)));
      visit(Item(FaceUse(k.face(c), 1)));
    }
  }
  for (const LoopId l : k.vertex_loops(v)) {
    visit(Item(FaceUse(k.face(l), 0)));
    visit(Item(FaceUse(k.face(l), 1)));
  }
  if (k.isolated_in_shell(v).valid()) visit(Item(v));
}

/// Visits the vertices of an item; one may come several times.
template <class Visit>
void for_each_vertex_of(const Complex& k, Item item, Visit&& visit) {
  switch (item.kind) {
    case Item::Kind::side:
      for (const LoopId l : k.loops(item.side().face())) {
        if (k.is_vertex_loop(l)) visit(k.loop_vertex(l));
        for (const CoedgeId c : k.coedges(l)) visit(k.start(c));
      }
      return;
    case Item::Kind::wire:
      visit(k.start(item.wire()));
      visit(k.end(item.wire()));
      return;
    case Item::Kind::point:
      visit(item.point());
      return;
  }
}

/// Visits the sides that share a sector about some edge with a side of a face: its neighbours along its region's
/// boundary.
template <class Visit>
void for_each_side_beside(const Complex& k, FaceUse u, Visit&& visit) {
  for (const LoopId l : k.loops(u.face())) {
    for (const CoedgeId c : k.coedges(l)) {
      if (k.side_after(c) == u) visit(k.side_before(k.radial(c)));
      if (k.side_before(c) == u) visit(k.side_after(k.radial_prev(c)));
    }
  }
}

}  // namespace aresta
