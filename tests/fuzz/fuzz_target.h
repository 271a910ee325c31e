// SPDX-License-Identifier: Apache-2.0
// The body of a target of libFuzzer: stops where a reader breaks its promise, and counts for the topic's figures.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/properties.h"

namespace aresta::test {

inline int fuzz(Verdict (*check)(std::string_view), const std::uint8_t* data, std::size_t size) {
  struct Counts {
    unsigned long accepted = 0, refused = 0;
    ~Counts() { std::fprintf(stderr, "accepted %lu, refused %lu\n", accepted, refused); }
  };
  static Counts counts;
  const Verdict verdict = check({reinterpret_cast<const char*>(data), size});
  ++(verdict.accepted ? counts.accepted : counts.refused);
  if (!verdict.wrong.empty()) {
    std::fprintf(stderr, "wrong: %s\n", verdict.wrong.c_str());
    std::abort();
  }
  return 0;
}

}  // namespace aresta::test
