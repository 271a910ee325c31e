// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/version.h>

#include "fragment/peers.h"

namespace aresta::bench {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

/// Corner i has the high end in x, y, z where the bits 0, 1, 2 of i are set; not rounded.
Kernel::Point_3 corner(const Block& block, int i) {
  const auto n = block.numerators();
  std::array<Kernel::FT, 3> p{block.middle.x, block.middle.y, block.middle.z};
  for (std::size_t row = 0; row < 3; ++row) {
    Kernel::FT sum(0);
    for (int axis = 0; axis < 3; ++axis)
      sum += Kernel::FT((i >> axis & 1) != 0 ? block.half[axis] : -block.half[axis]) * n[row][std::size_t(axis)];
    p[row] += sum / block.denominator();
  }
  return {p[0], p[1], p[2]};
}

struct BlockBuilder : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
  explicit BlockBuilder(const Block& given) : block(given) {}
  const Block& block;

  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target);
    constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    builder.begin_surface(8, 6, 24);
    for (int i = 0; i < 8; ++i) builder.add_vertex(corner(block, i));
    for (const auto& face : faces) builder.add_facet(face, face + 4);
    builder.end_surface();
  }
};

/// Neighbours in the list first, so that each is part of few unions.
Nef united(std::vector<Nef> parts) {
  while (parts.size() > 1) {
    std::vector<Nef> half;
    for (std::size_t i = 0; i + 1 < parts.size(); i += 2) half.push_back(parts[i] + parts[i + 1]);
    if (parts.size() % 2 == 1) half.push_back(parts.back());
    parts.swap(half);
  }
  return parts.front();
}

/// Of all bounded volumes: what is outside looks at the cells from the other side.
double volume_of_cells(const Nef& nef) {
  double sixfold = 0;
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    if (f->incident_volume() != nef.volumes_begin()) continue;
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) continue;
      const Nef::SHalfedge_const_handle first(cycle);
      Nef::SHalfedge_around_facet_const_circulator c(first), end = c;
      std::vector<Vec3> points;
      CGAL_For_all(c, end) {
        const auto p = c->source()->source()->point();
        points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
      }
      for (std::size_t i = 1; i + 1 < points.size(); ++i) sixfold += dot(points[0], cross(points[i], points[i + 1]));
    }
  }
  return std::abs(sixfold) / 6;
}

}  // namespace

Answer cells_with_nef(const std::vector<Block>& blocks) {
  std::vector<Nef> boundaries;
  for (const Block& block : blocks) {
    Polyhedron polyhedron;
    BlockBuilder builder(block);
    polyhedron.delegate(builder);
    boundaries.push_back(Nef(polyhedron).boundary());
  }
  Answer answer;
  const Nef all = timed(answer.seconds, [&] { return united(boundaries); });
  answer.cells = all.number_of_volumes() - 1;
  answer.volume = volume_of_cells(all);
  return answer;
}

std::string cgal_version() {
  return CGAL_VERSION_STR;
}

}  // namespace aresta::bench
