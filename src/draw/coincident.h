// SPDX-License-Identifier: Apache-2.0
// Internal to draw: pieces of lines that coincide in the picture are kept once.
#pragma once

#include "draw/hidden_lines.h"

namespace aresta::draw {

/// Cuts from each piece what a piece before it covers: visible ones before hidden ones, edges before silhouettes, near
/// before far.
void keep_coincident_once(HiddenLines& result, const Projector& projector);

}  // namespace aresta::draw
