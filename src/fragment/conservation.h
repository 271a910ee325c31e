// SPDX-License-Identifier: Apache-2.0
// A check of fragments that shares nothing with the engines: nothing was lost, nothing is there twice.
#pragma once

#include "fragment/fragment.h"

namespace aresta {

/// The area of every operand's face is that of its pieces, the volume of every operand's region that of its cells, to
/// 1e-6 of it and ten tolerances around its boundary. Errors: not_conserved, cancelled.
Status check_conservation(const Fragment& result, const Context& context);

}  // namespace aresta
