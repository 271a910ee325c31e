// SPDX-License-Identifier: Apache-2.0
// Blocks of memory of the size of the system's large pages, for arrays that are written in bulk: a block costs one
// fault where the same bytes one by one cost hundreds, which is what new memory costs most.
//
// What is allocated in a block owns a share of it: the block is freed with the last of them.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <utility>

namespace aresta {

class LargeBlock {
 public:
  static constexpr std::size_t bytes = std::size_t{2} << 20;

  LargeBlock();
  ~LargeBlock();
  LargeBlock(const LargeBlock&) = delete;
  LargeBlock& operator=(const LargeBlock&) = delete;

  /// The next bytes of the block. There must be room.
  void* take(std::size_t count, std::size_t alignment) {
    used_ = (used_ + alignment - 1) / alignment * alignment;
    assert(used_ + count <= bytes);
    return memory_ + std::exchange(used_, used_ + count);
  }

 private:
  std::byte* memory_;
  std::size_t used_ = 0;
};

/// The allocator of one block, as the standard library wants it.
template <class T>
struct LargeBlockAllocator {
  using value_type = T;

  std::shared_ptr<LargeBlock> block;

  explicit LargeBlockAllocator(std::shared_ptr<LargeBlock> of) : block(std::move(of)) {}
  template <class U>
  LargeBlockAllocator(const LargeBlockAllocator<U>& other) : block(other.block) {}

  T* allocate(std::size_t count) { return static_cast<T*>(block->take(count * sizeof(T), alignof(T))); }
  void deallocate(T*, std::size_t) {}
  template <class U>
  bool operator==(const LargeBlockAllocator<U>& other) const {
    return block == other.block;
  }
};

}  // namespace aresta
