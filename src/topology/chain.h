// SPDX-License-Identifier: Apache-2.0
// Ranges over linked records: `chain` follows links to their end, `cycle` once around, IdRange counts.
#pragma once

#include <cstddef>
#include <iterator>

namespace aresta {

namespace detail {
template <class Item>
constexpr bool is_valid(const Item& item) {
  if constexpr (requires { item.valid(); }) {
    return item.valid();
  } else {
    return item.edge.valid();  // EdgeEnd
  }
}
}  // namespace detail

template <class Item, class Next, bool closed>
class LinkRange {
 public:
  class iterator {
   public:
    using value_type = Item;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(Item item, const LinkRange* range) : item_(item), range_(range) {}
    Item operator*() const { return item_; }
    iterator& operator++() {
      item_ = range_->next_(item_);
      if (closed && item_ == range_->first_) item_ = Item{};
      return *this;
    }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    bool operator==(std::default_sentinel_t) const { return !detail::is_valid(item_); }

   private:
    Item item_{};
    const LinkRange* range_ = nullptr;
  };

  LinkRange(Item first, Next next) : first_(first), next_(next) {}
  iterator begin() const { return {first_, this}; }
  std::default_sentinel_t end() const { return {}; }
  bool empty() const { return !detail::is_valid(first_); }
  std::size_t count() const {
    std::size_t n = 0;
    for (auto it = begin(); it != end(); ++it) ++n;
    return n;
  }

 private:
  Item first_;
  Next next_;
};

template <class Item, class Next>
LinkRange<Item, Next, false> chain(Item first, Next next) {
  return {first, next};
}

template <class Item, class Next>
LinkRange<Item, Next, true> cycle(Item first, Next next) {
  return {first, next};
}

/// The ids 0 .. n - 1.
template <class IdType>
class IdRange {
 public:
  class iterator {
   public:
    using value_type = IdType;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    explicit iterator(std::size_t i) : i_(i) {}
    IdType operator*() const { return IdType(i_); }
    iterator& operator++() {
      ++i_;
      return *this;
    }
    iterator operator++(int) { return iterator(i_++); }
    bool operator==(const iterator&) const = default;

   private:
    std::size_t i_ = 0;
  };

  explicit IdRange(std::size_t n) : n_(n) {}
  iterator begin() const { return iterator(0); }
  iterator end() const { return iterator(n_); }
  std::size_t size() const { return n_; }

 private:
  std::size_t n_;
};

}  // namespace aresta
