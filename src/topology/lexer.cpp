// SPDX-License-Identifier: Apache-2.0
#include "topology/lexer.h"

namespace aresta {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}
bool is_mark(char c) {
  return c == ':' || c == ',' || c == '|';
}

}  // namespace

void Lexer::advance() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (is_blank(c)) {
      ++at_;
    } else if (c == '#') {
      while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    } else if (c == '\n') {
      word_ = {text_.substr(at_, 1), line_};
      ++at_;
      ++line_;
      if (in_line_) {
        in_line_ = false;
        return;
      }
    } else {
      const std::size_t begin = at_++;
      if (!is_mark(c)) {
        while (at_ < text_.size() && !is_blank(text_[at_]) && !is_mark(text_[at_]) && text_[at_] != '#' &&
               text_[at_] != '\n') {
          ++at_;
        }
      }
      word_ = {text_.substr(begin, at_ - begin), line_};
      in_line_ = true;
      return;
    }
  }
  word_ = {in_line_ ? "\n" : "", line_};
  in_line_ = false;
}

std::string at_line(std::uint32_t line) {
  return "line " + std::to_string(line) + ": ";
}

std::string shown(const Word& word) {
  if (word.text.empty()) return "the end of the text";
  if (word.text == "\n") return "the end of the line";
  constexpr std::size_t most = 40;
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "'";
  for (const char c : word.text.substr(0, most)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      result += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
    }
  }
  return result + (word.text.size() > most ? "...'" : "'");
}

std::string not_as_expected(std::string_view wanted, const Word& found) {
  return at_line(found.line) + std::string(wanted) + " is expected, not " + shown(found);
}

bool read_number(std::string_view digits, std::uint32_t most, std::uint32_t* number) {
  if (digits.empty()) return false;
  std::uint64_t value = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return false;
    value = 10 * value + static_cast<std::uint64_t>(c - '0');
    if (value > most) value = most;
  }
  *number = static_cast<std::uint32_t>(value);
  return true;
}

}  // namespace aresta
