// SPDX-License-Identifier: Apache-2.0
#include "topology/betti.h"

#include "topology/fans.h"
#include "topology/item.h"

namespace aresta {

ComplexCounts counts(const Complex& k) {
  ComplexCounts n;
  n.vertices = k.vertex_count();
  n.edges = k.edge_count();
  n.faces = k.face_count();
  n.loops = k.loop_count();
  n.shells = k.shell_count();
  n.regions = k.region_count();
  for (const RegionId r : k.regions()) n.filled_regions += k.is_filled(r) ? 1 : 0;
  UnionFind connected = components(k);
  for (const VertexId v : k.vertices()) {
    n.isolated_vertices += k.isolated_in_shell(v).valid() ? 1 : 0;
    n.components += connected.find(v.index()) == v.index() ? 1 : 0;
  }
  for (const EdgeId e : k.edges()) {
    switch (k.use_kind(e)) {
      case EdgeUseKind::wire:
        ++n.wires;
        break;
      case EdgeUseKind::lamina:
        ++n.laminas;
        break;
      case EdgeUseKind::manifold:
        ++n.manifold_edges;
        break;
      case EdgeUseKind::non_manifold:
        ++n.non_manifold_edges;
        break;
    }
  }
  n.voids = n.regions - 1;
  n.tunnels = static_cast<std::size_t>(static_cast<long>(n.components + n.voids) - n.euler_characteristic());
  return n;
}

std::vector<SideSurface> side_surfaces_of(const Complex& k) {
  UnionFind sides = side_surfaces(k);
  std::vector<std::size_t> place(2 * k.face_bound());
  std::vector<SideSurface> surfaces;
  for (const FaceId f : k.faces()) {
    for (const FaceUse u : {FaceUse(f, 0), FaceUse(f, 1)}) {
      const std::size_t root = sides.find(u.index());
      if (root == u.index()) {
        place[root] = surfaces.size();
        surfaces.push_back({u, k.shell(u)});
      }
      SideSurface& surface = surfaces[place[root]];
      ++surface.sides;
      for (const LoopId l : k.loops(f)) {
        ++surface.loops;
        surface.corners += k.is_vertex_loop(l) ? 1 : 0;
      }
    }
  }
  const auto surface_of = [&](FaceUse u) -> SideSurface& { return surfaces[place[sides.find(u.index())]]; };
  UnionFind corners = fans(k);
  for (const CoedgeId c : k.coedges()) {
    ++surface_of(k.side_after(c)).sectors;
    for (const FaceUse u : {FaceUse(k.face(c), 0), FaceUse(k.face(c), 1)}) {
      const std::size_t corner = 2 * c.index() + static_cast<std::size_t>(u.side());
      surface_of(u).corners += corners.find(corner) == corner ? 1 : 0;
    }
  }
  return surfaces;
}

std::vector<EulerPoincare> euler_poincare(const Complex& k) {
  // Cells that touch a region, each once; and how often they do, counted on the surfaces of sides. The boundary is
  // manifold where these are equal.
  std::vector<EulerPoincare> terms(k.region_bound());
  for (const RegionId r : k.regions()) terms[r.index()].region = r;
  const auto term = [&](RegionId r) -> EulerPoincare& { return terms[r.index()]; };
  std::vector<bool> has_others(k.region_bound(), false);
  std::vector<VertexId> vertex_seen(k.region_bound());
  for (const VertexId v : k.vertices()) {
    for_each_item_at(k, v, [&](Item item) {
      const RegionId r = region_of(k, item);
      if (item.kind != Item::Kind::side) has_others[r.index()] = true;
      if (vertex_seen[r.index()] != v) ++term(r).vertices;
      vertex_seen[r.index()] = v;
    });
  }
  std::vector<EdgeId> edge_seen(k.region_bound());
  for (const EdgeId e : k.edges()) {
    for (const CoedgeId c : k.coedges(e)) {
      const RegionId r = k.region(k.side_after(c));
      if (edge_seen[r.index()] != e) ++term(r).edges;
      edge_seen[r.index()] = e;
    }
  }
  for (const FaceId f : k.faces()) {
    const auto loops = static_cast<long>(k.loops(f).count());
    for (int side = 0; side < (k.has_same_region_on_both_sides(f) ? 1 : 2); ++side) {
      ++term(k.region(FaceUse(f, side))).faces;
      term(k.region(FaceUse(f, side))).loops += loops;
    }
  }
  for (const ShellId s : k.shells()) ++term(k.region(s)).shells;

  std::vector<SideSurface> times(k.region_bound());
  for (const SideSurface& surface : side_surfaces_of(k)) {
    const RegionId r = k.region(surface.shell);
    times[r.index()].sides += surface.sides;
    times[r.index()].sectors += surface.sectors;
    times[r.index()].corners += surface.corners;
    term(r).genus += static_cast<long>(surface.genus());
  }
  std::erase_if(terms, [&](const EulerPoincare& x) {
    if (!x.region.valid() || x.shells == 0 || has_others[x.region.index()]) return true;
    const SideSurface& uses = times[x.region.index()];
    return static_cast<long>(uses.sides) != x.faces || static_cast<long>(uses.sectors) != x.edges ||
           static_cast<long>(uses.corners) != x.vertices;
  });
  return terms;
}

}  // namespace aresta
