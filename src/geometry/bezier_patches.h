// SPDX-License-Identifier: Apache-2.0
// A NURBS surface cut at its knots into Bezier patches: convex hulls that shrink quadratically under subdivision.
#pragma once

#include <vector>

#include "geometry/free_form.h"
#include "geometry/surface.h"
#include "math/box.h"

namespace aresta {

struct BezierPatch {
  Range2 domain;
  int degree_u = 0, degree_v = 0;
  /// Poles times weights, and weights, at [i * (degree_v + 1) + j].
  std::vector<Vec3> weighted;
  std::vector<double> weights;
  Box3 box;  ///< of the poles
};

/// The patches of a bounded free-form surface over its whole domain, or of its NURBS form over `piece` where it has
/// another form (then parameters are those of the NURBS form). Empty when there is no NURBS form.
std::vector<BezierPatch> bezier_patches(const FreeSurface& surface, const Range2& piece);

/// Where a line may meet a patch: see Surface::intersect. `evaluate` gives the surface's point and first derivatives at
/// the patch's parameters. Contract: transversal meetings are all found, each at most twice (on the seam of two
/// patches); touches are found when the line comes within `noise` (a length); a line inside the surface gives none.
/// Method: the patch seen along the line is a plane map; cells whose hull misses the origin are dropped, cells where
/// the preconditioned map is diagonally dominant hold at most one root, which Newton finds; the rest are split.
struct PatchHit {
  Vec2 uv;
  double t;
  bool touch;
};
void line_meets_patch(const BezierPatch& patch, const Surface& evaluate, const Line& line, double noise,
                      std::vector<PatchHit>& hits);

}  // namespace aresta
