// SPDX-License-Identifier: Apache-2.0
#include "script/interpreter.h"

#include <algorithm>

#include "script/errors.h"
#include "script/operators.h"

namespace aresta::script {

using document::Value;
using Kind = Value::Kind;

/// Gives every name that is assigned anywhere a slot. Variables of a list's `for` are seen in that list only.
class Interpreter::Resolver {
 public:
  explicit Resolver(Interpreter& interpreter) : interpreter_(interpreter) {}

  void run(Block& block) {
    declare(block);
    resolve(block);
  }

 private:
  void declare(const Expr& target) {
    if (target.kind == ExprKind::name) {
      interpreter_.slot_of(target.text);
    } else if (target.kind == ExprKind::tuple || target.kind == ExprKind::list) {
      for (const ExprPtr& c : target.children) declare(*c);
    }
  }

  void declare(const Block& block) {
    for (const Stmt& s : block) {
      for (const ExprPtr& t : s.targets) declare(*t);
      for (const Branch& b : s.branches) declare(b.body);
      declare(s.body);
      declare(s.orelse);
    }
  }

  void resolve(Block& block) {
    for (Stmt& s : block) {
      for (ExprPtr& t : s.targets) resolve(t);
      resolve(s.value);
      resolve(s.message);
      for (Branch& b : s.branches) {
        resolve(b.condition);
        resolve(b.body);
      }
      resolve(s.body);
      resolve(s.orelse);
    }
  }

  void resolve(ExprPtr& e) {
    if (!e) return;
    if (e->kind == ExprKind::name) {
      e->slot = lookup(e->text);
    } else if (e->kind == ExprKind::comprehension) {
      const std::size_t depth = locals_.size();
      for (Clause& clause : e->clauses) {
        resolve(clause.iterable);
        bind_local(*clause.target);
        resolve(clause.target);
        for (ExprPtr& c : clause.conditions) resolve(c);
      }
      resolve(e->children[0]);
      locals_.resize(depth);
    } else {
      for (ExprPtr& c : e->children) resolve(c);
    }
  }

  void bind_local(const Expr& target) {
    if (target.kind == ExprKind::name) {
      // A slot by nesting depth: lists at the same depth may share it, they are never built at the same time.
      locals_.emplace_back(target.text, interpreter_.slot_of(target.text + "@" + std::to_string(locals_.size())));
    } else if (target.kind == ExprKind::tuple || target.kind == ExprKind::list) {
      for (const ExprPtr& c : target.children) bind_local(*c);
    }
  }

  int lookup(const std::string& name) const {
    for (auto it = locals_.rbegin(); it != locals_.rend(); ++it) {
      if (it->first == name) return it->second;
    }
    const auto found = interpreter_.slots_.find(name);
    return found == interpreter_.slots_.end() ? -1 : found->second;
  }

  Interpreter& interpreter_;
  std::vector<std::pair<std::string, int>> locals_;
};

Interpreter::Interpreter(document::Session& session) : session_(session) {}

Interpreter::~Interpreter() {
  for (const auto& weak : watched_) {
    if (const auto list = weak.lock()) {
      const std::vector<Value> released = std::move(list->values);
      list->values.clear();
    }
  }
}

int Interpreter::slot_of(const std::string& name) {
  const auto [found, is_new] = slots_.emplace(name, static_cast<int>(variables_.size()));
  if (is_new) variables_.push_back({.value = {}, .is_set = false, .name = name});
  return found->second;
}

void Interpreter::set(const std::string& name, Value value) {
  Variable& v = variables_[static_cast<std::size_t>(slot_of(name))];
  v.value = std::move(value);
  v.is_set = true;
}

const Value* Interpreter::get(const std::string& name) const {
  const auto found = slots_.find(name);
  if (found == slots_.end()) return nullptr;
  const Variable& v = variables_[static_cast<std::size_t>(found->second)];
  return v.is_set ? &v.value : nullptr;
}

Status Interpreter::run(std::string_view text, const std::string& file) {
  ARESTA_CHECK(evaluate(text, file));
  return {};
}

Result<Value> Interpreter::evaluate(std::string_view text, const std::string& file) {
  file_ = file;
  last_ = Value();
  ARESTA_TRY(Script script, parse(text, file));
  Resolver(*this).run(script.body);
  Flow flow = Flow::normal;
  ARESTA_CHECK(run_block(script.body, flow));
  return std::move(last_);
}

Status Interpreter::interrupted(Place place) const {
  if (!session_.context.cancelled()) return {};
  return at(Error{errors::cancelled, "the script was interrupted"}, place);
}

void Interpreter::watch(const Value& list, const Value& held) {
  if (held.is_sequence() && list.is(Kind::list)) {
    // Once per list is enough; the commonest repetition is the same list again and again.
    if (!watched_.empty() && watched_.back().lock() == list.list_pointer()) return;
    watched_.push_back(list.list_pointer());
    if (watched_.size() >= 1024 && (watched_.size() & (watched_.size() - 1)) == 0) {
      std::erase_if(watched_, [](const auto& weak) { return weak.expired(); });
    }
  }
}

// Statements.

Status Interpreter::run_block(const Block& block, Flow& flow) {
  for (const Stmt& s : block) {
    ARESTA_CHECK(interrupted(s.place));
    line_ = s.place.line;
    ARESTA_CHECK(run_statement(s, flow));
    if (flow != Flow::normal) return {};
  }
  return {};
}

Status Interpreter::run_statement(const Stmt& s, Flow& flow) {
  last_ = Value();
  switch (s.kind) {
    case StmtKind::expression:
      return eval(*s.value, last_);
    case StmtKind::assign: {
      Value value;
      ARESTA_CHECK(eval(*s.value, value));
      for (const ExprPtr& t : s.targets) ARESTA_CHECK(assign(*t, value));
      return {};
    }
    case StmtKind::augment:
      return run_augmented(s);
    case StmtKind::assertion:
      return run_assert(s);
    case StmtKind::if_else:
      return run_if(s, flow);
    case StmtKind::for_loop:
      return run_for(s, flow);
    case StmtKind::while_loop:
      return run_while(s, flow);
    case StmtKind::pass:
      return {};
    case StmtKind::break_loop:
      flow = Flow::broken;
      return {};
    case StmtKind::continue_loop:
      flow = Flow::continued;
      return {};
  }
  return {};
}

Status Interpreter::run_if(const Stmt& s, Flow& flow) {
  for (const Branch& branch : s.branches) {
    if (branch.condition) {
      Value condition;
      ARESTA_CHECK(eval(*branch.condition, condition));
      if (!document::truth(condition)) continue;
    }
    return run_block(branch.body, flow);
  }
  return {};
}

template <class Body>
Status Interpreter::for_each(const Value& iterable, Place place, Body&& body) {
  bool stop = false;
  switch (iterable.kind()) {
    case Kind::range: {
      const document::IntegerRange r = iterable.range();
      const std::uint64_t n = r.size();
      for (std::uint64_t i = 0; i < n && !stop; ++i) {
        ARESTA_CHECK(interrupted(place));
        ARESTA_CHECK(body(Value(r.at(i)), stop));
      }
      return {};
    }
    case Kind::list:
    case Kind::tuple:
      // By index: the body may change the list's length.
      for (std::size_t i = 0; i < iterable.items().size() && !stop; ++i) {
        ARESTA_CHECK(interrupted(place));
        const Value item = iterable.items()[i];
        ARESTA_CHECK(body(item, stop));
      }
      return {};
    default: {
      auto items = items_of(iterable);
      if (!items) return at(std::move(items).error(), place);
      for (std::size_t i = 0; i < items->size() && !stop; ++i) {
        ARESTA_CHECK(interrupted(place));
        ARESTA_CHECK(body((*items)[i], stop));
      }
      return {};
    }
  }
}

Status Interpreter::run_for(const Stmt& s, Flow& flow) {
  Value iterable;
  ARESTA_CHECK(eval(*s.value, iterable));
  bool broken = false;
  Status done = for_each(iterable, s.value->place, [&](const Value& item, bool& stop) -> Status {
    ARESTA_CHECK(assign(*s.targets[0], item));
    Flow inner = Flow::normal;
    ARESTA_CHECK(run_block(s.body, inner));
    stop = broken = inner == Flow::broken;
    return {};
  });
  if (!done || broken) return done;
  return run_block(s.orelse, flow);
}

Status Interpreter::run_while(const Stmt& s, Flow& flow) {
  for (;;) {
    ARESTA_CHECK(interrupted(s.place));
    Value condition;
    ARESTA_CHECK(eval(*s.value, condition));
    if (!document::truth(condition)) break;
    Flow inner = Flow::normal;
    ARESTA_CHECK(run_block(s.body, inner));
    if (inner == Flow::broken) return {};
  }
  return run_block(s.orelse, flow);
}

Status Interpreter::run_assert(const Stmt& s) {
  Value condition;
  ARESTA_CHECK(eval(*s.value, condition));
  if (document::truth(condition)) return {};
  std::string message = "the assertion is not true";
  if (s.message) {
    Value text;
    ARESTA_CHECK(eval(*s.message, text));
    message = document::display(text);
  } else if (s.value->kind == ExprKind::compare && s.value->children.size() == 2) {
    // Say what was compared. Evaluated again only when both sides are names, so that nothing is done twice.
    const auto simple = [](const Expr& e) { return e.kind == ExprKind::name || e.kind == ExprKind::constant; };
    const Expr &left = *s.value->children[0], &right = *s.value->children[1];
    if (simple(left) && simple(right)) {
      Value a, b;
      ARESTA_CHECK(eval(left, a));
      ARESTA_CHECK(eval(right, b));
      message += ": " + document::repr(a, document::Digits::shortest, 200) + " " + op_text(s.value->ops[0].op) + " " +
                 document::repr(b, document::Digits::shortest, 200);
    }
  }
  return at(Error{errors::script_assertion, message}, s.place);
}

Status Interpreter::run_augmented(const Stmt& s) {
  const Expr& target = *s.targets[0];
  Value old, operand;
  if (target.kind == ExprKind::name) {
    ARESTA_CHECK(eval(target, old));
    ARESTA_CHECK(eval(*s.value, operand));
    ARESTA_CHECK(at(binary(s.op, old, operand, session_, old), s.place));
    return assign(target, old);
  }
  Value container, key;
  ARESTA_CHECK(eval(*target.children[0], container));
  ARESTA_CHECK(eval(*target.children[1], key));
  ARESTA_CHECK(at(index(container, key, old), target.place));
  ARESTA_CHECK(eval(*s.value, operand));
  ARESTA_CHECK(at(binary(s.op, old, operand, session_, old), s.place));
  watch(container, old);
  return at(assign_index(container, key, old), target.place);
}

Status Interpreter::assign(const Expr& target, const Value& value) {
  switch (target.kind) {
    case ExprKind::name: {
      Variable& v = variables_[static_cast<std::size_t>(target.slot)];
      v.value = value;
      v.is_set = true;
      return {};
    }
    case ExprKind::index: {
      Value container, key;
      ARESTA_CHECK(eval(*target.children[0], container));
      ARESTA_CHECK(eval(*target.children[1], key));
      watch(container, value);
      return at(assign_index(container, key, value), target.place);
    }
    default:
      return unpack(target, value);
  }
}

Status Interpreter::unpack(const Expr& target, const Value& value) {
  const std::size_t wanted = target.children.size();
  if (value.is(Kind::range) && value.range().size() != wanted) {  // without making a list of it
    return at(Error{errors::script_unpack,
                    std::to_string(wanted) + " variables, but " + std::to_string(value.range().size()) + " values"},
              target.place);
  }
  auto items = items_of(value);
  if (!items) {
    return at(Error{errors::script_unpack, std::string(document::kind_name(value)) + " cannot be shared out to " +
                                               std::to_string(wanted) + (wanted == 1 ? " variable" : " variables")},
              target.place);
  }
  if (items->size() != wanted) {
    return at(
        Error{errors::script_unpack, std::to_string(wanted) + (wanted == 1 ? " variable" : " variables") + ", but " +
                                         std::to_string(items->size()) + (items->size() == 1 ? " value" : " values")},
        target.place);
  }
  for (std::size_t i = 0; i < wanted; ++i) ARESTA_CHECK(assign(*target.children[i], (*items)[i]));
  return {};
}

// Expressions.

Status Interpreter::eval(const Expr& e, Value& out) {
  switch (e.kind) {
    case ExprKind::constant:
      out = e.value;
      return {};
    case ExprKind::name:
      return eval_name(e, out);
    case ExprKind::negate:
      ARESTA_CHECK(eval(*e.children[0], out));
      return at(script::negate(out, out), e.place);
    case ExprKind::plus:
      ARESTA_CHECK(eval(*e.children[0], out));
      if (out.is_number()) return {};
      return at(Error{errors::script_type, std::string("'+' is not defined for ") + document::kind_name(out)}, e.place);
    case ExprKind::logical_not:
      ARESTA_CHECK(eval(*e.children[0], out));
      out = !document::truth(out);
      return {};
    case ExprKind::chain:
      return eval_chain(e, out);
    case ExprKind::compare:
      return eval_compare(e, out);
    case ExprKind::logical_and:
    case ExprKind::logical_or:
      return eval_logical(e, out);
    case ExprKind::conditional:
      ARESTA_CHECK(eval(*e.children[1], out));
      return eval(*e.children[document::truth(out) ? 0 : 2], out);
    case ExprKind::call:
      return eval_call(e, out);
    case ExprKind::method:
      return eval_method(e, out);
    case ExprKind::index:
    case ExprKind::slice:
      return eval_slice(e, out);
    case ExprKind::list:
    case ExprKind::tuple:
      return eval_items(e, out);
    case ExprKind::comprehension:
      return eval_comprehension(e, out);
    case ExprKind::formatted:
      return eval_formatted(e, out);
  }
  return {};
}

Status Interpreter::eval_name(const Expr& e, Value& out) {
  if (e.slot >= 0) {
    const Variable& v = variables_[static_cast<std::size_t>(e.slot)];
    if (v.is_set) {
      out = v.value;
      return {};
    }
  }
  if (const document::Command* command = session_.registry->find(e.text)) {
    out = Value(command);
    return {};
  }
  if (const document::Constant* constant = session_.registry->find_constant(e.text)) {
    out = constant->value;
    return {};
  }
  if (e.slot >= 0 && slots_.count(e.text) > 0) {
    return at(Error{errors::script_name, "'" + e.text + "' has no value yet: it is assigned further below"}, e.place);
  }
  std::vector<std::string> names;
  for (const Variable& v : variables_) {
    if (v.is_set && v.name.find('@') == std::string::npos) names.push_back(v.name);
  }
  for (const auto& [name, command] : session_.registry->commands()) names.push_back(name);
  for (const auto& [name, constant] : session_.registry->constants()) names.push_back(name);
  const std::string near = document::nearest_name(e.text, names);
  return at(Error{errors::script_name,
                  "unknown name '" + e.text + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?")},
            e.place);
}

Status Interpreter::eval_chain(const Expr& e, Value& out) {
  ARESTA_CHECK(eval(*e.children[0], out));
  Value right;
  for (std::size_t i = 0; i < e.ops.size(); ++i) {
    ARESTA_CHECK(eval(*e.children[i + 1], right));
    ARESTA_CHECK(at(binary(e.ops[i].op, out, right, session_, out), e.ops[i].place));
  }
  return {};
}

Status Interpreter::eval_compare(const Expr& e, Value& out) {
  Value left, right;
  ARESTA_CHECK(eval(*e.children[0], left));
  for (std::size_t i = 0; i < e.ops.size(); ++i) {
    ARESTA_CHECK(eval(*e.children[i + 1], right));
    ARESTA_CHECK(at(binary(e.ops[i].op, left, right, session_, out), e.ops[i].place));
    if (!document::truth(out)) return {};
    left = std::move(right);
  }
  return {};
}

Status Interpreter::eval_logical(const Expr& e, Value& out) {
  for (const ExprPtr& c : e.children) {
    ARESTA_CHECK(eval(*c, out));
    if (document::truth(out) == (e.kind == ExprKind::logical_or)) return {};
  }
  return {};
}

Status Interpreter::eval_arguments(const Expr& e, document::Arguments& out) {
  out.positional.reserve(e.keywords.size());
  for (std::size_t i = 0; i < e.keywords.size(); ++i) {
    Value value;
    ARESTA_CHECK(eval(*e.children[i + 1], value));
    if (e.keywords[i].empty()) {
      out.positional.push_back(std::move(value));
    } else if (e.keywords[i] == "*") {
      auto items = items_of(value);
      if (!items) return at(std::move(items).error(), e.children[i + 1]->place);
      out.positional.insert(out.positional.end(), items->begin(), items->end());
    } else {
      out.keywords.emplace_back(e.keywords[i], std::move(value));
    }
  }
  return {};
}

Status Interpreter::eval_call(const Expr& e, Value& out) {
  Value callee;
  ARESTA_CHECK(eval(*e.children[0], callee));
  if (!callee.is(Kind::command)) {
    const bool named = e.children[0]->kind == ExprKind::name;
    const bool hides = named && session_.registry->find(e.children[0]->text) != nullptr;
    return at(Error{errors::script_type, (named ? "'" + e.children[0]->text + "' is " : "this is ") +
                                             document::given_text(callee) + ", and cannot be called" +
                                             (hides ? "; a variable of that name hides the command" : "")},
              e.place);
  }
  document::Arguments arguments;
  ARESTA_CHECK(eval_arguments(e, arguments));
  const int line = line_;
  line_ = e.place.line;
  auto result = document::invoke(*callee.command(), std::move(arguments), session_);
  line_ = line;
  if (!result) return at(std::move(result).error(), e.place);
  out = std::move(*result);
  return {};
}

Status Interpreter::eval_method(const Expr& e, Value& out) {
  Value target;
  ARESTA_CHECK(eval(*e.children[0], target));
  document::Arguments arguments;
  ARESTA_CHECK(eval_arguments(e, arguments));
  if (!arguments.keywords.empty()) {
    return at(Error{errors::script_type, "." + e.text + " takes no named arguments"}, e.place);
  }
  for (const Value& v : arguments.positional) watch(target, v);
  Status status = method(target, e.text, std::move(arguments.positional), out);
  if (!status && status.error().hint.empty() && target.is(Value::Kind::shape) &&
      session_.registry->find(e.text) != nullptr) {
    status.error().hint = e.text + "(x)";
  }
  return at(std::move(status), e.place);
}

Status Interpreter::eval_slice(const Expr& e, Value& out) {
  Value container, key[3];
  ARESTA_CHECK(eval(*e.children[0], container));
  for (std::size_t i = 1; i < e.children.size(); ++i) {
    if (e.children[i]) ARESTA_CHECK(eval(*e.children[i], key[i - 1]));
  }
  if (e.kind == ExprKind::index) return at(index(container, key[0], out), e.place);
  return at(slice(container, key[0], key[1], key[2], out), e.place);
}

Status Interpreter::eval_items(const Expr& e, Value& out) {
  std::vector<Value> items(e.children.size());
  for (std::size_t i = 0; i < items.size(); ++i) ARESTA_CHECK(eval(*e.children[i], items[i]));
  out = e.kind == ExprKind::list ? Value::list(std::move(items)) : Value::tuple(std::move(items));
  return {};
}

Status Interpreter::eval_comprehension(const Expr& e, Value& out) {
  std::vector<Value> items;
  ARESTA_CHECK(eval_clause(e, 0, items));
  out = Value::list(std::move(items));
  return {};
}

Status Interpreter::eval_clause(const Expr& e, std::size_t clause, std::vector<Value>& items) {
  if (clause == e.clauses.size()) {
    if (items.size() >= max_items) return at(Error{errors::script_too_large, "the list would be too long"}, e.place);
    Value item;
    ARESTA_CHECK(eval(*e.children[0], item));
    items.push_back(std::move(item));
    return {};
  }
  const Clause& c = e.clauses[clause];
  Value iterable;
  ARESTA_CHECK(eval(*c.iterable, iterable));
  return for_each(iterable, c.iterable->place, [&](const Value& item, bool&) -> Status {
    ARESTA_CHECK(assign(*c.target, item));
    for (const ExprPtr& condition : c.conditions) {
      Value holds;
      ARESTA_CHECK(eval(*condition, holds));
      if (!document::truth(holds)) return {};
    }
    return eval_clause(e, clause + 1, items);
  });
}

Status Interpreter::eval_formatted(const Expr& e, Value& out) {
  std::string text;
  for (std::size_t i = 0; i < e.children.size(); ++i) {
    Value value;
    ARESTA_CHECK(eval(*e.children[i], value));
    const std::string& spec = e.keywords[i];
    auto part = format(value, spec.empty() ? std::string_view() : std::string_view(spec).substr(1));
    if (!part) return at(std::move(part).error(), e.children[i]->place);
    text += *part;
    if (text.size() > max_text) return at(Error{errors::script_too_large, "the text would be too long"}, e.place);
  }
  out = std::move(text);
  return {};
}

Value value_of_definition(std::string_view text) {
  document::Registry empty;
  document::Session session{.registry = &empty};
  Interpreter interpreter(session);
  auto value = interpreter.evaluate(text, "-D");
  // Only what is a single literal or expression counts as one; None comes of statements and of the word itself.
  if (value && (!value->is_none() || text == "None") && !text.empty() && parse_expression(text, "-D"))
    return std::move(*value);
  return std::string(text);
}

}  // namespace aresta::script
