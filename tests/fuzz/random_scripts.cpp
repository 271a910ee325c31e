// SPDX-License-Identifier: Apache-2.0
// Tries scripts of operators without a fuzzer.
//
//   random_scripts SEED CASES         so many scripts of seeded bytes; those that go wrong are left in the current
//                                     folder, to be added to tests/corpus/topology/script
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>

#include "fuzz/script_properties.h"

int main(int argument_count, char** arguments) {
  using namespace aresta::test;
  if (argument_count != 3) {
    std::cerr << "usage: random_scripts SEED CASES\n";
    return 2;
  }
  std::mt19937_64 random(std::strtoull(arguments[1], nullptr, 10));
  const unsigned long cases = std::strtoul(arguments[2], nullptr, 10);
  unsigned long accepted = 0, wrong = 0;
  for (unsigned long i = 0; i < cases; ++i) {
    std::string bytes(random() % 600, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    const Verdict verdict = check_script_of_bytes(bytes);
    accepted += verdict.accepted ? 1 : 0;
    if (verdict.wrong.empty()) continue;
    const std::string file = "wrong-script-" + std::to_string(i);
    std::ofstream(file) << verdict.wrong;
    std::cout << file << ": " << verdict.wrong << "\n";
    ++wrong;
  }
  std::cout << "script: accepted " << accepted << ", refused " << cases - accepted << ", wrong " << wrong << "\n";
  return wrong == 0 ? 0 : 1;
}
