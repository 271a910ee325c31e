// SPDX-License-Identifier: Apache-2.0
// Strings, which join their neighbours and may hold expressions.
#include "script/parser.h"

namespace aresta::script {

Status Parser::strings(ExprPtr& out) {
  out = make(ExprKind::formatted, token().place);
  while (at(TokenKind::string) || at(TokenKind::formatted)) {
    if (at(TokenKind::string)) {
      add_text(*out, token().text);
    } else {
      ARESTA_CHECK(formatted(*out, token()));
    }
    next();
  }
  if (out->children.empty()) add_text(*out, "");
  if (out->children.size() == 1 && out->children[0]->kind == ExprKind::constant && out->keywords[0].empty()) {
    out = std::move(out->children[0]);
  }
  return {};
}

void Parser::add_text(Expr& e, const std::string& text) const {
  if (!e.children.empty() && e.children.back()->kind == ExprKind::constant && e.keywords.back().empty()) {
    e.children.back()->value = e.children.back()->value.string() + text;
    return;
  }
  ExprPtr c = make(ExprKind::constant, e.place);
  c->value = text;
  e.children.push_back(std::move(c));
  e.keywords.emplace_back();
}

Status Parser::formatted(Expr& e, const Token& t) {
  const std::string& raw = t.text;
  std::string plain;
  const auto flush = [&]() -> Status {
    std::string text = plain;
    if (!t.raw) {
      ARESTA_TRY(text, unescape(plain, file_, t.place));
    }
    if (!text.empty()) add_text(e, text);
    plain.clear();
    return {};
  };
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if ((raw[i] == '{' || raw[i] == '}') && i + 1 < raw.size() && raw[i + 1] == raw[i]) {
      plain += raw[i++];
      continue;
    }
    if (raw[i] == '}') return fail_at(t.place, errors::script_syntax, "a single '}' in a formatted string; write '}}'");
    if (raw[i] != '{') {
      plain += raw[i];
      continue;
    }
    ARESTA_CHECK(flush());
    // Up to the '}' of this level; a ':' at this level starts the format.
    std::size_t depth = 0, end = i + 1, colon = std::string::npos;
    char quote = '\0';
    for (; end < raw.size(); ++end) {
      const char c = raw[end];
      if (quote != '\0') {
        if (c == quote) quote = '\0';
      } else if (c == '\'' || c == '"') {
        quote = c;
      } else if (c == '(' || c == '[' || c == '{') {
        ++depth;
      } else if (depth > 0 && (c == ')' || c == ']' || c == '}')) {
        --depth;
      } else if (depth == 0 && c == '}') {
        break;
      } else if (depth == 0 && c == ':' && colon == std::string::npos) {
        colon = end;
      }
    }
    if (end >= raw.size())
      return fail_at(t.place, errors::script_syntax, "a '{' in this formatted string is never closed");
    const std::size_t stop = colon == std::string::npos ? end : colon;
    if (raw.find_first_not_of(" \t\r\n", i + 1) >= stop) {
      return fail_at(t.place, errors::script_syntax, "nothing stands between '{' and '}' in this formatted string");
    }
    Place place = t.place;
    for (std::size_t k = 0; k <= i; ++k) {
      if (raw[k] == '\n')
        place = {place.line + 1, 1};
      else if ((static_cast<unsigned char>(raw[k]) & 0xc0) != 0x80)
        ++place.column;
    }
    // In brackets, so that it may go over lines; the place is shifted back by the bracket.
    --place.column;
    ARESTA_TRY(std::vector<Token> tokens, tokenize("(" + raw.substr(i + 1, stop - i - 1) + ")", file_, place));
    const Guard guard(*this);
    ARESTA_CHECK(guard.check());
    Parser inner(std::move(tokens), file_, depth_);
    ARESTA_TRY(ExprPtr child, inner.single_expression());
    e.children.push_back(std::move(child));
    e.keywords.push_back(colon == std::string::npos ? ":" : raw.substr(colon, end - colon));
    i = end;
  }
  return flush();
}

}  // namespace aresta::script
