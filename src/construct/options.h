// SPDX-License-Identifier: Apache-2.0
// What every constructor takes, and the errors of this folder.
#pragma once

#include "base/result.h"
#include "math/vec.h"

namespace aresta {

namespace errors {  // construct: 600-649
inline constexpr ErrorCode bad_size{600, "construct.argument"};
inline constexpr ErrorCode not_planar{601, "construct.not_planar"};
inline constexpr ErrorCode self_intersection{602, "construct.self_intersection"};
inline constexpr ErrorCode not_closed{603, "construct.not_closed"};
inline constexpr ErrorCode inside_out{604, "construct.inside_out"};
inline constexpr ErrorCode points_coincide{605, "construct.points_coincide"};
inline constexpr ErrorCode bad_profile{606, "construct.profile"};
inline constexpr ErrorCode sweep_overlaps{607, "construct.sweep_overlaps"};
inline constexpr ErrorCode not_similar{608, "construct.not_similar"};
inline constexpr ErrorCode not_disjoint{609, "construct.not_disjoint"};
inline constexpr ErrorCode mixed_units{610, "construct.mixed_units"};
}  // namespace errors

/// Lengths are in document units, angles in degrees.
struct ConstructOptions {
  /// Asked for; what is built gets the larger of it, 1e-9 of its box's diagonal and 32 roundings of its largest
  /// coordinate. A size below that is refused.
  double tolerance = 0;
  double length_unit = 1e-3;  ///< metres per document unit
  /// Name the faces by what they are: "bottom", "top", "side", "left", ...
  bool names = false;
};

/// Where a shape stands: its base's centre (or corner) and its axis, of any length but zero.
struct Placement {
  Vec3 at{};
  Vec3 axis{0, 0, 1};
};

/// A round side is split into `count` faces; the first seam is turned by `seam` degrees from the placement's local x.
struct Patches {
  int count = 1;
  double seam = 0;
};

}  // namespace aresta
