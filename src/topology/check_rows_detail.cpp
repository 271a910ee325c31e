// SPDX-License-Identifier: Apache-2.0
// First stage: rows and links, each looked at once.
#include "topology/check_detail.h"

namespace aresta::check_detail {

namespace {

using namespace structure;

constexpr std::uint32_t none = ComplexRows::none;

void check_free_rows(const ComplexRows& rows, RowKind kind, Findings& findings) {
  const std::uint32_t size = rows.size(kind);
  std::vector<bool> listed(size, false);
  bool broken = false;
  for (std::uint32_t row = rows.first_free(kind); row != none; row = rows.next_free({kind, row})) {
    if (row >= size || listed[row] || rows.is_live({kind, row})) {
      findings.push_back(FreeListBroken{{kind, row}});
      broken = true;
      break;
    }
    listed[row] = true;
  }
  std::uint32_t dead = 0;
  for (std::uint32_t row = 0; row < size; ++row) {
    if (rows.is_live({kind, row})) continue;
    ++dead;
    if (!listed[row] && !broken) findings.push_back(DeadRowNotFree{{kind, row}});
  }
  if (dead != rows.free_count(kind)) findings.push_back(FreeCountWrong{kind, rows.free_count(kind), dead});
}

class LinkCheck {
 public:
  LinkCheck(const ComplexRows& rows, Findings& findings) : rows_(rows), findings_(findings) {}

  void run() {
    for_live(RowKind::vertex, rows_.vertices(), [&](const auto& r) {
      optional_end(Link::first_end, 0, r.first_end);
      if (r.owner == none) return;
      if (ComplexRows::is_tagged(r.owner)) {
        to(Link::owner, 0, RowKind::shell, r.owner & ~ComplexRows::tag);
      } else {
        to(Link::owner, 0, RowKind::point_use, r.owner);
      }
    });
    for_live(RowKind::edge, rows_.edges(), [&](const auto& r) {
      for (int end = 0; end < 2; ++end) {
        to(Link::vertex, end, RowKind::vertex, r.vertex[end]);
        half_to(Link::next, end, RowKind::edge, r.next[end]);
        half_to(Link::prev, end, RowKind::edge, r.prev[end]);
      }
      if (r.first_use == none) return;
      if (ComplexRows::is_tagged(r.first_use)) {
        to(Link::first_use, 0, RowKind::wire, r.first_use & ~ComplexRows::tag);
      } else {
        to(Link::first_use, 0, RowKind::coedge, r.first_use);
      }
    });
    for_live(RowKind::wire, rows_.wires(), [&](const auto& r) {
      to(Link::edge, 0, RowKind::edge, r.edge);
      to(Link::shell, 0, RowKind::shell, r.shell);
      optional(Link::next, 0, RowKind::wire, r.next);
      to(Link::prev, 0, RowKind::wire, r.prev);
    });
    for_live(RowKind::coedge, rows_.coedges(), [&](const auto& r) {
      to(Link::next, 0, RowKind::coedge, r.next);
      to(Link::prev, 0, RowKind::coedge, r.prev);
      to(Link::radial, 0, RowKind::coedge, r.radial);
      half_to(Link::edge, 0, RowKind::edge, r.edge_sense);
      to(Link::loop, 0, RowKind::loop, r.loop);
    });
    for_live(RowKind::point_use, rows_.point_uses(), [&](const auto& r) {
      to(Link::loop, 0, RowKind::loop, r.loop);
      optional(Link::next, 0, RowKind::point_use, r.next);
    });
    for_live(RowKind::loop, rows_.loops(), [&](const auto& r) {
      optional(Link::next, 0, RowKind::loop, r.next);
      to(Link::prev, 0, RowKind::loop, r.prev);
      to(Link::face, 0, RowKind::face, r.face);
      if (r.first == none) return;
      if (ComplexRows::is_tagged(r.first)) {
        to(Link::first, 0, RowKind::vertex, r.first & ~ComplexRows::tag);
      } else {
        to(Link::first, 0, RowKind::coedge, r.first);
      }
    });
    for_live(RowKind::face, rows_.faces(), [&](const auto& r) {
      optional(Link::first_loop, 0, RowKind::loop, r.first_loop);
      for (int side = 0; side < 2; ++side) {
        to(Link::shell, side, RowKind::shell, r.shell[side]);
        if (r.next_in_shell[side] != none) half_to(Link::next_in_shell, side, RowKind::face, r.next_in_shell[side]);
        half_to(Link::prev_in_shell, side, RowKind::face, r.prev_in_shell[side]);
      }
    });
    for_live(RowKind::shell, rows_.shells(), [&](const auto& r) {
      to(Link::region, 0, RowKind::region, r.region);
      optional(Link::next, 0, RowKind::shell, r.next);
      to(Link::prev, 0, RowKind::shell, r.prev);
      if (r.first_face_use != none) half_to(Link::first_face_use, 0, RowKind::face, r.first_face_use);
      optional(Link::first_wire, 0, RowKind::wire, r.first_wire);
      optional(Link::vertex, 0, RowKind::vertex, r.vertex);
    });
    for_live(RowKind::region, rows_.regions(),
             [&](const auto& r) { optional(Link::first_shell, 0, RowKind::shell, r.first_shell); });
  }

 private:
  template <class Table, class Visit>
  void for_live(RowKind kind, const Table& table, Visit&& visit) {
    for (std::uint32_t i = 0; i < table.size(); ++i) {
      from_ = {kind, i};
      if (rows_.is_live(from_)) visit(table[i]);
    }
  }
  void to(Link link, int slot, RowKind kind, std::uint32_t index) {
    if (!rows_.is_live({kind, index})) findings_.push_back(DanglingLink{from_, link, slot, {kind, index}});
  }
  void optional(Link link, int slot, RowKind kind, std::uint32_t index) {
    if (index != none) to(link, slot, kind, index);
  }
  /// A link to one half of a row: an end of an edge, a side of a face, a sense.
  void half_to(Link link, int slot, RowKind kind, std::uint32_t code) {
    to(link, slot, kind, code == none ? none : code >> 1);
  }
  void optional_end(Link link, int slot, std::uint32_t code) {
    if (code != none) half_to(link, slot, RowKind::edge, code);
  }

  const ComplexRows& rows_;
  Findings& findings_;
  Row from_;
};

}  // namespace

void check_rows(const ComplexRows& rows, Findings& findings) {
  for (int kind = 0; kind <= static_cast<int>(RowKind::region); ++kind) {
    check_free_rows(rows, static_cast<RowKind>(kind), findings);
  }
  LinkCheck(rows, findings).run();
}

}  // namespace aresta::check_detail
