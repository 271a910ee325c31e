// SPDX-License-Identifier: Apache-2.0
#include "document/value.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "document/registry.h"

namespace aresta::document {

namespace {

constexpr int max_repr_depth = 100;
constexpr int max_equal_depth = 1000;

/// Lists and tuples waiting to be released by the outermost ~Items of this thread.
thread_local std::vector<Value>* pending = nullptr;

void hand_over(std::vector<Value>& values, std::vector<Value>& queue) {
  for (Value& v : values) {
    if (v.is_sequence()) queue.push_back(std::move(v));
  }
}

void append_quoted(std::string& out, const std::string& text, std::size_t limit) {
  const char quote = text.find('\'') != std::string::npos && text.find('"') == std::string::npos ? '"' : '\'';
  out += quote;
  for (const char c : text) {
    if (out.size() > limit) break;
    const auto byte = static_cast<unsigned char>(c);
    if (c == quote || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (c == '\r') {
      out += "\\r";
    } else if (byte < 0x20 || byte == 0x7f) {
      char hex[8];
      std::snprintf(hex, sizeof hex, "\\x%02x", byte);
      out += hex;
    } else {
      out += c;
    }
  }
  out += quote;
}

void append_repr(std::string& out, const Value& value, Digits digits, std::size_t limit, int depth) {
  if (out.size() > limit) return;
  switch (value.kind()) {
    case Value::Kind::none:
      out += "None";
      break;
    case Value::Kind::boolean:
      out += value.boolean() ? "True" : "False";
      break;
    case Value::Kind::integer:
      out += std::to_string(value.integer());
      break;
    case Value::Kind::real:
      out += number_text(value.real(), digits);
      break;
    case Value::Kind::string:
      append_quoted(out, value.string(), limit);
      break;
    case Value::Kind::list:
    case Value::Kind::tuple: {
      const bool is_list = value.is(Value::Kind::list);
      out += is_list ? '[' : '(';
      if (depth >= max_repr_depth) {
        out += "...";
      } else {
        const auto& items = value.items();
        for (std::size_t i = 0; i < items.size() && out.size() <= limit; ++i) {
          if (i > 0) out += ", ";
          append_repr(out, items[i], digits, limit, depth + 1);
        }
        if (!is_list && items.size() == 1) out += ',';
      }
      out += is_list ? ']' : ')';
      break;
    }
    case Value::Kind::range: {
      const IntegerRange& r = value.range();
      out += "range(" + std::to_string(r.start) + ", " + std::to_string(r.stop);
      if (r.step != 1) out += ", " + std::to_string(r.step);
      out += ")";
      break;
    }
    case Value::Kind::shape:
      out += "<" + value.shape()->describe() + ">";
      break;
    case Value::Kind::command:
      out += "<command " + value.command()->name + ">";
      break;
  }
}

bool equal_to_depth(const Value& a, const Value& b, int depth) {
  using Kind = Value::Kind;
  const auto numeric = [](const Value& v) { return v.is_number() || v.is(Kind::boolean); };
  if (numeric(a) && numeric(b)) {
    const auto whole = [](const Value& v) { return v.is(Kind::boolean) ? std::int64_t{v.boolean()} : v.integer(); };
    if (!a.is(Kind::real) && !b.is(Kind::real)) return whole(a) == whole(b);
    if (a.is(Kind::real) && b.is(Kind::real)) return a.real() == b.real();
    const double d = a.is(Kind::real) ? a.real() : b.real();
    const std::int64_t i = a.is(Kind::real) ? whole(b) : whole(a);
    // Exact: a real in the range of 64 bits is compared as a whole number.
    return d == std::floor(d) && d >= -9223372036854775808.0 && d < 9223372036854775808.0 &&
           static_cast<std::int64_t>(d) == i;
  }
  if (a.kind() != b.kind()) return false;
  switch (a.kind()) {
    case Kind::string:
      return a.string() == b.string();
    case Kind::list:
    case Kind::tuple: {
      if (a.identical(b)) return true;
      if (depth >= max_equal_depth) return false;
      const auto &x = a.items(), &y = b.items();
      if (x.size() != y.size()) return false;
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (!equal_to_depth(x[i], y[i], depth + 1)) return false;
      }
      return true;
    }
    case Kind::range: {
      const IntegerRange &r = a.range(), &s = b.range();
      const std::uint64_t n = r.size();
      return n == s.size() && (n == 0 || (r.start == s.start && (n == 1 || r.step == s.step)));
    }
    case Kind::shape:
      return a.shape() == b.shape() || a.shape()->same_as(*b.shape());
    default:
      return a.identical(b);
  }
}

}  // namespace

std::uint64_t IntegerRange::size() const {
  if (step > 0) {
    if (start >= stop) return 0;
    const std::uint64_t span = static_cast<std::uint64_t>(stop) - static_cast<std::uint64_t>(start);
    return (span - 1) / static_cast<std::uint64_t>(step) + 1;
  }
  if (start <= stop) return 0;
  const std::uint64_t span = static_cast<std::uint64_t>(start) - static_cast<std::uint64_t>(stop);
  return (span - 1) / (~static_cast<std::uint64_t>(step) + 1) + 1;
}

Items::Items(std::vector<Value> v) : values(std::move(v)) {}

Items::~Items() {
  if (pending != nullptr) {
    hand_over(values, *pending);
    return;
  }
  std::vector<Value> queue;
  hand_over(values, queue);
  if (queue.empty()) return;
  pending = &queue;
  while (!queue.empty()) {
    const Value last = std::move(queue.back());
    queue.pop_back();
  }
  pending = nullptr;
}

const std::vector<Value>& Value::items() const {
  if (const auto* list = std::get_if<std::shared_ptr<List>>(&state_)) return (*list)->values;
  return (*std::get_if<std::shared_ptr<const Tuple>>(&state_))->values;
}

bool Value::identical(const Value& other) const {
  return state_ == other.state_;
}

std::string number_text(double value, Digits digits) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char buffer[64];
  std::to_chars_result r{};
  if (digits == Digits::seventeen) {
    r = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 17);
  } else {
    // As Python: positional between 1e-4 and 1e16, with an exponent elsewhere.
    const double size = std::abs(value);
    const bool positional = size == 0 || (size >= 1e-4 && size < 1e16);
    r = std::to_chars(buffer, buffer + sizeof buffer, value,
                      positional ? std::chars_format::fixed : std::chars_format::scientific);
  }
  std::string text(buffer, r.ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string repr(const Value& value, Digits digits, std::size_t limit) {
  std::string out;
  append_repr(out, value, digits, limit, 0);
  if (out.size() > limit) {
    std::size_t cut = limit;
    while (cut > 0 && (static_cast<unsigned char>(out[cut]) & 0xc0) == 0x80) --cut;  // never inside a character
    out.resize(cut);
    out += "...";
  }
  return out;
}

std::string display(const Value& value, Digits digits) {
  return value.is(Value::Kind::string) ? value.string() : repr(value, digits);
}

const char* kind_name(const Value& value) {
  switch (value.kind()) {
    case Value::Kind::none:
      return "no value";
    case Value::Kind::boolean:
      return "a truth value";
    case Value::Kind::integer:
      return "a whole number";
    case Value::Kind::real:
      return "a number";
    case Value::Kind::string:
      return "a text";
    case Value::Kind::list:
      return "a list";
    case Value::Kind::tuple:
      return "a tuple";
    case Value::Kind::range:
      return "a range";
    case Value::Kind::shape:
      return "a shape";
    case Value::Kind::command:
      return "a command";
  }
  return "";
}

std::string given_text(const Value& value) {
  std::string text = repr(value, Digits::shortest, 60);
  if (value.is(Value::Kind::shape) || value.is(Value::Kind::command)) return text;
  return text + ", " + kind_name(value);
}

bool truth(const Value& value) {
  switch (value.kind()) {
    case Value::Kind::none:
      return false;
    case Value::Kind::boolean:
      return value.boolean();
    case Value::Kind::integer:
      return value.integer() != 0;
    case Value::Kind::real:
      return value.real() != 0;
    case Value::Kind::string:
      return !value.string().empty();
    case Value::Kind::list:
    case Value::Kind::tuple:
      return !value.items().empty();
    case Value::Kind::range:
      return value.range().size() > 0;
    default:
      return true;
  }
}

bool equal(const Value& a, const Value& b) {
  return equal_to_depth(a, b, 0);
}

}  // namespace aresta::document
