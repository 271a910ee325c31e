// SPDX-License-Identifier: Apache-2.0
// Compaction: the rows of a complex renumbered without gaps.
//
// Guarantees: ids of a kind keep their order, so that the dump is the one from before with ids replaced and nothing
// moved; a compact complex stays as it is, sharing all its pages. The infinite region stays 0. Linear in the rows.
// Not kept: operators applied before cannot be taken back afterwards (their ids are the old ones); go back to a copy
// instead.
#pragma once

#include <vector>

#include "topology/complex.h"

namespace aresta {

/// For each kind the new id of each old one; invalid for gaps.
struct Compaction {
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
  std::vector<CoedgeId> coedges;
  std::vector<LoopId> loops;
  std::vector<FaceId> faces;
  std::vector<ShellId> shells;
  std::vector<RegionId> regions;

  /// The new name of an entity; index EntityRef{}.index when it is a gap or out of range.
  EntityRef operator()(EntityRef old) const;
};

Compaction compact(Complex& k);

}  // namespace aresta
