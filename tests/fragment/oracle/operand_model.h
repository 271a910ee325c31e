// SPDX-License-Identifier: Apache-2.0
// An operand on the lattice as a model: entity i of the one is entity i of the other, regions included.
//
// Nothing of the modeler's own search is used: loops, radial order, cells and fills are read off the lattice. Senses of
// edges and faces vary, so that nothing depends on them. Coordinates are steps, turned and scaled: exact integers.
#pragma once

#include "fragment/oracle/recipe.h"
#include "model/builder.h"

namespace aresta::grid {

/// Points of the lattice in space and back.
class Placement {
 public:
  explicit Placement(const Turn& turn) : matrix_(turn.matrix()), scale_(turn.scale()) {}

  int scale() const { return scale_; }
  Vec3 point(const Steps& p) const;
  Vec3 direction(int axis) const;  ///< of length 1
  /// The lattice point that a point is, to 1e-6 of a step; none when it is no lattice point.
  std::optional<Steps> steps(Vec3 p) const;

 private:
  std::array<std::array<int, 3>, 3> matrix_;
  int scale_;
};

/// Does an entity of an operand run against the positive direction of its axis? Any fixed pattern without structure.
inline bool runs_down(EntityRef entity) {
  return ((entity.index * 2654435761u + static_cast<std::uint32_t>(entity.kind)) >> 15 & 1u) != 0;
}

/// The uses of an edge by faces, counterclockwise about its axis; `up` as in the face's loop seen against its axis.
struct RadialUse {
  FaceId face;
  bool up = true;
  bool operator==(const RadialUse&) const = default;
};
std::vector<RadialUse> radial_uses(const GridComplex& complex, EdgeId e);

Result<Model> to_model(const GridOperand& operand, const Turn& turn);

}  // namespace aresta::grid
