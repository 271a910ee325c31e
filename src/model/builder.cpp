// SPDX-License-Identifier: Apache-2.0
#include "model/builder.h"

#include <algorithm>

#include "model/cells.h"
#include "model/radial.h"
#include "topology/editor.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;
constexpr double relative_tolerance = 1e-9;  // of the box's diagonal

template <class T>
Pages<T> to_pages(const std::vector<T>& items) {
  Pages<T> pages;
  for (const T& item : items) pages.push_back(item);
  return pages;
}

/// Some radial order, as the coedges come. The largest number of uses that an edge has.
Result<std::size_t> link_coedges(Incidence& incidence, const std::vector<Vec3>& points) {
  for (std::uint32_t v = 0; v < incidence.vertex_count; ++v) {
    if (!is_finite(points[v]))
      return Error{errors::invalid_model, "a vertex has a coordinate that is not a finite number", {VertexId(v)}};
  }
  std::vector<std::uint32_t> last(incidence.edge_count(), none), first(incidence.edge_count(), none);
  std::vector<std::size_t> uses(incidence.edge_count(), 0);
  incidence.radial_next.assign(incidence.coedges.size(), none);
  std::size_t most = 0;
  for (std::uint32_t c = 0; c < incidence.coedges.size(); ++c) {
    const std::uint32_t e = incidence.coedges[c] >> 1;
    if (e >= incidence.edge_count()) return Error{errors::bad_incidence, "a loop names an edge that does not exist"};
    (last[e] == none ? first[e] : incidence.radial_next[last[e]]) = c;
    last[e] = c;
    most = std::max(most, ++uses[e]);
  }
  for (std::uint32_t e = 0; e < incidence.edge_count(); ++e) {
    if (last[e] != none) incidence.radial_next[last[e]] = first[e];
  }
  return most;
}

}  // namespace

VertexId ModelBuilder::add_vertex(Vec3 point, double tolerance_of_vertex) {
  points_.push_back(point);
  vertex_tolerance_.push_back(tolerance_of_vertex);
  return VertexId(incidence_.vertex_count++);
}

CurveId ModelBuilder::add_curve(Curve curve) {
  curves_.push_back(std::move(curve));
  return CurveId(curves_.size() - 1);
}

SurfaceId ModelBuilder::add_surface(Surface surface) {
  surfaces_.push_back(std::move(surface));
  return SurfaceId(surfaces_.size() - 1);
}

EdgeId ModelBuilder::add_edge(VertexId start, VertexId end, double tolerance_of_edge) {
  const double length = distance(points_[start.index()], points_[end.index()]);
  return add_edge(start, end, CurveId(), {0, length}, tolerance_of_edge);
}

EdgeId ModelBuilder::add_edge(VertexId start, VertexId end, CurveId curve, Range range, double tolerance_of_edge) {
  incidence_.edges.push_back({start.value, end.value});
  edge_geometry_.push_back({curve, range, tolerance_of_edge});
  return EdgeId(incidence_.edges.size() - 1);
}

FaceId ModelBuilder::begin_face(SurfaceId surface, bool reversed, double tolerance_of_face) {
  face_geometry_.push_back({surface, reversed, false, tolerance_of_face});
  fill_.push_back({Fill::unknown, Fill::unknown});
  return FaceId(face_geometry_.size() - 1);
}

void ModelBuilder::add_coedge(EdgeId edge, bool reversed) {
  incidence_.add_coedge(edge.value, reversed);
  coedge_pcurve_.push_back(none);
}

void ModelBuilder::add_coedge(EdgeId edge, bool reversed, Curve2 pcurve) {
  incidence_.add_coedge(edge.value, reversed);
  coedge_pcurve_.push_back(static_cast<std::uint32_t>(pcurves_.size()));
  pcurves_.push_back(std::move(pcurve));
}

void ModelBuilder::close_loop() {
  incidence_.close_loop();
}
void ModelBuilder::add_point_loop(VertexId vertex) {
  incidence_.add_vertex_loop(vertex.value);
}
void ModelBuilder::end_face() {
  incidence_.close_face();
}
void ModelBuilder::set_fill(Fill front, Fill back) {
  fill_.back() = {front, back};
}
void ModelBuilder::set_constraint(bool constraint) {
  face_geometry_.back().constraint = constraint;
}

void ModelBuilder::set_constraint(FaceId face, bool constraint) {
  face_geometry_[face.index()].constraint = constraint;
}

Result<Model> ModelBuilder::build(const Cells& cells, const std::vector<bool>& filled) {
  if (incidence_.radial_next.size() != incidence_.coedges.size()) {
    ARESTA_TRY(const std::size_t most_uses, link_coedges(incidence_, points_));
    if (most_uses > 2) {  // two uses have but one cyclic order
      ARESTA_TRY(const Model model, provisional());
      ARESTA_CHECK(order_radially(model, incidence_));
    }
  }
  incidence_.region_count = cells.count;
  incidence_.region_filled = filled;
  incidence_.face_use_region = cells.of_face_use;
  incidence_.edge_region = cells.of_edge;
  incidence_.vertex_region = cells.of_vertex;
  Model model;
  ARESTA_TRY(model.topology_, assemble(incidence_));
  model.points_ = to_pages(points_);
  model.vertex_tolerance_ = to_pages(vertex_tolerance_);
  model.edges_ = to_pages(edge_geometry_);
  model.faces_ = to_pages(face_geometry_);
  model.curves_ = curves_;
  model.surfaces_ = surfaces_;
  model.coedge_pcurve_ = to_pages(coedge_pcurve_);
  model.pcurves_ = pcurves_;
  model.labels = labels;
  model.provenance = provenance;
  model.length_unit = length_unit;
  model.tolerance_ = std::max(tolerance, relative_tolerance * model.bounds().diagonal());
  return model;
}

void ModelBuilder::fill(Model& model, const std::vector<bool>& filled) {
  Editor editor(model.topology_);
  for (std::size_t r = 1; r < filled.size(); ++r) editor.set_filled(RegionId(r), filled[r]);
}

Result<Model> ModelBuilder::provisional() {
  ARESTA_CHECK(link_coedges(incidence_, points_));
  Cells all_infinite;
  all_infinite.of_face_use.assign(2 * std::size_t{incidence_.face_count()}, 0);
  all_infinite.of_edge.assign(incidence_.edge_count(), 0);
  all_infinite.of_vertex.assign(incidence_.vertex_count, 0);
  for (const std::uint32_t code : incidence_.coedges) all_infinite.of_edge[code >> 1] = none;
  for (const auto& e : incidence_.edges) {
    for (const std::uint32_t v : e) {
      if (v < incidence_.vertex_count) all_infinite.of_vertex[v] = none;
    }
  }
  for (const std::uint32_t v : incidence_.loop_vertex) {
    if (v < incidence_.vertex_count) all_infinite.of_vertex[v] = none;
  }
  return build(all_infinite, {false});
}

Result<Cells> ModelBuilder::find_cells(const Context& context) {
  ARESTA_CHECK(context.step(0, "ordering faces around edges"));
  ARESTA_TRY(const Model model, provisional());
  ARESTA_CHECK(order_radially(model, incidence_));
  return aresta::find_cells(model, incidence_, context);
}

Result<Model> ModelBuilder::build(const Context& context) {
  ARESTA_TRY(const Cells cells, find_cells(context));
  std::vector<std::uint32_t> filled_by(cells.count, none), emptied_by(cells.count, none);
  for (std::uint32_t u = 0; u < cells.of_face_use.size(); ++u) {
    const Fill fill = fill_[u / 2][u % 2];
    const std::uint32_t cell = cells.of_face_use[u];
    if (fill == Fill::filled && filled_by[cell] == none) filled_by[cell] = u / 2;
    if (fill == Fill::empty && emptied_by[cell] == none) emptied_by[cell] = u / 2;
  }
  if (filled_by[0] != none) {
    return Error{errors::open_solid,
                 "the faces of a solid do not enclose it: it is open or turned inside out",
                 {FaceId(filled_by[0])}};
  }
  std::vector<bool> filled(cells.count, false);
  for (std::uint32_t c = 1; c < cells.count; ++c) {
    if (filled_by[c] != none && emptied_by[c] != none) {
      return Error{errors::ambiguous_fill,
                   "one enclosed space is material for one of its faces and empty for another",
                   {FaceId(filled_by[c]), FaceId(emptied_by[c])}};
    }
    filled[c] = filled_by[c] != none;
  }
  return build(cells, filled);
}

}  // namespace aresta
