// SPDX-License-Identifier: Apache-2.0
// Plane faces over shared points: what block, prism, polyhedron and polygon are made of.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/builder.h"

namespace aresta {

using IndexLoop = std::vector<std::size_t>;

/// Twice the vector area of a closed polygon (Newell): its direction is the normal by the right-hand rule.
Vec3 newell(std::span<const Vec3> points, const IndexLoop& loop);

/// The plane of the loop: natural normal by the right-hand rule, x along its first edge, through its mean height. The
/// loop must have area. `deviation`, when given, gets the largest distance of a point of the loop from it.
Frame plane_of(std::span<const Vec3> points, const IndexLoop& loop, double* deviation = nullptr);

/// Where a closed polygon in a plane meets itself or another: a place for the error message.
struct Crossing {
  Vec3 place;
  std::size_t first = 0, second = 0;  ///< segments, counted through all loops
};

/// Do segments of these loops come nearer to each other than `tolerance` other than in the end that neighbours share?
/// The loops' points are in the plane of `frame`. Near n log n for loops that do not overlap much in x.
std::optional<Crossing> find_crossing(std::span<const Vec3> points, std::span<const IndexLoop> loops,
                                      const Frame& frame, double tolerance);

/// Is the point in the plane of `frame` inside the closed polygon? Even-odd rule; for points that are not on it.
bool inside_loop(std::span<const Vec3> points, const IndexLoop& loop, const Frame& frame, Vec3 p);

/// Shares vertices and straight edges among faces given by point indices.
class PlanarParts {
 public:
  /// Adds all the points as vertices.
  PlanarParts(ModelBuilder& builder, std::span<const Vec3> points);

  /// Outer loop first, counterclockwise seen from the face's front.
  FaceId add_face(std::span<const IndexLoop> loops, const std::string& name = {});
  FaceId add_face(const IndexLoop& loop, const std::string& name = {}) { return add_face(std::span(&loop, 1), name); }

  std::size_t edge_count() const { return edges_.size(); }
  std::size_t vertex_count() const { return points_.size(); }
  std::size_t face_count() const { return builder_.face_count(); }

 private:
  ModelBuilder& builder_;
  std::span<const Vec3> points_;
  std::vector<VertexId> vertices_;
  std::map<std::pair<std::size_t, std::size_t>, EdgeId> edges_;  // by smaller, larger point
};

}  // namespace aresta
