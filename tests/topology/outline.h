// SPDX-License-Identifier: Apache-2.0
// A small complex in one line: regions with their shells, faces with their loops, edges with their ends, and the order
// of uses about edges with three or more of them.
//
//   r0: +f0 -f0 e3, v5; f0: +e0 -e1 +e2, v3; e0: v0 v1; e1: v2 v1; e2: v2 v0; e3: v0 v4
//   e0: v0 v1, +f0 -f1 +f2                      counterclockwise about the edge, from the smallest coedge on
#pragma once

#include <string>

#include "topology/complex.h"

namespace aresta {

std::string outline(const Complex& k);

}  // namespace aresta
