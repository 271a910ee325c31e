// SPDX-License-Identifier: Apache-2.0
// Interpolation by cubic splines.
#pragma once

#include <span>

#include "geometry/free_form.h"

namespace aresta {

/// The C2 cubic B-spline through the points at parameters that grow by chord length, from 0. Two or more points, each
/// apart from the next; a closed one (three or more, the first not repeated) returns to the first point. Ends: the
/// derivative there is that of the parabola (with three points; cubic with four or more) through the nearest points,
/// so that a parabola given at any parameters proportional to its own is reproduced. De Boor, "A practical guide to
/// splines", ch. IV; poles by blossoming.
NurbsCurveData interpolating_spline(std::span<const Vec3> points, bool closed);

}  // namespace aresta
