// SPDX-License-Identifier: Apache-2.0
// Measures and questions.
#include <algorithm>
#include <cmath>

#include "document/commands.h"
#include "document/counting.h"
#include "document/errors.h"
#include "document/mesh_shape.h"
#include "document/shape.h"
#include "model/check.h"
#include "model/measure.h"
#include "model/query.h"

namespace aresta::document {

namespace {

const Parameter shape{.name = "x", .type = Type::shape};

Result<ModelShapePtr> x_of(Call& call) {
  return model_shape(call, call.shape("x"), "x");
}

Result<Moments> moments_of(const Model& model, EntityRef e) {
  switch (e.kind) {
    case EntityKind::vertex: {
      const Vec3 p = model.point(VertexId(e.index));
      return Moments{1, p, {p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x}};
    }
    case EntityKind::edge:
      return measure(model, EdgeId(e.index));
    case EntityKind::face:
      return measure(model, FaceId(e.index));
    case EntityKind::region:
      return measure(model, RegionId(e.index));
  }
  return Moments{};
}

/// Sum over all entities of one kind that the shape holds.
Result<Moments> total(Call& call, const ModelShape& x, EntityKind kind) {
  Moments sum;
  for (const Part& part : x.parts()) {
    for (const EntityRef e : closure(part, kind)) {
      ARESTA_CHECK(call.context().step(0, call.command().name));
      ARESTA_TRY(const Moments one, moments_of(*part.model, e));
      sum += one;
    }
  }
  return sum;
}

Result<Value> measured(Call& call, EntityKind kind) {
  if (const auto* m = dynamic_cast<const MeshShape*>(call.shape("x").get());
      m != nullptr && kind == EntityKind::region) {
    return Value(linear_volume(m->mesh()));
  }
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  ARESTA_TRY(const Moments sum, total(call, *x, kind));
  return Value(sum.measure);
}

/// Moments of the entities of the highest dimension that the shape holds.
Result<Moments> body(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  for (const EntityKind kind : {EntityKind::region, EntityKind::face, EntityKind::edge, EntityKind::vertex}) {
    ARESTA_TRY(const Moments sum, total(call, *x, kind));
    if (sum.measure != 0) return sum;
  }
  return Error{errors::unknown_entity, call.command().name + ": the shape is empty"};
}

Value point_value(Vec3 p) {
  return Value::tuple({Value(p.x), Value(p.y), Value(p.z)});
}

Result<Value> inertia_of(Call& call) {
  ARESTA_TRY(const Moments m, body(call));
  const auto i = m.inertia();
  return Value::list(
      {Value::list({i[0], i[3], i[5]}), Value::list({i[3], i[1], i[4]}), Value::list({i[5], i[4], i[2]})});
}

Result<Value> bounds_of(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  Box3 box;
  for (const Part& part : x->parts()) {
    const auto members = closure(part);
    for (const EntityRef v : members[0]) box.add(part.model->point(VertexId(v.index)));
    for (const EntityRef e : members[1]) box.add(part.model->bounds(EdgeId(e.index)));
    for (const EntityRef f : members[2]) box.add(part.model->bounds(FaceId(f.index)));
  }
  if (box.empty()) return Error{errors::unknown_entity, "bounds: the shape is empty"};
  return Value::tuple({point_value(box.low), point_value(box.high)});
}

Result<Value> count_of(Call& call) {
  const std::string& what = call.string("what");
  const bool of_meshes = what == "nodes" || what == "elements";
  const auto* m = dynamic_cast<const MeshShape*>(call.shape("x").get());
  if (of_meshes && m == nullptr)
    return Error{errors::command_type,
                 "count: " + what + " are counted in meshes, not in <" + call.shape("x")->describe() + ">"};
  if (of_meshes) return Value(static_cast<std::int64_t>(what == "nodes" ? m->mesh().nodes.size() : m->element_count()));
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  std::size_t n = 0;
  for (const Part& part : x->parts()) {
    if (what == "components") {
      n += component_count(part);
    } else if (what == "shells") {
      n += shell_count(part);
    } else {
      n += closure(part, what == "vertices" ? EntityKind::vertex
                         : what == "edges"  ? EntityKind::edge
                         : what == "faces"  ? EntityKind::face
                                            : EntityKind::region)
               .size();
    }
  }
  return Value(static_cast<std::int64_t>(n));
}

Result<Value> genus_of(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  std::int64_t sum = 0;
  for (const Part& part : x->parts()) sum += genus(part);
  return Value(sum);
}

Result<Value> check_shape(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  std::size_t n = 0;
  for (const Part& part : x->parts()) {
    ARESTA_TRY(const std::vector<Finding> findings, check(*part.model, CheckLevel::full, call.context()));
    n += findings.size();
  }
  return Value(static_cast<std::int64_t>(n));
}

Result<Value> contains_point(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  const Vec3 p = call.point("point");
  for (const Part& part : x->parts()) {
    const Model& model = *part.model;
    const double tolerance = call.session().tolerance > 0 ? call.session().tolerance : model.tolerance();
    for (const EntityRef e : part.entities) {
      ARESTA_CHECK(call.context().step(0, "contains"));
      switch (e.kind) {
        case EntityKind::vertex:
          if (point_on_vertex(model, VertexId(e.index), p, tolerance)) return Value(true);
          break;
        case EntityKind::edge:
          if (point_on_edge(model, EdgeId(e.index), p, tolerance)) return Value(true);
          break;
        case EntityKind::face:
          if (point_on_face(model, FaceId(e.index), p, tolerance)) return Value(true);
          break;
        case EntityKind::region: {
          ARESTA_TRY(const Position position, point_in_region(model, RegionId(e.index), p, tolerance));
          if (position != Position::outside) return Value(true);
          break;
        }
      }
    }
  }
  return Value(false);
}

Command question(std::string name, std::vector<Parameter> parameters, std::string returns, std::string doc,
                 std::string example, Function function) {
  return {.name = std::move(name),
          .group = "measures",
          .parameters = std::move(parameters),
          .returns = std::move(returns),
          .doc = std::move(doc),
          .example = std::move(example),
          .errors = {errors::measure_failed},
          .function = std::move(function)};
}

}  // namespace

void register_measures(Registry& r) {
  r.add(question("volume", {shape}, "a number", "The volume of a shape's regions.", "volume(block(1, 2, 3))",
                 [](Call& c) { return measured(c, EntityKind::region); }));
  r.add(question("area", {shape}, "a number", "The area of a shape's faces, each counted once.", "area(block(1, 2, 3))",
                 [](Call& c) { return measured(c, EntityKind::face); }));
  r.add(question("length", {shape}, "a number", "The length of a shape's edges, each counted once.",
                 "length(line((0, 0, 0), (3, 4, 0)))", [](Call& c) { return measured(c, EntityKind::edge); }));
  r.add(question("centroid", {shape}, "a point (x, y, z)",
                 "The centre of gravity of a shape's regions; of its faces, edges or vertices when it has none.",
                 "centroid(cone(2, 0, 4))", [](Call& c) -> Result<Value> {
                   ARESTA_TRY(const Moments m, body(c));
                   return point_value(m.centroid());
                 }));
  r.add(question("inertia", {shape}, "a 3 x 3 matrix, as three rows",
                 "The inertia tensor about the centroid, for unit density.", "inertia(block(1, 2, 3))", inertia_of));
  r.add(question("bounds", {shape}, "two points, the lowest and the highest coordinates",
                 "The box around a shape, along the axes.", "low, high = bounds(sphere(1))", bounds_of));
  r.add(question("count",
                 {shape,
                  {.name = "what",
                   .type = Type::string,
                   .default_value = "regions",
                   .choices = {"regions", "shells", "faces", "edges", "vertices", "components", "nodes", "elements"}}},
                 "a whole number",
                 "Counts the finite regions of a shape, the shells of its finite regions, its faces, edges, vertices "
                 "or connected components; or the nodes or elements of a mesh.",
                 "count(block(1, 1, 1), \"edges\")", count_of));
  r.add(question("genus", {shape}, "a whole number",
                 "The number of handles (through holes), summed over a shape's closed shells.", "genus(torus(3, 1))",
                 genus_of));
  r.add(question("check", {shape}, "the number of findings, 0 when all is well",
                 "Runs the full checker on a shape's model.", "expect(check(block(1, 1, 1)), 0)", check_shape));
  r.add(question("contains", {shape, {.name = "point", .type = Type::point, .unit = "length"}},
                 "True or False; the boundary belongs to it", "Does a shape contain a point?",
                 "contains(sphere(1), (0.5, 0, 0))", contains_point));
}

void register_modelling(Registry& registry) {
  register_solids(registry);
  register_sheets(registry);
  register_moves(registry);
  register_booleans(registry);
  register_access(registry);
  register_measures(registry);
  register_files(registry);
}

}  // namespace aresta::document
