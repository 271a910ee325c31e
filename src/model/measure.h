// SPDX-License-Identifier: Apache-2.0
// Length, area, volume, centroid and inertia of entities.
//
// Exact (to rounding) where all edges are straight and all faces plane; else by adaptive quadrature of closed one-form
// integrals along the faces' boundaries, to `relative` error, which the result states. Points of edges are first put on
// the exact surface (by inverting it near the edge's image), so that the error of a stored image does not count.
// Method: divergence theorem on each region's boundary, Green's theorem in each face's parameter plane.
#pragma once

#include <span>

#include "base/context.h"
#include "model/model.h"

namespace aresta {

/// Moments of a set of points of some dimension: measure (length, area or volume), first and second moments about
/// `reference`, a point near the set: far from the origin nothing is lost. `error` bounds the measure's absolute error.
struct Moments {
  double measure = 0;
  Vec3 first{};                    ///< integral of q = p - reference
  std::array<double, 6> second{};  ///< integrals of xx, yy, zz, xy, yz, zx of q
  Vec3 reference{};
  double error = 0;

  Vec3 centroid() const { return measure != 0 ? reference + first / measure : reference; }
  /// Inertia tensor about the centroid (unit density): xx, yy, zz, xy, yz, zx; products of inertia with negative sign.
  std::array<double, 6> inertia() const;
  /// The same moments about another point.
  Moments about(Vec3 point) const;
  /// Adds, about this reference (or the other's, when this is still zero).
  Moments& operator+=(const Moments& other);
};

struct MeasureOptions {
  double relative = 1e-10;
};

Result<Moments> measure(const Model& model, EdgeId edge, const MeasureOptions& options = {});
Result<Moments> measure(const Model& model, FaceId face, const MeasureOptions& options = {});
Result<Moments> measure(const Model& model, RegionId region, const MeasureOptions& options = {});

/// Volume moments enclosed under one side of a face towards a reference point: the flux integrals whose sum over a
/// closed set of sides gives the volume that these sides look away from (side 0 looks along the face's normal). So the
/// volume of a region is minus the sum over its face-uses. First and second moments likewise, about `reference`.
/// Regions and radial order are not looked at.
Result<Moments> flux(const Model& model, FaceId face, Vec3 reference, const MeasureOptions& options = {});

/// Sum over all of: regions' volumes; each face's area once; each edge's length once.
Result<double> total_volume(const Model& model, const Context& context = {});
Result<double> total_area(const Model& model, const Context& context = {});
Result<double> total_length(const Model& model, const Context& context = {});

}  // namespace aresta
