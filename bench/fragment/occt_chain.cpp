// SPDX-License-Identifier: Apache-2.0
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <map>
#include <stdexcept>

#include "fragment/peers.h"

namespace aresta::bench {

namespace {

TopoDS_Solid to_solid(const PolygonMesh& mesh) {
  std::vector<TopoDS_Vertex> vertices;
  for (const Vec3 p : mesh.points) vertices.push_back(BRepBuilderAPI_MakeVertex(gp_Pnt(p.x, p.y, p.z)).Vertex());
  std::map<std::array<std::uint32_t, 2>, TopoDS_Edge> edges;
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const auto& corners : mesh.faces) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
      TopoDS_Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
      if (edge.IsNull()) edge = BRepBuilderAPI_MakeEdge(vertices[std::min(a, b)], vertices[std::max(a, b)]).Edge();
      wire.Add(a < b ? edge : TopoDS::Edge(edge.Reversed()));
    }
    builder.Add(shell, BRepBuilderAPI_MakeFace(wire.Wire(), true).Face());
  }
  shell.Closed(true);
  return BRepBuilderAPI_MakeSolid(shell).Solid();
}

TopoDS_Shape apply(BRepAlgoAPI_BooleanOperation&& operation, const TopoDS_Shape& first,
                   const TopTools_ListOfShape& others) {
  TopTools_ListOfShape arguments;
  arguments.Append(first);
  operation.SetArguments(arguments);
  operation.SetTools(others);
  operation.SetRunParallel(false);
  operation.SetUseOBB(true);
  operation.Build();
  if (operation.HasErrors()) throw std::runtime_error("BRepAlgoAPI has errors");
  return operation.Shape();
}

}  // namespace

Answer chain_with_occt(const Chain& chain) {
  const TopoDS_Shape first = to_solid(chain.first);
  std::vector<TopTools_ListOfShape> steps;
  for (const auto& step : chain.steps) {
    auto& solids = steps.emplace_back();
    for (const PolygonMesh& mesh : step) solids.Append(to_solid(mesh));
  }
  Answer answer;
  const TopoDS_Shape result = timed(answer.seconds, [&] {
    TopoDS_Shape shape = first;
    for (const auto& step : steps)
      shape = chain.is_difference ? apply(BRepAlgoAPI_Cut(), shape, step) : apply(BRepAlgoAPI_Fuse(), shape, step);
    return shape;
  });
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(result, TopAbs_SOLID, solids);
  answer.cells = static_cast<std::uint64_t>(solids.Extent());
  GProp_GProps moments;
  BRepGProp::VolumeProperties(result, moments);
  answer.volume = answer.solid_volume = moments.Mass();
  return answer;
}

}  // namespace aresta::bench
