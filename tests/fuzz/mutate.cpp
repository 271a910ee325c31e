// SPDX-License-Identifier: Apache-2.0
// mutate_topology SEED CASES: tries each reader of topology/ with so many mutated texts, and says how it went. Texts
// that went wrong are left in the current folder, to be added to tests/corpus/topology.
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "fuzz/mutations.h"

int main(int argument_count, char** arguments) {
  using namespace aresta::test;
  if (argument_count != 3) {
    std::cerr << "usage: mutate_topology SEED CASES\n";
    return 2;
  }
  const std::uint64_t seed = std::strtoull(arguments[1], nullptr, 10);
  const unsigned long cases = std::strtoul(arguments[2], nullptr, 10);
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
