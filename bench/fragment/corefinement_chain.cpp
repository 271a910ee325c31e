// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

#include "fragment/peers.h"

namespace aresta::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

void add(Mesh& target, const PolygonMesh& mesh) {
  std::vector<Mesh::Vertex_index> vertices;
  for (const Vec3 p : mesh.points) vertices.push_back(target.add_vertex({p.x, p.y, p.z}));
  for (const auto& [a, b, c] : triangles_of(mesh)) target.add_face(vertices[a], vertices[b], vertices[c]);
}

std::uint64_t solids_of(const Mesh& mesh) {
  std::vector<Mesh> parts;
  processing::split_connected_components(mesh, parts);
  return static_cast<std::uint64_t>(
      std::count_if(parts.begin(), parts.end(), [](const Mesh& part) { return processing::volume(part) > 0; }));
}

}  // namespace

Answer chain_with_corefinement(const Chain& chain) {
  Mesh first;
  add(first, chain.first);
  std::vector<Mesh> steps(chain.steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const PolygonMesh& mesh : chain.steps[i]) add(steps[i], mesh);
  }
  Answer answer;
  const Mesh result = timed(answer.seconds, [&] {
    Mesh mesh = first;
    // The operands are changed: the copies are part of what it takes.
    for (Mesh other : steps) {
      Mesh made;
      const bool is_done = chain.is_difference ? processing::corefine_and_compute_difference(mesh, other, made)
                                               : processing::corefine_and_compute_union(mesh, other, made);
      if (!is_done) throw std::runtime_error("the result is no manifold mesh");
      mesh = std::move(made);
    }
    return mesh;
  });
  answer.cells = solids_of(result);
  answer.volume = answer.solid_volume = CGAL::to_double(processing::volume(result));
  return answer;
}

}  // namespace aresta::bench
