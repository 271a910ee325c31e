// SPDX-License-Identifier: Apache-2.0
// Which regions of which operands a cell lies in.
//
// Contract. From the infinite cell outwards each cell has the labels of its neighbour across a face, changed by what
// the face is a piece of; then every face is asked whether both its sides agree with that. Labels that do not agree are
// label_conflict, which names the face and the operand. Only regions other than an operand's infinite one are stored:
// cost and memory are what the answer holds, whatever the number of operands. Bieri and Nef 1988 (labels by
// propagation).
#pragma once

#include "model/model.h"

namespace aresta {

class CellLabels {
 public:
  CellLabels() = default;
  /// Per cell, what it lies in: sorted by operand, each operand once.
  explicit CellLabels(std::vector<std::vector<Parent>> labels);

  /// The operands' regions, filled or not, that contain the cell; those in whose infinite region it lies are not there.
  std::span<const Parent> of(RegionId cell) const {
    return {items_.data() + begin_[cell.index()], begin_[cell.index() + 1] - begin_[cell.index()]};
  }
  /// The region of one operand in which the cell lies: the infinite one where it is in no other.
  RegionId region_of(std::uint32_t operand, RegionId cell) const;
  /// The cells in a region of an operand that is not its infinite one, sorted.
  std::span<const RegionId> cells_in(Parent region) const;

 private:
  std::vector<std::uint32_t> begin_{0};
  std::vector<Parent> items_;
  std::vector<Parent> regions_;  // sorted, each that has cells
  std::vector<std::uint32_t> region_begin_{0};
  std::vector<RegionId> cells_;
};

/// `face_cells` per face-use of the imprint; per face its parents and, for those that are faces, whether the normals
/// agree. Errors: label_conflict.
Result<CellLabels> label_cells(std::span<const std::shared_ptr<const Model>> operands, std::uint32_t cell_count,
                               std::span<const std::uint32_t> face_cells,
                               const std::vector<std::vector<Parent>>& face_parents,
                               const std::vector<std::vector<bool>>& same_sense);

}  // namespace aresta
