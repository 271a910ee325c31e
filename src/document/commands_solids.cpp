// SPDX-License-Identifier: Apache-2.0
// Solids: block, cylinder, cone, sphere, torus, wedge, prism, pyramid, polyhedron, half_space.
#include "construct/primitives.h"
#include "document/commands.h"
#include "document/construction.h"

namespace aresta::document {

namespace {

const std::vector<ErrorCode> size_errors = {errors::bad_size};

Command solid(std::string name, std::vector<Parameter> parameters, std::string doc, std::string example,
              Function function) {
  return {.name = std::move(name),
          .group = "solids",
          .parameters = std::move(parameters),
          .returns = "a shape of one region",
          .doc = std::move(doc),
          .example = std::move(example),
          .errors = size_errors,
          .function = std::move(function)};
}

std::vector<Parameter> with(std::vector<Parameter> first, const std::vector<Parameter>& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

Result<Value> make_polyhedron(Call& call) {
  const std::vector<Vec3> points = call.points("points");
  std::vector<PolyhedronFace> faces;
  const auto loops = call.index_loops("faces");
  for (std::size_t f = 0; f < loops.size(); ++f) {
    for (const auto& loop : loops[f]) {
      for (const std::size_t i : loop) {
        if (i < points.size()) continue;
        return Error{errors::bad_size, "polyhedron: faces[" + std::to_string(f) + "] names point " + std::to_string(i) +
                                           ", but there are only " + std::to_string(points.size()) +
                                           " (counted from 0)"};
      }
    }
    faces.push_back({loops[f]});
  }
  return made(polyhedron(points, faces, construct_options(call), call.context()));
}

}  // namespace

void register_solids(Registry& r) {
  r.add(solid("block",
              with({length("dx", "size along x"), length("dy", "size along y"), length("dz", "size along z"),
                    at("the corner with the lowest coordinates")},
                   {names()}),
              "A box with its edges along the axes.", "block(3, 5, 7)", [](Call& c) {
                return made(block(c.number("dx"), c.number("dy"), c.number("dz"), c.point("at"), construct_options(c)));
              }));
  r.add(solid("cylinder", with({length("r", "radius"), length("h", "height")}, round()),
              "A cylinder; its base's centre stands at `at`.", "cylinder(2, 10, at=(0, 0, -5))", [](Call& c) {
                return made(cylinder(c.number("r"), c.number("h"), placement(c), patches(c), construct_options(c)));
              }));
  r.add(solid("cone",
              with({size("r1", "radius at the base"), size("r2", "radius at the top"), length("h", "height")}, round()),
              "A cone or a frustum; one of the radii may be 0.", "cone(2, 0, 3)", [](Call& c) {
                return made(cone(c.number("r1"), c.number("r2"), c.number("h"), placement(c), patches(c),
                                 construct_options(c)));
              }));
  r.add(solid("sphere", with({length("r", "radius")}, round()), "A sphere; its centre is at `at`.",
              "sphere(2, at=(1, 0, 0))",
              [](Call& c) { return made(sphere(c.number("r"), placement(c), patches(c), construct_options(c))); }));
  r.add(solid(
      "torus",
      with({length("R", "from the centre to the middle of the tube"), length("r", "radius of the tube, less than R")},
           round()),
      "A torus; its centre is at `at`.", "torus(3, 1)", [](Call& c) {
        return made(torus(c.number("R"), c.number("r"), placement(c), patches(c), construct_options(c)));
      }));
  r.add(solid("wedge",
              with({length("dx", "size along x"), length("dy", "size along y"), length("dz", "size along z"),
                    size("ltx", "width in x at the far side y = dy")},
                   standing()),
              "A block that narrows along y: at y = dy it is only ltx wide.", "wedge(4, 2, 3, 1)", [](Call& c) {
                return made(wedge(c.number("dx"), c.number("dy"), c.number("dz"), c.number("ltx"), placement(c),
                                  construct_options(c)));
              }));
  const Parameter sides{.name = "n", .type = Type::integer, .doc = "number of sides", .limits = {3, 10000}};
  r.add(solid("prism",
              with({sides, length("r", "radius of the circle through its corners"), length("h", "height")}, standing()),
              "A prism over a regular polygon.", "prism(6, 2, 3)", [](Call& c) {
                return made(prism(static_cast<int>(c.integer("n")), c.number("r"), c.number("h"), placement(c),
                                  construct_options(c)));
              }));
  r.add(solid("pyramid",
              with({sides, length("r", "radius of the circle through its corners"), length("h", "height")}, standing()),
              "A pyramid over a regular polygon.", "pyramid(4, 1, 2)", [](Call& c) {
                return made(pyramid(static_cast<int>(c.integer("n")), c.number("r"), c.number("h"), placement(c),
                                    construct_options(c)));
              }));
  r.add(
      {.name = "polyhedron",
       .group = "solids",
       .parameters =
           {{.name = "points", .type = Type::points, .unit = "length"},
            {.name = "faces",
             .type = Type::index_loops,
             .doc =
                 "each counterclockwise seen from outside; a face with holes is a list of loops, the outer one first"}},
       .returns = "a shape of one or more regions",
       .doc = "A solid with plane faces.",
       .example =
           "polyhedron([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])",
       .errors = {errors::bad_size, errors::not_planar, errors::self_intersection, errors::not_closed,
                  errors::inside_out, errors::points_coincide},
       .function = make_polyhedron});
  r.add({.name = "half_space",
         .group = "solids",
         .parameters = {{.name = "point", .type = Type::point, .doc = "on the plane", .unit = "length"},
                        {.name = "normal", .type = Type::direction, .doc = "points out of the half-space"}},
         .returns = "an operand for intersection and difference",
         .doc = "All that lies on one side of a plane, the side that the normal points away from.",
         .example = "intersection(sphere(1), half_space((0, 0, 0), (0, 0, 1)))",
         .function = [](Call& c) -> Result<Value> {
           return Value(
               ShapePtr(std::make_shared<const HalfSpaceShape>(c.point("point"), normalized(c.point("normal")))));
         }});
}

}  // namespace aresta::document
