// SPDX-License-Identifier: Apache-2.0
// Words and numbers of text files, whatever the locale.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace aresta {

/// Reads a text word by word, line by line.
class TextReader {
 public:
  explicit TextReader(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  std::size_t position() const { return at_; }
  std::size_t line() const { return line_; }  ///< of the words just read, from 1

  /// The rest of the line and goes to the next; false at the end.
  bool next_line(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) end = text_.size();
    line = text_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    at_ = end + 1;
    ++line_;
    return true;
  }

  /// The next word, across lines; empty at the end.
  std::string_view word() {
    while (at_ < text_.size() && is_space(text_[at_])) {
      if (text_[at_] == '\n') ++line_;
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

 private:
  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
};

/// The first word of a text and what follows.
inline std::string_view take_word(std::string_view& text) {
  TextReader reader(text);
  const std::string_view word = reader.word();
  text.remove_prefix(reader.position());
  return word;
}

/// The whole word as a number; false when it is none. "nan" and "inf" are numbers here: whoever reads decides.
inline bool to_number(std::string_view word, double& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}
inline bool to_number(std::string_view word, std::int64_t& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

/// Appends the shortest text that reads back as the same number.
inline void append_number(std::string& text, double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, end);
}

}  // namespace aresta
