// SPDX-License-Identifier: Apache-2.0
// Arguments against declarations: the one place where they are checked.
#include <algorithm>
#include <cmath>

#include "document/errors.h"
#include "document/registry.h"

namespace aresta::document {

namespace {

Error wrong(const ErrorCode& code, const Command& command, std::string message) {
  return {.code = code, .message = std::move(message), .hint = command.signature()};
}

/// "block: parameter dx: expected ..., given ...".
Error wrong_value(const ErrorCode& code, const Command& command, const Parameter& p, const std::string& part,
                  const std::string& expected, const Value& given) {
  return {.code = code,
          .message = command.name + ": " + p.name + part + " must be " + expected + ", not " +
                     (code == errors::command_type ? given_text(given) : repr(given, Digits::shortest, 60))};
}

/// Checks one number and its range. A whole number too large for a double is no trouble: 64 bits always fit.
Status check_number(const Command& c, const Parameter& p, const std::string& part, const Value& v, bool whole) {
  if (!v.is_number()) {
    return wrong_value(errors::command_type, c, p, part, whole ? "a whole number" : "a number", v);
  }
  const double x = v.number();
  if (!std::isfinite(x)) return wrong_value(errors::command_not_finite, c, p, part, "a finite number", v);
  if (whole && v.is(Value::Kind::real) && (x != std::floor(x) || std::abs(x) > 9007199254740992.0)) {
    return wrong_value(errors::command_type, c, p, part, "a whole number", v);
  }
  if (!p.limits.holds(x)) return wrong_value(errors::command_range, c, p, part, p.limits.text(), v);
  return {};
}

Status check_numbers(const Command& c, const Parameter& p, const std::string& part, const Value& v, std::size_t size,
                     const char* expected) {
  if (!v.is_sequence()) return wrong_value(errors::command_type, c, p, part, expected, v);
  const auto& items = v.items();
  if (size > 0 && items.size() != size) {
    return wrong_value(errors::command_type, c, p, part,
                       std::string(expected) + " of " + std::to_string(size) + " numbers (it has " +
                           std::to_string(items.size()) + ")",
                       v);
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    ARESTA_CHECK(check_number(c, p, part + "[" + std::to_string(i) + "]", items[i], false));
  }
  return {};
}

Status check_point(const Command& c, const Parameter& p, const std::string& part, const Value& v,
                   const char* expected) {
  if (!v.is_sequence() || v.items().size() != 3) return wrong_value(errors::command_type, c, p, part, expected, v);
  return check_numbers(c, p, part, v, 3, expected);
}

/// A point of space: squares of what is farther out than 1e30 and their products are no numbers any more.
Status check_place(const Command& c, const Parameter& p, const std::string& part, const Value& v,
                   const char* expected) {
  constexpr double farthest = 1e30;
  ARESTA_CHECK(check_point(c, p, part, v, expected));
  for (const Value& x : v.items()) {
    if (std::abs(x.number()) > farthest)
      return wrong_value(errors::command_range, c, p, part, "a point with coordinates of at most 1e30", v);
  }
  return {};
}

Status check_points(const Command& c, const Parameter& p, const std::string& part, const Value& v) {
  if (!v.is_sequence()) return wrong_value(errors::command_type, c, p, part, type_text(Type::points), v);
  const auto& items = v.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    ARESTA_CHECK(check_place(c, p, part + "[" + std::to_string(i) + "]", items[i], type_text(Type::point)));
  }
  return {};
}

/// Point numbers of one loop.
Status check_loop(const Command& c, const Parameter& p, const std::string& part, const Value& v) {
  if (!v.is_sequence()) return wrong_value(errors::command_type, c, p, part, "a list of point numbers", v);
  for (std::size_t i = 0; i < v.items().size(); ++i) {
    const Value& n = v.items()[i];
    if (!n.is(Value::Kind::integer) || n.integer() < 0) {
      return wrong_value(errors::command_type, c, p, part + "[" + std::to_string(i) + "]",
                         "the number of a point, from 0", n);
    }
  }
  return {};
}

Status check_shapes(const Command& c, const Parameter& p, const std::string& part, const Value& v) {
  if (v.is(Value::Kind::shape)) return {};
  if (!v.is_sequence()) return wrong_value(errors::command_type, c, p, part, type_text(Type::shapes), v);
  const auto& items = v.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].is(Value::Kind::shape)) {
      return wrong_value(errors::command_type, c, p, part + "[" + std::to_string(i) + "]", "a shape", items[i]);
    }
  }
  return {};
}

Status check(const Command& c, const Parameter& p, const std::string& part, const Value& v) {
  using Kind = Value::Kind;
  const auto expect_kind = [&](bool ok) -> Status {
    if (ok) return {};
    return wrong_value(errors::command_type, c, p, part, type_text(p.type), v);
  };
  switch (p.type) {
    case Type::any:
      return {};
    case Type::boolean:
      return expect_kind(v.is(Kind::boolean));
    case Type::integer:
      return check_number(c, p, part, v, true);
    case Type::number:
      return check_number(c, p, part, v, false);
    case Type::string: {
      ARESTA_CHECK(expect_kind(v.is(Kind::string)));
      if (!p.choices.empty() && std::find(p.choices.begin(), p.choices.end(), v.string()) == p.choices.end()) {
        std::string expected;
        for (const std::string& choice : p.choices) expected += (expected.empty() ? "one of '" : ", '") + choice + "'";
        Error error = wrong_value(errors::command_range, c, p, part, expected, v);
        if (const std::string near = nearest_name(v.string(), p.choices); !near.empty()) error.hint = "'" + near + "'";
        return error;
      }
      return {};
    }
    case Type::sequence:
      return expect_kind(v.is_sequence() || v.is(Kind::range));
    case Type::numbers:
      return check_numbers(c, p, part, v, p.size, "a list");
    case Type::point:
      return check_place(c, p, part, v, type_text(Type::point));
    case Type::direction: {
      ARESTA_CHECK(check_point(c, p, part, v, type_text(Type::direction)));
      const auto& d = v.items();
      if (d[0].number() == 0 && d[1].number() == 0 && d[2].number() == 0) {
        return wrong_value(errors::command_range, c, p, part, type_text(Type::direction), v);
      }
      return {};
    }
    case Type::points:
      return check_points(c, p, part, v);
    case Type::point_lists: {
      ARESTA_CHECK(expect_kind(v.is_sequence()));
      const auto& items = v.items();
      for (std::size_t i = 0; i < items.size(); ++i) {
        ARESTA_CHECK(check_points(c, p, part + "[" + std::to_string(i) + "]", items[i]));
      }
      return {};
    }
    case Type::index_loops: {
      ARESTA_CHECK(expect_kind(v.is_sequence()));
      const auto& items = v.items();
      for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string place = part + "[" + std::to_string(i) + "]";
        const bool several = items[i].is_sequence() && !items[i].items().empty() && items[i].items()[0].is_sequence();
        if (!several) {
          ARESTA_CHECK(check_loop(c, p, place, items[i]));
          continue;
        }
        for (std::size_t k = 0; k < items[i].items().size(); ++k) {
          ARESTA_CHECK(check_loop(c, p, place + "[" + std::to_string(k) + "]", items[i].items()[k]));
        }
      }
      return {};
    }
    case Type::shape:
      return expect_kind(v.is(Kind::shape));
    case Type::shape_or_point: {
      if (v.is(Kind::shape)) return {};
      return check_place(c, p, part, v, type_text(Type::shape_or_point));
    }
    case Type::shapes:
      return check_shapes(c, p, part, v);
    case Type::command:
      return expect_kind(v.is(Kind::command));
  }
  return {};
}

bool may_be_none(const Parameter& p) {
  return p.default_value && p.default_value->is_none();
}

}  // namespace

Result<std::vector<Value>> bind(const Command& command, Arguments arguments) {
  const auto& parameters = command.parameters;
  std::vector<Value> bound(parameters.size());
  std::vector<bool> given(parameters.size(), false);

  std::size_t next = 0;
  std::size_t places = 0;
  for (const Parameter& p : parameters) places += !p.variadic && !p.keyword_only;
  for (std::size_t i = 0; i < parameters.size() && next < arguments.positional.size(); ++i) {
    const Parameter& p = parameters[i];
    if (p.keyword_only) continue;
    given[i] = true;
    if (p.variadic) {
      std::vector<Value> rest(std::make_move_iterator(arguments.positional.begin() + static_cast<std::ptrdiff_t>(next)),
                              std::make_move_iterator(arguments.positional.end()));
      next = arguments.positional.size();
      bound[i] = Value::tuple(std::move(rest));
    } else {
      bound[i] = std::move(arguments.positional[next++]);
    }
  }
  if (next < arguments.positional.size()) {
    return wrong(errors::command_too_many, command,
                 command.name + " takes " + (places == 0 ? "no" : "at most " + std::to_string(places)) +
                     (places == 1 ? " argument, " : " arguments, ") + std::to_string(arguments.positional.size()) +
                     (arguments.positional.size() == 1 ? " was given" : " were given"));
  }

  for (auto& [name, value] : arguments.keywords) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&name = name](const Parameter& p) { return p.name == name && !p.variadic; });
    if (found == parameters.end()) {
      std::vector<std::string> names;
      for (const Parameter& p : parameters) {
        if (!p.variadic) names.push_back(p.name);
      }
      const std::string near = nearest_name(name, names);
      Error error = wrong(errors::command_unknown_parameter, command,
                          command.name + " has no parameter '" + name + "'" +
                              (near.empty() ? std::string() : "; did you mean '" + near + "'?"));
      return error;
    }
    const auto i = static_cast<std::size_t>(found - parameters.begin());
    if (given[i]) {
      return wrong(errors::command_repeated, command, command.name + ": '" + name + "' is given twice");
    }
    given[i] = true;
    bound[i] = std::move(value);
  }

  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    if (!given[i]) {
      if (p.variadic) {
        bound[i] = Value::tuple({});
      } else if (p.default_value) {
        bound[i] = *p.default_value;
      } else {
        return wrong(errors::command_missing, command,
                     command.name + ": '" + p.name + "' is missing: " + type_text(p.type));
      }
      continue;
    }
    if (p.variadic) {
      const auto& rest = bound[i].items();
      for (std::size_t k = 0; k < rest.size(); ++k) {
        ARESTA_CHECK(check(command, p, "[" + std::to_string(k) + "]", rest[k]));
      }
    } else if (!(bound[i].is_none() && may_be_none(p))) {
      ARESTA_CHECK(check(command, p, "", bound[i]));
    }
  }
  return bound;
}

}  // namespace aresta::document
