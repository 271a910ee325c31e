// SPDX-License-Identifier: Apache-2.0
#include "occt/tessellate.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "occt/errors.h"
#include "occt/guard.h"
#include "occt/model_shape.h"

namespace aresta {

namespace {

Vec3 to_vec(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}

class Tessellator {
 public:
  Tessellator(const Model& model, const TessellationOptions& options, const Context& context)
      : model_(model), k_(model.topology()), context_(context) {
    const Box3 box = model.bounds();
    deflection_ = options.deflection > 0 ? options.deflection : 1e-3 * (box.empty() ? 1 : box.diagonal());
    angle_ = std::clamp(options.angle, 0.1, 60.0) * std::numbers::pi / 180;
  }

  Result<Tessellation> run() {
    ToShapeOptions plain;
    plain.solids = false;
    ARESTA_TRY(const ModelShape made, to_shape(model_, plain, context_));
    const ModelShape::Data& shapes = made.data();
    ARESTA_CHECK(triangulate(shapes));
    out_.faces.resize(k_.face_count());
    out_.edges.resize(k_.edge_count());
    for (const FaceId f : k_.faces()) {
      if (f.index() % 64 == 0) ARESTA_CHECK(context_.step(0.9, "collecting triangles"));
      ARESTA_CHECK(take_face(f, shapes));
    }
    for (const EdgeId e : k_.edges()) {
      if (out_.edges[e.index()].empty()) take_wire(e, shapes.edges[e.index()]);
    }
    return std::move(out_);
  }

 private:
  IMeshTools_Parameters parameters(double factor) const {
    IMeshTools_Parameters p;
    p.Deflection = deflection_ * factor;
    p.DeflectionInterior = p.Deflection;
    p.Angle = angle_;
    p.AngleInterior = 2 * angle_;
    p.Relative = Standard_False;
    p.InParallel = Standard_False;
    p.MinSize = 1e-3 * p.Deflection;
    return p;
  }

  Status triangulate(const ModelShape::Data& shapes) {
    if (k_.face_count() == 0) return {};
    // A second and third look, finer, at everything: the mesher's failures depend on the size, and points of shared
    // edges must stay shared.
    FaceId missing;
    for (const double factor : {1.0, 0.5, 0.2}) {
      if (factor < 1) forget(shapes);
      Handle(ContextIndicator) progress = new ContextIndicator(context_, "triangulating", 0, 0.9);
      BRepMesh_IncrementalMesh mesher;
      mesher.SetShape(shapes.whole);
      mesher.ChangeParameters() = parameters(factor);
      mesher.Perform(progress->Start());
      ARESTA_CHECK(context_.step(0.9, "triangulating"));
      missing = FaceId();
      for (const FaceId f : k_.faces()) {
        TopLoc_Location location;
        const auto triangles = BRep_Tool::Triangulation(shapes.faces[f.index()], location);
        if (triangles.IsNull() || triangles->NbTriangles() == 0) {
          missing = f;
          break;
        }
      }
      if (!missing.valid()) return {};
    }
    const Vec3 p = model_.bounds(missing).low;
    return Error{errors::tessellation_failed,
                 "a face cannot be triangulated for display",
                 {missing},
                 {{p.x, p.y, p.z}},
                 "check the face; another deflection"};
  }

  static void forget(const ModelShape::Data& shapes) {
    BRep_Builder build;
    for (const TopoDS_Face& face : shapes.faces) build.UpdateFace(face, Handle(Poly_Triangulation)());
  }

  Status take_face(FaceId f, const ModelShape::Data& shapes) {
    const TopoDS_Face& face = shapes.faces[f.index()];
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    FaceTriangles& out = out_.faces[f.index()];
    for (int i = 1; i <= mesh->NbNodes(); ++i) {
      out.points.push_back(to_vec(mesh->Node(i)));
      Vec2 uv{};
      if (mesh->HasUVNodes()) {
        const gp_Pnt2d image = mesh->UVNode(i);
        uv = {image.X(), image.Y()};
      } else {
        uv = model_.surface(f).project(out.points.back()).uv;
      }
      out.images.push_back(uv);
      out.normals.push_back(model_.normal(f, uv));
    }
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      mesh->Triangle(i).Get(a, b, c);
      if (model_.is_reversed(f)) std::swap(b, c);
      out.triangles.push_back(
          {static_cast<std::uint32_t>(a - 1), static_cast<std::uint32_t>(b - 1), static_cast<std::uint32_t>(c - 1)});
    }
    mend_normals(out);
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) ARESTA_CHECK(take_edge(f, c, shapes, mesh, location, out));
    }
    return {};
  }

  // At a singular point the surface may have no normal: that of a triangle there serves.
  static void mend_normals(FaceTriangles& out) {
    for (const auto& t : out.triangles) {
      const Vec3 n = normalized(cross(out.points[t[1]] - out.points[t[0]], out.points[t[2]] - out.points[t[0]]));
      for (const std::uint32_t i : t) {
        if (norm2(out.normals[i]) == 0) out.normals[i] = n;
      }
    }
  }

  Status take_edge(FaceId f, CoedgeId c, const ModelShape::Data& shapes, const Handle(Poly_Triangulation) & mesh,
                   const TopLoc_Location& location, FaceTriangles& out) {
    const EdgeId e = k_.edge(c);
    TopoDS_Edge edge = shapes.edges[e.index()];
    // Of a seam's two polygons the sense of the edge in the face, seen along the surface's normal, chooses.
    if (k_.reversed(c) != model_.is_reversed(f)) edge.Reverse();
    const auto polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
    if (polygon.IsNull() || polygon->NbNodes() < 2) {
      return Error{errors::tessellation_failed, "an edge has no points in the triangles of its face", {f, e}};
    }
    const int n = polygon->NbNodes();
    std::vector<Vec3>& line = out_.edges[e.index()];
    if (line.empty()) {
      for (int i = 1; i <= n; ++i) line.push_back(to_vec(mesh->Node(polygon->Node(i))));
      line.front() = model_.point(k_.start(e));
      line.back() = model_.point(k_.end(e));
    }
    if (static_cast<int>(line.size()) != n) {
      return Error{errors::tessellation_failed, "two faces divide a shared edge differently", {f, e}};
    }
    for (int i = 1; i <= n; ++i) {
      out.points[static_cast<std::size_t>(polygon->Node(i) - 1)] = line[static_cast<std::size_t>(i - 1)];
    }
    return {};
  }

  void take_wire(EdgeId e, const TopoDS_Edge& edge) {
    std::vector<Vec3>& line = out_.edges[e.index()];
    if (model_.is_straight(e)) {
      line = {model_.point(k_.start(e)), model_.point(k_.end(e))};
      return;
    }
    const BRepAdaptor_Curve curve(edge);
    const GCPnts_TangentialDeflection points(curve, angle_, deflection_, 2);
    for (int i = 1; i <= points.NbPoints(); ++i) line.push_back(to_vec(points.Value(i)));
    line.front() = model_.point(k_.start(e));
    line.back() = model_.point(k_.end(e));
  }

  const Model& model_;
  const Complex& k_;
  const Context& context_;
  double deflection_ = 0, angle_ = 0;
  Tessellation out_;
};

}  // namespace

Result<Tessellation> tessellate(const Model& model, const TessellationOptions& options, const Context& context) {
  return guarded(errors::tessellation_failed, "triangulating a model",
                 [&]() -> Result<Tessellation> { return Tessellator(model, options, context).run(); });
}

}  // namespace aresta
