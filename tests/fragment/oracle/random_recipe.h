// SPDX-License-Identifier: Apache-2.0
// Random recipes in which operands meet in as many ways as there are.
//
// Two to five operands of at least eight shapes together on a grid of 3 or 4 cells along each axis: unit cubes, larger
// boxes, rectangles, edges and points, most of them aligned with the cells, the others off by half a cell along some
// axis. Some shapes repeat one of an earlier operand or are made from one (a side of it, its half, its inside, itself a
// step further), and some operands repeat an earlier one. Two themes bring about what chance alone seldom does: planes
// through everything, which cross in points, and bodies in the hollow of a body. Every operand has something in it.
// Same seed, same recipe.
#pragma once

#include <random>

#include "fragment/oracle/recipe.h"

namespace aresta::grid {

class RandomRecipes {
 public:
  explicit RandomRecipes(std::uint64_t seed) : random_(seed) {}

  Recipe next(bool turned);

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  bool chance(int percent) { return below(100) < percent; }

  Box any_box(int steps, int dimension, int longest);
  Box related(const Box& box, int steps);
  Shape any_shape(const Recipe& recipe, bool first);
  OperandRecipe any_operand(const Recipe& recipe, int shapes);
  OperandRecipe nest(int steps, std::size_t operand);
  Shape plane_through(int steps, std::size_t operand);
  Turn any_turn();

  std::mt19937_64 random_;
};

}  // namespace aresta::grid
