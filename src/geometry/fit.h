// SPDX-License-Identifier: Apache-2.0
// Least-squares fits of the analytic forms to points, and to points with normals. They fit whatever they get; how well
// is for the caller to ask. Nothing comes back when the points do not determine the form.
//
// Papers: Pottmann, Randrup, Rotational and helical surface approximation (1998) for the axis of a surface of
// revolution (its normals meet the axis: a linear complex); Pratt, Direct least-squares fitting of algebraic surfaces
// (1987).
#pragma once

#include <optional>
#include <span>

#include "geometry/curve.h"
#include "geometry/surface.h"

namespace aresta::fit {

/// Points and unit normals (zero where unknown) of a patch; normals all to one side.
struct Samples {
  std::vector<Vec3> points, normals;
};

std::optional<Plane> plane(std::span<const Vec3> points);
std::optional<Sphere> sphere(std::span<const Vec3> points);
std::optional<Cylinder> cylinder(const Samples& samples);
std::optional<Cone> cone(const Samples& samples);
std::optional<Torus> torus(const Samples& samples);

/// In the plane of best fit; the frame's z is its normal, x and y are arbitrary for a circle.
std::optional<Circle> circle(std::span<const Vec3> points);
std::optional<Ellipse> ellipse(std::span<const Vec3> points);

}  // namespace aresta::fit
