// SPDX-License-Identifier: Apache-2.0
// The single registry of commands. A command declares its name, typed parameters (type, unit, default, range), its
// documentation, an example and the errors it can give, once; the script language, help pages and every other front
// end derive from these declarations, and arguments are checked against them in one place: bind().
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/context.h"
#include "document/value.h"
#include "math/vec.h"

namespace aresta::document {

/// What a parameter accepts. Real numbers must be finite, everywhere.
enum class Type {
  any,
  boolean,
  integer,  ///< a whole number (3.0 counts)
  number,
  string,
  sequence,     ///< a list, tuple or range of anything
  numbers,      ///< a list or tuple of numbers
  point,        ///< three numbers
  direction,    ///< three numbers, not all zero
  points,       ///< a list or tuple of points
  point_lists,  ///< a list or tuple of such
  index_loops,  ///< faces by point numbers: each a list of numbers from 0, or a list of such (holes after the outer)
  shape,
  shape_or_point,
  shapes,   ///< a shape, or a list or tuple of shapes
  command,  ///< the name of a command, as in sorted(xs, key=volume)
};

/// In words, as in "a point (x, y, z)".
const char* type_text(Type type);

/// Where numbers may lie; for sequences of numbers, each of them.
struct Limits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< `low` itself is not allowed

  bool any() const;
  bool holds(double x) const { return (low_open ? x > low : x >= low) && x <= high; }
  /// As in "greater than 0" or "between 1 and 64".
  std::string text() const;
};
inline constexpr Limits positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Limits not_negative{0, std::numeric_limits<double>::infinity(), false};

struct Parameter {
  std::string name;
  Type type = Type::any;
  std::string doc = {};
  std::string unit = {};                    ///< "length", "degrees", or empty
  std::optional<Value> default_value = {};  ///< none: must be given. None: may be left out or given as None
  Limits limits = {};
  std::vector<std::string> choices = {};  ///< the allowed texts; empty: any
  std::size_t size = 0;                   ///< of a sequence; 0: any
  bool variadic = false;                  ///< takes all further positional arguments, as a tuple
  bool keyword_only = false;
};

class Registry;

/// What goes on around a command while it runs: whom it prints to, who may interrupt it, the settings.
struct Session {
  const Registry* registry = nullptr;
  Context context = {};
  /// Takes text as it is, line ends included.
  std::function<Status(const std::string&)> print = {};
  Digits digits = Digits::seventeen;
  double tolerance = 0;  ///< of operations, in document units; 0: each model's own
  /// Every shape that a command gave, the latest last.
  std::vector<std::weak_ptr<const Shape>> made = {};
  /// Told of each finished command that is not part of the language itself (not len, print, sqrt, ...).
  std::function<void(const Command&, double seconds, const Value* result)> finished = {};
};

/// One call of a command whose arguments have been checked: each parameter has a value of its type.
class Call {
 public:
  Call(const Command& command, std::vector<Value> arguments, Session& session)
      : command_(command), arguments_(std::move(arguments)), session_(session) {}

  const Command& command() const { return command_; }
  Session& session() const { return session_; }
  const Context& context() const { return session_.context; }

  /// The argument by its parameter's name (a name that the command declares).
  const Value& operator[](std::string_view name) const;
  bool boolean(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  double number(std::string_view name) const { return (*this)[name].number(); }
  const std::string& string(std::string_view name) const { return (*this)[name].string(); }
  Vec3 point(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;
  std::vector<Vec3> points(std::string_view name) const;
  std::vector<std::vector<Vec3>> point_lists(std::string_view name) const;
  std::vector<std::vector<std::vector<std::size_t>>> index_loops(std::string_view name) const;
  ShapePtr shape(std::string_view name) const { return (*this)[name].shape(); }
  /// Of a parameter of type shapes, or a variadic one of that type: all of them, flat.
  std::vector<ShapePtr> shapes(std::string_view name) const;
  const std::vector<Value>& items(std::string_view name) const { return (*this)[name].items(); }

 private:
  const Command& command_;
  std::vector<Value> arguments_;
  Session& session_;
};

using Function = std::function<Result<Value>(Call&)>;

struct Command {
  std::string name;
  std::string group;  ///< a heading of the help, as in "solids"; "language" and "mathematics" are the language itself
  std::vector<Parameter> parameters = {};
  std::string returns = {};            ///< what comes back, in words
  std::string doc = {};                ///< first sentence: what it does
  std::string example = {};            ///< a line of script
  std::vector<ErrorCode> errors = {};  ///< that its function can give, besides those of wrong arguments
  Function function = {};

  /// As in "block(dx, dy, dz, at=(0, 0, 0))".
  std::string signature() const;
  bool of_the_language() const { return group == "language" || group == "mathematics"; }
};

struct Constant {
  std::string name;
  Value value;
  std::string doc;
};

/// Arguments as written: positional ones, then name=value ones.
struct Arguments {
  std::vector<Value> positional = {};
  std::vector<std::pair<std::string, Value>> keywords = {};
};

class Registry {
 public:
  /// Asks for a name that is not taken, and for declarations that make sense (checked by assertions).
  void add(Command command);
  void add(Constant constant);

  const Command* find(std::string_view name) const;
  const Constant* find_constant(std::string_view name) const;
  /// All commands, sorted by name.
  const std::map<std::string, Command, std::less<>>& commands() const { return commands_; }
  const std::map<std::string, Constant, std::less<>>& constants() const { return constants_; }
  /// The groups in the order in which they were first declared.
  const std::vector<std::string>& groups() const { return groups_; }
  /// The page of help of a command: signature, doc, each parameter with its type, unit, range and default, example.
  static std::string help(const Command& command);

 private:
  std::map<std::string, Command, std::less<>> commands_;
  std::map<std::string, Constant, std::less<>> constants_;
  std::vector<std::string> groups_;
};

/// Checks arguments against the declaration: count, names, types, ranges, finite numbers. Gives one value per
/// parameter, defaults filled in. Errors name the parameter, what was expected and what was given.
Result<std::vector<Value>> bind(const Command& command, Arguments arguments);

/// bind(), then the command's function; tells session.finished.
Result<Value> invoke(const Command& command, Arguments arguments, Session& session);

/// The nearest of `names` to `name` by edit distance, if near enough to be meant; else empty.
std::string nearest_name(std::string_view name, const std::vector<std::string>& names);

}  // namespace aresta::document
