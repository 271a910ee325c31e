// SPDX-License-Identifier: Apache-2.0
// Tries the readers of topology/ without a fuzzer, and gives fuzzers texts to begin with.
//
//   mutate_topology SEED CASES        each reader with so many mutated texts; those that go wrong are left in the
//                                     current folder, to be added to tests/corpus/topology
//   mutate_topology corpus FOLDER     writes the texts to begin with into FOLDER/dump, FOLDER/json, FOLDER/notation
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "fuzz/mutations.h"

namespace {

using namespace aresta::test;

int write_corpus(const std::filesystem::path& folder) {
  for (const Format& format : formats()) {
    std::filesystem::create_directories(folder / format.name);
    int number = 0;
    for (const auto& text : corpus(format)) {
      std::ofstream(folder / format.name / std::to_string(number++), std::ios::binary) << text.text;
    }
  }
  return 0;
}

int try_mutations(std::uint64_t seed, unsigned long cases) {
  unsigned long all_wrong = 0;
  for (const Format& format : formats()) {
    const auto texts = corpus(format);
    Mutator mutator(seed);
    unsigned long accepted = 0, wrong = 0;
    for (unsigned long i = 0; i < cases; ++i) {
      const std::string text = mutator.mutate(texts);
      const Verdict verdict = format.check(text);
      accepted += verdict.accepted ? 1 : 0;
      if (verdict.wrong.empty()) continue;
      const std::string file = "wrong-" + std::string(format.name) + "-" + std::to_string(i);
      std::ofstream(file, std::ios::binary) << text;
      std::cout << file << ": " << verdict.wrong << "\n";
      ++wrong;
    }
    std::cout << format.name << ": accepted " << accepted << ", refused " << cases - accepted << ", wrong " << wrong
              << "\n";
    all_wrong += wrong;
  }
  return all_wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::cerr << "usage: mutate_topology SEED CASES | mutate_topology corpus FOLDER\n";
    return 2;
  }
  if (std::string(arguments[1]) == "corpus") return write_corpus(arguments[2]);
  return try_mutations(std::strtoull(arguments[1], nullptr, 10), std::strtoul(arguments[2], nullptr, 10));
}
