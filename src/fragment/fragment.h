// SPDX-License-Identifier: Apache-2.0
// Fragment: everything imprinted on everything, all cells of space found and labelled with the operands that contain
// them.
//
// Contract. The result's entities meet only in shared entities of lower dimension. For every operand and every cell of
// the result it is known in which region of that operand the cell lies; the labels follow from which side of which face
// a cell is on, by propagation over the cells, and must agree everywhere (label_conflict names the face where they do
// not). As a check that shares nothing with the engine, the area of every operand's face must equal that of its pieces
// and the volume of every operand's region that of its cells (not_conserved): a fragment that lost or doubled something
// is never returned. Cost above the engine's: linear in entities and labels.
//
// One operand is its own fragment, unless the full checker finds that its parts meet without sharing what they meet in:
// then each region, and what belongs to none, is a part for itself, and the parts are imprinted on each other. Where
// regions overlap the cell has both for parents; the labels can tell but one of them, the first.
//
// Regions of the result: a cell is filled when it lies in a region of some operand, or when it is enclosed with the
// help of a face that bounds no operand's region (sheets that close a volume make a region; the void of a hollow body
// stays empty, also with sheets hanging in it that separate nothing).
#pragma once

#include <array>

#include "base/lists.h"
#include "fragment/engine.h"
#include "fragment/errors.h"
#include "fragment/labels.h"
#include "model/inherit.h"

namespace aresta {

struct FragmentOptions {
  double tolerance = 0;                    ///< absolute; 0: what the operands carry
  const FragmentEngine* engine = nullptr;  ///< null: the default one
  bool detect_regions = true;              ///< fill cells that sheets enclose
};

/// Which pieces each operand's vertices, edges and faces have become.
class PieceTable {
 public:
  PieceTable() = default;
  /// `parents` of the pieces, by dimension.
  PieceTable(std::span<const std::shared_ptr<const Model>> operands,
             const std::array<const std::vector<std::vector<Parent>>*, 3>& parents);
  std::span<const std::uint32_t> of(std::uint32_t operand, EntityRef entity) const {
    const auto dimension = static_cast<std::size_t>(entity.kind);
    return pieces_[dimension][first_[operand][dimension] + entity.index];
  }

 private:
  std::vector<std::array<std::uint32_t, 3>> first_;  // per operand and dimension: the list of its entity 0
  std::array<Lists, 3> pieces_;
};

struct Fragment {
  std::vector<std::shared_ptr<const Model>> operands;
  std::shared_ptr<const Model> model;  ///< with provenance; source i is operand i
  CellLabels labels;                   ///< in which of the operands' regions each cell of the model lies
  /// same_sense[f] tells, for each parent of face f that is a face, whether both normals agree.
  std::vector<std::vector<bool>> same_sense;

  std::vector<LabelConflict> conflicts;  ///< labels on which an entity's parents disagree

  /// Pieces of an operand's vertex, edge or face in the model, sorted.
  std::span<const std::uint32_t> pieces(std::uint32_t operand, EntityRef entity) const {
    return piece_table.of(operand, entity);
  }
  std::span<const Parent> parents(EntityRef entity) const { return model->provenance->of(entity); }

  PieceTable piece_table;
};

Result<Fragment> fragment(std::vector<std::shared_ptr<const Model>> operands, const FragmentOptions& options,
                          const Context& context);

}  // namespace aresta
