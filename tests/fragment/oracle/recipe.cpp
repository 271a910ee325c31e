// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/recipe.h"

#include <algorithm>
#include <sstream>

namespace aresta::grid {

namespace {

constexpr const char* kind_names[] = {"solid", "joined", "hole", "shell", "sheet", "wire", "point"};
constexpr int dimensions[] = {3, 3, 3, 3, 2, 1, 0};
constexpr int most_steps = 64;

Error bad_line(int number, const std::string& what) {
  return {errors::invalid_argument, "line " + std::to_string(number) + " of a recipe: " + what};
}

Result<Shape> parse_shape(const std::string& word, std::istringstream& numbers, int steps, int line) {
  const auto* name = std::find(std::begin(kind_names), std::end(kind_names), word);
  if (name == std::end(kind_names)) return bad_line(line, "'" + word + "' is unknown");
  Shape shape{static_cast<ShapeKind>(name - std::begin(kind_names)), {}};
  for (int& c : shape.box.low) numbers >> c;
  if (shape.kind == ShapeKind::point) {
    shape.box.high = shape.box.low;
  } else {
    for (int& c : shape.box.high) numbers >> c;
  }
  if (!numbers) return bad_line(line, "coordinates are missing");
  for (std::size_t a = 0; a < 3; ++a) {
    if (shape.box.low[a] < 0 || shape.box.low[a] > shape.box.high[a] || shape.box.high[a] > steps)
      return bad_line(line, "corners are not in order, or not on the lattice");
  }
  if (shape.box.dimension() != dimensions[name - std::begin(kind_names)])
    return bad_line(line, "the box has not the dimension of a " + word);
  return shape;
}

}  // namespace

int Turn::scale() const {
  int sum = 0;
  for (const int c : quaternion) sum += c * c;
  return sum;
}

std::array<std::array<int, 3>, 3> Turn::matrix() const {
  const auto [a, b, c, d] = quaternion;
  return {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
           {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
           {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
}

std::size_t Recipe::shape_count() const {
  std::size_t sum = 0;
  for (const OperandRecipe& operand : operands) sum += operand.size();
  return sum;
}

std::string Recipe::text() const {
  std::string result = "steps " + std::to_string(steps) + "\n";
  if (turn != Turn{}) {
    result += "turn";
    for (const int c : turn.quaternion) result += " " + std::to_string(c);
    result += "\n";
  }
  const auto corner = [](const Steps& p) {
    return " " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]);
  };
  for (const OperandRecipe& operand : operands) {
    result += "operand\n";
    for (const Shape& s : operand) {
      result += std::string("  ") + kind_names[static_cast<std::size_t>(s.kind)] + corner(s.box.low);
      if (s.kind != ShapeKind::point) result += " " + corner(s.box.high);
      result += "\n";
    }
  }
  return result;
}

Result<Recipe> parse_recipe(const std::string& text) {
  Recipe recipe;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word;
    if (!(words >> word)) continue;
    if (word == "steps") {
      if (!(words >> recipe.steps) || recipe.steps < 1 || recipe.steps > most_steps)
        return bad_line(number, "steps are from 1 to " + std::to_string(most_steps));
    } else if (word == "turn") {
      for (int& c : recipe.turn.quaternion) words >> c;
      if (!words || recipe.turn.scale() == 0) return bad_line(number, "a turn has four integers, not all zero");
    } else if (word == "operand") {
      recipe.operands.emplace_back();
    } else {
      if (recipe.operands.empty()) return bad_line(number, "a shape before the first operand");
      ARESTA_TRY(const Shape shape, parse_shape(word, words, recipe.steps, number));
      recipe.operands.back().push_back(shape);
    }
    if (words >> word) return bad_line(number, "'" + word + "' is too much");
  }
  return recipe;
}

GridOperand lay_out(const OperandRecipe& recipe, std::shared_ptr<const Lattice> lattice) {
  const Lattice& g = *lattice;
  GridComplex complex(std::move(lattice));
  std::vector<std::uint32_t> paint(g.size(), 0);
  std::uint32_t colour = 0;
  for (const Shape& shape : recipe) {
    const int dimension = shape.box.dimension();
    const auto on_boundary = [&](Piece p) {  // of the box, within its own plane or line
      for (int a = 0; a < 3; ++a) {
        const auto i = static_cast<std::size_t>(a);
        if (shape.box.low[i] == shape.box.high[i]) continue;
        if (g.raw(p, a) == 2 * shape.box.low[i] + 1 || g.raw(p, a) == 2 * shape.box.high[i] + 1) return true;
      }
      return false;
    };
    switch (shape.kind) {
      case ShapeKind::solid:
      case ShapeKind::joined:
      case ShapeKind::hole: {
        if (shape.kind == ShapeKind::solid || colour == 0) ++colour;
        const std::uint32_t now = shape.kind == ShapeKind::hole ? 0 : colour;
        g.for_each(shape.box, [&](Piece p) {
          if (g.dimension(p) == 3) paint[p] = now;
        });
        break;
      }
      case ShapeKind::shell:
        g.for_each(shape.box, [&](Piece p) {
          if (g.dimension(p) == 2 && on_boundary(p)) complex.mark(p);
        });
        break;
      case ShapeKind::sheet:
      case ShapeKind::wire:
      case ShapeKind::point:
        g.for_each(shape.box, [&](Piece p) {
          if (g.dimension(p) == dimension || (g.dimension(p) == dimension - 1 && on_boundary(p))) complex.mark(p);
        });
        break;
    }
  }
  for (Piece p = 0; p < g.size(); ++p) {
    if (g.dimension(p) != 2) continue;
    const int a = g.axis(p);
    if (paint[g.next(p, a, false)] != paint[g.next(p, a, true)]) complex.mark(p);
  }
  complex.complete();
  GridOperand operand{std::move(complex), {}};
  for (std::size_t r = 0; r < operand.complex.count(EntityKind::region); ++r)
    operand.filled.push_back(paint[operand.complex.pieces(RegionId(r)).front()] != 0);
  return operand;
}

}  // namespace aresta::grid
