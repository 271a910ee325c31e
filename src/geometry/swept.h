// SPDX-License-Identifier: Apache-2.0
// Surfaces that a moving curve sweeps, in the parametrisation of the STEP standard, and images rescaled to match.
#pragma once

#include "geometry/curve2.h"
#include "geometry/surface.h"

namespace aresta {

/// curve(u) + v direction, direction a unit vector. Keeps the curve as it is. Error: bad_geometry.
Result<Surface> extrusion_surface(const Curve& curve, Vec3 direction);

/// curve(v) turned by u radians about the axis (a unit vector) through origin. Error: bad_geometry.
Result<Surface> revolution_surface(const Curve& curve, Vec3 origin, Vec3 axis);

/// The image q with q(t_scale t) = (uv_scale.x p.x, uv_scale.y p.y) at p = image(t), for t in `range`; exact. It stays
/// what it is where it can, else becomes a NURBS.
Result<Curve2> rescaled(const Curve2& image, Vec2 uv_scale, double t_scale, Range range);

}  // namespace aresta
