// SPDX-License-Identifier: Apache-2.0
#include "document/construction.h"

namespace aresta::document {

namespace {

bool declares(const Call& call, std::string_view name) {
  for (const Parameter& p : call.command().parameters) {
    if (p.name == name) return true;
  }
  return false;
}

}  // namespace

Parameter length(std::string name, std::string doc) {
  return {.name = std::move(name), .type = Type::number, .doc = std::move(doc), .unit = "length", .limits = positive};
}

Parameter size(std::string name, std::string doc) {
  return {
      .name = std::move(name), .type = Type::number, .doc = std::move(doc), .unit = "length", .limits = not_negative};
}

Parameter at(std::string doc) {
  return {.name = "at",
          .type = Type::point,
          .doc = std::move(doc),
          .unit = "length",
          .default_value = Value::tuple({0, 0, 0})};
}

Parameter axis() {
  return {.name = "axis",
          .type = Type::direction,
          .doc = "the direction that it stands in",
          .default_value = Value::tuple({0, 0, 1})};
}

Parameter names() {
  return {.name = "names",
          .type = Type::boolean,
          .doc = "name the faces by what they are: bottom, top, side ...",
          .default_value = false,
          .keyword_only = true};
}

std::vector<Parameter> standing() {
  return {at("where its base stands"), axis(), names()};
}

std::vector<Parameter> round() {
  return {at("where its base or centre is"),
          axis(),
          {.name = "patches",
           .type = Type::integer,
           .doc = "into how many faces the round side is split",
           .default_value = 1,
           .limits = {1, 1000}},
          {.name = "seam",
           .type = Type::number,
           .doc = "turns the first seam about the axis",
           .unit = "degrees",
           .default_value = 0},
          names()};
}

ConstructOptions construct_options(const Call& call) {
  return {.tolerance = call.session().tolerance, .names = declares(call, "names") && call.boolean("names")};
}

Placement placement(const Call& call) {
  return {call.point("at"), call.point("axis")};
}

Patches patches(const Call& call) {
  return {static_cast<int>(call.integer("patches")), call.number("seam")};
}

Result<Value> made(Result<Model> model) {
  if (!model) return std::move(model).error();
  return Value(whole_shape(std::move(*model)));
}

}  // namespace aresta::document
