// SPDX-License-Identifier: Apache-2.0
#include "base/large_block.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace aresta {

LargeBlock::LargeBlock() : memory_(static_cast<std::byte*>(std::aligned_alloc(bytes, bytes))) {
  if (memory_ == nullptr) throw std::bad_alloc();
  madvise(memory_, bytes, MADV_HUGEPAGE);  // a wish: where the system has no large pages, it stays with small ones
}

LargeBlock::~LargeBlock() {
  std::free(memory_);
}

}  // namespace aresta
