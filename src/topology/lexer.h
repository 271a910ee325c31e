// SPDX-License-Identifier: Apache-2.0
// The words of a line-oriented text, for its readers: dumps and notation.
//
// Words are set apart by blanks; ":", "," and "|" are words of their own; "#" begins a comment that ends with the line.
// The end of a line is a word too, "\n", but empty lines are none and the last line need not be ended. Any bytes do.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace aresta {

struct Word {
  std::string_view text;  ///< "\n" at the end of a line, empty at the end of the text
  std::uint32_t line = 1;

  bool is(std::string_view other) const { return text == other; }
  bool ends_line() const { return text.empty() || text == "\n"; }
};

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) { advance(); }

  const Word& word() const { return word_; }
  Word take() {
    const Word word = word_;
    advance();
    return word;
  }

 private:
  void advance();

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  bool in_line_ = false;
  Word word_;
};

/// "line 12: "
std::string at_line(std::uint32_t line);

/// A word as messages show it: quoted, cut when long, with bytes that do not print as \x1f.
std::string shown(const Word& word);

/// "line 12: WANTED is expected, not WORD"
std::string not_as_expected(std::string_view wanted, const Word& found);

/// What readers have in common: they read words until the first error, which stays; after it all reads give nothing.
class WordReader {
 protected:
  WordReader(std::string_view text, const ErrorCode& code) : lexer_(text), code_(code) {}

  bool failed() const { return error_.has_value(); }
  void fail(std::string_view wanted) {
    if (!failed()) error_ = Error{code_, not_as_expected(wanted, lexer_.word())};
  }
  bool is(std::string_view text) const { return !failed() && lexer_.word().is(text); }
  bool accept(std::string_view text) {
    if (!is(text)) return false;
    lexer_.take();
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) fail("'" + std::string(text) + "'");
  }

  Lexer lexer_;
  std::optional<Error> error_;

 private:
  ErrorCode code_;
};

/// A number of decimal digits alone; the most that there is when it is too large, and nothing else is false.
bool read_number(std::string_view digits, std::uint32_t most, std::uint32_t* number);

}  // namespace aresta
