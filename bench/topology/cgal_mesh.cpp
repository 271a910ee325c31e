// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include "topology/peers.h"

namespace aresta::bench {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

struct CgalMesh : Built {
  CGAL::Surface_mesh<Point> mesh;
  std::size_t edge_count() const override { return mesh.number_of_edges(); }
};

}  // namespace

std::unique_ptr<Built> build_with_cgal(const test::TriangleMesh& input) {
  auto built = std::make_unique<CgalMesh>();
  auto& mesh = built->mesh;
  mesh.reserve(static_cast<unsigned>(input.points.size()), static_cast<unsigned>(3 * input.triangles.size() / 2),
               static_cast<unsigned>(input.triangles.size()));
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
  for (const auto& p : input.points) mesh.add_vertex(Point(p[0], p[1], p[2]));
  for (const auto& t : input.triangles) mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return built;
}

std::string cgal_version() {
  return CGAL_VERSION_STR;
}

}  // namespace aresta::bench
