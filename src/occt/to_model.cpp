// SPDX-License-Identifier: Apache-2.0
#include "occt/to_model.h"

#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>

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

/// Does some solid have a point of another one's inside in its own?
Status require_apart(const Model& model, const ShapeMaps& maps, const Context& context) {
  const int n = maps.solids.Extent();
  std::vector<Bnd_Box> boxes(static_cast<std::size_t>(n) + 1);
  std::vector<Vec3> inner(static_cast<std::size_t>(n) + 1);
  for (int s = 1; s <= n; ++s) {
    BRepBndLib::Add(maps.solids(s), boxes[static_cast<std::size_t>(s)], Standard_False);
    const FaceUse use = maps.sides[static_cast<std::size_t>(s - 1)].inside.front();
    ARESTA_TRY(inner[static_cast<std::size_t>(s)], interior_point(model, model.topology().region(use)));
  }
  for (int s = 1; s <= n; ++s) {
    ARESTA_CHECK(context.step(static_cast<double>(s) / n, "looking for overlapping solids"));
    BRepClass3d_SolidClassifier classifier(maps.solids(s).Oriented(TopAbs_FORWARD));
    for (int other = 1; other <= n; ++other) {
      if (other == s) continue;
      const Vec3 p = inner[static_cast<std::size_t>(other)];
      if (boxes[static_cast<std::size_t>(s)].IsOut(gp_Pnt(p.x, p.y, p.z))) continue;
      classifier.Perform(gp_Pnt(p.x, p.y, p.z), Precision::Confusion());
      if (classifier.State() == TopAbs_OUT) continue;
      const auto region = [&](int i) {
        return model.topology().region(maps.sides[static_cast<std::size_t>(i - 1)].inside.front());
      };
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
