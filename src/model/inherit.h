// SPDX-License-Identifier: Apache-2.0
// Labels follow provenance: what a piece is called and carries, it has from its parents.
//
// Rule: an entity of a result gets every attribute of its parents of the same dimension. Parents that disagree on a
// value are settled by the numeric attribute "priority" (the greatest wins, when it is unique); else the attribute is
// left out and the disagreement reported, never guessed. A group of a source becomes the group of all pieces of its
// members.
#pragma once

#include "model/extract.h"

namespace aresta {

struct LabelConflict {
  EntityRef entity;  ///< of the result
  std::string attribute;
  std::vector<Parent> parents;
};

/// Replaces model.labels by what follows from model.provenance (which must be set); returns the disagreements, sorted
/// by entity.
std::vector<LabelConflict> inherit_labels(Model& model);

/// Replaces the labels of an extracted model by those of what it was extracted from; a region has those of its first
/// cell that is a region.
void copy_labels(const Model& source, const ExtractionMap& from, Model& result);

}  // namespace aresta
