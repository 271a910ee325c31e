// SPDX-License-Identifier: Apache-2.0
// What of an incidence hangs on no face: wires, in groups that lie in one cell as a whole, and isolated vertices.
#pragma once

#include "topology/assemble.h"

namespace aresta {

/// Per edge: for a wire the first wire of those that hang together without passing through a vertex of a face, so that
/// all of them lie in one cell; none for an edge of a face. Linear.
std::vector<std::uint32_t> wire_groups(const Incidence& incidence);

/// Vertices of no edge and no loop, rising.
std::vector<std::uint32_t> isolated_vertices(const Incidence& incidence);

}  // namespace aresta
