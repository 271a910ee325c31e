// SPDX-License-Identifier: Apache-2.0
#include "occt/fuse_checks.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <IntTools_Context.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <map>

#include "occt/errors.h"

namespace aresta {

namespace {

Error coincide(const std::string& what, const gp_Pnt& p) {
  return Error{errors::general_fuse_failed, what, {}, {{p.X(), p.Y(), p.Z()}}, "a larger --tolerance"};
}

gp_Pnt point(const ShapeMaps& maps, int v) {
  return BRep_Tool::Pnt(TopoDS::Vertex(maps.vertices(v)));
}

Status distinct_vertices(const ShapeMaps& maps, double tolerance) {
  std::vector<int> order(static_cast<std::size_t>(maps.vertices.Extent()));
  std::vector<gp_Pnt> at;
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = static_cast<int>(i);
    at.push_back(point(maps, static_cast<int>(i) + 1));
  }
  const auto x = [&](int i) { return at[static_cast<std::size_t>(i)].X(); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return x(a) != x(b) ? x(a) < x(b) : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && x(order[j]) - x(order[i]) <= tolerance; ++j) {
      const gp_Pnt &a = at[static_cast<std::size_t>(order[i])], &b = at[static_cast<std::size_t>(order[j])];
      if (a.Distance(b) <= tolerance)
        return coincide("two vertices are left closer to each other than the tolerance", a);
    }
  }
  return {};
}

bool on_curve(const TopoDS_Edge& edge, const gp_Pnt& p, double tolerance) {
  double low = 0, high = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, low, high);
  const GeomAPI_ProjectPointOnCurve projection(p, curve, low, high);
  return projection.NbPoints() > 0 && projection.LowerDistance() <= tolerance;
}

Status distinct_edges(const ShapeMaps& maps, double tolerance) {
  std::map<std::pair<int, int>, std::vector<int>> between;
  for (int e = 1; e <= maps.edges.Extent(); ++e) {
    TopoDS_Vertex a, b;
    TopExp::Vertices(TopoDS::Edge(maps.edges(e)), a, b);
    const int first = maps.vertices.FindIndex(a), last = maps.vertices.FindIndex(b);
    between[std::minmax(first, last)].push_back(e);
  }
  for (const auto& [ends, group] : between) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(maps.edges(group[i]));
      double low = 0, high = 0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, low, high);
      for (std::size_t j = i + 1; j < group.size(); ++j) {
        const TopoDS_Edge other = TopoDS::Edge(maps.edges(group[j]));
        const double allowed = std::max({tolerance, BRep_Tool::Tolerance(edge), BRep_Tool::Tolerance(other)});
        bool along = true;
        for (const double share : {0.5, 0.3, 0.8}) {
          along = along && on_curve(other, curve->Value(low + share * (high - low)), allowed);
        }
        if (along) return coincide("two edges are left lying on each other", curve->Value(0.5 * (low + high)));
      }
    }
  }
  return {};
}

Status distinct_faces(const ShapeMaps& maps, double tolerance) {
  std::map<std::vector<int>, std::vector<int>> with_edges;
  for (int f = 1; f <= maps.faces.Extent(); ++f) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(maps.faces(f), TopAbs_EDGE, edges);
    std::vector<int> key;
    for (int e = 1; e <= edges.Extent(); ++e) {
      if (const int id = maps.edges.FindIndex(edges(e)); id > 0) key.push_back(id);
    }
    std::sort(key.begin(), key.end());
    with_edges[key].push_back(f);
  }
  const Handle(IntTools_Context) tools = new IntTools_Context;
  for (const auto& [key, group] : with_edges) {
    for (std::size_t i = 0; i + 1 < group.size(); ++i) {
      const TopoDS_Face face = TopoDS::Face(maps.faces(group[i]));
      gp_Pnt p;
      gp_Pnt2d uv;
      if (BOPTools_AlgoTools3D::PointInFace(face, p, uv, tools) != 0) {
        return coincide("a face is left that is thinner than the tolerance", point(maps, 1));
      }
      for (std::size_t j = i + 1; j < group.size(); ++j) {
        const TopoDS_Face other = TopoDS::Face(maps.faces(group[j]));
        const double allowed = std::max({tolerance, BRep_Tool::Tolerance(face), BRep_Tool::Tolerance(other)});
        if (tools->IsValidPointForFace(p, other, allowed)) return coincide("two faces are left lying on each other", p);
      }
    }
  }
  return {};
}

}  // namespace

Status require_distinct(const ShapeMaps& maps, double tolerance) {
  const double least = std::max(tolerance, Precision::Confusion());
  ARESTA_CHECK(distinct_vertices(maps, tolerance));
  ARESTA_CHECK(distinct_edges(maps, least));
  return distinct_faces(maps, least);
}

}  // namespace aresta
