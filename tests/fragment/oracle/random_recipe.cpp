// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/random_recipe.h"

#include <algorithm>

namespace aresta::grid {

namespace {

constexpr int cell = 2;  // steps

Shape plain(const Box& box) {
  constexpr ShapeKind kinds[] = {ShapeKind::point, ShapeKind::wire, ShapeKind::sheet, ShapeKind::solid};
  return {kinds[box.dimension()], box};
}

}  // namespace

/// Along as many axes as it has dimensions up to `longest` cells long.
Box RandomRecipes::any_box(int steps, int dimension, int longest) {
  std::array<bool, 3> spans{};
  for (int left = dimension; left > 0;) {
    auto& chosen = spans[static_cast<std::size_t>(below(3))];
    if (chosen) continue;
    chosen = true;
    --left;
  }
  Box box;
  const bool off = chance(30);
  for (std::size_t a = 0; a < 3; ++a) {
    int length = spans[a] ? cell * (1 + below(longest)) : 0;
    if (length > steps) length = steps;
    const int room = steps - length;
    int low = cell * below(room / cell + 1);
    if (off && chance(50) && low + 1 <= room) ++low;
    box.low[a] = low;
    box.high[a] = low + length;
  }
  return box;
}

Box RandomRecipes::related(const Box& from, int steps) {
  Box box = from;
  const auto a = static_cast<std::size_t>(below(3));
  switch (below(5)) {
    case 0:  // a side or an end of it
      (chance(50) ? box.low : box.high)[a] = chance(50) ? box.low[a] : box.high[a];
      if (box.low[a] > box.high[a]) std::swap(box.low[a], box.high[a]);
      if (box == from) box.low[a] = box.high[a];
      break;
    case 1:  // what is halfway through it
      box.low[a] = box.high[a] = (box.low[a] + box.high[a]) / 2;
      break;
    case 2:  // a half of it
      if (box.high[a] - box.low[a] > 1) (chance(50) ? box.low : box.high)[a] = (box.low[a] + box.high[a]) / 2;
      break;
    case 3:  // its inside, as far as there is one
      for (std::size_t b = 0; b < 3; ++b) {
        if (box.high[b] - box.low[b] > 2) ++box.low[b], --box.high[b];
      }
      break;
    default: {  // itself, elsewhere
      const int by = (chance(50) ? 1 : -1) * (chance(50) ? 1 : box.high[a] - box.low[a]);
      if (box.low[a] + by >= 0 && box.high[a] + by <= steps) box.low[a] += by, box.high[a] += by;
    }
  }
  return box;
}

Shape RandomRecipes::any_shape(const Recipe& recipe, bool first) {
  if (!recipe.operands.empty() && chance(35)) {
    const auto& operand = recipe.operands[static_cast<std::size_t>(below(static_cast<int>(recipe.operands.size())))];
    const Shape& shape = operand[static_cast<std::size_t>(below(static_cast<int>(operand.size())))];
    if (chance(30) && (shape.kind == ShapeKind::solid || shape.kind >= ShapeKind::shell)) return shape;
    return plain(related(shape.box, recipe.steps));
  }
  const int kind = below(100);
  const int longest = recipe.steps / cell;
  if (kind < 30) return plain(any_box(recipe.steps, 3, 1));
  if (kind < 42) return plain(any_box(recipe.steps, 3, longest));
  if (kind < 47) return {first ? ShapeKind::solid : ShapeKind::joined, any_box(recipe.steps, 3, 2)};
  if (kind < 52) return {first ? ShapeKind::solid : ShapeKind::hole, any_box(recipe.steps, 3, 1)};
  if (kind < 56) return {ShapeKind::shell, any_box(recipe.steps, 3, 2)};
  if (kind < 68) return plain(any_box(recipe.steps, 2, 1));
  if (kind < 76) return plain(any_box(recipe.steps, 2, longest));
  if (kind < 90) return plain(any_box(recipe.steps, 1, longest));
  return plain(any_box(recipe.steps, 0, 1));
}

/// The first operand is a body, hollow or not; the others have something inside it, mostly apart from its walls.
OperandRecipe RandomRecipes::nest(int steps, std::size_t operand) {
  if (operand == 0) {
    OperandRecipe body{plain({{0, 0, 0}, {steps, steps, steps}})};
    if (chance(60)) body.push_back({ShapeKind::hole, {{2, 2, 2}, {steps - 2, steps - 2, steps - 2}}});
    return body;
  }
  OperandRecipe inside;
  for (int left = 1 + below(3); left > 0; --left) {
    Box box;
    const int thickness = chance(30) ? 0 : 75;
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = box.high[a] = 1 + below(steps - 2);
      if (chance(thickness)) box.high[a] += 1 + below(steps - 1 - box.low[a]);
    }
    inside.push_back(plain(box));
  }
  return inside;
}

Shape RandomRecipes::plane_through(int steps, std::size_t operand) {
  const std::size_t a = operand % 3;
  Box box{{0, 0, 0}, {steps, steps, steps}};
  box.low[a] = box.high[a] = 1 + below(steps - 1);
  return plain(box);
}

OperandRecipe RandomRecipes::any_operand(const Recipe& recipe, int shapes) {
  if (!recipe.operands.empty() && chance(12))
    return recipe.operands[static_cast<std::size_t>(below(static_cast<int>(recipe.operands.size())))];
  OperandRecipe operand;
  while (static_cast<int>(operand.size()) < shapes) operand.push_back(any_shape(recipe, operand.empty()));
  return operand;
}

/// Neither the identity nor a turn that takes axes to axes.
Turn RandomRecipes::any_turn() {
  Turn turn;
  const auto takes_axes_to_axes = [](const Turn& t) {
    for (const auto& row : t.matrix()) {
      for (const int c : row) {
        if (std::abs(c) == t.scale()) return true;
      }
    }
    return false;
  };
  do {
    for (int& c : turn.quaternion) c = below(7) - 3;
  } while (takes_axes_to_axes(turn));
  return turn;
}

Recipe RandomRecipes::next(bool turned) {
  Recipe recipe;
  recipe.steps = cell * (chance(75) ? 3 : 4);
  if (turned) recipe.turn = any_turn();
  const int operands = 2 + below(4);
  const int shapes = 8 + below(5);
  const int theme = below(100);
  const auto lattice = std::make_shared<const Lattice>(recipe.steps);
  while (static_cast<int>(recipe.operands.size()) < operands || recipe.shape_count() < 8) {
    if (recipe.operands.size() == 5) recipe.operands.clear();
    const std::size_t index = recipe.operands.size();
    OperandRecipe operand;
    if (theme < 18) operand = nest(recipe.steps, index);
    if (theme >= 90) operand.push_back(plane_through(recipe.steps, index));
    if (operand.empty() || (index > 0 && (theme >= 90 || chance(30)))) {
      const auto more = any_operand(recipe, std::max(1, shapes / operands + below(3) - 1));
      operand.insert(operand.end(), more.begin(), more.end());
    }
    if (!lay_out(operand, lattice).complex.is_empty()) recipe.operands.push_back(std::move(operand));
  }
  return recipe;
}

}  // namespace aresta::grid
