// SPDX-License-Identifier: Apache-2.0
#include "math/transform.h"

#include <numbers>

namespace aresta {

namespace {

constexpr double orthogonality_tolerance = 1e-12;

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
std::array<double, 2> cos_sin_degrees(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  if (turn == 0) return {1, 0};
  if (turn == 90 || turn == -270) return {0, 1};
  if (turn == 180 || turn == -180) return {-1, 0};
  if (turn == 270 || turn == -90) return {0, -1};
  const double radians = turn * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

}  // namespace

Transform Transform::translation(Vec3 d) {
  Transform t;
  t.offset = d;
  return t;
}

Transform Transform::rotation(double degrees, Vec3 axis, Vec3 about) {
  const Vec3 n = normalized(axis);
  const auto [c, s] = cos_sin_degrees(degrees);
  Transform t;
  t.rows[0] = Vec3{c, -s * n.z, s * n.y} + (1 - c) * n.x * n;
  t.rows[1] = Vec3{s * n.z, c, -s * n.x} + (1 - c) * n.y * n;
  t.rows[2] = Vec3{-s * n.y, s * n.x, c} + (1 - c) * n.z * n;
  t.offset = about - t.vector(about);
  return t;
}

Transform Transform::scaling(double factor, Vec3 about) {
  Transform t;
  t.rows = {{{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}}};
  t.offset = (1 - factor) * about;
  return t;
}

Transform Transform::reflection(Vec3 point, Vec3 normal) {
  const Vec3 n = normalized(normal);
  Transform t;
  t.rows[0] -= 2 * n.x * n;
  t.rows[1] -= 2 * n.y * n;
  t.rows[2] -= 2 * n.z * n;
  t.offset = 2 * dot(point, n) * n;
  return t;
}

Transform Transform::from_rows(const std::array<double, 12>& m) {
  Transform t;
  t.rows = {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
  t.offset = {m[3], m[7], m[11]};
  return t;
}

bool Transform::is_similarity(double* factor) const {
  const double s2 = (norm2(rows[0]) + norm2(rows[1]) + norm2(rows[2])) / 3;
  if (!(s2 > 0) || !std::isfinite(s2)) return false;
  if (factor != nullptr) *factor = std::sqrt(s2);
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const double expected = i == j ? s2 : 0;
      if (std::abs(dot(rows[i], rows[j]) - expected) > orthogonality_tolerance * s2 * 4) return false;
    }
  }
  return true;
}

bool Transform::is_rigid() const {
  double factor = 0;
  return is_similarity(&factor) && std::abs(factor - 1) <= orthogonality_tolerance && determinant() > 0;
}

}  // namespace aresta
