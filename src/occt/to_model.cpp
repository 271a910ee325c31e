// SPDX-License-Identifier: Apache-2.0
#include "occt/to_model.h"

#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "model/query.h"
#include "occt/errors.h"
#include "occt/guard.h"
#include "occt/shape_data.h"
#include "occt/shape_reader.h"

namespace aresta {

namespace {

gp_Pnt to_pnt(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// A point in the solid's material: a little behind one of its faces.
Result<Vec3> point_inside(const Model& model, const SolidSides& sides, BRepClass3d_SolidClassifier& solid,
                          double size) {
  for (const FaceUse use : sides.inside) {
    const auto uv = FaceTrim(model, use.face()).interior_point();
    if (!uv.ok()) continue;
    const Vec3 normal = model.normal(use.face(), *uv), inwards = use.side() == 0 ? normal : -normal;
    for (double step = 0.03 * size; step > 1e-6 * size; step *= 0.2) {
      const Vec3 p = model.surface(use.face()).point(*uv) + step * inwards;
      solid.Perform(to_pnt(p), Precision::Confusion());
      if (solid.State() == TopAbs_IN) return p;
    }
  }
  return Error{errors::to_model_failed, "no point is found inside a solid", {sides.inside.front().face()}};
}

/// Cells taken from what the solids themselves say, for solids that touch without sharing anything: where one lies
/// among the others cannot be asked by rays there. Each solid is one cell, each void one more; what surrounds a solid
/// is the void around it, or infinite space.
class SolidCells {
 public:
  SolidCells(const Model& model, const ShapeMaps& maps, const Context& context)
      : model_(model), maps_(maps), context_(context) {}

  Status run() {
    const std::size_t n = maps_.sides.size();
    for (std::size_t s = 0; s < n; ++s) {
      ARESTA_CHECK(context_.step(static_cast<double>(s) / static_cast<double>(n), "looking at solids one by one"));
      ARESTA_CHECK(require_closed(s));
      solids_.emplace_back(solid(s));
      BRepBndLib::Add(solid(s), boxes_.emplace_back(), Standard_False);
      auto p = point_inside(model_, maps_.sides[s], solids_.back(), std::sqrt(boxes_.back().SquareExtent()));
      if (!p.ok()) return std::move(p).error();
      inner_.push_back(*p);
    }
    ARESTA_CHECK(require_apart());
    number();
    return {};
  }

  Cells cells;
  std::vector<bool> filled;

 private:
  TopoDS_Shape solid(std::size_t s) const { return maps_.solids(static_cast<int>(s) + 1).Oriented(TopAbs_FORWARD); }

  /// At each edge as many of the solid's sides run one way as the other, and they enclose a positive volume.
  Status require_closed(std::size_t s) const {
    const Complex& k = model_.topology();
    std::map<EdgeId, int> balance;
    for (const FaceUse use : maps_.sides[s].inside) {
      for (const LoopId l : k.loops(use.face())) {
        for (const CoedgeId c : k.coedges(l)) balance[k.edge(c)] += k.reversed(c) == (use.side() == 0) ? 1 : -1;
      }
    }
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid(s), properties);
    const bool closed = std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
    if (closed && properties.Mass() > 0) return {};
    return Error{errors::open_solid,
                 "the faces of a solid do not enclose it: it is open or turned inside out",
                 {maps_.sides[s].inside.front().face()}};
  }

  Status require_apart() {
    for (std::size_t s = 0; s < inner_.size(); ++s) {
      for (std::size_t other = 0; other < inner_.size(); ++other) {
        const gp_Pnt p = to_pnt(inner_[other]);
        if (other == s || boxes_[s].IsOut(p)) continue;
        solids_[s].Perform(p, Precision::Confusion());
        if (solids_[s].State() == TopAbs_OUT) continue;
        return Error{errors::solids_overlap,
                     "one solid lies in the material of another",
                     {maps_.sides[s].inside.front().face(), maps_.sides[other].inside.front().face()},
                     {{p.X(), p.Y(), p.Z()}},
                     "read the solids one by one and fragment them"};
      }
    }
    return {};
  }

  void number() {
    const std::size_t n = maps_.sides.size();
    cells.of_face_use.assign(2 * model_.topology().face_count(), 0);
    cells.of_edge.assign(model_.topology().edge_count(), Incidence::none);
    cells.of_vertex.assign(model_.topology().vertex_count(), Incidence::none);
    cells.count = 1 + static_cast<std::uint32_t>(n);
    filled.assign(cells.count, true);
    filled[0] = false;
    const std::vector<std::uint32_t> around = find_surroundings();
    for (std::size_t s = 0; s < n; ++s) {
      for (const FaceUse use : maps_.sides[s].inside) cells.of_face_use[use.opposite().index()] = around[s];
    }
    std::size_t next = 0;
    for (const SolidSides& sides : maps_.sides) {
      for (const VoidSides& hollow : sides.voids) {
        for (const FaceUse use : hollow.outside) cells.of_face_use[use.index()] = void_cell_[next];
        ++next;
      }
    }
    for (std::size_t s = 0; s < n; ++s) {  // last: what is material on one side is material
      for (const FaceUse use : maps_.sides[s].inside) {
        cells.of_face_use[use.index()] = static_cast<std::uint32_t>(s) + 1;
      }
    }
  }

  static double volume_of(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
  }

  /// Per solid the cell of the smallest void that holds it, else 0. Gives the voids their cells; a void that solids
  /// fill wholly leaves no space for one, and its sides count as outside.
  std::vector<std::uint32_t> find_surroundings() {
    constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
    std::vector<std::size_t> holder(inner_.size(), nowhere);
    std::vector<double> volumes, left;
    for (std::size_t s = 0; s < inner_.size(); ++s) {
      for (const VoidSides& hollow : maps_.sides[s].voids) {
        TopoDS_Solid space;
        BRep_Builder build;
        build.MakeSolid(space);
        build.Add(space, hollow.shell.Reversed());
        volumes.push_back(volume_of(space));
        BRepClass3d_SolidClassifier classifier(space);
        for (std::size_t other = 0; other < inner_.size(); ++other) {
          if (other == s || (holder[other] != nowhere && volumes[holder[other]] <= volumes.back())) continue;
          classifier.Perform(to_pnt(inner_[other]), Precision::Confusion());
          if (classifier.State() == TopAbs_IN) holder[other] = volumes.size() - 1;
        }
      }
    }
    left = volumes;
    for (std::size_t s = 0; s < inner_.size(); ++s) {
      if (holder[s] == nowhere) continue;
      double whole = volume_of(solid(s));
      for (const VoidSides& hollow : maps_.sides[s].voids) whole += std::abs(volume_of(hollow.shell));
      left[holder[s]] -= whole;
    }
    for (std::size_t v = 0; v < volumes.size(); ++v) {
      const bool is_filled = left[v] <= 1e-5 * volumes[v];
      void_cell_.push_back(is_filled ? 0 : cells.count++);
      if (!is_filled) filled.push_back(false);
    }
    std::vector<std::uint32_t> around(inner_.size(), 0);
    for (std::size_t s = 0; s < inner_.size(); ++s) {
      if (holder[s] != nowhere) around[s] = void_cell_[holder[s]];
    }
    return around;
  }

  const Model& model_;
  const ShapeMaps& maps_;
  const Context& context_;
  std::deque<BRepClass3d_SolidClassifier> solids_;
  std::vector<Bnd_Box> boxes_;
  std::vector<Vec3> inner_;
  std::vector<std::uint32_t> void_cell_;  // per void, solid after solid
};

bool only_solids(const ShapeMaps& maps, std::size_t face_count) {
  std::vector<bool> used(face_count, false);
  for (const SolidSides& sides : maps.sides) {
    if (sides.inside.empty()) return false;
    for (const FaceUse use : sides.inside) used[use.face().index()] = true;
  }
  return !maps.sides.empty() && std::all_of(used.begin(), used.end(), [](bool b) { return b; });
}

/// Everything in infinite space: enough to ask for geometry.
Result<Model> build_unplaced(ModelBuilder& builder, const ShapeMaps& maps) {
  Cells cells;
  cells.of_face_use.assign(2 * builder.face_count(), 0);
  cells.of_edge.assign(static_cast<std::size_t>(maps.edges.Extent()), Incidence::none);
  cells.of_vertex.assign(static_cast<std::size_t>(maps.vertices.Extent()), Incidence::none);
  return builder.build(cells, {false});
}

}  // namespace

Result<ModelOfShape> to_model(const OcctShape& shape, const ToModelOptions& options, const Context& context) {
  if (shape.null()) return Error{errors::to_model_failed, "there is no shape"};
  return guarded(errors::to_model_failed, "converting a shape", [&]() -> Result<ModelOfShape> {
    auto data = std::make_shared<ModelOfShape::Data>();
    ModelBuilder builder;
    builder.length_unit = options.length_unit;
    builder.tolerance = options.tolerance;
    ARESTA_CHECK(read_shape(shape.data().shape, builder, data->maps, context));
    Result<Model> built = builder.build(context);
    const bool nesting =
        !built.ok() && (built.error().code == errors::nesting_failed || built.error().code == errors::ambiguous_fill ||
                        built.error().code == errors::open_solid);
    if (nesting && only_solids(data->maps, builder.face_count())) {
      ARESTA_TRY(const Model unplaced, build_unplaced(builder, data->maps));
      SolidCells by_solids(unplaced, data->maps, context);
      ARESTA_CHECK(by_solids.run());
      built = builder.build(by_solids.cells, by_solids.filled);
    }
    if (!built.ok()) return std::move(built).error();
    const Complex& k = built->topology();
    for (const SolidSides& sides : data->maps.sides) {
      data->regions.push_back(sides.inside.empty() ? RegionId() : k.region(sides.inside.front()));
    }
    return ModelOfShape(std::move(built).value(), std::move(data));
  });
}

EntityRef ModelOfShape::entity_of(const OcctShape& subshape) const {
  if (subshape.null()) return {};
  const TopoDS_Shape& shape = subshape.data().shape;
  const auto id = [&](const TopTools_IndexedMapOfShape& map) {
    return static_cast<std::uint32_t>(map.FindIndex(shape) - 1);
  };
  switch (shape.ShapeType()) {
    case TopAbs_VERTEX:
      return {EntityKind::vertex, id(data_->maps.vertices)};
    case TopAbs_EDGE:
      return {EntityKind::edge, id(data_->maps.edges)};
    case TopAbs_FACE:
      return {EntityKind::face, id(data_->maps.faces)};
    case TopAbs_SOLID: {
      const std::uint32_t i = id(data_->maps.solids);
      return i == Incidence::none ? EntityRef(RegionId()) : EntityRef(data_->regions[i]);
    }
    default:
      return {};
  }
}

}  // namespace aresta
