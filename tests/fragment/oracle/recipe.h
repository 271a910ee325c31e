// SPDX-License-Identifier: Apache-2.0
// What a random case is made of, as text that a person can read and change:
//
//   steps 6                       the lattice: points 0..6 along each axis (two steps to a grid cell)
//   turn 1 2 0 -1                 optional: turned by this integer quaternion, and scaled by its norm
//   operand
//     solid 0 0 0  2 2 2          a region: corners of a box
//     joined 2 0 0  4 2 2         more of the region before it
//     hole 0 0 0  1 1 1           no region here
//     shell 0 0 4  2 2 6          the boundary of a box as sheets
//     sheet 0 0 0  2 2 0          a rectangle
//     wire 1 1 0  1 1 5           an edge
//     point 1 1 1
//
// Within an operand later solids and holes replace what they overlap; walls are where regions differ, sheets add faces,
// wires and points cut what they lie on. Operands lie over each other as they like.
#pragma once

#include "base/result.h"
#include "fragment/oracle/grid_complex.h"

namespace aresta::grid {

enum class ShapeKind { solid, joined, hole, shell, sheet, wire, point };

struct Shape {
  ShapeKind kind = ShapeKind::solid;
  Box box;
  bool operator==(const Shape&) const = default;
};

using OperandRecipe = std::vector<Shape>;

/// The rotation of an integer quaternion times its norm: an integer matrix, whose columns have the norm for length.
struct Turn {
  std::array<int, 4> quaternion{1, 0, 0, 0};
  int scale() const;
  std::array<std::array<int, 3>, 3> matrix() const;
  bool operator==(const Turn&) const = default;
};

struct Recipe {
  int steps = 6;
  Turn turn;
  std::vector<OperandRecipe> operands;

  std::size_t shape_count() const;
  std::string text() const;
};

Result<Recipe> parse_recipe(const std::string& text);

/// An operand on the lattice: its entities, and which regions are filled.
struct GridOperand {
  GridComplex complex;
  std::vector<bool> filled;  ///< per region; [0] is outside
};

GridOperand lay_out(const OperandRecipe& recipe, std::shared_ptr<const Lattice> lattice);

}  // namespace aresta::grid
