// SPDX-License-Identifier: Apache-2.0
// From text to tokens: the first stage of running a script.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace aresta::script {

/// A place in a script; both count from 1, columns count characters.
struct Place {
  int line = 1;
  int column = 1;
};

enum class TokenKind : std::uint8_t {
  name,
  keyword,
  integer,
  real,
  string,
  formatted,
  op,
  newline,
  indent,
  dedent,
  end
};

struct Token {
  TokenKind kind = TokenKind::end;
  Place place;
  std::string text;  ///< name, keyword, operator; the characters of a string; the raw inside of a formatted one
  std::int64_t integer = 0;
  double real = 0;
  bool raw = false;  ///< of a formatted string: escapes are kept as they are
};

/// The tokens of a script, with indentation as indent and dedent and an end at the last. Lines are joined in brackets
/// and after a backslash. Errors: script.syntax, script.not_text, script.too_deep, script.too_large, located in `file`.
Result<std::vector<Token>> tokenize(std::string_view text, const std::string& file, Place start = {});

/// A word of Python's grammar (not a name)?
bool is_keyword(std::string_view word);

/// The characters that a string's escapes stand for; `place` and `file` are for errors.
Result<std::string> unescape(std::string_view raw, const std::string& file, Place place);

/// An error at a place of a file: sets error.location.
Error located(Error error, const std::string& file, Place place);

}  // namespace aresta::script
