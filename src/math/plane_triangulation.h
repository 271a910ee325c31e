// SPDX-License-Identifier: Apache-2.0
// Constrained Delaunay triangulation of a region of the plane given by directed boundary segments.
//
// Guarantees: every point is a corner, every segment an edge, triangles are counterclockwise, none has zero area; only
// the inside is returned. Orientation signs are exact; the in-circle test is in doubles, so that the triangulation may
// differ from Delaunay's in nearly cocircular cases, never in validity.
// Degeneracies: a point on a segment, segments that cross and coinciding points are reported, not repaired.
// Cost: about n^1.5 for points in no special order (walking location), small constants.
// Papers: C. L. Lawson (1977) for the flips; S. W. Sloan, Computers & Structures 47 (1993) for the recovery of
// segments.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/vec.h"

namespace aresta {

struct PlaneInput {
  std::vector<Vec2> points;
  /// The inside lies to the left. A segment present in both directions has the inside on both sides.
  std::vector<std::array<std::uint32_t, 2>> segments;
};

struct PlaneOutput {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Set when the input is broken: a point at the place of the trouble; triangles are then empty.
  std::optional<std::uint32_t> bad_point;
};

PlaneOutput triangulate_plane(const PlaneInput& input);

/// Positive when a, b, c turn left, zero when they are in line; the sign is exact.
double orient2d(Vec2 a, Vec2 b, Vec2 c);

}  // namespace aresta
