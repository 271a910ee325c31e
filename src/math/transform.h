// SPDX-License-Identifier: Apache-2.0
// Frames (right-handed orthonormal axes at an origin) and affine maps.
#pragma once

#include <array>

#include "math/vec.h"

namespace aresta {

/// Orthonormal axes at an origin. Right-handed unless a mirror made it left-handed: z is stored, not derived.
struct Frame {
  Vec3 origin{};
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  constexpr bool operator==(const Frame&) const = default;
  constexpr Vec3 to_world(Vec3 p) const { return origin + p.x * x + p.y * y + p.z * z; }
  constexpr Vec3 to_local(Vec3 p) const {
    const Vec3 d = p - origin;
    return {dot(d, x), dot(d, y), dot(d, z)};
  }
  constexpr bool right_handed() const { return dot(cross(x, y), z) > 0; }

  /// The frame at `origin` with z along `axis` (any length but zero) and a fixed choice of x.
  static Frame along(Vec3 origin, Vec3 axis) {
    const Vec3 z = normalized(axis);
    const bool is_world_z = z.x == 0 && z.y == 0;
    const Vec3 x = is_world_z ? Vec3{1, 0, 0} : any_perpendicular(z);
    return {origin, x, cross(z, x), z};
  }
  /// The frame at `origin` with z along `axis` and x as near to `x_hint` as it can be; x_hint not parallel to axis.
  static Frame along(Vec3 origin, Vec3 axis, Vec3 x_hint) {
    const Vec3 z = normalized(axis);
    const Vec3 x = normalized(x_hint - dot(x_hint, z) * z);
    return {origin, x, cross(z, x), z};
  }
};

/// p -> linear * p + offset; linear by rows.
struct Transform {
  std::array<Vec3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 offset{};

  constexpr Vec3 vector(Vec3 v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
  constexpr Vec3 point(Vec3 p) const { return vector(p) + offset; }
  constexpr double determinant() const { return dot(rows[0], cross(rows[1], rows[2])); }

  /// First `b`, then `a`.
  friend constexpr Transform operator*(const Transform& a, const Transform& b) {
    Transform c;
    for (int i = 0; i < 3; ++i) {
      c.rows[i] = a.rows[i].x * b.rows[0] + a.rows[i].y * b.rows[1] + a.rows[i].z * b.rows[2];
    }
    c.offset = a.point(b.offset);
    return c;
  }

  static Transform translation(Vec3 d);
  /// Right-handed turn by `degrees` about the line through `about` along `axis` (any length but zero).
  static Transform rotation(double degrees, Vec3 axis, Vec3 about = {});
  static Transform scaling(double factor, Vec3 about = {});
  /// Reflection in the plane through `point` with normal `normal` (any length but zero).
  static Transform reflection(Vec3 point, Vec3 normal);
  /// Twelve numbers: the 3x4 matrix by rows.
  static Transform from_rows(const std::array<double, 12>& m);

  /// Is it a rotation, reflection or uniform scaling followed by a translation, to 1e-12 relative? `factor` gets
  /// |scale|.
  bool is_similarity(double* factor = nullptr) const;
  /// Is it a rigid motion (no scaling, no reflection), to 1e-12?
  bool is_rigid() const;
};

}  // namespace aresta
