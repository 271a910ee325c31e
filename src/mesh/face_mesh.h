// SPDX-License-Identifier: Apache-2.0
// The mesh of one face, conforming to its subdivided boundary and to the edges and points inside it.
//
// Guarantees when it succeeds: every side of the boundary's chains is a side of exactly one triangle (of two where the
// edge lies inside the face, or is a seam); points inside are corners; corners lie on the surface; no triangle looks
// away from the surface's normal; the surface is near every triangle. Degeneracies: seams (the boundary uses an edge
// twice), poles and apexes (a gap in parameter space that is a point in space), dangling edges, slits, isolated points,
// several outer loops, periodic parameters. A closed face without seam is refused. Method: a constrained Delaunay
// triangulation in the parameter plane, with a grid of points where the surface or its parameter lines turn, gives the
// topology only; its seam is glued and its poles shrunk; then it is remeshed in space (remesh.h), where the
// parametrisation no longer matters.
#pragma once

#include "mesh/sizes.h"

namespace aresta::mesh {

struct FaceMesh {
  /// Nodes of triangles: below `boundary.size()` the boundary's, by their number there; then the inner points.
  std::vector<std::uint32_t> boundary;  ///< nodes of the edge mesh
  std::vector<Vec3> inner;
  std::vector<Vec2> inner_uv, boundary_uv;              ///< one parameter pair of each (a seam's node has several)
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise seen from the face's front
};

/// Errors: mesh.bad_input, mesh.face_boundary and mesh.face_failed (worth another try with smaller sizes), cancelled.
Result<FaceMesh> mesh_face(const Model& model, FaceId face, const EdgeMesh& edges, const SizeField& field,
                           const Context& context);

}  // namespace aresta::mesh
