// SPDX-License-Identifier: Apache-2.0
// Expressions by their operators, from the loosest to the tightest binding.
#include "script/parser.h"

namespace aresta::script {

Result<ExprPtr> Parser::single_expression() {
  ExprPtr e;
  ARESTA_CHECK(expression_list(e));
  if (at(TokenKind::newline)) next();
  if (!at(TokenKind::end)) return not_expected();
  return e;
}

Status Parser::expression_list(ExprPtr& out) {
  const Place place = token().place;
  ARESTA_CHECK(expression(out));
  if (!at(",")) return {};
  ExprPtr tuple = make(ExprKind::tuple, place);
  tuple->children.push_back(std::move(out));
  while (accept(",")) {
    if (ends_list()) break;
    ExprPtr e;
    ARESTA_CHECK(expression(e));
    tuple->children.push_back(std::move(e));
  }
  out = std::move(tuple);
  return {};
}

bool Parser::ends_list() const {
  return at(TokenKind::newline) || at(TokenKind::end) || at("=") || at(")") || at("]") || at("}") || at(":") || at(";");
}

Status Parser::expression(ExprPtr& out) {
  const Guard guard(*this);
  ARESTA_CHECK(guard.check());
  if (at("lambda")) return fail(errors::script_unsupported, "'lambda' is Python, but not part of this language");
  ARESTA_CHECK(or_expression(out));
  if (at(":=")) return fail(errors::script_unsupported, "':=' is Python, but not part of this language");
  if (!at("if")) return {};
  ExprPtr e = make(ExprKind::conditional, token().place);
  next();
  e->children.push_back(std::move(out));
  e->children.resize(3);
  ARESTA_CHECK(or_expression(e->children[1]));
  ARESTA_CHECK(expect("else", "in the conditional expression"));
  ARESTA_CHECK(expression(e->children[2]));
  out = std::move(e);
  return {};
}

Status Parser::logical(ExprPtr& out, const char* word, ExprKind kind, Rule operand) {
  ARESTA_CHECK((this->*operand)(out));
  if (!at(word)) return {};
  ExprPtr e = make(kind, token().place);
  e->children.push_back(std::move(out));
  while (accept(word)) {
    ExprPtr c;
    ARESTA_CHECK((this->*operand)(c));
    e->children.push_back(std::move(c));
  }
  out = std::move(e);
  return {};
}

Status Parser::or_expression(ExprPtr& out) {
  return logical(out, "or", ExprKind::logical_or, &Parser::and_expression);
}

Status Parser::and_expression(ExprPtr& out) {
  return logical(out, "and", ExprKind::logical_and, &Parser::not_expression);
}

Status Parser::not_expression(ExprPtr& out) {
  if (!at("not")) return comparison(out);
  const Guard guard(*this);
  ARESTA_CHECK(guard.check());
  ExprPtr e = make(ExprKind::logical_not, token().place);
  next();
  e->children.resize(1);
  ARESTA_CHECK(not_expression(e->children[0]));
  out = std::move(e);
  return {};
}

bool Parser::comparison_op(PlacedOp& op) {
  if (!at(TokenKind::op) && !at(TokenKind::keyword)) return false;
  op.place = token().place;
  std::string text = token().text;
  if (text == "not" && at("in", 1)) {
    text = "not in";
    next();
  } else if (text == "is" && at("not", 1)) {
    text = "is not";
    next();
  }
  const auto known = op_named(text);
  if (!known || *known < Op::equal) return false;
  op.op = *known;
  next();
  return true;
}

Status Parser::comparison(ExprPtr& out) {
  ARESTA_CHECK(and_bits(out));
  PlacedOp op{};
  if (!comparison_op(op)) return {};
  ExprPtr e = make(ExprKind::compare, op.place);
  e->children.push_back(std::move(out));
  do {
    e->ops.push_back(op);
    ExprPtr c;
    ARESTA_CHECK(and_bits(c));
    e->children.push_back(std::move(c));
  } while (comparison_op(op));
  out = std::move(e);
  return {};
}

Status Parser::chain(ExprPtr& out, std::initializer_list<const char*> ops, Rule operand) {
  ARESTA_CHECK((this->*operand)(out));
  ExprPtr e;
  for (;;) {
    const char* found = nullptr;
    for (const char* op : ops) {
      if (at(op)) found = op;
    }
    if (found == nullptr) break;
    if (!e) {
      e = make(ExprKind::chain, token().place);
      e->children.push_back(std::move(out));
    }
    e->ops.push_back({*op_named(found), token().place});
    next();
    ExprPtr c;
    ARESTA_CHECK((this->*operand)(c));
    e->children.push_back(std::move(c));
  }
  if (e) out = std::move(e);
  return {};
}

Status Parser::and_bits(ExprPtr& out) {
  ARESTA_CHECK(chain(out, {"&"}, &Parser::sum));
  for (const char* op : {"|", "^", "<<", ">>"}) {
    if (at(op)) {
      return fail(errors::script_unsupported, std::string("the operator '") + op +
                                                  "' is not part of this language (union is +, intersection is &)");
    }
  }
  return {};
}

Status Parser::sum(ExprPtr& out) {
  return chain(out, {"+", "-"}, &Parser::product);
}

Status Parser::product(ExprPtr& out) {
  ARESTA_CHECK(chain(out, {"*", "/", "//", "%"}, &Parser::unary));
  if (at("@")) return fail(errors::script_unsupported, "the operator '@' is not part of this language");
  return {};
}

Status Parser::unary(ExprPtr& out) {
  if (at("-") || at("+")) {
    const Guard guard(*this);
    ARESTA_CHECK(guard.check());
    ExprPtr e = make(at("-") ? ExprKind::negate : ExprKind::plus, token().place);
    next();
    e->children.resize(1);
    ARESTA_CHECK(unary(e->children[0]));
    out = std::move(e);
    return {};
  }
  if (at("~")) return fail(errors::script_unsupported, "the operator '~' is not part of this language");
  return power(out);
}

Status Parser::power(ExprPtr& out) {
  ARESTA_CHECK(postfix(out));
  if (!at("**")) return {};
  const Guard guard(*this);
  ARESTA_CHECK(guard.check());
  ExprPtr e = make(ExprKind::chain, token().place);
  e->ops.push_back({Op::power, token().place});
  next();
  e->children.push_back(std::move(out));
  e->children.resize(2);
  ARESTA_CHECK(unary(e->children[1]));
  out = std::move(e);
  return {};
}

}  // namespace aresta::script
