// SPDX-License-Identifier: Apache-2.0
#include "script/parser.h"

namespace aresta::script {

std::string shown(const Token& token) {
  switch (token.kind) {
    case TokenKind::newline:
      return "the end of the line";
    case TokenKind::indent:
      return "an indented line";
    case TokenKind::dedent:
      return "the end of the block";
    case TokenKind::end:
      return "the end of the script";
    case TokenKind::integer:
    case TokenKind::real:
      return "a number";
    case TokenKind::string:
    case TokenKind::formatted:
      return "a string";
    default:
      return "'" + token.text + "'";
  }
}

Error Parser::fail_at(Place place, const ErrorCode& code, std::string message) const {
  return located({code, std::move(message)}, file_, place);
}

Error Parser::fail(const ErrorCode& code, std::string message) const {
  return fail_at(token().place, code, std::move(message));
}

Error Parser::not_expected() const {
  return fail(errors::script_syntax, shown(token()) + " is not expected here");
}

Status Parser::expect(const char* text, const char* where) {
  if (accept(text)) return {};
  return fail(errors::script_syntax, std::string("expected '") + text + "' " + where + ", not " + shown(token()));
}

ExprPtr Parser::make(ExprKind kind, Place place) const {
  auto e = std::make_unique<Expr>();
  e->kind = kind;
  e->place = place;
  return e;
}

Result<Script> parse(std::string_view text, const std::string& file) {
  ARESTA_TRY(std::vector<Token> tokens, tokenize(text, file));
  Parser parser(std::move(tokens), file);
  Script script{.file = file};
  ARESTA_TRY(script.body, parser.script());
  return script;
}

Result<ExprPtr> parse_expression(std::string_view text, const std::string& file) {
  ARESTA_TRY(std::vector<Token> tokens, tokenize(text, file));
  return Parser(std::move(tokens), file).single_expression();
}

}  // namespace aresta::script
