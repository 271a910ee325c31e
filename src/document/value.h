// SPDX-License-Identifier: Apache-2.0
// The values that commands take and give, and that scripts compute with: None, booleans, whole and real numbers, text,
// lists, tuples, ranges, shapes and commands themselves. Small, copied freely; lists are shared as in Python.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"

namespace aresta::document {

struct Command;
class Value;

/// What a script calls a shape, as far as the language has to know it. Immutable.
class Shape {
 public:
  virtual ~Shape() = default;
  /// A few words, as in "shape of 1 region".
  virtual std::string describe() const = 0;
  /// The same entities of the same model?
  virtual bool same_as(const Shape& other) const = 0;
};
using ShapePtr = std::shared_ptr<const Shape>;

/// The numbers start, start + step, ... before stop; step is not 0.
struct IntegerRange {
  std::int64_t start = 0, stop = 0, step = 1;
  std::uint64_t size() const;
  std::int64_t at(std::uint64_t i) const {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(start) + i * static_cast<std::uint64_t>(step));
  }
};

/// The items of a list or tuple. Releasing a list nested a million deep takes no more stack than a flat one.
struct Items {
  std::vector<Value> values;
  Items() = default;
  explicit Items(std::vector<Value> v);
  Items(const Items&) = delete;
  Items& operator=(const Items&) = delete;
  ~Items();
};
struct List : Items {
  using Items::Items;
};
struct Tuple : Items {
  using Items::Items;
};

class Value {
 public:
  /// In the order of the variant below.
  enum class Kind : std::uint8_t { none, boolean, integer, real, string, list, tuple, range, shape, command };

  Value() = default;
  Value(bool b) : state_(b) {}
  Value(int i) : state_(std::int64_t{i}) {}
  Value(std::int64_t i) : state_(i) {}
  Value(double d) : state_(d) {}
  Value(const char* text) : Value(std::string(text)) {}
  Value(std::string text) : state_(std::make_shared<const std::string>(std::move(text))) {}
  Value(std::shared_ptr<List> list) : state_(std::move(list)) {}
  Value(std::shared_ptr<const Tuple> tuple) : state_(std::move(tuple)) {}
  Value(const IntegerRange& range) : state_(std::make_shared<const IntegerRange>(range)) {}
  Value(ShapePtr shape) : state_(std::move(shape)) {}
  explicit Value(const Command* command) : state_(command) {}
  static Value list(std::vector<Value> items) { return std::make_shared<List>(std::move(items)); }
  static Value tuple(std::vector<Value> items) { return std::make_shared<const Tuple>(std::move(items)); }

  Kind kind() const { return static_cast<Kind>(state_.index()); }
  bool is(Kind k) const { return kind() == k; }
  bool is_none() const { return is(Kind::none); }
  /// A whole or real number; True and False are not numbers here.
  bool is_number() const { return is(Kind::integer) || is(Kind::real); }
  /// A list or a tuple.
  bool is_sequence() const { return is(Kind::list) || is(Kind::tuple); }

  // Each asks for the kind that it names.
  bool boolean() const { return *std::get_if<bool>(&state_); }
  std::int64_t integer() const { return *std::get_if<std::int64_t>(&state_); }
  double real() const { return *std::get_if<double>(&state_); }
  const std::string& string() const { return **std::get_if<std::shared_ptr<const std::string>>(&state_); }
  const std::shared_ptr<List>& list_pointer() const { return *std::get_if<std::shared_ptr<List>>(&state_); }
  const IntegerRange& range() const { return **std::get_if<std::shared_ptr<const IntegerRange>>(&state_); }
  const ShapePtr& shape() const { return *std::get_if<ShapePtr>(&state_); }
  const Command* command() const { return *std::get_if<const Command*>(&state_); }
  /// The number as a double; asks for is_number().
  double number() const { return is(Kind::integer) ? static_cast<double>(integer()) : real(); }
  /// The items of a list or tuple.
  const std::vector<Value>& items() const;
  /// Do both hold the very same object (or equal simple values)?
  bool identical(const Value& other) const;

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::shared_ptr<const std::string>, std::shared_ptr<List>,
               std::shared_ptr<const Tuple>, std::shared_ptr<const IntegerRange>, ShapePtr, const Command*>
      state_;
};

/// How real numbers are written: the shortest text that reads back the same, or always 17 significant digits.
enum class Digits { shortest, seventeen };

/// A real number as Python writes it ("3.0", "1e+22"), locale-free.
std::string number_text(double value, Digits digits = Digits::shortest);

/// The value as one would type it (text in quotes). Lists nested deeper than 100 and texts longer than `limit`
/// characters are cut with "...".
std::string repr(const Value& value, Digits digits = Digits::shortest, std::size_t limit = std::size_t{1} << 26);

/// As repr, but text without quotes: what print() writes.
std::string display(const Value& value, Digits digits = Digits::shortest);

/// "a whole number", "a list", ...: for messages.
const char* kind_name(const Value& value);

/// "'abc', a text" or "-3, a whole number": what was given, for messages; at most about 60 characters of the value.
std::string given_text(const Value& value);

/// Python's truth: False for None, 0, empty text and empty lists.
bool truth(const Value& value);

/// Python's ==: numbers by value, sequences item by item (a list never equals a tuple), shapes when they are the same
/// entities of the same model. Lists nested more than 1000 deep are unequal unless identical.
bool equal(const Value& a, const Value& b);

}  // namespace aresta::document
