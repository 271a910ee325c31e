// SPDX-License-Identifier: Apache-2.0
// Identity first: vertices, then edges, then faces of different operands that coincide as wholes become one.
//
// Contract. Two vertices are one when they are nearer than the tolerance (the one asked for, what the operands carry,
// or their own, whichever is largest); two edges when their ends are one and each lies along the other; two faces when
// they have the same edges and their surfaces agree inside. The first of the operands that has an entity gives its
// geometry, and its tolerance grows by how far the others are from it. Nothing is cut: entities that coincide in part,
// cross or touch stay as they are, for an engine to imprint. Entities of one operand never become one; a cluster that
// would make them so is left alone, for the engine to say what it thinks of it. A cluster that hangs together link by
// link but is wider than its tolerance is an error (cluster_too_wide) that names its members: which of them are the
// same cannot be told.
// Not guaranteed: free-form faces that bulge apart between the points looked at (64 or more) count as one; what a
// fragment is made of passes the conservation of areas and volumes afterwards.
// Deterministic: union-find, smallest index as root. Cost: n log n plus the comparisons of candidates with equal
// boundaries.
#pragma once

#include <array>

#include "fragment/engine.h"

namespace aresta {

struct Identity {
  Imprint imprint;
  /// Per face of the imprint and parent: is the parent's normal opposite to the face's?
  std::vector<std::vector<bool>> opposite;
  std::array<std::size_t, 3> united{};  ///< how many vertices, edges, faces were found to be another one

  bool found_any() const { return united[0] + united[1] + united[2] > 0; }
};

/// Errors: cluster_too_wide, cancelled.
Result<Identity> unite_coincident(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                                  const Context& context);

/// Identity alone: an imprint of operands that meet only in entities that they have as wholes. Who asks for it looks
/// afterwards whether that was so (the checker, or counts that are known).
const FragmentEngine& identity_engine();

}  // namespace aresta
