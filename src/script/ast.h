// SPDX-License-Identifier: Apache-2.0
// The tree of a script. Chains of operators of one precedence are one node with many children, so that the depth of
// the tree is bounded by the parser whatever the length of a sum.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/value.h"
#include "script/token.h"

namespace aresta::script {

enum class Op : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  floor_divide,
  modulo,
  power,
  bit_and,
  equal,
  not_equal,
  less,
  less_equal,
  greater,
  greater_equal,
  in,
  not_in,
  is,
  is_not
};

/// As it is written in a script; and the other way round, as in "+" or "not in".
const char* op_text(Op op);
std::optional<Op> op_named(std::string_view text);

enum class ExprKind : std::uint8_t {
  constant,  ///< value
  name,      ///< text, slot
  negate,    ///< children[0]; likewise plus, logical_not
  plus,
  logical_not,
  chain,        ///< arithmetic from left to right: children[0] ops[0] children[1] ops[1] ...
  compare,      ///< chained comparison, with ops
  logical_and,  ///< children, at least two; likewise logical_or
  logical_or,
  conditional,  ///< children: value if true, condition, value if false
  call,         ///< children[0] is called with the rest; keywords as long as the arguments ("" positional, "*" spread)
  method,       ///< children[0] . text ( rest ), arguments as in call
  index,        ///< children[0][children[1]]
  slice,        ///< children[0][children[1] : children[2] : children[3]], absent ones null
  list,
  tuple,
  comprehension,  ///< children[0] for clauses
  formatted       ///< children joined as text, each by its format in keywords ("" plain)
};

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;

/// A clause of a comprehension: `for targets in iterable if condition...`.
struct Clause {
  ExprPtr target;
  ExprPtr iterable;
  std::vector<ExprPtr> conditions;
};

struct PlacedOp {
  Op op;
  Place place;
};

struct Expr {
  ExprKind kind = ExprKind::constant;
  Place place;
  int slot = -1;  ///< of a name: its variable; -1: none, it is a command or constant
  document::Value value;
  std::string text;
  std::vector<ExprPtr> children;
  std::vector<PlacedOp> ops;
  std::vector<std::string> keywords;
  std::vector<Clause> clauses;
};

enum class StmtKind : std::uint8_t {
  expression,  ///< value
  assign,      ///< targets = value
  augment,     ///< targets[0] op= value
  assertion,   ///< value, message (may be null)
  if_else,     ///< branches, the last without a condition when there is an else
  for_loop,    ///< targets[0] in value: body, orelse
  while_loop,  ///< value: body, orelse
  pass,
  break_loop,
  continue_loop
};

struct Stmt;
using Block = std::vector<Stmt>;

struct Branch {
  ExprPtr condition;
  Block body;
};

struct Stmt {
  StmtKind kind = StmtKind::pass;
  Place place;
  Op op = Op::add;
  std::vector<ExprPtr> targets = {};
  ExprPtr value = {};
  ExprPtr message = {};
  std::vector<Branch> branches = {};
  Block body = {}, orelse = {};
};

struct Script {
  std::string file;
  Block body = {};
};

/// Parses a script; names have no slots yet. Errors are located: script.syntax, script.unsupported, script.too_deep...
Result<Script> parse(std::string_view text, const std::string& file);

/// Parses one expression, as in the value of -D name=value.
Result<ExprPtr> parse_expression(std::string_view text, const std::string& file);

}  // namespace aresta::script
