// SPDX-License-Identifier: Apache-2.0
#include "topology/complex.h"

namespace aresta {

Complex::Complex() {
  regions_.push_back({});
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
  if (owner == none || (owner & vertex_tag) != 0) return result;
  for (std::uint32_t use = owner; use != none; use = point_uses_[use].next)
    result.push_back(LoopId(point_uses_[use].loop));
  return result;
}

ShellId Complex::isolated_in_shell(VertexId v) const {
  const std::uint32_t owner = vertices_[v.index()].owner;
  return owner == none || (owner & vertex_tag) == 0 ? ShellId() : ShellId(owner & ~vertex_tag);
}

std::size_t Complex::allocated_bytes() const {
  return vertices_.allocated_bytes() + edges_.allocated_bytes() + coedges_.allocated_bytes() +
         loops_.allocated_bytes() + point_uses_.allocated_bytes() + faces_.allocated_bytes() +
         shells_.allocated_bytes() + regions_.allocated_bytes();
}

}  // namespace aresta
