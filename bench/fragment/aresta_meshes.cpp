// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "fragment/peers.h"
#include "planar/triangle_mesh.h"

namespace aresta::bench {

namespace {

planar::TriangleMesh to_mesh(const PolygonMesh& mesh) {
  return {mesh.points, triangles_of(mesh)};
}

}  // namespace

Answer meshes_with_aresta(const Chain& chain) {
  const planar::TriangleMesh first = to_mesh(chain.first);
  std::vector<planar::TriangleMesh> others;
  for (const auto& step : chain.steps) {
    for (const PolygonMesh& mesh : step) others.push_back(to_mesh(mesh));
  }
  const auto operation = chain.is_difference ? planar::MeshOperation::subtract : planar::MeshOperation::unite;
  Answer answer;
  const planar::CombinedMesh result = timed(answer.seconds, [&] {
    planar::CombinedMesh done;
    const planar::TriangleMesh* mesh = &first;
    for (const planar::TriangleMesh& other : others) {
      auto next = planar::combine(*mesh, other, operation, {}, {});
      if (!next.ok()) throw std::runtime_error(next.error().to_line());
      done = std::move(*next);
      mesh = &done.mesh;
    }
    return done;
  });
  answer.cells = 1;  // meshes have no regions; the volume is what is compared
  answer.volume = answer.solid_volume = result.volume;
  return answer;
}

}  // namespace aresta::bench
