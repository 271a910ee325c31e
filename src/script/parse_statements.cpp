// SPDX-License-Identifier: Apache-2.0
// Statements: lines, blocks, and what may stand left of a =.
#include "script/parser.h"

namespace aresta::script {

Result<Block> Parser::script() {
  Block body;
  while (!at(TokenKind::end)) {
    if (at(TokenKind::indent)) return fail(errors::script_syntax, "this line is indented, but belongs to no block");
    ARESTA_CHECK(statement(body));
  }
  return body;
}

Status Parser::statement(Block& block) {
  const Guard guard(*this);
  ARESTA_CHECK(guard.check());
  if (at("if")) return if_statement(block);
  if (at("for")) return for_statement(block);
  if (at("while")) return while_statement(block);
  return simple_line(block);
}

Status Parser::simple_line(Block& block) {
  for (;;) {
    ARESTA_CHECK(simple_statement(block));
    if (!accept(";") || at(TokenKind::newline)) break;
  }
  if (at(TokenKind::newline)) {
    next();
    return {};
  }
  if (at(TokenKind::end)) return {};
  Error error = not_expected();
  const bool value = at(TokenKind::name) || at(TokenKind::integer) || at(TokenKind::real) || at(TokenKind::string);
  if (value && last_was_name_) error.hint = "a command's arguments in brackets, as in name(1, 2)";
  return error;
}

Status Parser::block(Block& body, const char* where) {
  ARESTA_CHECK(expect(":", where));
  if (!at(TokenKind::newline)) return simple_line(body);
  next();
  if (!at(TokenKind::indent)) return fail(errors::script_syntax, std::string("expected an indented block ") + where);
  next();
  while (!at(TokenKind::dedent) && !at(TokenKind::end)) {
    if (at(TokenKind::indent)) return fail(errors::script_syntax, "this line is indented, but belongs to no block");
    ARESTA_CHECK(statement(body));
  }
  if (at(TokenKind::dedent)) next();
  return {};
}

Status Parser::if_statement(Block& out) {
  Stmt s{.kind = StmtKind::if_else, .place = token().place};
  bool more = true;
  while (more) {
    next();  // if, elif
    Branch branch;
    ARESTA_CHECK(expression(branch.condition));
    ARESTA_CHECK(block(branch.body, "after the condition"));
    s.branches.push_back(std::move(branch));
    more = at("elif");
  }
  if (accept("else")) {
    Branch branch;
    ARESTA_CHECK(block(branch.body, "after else"));
    s.branches.push_back(std::move(branch));
  }
  out.push_back(std::move(s));
  return {};
}

Status Parser::loop_body(Stmt& s, const char* where) {
  ++loops_;
  ARESTA_CHECK(block(s.body, where));
  --loops_;
  if (accept("else")) ARESTA_CHECK(block(s.orelse, "after else"));
  return {};
}

Status Parser::for_statement(Block& out) {
  Stmt s{.kind = StmtKind::for_loop, .place = token().place};
  next();
  ExprPtr target;
  ARESTA_CHECK(for_targets(target));
  s.targets.push_back(std::move(target));
  ARESTA_CHECK(expression_list(s.value));
  ARESTA_CHECK(loop_body(s, "after the for line"));
  out.push_back(std::move(s));
  return {};
}

Status Parser::while_statement(Block& out) {
  Stmt s{.kind = StmtKind::while_loop, .place = token().place};
  next();
  ARESTA_CHECK(expression(s.value));
  ARESTA_CHECK(loop_body(s, "after the condition"));
  out.push_back(std::move(s));
  return {};
}

Status Parser::simple_statement(Block& out) {
  const Place place = token().place;
  Stmt s{.kind = StmtKind::pass, .place = place};
  last_was_name_ = at(TokenKind::name);
  if (at(TokenKind::keyword)) {
    const std::string& word = token().text;
    if (word == "pass" || word == "break" || word == "continue") {
      s.kind = word == "pass" ? StmtKind::pass : word == "break" ? StmtKind::break_loop : StmtKind::continue_loop;
      if (word != "pass" && loops_ == 0) return fail(errors::script_syntax, "'" + word + "' outside of a loop");
      next();
      out.push_back(std::move(s));
      return {};
    }
    if (word == "assert") {
      next();
      s.kind = StmtKind::assertion;
      ARESTA_CHECK(expression(s.value));
      if (accept(",")) ARESTA_CHECK(expression(s.message));
      out.push_back(std::move(s));
      return {};
    }
    if (word == "from" || word == "import") return import_statement();
    if (word == "elif" || word == "else") return fail(errors::script_syntax, "'" + word + "' without an if before it");
    if (word == "def" || word == "class" || word == "return" || word == "try" || word == "except" || word == "with" ||
        word == "raise" || word == "del" || word == "global" || word == "nonlocal" || word == "yield" ||
        word == "async" || word == "await" || word == "finally") {
      return fail(errors::script_unsupported, "'" + word + "' is Python, but not part of this language");
    }
  }
  if (at("@")) return fail(errors::script_unsupported, "decorators are Python, but not part of this language");

  ExprPtr first;
  ARESTA_CHECK(expression_list(first));
  if (at(":"))
    return fail(errors::script_unsupported, "annotated assignments are Python, but not part of this language");
  if (at("=")) {
    s.kind = StmtKind::assign;
    s.targets.push_back(std::move(first));
    while (accept("=")) {
      ExprPtr e;
      ARESTA_CHECK(expression_list(e));
      s.targets.push_back(std::move(e));
    }
    s.value = std::move(s.targets.back());
    s.targets.pop_back();
    for (const ExprPtr& t : s.targets) ARESTA_CHECK(check_target(*t));
    out.push_back(std::move(s));
    return {};
  }
  if (at(TokenKind::op) && token().text.size() >= 2 && token().text.back() == '=' && token().text != "==") {
    const std::string op = token().text.substr(0, token().text.size() - 1);
    if (const auto known = op_named(op); known && *known <= Op::bit_and) {
      if (first->kind != ExprKind::name && first->kind != ExprKind::index) {
        return fail(errors::script_syntax,
                    "only a variable or an item of a list can stand left of '" + token().text + "'");
      }
      s.kind = StmtKind::augment;
      s.op = *known;
      s.place = token().place;
      next();
      ARESTA_CHECK(expression_list(s.value));
      s.targets.push_back(std::move(first));
      out.push_back(std::move(s));
      return {};
    }
    return fail(errors::script_unsupported, "the operator '" + token().text + "' is not part of this language");
  }
  s.kind = StmtKind::expression;
  s.value = std::move(first);
  out.push_back(std::move(s));
  return {};
}

Status Parser::import_statement() {
  const Place place = token().place;
  const bool ours =
      at("from") && token(1).kind == TokenKind::name && token(1).text == "aresta" && at("import", 2) && at("*", 3);
  if (!ours) {
    return fail_at(place, errors::script_unsupported,
                   "only 'from aresta import *' can be imported; mathematics (pi, sqrt, sin, ...) is there without it");
  }
  for (int i = 0; i < 4; ++i) next();
  return {};
}

Status Parser::check_target(Expr& e) const {
  switch (e.kind) {
    case ExprKind::name:
    case ExprKind::index:
      return {};
    case ExprKind::list:
    case ExprKind::tuple:
      if (e.children.empty()) break;
      for (const ExprPtr& c : e.children) ARESTA_CHECK(check_target(*c));
      return {};
    case ExprKind::slice:
      return fail_at(e.place, errors::script_unsupported, "a slice cannot be assigned to");
    default:
      break;
  }
  return fail_at(e.place, errors::script_syntax,
                 e.kind == ExprKind::compare ? "a comparison cannot be assigned to"
                                             : "only variables and items of lists can be assigned to");
}

Status Parser::for_targets(ExprPtr& out) {
  const Place place = token().place;
  std::vector<ExprPtr> items;
  bool comma = false;
  do {
    if (at("in")) break;
    ExprPtr e;
    ARESTA_CHECK(postfix(e));
    ARESTA_CHECK(check_target(*e));
    items.push_back(std::move(e));
    comma = at(",");
  } while (accept(","));
  ARESTA_CHECK(expect("in", "after the variables of a for"));
  if (items.empty()) return fail_at(place, errors::script_syntax, "a for needs a variable, as in 'for i in range(3)'");
  if (items.size() == 1 && !comma) {
    out = std::move(items[0]);
  } else {
    out = make(ExprKind::tuple, place);
    out->children = std::move(items);
  }
  return {};
}

}  // namespace aresta::script
