// SPDX-License-Identifier: Apache-2.0
#include "fuzz/mutations.h"

#include <algorithm>
#include <cctype>

namespace aresta::test {

namespace {

bool is_word_part(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The text cut between words and what is between them, or behind each line.
std::vector<std::string> cut(const std::string& text, bool lines) {
  std::vector<std::string> pieces;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool goes_on = i > 0 && (lines ? text[i - 1] != '\n' : is_word_part(text[i]) && is_word_part(text[i - 1]));
    if (!goes_on) pieces.emplace_back();
    pieces.back() += text[i];
  }
  return pieces;
}

std::string join(const std::vector<std::string>& pieces) {
  std::string text;
  for (const auto& piece : pieces) text += piece;
  return text;
}

}  // namespace

std::string Mutator::mutate(const std::vector<CorpusText>& texts) {
  std::string text = texts[below(texts.size())].text;
  const std::size_t times = 1 + below(4) * below(3);
  for (std::size_t i = 0; i < times; ++i) change(text, texts[below(texts.size())].text);
  constexpr std::size_t longest = 20000;
  if (text.size() > longest) text.resize(longest);
  return text;
}

void Mutator::change(std::string& text, const std::string& other) {
  switch (below(8)) {
    case 0:
    case 1:
      return change_bytes(text);
    case 2:
    case 3:
      return change_words(text, other);
    case 4:
      return change_lines(text);
    case 5:
      return change_number(text);
    case 6:
      return shift_ids(text);
    case 7:
      // One text's head and another's tail.
      text.resize(below(text.size() + 1));
      if (below(4) != 0) text += other.substr(below(other.size() + 1));
      return;
  }
}

void Mutator::change_bytes(std::string& text) {
  const std::size_t at = below(text.size() + 1);
  static const std::string common = "+-:,|#.0123456789vecflrin \n\"[]{}";
  const char byte = below(4) == 0 ? static_cast<char>(below(256)) : common[below(common.size())];
  switch (below(3)) {
    case 0:
      text.insert(at, 1, byte);
      return;
    case 1:
      text.erase(at, 1 + below(3));
      return;
    case 2:
      if (at < text.size()) text[at] = byte;
      return;
  }
}

void Mutator::change_words(std::string& text, const std::string& other) {
  auto words = cut(text, false);
  const auto others = cut(other, false);
  if (words.empty() || others.empty()) return;
  std::string& word = words[below(words.size())];
  switch (below(5)) {
    case 0:
      word = words[below(words.size())];
      break;
    case 1:
      word = others[below(others.size())];
      break;
    case 2:
      word += " " + others[below(others.size())];
      break;
    case 3:
      word.clear();
      break;
    case 4:
      std::swap(word, words[below(words.size())]);
      break;
  }
  text = join(words);
}

void Mutator::change_lines(std::string& text) {
  auto lines = cut(text, true);
  if (lines.empty()) return;
  const std::size_t line = below(lines.size()), place = below(lines.size());
  switch (below(4)) {
    case 0:
      lines[line].clear();
      break;
    case 1:
      std::swap(lines[line], lines[place]);
      break;
    case 2:
      lines[line] += lines[place];
      break;
    case 3:
      lines[line].insert(0, "  # a comment\n\n");
      break;
  }
  text = join(lines);
}

void Mutator::change_number(std::string& text) {
  auto words = cut(text, false);
  std::vector<std::string*> numbers;
  for (auto& word : words) {
    if (is_digit(word.back())) numbers.push_back(&word);
  }
  if (numbers.empty()) return;
  std::string& word = *numbers[below(numbers.size())];
  while (!word.empty() && is_digit(word.back())) word.pop_back();
  static const char* const extremes[] = {"1048575",    "1048576",    "1073741823",           "2147483647",
                                         "4294967295", "4294967296", "18446744073709551616", "007"};
  word += below(4) == 0 ? extremes[below(std::size(extremes))] : std::to_string(below(12));
  text = join(words);
}

/// All ids of one kind from some on grow, so that the text stays sound and gets gaps.
void Mutator::shift_ids(std::string& text) {
  static const std::string letters = "vecflr";
  const char letter = letters[below(letters.size())];
  const unsigned long from = below(12), by = below(20) == 0 ? 1000 * below(1000) : below(5);
  auto words = cut(text, false);
  for (auto& word : words) {
    if (word.size() < 2 || word.size() > 8 || word[0] != letter ||
        !std::all_of(word.begin() + 1, word.end(), is_digit)) {
      continue;
    }
    const unsigned long id = std::stoul(word.substr(1));
    if (id >= from && (letter != 'r' || id != 0)) word = letter + std::to_string(id + by);
  }
  text = join(words);
}

}  // namespace aresta::test
