// SPDX-License-Identifier: Apache-2.0
#include "topology/complex.h"

namespace aresta {

Complex::Complex() {
  regions_.push_back({});
}

bool Complex::is_compact() const {
  for (const FreeRows& rows : free_) {
    if (rows.count != 0) return false;
  }
  return true;
}

bool Complex::is_live(EntityRef entity) const {
  switch (entity.kind) {
    case EntityKind::vertex:
      return is_live(VertexId(entity.index));
    case EntityKind::edge:
      return is_live(EdgeId(entity.index));
    case EntityKind::face:
      return is_live(FaceId(entity.index));
    case EntityKind::region:
      return is_live(RegionId(entity.index));
  }
  return false;
}

EdgeUseKind Complex::use_kind(EdgeId e) const {
  switch (coedges(e).count()) {
    case 0:
      return EdgeUseKind::wire;
    case 1:
      return EdgeUseKind::lamina;
    case 2:
      return EdgeUseKind::manifold;
    default:
      return EdgeUseKind::non_manifold;
  }
}

std::vector<LoopId> Complex::vertex_loops(VertexId v) const {
  std::vector<LoopId> result;
  const std::uint32_t owner = vertices_[v.index()].owner;
  if (owner == none || (owner & tag) != 0) return result;
  for (std::uint32_t use = owner; use != none; use = point_uses_[use].next)
    result.push_back(LoopId(point_uses_[use].loop));
  return result;
}

ShellId Complex::isolated_in_shell(VertexId v) const {
  const std::uint32_t owner = vertices_[v.index()].owner;
  return owner == none || (owner & tag) == 0 ? ShellId() : ShellId(owner & ~tag);
}

std::size_t Complex::allocated_bytes() const {
  return vertices_.allocated_bytes() + edges_.allocated_bytes() + wires_.allocated_bytes() +
         coedges_.allocated_bytes() + loops_.allocated_bytes() + point_uses_.allocated_bytes() +
         faces_.allocated_bytes() + shells_.allocated_bytes() + regions_.allocated_bytes();
}

std::size_t Complex::bytes_not_shared_with(const Complex& earlier) const {
  return vertices_.bytes_not_shared_with(earlier.vertices_) + edges_.bytes_not_shared_with(earlier.edges_) +
         wires_.bytes_not_shared_with(earlier.wires_) + coedges_.bytes_not_shared_with(earlier.coedges_) +
         loops_.bytes_not_shared_with(earlier.loops_) + point_uses_.bytes_not_shared_with(earlier.point_uses_) +
         faces_.bytes_not_shared_with(earlier.faces_) + shells_.bytes_not_shared_with(earlier.shells_) +
         regions_.bytes_not_shared_with(earlier.regions_);
}

}  // namespace aresta
