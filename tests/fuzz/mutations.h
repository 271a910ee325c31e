// SPDX-License-Identifier: Apache-2.0
// Small changes of texts that a reader is tried with: bytes, words, lines and numbers. The same seed gives the same
// texts everywhere.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "fuzz/corpus.h"

namespace aresta::test {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  /// One of the texts, changed once or a few times.
  std::string mutate(const std::vector<CorpusText>& texts);

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  void change(std::string& text, const std::string& other);
  void change_bytes(std::string& text);
  void change_words(std::string& text, const std::string& other);
  void change_lines(std::string& text);
  void change_number(std::string& text);
  void shift_ids(std::string& text);

  std::mt19937_64 random_;
};

}  // namespace aresta::test
