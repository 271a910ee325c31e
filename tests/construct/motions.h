// SPDX-License-Identifier: Apache-2.0
// Reproducible random motions.
#pragma once

#include <random>

#include "math/transform.h"

namespace aresta {

class Motions {
 public:
  explicit Motions(unsigned seed) : random_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1.0p-53);
  }
  Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Transform rigid() {
    return Transform::translation(vector(20)) * Transform::rotation(number(-180, 180), vector(1), vector(5));
  }
  Transform mirrored() { return rigid() * Transform::reflection(vector(5), vector(1)); }

 private:
  std::mt19937_64 random_;
};

}  // namespace aresta
