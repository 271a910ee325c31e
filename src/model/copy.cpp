// SPDX-License-Identifier: Apache-2.0
#include "model/copy.h"

#include <algorithm>

namespace aresta {

namespace {

/// What new surfaces add to the tolerances of edges and vertices.
struct Slack {
  std::vector<double> edges, vertices;

  Slack(const Complex& k, const GeometryChanges& changes) : edges(k.edge_count(), 0), vertices(k.vertex_count(), 0) {
    for (const auto& [f, changed] : changes.surfaces) {
      for (const LoopId l : k.loops(f)) {
        if (k.is_vertex_loop(l)) {
          widen(vertices[k.loop_vertex(l).index()], changed.deviation);
          continue;
        }
        for (const CoedgeId c : k.coedges(l)) widen(edges[k.edge(c).index()], changed.deviation);
      }
    }
    for (const EdgeId e : k.edges()) {
      double here = edges[e.index()];
      if (const auto changed = changes.curves.find(e); changed != changes.curves.end()) {
        here += changed->second.deviation;
      }
      widen(vertices[k.start(e).index()], here);
      widen(vertices[k.end(e).index()], here);
    }
  }

 private:
  static void widen(double& slack, double by) { slack = std::max(slack, by); }
};

}  // namespace

void append(ModelBuilder& copy, const Model& model, const GeometryChanges& changes) {
  const Complex& k = model.topology();
  const std::size_t vertices = copy.vertex_count(), edges = copy.edge_count();
  const std::size_t curves = copy.curve_count(), surfaces = copy.surface_count();
  const auto moved = [](auto id, std::size_t by) { return id.valid() ? decltype(id)(id.index() + by) : id; };
  const Slack slack(k, changes);
  for (const VertexId v : k.vertices()) {
    copy.add_vertex(model.point(v), model.tolerance(v) + slack.vertices[v.index()]);
  }
  for (std::size_t c = 0; c < model.curve_count(); ++c) copy.add_curve(model.curve(CurveId(c)));
  for (std::size_t s = 0; s < model.surface_count(); ++s) copy.add_surface(model.surface(SurfaceId(s)));
  for (const EdgeId e : k.edges()) {
    const EdgeGeometry& g = model.geometry(e);
    const auto changed = changes.curves.find(e);
    if (changed == changes.curves.end()) {
      copy.add_edge(moved(k.start(e), vertices), moved(k.end(e), vertices), moved(g.curve, curves), g.range,
                    g.tolerance + slack.edges[e.index()]);
    } else {
      const auto& [curve, range, deviation] = changed->second;
      copy.add_edge(moved(k.start(e), vertices), moved(k.end(e), vertices), copy.add_curve(curve), range,
                    g.tolerance + deviation + slack.edges[e.index()]);
    }
  }
  for (const FaceId f : k.faces()) {
    const FaceGeometry& g = model.geometry(f);
    const auto new_surface = changes.surfaces.find(f);
    const bool has_new_surface = new_surface != changes.surfaces.end();
    if (has_new_surface) {
      const auto& [surface, turned, deviation] = new_surface->second;
      copy.begin_face(copy.add_surface(surface), g.reversed != turned, g.tolerance + deviation);
    } else {
      copy.begin_face(moved(g.surface, surfaces), g.reversed, g.tolerance);
    }
    copy.set_constraint(g.constraint);
    for (const LoopId l : k.loops(f)) {
      if (k.is_vertex_loop(l)) {
        copy.add_point_loop(moved(k.loop_vertex(l), vertices));
        continue;
      }
      for (const CoedgeId c : k.coedges(l)) {
        const auto changed = changes.images.find(c);
        const Curve2* image = changed != changes.images.end() ? &changed->second : model.pcurve(c);
        const bool stale = changed == changes.images.end() && (has_new_surface || changes.curves.contains(k.edge(c)));
        if (image != nullptr && !stale) {
          copy.add_coedge(moved(k.edge(c), edges), k.reversed(c), *image);
        } else {
          copy.add_coedge(moved(k.edge(c), edges), k.reversed(c));
        }
      }
      copy.close_loop();
    }
    copy.end_face();
  }
}

ModelBuilder to_builder(const Model& model, const GeometryChanges& changes) {
  ModelBuilder copy;
  append(copy, model, changes);
  copy.labels = model.labels;
  copy.length_unit = model.length_unit;
  copy.tolerance = model.tolerance();
  return copy;
}

Result<Model> with_geometry(const Model& model, const GeometryChanges& changes) {
  const Complex& k = model.topology();
  ModelBuilder copy = to_builder(model, changes);
  copy.provenance = model.provenance;
  // The builder numbers coedges loop by loop; so does every model that was built, but nothing promises it.
  std::vector<CoedgeId> order;
  std::vector<std::uint32_t> position(k.coedge_count());
  for (const FaceId f : k.faces()) {
    for (const LoopId l : k.loops(f)) {
      for (const CoedgeId c : k.coedges(l)) {
        position[c.index()] = static_cast<std::uint32_t>(order.size());
        order.push_back(c);
      }
    }
  }
  std::vector<std::uint32_t> radial;
  for (const CoedgeId c : order) radial.push_back(position[k.radial(c).index()]);
  copy.set_radial_order(std::move(radial));

  Cells cells;
  cells.count = static_cast<std::uint32_t>(k.region_count());
  std::vector<bool> filled(k.region_count());
  for (const RegionId r : k.regions()) filled[r.index()] = k.is_filled(r);
  for (const FaceId f : k.faces()) {
    for (int side = 0; side < 2; ++side) cells.of_face_use.push_back(k.region(FaceUse(f, side)).value);
  }
  for (const EdgeId e : k.edges())
    cells.of_edge.push_back(k.is_wire(e) ? k.region(k.wire_shell(e)).value : Incidence::none);
  for (const VertexId v : k.vertices()) {
    const ShellId s = k.isolated_in_shell(v);
    cells.of_vertex.push_back(s.valid() ? k.region(s).value : Incidence::none);
  }
  return copy.build(cells, filled);
}

}  // namespace aresta
