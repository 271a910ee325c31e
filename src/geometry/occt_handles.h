// SPDX-License-Identifier: Apache-2.0
// The library's objects behind FreeCurve, FreeCurve2 and FreeSurface. Include only where OCCT may be seen.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include "geometry/curve.h"
#include "geometry/curve2.h"
#include "geometry/surface.h"

namespace aresta {

struct OcctCurve {
  Handle(Geom_Curve) curve;
};
struct OcctCurve2 {
  Handle(Geom2d_Curve) curve;
};
struct OcctSurface {
  Handle(Geom_Surface) surface;
};

/// Conversions keep the parametrisation. Trimmed curves and surfaces become their basis.
Curve from_occt(const Handle(Geom_Curve) & curve);
Curve2 from_occt(const Handle(Geom2d_Curve) & curve);
Surface from_occt(const Handle(Geom_Surface) & surface);
Handle(Geom_Curve) to_occt(const Curve& curve);
Handle(Geom2d_Curve) to_occt(const Curve2& curve);
Handle(Geom_Surface) to_occt(const Surface& surface);

}  // namespace aresta
