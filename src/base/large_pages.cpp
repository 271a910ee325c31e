// SPDX-License-Identifier: Apache-2.0
#include "base/large_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <new>

namespace aresta {

void prefer_large_pages(const void* memory, std::size_t bytes) {
  constexpr std::uintptr_t page = 4096;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(memory) + bytes;
  if (bytes >= LargeBlock::bytes) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

LargeBlock::LargeBlock() : memory_(static_cast<std::byte*>(std::aligned_alloc(bytes, bytes))) {
  if (memory_ == nullptr) throw std::bad_alloc();
  prefer_large_pages(memory_, bytes);
}

LargeBlock::~LargeBlock() {
  std::free(memory_);
}

}  // namespace aresta
