// SPDX-License-Identifier: Apache-2.0
// The records of a complex as they are, to read, for what must not rely on them.
#pragma once

#include "topology/finding.h"

namespace aresta {

struct ComplexRows {
 private:
  /// The table of a kind, which member of its records marks a free row and which one links free rows.
  template <class Visit>
  auto visit(RowKind kind, Visit&& use) const {
    switch (kind) {
      case RowKind::vertex:
        return use(
            k.vertices_, [](auto& r) { return r.first_end; }, [](auto& r) { return r.owner; });
      case RowKind::edge:
        return use(
            k.edges_, [](auto& r) { return r.vertex[0]; }, [](auto& r) { return r.vertex[1]; });
      case RowKind::wire:
        return use(
            k.wires_, [](auto& r) { return r.edge; }, [](auto& r) { return r.next; });
      case RowKind::coedge:
        return use(
            k.coedges_, [](auto& r) { return r.loop; }, [](auto& r) { return r.next; });
      case RowKind::point_use:
        return use(
            k.point_uses_, [](auto& r) { return r.loop; }, [](auto& r) { return r.next; });
      case RowKind::loop:
        return use(
            k.loops_, [](auto& r) { return r.face; }, [](auto& r) { return r.next; });
      case RowKind::face:
        return use(
            k.faces_, [](auto& r) { return r.first_loop; }, [](auto& r) { return r.shell[0]; });
      case RowKind::shell:
        return use(
            k.shells_, [](auto& r) { return r.region; }, [](auto& r) { return r.next; });
      case RowKind::region:
        break;
    }
    return use(
        k.regions_, [](auto& r) { return r.filled; }, [](auto& r) { return r.first_shell; });
  }

 public:
  explicit ComplexRows(const Complex& complex) : k(complex) {}

  static constexpr std::uint32_t none = Complex::none, dead = Complex::dead, tag = Complex::tag;
  static bool is_tagged(std::uint32_t code) { return (code & tag) != 0; }

  const auto& vertices() const { return k.vertices_; }
  const auto& edges() const { return k.edges_; }
  const auto& wires() const { return k.wires_; }
  const auto& coedges() const { return k.coedges_; }
  const auto& point_uses() const { return k.point_uses_; }
  const auto& loops() const { return k.loops_; }
  const auto& faces() const { return k.faces_; }
  const auto& shells() const { return k.shells_; }
  const auto& regions() const { return k.regions_; }

  std::uint32_t size(RowKind kind) const {
    return visit(kind, [](const auto& rows, auto&&, auto&&) { return static_cast<std::uint32_t>(rows.size()); });
  }
  bool is_live(Row row) const {
    return visit(row.kind, [&](const auto& rows, auto&& mark, auto&&) {
      return row.index < rows.size() && mark(rows[row.index]) != dead;
    });
  }
  /// The free row that a free one leads to.
  std::uint32_t next_free(Row row) const {
    return visit(row.kind, [&](const auto& rows, auto&&, auto&& next) { return next(rows[row.index]); });
  }
  std::uint32_t first_free(RowKind kind) const { return k.free_[static_cast<std::size_t>(kind)].first; }
  std::uint32_t free_count(RowKind kind) const { return k.free_[static_cast<std::size_t>(kind)].count; }

  const Complex& k;
};

}  // namespace aresta
