// SPDX-License-Identifier: Apache-2.0
// Shapes made by the kernel library itself, and what to compare.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <initializer_list>
#include <string>

#include "model/model.h"
#include "occt/shape_data.h"
#include "occt/to_model.h"
#include "occt/to_shape.h"

namespace aresta::test {

inline TopoDS_Compound compound(std::initializer_list<TopoDS_Shape> shapes) {
  TopoDS_Compound all;
  BRep_Builder build;
  build.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) build.Add(all, shape);
  return all;
}

inline TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

inline TopoDS_Face polygon(std::initializer_list<gp_Pnt> points) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& p : points) wire.Add(p);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Face();
}

inline TopoDS_Edge segment(const gp_Pnt& a, const gp_Pnt& b) {
  return BRepBuilderAPI_MakeEdge(a, b).Edge();
}

inline std::string counts(const Model& model) {
  const Complex& k = model.topology();
  return std::to_string(model.regions().size()) + "/" + std::to_string(k.face_count()) + "/" +
         std::to_string(k.edge_count()) + "/" + std::to_string(k.vertex_count());
}

inline std::string counts(const OcctShape& shape) {
  const ShapeCounts c = shape.counts();
  return std::to_string(c.solids) + "/" + std::to_string(c.faces) + "/" + std::to_string(c.edges) + "/" +
         std::to_string(c.vertices);
}

inline std::string text(const Error& error) {
  return error.to_line();
}

}  // namespace aresta::test
