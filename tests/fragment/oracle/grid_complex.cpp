// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/grid_complex.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace aresta::grid {

void GridComplex::mark_all(const GridComplex& other) {
  for (Piece p = 0; p < lattice_->size(); ++p) {
    if (other.marked_[p]) marked_[p] = true;
  }
}

bool GridComplex::has_marked_square_across(Piece point, int axis) const {
  const Lattice& g = *lattice_;
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  for (const bool up_a : {false, true}) {
    for (const bool up_b : {false, true}) {
      if (marked_[g.next(g.next(point, a, up_a), b, up_b)]) return true;
    }
  }
  return false;
}

void GridComplex::complete() {
  const Lattice& g = *lattice_;
  for (Piece p = 0; p < g.size(); ++p) {
    if (g.dimension(p) != 1) continue;
    std::array<bool, 4> square{};
    int squares = 0;
    for (int q = 0; q < 4; ++q) {
      const Direction d = around(g.axis(p), q);
      if (g.raw(p, d.axis) % 2 == 0) continue;
      square[static_cast<std::size_t>(q)] = marked_[g.next(p, d.axis, d.up)];
      squares += square[static_cast<std::size_t>(q)] ? 1 : 0;
    }
    const bool plain = squares == 0 || (squares == 2 && square[0] == square[2]);
    if (!plain) marked_[p] = true;
  }
  for (Piece p = 0; p < g.size(); ++p) {
    if (g.dimension(p) != 0) continue;
    int edges = 0, lines = 0, line = 0;
    for (int a = 0; a < 3; ++a) {
      const int here = (marked_[g.next(p, a, false)] ? 1 : 0) + (marked_[g.next(p, a, true)] ? 1 : 0);
      edges += here;
      if (here == 2) ++lines, line = a;
    }
    const bool plain = edges == 0 || (edges == 2 && lines == 1 && !has_marked_square_across(p, line));
    if (!plain) marked_[p] = true;
  }
  find_carriers();
}

void GridComplex::find_carriers() {
  const Lattice& g = *lattice_;
  // The dimension of the carrier: the least one among the marked pieces that this one is on the boundary of, or is.
  std::vector<std::uint8_t> rank(g.size(), 3);
  for (int dimension = 3; dimension >= 0; --dimension) {
    for (Piece p = 0; p < g.size(); ++p) {
      if (g.dimension(p) != dimension) continue;
      if (marked_[p]) {
        rank[p] = static_cast<std::uint8_t>(dimension);
        continue;
      }
      for (int a = 0; a < 3; ++a) {
        if (g.spans(p, a)) continue;
        for (const bool up : {false, true}) rank[p] = std::min(rank[p], rank[g.next(p, a, up)]);
      }
    }
  }
  constexpr std::uint32_t unknown = EntityRef().index;
  std::fill(carrier_.begin(), carrier_.end(), EntityRef());
  for (auto& list : pieces_) list.clear();
  std::vector<Piece> pending;
  for (Piece seed = 0; seed < g.size(); ++seed) {
    if (carrier_[seed].index != unknown) continue;
    const std::size_t kind = rank[seed];
    const EntityRef entity(static_cast<EntityKind>(kind), static_cast<std::uint32_t>(pieces_[kind].size()));
    auto& pieces = pieces_[kind].emplace_back();
    carrier_[seed] = entity;
    pending.push_back(seed);
    while (!pending.empty()) {
      const Piece p = pending.back();
      pending.pop_back();
      if (g.dimension(p) == static_cast<int>(kind)) pieces.push_back(p);
      for (int a = 0; a < 3; ++a) {
        for (const bool up : {false, true}) {
          const int c = g.raw(p, a);
          if (up ? c == 2 * g.steps() + 2 : c == 0) continue;
          const Piece q = g.next(p, a, up);
          if (rank[q] != kind || carrier_[q].index != unknown) continue;
          carrier_[q] = entity;
          pending.push_back(q);
        }
      }
    }
    std::sort(pieces.begin(), pieces.end());
  }
}

std::array<std::uint32_t, 2> GridComplex::ends(EdgeId e) const {
  const auto& pieces = this->pieces(e);
  const int a = lattice_->axis(pieces.front());
  return {carrier_[lattice_->next(pieces.front(), a, false)].index,
          carrier_[lattice_->next(pieces.back(), a, true)].index};
}

bool GridComplex::is_wire(EdgeId e) const {
  const Piece p = pieces(e).front();
  for (int q = 0; q < 4; ++q) {
    const Direction d = around(lattice_->axis(p), q);
    if (marked_[lattice_->next(p, d.axis, d.up)]) return false;
  }
  return true;
}

bool GridComplex::is_without_edges(VertexId v) const {
  const Piece p = pieces(v).front();
  for (int a = 0; a < 3; ++a) {
    if (marked_[lattice_->next(p, a, false)] || marked_[lattice_->next(p, a, true)]) return false;
  }
  return true;
}

FaceId GridComplex::face_around(VertexId v) const {
  const Lattice& g = *lattice_;
  const Piece p = pieces(v).front();
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    if (marked_[g.next(p, b, false)] || marked_[g.next(p, b, true)]) continue;
    if (marked_[g.next(p, c, false)] || marked_[g.next(p, c, true)]) continue;
    const Piece square = g.next(g.next(p, b, true), c, true);
    if (marked_[square]) return FaceId(carrier_[square].index);
  }
  return {};
}

std::vector<GridLoop> GridComplex::loops(FaceId f) const {
  const Lattice& g = *lattice_;
  const int axis = this->axis(f);
  const std::size_t u = static_cast<std::size_t>((axis + 1) % 3), v = static_cast<std::size_t>((axis + 2) % 3);
  // A pass with the face to the left goes a quarter turn ahead of the direction from the square to the edge.
  std::set<Pass> to_do;
  for (const Piece square : pieces(f)) {
    for (int q = 0; q < 4; ++q) {
      const Direction d = around(axis, q);
      const Piece edge = g.next(square, d.axis, d.up);
      if (marked_[edge]) to_do.insert({edge, around(axis, q + 1).up});
    }
  }
  std::vector<GridLoop> result;
  while (!to_do.empty()) {
    GridLoop& loop = result.emplace_back();
    const Pass first = *to_do.begin();
    Pass pass = first;
    do {
      [[maybe_unused]] const std::size_t erased = to_do.erase(pass);
      assert(erased == 1);
      loop.passes.push_back(pass);
      const int along = g.axis(pass.piece);
      const Piece corner = g.next(pass.piece, along, pass.up);
      const Steps from = g.low(g.next(pass.piece, along, !pass.up)), to = g.low(corner);
      loop.area += from[u] * to[v] - from[v] * to[u];
      const int arrived = (along == static_cast<int>(u) ? 0 : 1) + (pass.up ? 0 : 2);
      for (int turn = 1; turn <= 4; ++turn) {
        const Direction out = around(axis, arrived + 2 - turn + 4);
        const Piece edge = g.next(corner, out.axis, out.up);
        if (!marked_[edge]) continue;
        pass = {edge, out.up};
        break;
      }
    } while (pass != first);
  }
  std::stable_sort(result.begin(), result.end(), [](const GridLoop& a, const GridLoop& b) { return a.area > b.area; });
  std::set<Piece> points;
  for (const Piece square : pieces(f)) {
    const Piece point = g.next(g.next(square, static_cast<int>(u), true), static_cast<int>(v), true);
    if (marked_[point] && carrier_[point].kind == EntityKind::vertex &&
        face_around(VertexId(carrier_[point].index)) == f)
      points.insert(point);
  }
  for (const Piece point : points) result.push_back({{}, point, 0});
  return result;
}

}  // namespace aresta::grid
