// SPDX-License-Identifier: Apache-2.0
// Faces, wires and points: models of one face, of wire edges, or of one vertex.
//
// Errors: bad_size names the argument, what was expected and what was given; points_coincide; not_planar;
// self_intersection names the place.
#pragma once

#include <span>
#include <vector>

#include "base/context.h"
#include "construct/options.h"
#include "model/model.h"

namespace aresta {

/// Plane face inside `points`; its normal follows from their order by the right-hand rule. Holes may run either way;
/// they lie inside, apart from each other. The last point may repeat the first.
Result<Model> polygon(std::span<const Vec3> points, std::span<const std::vector<Vec3>> holes = {},
                      const ConstructOptions& options = {});

/// Plane round face about the axis: 1 vertex, 1 edge.
Result<Model> disk(double r, const Placement& placement = {}, const ConstructOptions& options = {});

/// The plane face inside closed wires (lines, arcs, splines, ...), given in any order and direction, whose ends meet
/// within tolerance: the largest outline, less the others, which lie inside it. Its normal follows from the direction
/// of the first edge given of the outline, by the right-hand rule. Errors: not_closed, not_planar, self_intersection,
/// bad_profile.
Result<Model> planar_face(std::span<const Model* const> wires, const ConstructOptions& options = {},
                          const Context& context = {});

/// Straight edges from point to point. The last point may repeat the first of a closed one.
Result<Model> polyline(std::span<const Vec3> points, bool closed = false, const ConstructOptions& options = {});
Result<Model> line(Vec3 p, Vec3 q, const ConstructOptions& options = {});

/// The shorter circular arc from `start` to `end` about `centre`.
Result<Model> arc(Vec3 centre, Vec3 start, Vec3 end, const ConstructOptions& options = {});
/// The arc counterclockwise about `axis`, which decides where the short way does not (half turns and longer ones).
Result<Model> arc_about(Vec3 centre, Vec3 start, Vec3 end, Vec3 axis, const ConstructOptions& options = {});
/// The arc from `start` through `middle` to `end`.
Result<Model> arc_through(Vec3 start, Vec3 middle, Vec3 end, const ConstructOptions& options = {});

/// A closed edge with one vertex, on the placement's local x; counterclockwise about the axis.
Result<Model> circle(double r, const Placement& placement = {}, const ConstructOptions& options = {});
/// Semi-axis a along local x, b along local y; either may be the larger one.
Result<Model> ellipse(double a, double b, const Placement& placement = {}, const ConstructOptions& options = {});

/// The cubic spline through the points, parametrised by chord length, with continuous second derivative; see spline.h.
/// A closed one comes back to its first point with continuous second derivative.
Result<Model> spline(std::span<const Vec3> points, bool closed = false, const ConstructOptions& options = {});

Result<Model> point(Vec3 p, const ConstructOptions& options = {});

}  // namespace aresta
