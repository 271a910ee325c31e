// SPDX-License-Identifier: Apache-2.0
// What is connected with what: sides of faces through sectors, items of a region through vertices.
#pragma once

#include <vector>

#include "topology/item.h"

namespace aresta {

/// Some shell at the vertex in the region; invalid when the vertex does not touch the region.
ShellId shell_at(const Complex& k, VertexId v, RegionId r);

/// All sides connected with u through sectors, sorted: the closed surface that u is part of.
std::vector<FaceUse> side_component(const Complex& k, FaceUse u);

/// Are the two sides connected through sectors? Searches from both in turn, so that it costs the smaller of the two
/// surfaces when they are not. Then `part`, if given, gets the one of `a`, or of `b` when `of_b`.
bool sides_connected(const Complex& k, FaceUse a, FaceUse b, bool of_b = false, std::vector<FaceUse>* part = nullptr);

}  // namespace aresta
