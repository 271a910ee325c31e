// SPDX-License-Identifier: Apache-2.0
// Mathematics for scripts. Angles are in degrees, as everywhere in the language; multiples of 30 and 45 degrees give
// the exact values where they are exact.
#include <charconv>
#include <cmath>
#include <numbers>

#include "script/errors.h"
#include "script/interpreter.h"

namespace aresta::script {

using document::Call;
using document::Parameter;
using document::Registry;
using document::Type;
using document::Value;

namespace {

constexpr double per_degree = std::numbers::pi / 180;

struct SinCos {
  double sin, cos;
};

/// Reduced to [-45, 45] degrees first, which is exact, so that sin(180) is 0 and cos(60) is 0.5.
SinCos sin_cos(double degrees) {
  int quadrant = 0;
  const double r = std::remquo(degrees, 90, &quadrant);
  SinCos v{std::sin(r * per_degree), std::cos(r * per_degree)};
  if (std::abs(r) == 30) v.sin = std::copysign(0.5, r);
  if (std::abs(r) == 45) v = {std::copysign(std::numbers::sqrt2 / 2, r), std::numbers::sqrt2 / 2};
  switch (quadrant & 3) {
    case 1:
      return {v.cos, -v.sin + 0.0};
    case 2:
      return {-v.sin + 0.0, -v.cos};
    case 3:
      return {-v.cos, v.sin + 0.0};
    default:
      return v;
  }
}

/// Degrees of an inverse function; exact where the value is.
double in_degrees(double radians) {
  const double d = radians / per_degree, nearest = std::round(d);
  return std::abs(d - nearest) < 4e-15 * std::abs(nearest) && std::fmod(nearest, 15) == 0 ? nearest : d;
}

Result<Value> finite(double x, const Call& call) {
  if (std::isfinite(x)) return Value(x);
  return Error{errors::script_overflow, "the result of " + call.command().name + " is too large for a number"};
}

Error outside(const Call& call, const char* domain) {
  return {errors::script_value, call.command().name + " takes " + domain + ", not " + document::repr(call["x"])};
}

void add(Registry& r, const char* name, std::string unit, std::string returns, std::string doc, std::string example,
         document::Function function) {
  r.add({.name = name,
         .group = "mathematics",
         .parameters = {{.name = "x", .type = Type::number, .unit = std::move(unit)}},
         .returns = std::move(returns),
         .doc = std::move(doc),
         .example = std::move(example),
         .errors = {errors::script_value, errors::script_overflow},
         .function = std::move(function)});
}

Result<Value> round_number(Call& c) {
  const Value& x = c["x"];
  if (c["digits"].is_none()) {
    if (x.is(Value::Kind::integer)) return x;
    const double r = std::nearbyint(x.real());  // halves to even, as Python
    if (std::abs(r) >= 9223372036854775808.0)
      return Error{errors::script_overflow, document::repr(x) + " does not fit in 64 bits"};
    return Value(static_cast<std::int64_t>(r));
  }
  const std::int64_t digits = c.integer("digits");
  if (x.is(Value::Kind::integer) && digits >= 0) return x;
  if (digits < 0) {
    const double power = std::pow(10.0, static_cast<double>(-digits));
    const double r = std::nearbyint(x.number() / power) * power;
    if (x.is(Value::Kind::integer) && std::abs(r) < 9007199254740992.0) return Value(static_cast<std::int64_t>(r));
    return finite(r, c);
  }
  // By way of the decimal text, which is correctly rounded.
  char buffer[512];
  const auto written =
      std::to_chars(buffer, buffer + sizeof buffer, x.real(), std::chars_format::fixed, static_cast<int>(digits));
  double r = 0;
  std::from_chars(buffer, written.ptr, r);
  return Value(r);
}

Result<Value> whole(double x) {
  if (!(std::abs(x) < 9223372036854775808.0)) {
    return Error{errors::script_overflow, document::number_text(x) + " does not fit in a whole number of 64 bits"};
  }
  return Value(static_cast<std::int64_t>(x));
}

}  // namespace

void register_mathematics(Registry& r) {
  r.add(document::Constant{"pi", Value(std::numbers::pi), "The ratio of a circle's circumference to its diameter."});
  add(r, "sqrt", "", "a number", "The square root.", "sqrt(2)", [](Call& c) -> Result<Value> {
    const double x = c.number("x");
    if (x < 0) return outside(c, "a number that is not negative");
    return Value(std::sqrt(x));
  });
  add(r, "sin", "degrees", "a number", "The sine of an angle in degrees.", "sin(30)",
      [](Call& c) -> Result<Value> { return Value(sin_cos(c.number("x")).sin); });
  add(r, "cos", "degrees", "a number", "The cosine of an angle in degrees.", "cos(60)",
      [](Call& c) -> Result<Value> { return Value(sin_cos(c.number("x")).cos); });
  add(r, "tan", "degrees", "a number", "The tangent of an angle in degrees.", "tan(45)", [](Call& c) -> Result<Value> {
    const SinCos v = sin_cos(c.number("x"));
    if (v.cos == 0) return Error{errors::script_value, "tan has no value at " + document::repr(c["x"]) + " degrees"};
    return Value(v.sin / v.cos);
  });
  add(r, "asin", "", "an angle in degrees, from -90 to 90", "The angle whose sine is x.", "asin(0.5)",
      [](Call& c) -> Result<Value> {
        const double x = c.number("x");
        if (std::abs(x) > 1) return outside(c, "a number from -1 to 1");
        return Value(in_degrees(std::asin(x)));
      });
  add(r, "acos", "", "an angle in degrees, from 0 to 180", "The angle whose cosine is x.", "acos(0.5)",
      [](Call& c) -> Result<Value> {
        const double x = c.number("x");
        if (std::abs(x) > 1) return outside(c, "a number from -1 to 1");
        return Value(in_degrees(std::acos(x)));
      });
  add(r, "atan", "", "an angle in degrees, from -90 to 90", "The angle whose tangent is x.", "atan(1)",
      [](Call& c) -> Result<Value> { return Value(in_degrees(std::atan(c.number("x")))); });
  r.add({.name = "atan2",
         .group = "mathematics",
         .parameters = {{.name = "y", .type = Type::number}, {.name = "x", .type = Type::number}},
         .returns = "an angle in degrees, from -180 to 180",
         .doc = "The angle of the direction (x, y) from the x axis.",
         .example = "atan2(1, 1)",
         .function = [](Call& c) -> Result<Value> {
           return Value(in_degrees(std::atan2(c.number("y"), c.number("x"))));
         }});
  r.add({.name = "hypot",
         .group = "mathematics",
         .parameters = {{.name = "x", .type = Type::number}, {.name = "y", .type = Type::number}},
         .returns = "a number",
         .doc = "The length of (x, y).",
         .example = "hypot(3, 4)",
         .errors = {errors::script_overflow},
         .function = [](Call& c) -> Result<Value> { return finite(std::hypot(c.number("x"), c.number("y")), c); }});
  add(r, "exp", "", "a number", "e to the power x.", "exp(1)",
      [](Call& c) -> Result<Value> { return finite(std::exp(c.number("x")), c); });
  add(r, "log", "", "a number", "The natural logarithm.", "log(10)", [](Call& c) -> Result<Value> {
    const double x = c.number("x");
    if (x <= 0) return outside(c, "a number greater than 0");
    return Value(std::log(x));
  });
  add(r, "floor", "", "a whole number", "The largest whole number that is not greater.", "floor(2.7)",
      [](Call& c) -> Result<Value> {
        return c["x"].is(Value::Kind::integer) ? Result<Value>(c["x"]) : whole(std::floor(c["x"].real()));
      });
  add(r, "ceil", "", "a whole number", "The smallest whole number that is not less.", "ceil(2.2)",
      [](Call& c) -> Result<Value> {
        return c["x"].is(Value::Kind::integer) ? Result<Value>(c["x"]) : whole(std::ceil(c["x"].real()));
      });
  add(r, "abs", "", "a number that is not negative", "The absolute value.", "abs(-3)", [](Call& c) -> Result<Value> {
    const Value& x = c["x"];
    if (x.is(Value::Kind::real)) return Value(std::abs(x.real()));
    if (x.integer() == INT64_MIN) return Error{errors::script_overflow, "the absolute value does not fit in 64 bits"};
    return Value(std::abs(x.integer()));
  });
  r.add({.name = "round",
         .group = "mathematics",
         .parameters = {{.name = "x", .type = Type::number},
                        {.name = "digits",
                         .type = Type::integer,
                         .doc = "after the decimal point",
                         .default_value = Value(),
                         .limits = {-300, 300}}},
         .returns = "a whole number, or with digits a number of the same kind",
         .doc = "Rounds, halves to the even neighbour.",
         .example = "round(2.345, 2)",
         .errors = {errors::script_overflow},
         .function = round_number});
}

}  // namespace aresta::script
