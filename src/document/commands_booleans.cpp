// SPDX-License-Identifier: Apache-2.0
// Booleans between groups, fragment, region detection, clean-up, cuts and sections.
#include <algorithm>
#include <cmath>
#include <set>

#include "boolean/boolean.h"
#include "boolean/errors.h"
#include "boolean/simplify.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "construct/select.h"
#include "document/commands.h"
#include "document/construction.h"
#include "document/errors.h"
#include "document/operands.h"
#include "fragment/parts.h"
#include "model/inherit.h"
#include "model/query.h"

namespace aresta::document {

namespace {

const Parameter regularise{.name = "regularise",
                           .type = Type::boolean,
                           .doc = "keep solids only: no dangling faces, wires or inner walls",
                           .default_value = false,
                           .keyword_only = true};
const Parameter keep_partitions{.name = "keep_partitions",
                                .type = Type::boolean,
                                .doc = "with regularise: keep the faces between adjoining regions",
                                .default_value = false,
                                .keyword_only = true};
const Parameter internals{.name = "internals",
                          .type = Type::boolean,
                          .doc = "bring what regions have inside: sheets, wires, points",
                          .default_value = true,
                          .keyword_only = true};
const std::vector<ErrorCode> boolean_errors = {errors::regions_overlap,     errors::empty_group,
                                               errors::inconsistent_result, errors::imprint_failed,
                                               errors::not_conserved,       errors::invalid_model};

bool is_half_space(const ShapePtr& s) {
  return dynamic_cast<const HalfSpaceShape*>(s.get()) != nullptr;
}

/// An empty model: what a union with nothing is made with.
Result<Model> nothing(const Context& context) {
  return ModelBuilder().build(context);
}

bool holds_nothing(const GroupSpec& group) {
  return group.members.empty();
}

/// Operands without anything in them are no trouble: they are dropped, and what is left may need no operation at all.
Result<Value> run_boolean(Call& call, BooleanKind kind, const std::vector<ShapePtr>& shapes) {
  const bool bounded = kind == BooleanKind::intersect  ? !std::all_of(shapes.begin(), shapes.end(), is_half_space)
                       : kind == BooleanKind::subtract ? !is_half_space(shapes[0])
                                                       : std::none_of(shapes.begin(), shapes.end(), is_half_space);
  if (!bounded)
    return Error{errors::command_type,
                 call.command().name +
                     ": the result would reach to infinity: a half-space can only be intersected with or subtracted"};

  ARESTA_TRY(Operands operands, gather_operands(call, shapes));
  for (GroupSpec& g : operands.groups) g.internals = call.boolean("internals");
  BooleanOptions options;
  options.kind = kind;
  options.regularise = call.boolean("regularise");
  options.keep_partitions = call.boolean("keep_partitions");
  options.fragment.tolerance = call.session().tolerance;

  const bool first_empty = holds_nothing(operands.groups[0]);
  const bool any_empty = std::any_of(operands.groups.begin(), operands.groups.end(), holds_nothing);
  if ((kind == BooleanKind::intersect && any_empty) || (kind == BooleanKind::subtract && first_empty) ||
      std::all_of(operands.groups.begin(), operands.groups.end(), holds_nothing)) {
    return made(nothing(call.context()));
  }
  auto result = boolean(operands.models, operands.groups, options, call.context());
  if (!result) return std::move(result).error();
  return made(std::move(result->model));
}

Result<Value> two_operands(Call& call, BooleanKind kind) {
  return run_boolean(call, kind, {call.shape("a"), call.shape("b")});
}

Result<Value> many_operands(Call& call, BooleanKind kind) {
  const std::vector<ShapePtr> shapes = call.shapes("shapes");
  if (shapes.size() < 2) {
    return Error{errors::empty_group, call.command().name + " takes at least two shapes, " +
                                          std::to_string(shapes.size()) +
                                          (shapes.size() == 1 ? " was given" : " were given")};
  }
  return run_boolean(call, kind, shapes);
}

/// Do parts of one model have no vertex in common?
bool share_nothing(const std::vector<Part>& parts) {
  std::set<std::pair<const Model*, EntityRef>> seen;
  for (const Part& part : parts) {
    for (const EntityRef v : closure(part, EntityKind::vertex)) {
      if (!seen.emplace(part.model.get(), v).second) return false;
    }
  }
  return true;
}

/// The shapes as models that hold nothing but what is listed, each once; empty ones left out.
Result<std::vector<std::shared_ptr<const Model>>> models_of(Call& call, const std::vector<ShapePtr>& shapes,
                                                            const std::string& parameter) {
  // Entities of one model stay together, so that what they share stays shared.
  std::vector<Part> parts;
  for (const ShapePtr& s : shapes) {
    ARESTA_TRY(const ModelShapePtr x, model_shape(call, s, parameter));
    parts.insert(parts.end(), x->parts().begin(), x->parts().end());
  }
  const ModelShape all(parts);
  std::vector<std::shared_ptr<const Model>> models;
  // Shapes that are components of one model (which may not know that they touch, as in a file) are apart from the
  // start.
  const bool apart = all.parts().size() < parts.size() && share_nothing(parts);
  for (const Part& part : apart ? parts : all.parts()) {
    ARESTA_TRY(std::shared_ptr<Model> model, as_model(ModelShape({part}), call.context()));
    if (model->topology().vertex_count() > 0) models.push_back(std::move(model));
  }
  return models;
}

/// Everything imprinted on everything; all cells kept.
Result<Value> make_fragment(Call& call, const std::string& parameter) {
  ARESTA_TRY(std::vector<std::shared_ptr<const Model>> models, models_of(call, call.shapes(parameter), parameter));
  if (models.empty()) return made(nothing(call.context()));
  bool apart = models.size() > 1;
  if (!apart) {
    ARESTA_TRY(apart, meets_unshared(*models[0], call.context()));
  }
  if (!apart) {
    // Nothing to imprint: the model's own entities meet in shared ones. Spaces that sheets enclose become regions.
    const bool solid = !models[0]->regions().empty();
    if (!solid) return made(detect_regions(models[0]));
    return made(Model(*models[0]));
  }
  FragmentOptions options;
  options.tolerance = call.session().tolerance;
  ARESTA_TRY(const Fragment pieces, fragment(std::move(models), options, call.context()));
  Model model = *pieces.model;
  inherit_labels(model);
  ARESTA_CHECK(require_valid(model, CheckLevel::fast, call.context()));
  return made(std::move(model));
}

Result<Value> classes_of(Call& call, bool counts) {
  ARESTA_TRY(const Operands operands, gather_operands(call, {call.shape("a"), call.shape("b")}));
  FragmentOptions options;
  options.tolerance = call.session().tolerance;
  ARESTA_TRY(const Classification found, classify(operands.models, operands.groups, options, call.context()));
  const Value& kind = call["kind"];
  std::array<std::int64_t, 5> count{};
  std::vector<Value> list;
  const auto model = std::make_shared<Model>(*found.fragment->model);
  for (const auto& [entity, cls] : found.classes) {
    if (!kind.is_none() && kind.string() != to_string(entity.kind)) continue;
    ++count[static_cast<std::size_t>(cls)];
    if (!counts) list.push_back(Value::tuple({Value(shape_of(model, {entity})), Value(to_string(cls))}));
  }
  if (!counts) return Value::list(std::move(list));
  for (std::size_t c = 0; c < count.size(); ++c) {
    list.push_back(Value::tuple({Value(to_string(static_cast<Class>(c))), Value(count[c])}));
  }
  return Value::list(std::move(list));
}

Result<Value> simplify_shape(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  ARESTA_TRY(const std::shared_ptr<Model> model, as_model(*x, call.context()));
  ARESTA_TRY(Extraction cleaned, simplify(*model));
  auto provenance = std::make_shared<Provenance>();
  provenance->sources = {model};
  const ExtractionMap& from = cleaned.from;
  for (std::size_t i = 0; i < from.vertices.size(); ++i) provenance->parents[VertexId(i)] = {{0, from.vertices[i]}};
  for (std::size_t i = 0; i < from.edges.size(); ++i) provenance->parents[EdgeId(i)] = {{0, from.edges[i]}};
  for (std::size_t i = 0; i < from.faces.size(); ++i) provenance->parents[FaceId(i)] = {{0, from.faces[i]}};
  for (std::size_t i = 1; i < from.regions.size(); ++i) {
    for (const RegionId r : from.regions[i]) {
      if (model->is_region(r)) provenance->parents[RegionId(i)].push_back({0, r});
    }
  }
  cleaned.model.provenance = std::move(provenance);
  inherit_labels(cleaned.model);
  ARESTA_CHECK(require_valid(cleaned.model, CheckLevel::fast, call.context()));
  return made(std::move(cleaned.model));
}

/// A plane, and a square face on it that reaches beyond the shape everywhere; none when the plane misses the shape.
struct CuttingPlane {
  Vec3 point, normal;
  std::shared_ptr<const Model> square;
  bool shape_is_above = false;  ///< where the plane misses it
};

Result<CuttingPlane> cutting_plane(Call& call, const Model& model) {
  Vec3 normal = call.point("normal");
  normal = normal / std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});  // its square is a number
  CuttingPlane plane{call.point("point"), normalized(normal), nullptr};
  Box3 box = model.bounds();
  // Centred near the shape, however far away `point` is.
  const Vec3 middle = box.empty() ? plane.point : box.centre();
  const double height = dot(middle - plane.point, plane.normal);
  if (std::abs(height) > box.diagonal() + 1) {
    plane.shape_is_above = height > 0;
    return plane;
  }
  const Frame frame = Frame::along(middle - height * plane.normal, plane.normal);
  const double reach = box.diagonal() + 1;
  const std::array<Vec3, 4> corners = {frame.to_world({-reach, -reach, 0}), frame.to_world({reach, -reach, 0}),
                                       frame.to_world({reach, reach, 0}), frame.to_world({-reach, reach, 0})};
  ARESTA_TRY(Model square, polygon(corners, {}, construct_options(call)));
  plane.square = std::make_shared<const Model>(std::move(square));
  return plane;
}

/// A point of an entity that shows on which side of a plane it lies, when the plane does not cross it.
Result<Vec3> point_of(const Model& model, EntityRef e) {
  switch (e.kind) {
    case EntityKind::vertex:
      return model.point(VertexId(e.index));
    case EntityKind::edge: {
      const Range range = model.range(EdgeId(e.index));
      return model.edge_point(EdgeId(e.index), 0.5 * (range.low + range.high));
    }
    case EntityKind::face: {
      ARESTA_TRY(const Vec2 uv, FaceTrim(model, FaceId(e.index)).interior_point());
      return model.surface(FaceId(e.index)).point(uv);
    }
    case EntityKind::region:
      return interior_point(model, RegionId(e.index));
  }
  return Vec3{};
}

/// Imprints the plane on the shape and shares its pieces out; what lies in the plane goes to both sides. Every region
/// is cut by itself: walls between regions stay.
Result<Value> cut_shape(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  ARESTA_TRY(const std::shared_ptr<Model> model, as_model(*x, call.context()));
  if (model->topology().vertex_count() == 0)
    return Value::tuple({Value(whole_shape(model)), Value(whole_shape(model))});
  ARESTA_TRY(const CuttingPlane plane, cutting_plane(call, *model));
  if (plane.square == nullptr) {
    const Value whole(whole_shape(model)), nothing(whole_shape(std::make_shared<Model>()));
    return plane.shape_is_above ? Value::tuple({whole, nothing}) : Value::tuple({nothing, whole});
  }
  FragmentOptions options;
  options.tolerance = call.session().tolerance;
  options.detect_regions = false;
  ARESTA_TRY(const Fragment pieces, fragment({model, plane.square}, options, call.context()));
  const auto all = std::make_shared<Model>(*pieces.model);
  inherit_labels(*all);
  std::array<std::vector<EntityRef>, 2> sides;
  for (const EntityRef e : all->listed()) {
    if (e.kind != EntityKind::region) {
      const auto parents = pieces.parents(e);
      const bool of_shape = std::any_of(parents.begin(), parents.end(),
                                        [&](const Parent& p) { return p.source == 0 && p.entity.kind == e.kind; });
      if (!of_shape) continue;
    }
    ARESTA_TRY(const Vec3 p, point_of(*all, e));
    const double height = dot(p - plane.point, plane.normal);
    if (height >= -all->tolerance()) sides[0].push_back(e);
    if (height <= all->tolerance()) sides[1].push_back(e);
  }
  std::vector<Value> halves;
  for (auto& side : sides) {
    ARESTA_TRY(std::shared_ptr<Model> half, as_model(ModelShape({{all, std::move(side)}}), call.context()));
    ARESTA_CHECK(require_valid(*half, CheckLevel::fast, call.context()));
    halves.emplace_back(whole_shape(std::move(half)));
  }
  return Value::tuple(std::move(halves));
}

Result<Value> section_shape(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  ARESTA_TRY(const std::shared_ptr<Model> model, as_model(*x, call.context()));
  if (model->topology().vertex_count() == 0) return Value(whole_shape(model));
  ARESTA_TRY(const CuttingPlane plane, cutting_plane(call, *model));
  if (plane.square == nullptr) return Value(whole_shape(std::make_shared<Model>()));
  BooleanOptions options;
  options.kind = BooleanKind::intersect;
  options.fragment.tolerance = call.session().tolerance;
  const std::vector<GroupSpec> groups = {whole_operand("shape", 0, *model), whole_operand("plane", 1, *plane.square)};
  auto result = boolean({model, plane.square}, groups, options, call.context());
  if (!result) return std::move(result).error();
  return made(std::move(result->model));
}

Command operation(std::string name, std::vector<Parameter> parameters, std::string doc, std::string example,
                  Function function) {
  for (const Parameter& p : {regularise, keep_partitions, internals}) parameters.push_back(p);
  return {.name = std::move(name),
          .group = "booleans",
          .parameters = std::move(parameters),
          .returns = "a new shape; the operands stay as they are",
          .doc = std::move(doc),
          .example = std::move(example),
          .errors = boolean_errors,
          .function = std::move(function)};
}

}  // namespace

void register_booleans(Registry& r) {
  const Parameter many{.name = "shapes",
                       .type = Type::shapes,
                       .doc = "solids, sheets, wires, points, entities of them, or groups",
                       .variadic = true};
  const Parameter a{.name = "a", .type = Type::shape}, b{.name = "b", .type = Type::shape};
  r.add(operation("union", {many},
                  "What is in any of the shapes; a + b is the regularised one. All shapes are decided at once, so that "
                  "their order does not matter.",
                  "union(block(2, 2, 2), cylinder(1, 3))",
                  [](Call& c) { return many_operands(c, BooleanKind::unite); }));
  r.add(operation("intersection", {many}, "What is in all of the shapes; a & b is the regularised one.",
                  "intersection(block(2, 2, 2), sphere(1))",
                  [](Call& c) { return many_operands(c, BooleanKind::intersect); }));
  r.add(operation("difference", {a, b}, "What is in a and not in b; a - b is the regularised one.",
                  "difference(block(2, 2, 2), cylinder(1, 3))",
                  [](Call& c) { return two_operands(c, BooleanKind::subtract); }));
  r.add(operation("symmetric_difference", {a, b}, "What is in one of the two and not in the other.",
                  "symmetric_difference(block(2, 2, 2), cylinder(1, 3))",
                  [](Call& c) { return two_operands(c, BooleanKind::symmetric_difference); }));
  r.add({.name = "fragment",
         .group = "booleans",
         .parameters = {many},
         .returns = "a shape in which everything meets only in shared faces, edges and vertices",
         .doc = "Imprints all shapes on one another, finds all regions and keeps all of them.",
         .example = "fragment(block(2, 2, 2), cylinder(1, 3))",
         .errors = {errors::no_operands, errors::imprint_failed, errors::label_conflict, errors::not_conserved},
         .function = [](Call& c) { return make_fragment(c, "shapes"); }});
  r.add({.name = "detect_regions",
         .group = "booleans",
         .parameters = {{.name = "faces", .type = Type::shapes, .doc = "sheets, or faces of models", .variadic = true}},
         .returns = "a shape with a region in every space that they enclose",
         .doc = "Finds the regions that faces enclose.",
         .example = "detect_regions(faces(block(1, 1, 1)))",
         .errors = {errors::imprint_failed},
         .function = [](Call& c) { return make_fragment(c, "faces"); }});
  r.add({.name = "simplify",
         .group = "booleans",
         .parameters = {{.name = "x", .type = Type::shape}},
         .returns = "a new shape of the same points",
         .doc = "Merges neighbouring faces on one surface and edges on one curve, where nothing else needs what is "
                "between them.",
         .example = "simplify(block(1, 1, 1) + block(1, 1, 1, at=(1, 0, 0)))",
         .function = simplify_shape});
  const Parameter x{.name = "x", .type = Type::shape};
  const Parameter point{.name = "point", .type = Type::point, .doc = "on the plane", .unit = "length"};
  const Parameter normal{.name = "normal", .type = Type::direction, .doc = "points to the side above"};
  r.add({.name = "cut",
         .group = "cutting",
         .parameters = {x, point, normal},
         .returns = "a pair of shapes: what is above the plane and what is below",
         .doc = "Cuts a shape in two by a plane.",
         .example = "above, below = cut(sphere(1), (0, 0, 0), (0, 0, 1))",
         .errors = boolean_errors,
         .function = cut_shape});
  r.add({.name = "section",
         .group = "cutting",
         .parameters = {x, point, normal},
         .returns = "a shape of faces, edges and vertices in the plane",
         .doc = "What of a shape lies in a plane.",
         .example = "area(section(sphere(1), (0, 0, 0), (0, 0, 1)))",
         .errors = boolean_errors,
         .function = section_shape});
  const Parameter kind{.name = "kind",
                       .type = Type::string,
                       .doc = "only entities of this kind",
                       .default_value = Value(),
                       .choices = {"vertex", "edge", "face"}};
  Parameter face_kind = kind;
  face_kind.default_value = "face";
  r.add({.name = "classes",
         .group = "measures",
         .parameters = {a, b, kind},
         .returns = "a list of pairs (entity, class)",
         .doc = "The class of every vertex, edge and face of two shapes against the other: AoutB, BoutA, INTERS, AinB, "
                "BinA.",
         .example = "for f, c in classes(a, b, kind=\"face\"): print(c, area(f))",
         .errors = boolean_errors,
         .function = [](Call& c) { return classes_of(c, false); }});
  r.add({.name = "class_counts",
         .group = "measures",
         .parameters = {a, b, face_kind},
         .returns = "a list of pairs (class, number)",
         .doc = "How many faces (or edges, or vertices) of two shapes are of each class.",
         .example = "class_counts(a, b)",
         .errors = boolean_errors,
         .function = [](Call& c) { return classes_of(c, true); }});
}

}  // namespace aresta::document
