// SPDX-License-Identifier: Apache-2.0
// The coarsest cell complex on a lattice in which given squares, edges and points are kept.
//
// Contract. Marks say which lattice squares, edges and points must lie in faces, edges and vertices. `complete` adds
// what follows: a lattice edge is part of an edge unless it has no marked square or just two in one plane; a lattice
// point is a vertex where marked edges meet that are not two of one line, or where a line meets marked squares across
// it. Every piece then has a carrier, the entity in whose relative interior it lies, and entities are the connected
// sets of pieces that no entity of less dimension separates: region 0 is what is outside. Integers only; flood fill,
// linear in the lattice. Shares nothing with the modeler but the names of entities.
#pragma once

#include <memory>

#include "base/ids.h"
#include "fragment/oracle/lattice.h"

namespace aresta::grid {

/// A lattice edge passed in one direction; `up` is that of its axis.
struct Pass {
  Piece piece = 0;
  bool up = true;
  constexpr auto operator<=>(const Pass&) const = default;
  Pass reversed() const { return {piece, !up}; }
};

/// A loop of a face, seen against the positive direction of the axis across it, the face to the left; or one point.
struct GridLoop {
  std::vector<Pass> passes;
  Piece point = 0;  ///< when there are no passes
  int area = 0;     ///< twice the signed area; positive for the outer loop
};

class GridComplex {
 public:
  explicit GridComplex(std::shared_ptr<const Lattice> lattice)
      : lattice_(std::move(lattice)), marked_(lattice_->size(), false), carrier_(lattice_->size()) {}

  const Lattice& lattice() const { return *lattice_; }
  std::shared_ptr<const Lattice> shared_lattice() const { return lattice_; }

  void mark(Piece p) { marked_[p] = true; }
  /// All that another complex on the same lattice has.
  void mark_all(const GridComplex& other);
  void complete();

  // After `complete`.
  bool is_marked(Piece p) const { return marked_[p]; }
  EntityRef carrier(Piece p) const { return carrier_[p]; }
  std::size_t count(EntityKind kind) const { return pieces_[static_cast<std::size_t>(kind)].size(); }
  bool is_empty() const { return count(EntityKind::vertex) == 0; }
  /// The pieces of its own dimension, ascending.
  const std::vector<Piece>& pieces(EntityRef entity) const {
    return pieces_[static_cast<std::size_t>(entity.kind)][entity.index];
  }

  int axis(EntityRef edge_or_face) const { return lattice_->axis(pieces(edge_or_face).front()); }
  /// The vertices at the lower and the upper end of an edge.
  std::array<std::uint32_t, 2> ends(EdgeId e) const;
  bool is_wire(EdgeId e) const;
  bool is_without_edges(VertexId v) const;
  /// The face in which a vertex without edges in its plane lies, if any; one at most.
  FaceId face_around(VertexId v) const;

  /// Outer loop first, points last. At each corner the next edge is the first one clockwise from the one that arrives.
  std::vector<GridLoop> loops(FaceId f) const;

 private:
  bool has_marked_square_across(Piece point, int axis) const;
  void find_carriers();

  std::shared_ptr<const Lattice> lattice_;
  std::vector<bool> marked_;
  std::vector<EntityRef> carrier_;
  std::array<std::vector<std::vector<Piece>>, 4> pieces_;  // per dimension and entity
};

/// A direction along an axis.
struct Direction {
  int axis = 0;
  bool up = true;
};

/// The four directions at right angles to an axis, counterclockwise about it.
inline Direction around(int axis, int quarter) {
  const int q = quarter & 3;
  return {(axis + 1 + (q & 1)) % 3, q < 2};
}

}  // namespace aresta::grid
