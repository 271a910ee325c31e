// SPDX-License-Identifier: Apache-2.0
// Tries the planar engine without a fuzzer.
//
//   random_planar SEED CASES          so many soups and pairs of meshes from seeded bytes; the bytes of those that go
//                                     wrong are left in the current folder, for tests/corpus/planar
//   random_planar FILE...             files of bytes, named groups-* or meshes-*
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>

#include "fuzz/planar_properties.h"

using namespace aresta::test;

namespace {

constexpr struct {
  const char* name;
  Verdict (*check)(std::string_view);
} targets[] = {{"groups", check_planar_groups}, {"meshes", check_planar_meshes}};

int try_files(int count, char** files) {
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    std::ifstream in(files[i], std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    for (const auto& target : targets) {
      if (std::string_view(files[i]).find(target.name) == std::string_view::npos) continue;
      const Verdict verdict = target.check(bytes);
      std::cout << files[i] << ": "
                << (verdict.wrong.empty() ? verdict.accepted ? "accepted" : "refused" : verdict.wrong) << "\n";
      wrong += verdict.wrong.empty() ? 0 : 1;
    }
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count < 2) {
    std::cerr << "usage: random_planar SEED CASES | FILE...\n";
    return 2;
  }
  if (std::ifstream(arguments[1])) return try_files(argument_count - 1, arguments + 1);
  std::mt19937_64 random(std::strtoull(arguments[1], nullptr, 10));
  const unsigned long cases = argument_count > 2 ? std::strtoul(arguments[2], nullptr, 10) : 1000;
  bool good = true;
  for (const auto& target : targets) {
    unsigned long accepted = 0, wrong = 0;
    for (unsigned long i = 0; i < cases; ++i) {
      std::string bytes(20 + random() % 100, '\0');
      for (char& byte : bytes) byte = static_cast<char>(random());
      const Verdict verdict = target.check(bytes);
      accepted += verdict.accepted ? 1 : 0;
      if (verdict.wrong.empty()) continue;
      const std::string file = std::string(target.name) + "-" + std::to_string(i);
      std::ofstream(file, std::ios::binary) << bytes;
      if (++wrong <= 10) std::cout << file << ": " << verdict.wrong << "\n";
    }
    std::cout << target.name << ": accepted " << accepted << ", refused " << cases - accepted - wrong << ", wrong "
              << wrong << "\n";
    good = good && wrong == 0;
  }
  return good ? 0 : 1;
}
