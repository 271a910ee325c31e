// SPDX-License-Identifier: Apache-2.0
#include "document/registry.h"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace aresta::document {

namespace {

std::string short_number(double x) {
  std::string text = number_text(x);
  if (text.size() > 2 && text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::vector<Vec3> as_points(const Value& list) {
  std::vector<Vec3> out;
  for (const Value& v : list.items()) {
    const auto& c = v.items();
    out.push_back({c[0].number(), c[1].number(), c[2].number()});
  }
  return out;
}

/// The range and choices of a parameter, in words; empty when it takes anything of its type.
std::string allowed_text(const Parameter& p) {
  std::string text;
  if (p.limits.any()) text = p.limits.text();
  for (std::size_t i = 0; i < p.choices.size(); ++i) {
    text += (i == 0 ? "one of '" : ", '") + p.choices[i] + "'";
  }
  return text;
}

}  // namespace

const char* type_text(Type type) {
  switch (type) {
    case Type::any:
      return "any value";
    case Type::boolean:
      return "True or False";
    case Type::integer:
      return "a whole number";
    case Type::number:
      return "a number";
    case Type::string:
      return "a text";
    case Type::sequence:
      return "a list";
    case Type::numbers:
      return "a list of numbers";
    case Type::point:
      return "a point (x, y, z)";
    case Type::direction:
      return "a direction (x, y, z) other than (0, 0, 0)";
    case Type::points:
      return "a list of points [(x, y, z), ...]";
    case Type::point_lists:
      return "a list of lists of points";
    case Type::index_loops:
      return "a list of faces, each a list of point numbers (from 0)";
    case Type::shape:
      return "a shape";
    case Type::shape_or_point:
      return "a shape or a point (x, y, z)";
    case Type::shapes:
      return "a shape or a list of shapes";
    case Type::command:
      return "the name of a command";
  }
  return "";
}

bool Limits::any() const {
  return low > -std::numeric_limits<double>::max() || high < std::numeric_limits<double>::max();
}

std::string Limits::text() const {
  const bool has_low = low > -std::numeric_limits<double>::max(), has_high = high < std::numeric_limits<double>::max();
  if (has_low && has_high) {
    return (low_open ? "greater than " + short_number(low) + " and at most "
                     : "between " + short_number(low) + " and ") +
           short_number(high);
  }
  if (has_low) return (low_open ? "greater than " : "at least ") + short_number(low);
  return "at most " + short_number(high);
}

const Value& Call::operator[](std::string_view name) const {
  const auto& parameters = command_.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == name) return arguments_[i];
  }
  assert(false && "the command declares no parameter of this name");
  static const Value none;
  return none;
}

bool Call::boolean(std::string_view name) const {
  return (*this)[name].boolean();
}

std::int64_t Call::integer(std::string_view name) const {
  const Value& v = (*this)[name];
  return v.is(Value::Kind::integer) ? v.integer() : static_cast<std::int64_t>(v.real());
}

Vec3 Call::point(std::string_view name) const {
  const auto& c = items(name);
  return {c[0].number(), c[1].number(), c[2].number()};
}

std::vector<double> Call::numbers(std::string_view name) const {
  std::vector<double> out;
  for (const Value& v : items(name)) out.push_back(v.number());
  return out;
}

std::vector<Vec3> Call::points(std::string_view name) const {
  return as_points((*this)[name]);
}

std::vector<std::vector<Vec3>> Call::point_lists(std::string_view name) const {
  std::vector<std::vector<Vec3>> out;
  for (const Value& v : items(name)) out.push_back(as_points(v));
  return out;
}

std::vector<std::vector<std::vector<std::size_t>>> Call::index_loops(std::string_view name) const {
  const auto loop = [](const Value& v) {
    std::vector<std::size_t> out;
    for (const Value& i : v.items()) out.push_back(static_cast<std::size_t>(i.integer()));
    return out;
  };
  std::vector<std::vector<std::vector<std::size_t>>> out;
  for (const Value& face : items(name)) {
    auto& loops = out.emplace_back();
    if (!face.items().empty() && face.items()[0].is_sequence()) {
      for (const Value& v : face.items()) loops.push_back(loop(v));
    } else {
      loops.push_back(loop(face));
    }
  }
  return out;
}

std::vector<ShapePtr> Call::shapes(std::string_view name) const {
  std::vector<ShapePtr> out;
  const auto add = [&out](const auto& self, const Value& v) -> void {
    if (v.is(Value::Kind::shape)) {
      out.push_back(v.shape());
    } else {
      for (const Value& item : v.items()) self(self, item);
    }
  };
  add(add, (*this)[name]);
  return out;
}

std::string Command::signature() const {
  std::string text = name + "(";
  bool first = true, star_seen = false;
  for (const Parameter& p : parameters) {
    if (!first) text += ", ";
    first = false;
    if (p.keyword_only && !star_seen) {
      text += "*, ";
      star_seen = true;
    }
    if (p.variadic) {
      text += "*";
      star_seen = true;
    }
    text += p.name;
    if (p.default_value && !p.variadic) text += "=" + repr(*p.default_value);
  }
  return text + ")";
}

void Registry::add(Command command) {
  assert(!command.name.empty() && find(command.name) == nullptr && find_constant(command.name) == nullptr);
  assert(command.function != nullptr && !command.doc.empty());
  if (std::find(groups_.begin(), groups_.end(), command.group) == groups_.end()) groups_.push_back(command.group);
  std::string name = command.name;
  commands_.emplace(std::move(name), std::move(command));
}

void Registry::add(Constant constant) {
  assert(find(constant.name) == nullptr);
  std::string name = constant.name;
  constants_.emplace(std::move(name), std::move(constant));
}

const Command* Registry::find(std::string_view name) const {
  const auto found = commands_.find(name);
  return found == commands_.end() ? nullptr : &found->second;
}

const Constant* Registry::find_constant(std::string_view name) const {
  const auto found = constants_.find(name);
  return found == constants_.end() ? nullptr : &found->second;
}

std::string Registry::help(const Command& command) {
  std::string text = command.signature() + "\n\n" + command.doc + "\n";
  if (!command.parameters.empty()) text += "\nParameters:\n";
  for (const Parameter& p : command.parameters) {
    text += "  " + p.name + ": " + (p.variadic ? "any number, each " : "") + type_text(p.type);
    if (p.size > 0) text += " of " + std::to_string(p.size);
    if (const std::string allowed = allowed_text(p); !allowed.empty()) text += ", " + allowed;
    if (!p.unit.empty()) text += " [" + p.unit + "]";
    if (p.default_value && !p.variadic) {
      text += p.default_value->is_none() ? "; may be left out" : "; default " + repr(*p.default_value);
    }
    text += "\n";
    if (!p.doc.empty()) text += "      " + p.doc + "\n";
  }
  if (!command.returns.empty()) text += "\nGives " + command.returns + ".\n";
  if (!command.example.empty()) text += "\nExample:\n  " + command.example + "\n";
  if (!command.errors.empty()) {
    text += "\nErrors:";
    for (const ErrorCode& code : command.errors) text += std::string(" ") + code.name;
    text += "\n";
  }
  return text;
}

namespace {

/// Shapes that are gone are dropped whenever the list has doubled.
void remember(std::vector<std::weak_ptr<const Shape>>& made, const ShapePtr& shape) {
  if (made.size() >= 1024 && (made.size() & (made.size() - 1)) == 0) {
    std::erase_if(made, [](const auto& weak) { return weak.expired(); });
  }
  made.push_back(shape);
}

}  // namespace

Result<Value> invoke(const Command& command, Arguments arguments, Session& session) {
  ARESTA_TRY(std::vector<Value> bound, bind(command, std::move(arguments)));
  Call call(command, std::move(bound), session);
  if (command.of_the_language()) return command.function(call);
  const auto start = std::chrono::steady_clock::now();
  Result<Value> result = command.function(call);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (result && result->is(Value::Kind::shape)) remember(session.made, result->shape());
  if (session.finished) session.finished(command, taken.count(), result ? &*result : nullptr);
  return result;
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& names) {
  if (name.empty() || name.size() > 64) return {};
  std::string best;
  std::size_t best_distance = name.size() <= 3 ? 2 : name.size() / 3 + 1;  // below this is near enough
  for (const std::string& candidate : names) {
    if (candidate.size() > 64) continue;
    // Levenshtein distance with neighbouring letters swapped counted once, one row at a time.
    std::vector<std::size_t> before, row(candidate.size() + 1), above;
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= name.size(); ++i) {
      before = std::move(above);
      above = row;
      row[0] = i;
      for (std::size_t j = 1; j < row.size(); ++j) {
        const bool same = name[i - 1] == candidate[j - 1];
        row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
        if (i > 1 && j > 1 && name[i - 1] == candidate[j - 2] && name[i - 2] == candidate[j - 1]) {
          row[j] = std::min(row[j], before[j - 2] + 1);
        }
      }
    }
    if (row.back() < best_distance) {
      best_distance = row.back();
      best = candidate;
    }
  }
  return best;
}

}  // namespace aresta::document
