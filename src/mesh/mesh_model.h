// SPDX-License-Identifier: Apache-2.0
// From a model to a conforming finite element mesh: edges, then faces, then regions.
#pragma once

#include <map>

#include "base/context.h"
#include "mesh/mesh.h"
#include "model/model.h"

namespace aresta {

struct MeshOptions {
  /// Wished length of element sides, in the model's unit; 0: a twelfth of the box's diagonal.
  double size = 0;
  /// No element is asked to be smaller; 0: a thousandth of `size`.
  double least_size = 0;
  /// Most degrees that a curve or a surface may turn along one element side; 5 to 90.
  double angle = 20;
  /// Growth of the size per unit of distance; 0.05 to 1.
  double grading = 0.3;
  /// 1: straight elements; 2: with mid-side nodes on the curves and surfaces.
  int order = 1;
  /// Highest dimension of the elements: 1, 2 or 3.
  int dimension = 3;
  /// Own sizes of vertices, edges, faces and regions; they only make the mesh finer.
  std::map<EntityRef, double> sizes = {};
};

/// A mesh of everything in the model up to `dimension`: points, lines on all edges, triangles on all faces (oriented as
/// their face), tetrahedra in all filled regions. What touches shares nodes. Sets: the names of entities and the
/// groups, those whose entities have elements. Every node of an edge or face lies on its curve or surface.
///
/// Checked before it is returned: face meshes (boundary met exactly, no folded triangle, near the surface), the volumes
/// of regions against their boundaries to 1e-9, conformity, positive Jacobians. Where a check of a face fails the sizes
/// around it are halved and the mesh is made again, some times; what still fails is an error.
/// Deterministic: the same model and options give the same bytes.
/// Errors: mesh.bad_options, mesh.bad_input, mesh.edge_failed, mesh.face_boundary, mesh.face_failed,
/// mesh.surfaces_cross, mesh.volume_failed, mesh.check_failed, mesh.embedded_wire, module.missing, cancelled.
Result<Mesh> mesh_model(const Model& model, const MeshOptions& options = {}, const Context& context = {});

}  // namespace aresta
