// SPDX-License-Identifier: Apache-2.0
// Recursive descent over tokens. Depth of recursion is bounded: brackets by the tokenizer, everything else by Guard.
#include "script/ast.h"
#include "script/errors.h"

namespace aresta::script {

namespace {

constexpr int max_depth = 150;

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

class Parser {
 public:
  Parser(std::vector<Token> tokens, const std::string& file, int depth = 0)
      : tokens_(std::move(tokens)), file_(file), depth_(depth) {}

  Result<Block> script() {
    Block body;
    while (!at(TokenKind::end)) {
      if (at(TokenKind::indent)) return fail(errors::script_syntax, "this line is indented, but belongs to no block");
      ARESTA_CHECK(statement(body));
    }
    return body;
  }

  Result<ExprPtr> single_expression() {
    ExprPtr e;
    ARESTA_CHECK(expression_list(e));
    if (at(TokenKind::newline)) next();
    if (!at(TokenKind::end)) return fail(errors::script_syntax, "unexpected " + shown(token()));
    return e;
  }

 private:
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

  Error fail_at(Place place, const ErrorCode& code, std::string message) const {
    return located({code, std::move(message)}, file_, place);
  }
  Error fail(const ErrorCode& code, std::string message) const {
    return fail_at(token().place, code, std::move(message));
  }
  Status expect(const char* text, const char* where) {
    if (accept(text)) return {};
    return fail(errors::script_syntax, std::string("expected '") + text + "' " + where + ", not " + shown(token()));
  }

  ExprPtr make(ExprKind kind, Place place) const {
    auto e = std::make_unique<Expr>();
    e->kind = kind;
    e->place = place;
    return e;
  }

  // Statements.

  Status statement(Block& block) {
    const Guard guard(*this);
    ARESTA_CHECK(guard.check());
    if (at("if")) return if_statement(block);
    if (at("for")) return for_statement(block);
    if (at("while")) return while_statement(block);
    return simple_line(block);
  }

  Status simple_line(Block& block) {
    for (;;) {
      ARESTA_CHECK(simple_statement(block));
      if (!accept(";") || at(TokenKind::newline)) break;
    }
    if (at(TokenKind::newline)) {
      next();
      return {};
    }
    if (at(TokenKind::end)) return {};
    if (at(TokenKind::name) && token(0).place.line == last_place_.line && last_was_name_) {
      return fail(errors::script_syntax,
                  "unexpected " + shown(token()) + ": a command's arguments go in brackets, as in name(1, 2)");
    }
    return fail(errors::script_syntax, "unexpected " + shown(token()));
  }

  Status block(Block& body, const char* where) {
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

  Status if_statement(Block& out) {
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

  Status loop_body(Stmt& s, const char* where) {
    ++loops_;
    ARESTA_CHECK(block(s.body, where));
    --loops_;
    if (accept("else")) ARESTA_CHECK(block(s.orelse, "after else"));
    return {};
  }

  Status for_statement(Block& out) {
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

  Status while_statement(Block& out) {
    Stmt s{.kind = StmtKind::while_loop, .place = token().place};
    next();
    ARESTA_CHECK(expression(s.value));
    ARESTA_CHECK(loop_body(s, "after the condition"));
    out.push_back(std::move(s));
    return {};
  }

  Status simple_statement(Block& out) {
    const Place place = token().place;
    Stmt s{.kind = StmtKind::pass, .place = place};
    last_was_name_ = at(TokenKind::name);
    last_place_ = place;
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
      if (word == "elif" || word == "else")
        return fail(errors::script_syntax, "'" + word + "' without an if before it");
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

  /// `from aresta import *` makes the same text run in Python; here everything is there already.
  Status import_statement() {
    const Place place = token().place;
    const bool ours =
        at("from") && token(1).kind == TokenKind::name && token(1).text == "aresta" && at("import", 2) && at("*", 3);
    if (!ours) {
      return fail_at(
          place, errors::script_unsupported,
          "only 'from aresta import *' can be imported; mathematics (pi, sqrt, sin, ...) is there without it");
    }
    for (int i = 0; i < 4; ++i) next();
    return {};
  }

  Status check_target(Expr& e) const {
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

  /// The targets of a for, up to and with its `in`.
  Status for_targets(ExprPtr& out) {
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
    if (items.empty())
      return fail_at(place, errors::script_syntax, "a for needs a variable, as in 'for i in range(3)'");
    if (items.size() == 1 && !comma) {
      out = std::move(items[0]);
    } else {
      out = make(ExprKind::tuple, place);
      out->children = std::move(items);
    }
    return {};
  }

  // Expressions, from the loosest to the tightest binding.

  /// One expression, or several with commas: a tuple.
  Status expression_list(ExprPtr& out) {
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

  bool ends_list() const {
    return at(TokenKind::newline) || at(TokenKind::end) || at("=") || at(")") || at("]") || at("}") || at(":") ||
           at(";");
  }

  Status expression(ExprPtr& out) {
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

  template <class Next>
  Status logical(ExprPtr& out, const char* word, ExprKind kind, Next operand) {
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

  Status or_expression(ExprPtr& out) { return logical(out, "or", ExprKind::logical_or, &Parser::and_expression); }
  Status and_expression(ExprPtr& out) { return logical(out, "and", ExprKind::logical_and, &Parser::not_expression); }

  Status not_expression(ExprPtr& out) {
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

  bool comparison_op(PlacedOp& op) {
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

  Status comparison(ExprPtr& out) {
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

  template <class Next>
  Status chain(ExprPtr& out, std::initializer_list<const char*> ops, Next operand) {
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

  Status and_bits(ExprPtr& out) {
    ARESTA_CHECK(chain(out, {"&"}, &Parser::sum));
    for (const char* op : {"|", "^", "<<", ">>"}) {
      if (at(op)) {
        return fail(errors::script_unsupported, std::string("the operator '") + op +
                                                    "' is not part of this language (union is +, intersection is &)");
      }
    }
    return {};
  }
  Status sum(ExprPtr& out) { return chain(out, {"+", "-"}, &Parser::product); }
  Status product(ExprPtr& out) {
    ARESTA_CHECK(chain(out, {"*", "/", "//", "%"}, &Parser::unary));
    if (at("@")) return fail(errors::script_unsupported, "the operator '@' is not part of this language");
    return {};
  }

  Status unary(ExprPtr& out) {
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

  Status power(ExprPtr& out) {
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

  Status postfix(ExprPtr& out) {
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
        if (!at(TokenKind::name))
          return fail(errors::script_syntax, "expected a name after '.', not " + shown(token()));
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

  Status arguments(Expr& call) {
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

  Status subscript(ExprPtr& out, Place place) {
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

  /// `element` is parsed; at the first `for`. Leaves a comprehension in `element`.
  Status comprehension(ExprPtr& element, Place place) {
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

  Status primary(ExprPtr& out) {
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

  /// A parenthesised expression, tuple or generator; or a list.
  Status bracketed(ExprPtr& out, Place place, bool round) {
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

  /// Neighbouring strings are one; with a formatted one among them they are joined when run.
  Status strings(ExprPtr& out) {
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

  void add_text(Expr& e, const std::string& text) const {
    if (!e.children.empty() && e.children.back()->kind == ExprKind::constant && e.keywords.back().empty()) {
      e.children.back()->value = e.children.back()->value.string() + text;
      return;
    }
    ExprPtr c = make(ExprKind::constant, e.place);
    c->value = text;
    e.children.push_back(std::move(c));
    e.keywords.emplace_back();
  }

  /// f"text {expression:format} text".
  Status formatted(Expr& e, const Token& t) {
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
      if (raw[i] == '}')
        return fail_at(t.place, errors::script_syntax, "a single '}' in a formatted string; write '}}'");
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

  std::vector<Token> tokens_;
  const std::string& file_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int loops_ = 0;
  Place last_place_;
  bool last_was_name_ = false;
};

}  // namespace

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
