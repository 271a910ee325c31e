// SPDX-License-Identifier: Apache-2.0
// Between our plain NURBS data and the library's objects. Include only in sources.
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include "geometry/free_form.h"

namespace aresta {

NurbsCurveData data_of(const Handle(Geom_BSplineCurve) & curve);
NurbsSurfaceData data_of(const Handle(Geom_BSplineSurface) & surface);

}  // namespace aresta
