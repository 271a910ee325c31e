// SPDX-License-Identifier: Apache-2.0
// Faces that go the whole way round an axis begin where their surface's parameter u is 0.
//
// The kernel library takes two faces on one cylinder for different when one of them covers another turn of u than
// [0, 2 pi], so that coincident sides stay unmerged. Files write such faces (a seam opposite to the surface's x axis);
// turning the surface's frame about its axis, and shifting the images, makes them what the library expects. No point
// moves. Linear in the model's size.
#pragma once

#include "model/copy.h"

namespace aresta {

/// The changes that do so for cylinders, cones, spheres and tori; none for faces that begin at 0 or are no full turn.
GeometryChanges seat_seams(const Model& model);

}  // namespace aresta
