// SPDX-License-Identifier: Apache-2.0
// Moves and copies. Half-spaces and meshes are refused; groups are moved part by part.
#include <functional>

#include "construct/move.h"
#include "document/commands.h"
#include "document/construction.h"

namespace aresta::document {

namespace {

const Parameter shape{.name = "x", .type = Type::shape};

/// The shape with each of its models replaced by `map` of it; entities keep their numbers.
Result<Value> move_models(Call& call, const std::function<Result<Model>(const Model&)>& map) {
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  std::vector<Part> parts;
  for (const Part& part : x->parts()) {
    ARESTA_CHECK(call.context().step(0, call.command().name));
    ARESTA_TRY(Model moved, map(*part.model));
    parts.push_back({std::make_shared<Model>(std::move(moved)), part.entities});
  }
  return Value(ShapePtr(std::make_shared<const ModelShape>(std::move(parts), x->name())));
}

Parameter offset(std::string name) {
  return {.name = std::move(name), .type = Type::number, .unit = "length", .default_value = 0};
}

Parameter origin(std::string name, std::string doc) {
  return {.name = std::move(name),
          .type = Type::point,
          .doc = std::move(doc),
          .unit = "length",
          .default_value = Value::tuple({0, 0, 0})};
}

Command move(std::string name, std::vector<Parameter> parameters, std::string doc, std::string example,
             Function function) {
  parameters.insert(parameters.begin(), shape);
  return {.name = std::move(name),
          .group = "moves",
          .parameters = std::move(parameters),
          .returns = "a new shape; the old one stays",
          .doc = std::move(doc),
          .example = std::move(example),
          .errors = {errors::bad_size, errors::not_similar},
          .function = std::move(function)};
}

Result<Value> make_grid(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  std::array<int, 3> count{};
  const auto n = call.numbers("n");
  for (std::size_t i = 0; i < 3; ++i) {
    if (n[i] != std::floor(n[i]) || n[i] > 1e6)
      return Error{errors::bad_size, "grid: n must be three whole numbers from 1 to 1000000"};
    count[i] = static_cast<int>(n[i]);
  }
  if (n[0] * n[1] * n[2] > 1e6) return Error{errors::bad_size, "grid: at most a million copies can be made"};
  const Vec3 step = call.point("step");
  std::vector<Value> copies;
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        ARESTA_CHECK(call.context().step(0, "grid"));
        std::vector<Part> parts;
        for (const Part& part : x->parts()) {
          ARESTA_TRY(Model moved, translate(*part.model, {i * step.x, j * step.y, k * step.z}));
          parts.push_back({std::make_shared<Model>(std::move(moved)), part.entities});
        }
        copies.emplace_back(ShapePtr(std::make_shared<const ModelShape>(std::move(parts), x->name())));
      }
    }
  }
  return Value::list(std::move(copies));
}

}  // namespace

void register_moves(Registry& r) {
  r.add(move("translate", {offset("dx"), offset("dy"), offset("dz")}, "Moves a shape.",
             "translate(block(1, 1, 1), 2, 0, 0)", [](Call& c) {
               const Vec3 d{c.number("dx"), c.number("dy"), c.number("dz")};
               return move_models(c, [d](const Model& m) { return translate(m, d); });
             }));
  r.add(move("rotate",
             {{.name = "angle", .type = Type::number, .doc = "right-handed about the axis", .unit = "degrees"},
              {.name = "axis", .type = Type::direction, .default_value = Value::tuple({0, 0, 1})},
              origin("about", "a point of the axis")},
             "Turns a shape about an axis.", "rotate(block(4, 2, 2), 35, axis=(0, 0, 1))", [](Call& c) {
               const double angle = c.number("angle");
               const Vec3 turning = c.point("axis"), about = c.point("about");
               return move_models(c, [=](const Model& m) { return rotate(m, angle, turning, about); });
             }));
  r.add(move("scale",
             {{.name = "s", .type = Type::number, .doc = "factor", .limits = positive},
              origin("about", "the point that stays")},
             "Scales a shape.", "scale(sphere(1), 2)", [](Call& c) {
               const double factor = c.number("s");
               const Vec3 about = c.point("about");
               return move_models(c, [=](const Model& m) { return scale(m, factor, about); });
             }));
  r.add(move("mirror",
             {{.name = "plane",
               .type = Type::any,
               .doc = "'xy', 'yz', 'xz', or (point, normal) as in ((0, 0, 4), (0, 0, 1))"}},
             "Mirrors a shape in a plane.", "mirror(block(1, 2, 3), 'xy')", [](Call& c) -> Result<Value> {
               const Value& plane = c["plane"];
               Vec3 through{}, normal{};
               if (plane.is(Value::Kind::string)) {
                 const std::string& s = plane.string();
                 if (s == "xy" || s == "yx") normal = {0, 0, 1};
                 if (s == "yz" || s == "zy") normal = {1, 0, 0};
                 if (s == "xz" || s == "zx") normal = {0, 1, 0};
               } else if (plane.is_sequence()) {
                 // (point, normal), or six numbers.
                 std::vector<double> numbers;
                 for (const Value& v : plane.items()) {
                   if (v.is_number()) numbers.push_back(v.number());
                   if (v.is_sequence() && v.items().size() == 3) {
                     for (const Value& w : v.items()) {
                       if (w.is_number()) numbers.push_back(w.number());
                     }
                   }
                 }
                 if (numbers.size() == 6) {
                   through = {numbers[0], numbers[1], numbers[2]};
                   normal = {numbers[3], numbers[4], numbers[5]};
                 }
               }
               if (!is_finite(through) || !is_finite(normal) || norm(normal) == 0) {
                 return Error{
                     errors::bad_size,
                     "mirror: plane must be 'xy', 'yz', 'xz' or (point, normal), as in ((0, 0, 4), (0, 0, 1)), not " +
                         given_text(plane)};
               }
               return move_models(c, [=](const Model& m) { return mirror(m, through, normal); });
             }));
  r.add(move("transform",
             {{.name = "matrix",
               .type = Type::numbers,
               .doc = "3 rows of 4 numbers: the linear map and, last in each row, the offset",
               .size = 12}},
             "Moves a shape by a matrix.", "transform(block(1, 1, 1), [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0])",
             [](Call& c) {
               std::array<double, 12> m{};
               const auto numbers = c.numbers("matrix");
               std::copy(numbers.begin(), numbers.end(), m.begin());
               return move_models(c, [t = Transform::from_rows(m)](const Model& model) { return transform(model, t); });
             }));
  r.add({.name = "grid",
         .group = "moves",
         .parameters =
             {shape,
              {.name = "n", .type = Type::numbers, .doc = "how many along x, y and z", .limits = {1, 1e6}, .size = 3},
              {.name = "step", .type = Type::point, .doc = "from one to the next along x, y and z", .unit = "length"}},
         .returns = "a list of copies, x fastest",
         .doc = "Copies of a shape in rows, columns and layers.",
         .example = "fragment(grid(block(1, 1, 1), n=(3, 3, 3), step=(1, 1, 1)))",
         .errors = {errors::bad_size},
         .function = make_grid});
}

}  // namespace aresta::document
