// SPDX-License-Identifier: Apache-2.0
// What a fragment engine does: imprint all operands on one another. Regions and labels are found above it, once for
// all.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/context.h"
#include "model/builder.h"

namespace aresta {

/// All vertices, edges and faces of the operands, split so that they meet only in shared entities of lower dimension,
/// each stored once. Loose and dangling edges and points inside a face are loops of that face. No fill.
struct Imprint {
  ModelBuilder builder;
  /// Per vertex, edge and face of the builder: the operands' entities it is a piece or an intersection of (sorted). An
  /// entity of the same dimension is its ancestor; those of higher dimension are what created it.
  std::vector<std::vector<Parent>> vertex_parents, edge_parents, face_parents;
  std::optional<Cells> cells;  ///< when the engine knows them; the builder then has the radial order
};

class FragmentEngine {
 public:
  virtual ~FragmentEngine() = default;
  virtual const char* name() const = 0;
  /// `tolerance` is absolute; 0 asks for the operands' own. Components of one operand are imprinted on each other, too.
  virtual Result<Imprint> imprint(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                                  const Context& context) const = 0;

  /// May an imprint have left pieces of several operands that still coincide or cross, which again() finds?
  virtual bool has_second_try() const { return false; }
  /// The imprint of what an imprint left. Error: imprint_failed by an engine that does all in one round.
  virtual Result<Imprint> again(const Imprint& imprint, std::size_t operands, double tolerance,
                                const Context& context) const;
};

/// What coincides as a whole made one (identity.h), the rest intersected by the general fuse of OCCT: any mix of
/// dimensions, plane or curved.
const FragmentEngine& occt_engine();

/// Straight edges and plane faces only: the exact engine of planar/, without a kernel.
const FragmentEngine& planar_engine();

}  // namespace aresta
