// SPDX-License-Identifier: Apache-2.0
// Edges that a file stores as B-splines, though they are lines, circles or ellipses, get their true form.
//
// An edge changes when its curve is proven to lie within the tolerance of an analytic form over its whole range, and
// when its image in every curved face that it bounds is found again (a straight line in the parameters, as for the
// rims, seams and meridians of cylinders, cones, spheres and tori); else it stays as it is. Nothing moves by more than
// the tolerance.
#pragma once

#include "exchange/exchange.h"

namespace aresta {

/// The model itself when there is nothing to recognise; else with the forms, which the report counts.
Result<Model> recognize_forms(Model model, ImportReport& report);

}  // namespace aresta
