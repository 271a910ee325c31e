// SPDX-License-Identifier: Apache-2.0
// Which cell of space the entities of an incidence bound or lie in, as whoever knows the geometry has found it.
#pragma once

#include <cstdint>
#include <vector>

namespace aresta {

/// The cells that faces enclose. Cell 0 is infinite space.
struct Cells {
  std::uint32_t count = 1;
  std::vector<std::uint32_t> of_face_use;  ///< per face-use
  std::vector<std::uint32_t> of_edge;      ///< per edge: for wires, else Incidence::none
  std::vector<std::uint32_t> of_vertex;    ///< per vertex: for isolated vertices of no face, else Incidence::none
};

}  // namespace aresta
