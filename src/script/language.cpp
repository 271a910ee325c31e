// SPDX-License-Identifier: Apache-2.0
// The language's own commands: those of Python that scripts need.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "script/errors.h"
#include "script/interpreter.h"
#include "script/operators.h"

namespace aresta::script {

using document::Call;
using document::Parameter;
using document::Registry;
using document::Type;
using document::Value;
using Kind = Value::Kind;

namespace {

const Parameter any_value{.name = "x", .type = Type::any};

Parameter optional(std::string name, Type type, Value value, std::string doc = {}) {
  return {.name = std::move(name), .type = type, .doc = std::move(doc), .default_value = std::move(value)};
}

Result<Value> print(Call& call) {
  std::string text;
  const std::string& separator = call.string("sep");
  bool first = true;
  for (const Value& v : call.items("values")) {
    if (!first) text += separator;
    first = false;
    text += document::display(v, call.session().digits);
    if (text.size() > max_text) return Error{errors::script_too_large, "the text to print is too long"};
  }
  text += call.string("end");
  if (call.session().print) ARESTA_CHECK(call.session().print(text));
  return Value();
}

Result<Value> range(Call& call) {
  std::vector<std::int64_t> n;
  for (const Value& v : call.items("numbers"))
    n.push_back(v.is(Kind::integer) ? v.integer() : static_cast<std::int64_t>(v.real()));
  if (n.empty() || n.size() > 3)
    return Error{errors::script_type,
                 "range takes one to three whole numbers: range(stop), range(start, stop), range(start, stop, step)"};
  if (n.size() == 3 && n[2] == 0) return Error{errors::script_value, "the step of a range cannot be 0"};
  if (n.size() == 1) return Value(document::IntegerRange{0, n[0], 1});
  return Value(document::IntegerRange{n[0], n[1], n.size() == 3 ? n[2] : 1});
}

Result<Value> sum(Call& call) {
  ARESTA_TRY(const std::vector<Value> items, items_of(call["items"]));
  Value total = call["start"];
  for (const Value& v : items) ARESTA_CHECK(binary(Op::add, total, v, call.session(), total));
  return total;
}

/// key(item), or the item itself.
Result<Value> key_of(Call& call, const Value& item) {
  if (call["key"].is_none()) return item;
  return document::invoke(*call["key"].command(), {.positional = {item}}, call.session());
}

Result<Value> extreme(Call& call, bool largest) {
  std::vector<Value> items = call.items("values");
  if (items.size() == 1) {
    ARESTA_TRY(items, items_of(Value(items[0])));
  }
  if (items.empty()) return Error{errors::script_value, call.command().name + " of nothing"};
  std::size_t best = 0;
  ARESTA_TRY(Value best_key, key_of(call, items[0]));
  for (std::size_t i = 1; i < items.size(); ++i) {
    ARESTA_TRY(Value key, key_of(call, items[i]));
    bool better = false;
    ARESTA_CHECK(largest ? less(best_key, key, better) : less(key, best_key, better));
    if (better) {
      best = i;
      best_key = std::move(key);
    }
  }
  return items[best];
}

Result<Value> sorted(Call& call) {
  ARESTA_TRY(std::vector<Value> items, items_of(call["items"]));
  std::vector<std::pair<Value, std::size_t>> keys;
  for (std::size_t i = 0; i < items.size(); ++i) {
    ARESTA_TRY(Value key, key_of(call, items[i]));
    keys.emplace_back(std::move(key), i);
  }
  // Merging, not std::sort: a comparison may fail or be no order, and equal items keep their order.
  const bool reverse = call.boolean("reverse");
  std::vector<std::pair<Value, std::size_t>> merged(keys.size());
  for (std::size_t width = 1; width < keys.size(); width *= 2) {
    for (std::size_t low = 0; low < keys.size(); low += 2 * width) {
      const std::size_t middle = std::min(low + width, keys.size()), high = std::min(low + 2 * width, keys.size());
      std::size_t a = low, b = middle;
      for (std::size_t k = low; k < high; ++k) {
        bool take_b = a == middle;
        if (a < middle && b < high) {
          ARESTA_CHECK(reverse ? less(keys[a].first, keys[b].first, take_b)
                               : less(keys[b].first, keys[a].first, take_b));
        }
        merged[k] = std::move(keys[take_b ? b++ : a++]);
      }
    }
    keys.swap(merged);
    ARESTA_CHECK(call.context().step(0, "sorted"));
  }
  std::vector<Value> out;
  out.reserve(items.size());
  for (const auto& [key, i] : keys) out.push_back(std::move(items[i]));
  return Value::list(std::move(out));
}

Result<Value> to_int(Call& call) {
  const Value& x = call["x"];
  if (x.is(Kind::integer)) return x;
  if (x.is(Kind::boolean)) return Value(std::int64_t{x.boolean()});
  if (x.is(Kind::real)) {
    if (!std::isfinite(x.real()) || std::abs(x.real()) >= 9223372036854775808.0) {
      return Error{errors::script_overflow, document::repr(x) + " does not fit in a whole number of 64 bits"};
    }
    return Value(static_cast<std::int64_t>(x.real()));
  }
  if (x.is(Kind::string)) {
    std::string text = x.string();
    const auto first = text.find_first_not_of(" \t\n"), last = text.find_last_not_of(" \t\n");
    if (first != std::string::npos) text = text.substr(first, last - first + 1);
    std::int64_t value = 0;
    const char* begin = text.data() + (text.starts_with("+") && text.size() > 1 && text[1] != '-' ? 1 : 0);
    const auto r = std::from_chars(begin, text.data() + text.size(), value);
    if (r.ec == std::errc() && r.ptr == text.data() + text.size()) return Value(value);
    return Error{errors::script_value,
                 "the text " + document::repr(x, document::Digits::shortest, 60) + " is no whole number"};
  }
  return Error{errors::script_type, "int takes a number or a text, not " + document::given_text(x)};
}

Result<Value> to_float(Call& call) {
  const Value& x = call["x"];
  if (x.is_number()) return Value(x.number());
  if (x.is(Kind::boolean)) return Value(x.boolean() ? 1.0 : 0.0);
  if (x.is(Kind::string)) {
    std::string text = x.string();
    const auto first = text.find_first_not_of(" \t\n"), last = text.find_last_not_of(" \t\n");
    if (first != std::string::npos) text = text.substr(first, last - first + 1);
    double value = 0;
    const char* begin = text.data() + (text.starts_with("+") && text.size() > 1 && text[1] != '-' ? 1 : 0);
    const auto r = std::from_chars(begin, text.data() + text.size(), value);
    if (r.ec == std::errc() && r.ptr == text.data() + text.size() && std::isfinite(value)) return Value(value);
    return Error{errors::script_value,
                 "the text " + document::repr(x, document::Digits::shortest, 60) + " is no number"};
  }
  return Error{errors::script_type, "float takes a number or a text, not " + document::given_text(x)};
}

Result<Value> enumerate(Call& call) {
  ARESTA_TRY(std::vector<Value> items, items_of(call["items"]));
  std::int64_t i = call.integer("start");
  for (Value& v : items) {
    v = Value::tuple({Value(i), std::move(v)});
    if (__builtin_add_overflow(i, std::int64_t{1}, &i))
      return Error{errors::script_overflow, "the numbers of enumerate do not fit in 64 bits"};
  }
  return Value::list(std::move(items));
}

Result<Value> zip(Call& call) {
  std::vector<std::vector<Value>> columns;
  for (const Value& v : call.items("lists")) {
    ARESTA_TRY(std::vector<Value> items, items_of(v));
    columns.push_back(std::move(items));
  }
  std::size_t n = columns.empty() ? 0 : columns[0].size();
  for (const auto& c : columns) n = std::min(n, c.size());
  std::vector<Value> rows;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Value> row;
    for (const auto& c : columns) row.push_back(c[i]);
    rows.push_back(Value::tuple(std::move(row)));
  }
  return Value::list(std::move(rows));
}

Result<Value> all_or_any(Call& call, bool all) {
  ARESTA_TRY(const std::vector<Value> items, items_of(call["items"]));
  for (const Value& v : items) {
    if (document::truth(v) != all) return Value(!all);
  }
  return Value(all);
}

/// |value - expected| within the larger of rel * |expected| and abs, item by item for lists.
Status compare_expected(const Value& value, const Value& expected, double rel, double abs, const std::string& part,
                        int depth) {
  const auto fail = [&](const std::string& why) {
    return Error{errors::script_expectation, "expected " + document::repr(expected, document::Digits::seventeen, 200) +
                                                 ", got " + document::repr(value, document::Digits::seventeen, 200) +
                                                 part + why};
  };
  if (depth > 100) return fail(": nested too deeply to compare");
  if (value.is_number() && expected.is_number()) {
    const double difference = std::abs(value.number() - expected.number());
    const double allowed = std::max(rel * std::abs(expected.number()), abs);
    if (difference <= allowed || document::equal(value, expected)) return {};
    std::string why = " (off by " + document::number_text(difference);
    if (expected.number() != 0) why += ", relative " + document::number_text(difference / std::abs(expected.number()));
    return fail(why + "; allowed " + document::number_text(allowed) + ")");
  }
  if (value.is_sequence() && expected.is_sequence()) {
    const auto &v = value.items(), &e = expected.items();
    if (v.size() != e.size())
      return fail(": " + std::to_string(v.size()) + " items instead of " + std::to_string(e.size()));
    for (std::size_t i = 0; i < v.size(); ++i) {
      ARESTA_CHECK(compare_expected(v[i], e[i], rel, abs, part + " in item " + std::to_string(i), depth + 1));
    }
    return {};
  }
  if (document::equal(value, expected)) return {};
  return fail("");
}

void register_values(Registry& r) {
  r.add({.name = "print",
         .group = "language",
         .parameters = {{.name = "values", .type = Type::any, .variadic = true},
                        {.name = "sep",
                         .type = Type::string,
                         .doc = "stands between the values",
                         .default_value = " ",
                         .keyword_only = true},
                        {.name = "end",
                         .type = Type::string,
                         .doc = "stands after them",
                         .default_value = "\n",
                         .keyword_only = true}},
         .doc = "Prints values. Numbers carry 17 significant digits when the output is not a terminal.",
         .example = "print(\"volume\", volume(block(1, 2, 3)))",
         .errors = {errors::script_too_large},
         .function = print});
  r.add({.name = "len",
         .group = "language",
         .parameters = {any_value},
         .returns = "how many items a list, tuple, range or text has",
         .doc = "Counts items.",
         .example = "len(faces(block(1, 1, 1)))",
         .errors = {errors::script_type},
         .function = [](Call& c) -> Result<Value> {
           ARESTA_TRY(const std::uint64_t n, length(c["x"]));
           if (n > INT64_MAX) return Error{errors::script_overflow, "the length does not fit in 64 bits"};
           return Value(static_cast<std::int64_t>(n));
         }});
  r.add({.name = "range",
         .group = "language",
         .parameters = {{.name = "numbers", .type = Type::integer, .variadic = true}},
         .returns = "the whole numbers from start (0) up to, not including, stop, by step (1)",
         .doc = "Counts: range(stop), range(start, stop) or range(start, stop, step).",
         .example = "for i in range(3): print(i)",
         .errors = {errors::script_type, errors::script_value},
         .function = range});
  r.add({.name = "sum",
         .group = "language",
         .parameters = {{.name = "items", .type = Type::any}, optional("start", Type::any, 0)},
         .returns = "start and all items added up",
         .doc = "Adds up the items of a list.",
         .example = "sum([volume(x) for x in regions(m)])",
         .errors = {errors::script_type, errors::script_overflow},
         .function = sum});
  for (const bool largest : {false, true}) {
    r.add({.name = largest ? "max" : "min",
           .group = "language",
           .parameters = {{.name = "values", .type = Type::any, .variadic = true},
                          {.name = "key",
                           .type = Type::command,
                           .doc = "compare by what this command gives for each",
                           .default_value = Value(),
                           .keyword_only = true}},
           .returns = largest ? "the largest" : "the smallest",
           .doc = largest ? "The largest of several values, or of the items of a list."
                          : "The smallest of several values, or of the items of a list.",
           .example = largest ? "max(faces(x), key=area)" : "min(3, 1, 2)",
           .errors = {errors::script_type, errors::script_value},
           .function = [largest](Call& c) { return extreme(c, largest); }});
    r.add({.name = largest ? "all" : "any",
           .group = "language",
           .parameters = {{.name = "items", .type = Type::any}},
           .returns = "True or False",
           .doc = largest ? "Are all items true?" : "Is any item true?",
           .example = largest ? "all([v > 0 for v in [1, 2]])" : "any([v > 1 for v in [1, 2]])",
           .errors = {errors::script_type},
           .function = [largest](Call& c) { return all_or_any(c, largest); }});
  }
  r.add({.name = "sorted",
         .group = "language",
         .parameters = {{.name = "items", .type = Type::any},
                        {.name = "key",
                         .type = Type::command,
                         .doc = "sort by what this command gives for each",
                         .default_value = Value(),
                         .keyword_only = true},
                        {.name = "reverse",
                         .type = Type::boolean,
                         .doc = "the largest first",
                         .default_value = false,
                         .keyword_only = true}},
         .returns = "a sorted list; equal items keep their order",
         .doc = "Sorts the items of a list.",
         .example = "sorted(faces(x), key=area, reverse=True)",
         .errors = {errors::script_type},
         .function = sorted});
  r.add({.name = "str",
         .group = "language",
         .parameters = {any_value},
         .returns = "a text",
         .doc = "A value as text.",
         .example = "str(3.5)",
         .function = [](Call& c) -> Result<Value> { return Value(document::display(c["x"])); }});
  r.add({.name = "repr",
         .group = "language",
         .parameters = {any_value},
         .returns = "a text",
         .doc = "A value as one would type it.",
         .example = "repr(\"a\")",
         .function = [](Call& c) -> Result<Value> { return Value(document::repr(c["x"])); }});
  r.add({.name = "int",
         .group = "language",
         .parameters = {any_value},
         .returns = "a whole number",
         .doc = "A number cut to a whole one, or a text read as one.",
         .example = "int(3.7)",
         .errors = {errors::script_type, errors::script_value, errors::script_overflow},
         .function = to_int});
  r.add({.name = "float",
         .group = "language",
         .parameters = {any_value},
         .returns = "a real number",
         .doc = "A number, or a text read as one, as a real number.",
         .example = "float(\"2.5\")",
         .errors = {errors::script_type, errors::script_value},
         .function = to_float});
  r.add({.name = "bool",
         .group = "language",
         .parameters = {any_value},
         .returns = "True or False",
         .doc = "False for None, False, 0, and whatever is empty; True for all else.",
         .example = "bool([])",
         .function = [](Call& c) -> Result<Value> { return Value(document::truth(c["x"])); }});
  for (const bool is_list : {true, false}) {
    r.add({.name = is_list ? "list" : "tuple",
           .group = "language",
           .parameters = {{.name = "items", .type = Type::any, .default_value = Value::tuple({})}},
           .returns = is_list ? "a new list" : "a tuple",
           .doc = is_list ? "The items as a new list." : "The items as a tuple.",
           .example = is_list ? "list(range(3))" : "tuple([1, 2])",
           .errors = {errors::script_type, errors::script_too_large},
           .function = [is_list](Call& c) -> Result<Value> {
             ARESTA_TRY(std::vector<Value> items, items_of(c["items"]));
             return is_list ? Value::list(std::move(items)) : Value::tuple(std::move(items));
           }});
  }
  r.add({.name = "enumerate",
         .group = "language",
         .parameters = {{.name = "items", .type = Type::any}, optional("start", Type::integer, 0)},
         .returns = "a list of pairs (number, item)",
         .doc = "Numbers the items of a list.",
         .example = "for i, f in enumerate(faces(x)): print(i, area(f))",
         .errors = {errors::script_type},
         .function = enumerate});
  r.add({.name = "zip",
         .group = "language",
         .parameters = {{.name = "lists", .type = Type::any, .variadic = true}},
         .returns = "a list of tuples, as long as the shortest",
         .doc = "Goes through several lists side by side.",
         .example = "for a, b in zip([1, 2], [3, 4]): print(a, b)",
         .errors = {errors::script_type},
         .function = zip});
  r.add({.name = "expect",
         .group = "language",
         .parameters = {{.name = "value", .type = Type::any},
                        {.name = "expected", .type = Type::any},
                        {.name = "rel",
                         .type = Type::number,
                         .doc = "allowed difference, relative to what is expected",
                         .default_value = 1e-9,
                         .limits = document::not_negative},
                        {.name = "abs",
                         .type = Type::number,
                         .doc = "allowed difference, absolute",
                         .default_value = 0,
                         .limits = document::not_negative}},
         .doc = "Fails the script, showing both values, unless value is expected. Numbers may differ by the larger of "
                "rel * |expected| and abs; lists are compared item by item.",
         .example = "expect(volume(block(1, 2, 3)), 6)",
         .errors = {errors::script_expectation},
         .function = [](Call& c) -> Result<Value> {
           ARESTA_CHECK(compare_expected(c["value"], c["expected"], c.number("rel"), c.number("abs"), "", 0));
           return Value();
         }});
}

}  // namespace

void register_mathematics(Registry& registry);

void register_language(Registry& registry) {
  register_values(registry);
  register_mathematics(registry);
}

}  // namespace aresta::script
