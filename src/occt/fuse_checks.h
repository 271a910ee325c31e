// SPDX-License-Identifier: Apache-2.0
// What must hold of a general fuse's result before anyone may use it. Include only where OCCT may be seen.
#pragma once

#include "base/result.h"
#include "occt/shape_reader.h"

namespace aresta {

/// No two vertices closer than `tolerance`, no two edges between the same vertices along each other, no two faces with
/// the same edges on each other. Error: general_fuse_failed, with a place.
Status require_distinct(const ShapeMaps& maps, double tolerance);

}  // namespace aresta
