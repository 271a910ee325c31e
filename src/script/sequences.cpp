// SPDX-License-Identifier: Apache-2.0
// Brackets: items and slices of texts, lists, tuples and ranges.
#include <algorithm>

#include "script/errors.h"
#include "script/operators.h"

namespace aresta::script {

using document::IntegerRange;
using document::Value;
using Kind = Value::Kind;

namespace {

/// The bytes at which the characters of a text start, and its end.
std::vector<std::size_t> character_starts(const std::string& text) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) starts.push_back(i);
  }
  starts.push_back(text.size());
  return starts;
}

Error no_items(const Value& v) {
  return {errors::script_type,
          std::string(document::kind_name(v)) + " has no items: " + document::repr(v, document::Digits::shortest, 60)};
}

/// A key, counted from the end when negative, as a place in [0, n).
Status place_of(const Value& container, const Value& key, std::uint64_t n, std::uint64_t& out) {
  if (!key.is(Kind::integer) && !key.is(Kind::boolean)) {
    return Error{errors::script_type, "the index must be a whole number, not " + document::given_text(key)};
  }
  const std::int64_t i = key.is(Kind::boolean) ? std::int64_t{key.boolean()} : key.integer();
  const bool inside = i >= 0 ? static_cast<std::uint64_t>(i) < n : ~static_cast<std::uint64_t>(i) < n;
  if (!inside) {
    const std::string kind = document::kind_name(container);
    return Error{errors::script_index,
                 "the index " + std::to_string(i) + " is outside of " + kind + " of " + std::to_string(n) +
                     (n == 1 ? " item" : " items") +
                     (n > 0 && i > 0 && static_cast<std::uint64_t>(i) == n ? " (items are counted from 0)" : "")};
  }
  out = i >= 0 ? static_cast<std::uint64_t>(i) : n + static_cast<std::uint64_t>(i);
  return {};
}

}  // namespace

Result<std::uint64_t> length(const Value& v) {
  switch (v.kind()) {
    case Kind::string: {
      std::uint64_t n = 0;
      for (const char c : v.string()) n += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
      return n;
    }
    case Kind::list:
    case Kind::tuple:
      return std::uint64_t{v.items().size()};
    case Kind::range:
      return v.range().size();
    default:
      return Error{errors::script_type, std::string(document::kind_name(v)) + " has no length"};
  }
}

Result<std::vector<Value>> items_of(const Value& v) {
  std::vector<Value> out;
  switch (v.kind()) {
    case Kind::list:
    case Kind::tuple:
      return v.items();
    case Kind::range: {
      const IntegerRange& r = v.range();
      const std::uint64_t n = r.size();
      if (n > max_items)
        return Error{errors::script_too_large, "a range of " + std::to_string(n) + " numbers is too long for a list"};
      out.reserve(n);
      for (std::uint64_t i = 0; i < n; ++i) out.emplace_back(r.at(i));
      return out;
    }
    case Kind::string: {
      const auto starts = character_starts(v.string());
      if (starts.size() > max_items) return Error{errors::script_too_large, "the text is too long for a list"};
      for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        out.emplace_back(v.string().substr(starts[i], starts[i + 1] - starts[i]));
      }
      return out;
    }
    default:
      return Error{errors::script_type, std::string(document::kind_name(v)) + " cannot be gone through item by item: " +
                                            document::repr(v, document::Digits::shortest, 60)};
  }
}

Status index(const Value& container, const Value& key, Value& out) {
  std::uint64_t place = 0;
  switch (container.kind()) {
    case Kind::list:
    case Kind::tuple: {
      ARESTA_CHECK(place_of(container, key, container.items().size(), place));
      Value item = container.items()[place];
      out = std::move(item);
      return {};
    }
    case Kind::range: {
      ARESTA_CHECK(place_of(container, key, container.range().size(), place));
      out = container.range().at(place);
      return {};
    }
    case Kind::string: {
      const auto starts = character_starts(container.string());
      ARESTA_CHECK(place_of(container, key, starts.size() - 1, place));
      out = container.string().substr(starts[place], starts[place + 1] - starts[place]);
      return {};
    }
    default:
      return no_items(container);
  }
}

Status assign_index(const Value& container, const Value& key, const Value& value) {
  if (!container.is(Kind::list)) {
    return Error{errors::script_type,
                 std::string("the items of ") + document::kind_name(container) + " cannot be changed"};
  }
  std::uint64_t place = 0;
  auto& items = container.list_pointer()->values;
  ARESTA_CHECK(place_of(container, key, items.size(), place));
  items[place] = value;
  return {};
}

Status slice(const Value& container, const Value& start, const Value& stop, const Value& step, Value& out) {
  ARESTA_TRY(const std::uint64_t length_found, length(container));
  const auto n = static_cast<std::int64_t>(std::min<std::uint64_t>(length_found, INT64_MAX / 4));
  const auto bound = [&](const Value& v, std::int64_t absent, std::int64_t& into) -> Status {
    if (v.is_none()) {
      into = absent;
      return {};
    }
    if (!v.is(Kind::integer)) {
      return Error{errors::script_type, "the bounds of a slice must be whole numbers, not " + document::given_text(v)};
    }
    into = v.integer();
    return {};
  };
  std::int64_t s = 1, from = 0, to = 0;
  ARESTA_CHECK(bound(step, 1, s));
  if (s == 0) return Error{errors::script_value, "the step of a slice cannot be 0"};
  s = std::clamp(s, -n - 1, n + 1);
  ARESTA_CHECK(bound(start, s > 0 ? 0 : n - 1, from));
  ARESTA_CHECK(bound(stop, s > 0 ? n : -n - 1, to));
  // As in Python: negative ones count from the end, and all are cut to what is there.
  const auto place = [&](std::int64_t i) {
    if (i < 0) i = i < -n ? -1 : i + n;
    return s > 0 ? std::clamp<std::int64_t>(i, 0, n) : std::clamp<std::int64_t>(i, -1, n - 1);
  };
  from = place(from);
  to = place(to);
  const IntegerRange r{from, to, s};
  const std::uint64_t count = r.size();
  if (container.is(Kind::range)) {
    const IntegerRange& whole = container.range();
    std::int64_t step_of_both = 0;
    if (__builtin_mul_overflow(whole.step, s, &step_of_both)) step_of_both = whole.step > 0 ? INT64_MAX : INT64_MIN;
    const auto at = [&](std::int64_t i) { return whole.at(static_cast<std::uint64_t>(i)); };
    out = count == 0 ? IntegerRange{whole.start, whole.start, 1} : IntegerRange{at(from), at(to), step_of_both};
    return {};
  }
  if (container.is(Kind::string)) {
    const auto starts = character_starts(container.string());
    std::string text;
    for (std::uint64_t k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(r.at(k));
      text += container.string().substr(starts[i], starts[i + 1] - starts[i]);
    }
    out = std::move(text);
    return {};
  }
  std::vector<Value> items;
  items.reserve(count);
  for (std::uint64_t k = 0; k < count; ++k) items.push_back(container.items()[static_cast<std::size_t>(r.at(k))]);
  out = container.is(Kind::list) ? Value::list(std::move(items)) : Value::tuple(std::move(items));
  return {};
}

}  // namespace aresta::script
