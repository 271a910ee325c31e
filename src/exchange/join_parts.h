// SPDX-License-Identifier: Apache-2.0
// Parts of an imported model that touch or overlap without sharing anything are imprinted on each other.
//
// Many files hold an assembly as separate solids whose faces coincide, or wires that lie on a solid's edges. As a model
// for analysis they must share them. When the checker finds entities that meet without being shared, the fragment of
// the model (which imprints its regions, and what belongs to none, on each other) takes its place. Names, attributes
// and groups follow. Overlapping parts give one region for the overlap. The fragment's own conservation checks hold
// here too.
#pragma once

#include "exchange/exchange.h"

namespace aresta {

/// The model itself when nothing meets unshared; else the joined one, which the report notes. Errors: those of
/// fragment.
Result<Model> join_touching_parts(Model model, ImportReport& report, const Context& context);

}  // namespace aresta
