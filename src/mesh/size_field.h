// SPDX-License-Identifier: Apache-2.0
// The wished element size at every point of a box: an octree whose leaves hold a size, graded between them.
#pragma once

#include <cstdint>
#include <vector>

#include "math/box.h"

namespace aresta::mesh {

/// Sizes only ever shrink. Where nothing was asked for, the largest size holds. Between places the size grows at most
/// by `grading` per unit of distance (approximately: the field is constant within a leaf no larger than its size).
class SizeField {
 public:
  /// All of the box is covered; `least` <= `largest`, both positive.
  SizeField(const Box3& box, double largest, double least, double grading);

  /// Elements near p shall be no larger than `size` (nor smaller than `least`), their surroundings graded.
  void restrict(Vec3 p, double size);
  double at(Vec3 p) const;
  double largest() const { return largest_; }
  double least() const { return least_; }

 private:
  struct Cell {
    double size;
    std::uint32_t first_child;  ///< 0: a leaf; the root is nobody's child
  };

  Box3 cube_;
  double largest_, least_, grading_;
  std::vector<Cell> cells_;
};

}  // namespace aresta::mesh
