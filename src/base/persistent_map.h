// SPDX-License-Identifier: Apache-2.0
// PersistentMap<Key, Value>: a sorted map that is copied for nothing. A write copies the path to the entry alone, so
// that a copy taken before keeps what it had.
//
// A treap whose priorities are a hash of the key: its shape follows from the keys alone, whatever the order of writes,
// so that it is the same on every run. Find, set and erase: expected O(log n). Comparing two states skips all they
// share. Key needs <, and priority(Key). Reading from several threads is safe while nobody writes to the same object.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "base/ids.h"

namespace aresta {

/// A hash that spreads all bits (the finalizer of splitmix64).
constexpr std::uint64_t spread_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}
constexpr std::uint64_t priority(std::uint64_t key) {
  return spread_bits(key);
}
constexpr std::uint64_t priority(EntityRef key) {
  return spread_bits(static_cast<std::uint64_t>(key.kind) << 32 | key.index);
}

template <class Key, class Value>
class PersistentMap {
  struct Node;
  using Link = std::shared_ptr<const Node>;
  struct Node {
    Key key;
    Value value;
    Link left, right;
  };

 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// Null when there is none. Valid until this object is written to.
  const Value* find(const Key& key) const {
    const Node* node = root_.get();
    while (node != nullptr) {
      if (key < node->key) {
        node = node->left.get();
      } else if (node->key < key) {
        node = node->right.get();
      } else {
        return &node->value;
      }
    }
    return nullptr;
  }
  bool contains(const Key& key) const { return find(key) != nullptr; }

  void set(const Key& key, Value value) {
    if (const Value* now = find(key); now != nullptr && *now == value) return;
    if (!contains(key)) ++size_;
    root_ = put(root_, key, std::move(value));
  }

  /// Was it there?
  bool erase(const Key& key) {
    if (!contains(key)) return false;
    --size_;
    root_ = drop(root_, key);
    return true;
  }

  /// visit(key, value), keys growing.
  template <class Visit>
  void for_each(Visit&& visit) const {
    walk(root_.get(), visit);
  }

  bool operator==(const PersistentMap& other) const {
    return size_ == other.size_ && equal(root_.get(), other.root_.get());
  }

 private:
  static Link node(const Node& like, Link left, Link right) {
    return std::make_shared<const Node>(Node{like.key, like.value, std::move(left), std::move(right)});
  }

  /// Before another with the same priority: the smaller key.
  static bool above(const Key& a, const Key& b) {
    const std::uint64_t p = priority(a), q = priority(b);
    return p != q ? p > q : a < b;
  }

  /// The entries below the key and those above it; the key itself is in neither.
  static std::pair<Link, Link> split(const Link& at, const Key& key) {
    if (!at) return {};
    if (at->key < key) {
      auto [low, high] = split(at->right, key);
      return {node(*at, at->left, std::move(low)), std::move(high)};
    }
    if (key < at->key) {
      auto [low, high] = split(at->left, key);
      return {std::move(low), node(*at, std::move(high), at->right)};
    }
    return {at->left, at->right};
  }

  /// All entries of `low` are below those of `high`.
  static Link join(const Link& low, const Link& high) {
    if (!low) return high;
    if (!high) return low;
    if (above(low->key, high->key)) return node(*low, low->left, join(low->right, high));
    return node(*high, join(low, high->left), high->right);
  }

  static Link put(const Link& at, const Key& key, Value value) {
    if (!at || above(key, at->key)) {
      auto [low, high] = split(at, key);
      return std::make_shared<const Node>(Node{key, std::move(value), std::move(low), std::move(high)});
    }
    if (key < at->key) return node(*at, put(at->left, key, std::move(value)), at->right);
    if (at->key < key) return node(*at, at->left, put(at->right, key, std::move(value)));
    return std::make_shared<const Node>(Node{key, std::move(value), at->left, at->right});
  }

  static Link drop(const Link& at, const Key& key) {
    if (key < at->key) return node(*at, drop(at->left, key), at->right);
    if (at->key < key) return node(*at, at->left, drop(at->right, key));
    return join(at->left, at->right);
  }

  template <class Visit>
  static void walk(const Node* at, Visit& visit) {
    if (at == nullptr) return;
    walk(at->left.get(), visit);
    visit(at->key, at->value);
    walk(at->right.get(), visit);
  }

  static bool equal(const Node* a, const Node* b) {
    if (a == b) return true;
    if (a == nullptr || b == nullptr) return false;
    return !(a->key < b->key) && !(b->key < a->key) && a->value == b->value && equal(a->left.get(), b->left.get()) &&
           equal(a->right.get(), b->right.get());
  }

  Link root_;
  std::size_t size_ = 0;
};

}  // namespace aresta
