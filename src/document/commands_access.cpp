// SPDX-License-Identifier: Apache-2.0
// Entities of shapes, names, attributes, groups, and where entities came from.
#include <algorithm>
#include <cmath>

#include "document/commands.h"
#include "document/counting.h"
#include "document/errors.h"
#include "document/shape.h"
#include "draw/color.h"
#include "draw/errors.h"
#include "model/query.h"

namespace aresta::document {

namespace {

const Parameter shape{.name = "x", .type = Type::shape};
const Parameter kind{
    .name = "kind", .type = Type::string, .default_value = "face", .choices = {"vertex", "edge", "face", "region"}};

EntityKind kind_of(const std::string& name) {
  for (const EntityKind k : {EntityKind::vertex, EntityKind::edge, EntityKind::face}) {
    if (name == to_string(k)) return k;
  }
  return EntityKind::region;
}

Result<ModelShapePtr> x_of(Call& call) {
  return model_shape(call, call.shape("x"), "x");
}

Result<Value> entities(Call& call, EntityKind of) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  std::vector<Value> list;
  for (const Part& part : x->parts()) {
    for (const EntityRef e : closure(part, of)) list.emplace_back(shape_of(part.model, {e}));
  }
  return Value::list(std::move(list));
}

Result<Value> named_part(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  const std::string& name = call.string("name");
  std::vector<Part> parts;
  std::vector<std::string> names;
  for (const Part& part : x->parts()) {
    const auto members = closure(part);
    const auto belongs = [&](EntityRef e) {
      const auto& of_kind = members[static_cast<std::size_t>(e.kind)];
      return std::binary_search(of_kind.begin(), of_kind.end(), e);
    };
    std::vector<EntityRef> found;
    for (const auto& [entity, attributes] : part.model->labels.attributes) {
      if (!belongs(entity)) continue;
      const std::string text = part.model->labels.name(entity);
      if (text.empty()) continue;
      names.push_back(text);
      if (text == name) found.push_back(entity);
    }
    for (const Group& group : part.model->labels.groups) {
      names.push_back(group.name);
      if (group.name != name) continue;
      std::copy_if(group.entities.begin(), group.entities.end(), std::back_inserter(found), belongs);
    }
    if (!found.empty()) parts.push_back({part.model, std::move(found)});
  }
  if (!parts.empty()) return Value(ShapePtr(std::make_shared<const ModelShape>(std::move(parts))));
  const std::string near = nearest_name(name, names);
  Error error{.code = errors::unknown_entity,
              .message = "part: nothing in the shape has the name '" + name + "'" +
                         (near.empty() ? "" : "; did you mean '" + near + "'?")};
  if (names.empty()) error.hint = "name(entity, \"" + name + "\") first";
  return error;
}

Result<Value> nearest_entity(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  const EntityKind of = kind_of(call.string("kind"));
  const Vec3 point = call.point("point");
  double best = std::numeric_limits<double>::infinity();
  std::shared_ptr<Model> model;
  EntityRef entity;
  for (const Part& part : x->parts()) {
    for (const EntityRef e : closure(part, of)) {
      ARESTA_CHECK(call.context().step(0, "nearest"));
      ARESTA_TRY(const double distance, distance_to(*part.model, e, point));
      if (distance >= best) continue;
      best = distance;
      model = part.model;
      entity = e;
    }
  }
  if (!model) return Error{errors::unknown_entity, std::string("nearest: the shape has no ") + to_string(of)};
  return Value(shape_of(std::move(model), {entity}));
}

Status set_label(Call& call, const std::string& key, const AttributeValue& value) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  for (const Part& part : x->parts()) {
    for (const EntityRef e : part.entities) part.model->labels.attributes[e][key] = value;
  }
  return {};
}

Result<Value> set_attribute(Call& call) {
  const Value& v = call["value"];
  AttributeValue value;
  if (v.is(Value::Kind::boolean)) {
    value = v.boolean();
  } else if (v.is_number() && std::isfinite(v.number())) {
    value = v.number();
  } else if (v.is(Value::Kind::string)) {
    value = v.string();
  } else {
    return Error{errors::command_type,
                 "attribute: value must be a number, a text, True or False, not " + given_text(v)};
  }
  const std::string& key = call.string("key");
  const auto* text = std::get_if<std::string>(&value);
  if ((key == "name" || key == "color") && text == nullptr)
    return Error{errors::command_type, "attribute: the value of \"" + key + "\" must be a text, not " + given_text(v)};
  if (key == "color") ARESTA_CHECK(draw::color_from_text(*text));
  ARESTA_CHECK(set_label(call, key, value));
  return call["x"];
}

Value value_of(const AttributeValue& value) {
  return std::visit([](const auto& v) { return Value(v); }, value);
}

Result<Value> attributes_of(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  std::vector<Value> list;
  for (const Part& part : x->parts()) {
    for (const EntityRef e : part.entities) {
      const auto found = part.model->labels.attributes.find(e);
      if (found == part.model->labels.attributes.end()) continue;
      for (const auto& [key, value] : found->second) {
        Value pair = Value::tuple({Value(key), value_of(value)});
        if (std::none_of(list.begin(), list.end(), [&](const Value& v) { return equal(v, pair); }))
          list.push_back(std::move(pair));
      }
    }
  }
  return Value::list(std::move(list));
}

/// Puts the group among its models' own, under its name, so that results, meshes and files carry it.
ShapePtr named_group(std::vector<Part> parts, const std::string& name) {
  auto group = std::make_shared<const ModelShape>(std::move(parts), name);
  if (!name.empty()) {
    for (const Part& part : group->parts()) {
      auto& groups = part.model->labels.groups;
      const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.name == name; });
      if (same != groups.end()) {
        same->entities = part.entities;
      } else {
        groups.push_back({name, part.entities});
      }
    }
  }
  return group;
}

Result<std::vector<Part>> parts_of(Call& call, const std::string& parameter) {
  std::vector<Part> parts;
  for (const ShapePtr& s : call.shapes(parameter)) {
    ARESTA_TRY(const ModelShapePtr x, model_shape(call, s, parameter));
    parts.insert(parts.end(), x->parts().begin(), x->parts().end());
  }
  return parts;
}

Result<Value> make_group(Call& call) {
  ARESTA_TRY(std::vector<Part> parts, parts_of(call, "shapes"));
  return Value(named_group(std::move(parts), call.string("name")));
}

Result<Value> change_group(Call& call, bool add) {
  ARESTA_TRY(const ModelShapePtr group, model_shape(call, call.shape("group"), "group"));
  ARESTA_TRY(std::vector<Part> change, parts_of(call, "shapes"));
  std::vector<Part> parts = group->parts();
  if (add) {
    parts.insert(parts.end(), change.begin(), change.end());
  } else {
    for (Part& part : parts) {
      for (const Part& gone : change) {
        if (gone.model != part.model) continue;
        std::erase_if(part.entities, [&](EntityRef e) {
          return std::find(gone.entities.begin(), gone.entities.end(), e) != gone.entities.end();
        });
      }
    }
  }
  return Value(named_group(std::move(parts), group->name()));
}

/// The entities that x came from, one shape each, of whatever models they are.
Result<Value> origin_of(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  std::vector<std::pair<std::shared_ptr<Model>, EntityRef>> found;
  for (const Part& part : x->parts()) {
    if (!part.model->provenance) continue;
    for (const EntityRef e : part.entities) {
      for (const Parent& p : part.model->provenance->of(e)) {
        // Labels of operands are edited through shapes, as those of any model.
        auto model = std::const_pointer_cast<Model>(part.model->provenance->sources[p.source]);
        const std::pair<std::shared_ptr<Model>, EntityRef> pair{std::move(model), p.entity};
        if (std::find(found.begin(), found.end(), pair) == found.end()) found.push_back(pair);
      }
    }
  }
  std::vector<Value> list;
  for (const auto& [model, entity] : found) list.emplace_back(shape_of(model, {entity}));
  return Value::list(std::move(list));
}

std::vector<Value> images_in(const ModelShape& x, const ModelShape& result) {
  std::vector<Value> list;
  for (const Part& target : result.parts()) {
    std::vector<EntityRef> found;
    for (const Part& part : x.parts()) {
      if (part.model == target.model) continue;
      for (const EntityRef e : part.entities) {
        const auto images = images_of(*target.model, *part.model, e);
        found.insert(found.end(), images.begin(), images.end());
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const EntityRef e : found) list.emplace_back(shape_of(target.model, {e}));
  }
  return list;
}

Result<Value> images(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, x_of(call));
  if (!call["result"].is_none()) {
    ARESTA_TRY(const ModelShapePtr result, model_shape(call, call.shape("result"), "result"));
    return Value::list(images_in(*x, *result));
  }
  // The latest result in which something of x is left.
  auto& made = call.session().made;
  for (auto it = made.rbegin(); it != made.rend(); ++it) {
    const auto result = std::dynamic_pointer_cast<const ModelShape>(it->lock());
    if (!result) continue;
    std::vector<Value> list = images_in(*x, *result);
    if (!list.empty()) return Value::list(std::move(list));
  }
  return Value::list({});
}

Command access(std::string name, std::vector<Parameter> parameters, std::string returns, std::string doc,
               std::string example, Function function) {
  return {.name = std::move(name),
          .group = "access",
          .parameters = std::move(parameters),
          .returns = std::move(returns),
          .doc = std::move(doc),
          .example = std::move(example),
          .function = std::move(function)};
}

}  // namespace

void register_access(Registry& r) {
  const struct {
    const char* name;
    EntityKind kind;
    const char* doc;
  } kinds[] = {
      {"faces", EntityKind::face, "The faces of a shape; of a region those that bound it and those inside it."},
      {"edges", EntityKind::edge, "The edges of a shape."},
      {"vertices", EntityKind::vertex, "The vertices of a shape."},
      {"regions", EntityKind::region, "The regions of a shape."}};
  for (const auto& k : kinds) {
    r.add(access(k.name, {shape}, "a list of shapes of the same model", k.doc,
                 std::string("len(") + k.name + "(block(1, 1, 1)))",
                 [of = k.kind](Call& c) { return entities(c, of); }));
  }
  r.add(access("components", {shape}, "a list of shapes", "The connected parts of a shape: what touches is one part.",
               "len(components(section(x, (0, 0, 1), (0, 0, 1))))", [](Call& c) -> Result<Value> {
                 ARESTA_TRY(const ModelShapePtr x, x_of(c));
                 std::vector<Value> list;
                 for (const Part& part : x->parts()) {
                   for (auto& entities_of_one : components(part))
                     list.emplace_back(shape_of(part.model, std::move(entities_of_one)));
                 }
                 return Value::list(std::move(list));
               }));
  const Parameter name{.name = "name", .type = Type::string};
  r.add(access("part", {shape, name}, "a shape", "What in a shape has a name, or is in the group of that name.",
               "part(plate, \"top\")", named_part));
  r.add(access("nearest", {shape, {.name = "point", .type = Type::point, .unit = "length"}, kind},
               "a shape of one entity", "The entity of a shape nearest to a point.",
               "nearest(block(1, 1, 1), (0.5, 0.5, 2), \"face\")", nearest_entity));
  r.add(access("name", {shape, {.name = "text", .type = Type::string}}, "the shape",
               "Gives the entities of a shape a name.", "name(nearest(b, (0, 0, 9), \"face\"), \"top\")",
               [](Call& c) -> Result<Value> {
                 ARESTA_CHECK(set_label(c, "name", c.string("text")));
                 return c["x"];
               }));
  Command attribute = access("attribute",
                             {shape,
                              {.name = "key", .type = Type::string},
                              {.name = "value",
                               .type = Type::any,
                               .doc = "a number, a text, True or False; of \"color\" a text like \"#ff8000\""}},
                             "the shape", "Gives the entities of a shape an attribute.",
                             "attribute(b, \"material\", \"steel\")", set_attribute);
  attribute.errors = {errors::draw_bad_color};
  r.add(std::move(attribute));
  r.add(access("attributes", {shape}, "a list of pairs (key, value)",
               "The attributes of the entities of a shape, the name among them.", "attributes(part(b, \"top\"))",
               attributes_of));
  r.add(access("origin", {shape}, "a list of shapes",
               "The entities that those of a shape came from, in the last operation.", "origin(faces(a + b)[0])",
               origin_of));
  r.add(access("images",
               {shape,
                {.name = "result",
                 .type = Type::shape,
                 .doc = "of operations on what x is of; left out: the latest",
                 .default_value = Value()}},
               "a list of shapes", "The entities of a result that came from those of a shape.",
               "images(part(a, \"top\"), union(a, b))", images));
  const Parameter shapes{.name = "shapes", .type = Type::shapes, .variadic = true};
  const Parameter group{.name = "group", .type = Type::shape};
  Command make = access("group",
                        {shapes,
                         {.name = "name",
                          .type = Type::string,
                          .doc = "carried on to results, meshes and files",
                          .default_value = "",
                          .keyword_only = true}},
                        "a shape that lists all of them", "Takes any entities, of several models too, as one operand.",
                        "group(solid, wire, name=\"A\")", make_group);
  make.group = "groups";
  r.add(std::move(make));
  for (const bool add : {true, false}) {
    Command change = access(add ? "group_add" : "group_remove", {group, shapes}, "the new group",
                            add ? "A group with more in it." : "A group with less in it.",
                            add ? "a = group_add(a, faces(b))" : "a = group_remove(a, faces(b))",
                            [add](Call& c) { return change_group(c, add); });
    change.group = "groups";
    r.add(std::move(change));
  }
}

}  // namespace aresta::document
