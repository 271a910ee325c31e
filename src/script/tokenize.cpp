// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>

#include "script/errors.h"
#include "script/token.h"

namespace aresta::script {

namespace {

constexpr std::size_t max_script_bytes = std::size_t{1} << 24;
constexpr std::size_t max_bracket_depth = 100;
constexpr std::size_t max_indent_depth = 50;

constexpr std::array keywords = {"False",  "None",   "True",    "and",      "as",       "assert", "async",
                                 "await",  "break",  "class",   "continue", "def",      "del",    "elif",
                                 "else",   "except", "finally", "for",      "from",     "global", "if",
                                 "import", "in",     "is",      "lambda",   "nonlocal", "not",    "or",
                                 "pass",   "raise",  "return",  "try",      "while",    "with",   "yield"};

constexpr std::array operators = {
    "**=", "//=", "<<=", ">>=", "...", "**", "//", "<<", ">>", "<=", ">=", "==", "!=", "->", "+=", "-=",
    "*=",  "/=",  "%=",  "&=",  "|=",  "^=", ":=", "@=", "+",  "-",  "*",  "/",  "%",  "&",  "|",  "^",
    "~",   "<",   ">",   "=",   "(",   ")",  "[",  "]",  "{",  "}",  ",",  ":",  ";",  ".",  "@"};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_hex(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

void append_utf8(std::string& out, std::uint32_t code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    out += static_cast<char>(0xe0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    out += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    out += static_cast<char>(0xf0 | (code >> 18));
    out += static_cast<char>(0x80 | ((code >> 12) & 0x3f));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    out += static_cast<char>(0x80 | (code & 0x3f));
  }
}

/// Reads one script from left to right.
class Tokenizer {
 public:
  Tokenizer(std::string_view text, const std::string& file, Place start) : text_(text), file_(file), place_(start) {}

  Result<std::vector<Token>> run() {
    if (text_.size() > max_script_bytes) {
      return fail(errors::script_too_large, "the script is larger than 16 MB");
    }
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
    while (at_ < text_.size()) {
      if (line_start_ && brackets_.empty()) {
        ARESTA_CHECK(read_indentation());
        line_start_ = false;
        continue;
      }
      ARESTA_CHECK(read_token());
    }
    if (!brackets_.empty()) {
      return located({errors::script_syntax, "'" + std::string(1, brackets_.back().first) + "' is never closed"}, file_,
                     brackets_.back().second);
    }
    if (!tokens_.empty() && tokens_.back().kind != TokenKind::newline && tokens_.back().kind != TokenKind::dedent) {
      push(TokenKind::newline, place_);
    }
    for (; indents_.size() > 1; indents_.pop_back()) push(TokenKind::dedent, place_);
    push(TokenKind::end, place_);
    return std::move(tokens_);
  }

 private:
  Error fail(const ErrorCode& code, std::string message) const { return fail_at(place_, code, std::move(message)); }
  Error fail_at(Place place, const ErrorCode& code, std::string message) const {
    return located({code, std::move(message)}, file_, place);
  }

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void advance() {
    if (text_[at_] == '\n') {
      ++place_.line;
      place_.column = 1;
    } else if ((static_cast<unsigned char>(text_[at_]) & 0xc0) != 0x80) {
      ++place_.column;
    }
    ++at_;
  }

  Token& push(TokenKind kind, Place place, std::string text = {}) {
    Token token;
    token.kind = kind;
    token.place = place;
    token.text = std::move(text);
    return tokens_.emplace_back(std::move(token));
  }

  void skip_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') advance();
  }

  /// At the start of a line: measures its indentation; blank lines and lines of comment alone count for nothing.
  Status read_indentation() {
    std::size_t first = at_;
    for (;;) {
      first = at_;
      while (peek() == ' ' || peek() == '\t' || peek() == '\f') advance();
      const bool blank =
          peek() == '#' || peek() == '\n' || (peek() == '\r' && (peek(1) == '\n' || at_ + 1 == text_.size()));
      if (at_ >= text_.size()) return {};
      if (!blank) break;
      skip_comment();
      if (at_ < text_.size()) advance();
    }
    const std::string_view indent = text_.substr(first, at_ - first);
    if (indent == indents_.back()) return {};
    if (indent.size() > indents_.back().size() && indent.starts_with(indents_.back())) {
      if (indents_.size() > max_indent_depth) {
        return fail(errors::script_too_deep, "blocks are nested more than 50 deep");
      }
      indents_.push_back(indent);
      push(TokenKind::indent, place_);
      return {};
    }
    while (indents_.size() > 1 && indent.size() < indents_.back().size()) {
      indents_.pop_back();
      push(TokenKind::dedent, place_);
    }
    if (indent != indents_.back()) {
      return fail(errors::script_syntax,
                  "this line's indentation matches no block above it (are tabs and spaces mixed?)");
    }
    return {};
  }

  Status read_token() {
    const char c = peek();
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ' || c == '\t' || c == '\f') {
      advance();
      return {};
    }
    if (c == '#') {
      skip_comment();
      return {};
    }
    if (c == '\r' && (peek(1) == '\n' || at_ + 1 == text_.size())) {
      ++at_;
      return {};
    }
    if (c == '\n') {
      if (brackets_.empty()) {
        push(TokenKind::newline, place_);
        line_start_ = true;
      }
      advance();
      return {};
    }
    if (c == '\\') return join_lines();
    if (is_letter(c)) return read_word();
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return read_number();
    if (c == '"' || c == '\'') return read_string(place_, false, false);
    if (c == '\0') return fail(errors::script_not_text, "this is not a text file: it holds a zero byte");
    if (byte < 0x20 || byte == 0x7f) {
      return fail(errors::script_not_text,
                  "a control character (byte " + std::to_string(byte) + ") outside of a string");
    }
    if (byte >= 0x80) {
      std::size_t n = 1;
      while (n < 4 && (static_cast<unsigned char>(peek(n)) & 0xc0) == 0x80) ++n;
      const bool plausible = byte >= 0xc2 && byte < 0xf5 && n > 1;
      return fail(errors::script_syntax, plausible ? "unexpected character '" + std::string(text_.substr(at_, n)) +
                                                         "': names are made of the letters a-z, digits and _"
                                                   : "a byte that is no text (" + std::to_string(byte) + ")");
    }
    return read_operator();
  }

  Status join_lines() {
    std::size_t n = 1;
    if (peek(n) == '\r') ++n;
    if (peek(n) != '\n') return fail(errors::script_syntax, "nothing may follow '\\' on its line");
    while (n-- > 0) advance();
    advance();
    return {};
  }

  Status read_word() {
    const Place place = place_;
    const std::size_t first = at_;
    while (is_letter(peek()) || is_digit(peek())) advance();
    const std::string_view word = text_.substr(first, at_ - first);
    if ((peek() == '"' || peek() == '\'') && word.size() <= 2) {
      bool raw = false, formatted = false, known = true;
      for (const char c : word) {
        if (c == 'r' || c == 'R')
          raw = true;
        else if (c == 'f' || c == 'F')
          formatted = true;
        else if (c != 'u' && c != 'U')
          known = false;
      }
      if (known) return read_string(place, raw, formatted);
      return fail_at(place, errors::script_unsupported,
                     "strings with the prefix '" + std::string(word) + "' are not supported");
    }
    push(is_keyword(word) ? TokenKind::keyword : TokenKind::name, place, std::string(word));
    return {};
  }

  Status read_number() {
    const Place place = place_;
    std::string digits;
    bool real = false;
    int base = 10;
    if (peek() == '0' && (peek(1) == 'x' || peek(1) == 'X')) base = 16;
    if (peek() == '0' && (peek(1) == 'b' || peek(1) == 'B')) base = 2;
    if (peek() == '0' && (peek(1) == 'o' || peek(1) == 'O')) base = 8;
    if (base != 10) {
      advance();
      advance();
      while (is_hex(peek()) || peek() == '_') {
        if (peek() != '_') digits += peek();
        advance();
      }
    } else {
      const auto read_digits = [&] {
        while (is_digit(peek()) || (peek() == '_' && is_digit(peek(1)))) {
          if (peek() != '_') digits += peek();
          advance();
        }
      };
      read_digits();
      if (peek() == '.') {
        real = true;
        digits += '.';
        advance();
        read_digits();
      }
      const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
      if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
        real = true;
        digits += 'e';
        advance();
        if (sign == 1) {
          if (peek() == '-') digits += '-';
          advance();
        }
        read_digits();
      }
    }
    if (is_letter(peek()) || is_digit(peek()) || static_cast<unsigned char>(peek()) >= 0x80 || digits.empty()) {
      return fail_at(place, errors::script_syntax, "this is no number");
    }
    const char* end = digits.data() + digits.size();
    if (real) {
      Token& token = push(TokenKind::real, place);
      const auto r = std::from_chars(digits.data(), end, token.real);
      const bool exponent_negative = digits.find("e-") != std::string::npos;
      if (r.ec == std::errc::result_out_of_range) {
        if (exponent_negative) {
          token.real = 0;  // underflow, as in Python
        } else {
          return fail_at(place, errors::script_overflow, "the number is too large (the limit is about 1.8e308)");
        }
      } else if (r.ec != std::errc() || r.ptr != end) {
        return fail_at(place, errors::script_syntax, "this is no number");
      }
      return {};
    }
    if (base == 10 && digits.size() > 1 && digits[0] == '0' && digits.find_first_not_of('0') != std::string::npos) {
      return fail_at(place, errors::script_syntax, "a whole number does not start with 0");
    }
    Token& token = push(TokenKind::integer, place);
    const auto r = std::from_chars(digits.data(), end, token.integer, base);
    if (r.ec == std::errc::result_out_of_range) {
      return fail_at(
          place, errors::script_overflow,
          "the whole number does not fit in 64 bits; write it with a decimal point to make it a real number");
    }
    if (r.ec != std::errc() || r.ptr != end) return fail_at(place, errors::script_syntax, "this is no number");
    return {};
  }

  Status read_string(Place place, bool raw, bool formatted) {
    const char quote = peek();
    const bool triple = peek(1) == quote && peek(2) == quote;
    for (int i = 0; i < (triple ? 3 : 1); ++i) advance();
    const Place inside = place_;
    const std::size_t first = at_;
    for (;;) {
      if (at_ >= text_.size() || (!triple && peek() == '\n')) {
        return fail_at(place, errors::script_syntax, "the string is never closed");
      }
      if (peek() == '\0') return fail(errors::script_not_text, "this is not a text file: it holds a zero byte");
      if (peek() == quote && (!triple || (peek(1) == quote && peek(2) == quote))) break;
      if (peek() == '\\' && at_ + 1 < text_.size()) advance();
      advance();
    }
    const std::string_view body = text_.substr(first, at_ - first);
    for (int i = 0; i < (triple ? 3 : 1); ++i) advance();
    if (formatted) {
      push(TokenKind::formatted, inside, std::string(body)).raw = raw;
      return {};
    }
    std::string value(body);
    if (!raw) {
      ARESTA_TRY(value, unescape(body, file_, place));
    }
    push(TokenKind::string, place, std::move(value));
    return {};
  }

  Status read_operator() {
    const Place place = place_;
    const std::string_view rest = text_.substr(at_);
    const auto found =
        std::find_if(operators.begin(), operators.end(), [&](const char* op) { return rest.starts_with(op); });
    if (found == operators.end()) {
      return fail(errors::script_syntax, "unexpected character '" + std::string(1, peek()) + "'");
    }
    const std::string op = *found;
    for (std::size_t i = 0; i < op.size(); ++i) advance();
    if (op == "(" || op == "[" || op == "{") {
      if (brackets_.size() >= max_bracket_depth) {
        return fail_at(place, errors::script_too_deep, "brackets are nested more than 100 deep");
      }
      brackets_.emplace_back(op[0], place);
    } else if (op == ")" || op == "]" || op == "}") {
      const char opening = op == ")" ? '(' : op == "]" ? '[' : '{';
      if (brackets_.empty()) return fail_at(place, errors::script_syntax, "'" + op + "' closes nothing");
      if (brackets_.back().first != opening) {
        return fail_at(place, errors::script_syntax,
                       "'" + op + "' does not match '" + std::string(1, brackets_.back().first) + "' of line " +
                           std::to_string(brackets_.back().second.line));
      }
      brackets_.pop_back();
    }
    push(TokenKind::op, place, op);
    return {};
  }

  std::string_view text_;
  const std::string& file_;
  Place place_;
  std::size_t at_ = 0;
  bool line_start_ = true;
  std::vector<std::string_view> indents_{""};
  std::vector<std::pair<char, Place>> brackets_;
  std::vector<Token> tokens_;
};

}  // namespace

Result<std::vector<Token>> tokenize(std::string_view text, const std::string& file, Place start) {
  return Tokenizer(text, file, start).run();
}

Error located(Error error, const std::string& file, Place place) {
  if (error.location.empty()) {
    error.location = file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
  }
  return error;
}

bool is_keyword(std::string_view word) {
  return std::any_of(keywords.begin(), keywords.end(), [word](const char* k) { return word == k; });
}

Result<std::string> unescape(std::string_view raw, const std::string& file, Place place) {
  std::string out;
  out.reserve(raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != '\\' || i + 1 == raw.size()) {
      if (raw[i] != '\r' || i + 1 == raw.size() || raw[i + 1] != '\n') out += raw[i];
      continue;
    }
    const char c = raw[++i];
    std::size_t hex_digits = 0;
    switch (c) {
      case '\r':
        if (i + 1 < raw.size() && raw[i + 1] == '\n') ++i;
        break;
      case '\n':
        break;
      case 'n':
        out += '\n';
        break;
      case 't':
        out += '\t';
        break;
      case 'r':
        out += '\r';
        break;
      case 'a':
        out += '\a';
        break;
      case 'b':
        out += '\b';
        break;
      case 'f':
        out += '\f';
        break;
      case 'v':
        out += '\v';
        break;
      case '\\':
      case '\'':
      case '"':
        out += c;
        break;
      case 'x':
        hex_digits = 2;
        break;
      case 'u':
        hex_digits = 4;
        break;
      case 'U':
        hex_digits = 8;
        break;
      default:
        if (c >= '0' && c <= '7') {
          std::uint32_t code = 0;
          std::size_t n = 0;
          for (; n < 3 && i + n < raw.size() && raw[i + n] >= '0' && raw[i + n] <= '7'; ++n) {
            code = 8 * code + static_cast<std::uint32_t>(raw[i + n] - '0');
          }
          i += n - 1;
          append_utf8(out, code);
        } else {
          out += '\\';
          out += c;
        }
    }
    if (hex_digits > 0) {
      std::uint32_t code = 0;
      const char* first = raw.data() + i + 1;
      const bool enough = i + hex_digits < raw.size();
      const auto r = enough ? std::from_chars(first, first + hex_digits, code, 16) : std::from_chars_result{first, {}};
      if (!enough || r.ptr != first + hex_digits || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) {
        return located({errors::script_syntax, std::string("the escape \\") + c + " in this string needs " +
                                                   std::to_string(hex_digits) + " hexadecimal digits of a character"},
                       file, place);
      }
      append_utf8(out, code);
      i += hex_digits;
    }
  }
  return out;
}

}  // namespace aresta::script
