// SPDX-License-Identifier: Apache-2.0
// Errors as values. A function that can fail returns Result<T>; nobody signals failure by an empty or null result.
#pragma once

#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/ids.h"

namespace aresta {

/// What a failure means for the caller of the program; decides the exit status.
enum class Failure { operation, usage, file, cancelled };

/// A kind of error: a number (a range of a hundred per module) and a name such as "boolean.regions_overlap".
/// Every module declares its own in its errors.h, as inline constexpr objects.
struct ErrorCode {
  int number = 0;
  const char* name = "";
  Failure failure = Failure::operation;
  constexpr bool operator==(const ErrorCode& other) const { return number == other.number; }
};

namespace errors {  // base: 100-199
inline constexpr ErrorCode cancelled{100, "cancelled", Failure::cancelled};
inline constexpr ErrorCode invalid_argument{101, "argument.invalid", Failure::operation};
inline constexpr ErrorCode module_missing{102, "module.missing", Failure::operation};
inline constexpr ErrorCode internal{103, "internal", Failure::operation};
inline constexpr ErrorCode too_large{104, "argument.too_large", Failure::operation};
inline constexpr ErrorCode file_unwritable{105, "file.unwritable", Failure::file};
inline constexpr ErrorCode file_unreadable{106, "file.unreadable", Failure::file};
}  // namespace errors

/// One error: what happened, to which entities, where, and what to try.
struct Error {
  ErrorCode code;
  std::string message;
  std::vector<EntityRef> entities = {};
  std::optional<std::array<double, 3>> place = {};
  std::string hint = {};
  std::string location = {};  ///< the place in a script, "FILE:LINE:COLUMN"

  /// One line for a person: "FILE:LINE:COLUMN: code: message (face 7, edge 12; at 1 2 3); try: hint".
  std::string to_line() const;
};

/// A value or an Error.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() & { return assert(ok()), *std::get_if<0>(&state_); }
  const T& value() const& { return assert(ok()), *std::get_if<0>(&state_); }
  T&& value() && { return assert(ok()), std::move(*std::get_if<0>(&state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  Error& error() { return assert(!ok()), *std::get_if<1>(&state_); }
  const Error& error() const { return assert(!ok()), *std::get_if<1>(&state_); }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  Error& error() { return *error_; }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

using Status = Result<void>;

}  // namespace aresta

#define ARESTA_CONCAT_(a, b) a##b
#define ARESTA_CONCAT(a, b) ARESTA_CONCAT_(a, b)

/// ARESTA_TRY(auto x, f()): x is f()'s value; on error the enclosing function returns the error.
#define ARESTA_TRY(target, expression) ARESTA_TRY_(ARESTA_CONCAT(aresta_try_, __LINE__), target, expression)
#define ARESTA_TRY_(name, target, expression)     \
  auto name = (expression);                       \
  if (!name.ok()) return std::move(name).error(); \
  target = std::move(name).value()

/// ARESTA_CHECK(f()): on error the enclosing function returns the error; the value, if any, is dropped.
#define ARESTA_CHECK(expression)                          \
  do {                                                    \
    auto status_ = (expression);                          \
    if (!status_.ok()) return std::move(status_).error(); \
  } while (false)
