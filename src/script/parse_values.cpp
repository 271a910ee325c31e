// SPDX-License-Identifier: Apache-2.0
// What operators work on: names, numbers, brackets, lists, and the calls and indices behind them.
#include "script/parser.h"

namespace aresta::script {

Status Parser::postfix(ExprPtr& out) {
  ARESTA_CHECK(primary(out));
  int depth = 0;
  for (;; ++depth) {
    if (depth_ + depth > max_depth) return fail(errors::script_too_deep, "the script is nested too deeply here");
    const Place place = token().place;
    if (at("(")) {
      ExprPtr e = make(ExprKind::call, out->place);
      e->children.push_back(std::move(out));
      ARESTA_CHECK(arguments(*e));
      out = std::move(e);
    } else if (at("[")) {
      ARESTA_CHECK(subscript(out, place));
    } else if (at(".")) {
      next();
      if (!at(TokenKind::name)) return fail(errors::script_syntax, "expected a name after '.', not " + shown(token()));
      ExprPtr e = make(ExprKind::method, token().place);
      e->text = token().text;
      next();
      if (!at("(")) {
        return fail_at(
            place, errors::script_unsupported,
            "values have no attributes in this language, as in '." + e->text + "'; use a command, as in volume(x)");
      }
      e->children.push_back(std::move(out));
      ARESTA_CHECK(arguments(*e));
      out = std::move(e);
    } else {
      return {};
    }
  }
}

Status Parser::arguments(Expr& call) {
  next();  // (
  bool keyword_seen = false;
  while (!at(")")) {
    std::string keyword;
    if (at(TokenKind::name) && at("=", 1)) {
      keyword = token().text;
      keyword_seen = true;
      next();
      next();
    } else if (at("**")) {
      return fail(errors::script_unsupported, "'**' before an argument is not part of this language");
    } else if (accept("*")) {
      keyword = "*";
    } else if (keyword_seen) {
      return fail(errors::script_syntax, "an argument without a name cannot follow one with a name");
    }
    ExprPtr e;
    const Place place = token().place;
    ARESTA_CHECK(expression(e));
    if (at("for")) {
      ARESTA_CHECK(comprehension(e, place));
    }
    call.children.push_back(std::move(e));
    call.keywords.push_back(std::move(keyword));
    if (!accept(",")) break;
  }
  return expect(")", "at the end of the arguments");
}

Status Parser::subscript(ExprPtr& out, Place place) {
  next();  // [
  ExprPtr parts[3];
  int colons = 0;
  while (!at("]")) {
    if (accept(":")) {
      if (++colons > 2) return fail(errors::script_syntax, "a slice has at most two ':'");
      continue;
    }
    if (parts[colons]) return fail(errors::script_syntax, "expected ']' or ':', not " + shown(token()));
    ARESTA_CHECK(expression_list(parts[colons]));
  }
  next();  // ]
  if (colons == 0 && !parts[0]) return fail_at(place, errors::script_syntax, "nothing stands between '[' and ']'");
  ExprPtr e = make(colons == 0 ? ExprKind::index : ExprKind::slice, place);
  e->children.push_back(std::move(out));
  for (int i = 0; i < (colons == 0 ? 1 : 3); ++i) e->children.push_back(std::move(parts[i]));
  out = std::move(e);
  return {};
}

Status Parser::comprehension(ExprPtr& element, Place place) {
  ExprPtr e = make(ExprKind::comprehension, place);
  e->children.push_back(std::move(element));
  while (accept("for")) {
    Clause clause;
    ARESTA_CHECK(for_targets(clause.target));
    ARESTA_CHECK(or_expression(clause.iterable));
    while (accept("if")) {
      ExprPtr condition;
      ARESTA_CHECK(or_expression(condition));
      clause.conditions.push_back(std::move(condition));
    }
    e->clauses.push_back(std::move(clause));
    if (e->clauses.size() > 10) return fail(errors::script_too_deep, "more than ten 'for' in one list");
  }
  element = std::move(e);
  return {};
}

Status Parser::primary(ExprPtr& out) {
  const Token& t = token();
  const Place place = t.place;
  switch (t.kind) {
    case TokenKind::integer:
    case TokenKind::real:
      out = make(ExprKind::constant, place);
      out->value = t.kind == TokenKind::integer ? document::Value(t.integer) : document::Value(t.real);
      next();
      return {};
    case TokenKind::string:
    case TokenKind::formatted:
      return strings(out);
    case TokenKind::name:
      out = make(ExprKind::name, place);
      out->text = t.text;
      next();
      return {};
    case TokenKind::keyword:
      if (t.text == "True" || t.text == "False" || t.text == "None") {
        out = make(ExprKind::constant, place);
        if (t.text != "None") out->value = t.text == "True";
        next();
        return {};
      }
      if (t.text == "lambda" || t.text == "yield" || t.text == "await") {
        return fail(errors::script_unsupported, "'" + t.text + "' is Python, but not part of this language");
      }
      return fail(errors::script_syntax, "'" + t.text + "' cannot stand here: it is a word of the language");
    case TokenKind::op:
      if (t.text == "(") return bracketed(out, place, true);
      if (t.text == "[") return bracketed(out, place, false);
      if (t.text == "{")
        return fail(errors::script_unsupported, "'{' (dictionaries and sets) is not part of this language");
      break;
    default:
      break;
  }
  return fail(errors::script_syntax, "expected a value, not " + shown(t));
}

Status Parser::bracketed(ExprPtr& out, Place place, bool round) {
  const char* closing = round ? ")" : "]";
  next();
  ExprPtr e = make(round ? ExprKind::tuple : ExprKind::list, place);
  bool comma = false;
  while (!at(closing)) {
    if (at("*")) return fail(errors::script_unsupported, "'*' in a list is not part of this language");
    ExprPtr item;
    ARESTA_CHECK(expression(item));
    if (at("for") && e->children.empty()) {
      ARESTA_CHECK(comprehension(item, place));
      ARESTA_CHECK(expect(closing, "at the end of the list"));
      out = std::move(item);
      return {};
    }
    e->children.push_back(std::move(item));
    comma = accept(",");
    if (!comma) break;
  }
  ARESTA_CHECK(expect(closing, round ? "or ',' here" : "or ',' in the list"));
  if (round && e->children.size() == 1 && !comma) {
    out = std::move(e->children[0]);
  } else {
    out = std::move(e);
  }
  return {};
}

}  // namespace aresta::script
