// SPDX-License-Identifier: Apache-2.0
// Methods of lists and texts, and formats.
#include <algorithm>
#include <charconv>

#include "script/errors.h"
#include "script/operators.h"

namespace aresta::script {

using document::Value;
using Kind = Value::Kind;

namespace {

Status expect_count(const std::string& name, const std::vector<Value>& arguments, std::size_t low, std::size_t high) {
  if (arguments.size() >= low && arguments.size() <= high) return {};
  const std::string wanted = low == high ? std::to_string(low) : std::to_string(low) + " to " + std::to_string(high);
  return Error{errors::script_type,
               "." + name + " takes " + wanted + (low == high && low == 1 ? " argument, " : " arguments, ") +
                   std::to_string(arguments.size()) + (arguments.size() == 1 ? " was given" : " were given")};
}

Status expect_texts(const std::string& name, const std::vector<Value>& arguments) {
  for (const Value& v : arguments) {
    if (!v.is(Kind::string))
      return Error{errors::script_type, "." + name + " takes a text, not " + document::given_text(v)};
  }
  return {};
}

Status list_method(const std::shared_ptr<document::List>& list, const std::string& name, std::vector<Value> a,
                   Value& out) {
  auto& items = list->values;
  const auto full = [&](std::size_t more) { return items.size() + more > max_items; };
  const Error too_long{errors::script_too_large, "the list would be too long"};
  out = Value();
  if (name == "append") {
    ARESTA_CHECK(expect_count(name, a, 1, 1));
    if (full(1)) return too_long;
    items.push_back(std::move(a[0]));
    return {};
  }
  if (name == "extend") {
    ARESTA_CHECK(expect_count(name, a, 1, 1));
    ARESTA_TRY(std::vector<Value> more, items_of(a[0]));
    if (full(more.size())) return too_long;
    items.insert(items.end(), more.begin(), more.end());
    return {};
  }
  if (name == "insert") {
    ARESTA_CHECK(expect_count(name, a, 2, 2));
    if (!a[0].is(Kind::integer)) return Error{errors::script_type, ".insert takes a whole number and a value"};
    if (full(1)) return too_long;
    const auto n = static_cast<std::int64_t>(items.size());
    const std::int64_t i =
        a[0].integer() < 0 ? std::max<std::int64_t>(a[0].integer(), -n) + n : std::min(a[0].integer(), n);
    items.insert(items.begin() + i, std::move(a[1]));
    return {};
  }
  if (name == "pop") {
    ARESTA_CHECK(expect_count(name, a, 0, 1));
    const Value key = a.empty() ? Value(-1) : a[0];
    const Value self(list);
    ARESTA_CHECK(index(self, key, out));
    const auto n = static_cast<std::int64_t>(items.size());
    const std::int64_t i = key.is(Kind::boolean) ? std::int64_t{key.boolean()} : key.integer();
    items.erase(items.begin() + (i < 0 ? i + n : i));
    return {};
  }
  if (name == "index" || name == "count") {
    ARESTA_CHECK(expect_count(name, a, 1, 1));
    const auto same = [&](const Value& v) { return document::equal(v, a[0]); };
    if (name == "count") {
      out = static_cast<std::int64_t>(std::count_if(items.begin(), items.end(), same));
      return {};
    }
    const auto found = std::find_if(items.begin(), items.end(), same);
    if (found == items.end()) return Error{errors::script_value, document::given_text(a[0]) + ", is not in the list"};
    out = static_cast<std::int64_t>(found - items.begin());
    return {};
  }
  if (name == "reverse") {
    ARESTA_CHECK(expect_count(name, a, 0, 0));
    std::reverse(items.begin(), items.end());
    return {};
  }
  return Error{.code = errors::script_name,
               .message = "a list has no method '" + name + "'",
               .hint = "append, extend, insert, pop, index, count, reverse"};
}

std::string number_by_format(double x, std::chars_format style, int precision) {
  char buffer[512];  // a fixed number has at most 309 digits, a point and `precision` (at most 100) more
  const auto r = std::to_chars(buffer, buffer + sizeof buffer, x, style, precision);
  return {buffer, r.ptr};
}

std::string stripped(const std::string& text) {
  const char* blank = " \t\n\r\f\v";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

Status split(const std::string& text, const std::vector<Value>& a, Value& out) {
  std::vector<Value> parts;
  if (a.empty()) {
    std::string word;
    for (const char c : text + " ") {
      if (std::string_view(" \t\n\r\f\v").find(c) == std::string_view::npos) {
        word += c;
      } else if (!word.empty()) {
        parts.emplace_back(std::move(word));
        word.clear();
      }
      if (parts.size() > max_items) return Error{errors::script_too_large, "the list would be too long"};
    }
  } else {
    const std::string& separator = a[0].string();
    if (separator.empty()) return Error{errors::script_value, ".split needs a separator that is not empty"};
    std::size_t from = 0;
    for (;;) {
      const std::size_t found = text.find(separator, from);
      parts.emplace_back(text.substr(from, found == std::string::npos ? found : found - from));
      if (parts.size() > max_items) return Error{errors::script_too_large, "the list would be too long"};
      if (found == std::string::npos) break;
      from = found + separator.size();
    }
  }
  out = Value::list(std::move(parts));
  return {};
}

Status join_texts(const std::string& separator, const Value& list, Value& out) {
  ARESTA_TRY(const std::vector<Value> items, items_of(list));
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].is(Kind::string)) {
      return Error{errors::script_type,
                   ".join takes a list of texts; item " + std::to_string(i) + " is " + document::given_text(items[i])};
    }
    if (text.size() + separator.size() + items[i].string().size() > max_text) {
      return Error{errors::script_too_large, "the text would be too long"};
    }
    if (i > 0) text += separator;
    text += items[i].string();
  }
  out = std::move(text);
  return {};
}

Status text_method(const std::string& text, const std::string& name, const std::vector<Value>& a, Value& out) {
  if (name == "join") {
    ARESTA_CHECK(expect_count(name, a, 1, 1));
    return join_texts(text, a[0], out);
  }
  ARESTA_CHECK(expect_texts(name, a));
  if (name == "split") {
    ARESTA_CHECK(expect_count(name, a, 0, 1));
    return split(text, a, out);
  }
  if (name == "strip" || name == "upper" || name == "lower") {
    ARESTA_CHECK(expect_count(name, a, 0, 0));
    std::string r = name == "strip" ? stripped(text) : text;
    for (char& c : r) {
      if (name == "upper" && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
      if (name == "lower" && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    out = std::move(r);
    return {};
  }
  if (name == "startswith" || name == "endswith") {
    ARESTA_CHECK(expect_count(name, a, 1, 1));
    out = name == "startswith" ? text.starts_with(a[0].string()) : text.ends_with(a[0].string());
    return {};
  }
  if (name == "replace") {
    ARESTA_CHECK(expect_count(name, a, 2, 2));
    const std::string &from = a[0].string(), &to = a[1].string();
    if (from.empty()) return Error{errors::script_value, ".replace needs a text to look for that is not empty"};
    std::string r;
    std::size_t at = 0;
    for (std::size_t found = 0; (found = text.find(from, at)) != std::string::npos; at = found + from.size()) {
      r.append(text, at, found - at).append(to);
      if (r.size() > max_text) return Error{errors::script_too_large, "the text would be too long"};
    }
    out = r.append(text, at, std::string::npos);
    return {};
  }
  return Error{.code = errors::script_name,
               .message = "a text has no method '" + name + "'",
               .hint = "join, split, strip, upper, lower, replace, startswith, endswith"};
}

}  // namespace

Status method(const Value& target, const std::string& name, std::vector<Value> arguments, Value& out) {
  if (target.is(Kind::list)) return list_method(target.list_pointer(), name, std::move(arguments), out);
  if (target.is(Kind::string)) {
    Value result;  // apart: `out` may be the target
    ARESTA_CHECK(text_method(target.string(), name, arguments, result));
    out = std::move(result);
    return {};
  }
  return Error{errors::script_type, std::string(document::kind_name(target)) + " has no method '" + name + "'"};
}

Result<std::string> format(const Value& value, std::string_view spec) {
  if (spec.empty()) return document::display(value);
  const Error bad{.code = errors::script_value,
                  .message = "the format '" + std::string(spec) + "' is not known",
                  .hint = "':.3f', ':.6g', ':.2e', ':8d', ':>10'"};
  std::size_t i = 0;
  char align = '\0';
  bool zero = false, plus = false;
  std::size_t width = 0;
  int precision = -1;
  if (i < spec.size() && (spec[i] == '<' || spec[i] == '>' || spec[i] == '^')) align = spec[i++];
  if (i < spec.size() && spec[i] == '+') plus = true, ++i;
  if (i < spec.size() && spec[i] == '0') zero = true, ++i;
  const auto digits = [&](std::size_t& into) {
    const std::size_t first = i;
    while (i < spec.size() && spec[i] >= '0' && spec[i] <= '9' && i - first < 4)
      into = 10 * into + static_cast<std::size_t>(spec[i++] - '0');
    return i > first;
  };
  digits(width);
  if (i < spec.size() && spec[i] == '.') {
    ++i;
    std::size_t p = 0;
    if (!digits(p) || p > 100) return bad;
    precision = static_cast<int>(p);
  }
  const char type = i < spec.size() ? spec[i++] : '\0';
  if (i != spec.size() || width > 1000) return bad;

  std::string text;
  const bool number = value.is_number() || value.is(Kind::boolean);
  const auto real = [&] { return value.is(Kind::boolean) ? (value.boolean() ? 1.0 : 0.0) : value.number(); };
  if (type == 'd') {
    if (!value.is(Kind::integer) && !value.is(Kind::boolean)) {
      return Error{errors::script_type, "the format 'd' takes a whole number, not " + document::given_text(value)};
    }
    text = std::to_string(value.is(Kind::boolean) ? std::int64_t{value.boolean()} : value.integer());
  } else if (type == 'f' || type == 'e' || type == 'g') {
    if (!number)
      return Error{errors::script_type,
                   std::string("the format '") + type + "' takes a number, not " + document::given_text(value)};
    const auto style = type == 'f'   ? std::chars_format::fixed
                       : type == 'e' ? std::chars_format::scientific
                                     : std::chars_format::general;
    text = number_by_format(real(), style, precision < 0 ? 6 : precision);
  } else if (type == '\0' || type == 's') {
    if (precision >= 0 && value.is(Kind::real)) {
      text = number_by_format(value.real(), std::chars_format::general, precision);
    } else {
      text = document::display(value);
    }
  } else {
    return bad;
  }
  if (plus && number && text[0] != '-') text.insert(0, "+");
  std::size_t shown = 0;
  for (const char c : text) shown += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  if (shown < width) {
    const std::size_t fill = width - shown;
    if (zero && number && align == '\0') {
      text.insert(text[0] == '-' || text[0] == '+' ? 1 : 0, fill, '0');
    } else if (align == '>' || (align == '\0' && number)) {
      text.insert(0, fill, ' ');
    } else if (align == '^') {
      text.insert(0, fill / 2, ' ');
      text.append(fill - fill / 2, ' ');
    } else {
      text.append(fill, ' ');
    }
  }
  return text;
}

}  // namespace aresta::script
