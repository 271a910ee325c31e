// SPDX-License-Identifier: Apache-2.0
// Ranges over linked records: `chain` follows links to their end, `cycle` once around, LiveRange counts up.
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

/// The ids below a bound that are live in their store, in growing order.
template <class IdType, class Store>
class LiveRange {
 public:
  class iterator {
   public:
    using value_type = IdType;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(const Store* store, std::size_t i, std::size_t bound) : store_(store), i_(i), bound_(bound) { skip(); }
    IdType operator*() const { return IdType(i_); }
    iterator& operator++() {
      ++i_;
      skip();
      return *this;
    }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    bool operator==(const iterator& other) const { return i_ == other.i_; }

   private:
    void skip() {
      while (i_ < bound_ && !store_->is_live(IdType(i_))) ++i_;
    }
    const Store* store_ = nullptr;
    std::size_t i_ = 0, bound_ = 0;
  };

  LiveRange(const Store* store, std::size_t bound) : store_(store), bound_(bound) {}
  iterator begin() const { return {store_, 0, bound_}; }
  iterator end() const { return {store_, bound_, bound_}; }
  bool empty() const { return begin() == end(); }

 private:
  const Store* store_;
  std::size_t bound_;
};

}  // namespace aresta
