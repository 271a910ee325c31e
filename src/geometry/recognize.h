// SPDX-License-Identifier: Apache-2.0
// Recognition of analytic forms in free-form curves and surfaces.
//
// Contract: an answer is given only when every point of the piece, not only those sampled, lies within `tolerance` of
// the form; `deviation` is a proven bound of the largest distance. The converse is not promised: a piece that lies
// within the tolerance by a hair, or that no least-squares fit finds, may stay free-form. The bound comes from the
// NURBS form of the piece: put into the form's implicit equation it is a polynomial on each span of knots, and a
// polynomial of degree d is nowhere larger than 1 / cos(pi d / 2 N) times its largest value at N + 1 Chebyshev points
// (Ehlich, Zeller 1964); for lines and planes the convex hull of the poles is exact. An offset surface is recognised
// when its basis is analytic.
//
// Parameters change: parameter-space images must be computed anew unless `same_parameters`.
#pragma once

#include <optional>

#include "geometry/curve.h"
#include "geometry/surface.h"

namespace aresta {

struct RecognizedCurve {
  Curve curve;                   ///< line, circle or ellipse; runs in the direction of the piece
  Range range;                   ///< the piece on it; a circle's starts at 0
  double deviation = 0;          ///< bound of the largest distance of the piece from it
  bool same_parameters = false;  ///< equal parameters give equal points within the tolerance
};

struct RecognizedSurface {
  /// Plane, cylinder, cone, sphere or torus in a right-handed frame. u = 0 lies where the piece begins and poles lie
  /// where its degenerate sides are, so that a face bounded by the piece's sides has its seams and poles in the same
  /// places.
  Surface surface;
  double deviation = 0;          ///< bound of the largest distance of the piece from it
  bool same_parameters = false;  ///< equal parameters give equal points within the tolerance
  bool same_normal = true;       ///< natural normals agree; else a face must be turned over
};

/// Nothing when no form is within `tolerance` (a length > 0) over the piece, which must be finite. An analytic form is
/// recognised as itself.
std::optional<RecognizedCurve> recognize_piece(const Curve& curve, Range range, double tolerance);
std::optional<RecognizedSurface> recognize_piece(const Surface& surface, const Range2& piece, double tolerance);

/// The form alone.
std::optional<Curve> recognize(const Curve& curve, Range range, double tolerance);
std::optional<Surface> recognize(const Surface& surface, const Range2& piece, double tolerance);

}  // namespace aresta
