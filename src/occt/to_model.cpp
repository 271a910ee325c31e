// SPDX-License-Identifier: Apache-2.0
#include "occt/to_model.h"

#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "model/query.h"
#include "occt/errors.h"
#include "occt/guard.h"
#include "occt/shape_data.h"
#include "occt/shape_reader.h"

namespace aresta {

namespace {

/// Cells as the solids say: one per solid, everything else infinite space. For solids without voids, and nothing else.
Cells cells_of_solids(const ShapeMaps& maps, std::size_t face_count, std::vector<bool>& filled) {
  Cells cells;
  cells.count = 1 + static_cast<std::uint32_t>(maps.sides.size());
  cells.of_face_use.assign(2 * face_count, 0);
  for (std::size_t s = 0; s < maps.sides.size(); ++s) {
    for (const FaceUse use : maps.sides[s].inside) cells.of_face_use[use.index()] = static_cast<std::uint32_t>(s + 1);
  }
  cells.of_edge.assign(static_cast<std::size_t>(maps.edges.Extent()), Incidence::none);
  cells.of_vertex.assign(static_cast<std::size_t>(maps.vertices.Extent()), Incidence::none);
  filled.assign(cells.count, true);
  filled[0] = false;
  return cells;
}

bool only_solids(const ShapeMaps& maps, std::size_t face_count) {
  std::vector<bool> used(face_count, false);
  for (const SolidSides& sides : maps.sides) {
    if (sides.has_voids) return false;
    for (const FaceUse use : sides.inside) used[use.face().index()] = true;
  }
  return !maps.sides.empty() && std::all_of(used.begin(), used.end(), [](bool b) { return b; });
}

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
  return Error{
      errors::to_model_failed, "no point is found inside a solid", {model.topology().region(sides.inside.front())}};
}

/// Does some solid have a point of another one's inside in its own?
Status require_apart(const Model& model, const ShapeMaps& maps, const Context& context) {
  const std::size_t n = maps.sides.size();
  std::vector<Bnd_Box> boxes(n);
  std::vector<Vec3> inner(n);
  const auto solid = [&](std::size_t s) { return maps.solids(static_cast<int>(s) + 1).Oriented(TopAbs_FORWARD); };
  for (std::size_t s = 0; s < n; ++s) {
    BRepBndLib::Add(solid(s), boxes[s], Standard_False);
    BRepClass3d_SolidClassifier classifier(solid(s));
    ARESTA_TRY(inner[s], point_inside(model, maps.sides[s], classifier, std::sqrt(boxes[s].SquareExtent())));
  }
  for (std::size_t s = 0; s < n; ++s) {
    ARESTA_CHECK(context.step(static_cast<double>(s) / static_cast<double>(n), "looking for overlapping solids"));
    BRepClass3d_SolidClassifier classifier(solid(s));
    for (std::size_t other = 0; other < n; ++other) {
      const Vec3 p = inner[other];
      if (other == s || boxes[s].IsOut(to_pnt(p))) continue;
      classifier.Perform(to_pnt(p), Precision::Confusion());
      if (classifier.State() == TopAbs_OUT) continue;
      const auto region = [&](std::size_t i) { return model.topology().region(maps.sides[i].inside.front()); };
      return Error{errors::solids_overlap,
                   "one solid lies in the material of another",
                   {region(s), region(other)},
                   {{p.x, p.y, p.z}},
                   "read the solids one by one and fragment them"};
    }
  }
  return {};
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
        !built.ok() && (built.error().code == errors::nesting_failed || built.error().code == errors::ambiguous_fill);
    if (nesting && only_solids(data->maps, builder.face_count())) {
      // Solids that touch without sharing: where one lies among the others cannot be asked, and need not be.
      std::vector<bool> filled;
      const Cells cells = cells_of_solids(data->maps, builder.face_count(), filled);
      built = builder.build(cells, filled);
      if (built.ok()) ARESTA_CHECK(require_apart(*built, data->maps, context));
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
