// SPDX-License-Identifier: Apache-2.0
// Building a model from vertices, edges and faces: radial order, shells, nesting and regions are found here.
//
// Guarantees: entity i added becomes the entity with id i. Every enclosed cell of space is found, with its voids,
// internal sheets, wires and points. What is not guaranteed: that faces do not cross each other; fragment first if they
// may.
//
// Method: faces around an edge are ordered by their tangent directions, ties by curvature (radial.h); sides of faces
// that share a sector are one component; a component of positive enclosed volume opens a cell, every other component,
// wire and point is put into the smallest cell around it by ray casting (cells.h). Weiler 1986; Arruda 2005.
#pragma once

#include "base/context.h"
#include "model/model.h"
#include "topology/assemble.h"
#include "topology/cells.h"

namespace aresta {

/// What a caller knows about the space on a side of a face.
enum class Fill : std::uint8_t { unknown, filled, empty };

class ModelBuilder {
 public:
  VertexId add_vertex(Vec3 point, double tolerance = 0);
  CurveId add_curve(Curve curve);
  SurfaceId add_surface(Surface surface);

  /// A straight segment.
  EdgeId add_edge(VertexId start, VertexId end, double tolerance = 0);
  EdgeId add_edge(VertexId start, VertexId end, CurveId curve, Range range, double tolerance = 0);

  // A face: begin_face, then per loop its coedges and close_loop (outer loop first), then end_face.
  // Loops run counterclockwise seen from the face's normal.
  FaceId begin_face(SurfaceId surface, bool reversed, double tolerance = 0);
  void add_coedge(EdgeId edge, bool reversed);
  void add_coedge(EdgeId edge, bool reversed, Curve2 pcurve);
  void close_loop();
  void add_point_loop(VertexId vertex);
  void end_face();
  /// For the face begun or ended last: what lies on its front and back side, and whether it is a constraint.
  void set_fill(Fill front, Fill back);
  void set_constraint(bool constraint);
  void set_constraint(FaceId face, bool constraint);

  Labels labels;
  std::shared_ptr<const Provenance> provenance;
  double length_unit = 1e-3;
  double tolerance = 0;  ///< asked for; see Model::tolerance

  std::size_t vertex_count() const { return points_.size(); }
  std::size_t edge_count() const { return edge_geometry_.size(); }
  std::size_t face_count() const { return face_geometry_.size(); }
  std::size_t curve_count() const { return curves_.size(); }
  std::size_t surface_count() const { return surfaces_.size(); }

  /// The radial order, when the caller knows it (one entry per coedge added, in that order); find_cells finds it
  /// itself.
  void set_radial_order(std::vector<std::uint32_t> radial_next) { incidence_.radial_next = std::move(radial_next); }

  /// The cells of all faces added. Errors: bad_incidence, ambiguous_radial_order, nesting_failed, cancelled.
  Result<Cells> find_cells(const Context& context);

  /// The model with given cells; filled[c] says which cells are regions ([0] must be false). Finds the radial order
  /// unless it is known.
  Result<Model> build(const Cells& cells, const std::vector<bool>& filled);

  /// Says afterwards which finite cells of a built model are regions.
  static void fill(Model& model, const std::vector<bool>& filled);

  /// find_cells, then fills by what set_fill said: a cell is filled when one of its sides was said to be; sides that
  /// disagree are an error (ambiguous_fill), so is a filled infinite cell (open_solid). Region ids follow the order of
  /// their first face-use.
  Result<Model> build(const Context& context);

  /// Everything in infinite space and any radial order: enough to ask for geometry by loops, also while entities still
  /// meet unshared.
  Result<Model> provisional();

 private:
  Incidence incidence_;
  std::vector<Vec3> points_;
  std::vector<double> vertex_tolerance_;
  std::vector<EdgeGeometry> edge_geometry_;
  std::vector<FaceGeometry> face_geometry_;
  std::vector<std::array<Fill, 2>> fill_;
  std::vector<Curve> curves_;
  std::vector<Surface> surfaces_;
  std::vector<std::uint32_t> coedge_pcurve_;
  std::vector<Curve2> pcurves_;
};

}  // namespace aresta
