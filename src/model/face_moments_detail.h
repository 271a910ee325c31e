// SPDX-License-Identifier: Apache-2.0
// Moments of one face: of its area, or of the cones from a reference point to it.
//
// Plane faces: the fan of triangles from a point of each loop to its edges; closed form for straight edges, quadrature
// along curved ones. The volumes are those of the fans' tetrahedra, so that a closed set of faces sums up to the same
// volume whatever the reference and however far from their planes the vertices are within tolerance.
//
// Curved faces: Green's theorem in the parameter plane. With the strip G(u, v) = integral of the density from v0 to v,
// which has the period of the surface in u, the face is minus the integral of G du around its loops (lifted to the
// covering plane, gaps closed by straight segments), when its loops go counterclockwise. What is special:
//   winding in u    where the loops' windings do not sum to zero the face reaches a line v = const that is one point
//                   (pole, apex): that line, run through against the sum, closes the boundary.
//   closed surface  (sphere, torus) the boundary determines the face up to whole surfaces: the area decides how many to
//                   add, as it lies between zero and all. Without any boundary the face is the whole surface.
//   winding in v    on a torus: G is no function there, so loops that wind in v are joined by straight bridges into one
//                   closed path; which bridges does not matter, again up to whole surfaces.
#pragma once

#include "model/measure.h"

namespace aresta::model_detail {

/// Area moments when `reference` is null, else flux towards it.
Result<Moments> face_moments(const Model& model, FaceId face, const Vec3* reference, const MeasureOptions& options);

}  // namespace aresta::model_detail
