// SPDX-License-Identifier: Apache-2.0
// Ordering the faces around each edge from geometry.
//
// At a point of the edge every coedge has a direction m into its face, at right angles to the edge. Coedges are sorted
// by the angle of m about the edge; faces that leave the edge tangentially (within 1e-4 rad) are told apart by their
// height above the common tangent plane a small step away (second fundamental form), then by a larger finite step on
// the surfaces themselves. When that fails at several points of the edge the order is an error, never a guess. Cost:
// O(k log k) per edge of k uses; edges of one or two uses cost nothing.
#pragma once

#include "model/model.h"
#include "topology/assemble.h"

namespace aresta {

/// Fills incidence.radial_next. `model` has the same loops; its regions and radial order are not looked at.
Status order_radially(const Model& model, Incidence& incidence);

}  // namespace aresta
