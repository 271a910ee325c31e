// SPDX-License-Identifier: Apache-2.0
// The image of a curve in a surface's parameters.
//
// Contract: for t in `range`, surface(image(t)) lies within `tolerance` of curve(t) at all places that were looked at
// (the ends, the knots and three places between each two knots); `deviation` is the largest distance found. A straight
// image at unit speed is preferred, as rims, seams and meridians of analytic surfaces have one; else it is a C1 cubic
// through points and derivatives of the exact image (Hermite), the spans that do not fit halved until all do, or there
// is none.
// `near` says roughly where the image lies: it chooses the period, and where the surface degenerates to a point (a
// pole, an apex) its value counts.
#pragma once

#include <functional>
#include <optional>

#include "geometry/curve.h"
#include "geometry/curve2.h"
#include "geometry/surface.h"

namespace aresta {

struct CurveImage {
  Curve2 image;
  double deviation = 0;
};

std::optional<CurveImage> image_on(const Surface& surface, const Curve& curve, Range range,
                                   const std::function<Vec2(double)>& near, double tolerance);

}  // namespace aresta
