// SPDX-License-Identifier: Apache-2.0
// Exact rational forms of pieces of the analytic curves and surfaces.
#pragma once

#include "geometry/curve.h"
#include "geometry/surface.h"

namespace aresta::analytic {

NurbsCurveData to_nurbs(const Curve& curve, Range range);
NurbsSurfaceData to_nurbs(const Surface& surface, const Range2& piece);

}  // namespace aresta::analytic
