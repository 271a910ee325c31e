// SPDX-License-Identifier: Apache-2.0
// Do triangles meet where they should not?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/vec.h"

namespace aresta::mesh {

/// A point where two triangles meet elsewhere than in shared corners and sides (nearly folded onto each other counts),
/// or nothing. `tolerance`: distances below it are contact.
std::optional<Vec3> triangles_meet(const std::vector<Vec3>& points, const std::array<std::uint32_t, 3>& s,
                                   const std::array<std::uint32_t, 3>& t, double tolerance);

struct Crossing {
  Vec3 place;
  std::uint32_t first = 0, second = 0;  ///< the two triangles
};

/// Such meetings among all triangles, at most `most`. Cost n log n for meshes of bounded overlap.
std::vector<Crossing> find_crossings(const std::vector<Vec3>& points,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t most);

}  // namespace aresta::mesh
