// SPDX-License-Identifier: Apache-2.0
#include <OpenMesh/Core/System/config.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "topology/peers.h"

namespace aresta::bench {

namespace {

struct DoublePoints : OpenMesh::DefaultTraits {
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<DoublePoints>;

struct OpenMeshMesh : Built {
  Mesh mesh;
  std::size_t edge_count() const override { return mesh.n_edges(); }
};

}  // namespace

std::unique_ptr<Built> build_with_openmesh(const test::TriangleMesh& input) {
  auto built = std::make_unique<OpenMeshMesh>();
  auto& mesh = built->mesh;
  mesh.reserve(input.points.size(), 3 * input.triangles.size() / 2, input.triangles.size());
  for (const auto& p : input.points) mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
  for (const auto& t : input.triangles) {
    mesh.add_face(OpenMesh::VertexHandle(static_cast<int>(t[0])), OpenMesh::VertexHandle(static_cast<int>(t[1])),
                  OpenMesh::VertexHandle(static_cast<int>(t[2])));
  }
  return built;
}

std::string openmesh_version() {
  return std::to_string(OM_GET_VER) + "." + std::to_string(OM_GET_MAJ);
}

}  // namespace aresta::bench
