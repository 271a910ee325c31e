// SPDX-License-Identifier: Apache-2.0
// Fragment: everything imprinted on everything, all cells of space found and labelled with the operands that contain
// them.
//
// Contract. The result's entities meet only in shared entities of lower dimension. For every operand and every cell of
// the result it is known in which region of that operand the cell lies; the labels follow from which side of which face
// a cell is on, by propagation over the cells, and must agree everywhere (label_conflict names the face where they do
// not). As a check that shares nothing with the engine, the area of every operand's face must equal that of its pieces
// and the volume of every operand's region that of its cells (not_conserved): a fragment that lost or doubled something
// is never returned. Cost above the engine's: O(faces x operands).
//
// One operand is its own fragment, unless the full checker finds that its parts meet without sharing what they meet in:
// then each region, and what belongs to none, is a part for itself, and the parts are imprinted on each other. Where
// regions overlap the cell has both for parents; region_of can tell but one of them, the first.
//
// Regions of the result: a cell is filled when it lies in a region of some operand, or when it is enclosed with the
// help of a face that bounds no operand's region (sheets that close a volume make a region; the void of a hollow body
// stays empty, also with sheets hanging in it that separate nothing).
#pragma once

#include <array>

#include "fragment/engine.h"
#include "fragment/errors.h"
#include "model/inherit.h"

namespace aresta {

struct FragmentOptions {
  double tolerance = 0;                    ///< absolute; 0: what the operands carry
  const FragmentEngine* engine = nullptr;  ///< null: the default one
  bool detect_regions = true;              ///< fill cells that sheets enclose
};

struct Fragment {
  std::vector<std::shared_ptr<const Model>> operands;
  std::shared_ptr<const Model> model;  ///< with provenance; source i is operand i
  /// region_of[o][c]: the region of operand o (possibly infinite or empty) in which cell c of the model lies.
  std::vector<std::vector<RegionId>> region_of;
  /// same_sense[f] tells, for each parent of face f that is a face, whether both normals agree.
  std::vector<std::vector<bool>> same_sense;

  std::vector<LabelConflict> conflicts;  ///< labels on which an entity's parents disagree

  /// Pieces of an operand's vertex, edge or face in the model, sorted.
  std::span<const std::uint32_t> pieces(std::uint32_t operand, EntityRef entity) const;
  std::span<const Parent> parents(EntityRef entity) const { return model->provenance->of(entity); }

  std::vector<std::array<std::vector<std::vector<std::uint32_t>>, 3>> piece_table;  ///< [operand][dimension][entity]
};

Result<Fragment> fragment(std::vector<std::shared_ptr<const Model>> operands, const FragmentOptions& options,
                          const Context& context);

}  // namespace aresta
