// SPDX-License-Identifier: Apache-2.0
// Edges and faces that a file stores in free form (B-splines, surfaces of revolution or extrusion, offsets), though
// they are lines, circles, ellipses, planes, cylinders, cones, spheres or tori, get their true form.
//
// A curve or surface changes when it is proven to lie within the tolerance of an analytic form over the whole edge or
// face (geometry/recognize.h), and when every edge of a changed face, and every curved face of a changed edge, finds
// its image again (geometry/image.h); else it stays as it is. Nothing moves by more than the tolerance, and faces keep
// their sides. A model that passed the fast check passes it afterwards, or stays as it was.
#pragma once

#include "exchange/exchange.h"

namespace aresta {

/// The model itself when there is nothing to recognise; else with the forms, which the report counts. Error: cancelled.
Result<Model> recognize_forms(Model model, ImportReport& report, const Context& context);

}  // namespace aresta
