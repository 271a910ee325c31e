// SPDX-License-Identifier: Apache-2.0
// Internal to script: recursive descent over tokens. Depth of recursion is bounded: brackets by the tokenizer,
// everything else by Guard.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "script/ast.h"
#include "script/errors.h"

namespace aresta::script {

/// A token as messages name it.
std::string shown(const Token& token);

class Parser {
 public:
  Parser(std::vector<Token> tokens, const std::string& file, int depth = 0)
      : tokens_(std::move(tokens)), file_(file), depth_(depth) {}

  Result<Block> script();
  Result<ExprPtr> single_expression();

 private:
  static constexpr int max_depth = 150;
  /// Parses an expression of one kind.
  using Rule = Status (Parser::*)(ExprPtr&);

  /// Counts the nesting of what is being parsed.
  class Guard {
   public:
    explicit Guard(Parser& p) : parser_(p) { ++parser_.depth_; }
    ~Guard() { --parser_.depth_; }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;
    Status check() const {
      if (parser_.depth_ <= max_depth) return {};
      return parser_.fail(errors::script_too_deep, "the script is nested too deeply here");
    }

   private:
    Parser& parser_;
  };

  const Token& token(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  bool at(TokenKind kind) const { return token().kind == kind; }
  bool at(const char* text, std::size_t ahead = 0) const {
    const Token& t = token(ahead);
    return (t.kind == TokenKind::op || t.kind == TokenKind::keyword) && t.text == text;
  }
  void next() {
    if (at_ + 1 < tokens_.size()) ++at_;
  }
  bool accept(const char* text) {
    if (!at(text)) return false;
    next();
    return true;
  }

  Error fail_at(Place place, const ErrorCode& code, std::string message) const;
  Error fail(const ErrorCode& code, std::string message) const;
  Error not_expected() const;
  Status expect(const char* text, const char* where);
  ExprPtr make(ExprKind kind, Place place) const;

  // parse_statements.cpp
  Status statement(Block& block);
  Status simple_line(Block& block);
  Status block(Block& body, const char* where);
  Status if_statement(Block& out);
  Status loop_body(Stmt& s, const char* where);
  Status for_statement(Block& out);
  Status while_statement(Block& out);
  Status simple_statement(Block& out);
  /// `from aresta import *` makes the same text run in Python; here everything is there already.
  Status import_statement();
  Status check_target(Expr& e) const;
  /// The targets of a for, up to and with its `in`.
  Status for_targets(ExprPtr& out);

  // parse_expressions.cpp
  /// One expression, or several with commas: a tuple.
  Status expression_list(ExprPtr& out);
  bool ends_list() const;
  Status expression(ExprPtr& out);
  Status logical(ExprPtr& out, const char* word, ExprKind kind, Rule operand);
  Status or_expression(ExprPtr& out);
  Status and_expression(ExprPtr& out);
  Status not_expression(ExprPtr& out);
  bool comparison_op(PlacedOp& op);
  Status comparison(ExprPtr& out);
  Status chain(ExprPtr& out, std::initializer_list<const char*> ops, Rule operand);
  Status and_bits(ExprPtr& out);
  Status sum(ExprPtr& out);
  Status product(ExprPtr& out);
  Status unary(ExprPtr& out);
  Status power(ExprPtr& out);

  // parse_values.cpp
  Status postfix(ExprPtr& out);
  Status arguments(Expr& call);
  Status subscript(ExprPtr& out, Place place);
  /// `element` is parsed; at the first `for`. Leaves a comprehension in `element`.
  Status comprehension(ExprPtr& element, Place place);
  Status primary(ExprPtr& out);
  /// A parenthesised expression, tuple or generator; or a list.
  Status bracketed(ExprPtr& out, Place place, bool round);

  // parse_strings.cpp
  /// Neighbouring strings are one; with a formatted one among them they are joined when run.
  Status strings(ExprPtr& out);
  void add_text(Expr& e, const std::string& text) const;
  /// f"text {expression:format} text".
  Status formatted(Expr& e, const Token& t);

  std::vector<Token> tokens_;
  const std::string& file_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int loops_ = 0;
  bool last_was_name_ = false;  ///< the statement began with a name
};

}  // namespace aresta::script
