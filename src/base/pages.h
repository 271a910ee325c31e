// SPDX-License-Identifier: Apache-2.0
// Pages<T>: an array in reference-counted pages, copied on write.
//
// Copying a Pages costs nothing (the table of pages is shared until one side is written to; then it costs one pointer
// per page); a write to a shared page copies that page alone. This is what makes snapshots, undo and rollback cheap.
// The first page grows with its content, so that a small array is small; every other page is whole. Reading from
// several threads is safe while nobody writes to the same object.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <vector>

#include "base/large_pages.h"

namespace aresta {

template <class T, std::size_t page_bits = 10>
class Pages {
 public:
  static constexpr std::size_t page_size = std::size_t{1} << page_bits;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  const T& operator[](std::size_t i) const {
    assert(i < size_);
    return (*table_)[i >> page_bits][i & (page_size - 1)];
  }

  /// A reference to write through; copies the page when a snapshot shares it. Valid until the next copy of this object
  /// or change of its size.
  T& edit(std::size_t i) {
    assert(i < size_);
    return writable_page(i >> page_bits)[i & (page_size - 1)];
  }

  /// All items to write to, without the look for snapshots that edit() takes each time.
  class Writer {
   public:
    T& operator[](std::size_t i) const {
      assert(i < size_);
      return pages_[i >> page_bits][i & (page_size - 1)];
    }

   private:
    friend class Pages;
    std::vector<T*> pages_;
    std::size_t size_ = 0;
  };

  /// For writing in bulk: copies every page that a snapshot shares. Valid until the next copy of this object or change
  /// of its size.
  Writer write_all() {
    Writer writer;
    writer.size_ = size_;
    for (std::size_t p = 0; p < table_->size(); ++p) writer.pages_.push_back(writable_page(p).get());
    return writer;
  }

  void push_back(const T& item) {
    const T kept = item;  // it may lie in a page that moves
    if (size_ == capacity_) reserve_one_more();
    ++size_;
    edit(size_ - 1) = kept;
  }

  void resize(std::size_t n, const T& item = T{}) {
    const T kept = item;
    while (capacity_ != 0 && capacity_ < std::min(n, page_size)) reserve_one_more();
    for (std::size_t i = size_; i < std::min(n, capacity_);) {
      const std::size_t page = i >> page_bits, last = std::min({n, capacity_, (page + 1) << page_bits});
      size_ = last;
      T* const items = writable_page(page).get();
      std::fill(items + (i & (page_size - 1)), items + (last - (page << page_bits)), kept);
      i = last;
    }
    while (capacity_ < n) add_page(capacity_ == 0 ? std::min(n, page_size) : page_size, kept);
    size_ = std::max(size_, n);
    if (n < size_) {
      size_ = n;
      const std::size_t pages = (n + page_size - 1) >> page_bits;
      if (pages < table_->size()) {
        writable_table().resize(pages);
        capacity_ = std::min(capacity_, pages << page_bits);
      }
    }
  }

  /// n items instead of those that are there, item i being make(i): in one pass over memory, which comes in large
  /// blocks. A block is freed with the last of its pages: what a snapshot still has of it holds it all.
  template <class Make>
  void generate(std::size_t n, Make&& make) {
    *this = Pages();
    table_->reserve((n + page_size - 1) >> page_bits);
    std::shared_ptr<LargeBlock> block;
    std::size_t left_in_block = 0;
    while (size_ < n) {
      const std::size_t count = std::min(n - size_, page_size);
      if (left_in_block == 0 && n - size_ >= pages_in_block * page_size) {  // blocks that become full alone
        block = std::make_shared<LargeBlock>();
        left_in_block = pages_in_block;
      }
      if (left_in_block > 0) {
        add_page(std::allocate_shared<T[]>(LargeBlockAllocator<T>(block), page_size), page_size);
        --left_in_block;
      } else {
        add_page(capacity_ == 0 ? count : page_size);
      }
      T* const items = table_->back().get();
      for (std::size_t i = 0; i < count; ++i) items[i] = make(size_ + i);
      size_ += count;
    }
  }

  void clear() { *this = Pages(); }

  /// Bytes allocated by this object, shared pages included.
  std::size_t allocated_bytes() const {
    return capacity_ * sizeof(T) + table_->size() * control_block_bytes + table_->capacity() * sizeof(PagePtr);
  }

  /// How many pages this object does not share with `other`, and how many bytes, its own table included: what a change
  /// since a snapshot has cost.
  std::size_t pages_not_shared_with(const Pages& other) const {
    std::size_t count = 0;
    for (std::size_t p = 0; p < table_->size(); ++p) count += !shares_page(p, other);
    return count;
  }
  std::size_t bytes_not_shared_with(const Pages& other) const {
    std::size_t bytes = table_ == other.table_ ? 0 : table_->size() * sizeof(PagePtr);
    for (std::size_t p = 0; p < table_->size(); ++p) {
      if (!shares_page(p, other)) bytes += items_in_page(p) * sizeof(T);
    }
    return bytes;
  }
  /// Calls visit(first, last) for each range of indices whose page the two objects do not share: all else is equal.
  template <class Visit>
  void for_each_difference(const Pages& other, Visit&& visit) const {
    const std::size_t pages = std::max(table_->size(), other.table_->size());
    for (std::size_t p = 0; p < pages; ++p) {
      const std::size_t end = (p + 1) << page_bits;
      if (p < table_->size() && shares_page(p, other) &&
          (size_ == other.size_ || end <= std::min(size_, other.size_))) {
        continue;
      }
      visit(p << page_bits, std::min(end, std::max(size_, other.size_)));
    }
  }

 private:
  using PagePtr = std::shared_ptr<T[]>;
  using Table = std::vector<PagePtr>;
  static constexpr std::size_t control_block_bytes = 64;  // no more, whichever the allocator
  static constexpr std::size_t pages_in_block = LargeBlock::bytes / (page_size * sizeof(T) + control_block_bytes);
  static constexpr std::size_t first_capacity = 8;

  bool shares_page(std::size_t p, const Pages& other) const {
    return p < other.table_->size() && (*table_)[p] == (*other.table_)[p];
  }

  /// How many items page p has room for.
  std::size_t items_in_page(std::size_t p) const { return p == 0 ? std::min(capacity_, page_size) : page_size; }

  void add_page(PagePtr page, std::size_t items) {
    writable_table().push_back(std::move(page));
    capacity_ += items;
  }
  void add_page(std::size_t items, const T& item = T{}) { add_page(std::make_shared<T[]>(items, item), items); }

  void reserve_one_more() {
    if (capacity_ >= page_size) return add_page(page_size);
    if (capacity_ == 0) return add_page(std::min(first_capacity, page_size));
    const std::size_t grown = std::min(2 * capacity_, page_size);
    auto page = std::make_shared<T[]>(grown);
    std::copy((*table_)[0].get(), (*table_)[0].get() + size_, page.get());
    writable_table()[0] = std::move(page);
    capacity_ = grown;
  }

  Table& writable_table() {
    if (table_.use_count() > 1) table_ = std::make_shared<Table>(*table_);
    return *table_;
  }

  PagePtr& writable_page(std::size_t p) {
    // The table first: while it is shared, a page in it may count one owner and still be seen by two.
    PagePtr& page = writable_table()[p];
    if (page.use_count() > 1) {
      const std::size_t items = items_in_page(p);
      auto own = std::make_shared<T[]>(items);
      std::copy(page.get(), page.get() + items, own.get());
      page = std::move(own);
    }
    return page;
  }

  std::shared_ptr<Table> table_ = std::make_shared<Table>();
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace aresta
