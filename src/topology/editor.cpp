// SPDX-License-Identifier: Apache-2.0
#include "topology/editor.h"

#include <algorithm>

#include "topology/components.h"
#include "topology/floods.h"

namespace aresta {

namespace {

constexpr std::uint32_t no_row = 0xffffffffu;

}  // namespace

// --- rows

template <class Rows, class Link>
std::uint32_t Editor::allocate(Rows& rows, Complex::Rows kind, std::uint32_t wanted, Link&& links) {
  auto& free = k_.free_[kind];
  if (wanted != no_row && wanted >= rows.size()) {
    const auto size = static_cast<std::uint32_t>(rows.size());
    rows.resize(std::size_t{wanted} + 1);
    for (std::uint32_t row = wanted; row-- > size;) release(rows, kind, row, links);
    return wanted;
  }
  if (wanted == no_row && free.first == no_row) {
    rows.push_back({});
    return static_cast<std::uint32_t>(rows.size() - 1);
  }
  // The row asked for is the first free one when changes are taken back in order.
  std::uint32_t row = free.first, before = no_row;
  while (wanted != no_row && row != wanted) {
    before = row;
    row = links(rows.edit(row)).second;
  }
  const std::uint32_t next = links(rows.edit(row)).second;
  (before == no_row ? free.first : links(rows.edit(before)).second) = next;
  --free.count;
  rows.edit(row) = {};
  return row;
}

template <class Rows, class Link>
void Editor::release(Rows& rows, Complex::Rows kind, std::uint32_t row, Link&& links) {
  auto& free = k_.free_[kind];
  rows.edit(row) = {};
  const auto [mark, next] = links(rows.edit(row));
  mark = Complex::dead;
  next = free.first;
  free.first = row;
  ++free.count;
}

namespace {

// For each kind of row the member that marks it dead and the one that names the next free row.
using Links = std::pair<std::uint32_t&, std::uint32_t&>;
constexpr auto vertex_links = [](auto& r) { return Links(r.first_end, r.owner); };
constexpr auto edge_links = [](auto& r) { return Links(r.vertex[0], r.vertex[1]); };
constexpr auto wire_links = [](auto& r) { return Links(r.edge, r.next); };
constexpr auto coedge_links = [](auto& r) { return Links(r.loop, r.next); };
constexpr auto point_links = [](auto& r) { return Links(r.loop, r.next); };
constexpr auto loop_links = [](auto& r) { return Links(r.face, r.next); };
constexpr auto face_links = [](auto& r) { return Links(r.first_loop, r.shell[0]); };
constexpr auto shell_links = [](auto& r) { return Links(r.region, r.next); };
constexpr auto region_links = [](auto& r) { return Links(r.filled, r.first_shell); };

}  // namespace

VertexId Editor::make_vertex(VertexId wanted) {
  return VertexId(allocate(k_.vertices_, Complex::vertex_rows, wanted.value, vertex_links));
}
EdgeId Editor::make_edge(EdgeId wanted) {
  return EdgeId(allocate(k_.edges_, Complex::edge_rows, wanted.value, edge_links));
}
CoedgeId Editor::make_coedge(CoedgeId wanted) {
  return CoedgeId(allocate(k_.coedges_, Complex::coedge_rows, wanted.value, coedge_links));
}
LoopId Editor::make_loop(LoopId wanted) {
  return LoopId(allocate(k_.loops_, Complex::loop_rows, wanted.value, loop_links));
}
FaceId Editor::make_face(FaceId wanted) {
  return FaceId(allocate(k_.faces_, Complex::face_rows, wanted.value, face_links));
}
RegionId Editor::make_region(bool filled, RegionId wanted) {
  const RegionId r(allocate(k_.regions_, Complex::region_rows, wanted.value, region_links));
  set_filled(r, filled);
  return r;
}
ShellId Editor::make_shell(RegionId region) {
  const ShellId s(allocate(k_.shells_, Complex::shell_rows, no_row, shell_links));
  k_.shells_.edit(s.index()).region = region.value;
  auto& first = k_.regions_.edit(region.index()).first_shell;
  if (first == no_row) {
    first = s.value;
    k_.shells_.edit(s.index()).prev = s.value;
  } else {
    const std::uint32_t last = k_.shells_[first].prev;
    k_.shells_.edit(s.index()).prev = last;
    k_.shells_.edit(last).next = s.value;
    k_.shells_.edit(first).prev = s.value;
  }
  return s;
}

void Editor::free(VertexId v) {
  release(k_.vertices_, Complex::vertex_rows, v.value, vertex_links);
}
void Editor::free(EdgeId e) {
  release(k_.edges_, Complex::edge_rows, e.value, edge_links);
}
void Editor::free(CoedgeId c) {
  release(k_.coedges_, Complex::coedge_rows, c.value, coedge_links);
}
void Editor::free(LoopId l) {
  release(k_.loops_, Complex::loop_rows, l.value, loop_links);
}
void Editor::free(FaceId f) {
  release(k_.faces_, Complex::face_rows, f.value, face_links);
}
void Editor::free(RegionId r) {
  release(k_.regions_, Complex::region_rows, r.value, region_links);
}
void Editor::free(ShellId s) {
  const auto record = k_.shells_[s.index()];
  auto& first = k_.regions_.edit(record.region).first_shell;
  if (record.next != no_row) k_.shells_.edit(record.next).prev = record.prev;
  if (first == s.value) {
    first = record.next;
  } else {
    k_.shells_.edit(record.prev).next = record.next;
    if (record.next == no_row) k_.shells_.edit(first).prev = record.prev;
  }
  release(k_.shells_, Complex::shell_rows, s.value, shell_links);
}

// --- edge ends

void Editor::attach(EdgeEnd end, VertexId v) {
  const std::uint32_t code = 2 * end.edge.value + static_cast<std::uint32_t>(end.end);
  auto& record = k_.edges_.edit(end.edge.index());
  record.vertex[end.end] = v.value;
  auto& first = k_.vertices_.edit(v.index()).first_end;
  if (first == no_row) {
    first = code;
    record.next[end.end] = record.prev[end.end] = code;
    return;
  }
  const std::uint32_t last = k_.edges_[first >> 1].prev[first & 1u];
  record.next[end.end] = first;
  record.prev[end.end] = last;
  k_.edges_.edit(last >> 1).next[last & 1u] = code;
  k_.edges_.edit(first >> 1).prev[first & 1u] = code;
}

void Editor::detach(EdgeEnd end) {
  const std::uint32_t code = 2 * end.edge.value + static_cast<std::uint32_t>(end.end);
  const std::uint32_t next = k_.edges_[end.edge.index()].next[end.end],
                      prev = k_.edges_[end.edge.index()].prev[end.end];
  auto& first = k_.vertices_.edit(k_.vertex(end).index()).first_end;
  if (next == code) {
    first = no_row;
  } else {
    if (first == code) first = next;
    k_.edges_.edit(next >> 1).prev[next & 1u] = prev;
    k_.edges_.edit(prev >> 1).next[prev & 1u] = next;
  }
  k_.edges_.edit(end.edge.index()).vertex[end.end] = no_row;
}

// --- loops

void Editor::append_loop(FaceId f, LoopId l) {
  auto& first = k_.faces_.edit(f.index()).first_loop;
  k_.loops_.edit(l.index()).face = f.value;
  k_.loops_.edit(l.index()).next = no_row;
  if (first == no_row) {
    first = l.value;
    k_.loops_.edit(l.index()).prev = l.value;
    return;
  }
  const std::uint32_t last = k_.loops_[first].prev;
  k_.loops_.edit(l.index()).prev = last;
  k_.loops_.edit(last).next = l.value;
  k_.loops_.edit(first).prev = l.value;
}

void Editor::remove_loop(LoopId l) {
  const auto record = k_.loops_[l.index()];
  auto& first = k_.faces_.edit(record.face).first_loop;
  if (record.next != no_row) k_.loops_.edit(record.next).prev = record.prev;
  if (first == l.value) {
    first = record.next;
  } else {
    k_.loops_.edit(record.prev).next = record.next;
    if (record.next == no_row) k_.loops_.edit(first).prev = record.prev;
  }
}

void Editor::set_vertex_loop(LoopId l, VertexId v) {
  k_.loops_.edit(l.index()).first = v.value | Complex::tag;
  const std::uint32_t use = allocate(k_.point_uses_, Complex::point_rows, no_row, point_links);
  auto& owner = k_.vertices_.edit(v.index()).owner;
  k_.point_uses_.edit(use).loop = l.value;
  k_.point_uses_.edit(use).next = owner;
  owner = use;
}

void Editor::unset_vertex_loop(LoopId l) {
  const VertexId v = k_.loop_vertex(l);
  std::uint32_t use = k_.vertices_[v.index()].owner, before = no_row;
  while (k_.point_uses_[use].loop != l.value) {
    before = use;
    use = k_.point_uses_[use].next;
  }
  const std::uint32_t next = k_.point_uses_[use].next;
  if (before == no_row) {
    k_.vertices_.edit(v.index()).owner = next;
  } else {
    k_.point_uses_.edit(before).next = next;
  }
  release(k_.point_uses_, Complex::point_rows, use, point_links);
  k_.loops_.edit(l.index()).first = no_row;
}

void Editor::link(CoedgeId c, CoedgeId next) {
  k_.coedges_.edit(c.index()).next = next.value;
  k_.coedges_.edit(next.index()).prev = c.value;
}

void Editor::insert_coedge(CoedgeId c, CoedgeId prev, LoopId l) {
  set_loop(c, l);
  if (!prev.valid()) {
    set_first(l, c);
    link(c, c);
    return;
  }
  const CoedgeId next = k_.next(prev);
  link(prev, c);
  link(c, next);
}

void Editor::remove_coedge(CoedgeId c) {
  const CoedgeId next = k_.next(c), prev = k_.prev(c);
  const LoopId l = k_.loop(c);
  link(prev, next);
  if (k_.first_coedge(l) == c) k_.loops_.edit(l.index()).first = next == c ? no_row : next.value;
}

// --- radial cycles

void Editor::set_edge(CoedgeId c, EdgeId e, bool reversed) {
  k_.coedges_.edit(c.index()).edge_sense = 2 * e.value + (reversed ? 1u : 0u);
}

void Editor::insert_radially(CoedgeId c, CoedgeId after) {
  if (!after.valid()) {
    k_.coedges_.edit(c.index()).radial = c.value;
    k_.edges_.edit(k_.edge(c).index()).first_use = c.value;
    return;
  }
  k_.coedges_.edit(c.index()).radial = k_.radial(after).value;
  k_.coedges_.edit(after.index()).radial = c.value;
}

void Editor::remove_radially(CoedgeId c) {
  const EdgeId e = k_.edge(c);
  const CoedgeId next = k_.radial(c);
  if (next == c) {
    k_.edges_.edit(e.index()).first_use = no_row;
    return;
  }
  k_.coedges_.edit(k_.radial_prev(c).index()).radial = next.value;
  if (k_.first_coedge(e) == c) k_.edges_.edit(e.index()).first_use = next.value;
}

// --- items of shells

void Editor::put(Item item, ShellId s) {
  switch (item.kind) {
    case Item::Kind::side: {
      const std::uint32_t face = item.index / 2, side = item.index % 2;
      auto& first = k_.shells_.edit(s.index()).first_face_use;
      auto& record = k_.faces_.edit(face);
      record.shell[side] = s.value;
      record.next_in_shell[side] = no_row;
      if (first == no_row) {
        first = record.prev_in_shell[side] = item.index;
        return;
      }
      auto& last = k_.faces_.edit(first / 2).prev_in_shell[first % 2];
      record.prev_in_shell[side] = last;
      k_.faces_.edit(last / 2).next_in_shell[last % 2] = item.index;
      k_.faces_.edit(first / 2).prev_in_shell[first % 2] = item.index;
      return;
    }
    case Item::Kind::wire: {
      const std::uint32_t wire = allocate(k_.wires_, Complex::wire_rows, no_row, wire_links);
      k_.edges_.edit(item.index).first_use = wire | Complex::tag;
      auto& first = k_.shells_.edit(s.index()).first_wire;
      k_.wires_.edit(wire) = {item.index, s.value, no_row, wire};
      if (first == no_row) {
        first = wire;
        return;
      }
      const std::uint32_t last = k_.wires_[first].prev;
      k_.wires_.edit(wire).prev = last;
      k_.wires_.edit(last).next = wire;
      k_.wires_.edit(first).prev = wire;
      return;
    }
    case Item::Kind::point:
      k_.shells_.edit(s.index()).vertex = item.index;
      k_.vertices_.edit(item.index).owner = s.value | Complex::tag;
      return;
  }
}

void Editor::take(Item item) {
  const ShellId s = shell_of(k_, item);
  switch (item.kind) {
    case Item::Kind::side: {
      const std::uint32_t face = item.index / 2, side = item.index % 2;
      const std::uint32_t next = k_.faces_[face].next_in_shell[side], prev = k_.faces_[face].prev_in_shell[side];
      auto& first = k_.shells_.edit(s.index()).first_face_use;
      if (next != no_row) k_.faces_.edit(next / 2).prev_in_shell[next % 2] = prev;
      if (first == item.index) {
        first = next;
      } else {
        k_.faces_.edit(prev / 2).next_in_shell[prev % 2] = next;
        if (next == no_row) k_.faces_.edit(first / 2).prev_in_shell[first % 2] = prev;
      }
      k_.faces_.edit(face).shell[side] = no_row;
      return;
    }
    case Item::Kind::wire: {
      const std::uint32_t wire = k_.edges_[item.index].first_use & ~Complex::tag;
      const auto record = k_.wires_[wire];
      auto& first = k_.shells_.edit(s.index()).first_wire;
      if (record.next != no_row) k_.wires_.edit(record.next).prev = record.prev;
      if (first == wire) {
        first = record.next;
      } else {
        k_.wires_.edit(record.prev).next = record.next;
        if (record.next == no_row) k_.wires_.edit(first).prev = record.prev;
      }
      release(k_.wires_, Complex::wire_rows, wire, wire_links);
      k_.edges_.edit(item.index).first_use = no_row;
      return;
    }
    case Item::Kind::point:
      k_.shells_.edit(s.index()).vertex = no_row;
      k_.vertices_.edit(item.index).owner = no_row;
      return;
  }
}

bool Editor::is_empty(ShellId s) const {
  const auto& record = k_.shells_[s.index()];
  return record.first_face_use == no_row && record.first_wire == no_row && record.vertex == no_row;
}

// --- shells

/// Orders two shells so that a is not the larger one; counts both only as far as the smaller goes.
void Editor::smaller_first(ShellId& a, ShellId& b) const {
  const auto next = [this](std::uint32_t use) { return k_.faces_[use / 2].next_in_shell[use % 2]; };
  std::uint32_t x = k_.shells_[a.index()].first_face_use, y = k_.shells_[b.index()].first_face_use;
  while (x != no_row && y != no_row) {
    x = next(x);
    y = next(y);
  }
  if (x == no_row && y == no_row) {
    std::uint32_t p = k_.shells_[a.index()].first_wire, q = k_.shells_[b.index()].first_wire;
    while (p != no_row && q != no_row) {
      p = k_.wires_[p].next;
      q = k_.wires_[q].next;
    }
    if (p != no_row || (q == no_row && a < b)) std::swap(a, b);
  } else if (x != no_row) {
    std::swap(a, b);
  }
}

void Editor::merge_shells(ShellId a, ShellId b) {
  smaller_first(a, b);
  // Read anew each time: a write may have moved the row to a page of its own.
  while (k_.shells_[a.index()].first_face_use != no_row) {
    const Item item = FaceUse::from_index(k_.shells_[a.index()].first_face_use);
    take(item);
    put(item, b);
  }
  while (k_.shells_[a.index()].first_wire != no_row) {
    const Item item = k_.wire_edge(k_.shells_[a.index()].first_wire);
    take(item);
    put(item, b);
  }
  free(a);
}

void Editor::unite_at(VertexId v) {
  // A vertex touches few regions; where it touches many, the search stays linear in the uses.
  std::vector<std::pair<RegionId, ShellId>> seen;
  std::vector<Item> items;
  for_each_item_at(k_, v, [&](Item item) { items.push_back(item); });
  for (const Item item : items) {
    const ShellId s = shell_of(k_, item);
    const RegionId r = k_.region(s);
    const auto at = std::find_if(seen.begin(), seen.end(), [&](const auto& pair) { return pair.first == r; });
    if (at == seen.end()) {
      seen.emplace_back(r, s);
    } else if (at->second != s) {
      merge_shells(at->second, s);
      at->second = shell_of(k_, item);
    }
  }
}

namespace {

using detail::Floods;

constexpr Floods::Node vertex_node = Floods::Node{3} << 32;  // kinds 0 to 2 are items

Floods::Node node_of(Item item) {
  return (Floods::Node{static_cast<unsigned>(item.kind)} << 32) | item.index;
}
Floods::Node node_of(VertexId v) {
  return vertex_node | v.value;
}
Item item_of(Floods::Node node) {
  Item item;
  item.kind = static_cast<Item::Kind>(node >> 32);
  item.index = static_cast<std::uint32_t>(node);
  return item;
}

}  // namespace

void Editor::separate(RegionId r, std::span<const VertexId> seeds) {
  Floods floods;
  for (const VertexId v : seeds) {
    if (k_.is_live(v) && shell_at(k_, v, r).valid()) floods.add_seed(node_of(v));
  }
  floods.run([&](Floods::Node node, auto&& reach) {
    if ((node >> 32) == 3) {
      for_each_item_at(k_, VertexId(static_cast<std::uint32_t>(node)), [&](Item item) {
        if (region_of(k_, item) == r) reach(node_of(item));
      });
    } else {
      for_each_vertex_of(k_, item_of(node), [&](VertexId v) { reach(node_of(v)); });
    }
  });
  // One part keeps the shell that it is labelled with: the unfinished one, else the last.
  std::size_t kept = floods.count();
  for (std::size_t g = 0; g < floods.count(); ++g) {
    if (floods.is_root(g) && (kept == floods.count() || floods.is_complete(kept))) kept = g;
  }
  for (std::size_t g = 0; g < floods.count(); ++g) {
    if (!floods.is_root(g) || g == kept) continue;
    ShellId fresh;
    for (const Floods::Node node : floods.members(g)) {
      if ((node >> 32) == 3) continue;
      const Item item = item_of(node);
      // A part that has a shell of its own already (an isolated vertex) keeps it.
      if (item.kind == Item::Kind::point) continue;
      const ShellId old = shell_of(k_, item);
      if (!fresh.valid()) fresh = make_shell(r);
      take(item);
      put(item, fresh);
      if (is_empty(old)) free(old);
    }
  }
}

void Editor::tidy(ShellId s, std::span<const VertexId> seeds) {
  const RegionId r = k_.region(s);
  if (is_empty(s)) free(s);
  separate(r, seeds);
}

// --- regions

void Editor::move_to_region(std::span<const Item> items, RegionId to) {
  if (items.empty()) return;
  const RegionId from = region_of(k_, items.front());
  std::vector<VertexId> touched;
  std::vector<ShellId> left;
  for (const Item item : items) {
    for_each_vertex_of(k_, item, [&](VertexId v) { touched.push_back(v); });
    left.push_back(shell_of(k_, item));
    take(item);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  std::sort(left.begin(), left.end());
  left.erase(std::unique(left.begin(), left.end()), left.end());

  // Each item in one shell; then what is not connected is told apart.
  const ShellId fresh = make_shell(to);
  for (const Item item : items) {
    if (item.kind == Item::Kind::point) {
      put(item, make_shell(to));
    } else {
      put(item, fresh);
    }
  }
  tidy(fresh, touched);
  for (const ShellId s : left) {
    if (is_empty(s)) free(s);
  }
  // A shell that lost items may fall apart; its parts can be told at the vertices that it shared with them.
  std::vector<std::pair<ShellId, VertexId>> shared;
  for (const VertexId v : touched) {
    if (const ShellId s = shell_at(k_, v, from); s.valid()) shared.emplace_back(s, v);
  }
  std::sort(shared.begin(), shared.end());
  for (std::size_t i = 0; i < shared.size();) {
    std::vector<VertexId> seeds;
    std::size_t j = i;
    for (; j < shared.size() && shared[j].first == shared[i].first; ++j) seeds.push_back(shared[j].second);
    separate(from, seeds);
    i = j;
  }
}

void Editor::merge_regions(RegionId to, RegionId from) {
  std::vector<VertexId> touched;
  for (const ShellId s : k_.shells(from)) {
    for (const FaceUse u : k_.face_uses(s)) for_each_vertex_of(k_, Item(u), [&](VertexId v) { touched.push_back(v); });
    for (const EdgeId e : k_.wires(s)) for_each_vertex_of(k_, Item(e), [&](VertexId v) { touched.push_back(v); });
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  // The list of shells of `from` goes behind that of `to`.
  const std::uint32_t first = k_.regions_[from.index()].first_shell;
  for (std::uint32_t s = first; s != no_row; s = k_.shells_[s].next) k_.shells_.edit(s).region = to.value;
  if (first != no_row) {
    auto& head = k_.regions_.edit(to.index()).first_shell;
    if (head == no_row) {
      head = first;
    } else {
      const std::uint32_t last = k_.shells_[head].prev, new_last = k_.shells_[first].prev;
      k_.shells_.edit(last).next = first;
      k_.shells_.edit(first).prev = last;
      k_.shells_.edit(head).prev = new_last;
    }
    k_.regions_.edit(from.index()).first_shell = no_row;
  }
  free(from);
  for (const VertexId v : touched) unite_at(v);
}

}  // namespace aresta
