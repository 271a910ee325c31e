// SPDX-License-Identifier: Apache-2.0
// Faces, wires and points.
#include "construct/profiles.h"
#include "construct/sweep.h"
#include "document/commands.h"
#include "document/construction.h"

namespace aresta::document {

namespace {

const Parameter path_points{.name = "points", .type = Type::points, .unit = "length"};
const Parameter closed{
    .name = "closed", .type = Type::boolean, .doc = "come back to the first point", .default_value = false};

Parameter place(std::string name, std::string doc = {}) {
  return {.name = std::move(name), .type = Type::point, .doc = std::move(doc), .unit = "length"};
}

Command sheet(std::string name, std::vector<Parameter> parameters, std::string returns, std::string doc,
              std::string example, Function function) {
  return {.name = std::move(name),
          .group = "faces, wires and points",
          .parameters = std::move(parameters),
          .returns = std::move(returns),
          .doc = std::move(doc),
          .example = std::move(example),
          .errors = {errors::bad_size, errors::points_coincide, errors::not_planar, errors::self_intersection},
          .function = std::move(function)};
}

/// The profile as a model of its own.
Result<std::shared_ptr<Model>> profile(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  return as_model(*x, call.context());
}

Result<Value> make_face(Call& call) {
  std::vector<std::shared_ptr<Model>> wires;
  std::vector<const Model*> models;
  for (const ShapePtr& shape : call.shapes("wires")) {
    ARESTA_TRY(const ModelShapePtr x, model_shape(call, shape, "wires"));
    ARESTA_TRY(std::shared_ptr<Model> wire, as_model(*x, call.context()));
    models.push_back(wire.get());
    wires.push_back(std::move(wire));
  }
  return made(planar_face(models, construct_options(call), call.context()));
}

}  // namespace

void register_sheets(Registry& r) {
  r.add(sheet("polygon",
              {path_points,
               {.name = "holes",
                .type = Type::point_lists,
                .doc = "loops of points inside",
                .unit = "length",
                .default_value = Value::list({})}},
              "a shape of one face", "A plane face; its front is where the points run counterclockwise.",
              "polygon([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)])",
              [](Call& c) { return made(polygon(c.points("points"), c.point_lists("holes"), construct_options(c))); }));
  r.add(sheet("disk", {length("r", "radius"), at("its centre"), axis()}, "a shape of one face", "A plane round face.",
              "disk(2)", [](Call& c) { return made(disk(c.number("r"), placement(c), construct_options(c))); }));
  r.add(sheet("polyline", {path_points, closed}, "a shape of wire edges", "Straight edges from point to point.",
              "polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)])",
              [](Call& c) { return made(polyline(c.points("points"), c.boolean("closed"), construct_options(c))); }));
  r.add(sheet("line", {place("p"), place("q")}, "a shape of one wire edge", "A straight edge.",
              "line((0, 0, 0), (1, 2, 3))",
              [](Call& c) { return made(line(c.point("p"), c.point("q"), construct_options(c))); }));
  const Parameter turn{.name = "axis",
                       .type = Type::direction,
                       .doc = "counterclockwise about it; for half turns and longer arcs",
                       .default_value = Value()};
  r.add(sheet("arc", {place("centre"), place("start"), place("end"), turn}, "a shape of one wire edge",
              "The shorter circular arc between two points, or the one about an axis.",
              "arc((0, 0, 0), (1, 0, 0), (0, 1, 0))", [](Call& c) {
                const Vec3 centre = c.point("centre"), start = c.point("start"), end = c.point("end");
                if (c["axis"].is_none()) return made(arc(centre, start, end, construct_options(c)));
                return made(arc_about(centre, start, end, c.point("axis"), construct_options(c)));
              }));
  r.add(sheet("arc_through", {place("start"), place("middle"), place("end")}, "a shape of one wire edge",
              "The circular arc through three points.", "arc_through((1, 0, 0), (0, 1, 0), (-1, 0, 0))", [](Call& c) {
                return made(arc_through(c.point("start"), c.point("middle"), c.point("end"), construct_options(c)));
              }));
  r.add(
      sheet("ellipse",
            {length("a", "semi-axis along local x"), length("b", "semi-axis along local y"), at("its centre"), axis()},
            "a shape of one closed wire edge", "An ellipse.", "ellipse(3, 2)",
            [](Call& c) { return made(ellipse(c.number("a"), c.number("b"), placement(c), construct_options(c))); }));
  r.add(sheet("circle", {length("r", "radius"), at("its centre"), axis()}, "a shape of one closed wire edge",
              "A circle.", "circle(2)",
              [](Call& c) { return made(circle(c.number("r"), placement(c), construct_options(c))); }));
  r.add(sheet("spline", {path_points, closed}, "a shape of one wire edge", "A smooth curve through points.",
              "spline([(0, 0, 0), (1, 1, 0), (2, 0, 0)])",
              [](Call& c) { return made(spline(c.points("points"), c.boolean("closed"), construct_options(c))); }));
  r.add(sheet("point", {place("p")}, "a shape of one vertex", "A single point.", "point((1, 2, 3))",
              [](Call& c) { return made(point(c.point("p"), construct_options(c))); }));
  Command face = sheet(
      "face",
      {{.name = "wires", .type = Type::shapes, .doc = "closed outlines, in any order and direction", .variadic = true}},
      "a shape of one face", "The plane face inside closed wires; further outlines inside the largest one are holes.",
      "face(circle(2), circle(1))", make_face);
  face.errors = {errors::bad_size, errors::not_closed, errors::not_planar, errors::self_intersection,
                 errors::bad_profile};
  r.add(std::move(face));
  const Parameter swept{.name = "x", .type = Type::shape, .doc = "faces, wires or points"};
  const std::vector<ErrorCode> sweep_errors = {errors::bad_size, errors::bad_profile, errors::sweep_overlaps};
  r.add({.name = "extrude",
         .group = "solids",
         .parameters = {swept, {.name = "vector", .type = Type::direction, .unit = "length"}, names()},
         .returns = "a shape: solids from faces, faces from wires, wires from points",
         .doc = "Sweeps a shape along a straight way.",
         .example = "extrude(disk(2), (0, 0, 5))",
         .errors = sweep_errors,
         .function = [](Call& c) -> Result<Value> {
           ARESTA_TRY(const std::shared_ptr<Model> x, profile(c));
           return made(extrude(x, c.point("vector"), construct_options(c), c.context()));
         }});
  r.add({.name = "revolve",
         .group = "solids",
         .parameters = {swept,
                        {.name = "angle",
                         .type = Type::number,
                         .doc = "right-handed about the axis",
                         .unit = "degrees",
                         .default_value = 360,
                         .limits = {-360, 360}},
                        {.name = "about",
                         .type = Type::point,
                         .doc = "a point of the axis",
                         .unit = "length",
                         .default_value = Value::tuple({0, 0, 0})},
                        {.name = "axis", .type = Type::direction, .default_value = Value::tuple({0, 0, 1})},
                        names()},
         .returns = "a shape: solids from faces, faces from wires, wires from points",
         .doc = "Sweeps a shape about an axis.",
         .example = "revolve(polygon([(1, 0, 0), (2, 0, 0), (2, 0, 1)]), 180)",
         .errors = sweep_errors,
         .function = [](Call& c) -> Result<Value> {
           ARESTA_TRY(const std::shared_ptr<Model> x, profile(c));
           return made(
               revolve(x, c.number("angle"), c.point("about"), c.point("axis"), construct_options(c), c.context()));
         }});
}

}  // namespace aresta::document
