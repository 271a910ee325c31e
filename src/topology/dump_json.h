// SPDX-License-Identifier: Apache-2.0
// The dump of a complex (dump.h) as JSON: the same content in the same order.
//
//   {"format": "aresta complex", "version": 1,
//    "regions":  [{"id": 0, "kind": "infinite" | "filled" | "empty",
//                  "shells": [{"front": [FACE...], "back": [FACE...], "wires": [EDGE...]} | {"vertex":
//                  VERTEX}...]}...],
//    "faces":    [{"id": 0, "front": REGION, "back": REGION,
//                  "loops": [{"id": 0, "coedges": [{"id": 0, "edge": EDGE, "reversed": false, "start": VERTEX,
//                                                   "end": VERTEX, "radial": COEDGE}...]}
//                            | {"id": 0, "vertex": VERTEX}...]}...],
//    "edges":    [{"id": 0, "start": VERTEX, "end": VERTEX, "coedges": [COEDGE...]}
//                 | {"id": 0, "start": VERTEX, "end": VERTEX, "wire_in": REGION}...],
//    "vertices": [{"id": 0, "starting": [EDGE...], "ending": [EDGE...], "loops": [LOOP...]}
//                 | {"id": 0, "isolated_in": REGION}...]}
//
// Lines: one for each region, face, edge and vertex.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "topology/complex.h"
#include "topology/parse_dump.h"

namespace aresta {

std::string dump_json(const Complex& k);

/// The inverse: what is read gives the same JSON again, the order of members and blanks apart. Any bytes may come;
/// errors say the line or the path. Errors: those of parse_dump.
Result<Complex> parse_json(std::string_view text);

}  // namespace aresta
