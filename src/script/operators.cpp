// SPDX-License-Identifier: Apache-2.0
#include "script/operators.h"

#include <algorithm>
#include <cmath>

#include "script/errors.h"

namespace aresta::script {

using document::IntegerRange;
using document::Session;
using document::Value;
using Kind = Value::Kind;

namespace {

constexpr int max_compare_depth = 200;

bool whole(const Value& v) {
  return v.is(Kind::integer) || v.is(Kind::boolean);
}
bool numeric(const Value& v) {
  return v.is_number() || v.is(Kind::boolean);
}
std::int64_t as_integer(const Value& v) {
  return v.is(Kind::boolean) ? std::int64_t{v.boolean()} : v.integer();
}
double as_real(const Value& v) {
  return v.is(Kind::real) ? v.real() : static_cast<double>(as_integer(v));
}

Error overflow_of_integers(Op op) {
  return {.code = errors::script_overflow,
          .message = std::string("the result of '") + op_text(op) + "' does not fit in 64 bits",
          .hint = "real numbers, as in 2.0"};
}

Error division_by_zero(const Value& a) {
  return {errors::script_zero_division, document::given_text(a) + ", is divided by zero"};
}

Error no_such_operation(Op op, const Value& a, const Value& b) {
  return {errors::script_type, std::string("'") + op_text(op) + "' is not defined between " + document::kind_name(a) +
                                   " and " + document::kind_name(b)};
}

Status integer_power(std::int64_t base, std::int64_t exponent, Value& out) {
  if (exponent < 0) {
    if (base == 0) return Error{errors::script_zero_division, "0 has no negative power"};
    out = std::pow(static_cast<double>(base), static_cast<double>(exponent));
    return {};
  }
  std::int64_t result = 1;
  for (std::int64_t e = exponent;;) {
    if ((e & 1) != 0 && __builtin_mul_overflow(result, base, &result)) return overflow_of_integers(Op::power);
    e >>= 1;
    if (e == 0) break;
    if (__builtin_mul_overflow(base, base, &base)) return overflow_of_integers(Op::power);
  }
  out = result;
  return {};
}

Status integer_arithmetic(Op op, const Value& a, const Value& b, Value& out) {
  const std::int64_t x = as_integer(a), y = as_integer(b);
  std::int64_t r = 0;
  switch (op) {
    case Op::add:
      if (__builtin_add_overflow(x, y, &r)) return overflow_of_integers(op);
      break;
    case Op::subtract:
      if (__builtin_sub_overflow(x, y, &r)) return overflow_of_integers(op);
      break;
    case Op::multiply:
      if (__builtin_mul_overflow(x, y, &r)) return overflow_of_integers(op);
      break;
    case Op::divide:
      if (y == 0) return division_by_zero(a);
      out = static_cast<double>(x) / static_cast<double>(y);
      return {};
    case Op::floor_divide:
    case Op::modulo:
      if (y == 0) return division_by_zero(a);
      if (y == -1) {  // the one case where the processor's division overflows
        if (op == Op::modulo)
          r = 0;
        else if (__builtin_sub_overflow(std::int64_t{0}, x, &r))
          return overflow_of_integers(op);
        break;
      }
      r = op == Op::modulo ? x % y : x / y;
      if (x % y != 0 && (x % y < 0) != (y < 0)) r += op == Op::modulo ? y : -1;
      break;
    case Op::bit_and:
      r = x & y;
      break;
    case Op::power:
      return integer_power(x, y, out);
    default:
      return no_such_operation(op, a, b);
  }
  out = r;
  return {};
}

Status real_arithmetic(Op op, const Value& a, const Value& b, Value& out) {
  const double x = as_real(a), y = as_real(b);
  double r = 0;
  switch (op) {
    case Op::add:
      r = x + y;
      break;
    case Op::subtract:
      r = x - y;
      break;
    case Op::multiply:
      r = x * y;
      break;
    case Op::divide:
      if (y == 0) return division_by_zero(a);
      r = x / y;
      break;
    case Op::floor_divide:
    case Op::modulo: {
      if (y == 0) return division_by_zero(a);
      double m = std::fmod(x, y);
      if (m != 0 && (m < 0) != (y < 0)) m += y;
      r = op == Op::modulo ? m : std::round((x - m) / y);
      break;
    }
    case Op::power:
      if (x == 0 && y < 0) return Error{errors::script_zero_division, "0 has no negative power"};
      if (x < 0 && y != std::floor(y)) {
        return Error{errors::script_value,
                     "a negative number has no real power with the exponent " + document::repr(b)};
      }
      r = std::pow(x, y);
      break;
    default:
      return no_such_operation(op, a, b);
  }
  if (!std::isfinite(r) && std::isfinite(x) && std::isfinite(y)) {
    return Error{errors::script_overflow,
                 std::string("the result of '") + op_text(op) + "' is too large for a number (about 1.8e308)"};
  }
  out = r;
  return {};
}

Status repeat(const Value& sequence, std::int64_t times, Value& out) {
  const std::uint64_t n = times < 0 ? 0 : static_cast<std::uint64_t>(times);
  if (sequence.is(Kind::string)) {
    const std::string& text = sequence.string();
    if (!text.empty() && n > max_text / text.size())
      return Error{errors::script_too_large, "the text would be too long"};
    std::string r;
    r.reserve(text.size() * n);
    for (std::uint64_t i = 0; i < n && !text.empty(); ++i) r += text;
    out = std::move(r);
    return {};
  }
  const auto& items = sequence.items();
  if (!items.empty() && n > max_items / items.size())
    return Error{errors::script_too_large, "the list would be too long"};
  std::vector<Value> r;
  r.reserve(items.size() * n);
  for (std::uint64_t i = 0; i < n && !items.empty(); ++i) r.insert(r.end(), items.begin(), items.end());
  out = sequence.is(Kind::list) ? Value::list(std::move(r)) : Value::tuple(std::move(r));
  return {};
}

Status join(const Value& a, const Value& b, Value& out) {
  if (a.is(Kind::string)) {
    if (a.string().size() + b.string().size() > max_text)
      return Error{errors::script_too_large, "the text would be too long"};
    out = a.string() + b.string();
    return {};
  }
  if (a.items().size() + b.items().size() > max_items)
    return Error{errors::script_too_large, "the list would be too long"};
  std::vector<Value> r;
  r.reserve(a.items().size() + b.items().size());
  r.insert(r.end(), a.items().begin(), a.items().end());
  r.insert(r.end(), b.items().begin(), b.items().end());
  out = a.is(Kind::list) ? Value::list(std::move(r)) : Value::tuple(std::move(r));
  return {};
}

Status shape_operation(Op op, const Value& a, const Value& b, Session& session, Value& out) {
  const char* name = op == Op::add        ? "union"
                     : op == Op::subtract ? "difference"
                     : op == Op::bit_and  ? "intersection"
                                          : nullptr;
  const document::Command* command = name != nullptr ? session.registry->find(name) : nullptr;
  if (command == nullptr) return no_such_operation(op, a, b);
  ARESTA_TRY(out,
             document::invoke(*command, {.positional = {a, b}, .keywords = {{"regularise", Value(true)}}}, session));
  return {};
}

/// -1, 0, 1; -2: unordered (not a number).
Status compare(const Value& a, const Value& b, int depth, int& out) {
  const auto sign = [](auto x, auto y) { return x < y ? -1 : x > y ? 1 : x == y ? 0 : -2; };
  if (numeric(a) && numeric(b)) {
    if (whole(a) && whole(b)) {
      out = sign(as_integer(a), as_integer(b));
    } else if (a.is(Kind::real) && b.is(Kind::real)) {
      out = sign(a.real(), b.real());
    } else {
      // long double holds both 64-bit whole numbers and doubles exactly.
      out = sign(a.is(Kind::real) ? static_cast<long double>(a.real()) : static_cast<long double>(as_integer(a)),
                 b.is(Kind::real) ? static_cast<long double>(b.real()) : static_cast<long double>(as_integer(b)));
    }
    return {};
  }
  if (a.is(Kind::string) && b.is(Kind::string)) {
    out = sign(a.string().compare(b.string()), 0);
    return {};
  }
  if (a.is_sequence() && a.kind() == b.kind()) {
    if (depth >= max_compare_depth) return Error{errors::script_too_deep, "the lists compared are nested too deeply"};
    const auto &x = a.items(), &y = b.items();
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
      if (document::equal(x[i], y[i])) continue;
      return compare(x[i], y[i], depth + 1, out);
    }
    out = sign(x.size(), y.size());
    return {};
  }
  return no_such_operation(Op::less, a, b);
}

Status contains(const Value& needle, const Value& container, bool& out) {
  switch (container.kind()) {
    case Kind::list:
    case Kind::tuple:
      out = std::any_of(container.items().begin(), container.items().end(),
                        [&](const Value& v) { return v.identical(needle) || document::equal(v, needle); });
      return {};
    case Kind::string:
      if (!needle.is(Kind::string)) return no_such_operation(Op::in, needle, container);
      out = container.string().find(needle.string()) != std::string::npos;
      return {};
    case Kind::range: {
      const IntegerRange& r = container.range();
      out = false;
      if (!numeric(needle)) return {};
      const double d = as_real(needle);
      if (needle.is(Kind::real) && (d != std::floor(d) || std::abs(d) > 9e18)) return {};
      const std::int64_t i = needle.is(Kind::real) ? static_cast<std::int64_t>(d) : as_integer(needle);
      const bool inside = r.step > 0 ? i >= r.start && i < r.stop : i <= r.start && i > r.stop;
      const std::uint64_t offset = r.step > 0 ? static_cast<std::uint64_t>(i) - static_cast<std::uint64_t>(r.start)
                                              : static_cast<std::uint64_t>(r.start) - static_cast<std::uint64_t>(i);
      const std::uint64_t step =
          r.step > 0 ? static_cast<std::uint64_t>(r.step) : ~static_cast<std::uint64_t>(r.step) + 1;
      out = inside && offset % step == 0;
      return {};
    }
    default:
      return no_such_operation(Op::in, needle, container);
  }
}

}  // namespace

Status less(const Value& a, const Value& b, bool& out) {
  int order = 0;
  ARESTA_CHECK(compare(a, b, 0, order));
  out = order == -1;
  return {};
}

Status binary(Op op, const Value& a, const Value& b, Session& session, Value& out) {
  switch (op) {
    case Op::equal:
      out = document::equal(a, b);
      return {};
    case Op::not_equal:
      out = !document::equal(a, b);
      return {};
    case Op::less:
    case Op::less_equal:
    case Op::greater:
    case Op::greater_equal: {
      int order = 0;
      if (auto status = compare(a, b, 0, order); !status) {
        if (status.error().code == errors::script_type) return no_such_operation(op, a, b);
        return status;
      }
      out = op == Op::less         ? order == -1
            : op == Op::less_equal ? order == -1 || order == 0
            : op == Op::greater    ? order == 1
                                   : order == 1 || order == 0;
      return {};
    }
    case Op::in:
    case Op::not_in: {
      bool found = false;
      ARESTA_CHECK(contains(a, b, found));
      out = found == (op == Op::in);
      return {};
    }
    case Op::is:
      out = a.identical(b);
      return {};
    case Op::is_not:
      out = !a.identical(b);
      return {};
    default:
      break;
  }
  if (numeric(a) && numeric(b)) {
    if (whole(a) && whole(b)) return integer_arithmetic(op, a, b, out);
    return real_arithmetic(op, a, b, out);
  }
  if (a.is(Kind::shape) && b.is(Kind::shape)) return shape_operation(op, a, b, session, out);
  if (op == Op::add && a.kind() == b.kind() && (a.is(Kind::string) || a.is_sequence())) return join(a, b, out);
  if (op == Op::multiply && (a.is(Kind::string) || a.is_sequence()) && whole(b)) return repeat(a, as_integer(b), out);
  if (op == Op::multiply && (b.is(Kind::string) || b.is_sequence()) && whole(a)) return repeat(b, as_integer(a), out);
  return no_such_operation(op, a, b);
}

Status negate(const Value& a, Value& out) {
  if (a.is(Kind::real)) {
    out = -a.real();
    return {};
  }
  if (!whole(a)) return Error{errors::script_type, std::string("'-' is not defined for ") + document::kind_name(a)};
  std::int64_t r = 0;
  if (__builtin_sub_overflow(std::int64_t{0}, as_integer(a), &r)) return overflow_of_integers(Op::subtract);
  out = r;
  return {};
}

}  // namespace aresta::script
