// SPDX-License-Identifier: Apache-2.0
#include "occt/shape.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "occt/errors.h"
#include "occt/guard.h"
#include "occt/shape_data.h"

namespace aresta {

ShapeCounts OcctShape::counts() const {
  ShapeCounts counts;
  if (null()) return counts;
  const auto distinct = [&](TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(data_->shape, kind, map);
    return map;
  };
  counts.solids = static_cast<std::size_t>(distinct(TopAbs_SOLID).Extent());
  counts.faces = static_cast<std::size_t>(distinct(TopAbs_FACE).Extent());
  counts.vertices = static_cast<std::size_t>(distinct(TopAbs_VERTEX).Extent());
  const auto edges = distinct(TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) {
    if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(i)))) ++counts.edges;
  }
  return counts;
}

Result<double> OcctShape::volume() const {
  if (null()) return 0.0;
  return guarded(errors::to_model_failed, "the volume of a shape", [&]() -> Result<double> {
    double sum = 0;
    for (TopExp_Explorer it(data_->shape, TopAbs_SOLID); it.More(); it.Next()) {
      GProp_GProps properties;
      BRepGProp::VolumeProperties(it.Current(), properties, 1e-9);
      sum += properties.Mass();
    }
    return sum;
  });
}

}  // namespace aresta
