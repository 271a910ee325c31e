// SPDX-License-Identifier: Apache-2.0
// Blocks of memory of the size of the system's large pages, for arrays that are written in bulk: a block costs one
// fault where the same bytes one by one cost hundreds, which is what new memory costs most.
//
// What is allocated in a block owns a share of it: the block is freed with the last of them. A vector of many items can
// lie in large pages by itself.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace aresta {

/// A wish: where the system has no large pages, or none fits in there, it stays with small ones.
void prefer_large_pages(const void* memory, std::size_t bytes);

/// The room that is reserved, before anything is written to it.
template <class T>
void prefer_large_pages(const std::vector<T>& room) {
  prefer_large_pages(room.data(), room.capacity() * sizeof(T));
}

template <class T>
std::vector<T> vector_in_large_pages(std::size_t size, const T& item) {
  std::vector<T> result;
  result.reserve(size);
  prefer_large_pages(result);
  result.resize(size, item);
  return result;
}

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
