// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/enumeration.h"

#include <algorithm>
#include <map>
#include <set>

namespace aresta::grid {

std::vector<Parent> Enumeration::parents(EntityRef entity) const {
  std::vector<Parent> result;
  const Piece p = whole.pieces(entity).front();
  for (std::uint32_t o = 0; o < operands.size(); ++o) {
    const EntityRef carrier = operands[o].complex.carrier(p);
    const bool counts =
        entity.kind == EntityKind::region ? operands[o].filled[carrier.index] : carrier.kind != EntityKind::region;
    if (counts) result.push_back({o, carrier});
  }
  return result;
}

RegionId Enumeration::region_of(std::size_t operand, RegionId cell) const {
  return RegionId(operands[operand].complex.carrier(whole.pieces(cell).front()).index);
}

/// Is a lattice square on a face of some operand, and on no operand's face that bounds a region?
bool Enumeration::is_sheet(Piece square) const {
  const Lattice& g = whole.lattice();
  for (const GridOperand& operand : operands) {
    if (!operand.complex.is_marked(square)) continue;
    for (const bool up : {false, true}) {
      if (operand.filled[operand.complex.carrier(g.next(square, g.axis(square), up)).index]) return false;
    }
  }
  return true;
}

Enumeration enumerate(const Recipe& recipe) {
  const auto lattice = std::make_shared<const Lattice>(recipe.steps);
  Enumeration result(lattice);
  result.turn = recipe.turn;
  for (const OperandRecipe& operand : recipe.operands) {
    result.operands.push_back(lay_out(operand, lattice));
    result.whole.mark_all(result.operands.back().complex);
  }
  GridComplex& whole = result.whole;
  whole.complete();
  result.filled.assign(whole.count(EntityKind::region), false);
  for (std::size_t c = 1; c < result.filled.size(); ++c) {
    for (std::size_t o = 0; o < result.operands.size(); ++o) {
      if (result.operands[o].filled[result.region_of(o, RegionId(c)).index()]) result.filled[c] = true;
    }
  }
  for (std::size_t f = 0; f < whole.count(EntityKind::face); ++f) {
    const Piece square = whole.pieces(FaceId(f)).front();
    if (!result.is_sheet(square)) continue;
    const std::uint32_t below = whole.carrier(lattice->next(square, lattice->axis(square), false)).index;
    const std::uint32_t above = whole.carrier(lattice->next(square, lattice->axis(square), true)).index;
    if (below == above) continue;
    if (below != 0) result.filled[below] = true;
    if (above != 0) result.filled[above] = true;
  }
  return result;
}

std::vector<std::vector<Enumeration::Shell>> Enumeration::shells() const {
  const Lattice& g = whole.lattice();
  // Which regions, faces, wires and points there are around each vertex: what shares one is of one shell.
  struct Member {
    std::uint32_t region;
    ShellPart part;
    constexpr auto operator<=>(const Member&) const = default;
  };
  std::map<Member, std::set<std::uint32_t>> vertices;
  for (Piece p = 0; p < g.size(); ++p) {
    const EntityRef entity = whole.carrier(p);
    if (static_cast<int>(entity.kind) != g.dimension(p) || entity.kind == EntityKind::region) continue;
    if (entity.kind == EntityKind::face) {
      std::set<std::uint32_t> corners;
      const int a = (g.axis(p) + 1) % 3, b = (g.axis(p) + 2) % 3;
      for (const bool up_a : {false, true}) {
        for (const bool up_b : {false, true}) {
          const EntityRef corner = whole.carrier(g.next(g.next(p, a, up_a), b, up_b));
          if (corner.kind == EntityKind::vertex) corners.insert(corner.index);
        }
      }
      for (const bool up : {false, true}) {
        const std::uint32_t region = whole.carrier(g.next(p, g.axis(p), up)).index;
        vertices[{region, {entity, up}}].insert(corners.begin(), corners.end());
      }
    } else if (entity.kind == EntityKind::edge && whole.is_wire(EdgeId(entity.index))) {
      const Piece beside = g.next(p, (g.axis(p) + 1) % 3, true);
      const auto ends = whole.ends(EdgeId(entity.index));
      vertices[{whole.carrier(beside).index, {entity, false}}].insert(ends.begin(), ends.end());
    } else if (entity.kind == EntityKind::vertex) {
      const VertexId v(entity.index);
      if (whole.is_without_edges(v) && !whole.face_around(v).valid())
        vertices[{whole.carrier(g.next(p, 0, true)).index, {entity, false}}].insert(entity.index);
    }
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<const Member*>> at_vertex;  // by region and vertex
  for (const auto& [member, touched] : vertices) {
    for (const std::uint32_t v : touched) at_vertex[{member.region, v}].push_back(&member);
  }
  std::vector<std::vector<Shell>> result(whole.count(EntityKind::region));
  std::set<const Member*> seen;
  for (const auto& [first, unused] : vertices) {
    if (!seen.insert(&first).second) continue;
    Shell shell;
    std::vector<const Member*> pending{&first};
    while (!pending.empty()) {
      const Member* member = pending.back();
      pending.pop_back();
      shell.push_back(member->part);
      for (const std::uint32_t v : vertices.at(*member)) {
        for (const Member* other : at_vertex.at({member->region, v})) {
          if (seen.insert(other).second) pending.push_back(other);
        }
      }
    }
    std::sort(shell.begin(), shell.end());
    result[first.region].push_back(std::move(shell));
  }
  for (auto& list : result) std::sort(list.begin(), list.end());
  return result;
}

}  // namespace aresta::grid
