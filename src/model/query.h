// SPDX-License-Identifier: Apache-2.0
// Questions about points and entities: where a point lies, where a ray meets a face, a point inside a face or region.
#pragma once

#include "base/context.h"
#include "model/model.h"

namespace aresta {

enum class Position { outside, boundary, inside };

/// Trimming of a face, prepared for many questions (boundary images as adaptive polylines with an error bound).
class FaceTrim {
 public:
  FaceTrim(const Model& model, FaceId face);
  /// Where uv lies in the trimmed face. Answers `boundary` when nearer to the boundary's image than `tolerance` (a
  /// length in space) or than the polylines' own error. Periodic parameters may be given in any period. The face's
  /// loose and dangling edges do not count as boundary.
  Position locate(Vec2 uv, double tolerance) const;
  /// A point well inside the face, away from its edges; deterministic. Error measure_failed when the face is thinner
  /// than its tolerance.
  Result<Vec2> interior_point() const;
  /// Box of the boundary's image, in one lift of it (a periodic parameter may leave its domain); the surface's domain
  /// for a face without edges.
  Range2 box() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

struct RayHit {
  double t = 0;  ///< distance along the ray
  FaceId face;
  Vec2 uv;
  FaceUse facing;         ///< the side that looks towards the ray's origin
  bool doubtful = false;  ///< near an edge or nearly tangent: choose another ray
};

/// Meetings of a ray with faces, with boxes and trims kept for many rays.
class RayCaster {
 public:
  explicit RayCaster(const Model& model);
  /// All meetings with t > 0 (a face that holds the origin itself, to rounding, is not met there), by growing t.
  /// `direction` is a unit vector. Several threads may cast at once.
  std::vector<RayHit> cast(Vec3 origin, Vec3 direction) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Where a point lies relative to a model's entities: the smallest-dimensional entity within `tolerance` of it, else
/// the region (possibly the infinite one, or an empty cell) that holds it.
Result<EntityRef> locate_point(const Model& model, Vec3 point, double tolerance);

/// Is the point inside the region, on its boundary, or outside?
Result<Position> point_in_region(const Model& model, RegionId region, Vec3 point, double tolerance);
bool point_on_face(const Model& model, FaceId face, Vec3 point, double tolerance);
bool point_on_edge(const Model& model, EdgeId edge, Vec3 point, double tolerance);
bool point_on_vertex(const Model& model, VertexId vertex, Vec3 point, double tolerance);

/// A point strictly inside the region; deterministic.
Result<Vec3> interior_point(const Model& model, RegionId region);
/// Distance from a point to an entity (0 inside a region).
Result<double> distance_to(const Model& model, EntityRef entity, Vec3 point);
/// The entity of a kind nearest to a point; ties go to the smallest id.
Result<EntityRef> nearest(const Model& model, EntityKind kind, Vec3 point);

}  // namespace aresta
