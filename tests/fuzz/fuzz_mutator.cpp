// SPDX-License-Identifier: Apache-2.0
// Has libFuzzer use the mutations of texts besides its own, which seldom keep a text sound.
#include <algorithm>
#include <cstring>

#include "fuzz/mutations.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const aresta::test::CorpusText text{{}, std::string(reinterpret_cast<const char*>(data), size)};
  const std::string mutated = aresta::test::Mutator(seed).mutate({text});
  const std::size_t length = std::min(mutated.size(), max_size);
  std::memcpy(data, mutated.data(), length);
  return length;
}
