// SPDX-License-Identifier: Apache-2.0
#include "fragment/labels.h"

#include <algorithm>

#include "base/lists.h"
#include "fragment/errors.h"

namespace aresta {

namespace {

class Labelling {
 public:
  Labelling(std::span<const std::shared_ptr<const Model>> operands, std::uint32_t cell_count,
            std::span<const std::uint32_t> face_cells, const std::vector<std::vector<Parent>>& face_parents,
            const std::vector<std::vector<bool>>& same_sense)
      : operands_(operands),
        face_cells_(face_cells),
        face_parents_(face_parents),
        same_sense_(same_sense),
        labels_(cell_count),
        known_(cell_count, false) {}

  Result<CellLabels> run() {
    std::vector<IndexPair> pairs;
    pairs.reserve(face_cells_.size());
    for (std::uint32_t u = 0; u < face_cells_.size(); ++u) pairs.emplace_back(face_cells_[u], u);
    const Lists uses = group(labels_.size(), pairs);
    known_[0] = true;
    std::vector<std::uint32_t> pending{0};
    for (std::size_t i = 0; i < pending.size(); ++i) {
      for (const std::uint32_t use : uses[pending[i]]) {
        const std::uint32_t there = face_cells_[use ^ 1u];
        if (known_[there]) continue;
        known_[there] = true;
        ARESTA_TRY(labels_[there], across(use));
        pending.push_back(there);
      }
    }
    for (std::uint32_t c = 0; c < labels_.size(); ++c) {
      if (!known_[c]) return Error{errors::label_conflict, "a cell has no face that leads out of it", {RegionId(c)}};
    }
    for (std::uint32_t f = 0; f < face_parents_.size(); ++f) {
      for (std::uint32_t u = 2 * f; u < 2 * f + 2; ++u) {
        ARESTA_TRY(const std::vector<Parent> expected, across(u));
        if (expected != labels_[face_cells_[u ^ 1u]]) return conflict(f, expected, labels_[face_cells_[u ^ 1u]]);
      }
    }
    return CellLabels(std::move(labels_));
  }

 private:
  /// The labels behind the face that bounds the cell of `use`.
  Result<std::vector<Parent>> across(std::uint32_t use) const {
    std::vector<Parent> labels = labels_[face_cells_[use]];
    const std::uint32_t f = use / 2;
    const int here = static_cast<int>(use % 2);
    std::size_t i = 0;
    for (auto p = face_parents_[f].begin(); p != face_parents_[f].end(); ++p) {
      if (p->entity.kind != EntityKind::face) continue;
      const int side = same_sense_[f][i++] ? here : 1 - here;
      const Complex& k = operands_[p->source]->topology();
      const FaceId g{p->entity.index};
      const RegionId before = k.region(FaceUse(g, side)), after = k.region(FaceUse(g, 1 - side));
      const auto at = std::lower_bound(labels.begin(), labels.end(), Parent{p->source, VertexId(0)});
      const bool present = at != labels.end() && at->source == p->source;
      const RegionId known = present ? RegionId(at->entity.index) : Complex::infinite_region();
      // Two faces of one operand may be one piece, each with its own sides; they must say the same.
      const bool again = std::any_of(face_parents_[f].begin(), p, [&](const Parent& q) {
        return q.source == p->source && q.entity.kind == EntityKind::face;
      });
      if (known != (again ? after : before)) return conflict(f, p->source, known, before);
      if (again) continue;
      if (after == Complex::infinite_region()) {
        if (present) labels.erase(at);
      } else if (present) {
        at->entity = after;
      } else {
        labels.insert(at, {p->source, after});
      }
    }
    return labels;
  }

  Error conflict(std::uint32_t f, std::uint32_t operand, RegionId one, RegionId other) const {
    return Error{errors::label_conflict,
                 "the pieces of operand " + std::to_string(operand + 1) +
                     " do not close: one cell lies in its regions " + std::to_string(one.value) + " and " +
                     std::to_string(other.value),
                 {FaceId(f)}};
  }

  Error conflict(std::uint32_t f, const std::vector<Parent>& one, const std::vector<Parent>& other) const {
    const auto at = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
    const bool first = at.second == other.end() || (at.first != one.end() && *at.first < *at.second);
    const std::uint32_t operand = first ? at.first->source : at.second->source;
    const auto of = [&](const std::vector<Parent>& labels) {
      for (const Parent& p : labels) {
        if (p.source == operand) return RegionId(p.entity.index);
      }
      return Complex::infinite_region();
    };
    return conflict(f, operand, of(one), of(other));
  }

  std::span<const std::shared_ptr<const Model>> operands_;
  std::span<const std::uint32_t> face_cells_;
  const std::vector<std::vector<Parent>>& face_parents_;
  const std::vector<std::vector<bool>>& same_sense_;
  std::vector<std::vector<Parent>> labels_;
  std::vector<bool> known_;
};

}  // namespace

CellLabels::CellLabels(std::vector<std::vector<Parent>> labels) {
  begin_.reserve(labels.size() + 1);
  std::vector<std::pair<Parent, RegionId>> by_region;
  for (std::size_t c = 0; c < labels.size(); ++c) {
    for (const Parent& p : labels[c]) {
      items_.push_back(p);
      by_region.emplace_back(p, RegionId(c));
    }
    begin_.push_back(static_cast<std::uint32_t>(items_.size()));
  }
  std::sort(by_region.begin(), by_region.end());
  for (const auto& [region, cell] : by_region) {
    if (regions_.empty() || regions_.back() != region) {
      regions_.push_back(region);
      region_begin_.push_back(static_cast<std::uint32_t>(cells_.size()));
    }
    cells_.push_back(cell);
    region_begin_.back() = static_cast<std::uint32_t>(cells_.size());
  }
}

RegionId CellLabels::region_of(std::uint32_t operand, RegionId cell) const {
  for (const Parent& p : of(cell)) {
    if (p.source == operand) return RegionId(p.entity.index);
  }
  return Complex::infinite_region();
}

std::span<const RegionId> CellLabels::cells_in(Parent region) const {
  const auto at = std::lower_bound(regions_.begin(), regions_.end(), region);
  if (at == regions_.end() || *at != region) return {};
  const auto i = static_cast<std::size_t>(at - regions_.begin());
  return {cells_.data() + region_begin_[i], region_begin_[i + 1] - region_begin_[i]};
}

Result<CellLabels> label_cells(std::span<const std::shared_ptr<const Model>> operands, std::uint32_t cell_count,
                               std::span<const std::uint32_t> face_cells,
                               const std::vector<std::vector<Parent>>& face_parents,
                               const std::vector<std::vector<bool>>& same_sense) {
  return Labelling(operands, cell_count, face_cells, face_parents, same_sense).run();
}

}  // namespace aresta
