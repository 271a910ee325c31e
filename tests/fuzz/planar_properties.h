// SPDX-License-Identifier: Apache-2.0
// What the planar engine must hold whatever it is given: bytes are read as small soups and pairs of meshes.
#pragma once

#include <cstdint>
#include <span>

#include "fuzz/properties.h"

namespace aresta::test {

/// Boxes, polygons, wires and points of up to four operands on a small grid, some moved by next to nothing: an imprint
/// is refused with a reason, or the area of every face and the length of every edge are those of its pieces and the
/// cells are found or refused.
Verdict check_planar_groups(std::string_view bytes);

/// Two closed meshes of tetrahedra and boxes on a small grid, some moved by next to nothing: operations are refused
/// with a reason, or each is closed and their volumes fit each other.
Verdict check_planar_meshes(std::string_view bytes);

}  // namespace aresta::test
