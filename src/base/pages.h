// SPDX-License-Identifier: Apache-2.0
// Pages<T>: an array in reference-counted pages, copied on write.
//
// Copying a Pages costs one pointer per page (a table of pages, itself shared, costs nothing until it is written to);
// a write to a shared page copies that page alone. This is what makes snapshots, undo and rollback cheap.
// Reading from several threads is safe while nobody writes to the same object.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <memory>
#include <vector>

namespace aresta {

template <class T, std::size_t page_bits = 10>
class Pages {
 public:
  static constexpr std::size_t page_size = std::size_t{1} << page_bits;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  const T& operator[](std::size_t i) const {
    assert(i < size_);
    return (*(*table_)[i >> page_bits])[i & (page_size - 1)];
  }

  /// A reference to write through; copies the page when a snapshot shares it. Valid until the next copy of this object.
  T& edit(std::size_t i) {
    assert(i < size_);
    return writable_page(i >> page_bits)[i & (page_size - 1)];
  }

  void push_back(const T& item) {
    if (size_ == capacity()) {
      writable_table().push_back(std::make_shared<Page>());
    }
    ++size_;
    edit(size_ - 1) = item;
  }

  void resize(std::size_t n, const T& item = T{}) {
    if (n < size_) {
      writable_table().resize((n + page_size - 1) >> page_bits);
      size_ = n;
    }
    while (size_ < n) push_back(item);
  }

  void clear() {
    table_ = std::make_shared<Table>();
    size_ = 0;
  }

  /// Bytes allocated by this object, shared pages included.
  std::size_t allocated_bytes() const {
    return table_->size() * (sizeof(Page) + control_block_bytes) + table_->capacity() * sizeof(PagePtr);
  }

  /// How many pages this object does not share with `other`: what a change since a snapshot has cost.
  std::size_t pages_not_shared_with(const Pages& other) const {
    std::size_t count = 0;
    for (std::size_t p = 0; p < table_->size(); ++p) {
      count += p >= other.table_->size() || (*table_)[p] != (*other.table_)[p];
    }
    return count;
  }

 private:
  using Page = std::array<T, page_size>;
  using PagePtr = std::shared_ptr<Page>;
  using Table = std::vector<PagePtr>;
  static constexpr std::size_t control_block_bytes = 16;

  std::size_t capacity() const { return table_->size() << page_bits; }

  Table& writable_table() {
    if (table_.use_count() > 1) table_ = std::make_shared<Table>(*table_);
    return *table_;
  }

  Page& writable_page(std::size_t p) {
    // The table first: while it is shared, a page in it may count one owner and still be seen by two.
    PagePtr& page = writable_table()[p];
    if (page.use_count() > 1) page = std::make_shared<Page>(*page);
    return *page;
  }

  std::shared_ptr<Table> table_ = std::make_shared<Table>();
  std::size_t size_ = 0;
};

}  // namespace aresta
