// SPDX-License-Identifier: Apache-2.0
#include "occt/shape_reader.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepClass3d.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/occt_handles.h"
#include "occt/errors.h"
#include "occt/face_loops.h"

namespace aresta {

namespace {

Vec3 to_vec(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}

Error bad(const std::string& message, Vec3 place) {
  return Error{errors::to_model_failed, message, {}, {{place.x, place.y, place.z}}};
}

class Reader {
 public:
  Reader(const TopoDS_Shape& shape, ModelBuilder& builder, ShapeMaps& maps, const Context& context)
      : shape_(shape), builder_(builder), maps_(maps), context_(context) {}

  Status run() {
    ARESTA_CHECK(context_.step(0, "reading a shape"));
    ARESTA_CHECK(prepare());
    fill_maps();
    ARESTA_CHECK(find_all_loops());
    measure();
    ARESTA_CHECK(add_vertices());
    ARESTA_CHECK(add_edges());
    find_solids();
    return add_faces();
  }

 private:
  Status prepare() {
    TopTools_IndexedMapOfShape faces, edges;
    TopExp::MapShapes(shape_, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) ARESTA_CHECK(bound(TopoDS::Face(faces(i))));
    TopExp::MapShapes(shape_, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(i));
      if (BRep_Tool::Degenerated(edge)) continue;
      double low = 0, high = 0;
      if (BRep_Tool::Curve(edge, low, high).IsNull() && !BRepLib::BuildCurve3d(edge)) {
        return bad("an edge has no curve and none can be built from its images", some_point(edge));
      }
      if (!BRep_Tool::SameRange(edge)) BRepLib::SameRange(edge);
      if (!BRep_Tool::SameParameter(edge)) BRepLib::SameParameter(edge, BRep_Tool::Tolerance(edge));
    }
    return {};
  }

  static Vec3 some_point(const TopoDS_Shape& shape) {
    TopExp_Explorer it(shape, TopAbs_VERTEX);
    return it.More() ? to_vec(BRep_Tool::Pnt(TopoDS::Vertex(it.Current()))) : Vec3{};
  }

  // A face without wires is the whole of a closed surface: it gets seams.
  static Status bound(const TopoDS_Face& face) {
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
      if (it.Value().ShapeType() == TopAbs_WIRE && it.Value().Orientation() != TopAbs_INTERNAL) return {};
    }
    TopLoc_Location location;
    TopoDS_Face plain = TopoDS::Face(face.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD));
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(plain, location);
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    if (!surface.IsNull()) surface->Bounds(u0, u1, v0, v1);
    const bool finite = !Precision::IsInfinite(u0) && !Precision::IsInfinite(u1) && !Precision::IsInfinite(v0) &&
                        !Precision::IsInfinite(v1);
    if (surface.IsNull() || !finite || !location.IsIdentity()) {
      return Error{errors::to_model_failed, "a face without a boundary lies on a surface that is not closed"};
    }
    const BRepBuilderAPI_MakeFace whole(surface, Precision::Confusion());
    BRep_Builder build;
    plain.Free(Standard_True);
    for (TopoDS_Iterator it(whole.Face()); it.More(); it.Next()) build.Add(plain, it.Value());
    return {};
  }

  void fill_maps() {
    TopTools_IndexedMapOfShape all_edges;
    TopExp::MapShapes(shape_, TopAbs_VERTEX, maps_.vertices);
    TopExp::MapShapes(shape_, TopAbs_EDGE, all_edges);
    for (int i = 1; i <= all_edges.Extent(); ++i) {
      if (!BRep_Tool::Degenerated(TopoDS::Edge(all_edges(i)))) maps_.edges.Add(all_edges(i));
    }
    TopExp::MapShapes(shape_, TopAbs_FACE, maps_.faces);
    TopExp::MapShapes(shape_, TopAbs_SOLID, maps_.solids);
  }

  Status find_all_loops() {
    const int n = maps_.faces.Extent();
    loops_.resize(static_cast<std::size_t>(n));
    for (int i = 1; i <= n; ++i) {
      if (i % 64 == 1) ARESTA_CHECK(context_.step(0.7 * i / n, "reading faces"));
      auto loops = find_face_loops(TopoDS::Face(maps_.faces(i)), maps_.vertices, maps_.edges);
      if (!loops.ok()) {
        Error error = std::move(loops).error();
        error.entities.insert(error.entities.begin(), FaceId(static_cast<std::size_t>(i - 1)));
        return error;
      }
      loops_[static_cast<std::size_t>(i - 1)] = std::move(loops).value();
    }
    return {};
  }

  // How far images lie off their curves, and curve ends and surfaces off the vertices.
  void measure() {
    const auto edge_count = static_cast<std::size_t>(maps_.edges.Extent());
    edge_off_.assign(edge_count, 0);
    vertex_off_.assign(static_cast<std::size_t>(maps_.vertices.Extent()), 0);
    plane_only_.assign(edge_count, true);
    for (int i = 1; i <= maps_.faces.Extent(); ++i) {
      const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(maps_.faces(i)));
      const Surface form = from_occt(surface);
      const Plane* plane = form.get_if<Plane>();
      for (const FaceLoop& loop : loops_[static_cast<std::size_t>(i - 1)]) {
        for (const LoopEdge& use : loop.edges) {
          const auto e = static_cast<std::size_t>(use.edge - 1);
          if (plane == nullptr) plane_only_[e] = false;
          double low = 0, high = 0;
          const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(maps_.edges(use.edge)), low, high);
          const auto off = [&](double t) {
            const Vec3 p = to_vec(curve->Value(t));
            if (plane != nullptr) return std::abs(dot(p - plane->frame.origin, cross(plane->frame.x, plane->frame.y)));
            const gp_Pnt2d uv = use.image->Value(t);
            return distance(p, to_vec(surface->Value(uv.X(), uv.Y())));
          };
          const bool straight = plane != nullptr && from_occt(curve).is_line();
          edge_off_[e] = std::max(edge_off_[e], greatest(off, low, high, straight ? 1 : 40));
        }
        if (loop.vertex > 0) {
          auto& off = vertex_off_[static_cast<std::size_t>(loop.vertex - 1)];
          off = std::max(off, form.project(point(loop.vertex)).distance);
        }
      }
    }
    Bnd_Box box;
    BRepBndLib::Add(shape_, box, Standard_False);
    negligible_ = box.IsVoid() ? 0 : 5e-10 * std::sqrt(box.SquareExtent());
  }

  /// The greatest value of f: of samples, then by halving around the greatest of them.
  template <class Function>
  static double greatest(const Function& f, double low, double high, int samples) {
    double best = 0, at = low, step = (high - low) / samples;
    for (int i = 0; i <= samples; ++i) {
      const double t = low + step * i, value = f(t);
      if (value > best) {
        best = value;
        at = t;
      }
    }
    if (samples < 2 || best == 0) return best;
    for (int i = 0; i < 12; ++i) {
      step *= 0.5;
      for (const double t : {at - step, at + step}) {
        if (t < low || t > high) continue;
        const double value = f(t);
        if (value <= best) continue;
        best = value;
        at = t;
      }
    }
    return best;
  }

  Vec3 point(int vertex) const { return to_vec(BRep_Tool::Pnt(TopoDS::Vertex(maps_.vertices(vertex)))); }

  /// What a measured deviation means as a tolerance: a little more, since the greatest one may lie between samples.
  double tolerance(double measured, double stated) const {
    if (measured <= negligible_) return 0;
    return std::max(1.1 * measured, std::min(1.5 * measured, stated));
  }

  Status add_vertices() {
    // Ends of edges first: they may widen the vertices' tolerances.
    ends_.resize(static_cast<std::size_t>(maps_.edges.Extent()));
    for (int i = 1; i <= maps_.edges.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(maps_.edges(i).Oriented(TopAbs_FORWARD));
      TopoDS_Vertex first, last;
      TopExp::Vertices(edge, first, last);
      if (first.IsNull() || last.IsNull()) return bad("an edge has no end vertices", some_point(edge));
      for (TopoDS_Iterator it(edge); it.More(); it.Next()) {
        const TopAbs_Orientation o = it.Value().Orientation();
        if (o == TopAbs_INTERNAL || o == TopAbs_EXTERNAL)
          return bad("an edge has a vertex in its middle that does not divide it", some_point(it.Value()));
      }
      double low = 0, high = 0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, low, high);
      if (Precision::IsInfinite(low) || Precision::IsInfinite(high) || !(high > low))
        return bad("an edge has no finite piece of its curve", some_point(edge));
      auto& ends = ends_[static_cast<std::size_t>(i - 1)];
      ends = {maps_.vertices.FindIndex(first), maps_.vertices.FindIndex(last)};
      for (int end = 0; end < 2; ++end) {
        const double off =
            distance(point(ends[static_cast<std::size_t>(end)]), to_vec(curve->Value(end == 0 ? low : high)));
        auto& vertex = vertex_off_[static_cast<std::size_t>(ends[static_cast<std::size_t>(end)] - 1)];
        vertex = std::max(vertex, off);
        if (off > negligible_) plane_only_[static_cast<std::size_t>(i - 1)] = false;
      }
    }
    for (int i = 1; i <= maps_.edges.Extent(); ++i) {
      const double t = edge_tolerance(i);
      for (const int v : ends_[static_cast<std::size_t>(i - 1)]) {
        auto& off = vertex_off_[static_cast<std::size_t>(v - 1)];
        off = std::max(off, t);
      }
    }
    for (int i = 1; i <= maps_.vertices.Extent(); ++i) {
      const Vec3 p = point(i);
      if (!is_finite(p)) return bad("a vertex has a coordinate that is not a finite number", {});
      builder_.add_vertex(p, tolerance(vertex_off_[static_cast<std::size_t>(i - 1)],
                                       BRep_Tool::Tolerance(TopoDS::Vertex(maps_.vertices(i)))));
    }
    return {};
  }

  double edge_tolerance(int i) const {
    return tolerance(edge_off_[static_cast<std::size_t>(i - 1)], BRep_Tool::Tolerance(TopoDS::Edge(maps_.edges(i))));
  }

  Status add_edges() {
    std::map<const void*, CurveId> curves;  // only looked up, never walked through
    for (int i = 1; i <= maps_.edges.Extent(); ++i) {
      double low = 0, high = 0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(maps_.edges(i)), low, high);
      const auto& ends = ends_[static_cast<std::size_t>(i - 1)];
      const VertexId start(static_cast<std::size_t>(ends[0] - 1)), end(static_cast<std::size_t>(ends[1] - 1));
      const Curve form = from_occt(curve);
      if (form.is_line() && plane_only_[static_cast<std::size_t>(i - 1)] && start != end) {
        builder_.add_edge(start, end, edge_tolerance(i));
        continue;
      }
      auto [found, is_new] = curves.try_emplace(curve.get());
      if (is_new) found->second = builder_.add_curve(form);
      kept_.push_back(curve);
      builder_.add_edge(start, end, found->second, {low, high}, edge_tolerance(i));
    }
    return {};
  }

  void find_solids() {
    fills_.assign(2 * static_cast<std::size_t>(maps_.faces.Extent()), Fill::unknown);
    maps_.sides.resize(static_cast<std::size_t>(maps_.solids.Extent()));
    for (int s = 1; s <= maps_.solids.Extent(); ++s) {
      SolidSides& sides = maps_.sides[static_cast<std::size_t>(s - 1)];
      const TopoDS_Shape solid = maps_.solids(s).Oriented(TopAbs_FORWARD);
      const TopoDS_Shell outer = BRepClass3d::OuterShell(TopoDS::Solid(solid));
      for (TopoDS_Iterator it(solid); it.More(); it.Next()) {
        VoidSides shell{it.Value(), {}};
        for (TopExp_Explorer face(it.Value(), TopAbs_FACE); face.More(); face.Next()) {
          const int i = maps_.faces.FindIndex(face.Current());
          const TopAbs_Orientation here = face.Current().Orientation();
          const bool as_kept = (here == TopAbs_REVERSED) == is_reversed(i);
          const FaceId id(static_cast<std::size_t>(i - 1));
          if (here == TopAbs_INTERNAL) {
            fills_[FaceUse(id, 0).index()] = fills_[FaceUse(id, 1).index()] = Fill::filled;
          } else if (here != TopAbs_EXTERNAL) {
            const FaceUse inside(id, as_kept ? 1 : 0);
            sides.inside.push_back(inside);
            fills_[inside.index()] = Fill::filled;
            if (fills_[inside.opposite().index()] == Fill::unknown) fills_[inside.opposite().index()] = Fill::empty;
            shell.outside.push_back(inside.opposite());
          }
        }
        if (!it.Value().IsSame(outer) && !shell.outside.empty()) sides.voids.push_back(std::move(shell));
      }
    }
  }

  bool is_reversed(int face) const { return maps_.faces(face).Orientation() == TopAbs_REVERSED; }

  Status add_faces() {
    std::map<const void*, SurfaceId> surfaces;  // only looked up
    const int n = maps_.faces.Extent();
    for (int i = 1; i <= n; ++i) {
      if (i % 64 == 1) ARESTA_CHECK(context_.step(0.7 + 0.3 * i / n, "reading faces"));
      const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(maps_.faces(i)));
      auto [found, is_new] = surfaces.try_emplace(surface.get());
      if (is_new) {
        found->second = builder_.add_surface(from_occt(surface));
        kept_.push_back(surface);
      }
      const bool reversed = is_reversed(i);
      builder_.begin_face(found->second, reversed, 0);
      for (FaceLoop& loop : loops_[static_cast<std::size_t>(i - 1)]) {
        if (loop.vertex > 0) {
          builder_.add_point_loop(VertexId(static_cast<std::size_t>(loop.vertex - 1)));
          continue;
        }
        if (reversed) std::reverse(loop.edges.begin(), loop.edges.end());
        for (const LoopEdge& use : loop.edges) {
          const EdgeId edge(static_cast<std::size_t>(use.edge - 1));
          if (use.image.IsNull()) {
            builder_.add_coedge(edge, use.reversed != reversed);
          } else {
            builder_.add_coedge(edge, use.reversed != reversed, from_occt(use.image));
          }
        }
        builder_.close_loop();
      }
      builder_.end_face();
      builder_.set_fill(fills_[2 * static_cast<std::size_t>(i - 1)], fills_[2 * static_cast<std::size_t>(i - 1) + 1]);
    }
    return {};
  }

  TopoDS_Shape shape_;
  ModelBuilder& builder_;
  ShapeMaps& maps_;
  const Context& context_;
  std::vector<std::vector<FaceLoop>> loops_;
  std::vector<double> edge_off_, vertex_off_;
  std::vector<bool> plane_only_;  // straight and on planes: needs no curve of its own
  double negligible_ = 0;
  std::vector<std::array<int, 2>> ends_;
  std::vector<Fill> fills_;
  std::vector<Handle(Standard_Transient)> kept_;  // so that no address is used twice
};

}  // namespace

Status read_shape(const TopoDS_Shape& shape, ModelBuilder& builder, ShapeMaps& maps, const Context& context) {
  return Reader(shape, builder, maps, context).run();
}

}  // namespace aresta
