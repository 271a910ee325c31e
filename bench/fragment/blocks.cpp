// SPDX-License-Identifier: Apache-2.0
#include "fragment/blocks.h"

#include <random>

namespace aresta::bench {

std::array<std::array<int, 3>, 3> Block::numerators() const {
  const auto [w, x, y, z] = turn;
  return {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

int Block::denominator() const {
  int sum = 0;
  for (const int q : turn) sum += q * q;
  return sum;
}

std::array<Vec3, 3> Block::rows() const {
  std::array<Vec3, 3> rows;
  const auto n = numerators();
  for (std::size_t i = 0; i < 3; ++i) rows[i] = Vec3{1. * n[i][0], 1. * n[i][1], 1. * n[i][2]} / (1. * denominator());
  return rows;
}

std::vector<Block> grid_of_blocks(int n) {
  std::vector<Block> blocks;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) blocks.push_back({{i + 0.5, j + 0.5, k + 0.5}, {0.5, 0.5, 0.5}});
    }
  }
  const double middle = 0.5 * n + 0.5, half = 0.5 * n;
  blocks.push_back({{middle, middle, middle}, {half, half, half}});
  return blocks;
}

// The unit blocks at the three low sides are cut in two, and the part of the large block outside the grid is one cell.
std::uint64_t cells_of_grid(int n) {
  const auto cube = [](int m) { return std::uint64_t(m) * m * m; };
  return 2 * cube(n) - cube(n - 1) + 1;
}

double volume_of_grid(int n) {
  const double inner = n - 0.5;
  return 2. * n * n * n - inner * inner * inner;
}

std::vector<Block> random_blocks(int count, bool turned) {
  std::mt19937_64 generator(20240229);
  // Not a distribution of the standard library, whose numbers differ between libraries.
  const auto between = [&](double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(generator() >> 11);
  };
  std::vector<Block> blocks;
  for (int i = 0; i < count; ++i) {
    Block block;
    for (double* x : {&block.half.x, &block.half.y, &block.half.z}) *x = between(0.5, 2);
    for (double* x : {&block.middle.x, &block.middle.y, &block.middle.z}) *x = between(0, 10);
    for (int& q : block.turn) q = static_cast<int>(between(-16, 16));
    if (!turned || block.denominator() == 0) block.turn = {1, 0, 0, 0};
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace aresta::bench
