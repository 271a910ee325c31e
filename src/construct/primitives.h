// SPDX-License-Identifier: Apache-2.0
// Primitive solids with exact geometry, each one filled region (a polyhedron may be several).
//
// Faces look outward. Errors: bad_size names the argument, what was expected and what was given. A shape whose size
// falls below its tolerance (see ConstructOptions) is refused, not built.
#pragma once

#include <span>
#include <vector>

#include "base/context.h"
#include "construct/options.h"
#include "model/model.h"

namespace aresta {

/// Axis-parallel box with its lowest corner at `at`. Faces in order: left (-x), right, front (-y), back, bottom, top.
Result<Model> block(double dx, double dy, double dz, Vec3 at = {}, const ConstructOptions& options = {});

/// A block whose side at y = dy is only `ltx` wide in x (0: an edge): a ramp with its corner at the origin of the
/// placement.
Result<Model> wedge(double dx, double dy, double dz, double ltx, const Placement& placement = {},
                    const ConstructOptions& options = {});

/// Regular n-gon of circumradius r, its first corner on the placement's local x, extruded by h along the axis.
Result<Model> prism(int n, double r, double h, const Placement& placement = {}, const ConstructOptions& options = {});

/// Regular n-gon of circumradius r and an apex at height h above its centre.
Result<Model> pyramid(int n, double r, double h, const Placement& placement = {}, const ConstructOptions& options = {});

/// Base centre at `at`. Faces: bottom, sides, top. With one patch: 2 vertices, 3 edges, 3 faces.
Result<Model> cylinder(double r, double h, const Placement& placement = {}, const Patches& patches = {},
                       const ConstructOptions& options = {});

/// Radius r1 at the base, r2 at height h; one may be 0 (an apex). Radii equal within tolerance make a cylinder.
Result<Model> cone(double r1, double r2, double h, const Placement& placement = {}, const Patches& patches = {},
                   const ConstructOptions& options = {});

/// Centre at `at`, poles along the axis. With one patch: 2 vertices, 1 edge (the seam), 1 face.
Result<Model> sphere(double r, const Placement& placement = {}, const Patches& patches = {},
                     const ConstructOptions& options = {});

/// `major` from the centre to the tube's centre, `minor` the tube's radius, smaller than `major`. With one patch: 1
/// vertex, 2 edges, 1 face.
Result<Model> torus(double major, double minor, const Placement& placement = {}, const Patches& patches = {},
                    const ConstructOptions& options = {});

/// A face of a polyhedron: its outer loop and its holes, as indices of points.
struct PolyhedronFace {
  std::vector<std::vector<std::size_t>> loops;
};

/// Solids bounded by plane faces. Outer loops run counterclockwise seen from outside (holes may run either way).
/// Several shells are allowed: separate solids, voids (their faces look into the void), and solids that touch in
/// vertices or edges. Points nearer than the tolerance are one. Errors: not_planar, self_intersection (a loop of a
/// face), not_closed (an edge without its other side), inside_out, points_coincide, and what
/// model/check.h finds: faces that cross.
Result<Model> polyhedron(std::span<const Vec3> points, std::span<const PolyhedronFace> faces,
                         const ConstructOptions& options = {}, const Context& context = {});

/// The side of a plane that its normal points away from: f(p) = (p - point) . normal <= 0.
struct HalfSpace {
  Vec3 point;
  Vec3 normal;
};

/// A half-space made finite for use as an operand: a block with one face on the plane that covers all of `box` on the
/// half-space's side and reaches beyond it everywhere else.
Result<Model> half_space_block(const HalfSpace& half_space, const Box3& box, const ConstructOptions& options = {});

}  // namespace aresta
