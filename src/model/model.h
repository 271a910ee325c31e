// SPDX-License-Identifier: Apache-2.0
// A model: a radial edge complex with geometry bound to it. Immutable in shape; labels (names, attributes, groups)
// change.
//
// Conventions
//   edge     its curve over `range`; the curve runs from the edge's start (range.low) to its end (range.high). An edge
//            without a curve of its own is the straight segment between its vertices, parametrised by length from its
//            start.
//   face     a piece of its surface; the face's normal is the surface's natural normal, turned round when `reversed`.
//   pcurve   image of a coedge in its face's surface, with the edge's parameters (for t in the edge's range,
//            surface(pcurve(t)) = curve(t) within tolerance). Planes need none. A seam's two coedges have one each.
//            Where a surface side degenerates to a point (pole, apex) no edge exists; consecutive images leave a gap
//            there.
//   tolerance  an absolute length: the geometry of the entity is known to lie this close to that of its neighbours.
// Lengths are in document units (length_unit metres each).
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "geometry/curve.h"
#include "geometry/curve2.h"
#include "geometry/surface.h"
#include "topology/complex.h"

namespace aresta {

namespace errors {  // model: 400-499
inline constexpr ErrorCode invalid_model{400, "model.invalid"};
inline constexpr ErrorCode unknown_entity{401, "model.unknown_entity"};
inline constexpr ErrorCode open_solid{402, "model.open_solid"};
inline constexpr ErrorCode ambiguous_fill{403, "model.ambiguous_fill"};
inline constexpr ErrorCode ambiguous_radial_order{404, "model.ambiguous_radial_order"};
inline constexpr ErrorCode nesting_failed{405, "model.nesting"};
inline constexpr ErrorCode measure_failed{406, "model.measure"};
}  // namespace errors

using AttributeValue = std::variant<bool, double, std::string>;

struct Group {
  std::string name;
  std::vector<EntityRef> entities;  ///< sorted, no duplicates
};

/// Everything attached to entities that is neither shape nor history. Attribute "name" is the entity's name and "color"
/// its colour as "#rrggbb".
struct Labels {
  std::map<EntityRef, std::map<std::string, AttributeValue>> attributes;
  std::vector<Group> groups;

  /// Empty when it has none.
  std::string name(EntityRef entity) const;
  void set_name(EntityRef entity, const std::string& name) { attributes[entity]["name"] = name; }
};

class Model;

/// An entity that an entity came from: `source` indexes Provenance::sources.
struct Parent {
  std::uint32_t source = 0;
  EntityRef entity;
  constexpr auto operator<=>(const Parent&) const = default;
};

/// For every entity of a result the entities of the sources that it came from (sorted): a piece of a face has that
/// face, a face that two operands share has both, a vertex where an edge pierces a face has the edge and the face.
struct Provenance {
  std::vector<std::shared_ptr<const Model>> sources;
  std::map<EntityRef, std::vector<Parent>> parents;

  std::span<const Parent> of(EntityRef entity) const;
  /// The entities of the result that came from `parent` and have its dimension, sorted.
  std::vector<EntityRef> images(Parent parent) const;
};

struct EdgeGeometry {
  CurveId curve;  ///< invalid: a straight segment
  Range range;
  double tolerance = 0;
};

struct FaceGeometry {
  SurfaceId surface;
  bool reversed = false;
  bool constraint = false;  ///< a face kept by a boolean that bounded no listed region: listed later, bounding nothing
  double tolerance = 0;
};

class Model {
 public:
  const Complex& topology() const { return topology_; }

  // Geometry.
  Vec3 point(VertexId v) const { return points_[v.index()]; }
  Curve curve(EdgeId e) const;
  const EdgeGeometry& geometry(EdgeId e) const { return edges_[e.index()]; }
  Range range(EdgeId e) const { return edges_[e.index()].range; }
  bool is_straight(EdgeId e) const;
  Vec3 edge_point(EdgeId e, double t) const;
  CurveJet edge_jet(EdgeId e, double t) const;
  const FaceGeometry& geometry(FaceId f) const { return faces_[f.index()]; }
  const Surface& surface(FaceId f) const { return surfaces_[faces_[f.index()].surface.index()]; }
  bool is_reversed(FaceId f) const { return faces_[f.index()].reversed; }
  bool is_constraint(FaceId f) const { return faces_[f.index()].constraint; }
  /// Null where none is stored (planes).
  const Curve2* pcurve(CoedgeId c) const;
  /// The image of the coedge's point at edge parameter t in the parameter plane of its face.
  Vec2 uv(CoedgeId c, double t) const;
  /// Unit normal of the face (reversal applied).
  Vec3 normal(FaceId f, Vec2 uv) const;

  double tolerance(VertexId v) const { return vertex_tolerance_[v.index()]; }
  double tolerance(EdgeId e) const { return edges_[e.index()].tolerance; }
  double tolerance(FaceId f) const { return faces_[f.index()].tolerance; }
  /// The model's own: points closer than this are one. The larger of 1e-9 of the box's diagonal and what was asked for.
  double tolerance() const { return tolerance_; }

  const Curve& curve(CurveId c) const { return curves_[c.index()]; }
  const Surface& surface(SurfaceId s) const { return surfaces_[s.index()]; }
  std::size_t curve_count() const { return curves_.size(); }
  std::size_t surface_count() const { return surfaces_.size(); }
  /// Straight edges and plane faces only?
  bool is_planar() const;

  // Boxes: contain the entity, tight for analytic forms.
  Box3 bounds(EdgeId e) const;
  Box3 bounds(FaceId f) const;
  Box3 bounds() const;

  // What users call regions: finite and filled.
  std::vector<RegionId> regions() const;
  bool is_region(RegionId r) const { return r.valid() && r != Complex::infinite_region() && topology_.is_filled(r); }

  /// Every entity the whole model lists: regions, constraint faces and faces that bound no region, wire edges, isolated
  /// vertices. Their downward closure is the whole model.
  std::vector<EntityRef> listed() const;

  Labels labels;
  std::shared_ptr<const Provenance> provenance;  ///< may be null
  double length_unit = 1e-3;                     ///< metres per document unit

 private:
  friend class ModelBuilder;

  Complex topology_;
  Pages<Vec3> points_;
  Pages<double> vertex_tolerance_;
  Pages<EdgeGeometry> edges_;
  Pages<FaceGeometry> faces_;
  std::vector<Curve> curves_;
  std::vector<Surface> surfaces_;
  Pages<std::uint32_t> coedge_pcurve_;  // index into pcurves_, or none
  std::vector<Curve2> pcurves_;
  double tolerance_ = 0;
};

}  // namespace aresta
