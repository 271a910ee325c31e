// SPDX-License-Identifier: Apache-2.0
// Element sizes of a model, and its edges subdivided by them.
#pragma once

#include "mesh/mesh_model.h"
#include "mesh/size_field.h"

namespace aresta::mesh {

/// `options` with defaults filled in. Error: mesh.bad_options, in words of the option.
Result<MeshOptions> complete_options(const Model& model, const MeshOptions& options);

/// The size field of the model's curvature and of entities' own sizes. Options must be complete.
Result<SizeField> model_sizes(const Model& model, const MeshOptions& options, const Context& context);

/// An edge as a chain of nodes, its vertices' nodes at the ends.
struct EdgeChain {
  std::vector<double> parameters;    ///< growing, from the range's low to its high end
  std::vector<std::uint32_t> nodes;  ///< as many
};

/// Vertices and subdivided edges: nodes of vertices first (node i is vertex i), then of edges, by id.
struct EdgeMesh {
  std::vector<Vec3> nodes;
  std::vector<EdgeChain> chains;  ///< per edge
};

/// Subdivides all edges so that sides have the field's size; puts the lengths that come out back into the field, so
/// that faces are graded from their boundary. Curved edges get at least 2 sides, closed ones 3. Error:
/// mesh.edge_failed.
Result<EdgeMesh> subdivide_edges(const Model& model, SizeField& field, const Context& context);

/// Largest principal curvature of a surface (absolute); 0 where it is singular.
double largest_curvature(const SurfaceJet& jet);

/// The box that a face's boundary has in its parameter plane.
Range2 parameter_box(const Model& model, FaceId face);

}  // namespace aresta::mesh
