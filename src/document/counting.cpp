// SPDX-License-Identifier: Apache-2.0
// Euler-Poincare on the boundary as seen from one side. The elements are darts: a coedge seen from one side of its
// face. Two darts are mates when they meet across a sector of space at their edge. Then per closed surface
//   vertices (fans of darts) - edges (pairs of mates) + faces (sides) - (loops - sides) = 2 - 2 genus.
// Weiler 1986 for the uses; loops that are single vertices count one vertex and no edge.
#include "document/counting.h"

#include <map>
#include <set>

#include "base/union_find.h"

namespace aresta::document {

namespace {

/// The coedge before c in the radial cycle of its edge.
CoedgeId radial_before(const Complex& k, CoedgeId c) {
  CoedgeId p = c;
  while (k.radial(p) != c) p = k.radial(p);
  return p;
}

class BoundarySurface {
 public:
  explicit BoundarySurface(const Complex& k) : k_(k), ends_(4 * k.coedge_count()), sides_(2 * k.face_count()) {}

  void add(FaceUse use) {
    if (!added_.insert(use).second) return;
    for (const LoopId l : k_.loops(use.face())) {
      ++loops_[use.index()];
      if (k_.is_vertex_loop(l)) {
        ++lone_vertices_[use.index()];
        continue;
      }
      for (const CoedgeId c : k_.coedges(l)) add_dart(c, use);
    }
  }

  std::int64_t genus() {
    std::map<std::uint32_t, std::int64_t> characteristic;  // per surface, V - E + 2F - L
    for (const FaceUse u : added_) {
      auto& x = characteristic[sides_.find(u.index())];
      x += 2 - loops_[u.index()] + lone_vertices_[u.index()];
    }
    std::set<std::uint32_t> vertices;
    for (const FaceUse u : added_) {
      for (const LoopId l : k_.loops(u.face())) {
        if (k_.is_vertex_loop(l)) continue;
        for (const CoedgeId c : k_.coedges(l)) {
          const std::uint32_t surface = sides_.find(u.index());
          darts_[surface] += 1;
          for (std::uint32_t end = 0; end < 2; ++end) {
            if (vertices.insert(ends_.find(end_index(c, u.side(), end))).second) ++characteristic[surface];
          }
        }
      }
    }
    std::int64_t sum = 0;
    for (const auto& [surface, x] : characteristic) sum += (2 - (x - darts_[surface] / 2)) / 2;
    return sum;
  }

 private:
  static std::size_t end_index(CoedgeId c, int side, std::uint32_t end) {
    return (2 * c.index() + static_cast<std::size_t>(side)) * 2 + end;
  }

  void add_dart(CoedgeId c, FaceUse use) {
    // Along the loop: where this coedge ends the next one starts. Ends are those of the edge.
    const CoedgeId n = k_.next(c);
    ends_.unite(end_index(c, use.side(), k_.reversed(c) ? 0 : 1), end_index(n, use.side(), k_.reversed(n) ? 1 : 0));
    // Across the sector.
    const bool after = k_.side_after(c) == use;
    const CoedgeId mate = after ? k_.radial(c) : radial_before(k_, c);
    const FaceUse mate_use = after ? k_.side_before(mate) : k_.side_after(mate);
    for (std::uint32_t end = 0; end < 2; ++end)
      ends_.unite(end_index(c, use.side(), end), end_index(mate, mate_use.side(), end));
    sides_.unite(use.index(), mate_use.index());
  }

  const Complex& k_;
  UnionFind ends_, sides_;
  std::set<FaceUse> added_;
  std::map<std::size_t, std::int64_t> loops_, lone_vertices_;
  std::map<std::uint32_t, std::int64_t> darts_;
};

}  // namespace

namespace {

/// Sets over all entities of a model, united along the boundaries of what a part holds.
class Connections {
 public:
  explicit Connections(const Part& part) : members_(closure(part)), k_(part.model->topology()), sets_(size(k_)) {
    for (const EntityRef e : members_[1]) {
      unite(e, k_.start(EdgeId(e.index)));
      unite(e, k_.end(EdgeId(e.index)));
    }
    for (const EntityRef f : members_[2]) {
      for (const LoopId l : k_.loops(FaceId(f.index))) {
        if (k_.is_vertex_loop(l)) {
          unite(f, k_.loop_vertex(l));
        } else {
          for (const CoedgeId c : k_.coedges(l)) unite(f, k_.edge(c));
        }
      }
    }
    for (const EntityRef r : members_[3]) {
      for (const ShellId s : k_.shells(RegionId(r.index))) {
        for (const FaceUse u : k_.face_uses(s)) unite(r, u.face());
        for (const EdgeId e : k_.wires(s)) unite(r, e);
        if (k_.shell_vertex(s).valid()) unite(r, k_.shell_vertex(s));
      }
    }
  }

  const std::array<std::vector<EntityRef>, 4>& members() const { return members_; }
  std::uint32_t set_of(EntityRef e) { return sets_.find(index(e)); }

 private:
  static std::size_t size(const Complex& k) {
    return k.vertex_count() + k.edge_count() + k.face_count() + k.region_count();
  }
  std::size_t index(EntityRef e) const {
    std::size_t i = e.index;
    if (e.kind > EntityKind::vertex) i += k_.vertex_count();
    if (e.kind > EntityKind::edge) i += k_.edge_count();
    if (e.kind > EntityKind::face) i += k_.face_count();
    return i;
  }
  void unite(EntityRef a, EntityRef b) { sets_.unite(index(a), index(b)); }

  std::array<std::vector<EntityRef>, 4> members_;
  const Complex& k_;
  UnionFind sets_;
};

}  // namespace

std::size_t component_count(const Part& part) {
  Connections connections(part);
  std::set<std::uint32_t> roots;
  for (const auto& of_kind : connections.members()) {
    for (const EntityRef e : of_kind) roots.insert(connections.set_of(e));
  }
  return roots.size();
}

std::vector<std::vector<EntityRef>> components(const Part& part) {
  Connections connections(part);
  std::map<std::uint32_t, std::size_t> number;
  std::vector<std::vector<EntityRef>> out;
  for (const EntityRef e : part.entities) {
    const auto [found, is_new] = number.emplace(connections.set_of(e), out.size());
    if (is_new) out.emplace_back();
    out[found->second].push_back(e);
  }
  return out;
}

std::size_t shell_count(const Part& part) {
  const Complex& k = part.model->topology();
  std::size_t n = 0;
  for (const EntityRef r : closure(part, EntityKind::region)) {
    for ([[maybe_unused]] const ShellId s : k.shells(RegionId(r.index))) ++n;
  }
  return n;
}

std::int64_t genus(const Part& part) {
  const Complex& k = part.model->topology();
  const auto members = closure(part);
  BoundarySurface surface(k);
  if (!members[3].empty()) {
    for (const EntityRef r : members[3]) {
      for (const ShellId s : k.shells(RegionId(r.index))) {
        for (const FaceUse u : k.face_uses(s)) surface.add(u);
      }
    }
  } else {
    for (const EntityRef f : members[2]) {
      for (int side = 0; side < 2; ++side) {
        const RegionId r = k.region(FaceUse(FaceId(f.index), side));
        if (r == Complex::infinite_region()) continue;
        for (const ShellId s : k.shells(r)) {
          for (const FaceUse u : k.face_uses(s)) surface.add(u);
        }
      }
    }
  }
  return surface.genus();
}

}  // namespace aresta::document
