// SPDX-License-Identifier: Apache-2.0
#include "model/copy.h"

namespace aresta {

ModelBuilder to_builder(const Model& model, const GeometryChanges& changes) {
  const Complex& k = model.topology();
  ModelBuilder copy;
  for (const VertexId v : k.vertices()) copy.add_vertex(model.point(v), model.tolerance(v));
  for (std::size_t c = 0; c < model.curve_count(); ++c) copy.add_curve(model.curve(CurveId(c)));
  for (std::size_t s = 0; s < model.surface_count(); ++s) copy.add_surface(model.surface(SurfaceId(s)));
  for (const EdgeId e : k.edges()) {
    const EdgeGeometry& g = model.geometry(e);
    const auto changed = changes.curves.find(e);
    if (changed == changes.curves.end()) {
      copy.add_edge(k.start(e), k.end(e), g.curve, g.range, g.tolerance);
    } else {
      const auto& [curve, range, deviation] = changed->second;
      copy.add_edge(k.start(e), k.end(e), copy.add_curve(curve), range, g.tolerance + deviation);
    }
  }
  for (const FaceId f : k.faces()) {
    const FaceGeometry& g = model.geometry(f);
    copy.begin_face(g.surface, g.reversed, g.tolerance);
    copy.set_constraint(g.constraint);
    for (const LoopId l : k.loops(f)) {
      if (k.is_vertex_loop(l)) {
        copy.add_point_loop(k.loop_vertex(l));
        continue;
      }
      for (const CoedgeId c : k.coedges(l)) {
        const auto changed = changes.images.find(c);
        const Curve2* image = changed != changes.images.end() ? &changed->second : model.pcurve(c);
        const bool stale = changed == changes.images.end() && changes.curves.contains(k.edge(c));
        if (image != nullptr && !stale) {
          copy.add_coedge(k.edge(c), k.reversed(c), *image);
        } else {
          copy.add_coedge(k.edge(c), k.reversed(c));
        }
      }
      copy.close_loop();
    }
    copy.end_face();
  }
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
