// SPDX-License-Identifier: Apache-2.0
#include "topology/compaction.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = 0xffffffffu, tag = 0x80000000u;

using Renumbering = std::vector<std::uint32_t>;

/// `none` stays.
std::uint32_t renamed(const Renumbering& to, std::uint32_t old) {
  return old == none ? none : to[old];
}
std::uint32_t renamed_tagged(const Renumbering& to, std::uint32_t code) {
  return to[code & ~tag] | tag;
}
/// A row and one bit: an edge end, a side.
std::uint32_t renamed_half(const Renumbering& to, std::uint32_t code) {
  return code == none ? none : (to[code >> 1] << 1 | (code & 1u));
}

template <class Rows, class IsLive>
Renumbering number(const Rows& rows, IsLive&& is_live) {
  Renumbering to(rows.size(), none);
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_live(rows[i])) to[i] = count++;
  }
  return to;
}

/// The rows that stay, each changed by `rename`.
template <class Rows, class Rename>
void rebuild(Rows& rows, const Renumbering& to, Rename&& rename) {
  Rows fresh;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (to[i] == none) continue;
    auto record = rows[i];
    rename(record);
    fresh.push_back(record);
  }
  rows = std::move(fresh);
}

template <class IdType>
std::vector<IdType> ids(const Renumbering& to) {
  std::vector<IdType> result(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) result[i].value = to[i];
  return result;
}

template <class IdType>
std::uint32_t find(const std::vector<IdType>& to, std::uint32_t old) {
  return old < to.size() ? to[old].value : none;
}

}  // namespace

EntityRef Compaction::operator()(EntityRef old) const {
  switch (old.kind) {
    case EntityKind::vertex:
      return {old.kind, find(vertices, old.index)};
    case EntityKind::edge:
      return {old.kind, find(edges, old.index)};
    case EntityKind::face:
      return {old.kind, find(faces, old.index)};
    case EntityKind::region:
      break;
  }
  return {old.kind, find(regions, old.index)};
}

Compaction compact(Complex& k) {
  const Renumbering vertices = number(k.vertices_, [](const auto& r) { return r.first_end != Complex::dead; });
  const Renumbering edges = number(k.edges_, [](const auto& r) { return r.vertex[0] != Complex::dead; });
  const Renumbering wires = number(k.wires_, [](const auto& r) { return r.edge != Complex::dead; });
  const Renumbering coedges = number(k.coedges_, [](const auto& r) { return r.loop != Complex::dead; });
  const Renumbering points = number(k.point_uses_, [](const auto& r) { return r.loop != Complex::dead; });
  const Renumbering loops = number(k.loops_, [](const auto& r) { return r.face != Complex::dead; });
  const Renumbering faces = number(k.faces_, [](const auto& r) { return r.first_loop != Complex::dead; });
  const Renumbering shells = number(k.shells_, [](const auto& r) { return r.region != Complex::dead; });
  const Renumbering regions = number(k.regions_, [](const auto& r) { return r.filled != Complex::dead; });
  Compaction result{ids<VertexId>(vertices), ids<EdgeId>(edges),   ids<CoedgeId>(coedges), ids<LoopId>(loops),
                    ids<FaceId>(faces),      ids<ShellId>(shells), ids<RegionId>(regions)};
  if (k.is_compact()) return result;

  rebuild(k.vertices_, vertices, [&](auto& r) {
    r.first_end = renamed_half(edges, r.first_end);
    if (r.owner != none) r.owner = (r.owner & tag) != 0 ? renamed_tagged(shells, r.owner) : points[r.owner];
  });
  rebuild(k.edges_, edges, [&](auto& r) {
    for (int end = 0; end < 2; ++end) {
      r.vertex[end] = vertices[r.vertex[end]];
      r.next[end] = renamed_half(edges, r.next[end]);
      r.prev[end] = renamed_half(edges, r.prev[end]);
    }
    r.first_use = (r.first_use & tag) != 0 ? renamed_tagged(wires, r.first_use) : coedges[r.first_use];
  });
  rebuild(k.wires_, wires, [&](auto& r) {
    r.edge = edges[r.edge];
    r.shell = shells[r.shell];
    r.next = renamed(wires, r.next);
    r.prev = renamed(wires, r.prev);
  });
  rebuild(k.coedges_, coedges, [&](auto& r) {
    r.next = coedges[r.next];
    r.prev = coedges[r.prev];
    r.radial = coedges[r.radial];
    r.edge_sense = renamed_half(edges, r.edge_sense);
    r.loop = loops[r.loop];
  });
  rebuild(k.point_uses_, points, [&](auto& r) {
    r.loop = loops[r.loop];
    r.next = renamed(points, r.next);
  });
  rebuild(k.loops_, loops, [&](auto& r) {
    r.first = (r.first & tag) != 0 ? renamed_tagged(vertices, r.first) : coedges[r.first];
    r.next = renamed(loops, r.next);
    r.prev = renamed(loops, r.prev);
    r.face = faces[r.face];
  });
  rebuild(k.faces_, faces, [&](auto& r) {
    r.first_loop = loops[r.first_loop];
    for (int side = 0; side < 2; ++side) {
      r.shell[side] = shells[r.shell[side]];
      r.next_in_shell[side] = renamed_half(faces, r.next_in_shell[side]);
      r.prev_in_shell[side] = renamed_half(faces, r.prev_in_shell[side]);
    }
  });
  rebuild(k.shells_, shells, [&](auto& r) {
    r.region = regions[r.region];
    r.next = renamed(shells, r.next);
    r.prev = renamed(shells, r.prev);
    r.first_face_use = renamed_half(faces, r.first_face_use);
    r.first_wire = renamed(wires, r.first_wire);
    r.vertex = renamed(vertices, r.vertex);
  });
  rebuild(k.regions_, regions, [&](auto& r) { r.first_shell = renamed(shells, r.first_shell); });
  k.free_ = {};
  return result;
}

}  // namespace aresta
