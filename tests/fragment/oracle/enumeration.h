// SPDX-License-Identifier: Apache-2.0
// What the fragment of operands on a lattice must be, by enumerating the lattice's pieces.
//
// Contract. The result is the coarsest complex that keeps every face, edge and vertex of every operand. Parents: for
// each operand whose vertices, edges or faces contain an entity of the result, the one of least dimension that does;
// for a region of the result the operands' filled regions around it. A finite cell is filled when an operand's region
// contains it, or when on its boundary, with another cell on the other side, is a face that bounds no operand's region.
#pragma once

#include "fragment/oracle/recipe.h"
#include "model/model.h"

namespace aresta::grid {

struct Enumeration {
  Turn turn;
  std::vector<GridOperand> operands;
  GridComplex whole;
  std::vector<bool> filled;  ///< per region of the whole

  std::vector<Parent> parents(EntityRef entity) const;
  /// In which region of an operand a region of the whole lies.
  RegionId region_of(std::size_t operand, RegionId cell) const;

  /// The entities of a shell: faces with the side (1: towards the positive direction of its axis), wires, a vertex.
  struct ShellPart {
    EntityRef entity;
    bool up = false;
    constexpr auto operator<=>(const ShellPart&) const = default;
  };
  using Shell = std::vector<ShellPart>;  ///< sorted
  /// Per region of the whole its shells, sorted.
  std::vector<std::vector<Shell>> shells() const;

 private:
  friend Enumeration enumerate(const Recipe& recipe);
  explicit Enumeration(std::shared_ptr<const Lattice> lattice) : whole(std::move(lattice)) {}
  bool is_sheet(Piece square) const;
};

Enumeration enumerate(const Recipe& recipe);

}  // namespace aresta::grid
