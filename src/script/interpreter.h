// SPDX-License-Identifier: Apache-2.0
// Runs scripts: the command language of .ars files, a subset of Python.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "document/registry.h"
#include "script/ast.h"

namespace aresta::script {

/// Variables and how to run text over them. Variables stay from one run to the next, as a dialogue needs.
/// Interrupted by the session's context between any two statements or items; nothing in a script can overflow the
/// stack or hang what is not a loop.
class Interpreter {
 public:
  /// The session must have its registry and stay while the interpreter does.
  explicit Interpreter(document::Session& session);
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// Runs a script. Errors are located in `file`, as in "box.ars:7:3".
  Status run(std::string_view text, const std::string& file);

  /// Runs a script and gives the value of its last statement when that is an expression, else None.
  Result<document::Value> evaluate(std::string_view text, const std::string& file);

  void set(const std::string& name, document::Value value);
  /// None when there is no such variable.
  const document::Value* get(const std::string& name) const;

  /// The line of the statement being run: for the log of commands.
  int line() const { return line_; }

 private:
  class Resolver;
  struct Variable {
    document::Value value;
    bool is_set = false;
    std::string name;
  };
  enum class Flow : std::uint8_t { normal, broken, continued };

  int slot_of(const std::string& name);

  Status run_block(const Block& block, Flow& flow);
  Status run_statement(const Stmt& s, Flow& flow);
  Status run_if(const Stmt& s, Flow& flow);
  Status run_for(const Stmt& s, Flow& flow);
  Status run_while(const Stmt& s, Flow& flow);
  Status run_assert(const Stmt& s);
  Status run_augmented(const Stmt& s);
  Status assign(const Expr& target, const document::Value& value);
  Status unpack(const Expr& target, const document::Value& value);

  Status eval(const Expr& e, document::Value& out);
  Status eval_name(const Expr& e, document::Value& out);
  Status eval_chain(const Expr& e, document::Value& out);
  Status eval_compare(const Expr& e, document::Value& out);
  Status eval_logical(const Expr& e, document::Value& out);
  Status eval_call(const Expr& e, document::Value& out);
  Status eval_method(const Expr& e, document::Value& out);
  Status eval_slice(const Expr& e, document::Value& out);
  Status eval_items(const Expr& e, document::Value& out);
  Status eval_comprehension(const Expr& e, document::Value& out);
  Status eval_clause(const Expr& e, std::size_t clause, std::vector<document::Value>& items);
  Status eval_formatted(const Expr& e, document::Value& out);
  Status eval_arguments(const Expr& e, document::Arguments& out);

  /// Calls body(item) for each item; `flow` may end it.
  template <class Body>
  Status for_each(const document::Value& iterable, Place place, Body&& body);

  Status interrupted(Place place) const;
  Error at(Error error, Place place) const { return located(std::move(error), file_, place); }
  /// Locates the error of a failed status.
  Status at(Status status, Place place) const {
    if (status.ok()) return status;
    return at(std::move(status.error()), place);
  }
  /// A list that was given a list could hold itself: emptied at the end, so that nothing leaks.
  void watch(const document::Value& list, const document::Value& held);

  document::Session& session_;
  std::string file_;
  int line_ = 0;
  std::unordered_map<std::string, int> slots_;
  std::vector<Variable> variables_;
  std::vector<std::weak_ptr<document::List>> watched_;
  document::Value last_;
};

/// Adds the language's own commands (print, len, range, sqrt, ...) and constants to a registry.
void register_language(document::Registry& registry);

/// The value of `-D name=value`: a literal or expression of literals, else the text itself.
document::Value value_of_definition(std::string_view text);

}  // namespace aresta::script
