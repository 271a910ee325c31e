// SPDX-License-Identifier: Apache-2.0
// Problems of blocks: all cells of many blocks at once. A block is given by numbers from which every library makes its
// own operands, those with exact constructions without rounding.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace aresta::bench {

/// p -> middle + R p for p in [-half, half]; R is the turn by a quaternion of integers, so that it is rational.
struct Block {
  Vec3 middle, half;
  std::array<int, 4> turn{1, 0, 0, 0};

  bool is_turned() const { return turn[1] != 0 || turn[2] != 0 || turn[3] != 0; }
  /// R times its denominator, by rows, and the denominator.
  std::array<std::array<int, 3>, 3> numerators() const;
  int denominator() const;
  /// R, rounded.
  std::array<Vec3, 3> rows() const;
};

/// n^3 unit blocks, and a block [0.5, n + 0.5]^3 across them.
std::vector<Block> grid_of_blocks(int n);
std::uint64_t cells_of_grid(int n);
double volume_of_grid(int n);

/// In a cube of side 10, sizes from 1 to 4, the same for the same count.
std::vector<Block> random_blocks(int count, bool turned);

/// Of what lies in some block, by the parts of faces that no other block covers: shares nothing with any library. For
/// blocks of which no two faces coincide.
double volume_of_union(const std::vector<Block>& blocks);

}  // namespace aresta::bench
