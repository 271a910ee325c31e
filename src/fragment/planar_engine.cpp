// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "fragment/engine.h"
#include "fragment/errors.h"
#include "planar/cells.h"
#include "planar/imprint.h"

namespace aresta {

namespace {

using planar::Index;

/// The soup of all operands; entity i of operand o is number first[o] + i of its kind.
struct Gathered {
  planar::Soup soup;
  std::vector<Index> first_vertex, first_edge, first_face;
};

Gathered gather(std::span<const std::shared_ptr<const Model>> operands) {
  Gathered all;
  planar::Soup& soup = all.soup;
  Incidence& shape = soup.shape;
  for (Index o = 0; o < operands.size(); ++o) {
    const Model& model = *operands[o];
    const Complex& k = model.topology();
    const auto vertex = static_cast<Index>(soup.points.size()), edge = shape.edge_count();
    all.first_vertex.push_back(vertex);
    all.first_edge.push_back(edge);
    all.first_face.push_back(shape.face_count());
    for (const VertexId v : k.vertices()) soup.points.push_back(model.point(v));
    for (const EdgeId e : k.edges()) shape.edges.push_back({vertex + k.start(e).value, vertex + k.end(e).value});
    for (const FaceId f : k.faces()) {
      for (const LoopId l : k.loops(f)) {
        if (k.is_vertex_loop(l)) {
          shape.add_vertex_loop(vertex + k.loop_vertex(l).value);
          continue;
        }
        for (const CoedgeId c : k.coedges(l)) shape.add_coedge(edge + k.edge(c).value, k.reversed(c));
        shape.close_loop();
      }
      shape.close_face();
    }
    soup.vertex_operand.resize(soup.points.size(), o);
    soup.edge_operand.resize(shape.edge_count(), o);
    soup.face_operand.resize(shape.face_count(), o);
  }
  shape.vertex_count = static_cast<Index>(soup.points.size());
  soup.stitched.assign(operands.size(), operands.size() > 1);
  return all;
}

/// What a model of this box takes for one point at least; a single point has no size to go by.
double least_tolerance(const Box3& box) {
  constexpr double relative = 1e-9;
  double size = box.diagonal();
  for (int i = 0; i < 3; ++i) size = std::max({size, 1e-3 * std::abs(box.low[i]), 1e-3 * std::abs(box.high[i])});
  return size > 0 ? relative * size : relative;
}

class PlanarEngine final : public FragmentEngine {
 public:
  const char* name() const override { return "planar"; }

  Result<Imprint> imprint(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                          const Context& context) const override {
    const Gathered all = gather(operands);
    Box3 box;
    for (const auto& operand : operands) {
      tolerance = std::max(tolerance, operand->tolerance());
      box.add(operand->bounds());
    }
    tolerance = std::max(tolerance, least_tolerance(box));
    auto pieces = planar::imprint(all.soup, tolerance, context);
    if (!pieces.ok()) return named(std::move(pieces).error(), all);
    ARESTA_CHECK(planar::order_radially(pieces->faces(), pieces->shape));
    ARESTA_TRY(Cells cells, planar::find_cells(pieces->faces(), context));
    ARESTA_TRY(Imprint result, to_imprint(*pieces, all, operands, tolerance));
    result.builder.set_radial_order(std::move(pieces->shape.radial_next));
    result.cells = std::move(cells);
    return result;
  }

 private:
  /// The soup's entities in an error, as the operands' own.
  static Error named(Error error, const Gathered& all) {
    for (EntityRef& entity : error.entities) {
      const auto& first = entity.kind == EntityKind::vertex ? all.first_vertex
                          : entity.kind == EntityKind::edge ? all.first_edge
                                                            : all.first_face;
      const auto o = std::upper_bound(first.begin(), first.end(), entity.index) - first.begin() - 1;
      entity.index -= first[static_cast<std::size_t>(o)];
      error.message += std::string(&entity == error.entities.data() ? ": " : ", ") + to_string(entity.kind) + " " +
                       std::to_string(entity.index) + " of operand " + std::to_string(o + 1);
    }
    return error;
  }

  /// Per entity and operand, what of least dimension it lies in.
  static std::vector<std::vector<Parent>> to_parents(const Lists& names, const Gathered& all) {
    const auto vertices = static_cast<Index>(all.soup.points.size()), edges = all.soup.shape.edge_count();
    std::vector<std::vector<Parent>> parents(names.size());
    std::vector<Parent> list;
    for (std::size_t i = 0; i < names.size(); ++i) {
      list.clear();
      for (const Index n : names[i]) {
        if (n < vertices) {
          const Index o = all.soup.vertex_operand[n];
          list.push_back({o, VertexId(n - all.first_vertex[o])});
        } else if (n < vertices + edges) {
          const Index o = all.soup.edge_operand[n - vertices];
          list.push_back({o, EdgeId(n - vertices - all.first_edge[o])});
        } else {
          const Index o = all.soup.face_operand[n - vertices - edges];
          list.push_back({o, FaceId(n - vertices - edges - all.first_face[o])});
        }
      }
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      for (const Parent& p : list) {
        if (parents[i].empty() || parents[i].back().source != p.source ||
            parents[i].back().entity.kind == p.entity.kind)
          parents[i].push_back(p);
      }
    }
    return parents;
  }

  static Result<Imprint> to_imprint(const planar::Imprinted& pieces, const Gathered& all,
                                    std::span<const std::shared_ptr<const Model>> operands, double tolerance) {
    Imprint result;
    result.vertex_parents = to_parents(pieces.vertex_names, all);
    result.edge_parents = to_parents(pieces.edge_names, all);
    result.face_parents = to_parents(pieces.face_names, all);
    const Incidence& shape = pieces.shape;
    ModelBuilder& builder = result.builder;
    std::vector<double> vertex_tolerance(pieces.points.size(), 0), edge_tolerance(shape.edge_count(), 0);
    const auto inherit = [&](double& own, std::span<const Parent> parents, auto&& of) {
      for (const Parent& p : parents) own = std::max(own, of(*operands[p.source], p.entity));
    };
    const auto tolerance_of = [](const Model& model, EntityRef entity) {
      switch (entity.kind) {
        case EntityKind::vertex:
          return model.tolerance(VertexId(entity.index));
        case EntityKind::edge:
          return model.tolerance(EdgeId(entity.index));
        default:
          return model.tolerance(FaceId(entity.index));
      }
    };
    std::vector<double> face_tolerance(shape.face_count(), 0);
    for (Index f = 0; f < shape.face_count(); ++f) {
      const Parent& first = result.face_parents[f].front();
      inherit(face_tolerance[f], result.face_parents[f], tolerance_of);
      const Surface& plane = operands[first.source]->surface(FaceId(first.entity.index));
      for (Index l = shape.face_begin[f]; l < shape.face_begin[f + 1]; ++l) {
        const auto widen = [&](Index v) {
          const double d = distance(plane.point(plane.project(pieces.points[v]).uv), pieces.points[v]);
          if (d > tolerance) face_tolerance[f] = std::max(face_tolerance[f], d);
        };
        if (shape.loop_vertex[l] != Incidence::none) widen(shape.loop_vertex[l]);
        for (Index c = shape.loop_begin[l]; c < shape.loop_begin[l + 1]; ++c)
          widen(shape.edges[shape.coedges[c] / 2][shape.coedges[c] % 2]);
      }
      for (Index c = shape.loop_begin[shape.face_begin[f]]; c < shape.loop_begin[shape.face_begin[f + 1]]; ++c) {
        double& t = edge_tolerance[shape.coedges[c] / 2];
        t = std::max(t, face_tolerance[f]);
      }
    }
    for (Index e = 0; e < shape.edge_count(); ++e) {
      inherit(edge_tolerance[e], result.edge_parents[e], tolerance_of);
      for (const Index v : shape.edges[e]) vertex_tolerance[v] = std::max(vertex_tolerance[v], edge_tolerance[e]);
    }
    for (Index v = 0; v < pieces.points.size(); ++v) {
      inherit(vertex_tolerance[v], result.vertex_parents[v], tolerance_of);
      builder.add_vertex(pieces.points[v], vertex_tolerance[v]);
    }
    for (Index e = 0; e < shape.edge_count(); ++e)
      builder.add_edge(VertexId(shape.edges[e][0]), VertexId(shape.edges[e][1]), edge_tolerance[e]);

    std::map<std::pair<Index, Index>, SurfaceId> surfaces;
    for (Index f = 0; f < shape.face_count(); ++f) {
      const Parent& first = result.face_parents[f].front();
      const Model& model = *operands[first.source];
      const FaceGeometry& geometry = model.geometry(FaceId(first.entity.index));
      const auto [known, fresh] = surfaces.try_emplace({first.source, geometry.surface.value});
      if (fresh) known->second = builder.add_surface(model.surface(geometry.surface));
      // The pieces run as the first of the faces that they come from does; parents are sorted as the soup is.
      builder.begin_face(known->second, geometry.reversed, face_tolerance[f]);
      for (Index l = shape.face_begin[f]; l < shape.face_begin[f + 1]; ++l) {
        if (shape.loop_vertex[l] != Incidence::none) {
          builder.add_point_loop(VertexId(shape.loop_vertex[l]));
          continue;
        }
        for (Index c = shape.loop_begin[l]; c < shape.loop_begin[l + 1]; ++c)
          builder.add_coedge(EdgeId(shape.coedges[c] / 2), shape.coedges[c] % 2 == 1);
        builder.close_loop();
      }
      builder.end_face();
    }
    return result;
  }
};

}  // namespace

const FragmentEngine& planar_engine() {
  static const PlanarEngine engine;
  return engine;
}

}  // namespace aresta
