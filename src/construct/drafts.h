// SPDX-License-Identifier: Apache-2.0
// Faces on their way into a ModelBuilder: they can be turned over, moved and copied before they are added.
#pragma once

#include <optional>
#include <vector>

#include "model/builder.h"

namespace aresta {

struct CoedgeDraft {
  EdgeId edge;
  bool reversed = false;
  std::optional<Curve2> pcurve = {};
};

/// A cycle of coedges, or a single vertex.
struct LoopDraft {
  std::vector<CoedgeDraft> coedges;
  VertexId vertex = {};
};

struct FaceDraft {
  SurfaceId surface;
  bool reversed = false;
  bool constraint = false;
  double tolerance = 0;
  Fill front = Fill::unknown, back = Fill::unknown;
  std::vector<LoopDraft> loops;
};

/// The same piece of surface with its normal turned round.
void turn_over(FaceDraft& face);
FaceId add_face(ModelBuilder& builder, const FaceDraft& face);

/// Image of an edge in the parameter plane, straight: through `origin` at t = 0 with unit `direction`.
inline Curve2 straight_image(double u0, double v0, double du, double dv) {
  return Line2{{u0, v0}, {du, dv}};
}

/// The cells of a single solid whose faces all look outward: every front lies in infinite space, every back in cell 1.
Cells one_solid(std::size_t faces, std::size_t edges, std::size_t vertices);
/// All in infinite space; an edge is a wire (a vertex isolated) where `wire` (`isolated`) says so.
Cells no_solid(std::size_t faces, const std::vector<bool>& wire, const std::vector<bool>& isolated);

}  // namespace aresta
