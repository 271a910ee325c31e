// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include "fragment/peers.h"

namespace aresta::bench {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

struct SolidsBuilder : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
  explicit SolidsBuilder(const std::vector<PolygonMesh>& given) : solids(given) {}
  const std::vector<PolygonMesh>& solids;

  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target);
    builder.begin_surface(0, 0);
    std::size_t first = 0;
    for (const PolygonMesh& solid : solids) {
      for (const Vec3 p : solid.points) builder.add_vertex({p.x, p.y, p.z});
      for (const auto& face : solid.faces) {
        builder.begin_facet();
        for (const std::uint32_t v : face) builder.add_vertex_to_facet(first + v);
        builder.end_facet();
      }
      first += solid.points.size();
    }
    builder.end_surface();
  }
};

Nef to_nef(const std::vector<PolygonMesh>& solids) {
  Polyhedron polyhedron;
  SolidsBuilder builder(solids);
  polyhedron.delegate(builder);
  return Nef(polyhedron);
}

}  // namespace

Answer chain_with_nef(const Chain& chain) {
  const Nef first = to_nef({chain.first});
  std::vector<Nef> steps;
  for (const auto& step : chain.steps) steps.push_back(to_nef(step));
  Answer answer;
  const Nef result = timed(answer.seconds, [&] {
    Nef nef = first;
    for (const Nef& step : steps) nef = chain.is_difference ? nef - step : nef + step;
    return nef;
  });
  for (auto v = result.volumes_begin(); v != result.volumes_end(); ++v) answer.cells += v->mark() ? 1 : 0;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(result, mesh, true);
  answer.volume = answer.solid_volume = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
  return answer;
}

}  // namespace aresta::bench
