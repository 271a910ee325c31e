// SPDX-License-Identifier: Apache-2.0
#include "occt/to_shape.h"

#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Geom_Surface.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/union_find.h"
#include "geometry/occt_handles.h"
#include "occt/errors.h"
#include "occt/guard.h"
#include "occt/model_shape.h"
#include "occt/shape_data.h"

namespace aresta {

namespace {

constexpr double least_tolerance = 1e-7;  // the library's own: Precision::Confusion()
constexpr std::uint32_t none = 0xffffffffu;

gp_Pnt to_pnt(Vec3 p) {
  return {p.x, p.y, p.z};
}

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// A coedge in the sense of its surface's natural normal.
struct Use {
  CoedgeId coedge;
  bool reversed = false;
};

class ShapeMaker {
 public:
  ShapeMaker(const Model& model, const ToShapeOptions& options, const Context& context)
      : model_(model), k_(model.topology()), options_(options), context_(context) {}

  Result<std::shared_ptr<const ModelShape::Data>> run() {
    find_tolerances();
    make_vertices();
    ARESTA_CHECK(make_edges());
    ARESTA_CHECK(make_faces());
    make_regions();
    make_whole();
    return std::shared_ptr<const ModelShape::Data>(std::make_shared<ModelShape::Data>(std::move(out_)));
  }

 private:
  void find_tolerances() {
    face_tolerance_.resize(k_.face_count());
    edge_tolerance_.resize(k_.edge_count());
    vertex_tolerance_.resize(k_.vertex_count());
    for (const FaceId f : k_.faces()) face_tolerance_[f.index()] = std::max(least_tolerance, model_.tolerance(f));
    for (const EdgeId e : k_.edges()) edge_tolerance_[e.index()] = std::max(least_tolerance, model_.tolerance(e));
    for (const CoedgeId c : k_.coedges()) {
      auto& t = edge_tolerance_[k_.edge(c).index()];
      t = std::max(t, face_tolerance_[k_.face(c).index()]);
    }
    for (const VertexId v : k_.vertices())
      vertex_tolerance_[v.index()] = std::max(least_tolerance, model_.tolerance(v));
    for (const LoopId l : k_.loops()) {
      if (!k_.is_vertex_loop(l)) continue;
      auto& t = vertex_tolerance_[k_.loop_vertex(l).index()];
      t = std::max(t, face_tolerance_[k_.face(l).index()]);
    }
    for (const EdgeId e : k_.edges()) {
      for (int end = 0; end < 2; ++end) {
        const VertexId v = k_.vertex(EdgeEnd{e, end});
        const Range range = model_.range(e);
        const double off = distance(model_.point(v), model_.edge_point(e, end == 0 ? range.low : range.high));
        auto& t = vertex_tolerance_[v.index()];
        t = std::max({t, edge_tolerance_[e.index()], off * (1 + 1e-9)});
      }
    }
  }

  void make_vertices() {
    out_.vertices.resize(k_.vertex_count());
    for (const VertexId v : k_.vertices()) {
      build_.MakeVertex(out_.vertices[v.index()], to_pnt(model_.point(v)), vertex_tolerance_[v.index()]);
    }
  }

  Status make_edges() {
    out_.edges.resize(k_.edge_count());
    for (const EdgeId e : k_.edges()) {
      const Range range = model_.range(e);
      if (!(range.length() > 0)) {
        return Error{errors::to_shape_failed,
                     "an edge without length cannot be converted",
                     {e},
                     as_array(model_.point(k_.start(e)))};
      }
      TopoDS_Edge& edge = out_.edges[e.index()];
      build_.MakeEdge(edge, curve_of(e), edge_tolerance_[e.index()]);
      build_.Range(edge, range.low, range.high);
      build_.Add(edge, out_.vertices[k_.start(e).index()].Oriented(TopAbs_FORWARD));
      build_.Add(edge, out_.vertices[k_.end(e).index()].Oriented(TopAbs_REVERSED));
      edge.Closed(k_.is_closed(e));
    }
    return {};
  }

  Handle(Geom_Curve) curve_of(EdgeId e) {
    const CurveId id = model_.geometry(e).curve;
    if (!id.valid()) return to_occt(model_.curve(e));
    auto& handle = curves_[id.value];
    if (handle.IsNull()) handle = to_occt(model_.curve(e));
    return handle;
  }

  // Images are kept by edge and surface object: two faces on one object that share an edge need two objects.
  Handle(Geom_Surface) surface_of(FaceId f) {
    const SurfaceId id = model_.geometry(f).surface;
    auto& handle = surfaces_[id.value];
    if (handle.IsNull()) handle = to_occt(model_.surface(f));
    if (model_.surface(f).is_plane()) return handle;
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) {
        for (const CoedgeId other : k_.coedges(k_.edge(c))) {
          if (k_.face(other) != f && model_.geometry(k_.face(other)).surface == id) {
            return Handle(Geom_Surface)::DownCast(handle->Copy());
          }
        }
      }
    }
    return handle;
  }

  Status make_faces() {
    out_.faces.resize(k_.face_count());
    in_face_.assign(k_.edge_count(), none);
    first_use_.assign(k_.edge_count(), CoedgeId());
    for (const FaceId f : k_.faces()) {
      if (f.index() % 64 == 0) {
        ARESTA_CHECK(
            context_.step(static_cast<double>(f.index()) / static_cast<double>(k_.face_count()), "converting faces"));
      }
      ARESTA_CHECK(make_face(f));
    }
    return {};
  }

  Status make_face(FaceId f) {
    TopoDS_Face face;
    build_.MakeFace(face, surface_of(f), face_tolerance_[f.index()]);
    const bool flip = model_.is_reversed(f);
    std::vector<std::vector<Use>> wires;
    std::vector<EdgeId> inner;
    for (const LoopId l : k_.loops(f)) {
      if (k_.is_vertex_loop(l)) {
        build_.Add(face, out_.vertices[k_.loop_vertex(l).index()].Oriented(TopAbs_INTERNAL));
        continue;
      }
      collect_images(f, l, flip, inner);
      split_loop(l, flip, wires);
    }
    ARESTA_CHECK(set_images(f, face));
    for (const auto& wire : wires) ARESTA_CHECK(add_wire(f, face, wire));
    add_inner(face, inner);
    if (flip) face.Reverse();
    out_.faces[f.index()] = face;
    return {};
  }

  /// Do the images of the two coedges of one edge in one face lie a turn apart?
  bool is_seam(CoedgeId a, CoedgeId b) const {
    const Surface& surface = model_.surface(k_.face(a));
    if (surface.is_plane()) return false;
    const double t = model_.range(k_.edge(a)).middle();
    const Vec2 apart = model_.uv(a, t) - model_.uv(b, t);
    const Vec2 period = surface.period();
    const Range2 domain = surface.domain();
    const double whole_u = period.x > 0 ? period.x : domain.u.length();
    const double whole_v = period.y > 0 ? period.y : domain.v.length();
    return std::abs(apart.x) > 0.25 * whole_u || std::abs(apart.y) > 0.25 * whole_v;
  }

  /// Notes the edges of a loop: single ones, seams, and inner ones (used twice with one image).
  void collect_images(FaceId f, LoopId l, bool flip, std::vector<EdgeId>& inner) {
    for (const CoedgeId c : k_.coedges(l)) {
      const EdgeId e = k_.edge(c);
      if (in_face_[e.index()] != f.value) {
        in_face_[e.index()] = f.value;
        first_use_[e.index()] = c;
        single_.push_back(c);
        continue;
      }
      const CoedgeId other = first_use_[e.index()];
      std::erase(single_, other);
      if (is_seam(c, other)) {
        const bool c_forward = k_.reversed(c) == flip;
        seams_.emplace_back(c_forward ? c : other, c_forward ? other : c);
      } else {
        inner.push_back(e);
        inner_images_.push_back(other);
      }
    }
  }

  Status set_images(FaceId f, const TopoDS_Face& face) {
    Status status;
    if (!model_.surface(f).is_plane()) {
      for (const CoedgeId c : single_) {
        if (status.ok()) status = set_image(f, face, c);
      }
      for (const CoedgeId c : inner_images_) {
        if (status.ok()) status = set_image(f, face, c);
      }
      for (const auto& [forward, backward] : seams_) {
        if (!status.ok()) break;
        const Curve2 *a = model_.pcurve(forward), *b = model_.pcurve(backward);
        const EdgeId e = k_.edge(forward);
        if (a == nullptr || b == nullptr) {
          status = Error{errors::to_shape_failed, "a seam lacks its images in the face's parameters", {f, e}};
          break;
        }
        build_.UpdateEdge(out_.edges[e.index()], to_occt(*a), to_occt(*b), face, edge_tolerance_[e.index()]);
        build_.Continuity(out_.edges[e.index()], face, face, GeomAbs_CN);
      }
    }
    single_.clear();
    inner_images_.clear();
    seams_.clear();
    return status;
  }

  Status set_image(FaceId f, const TopoDS_Face& face, CoedgeId c) {
    const EdgeId e = k_.edge(c);
    if (const Curve2* image = model_.pcurve(c)) {
      build_.UpdateEdge(out_.edges[e.index()], to_occt(*image), face, edge_tolerance_[e.index()]);
      return {};
    }
    if (!ShapeFix_Edge().FixAddPCurve(out_.edges[e.index()], face, Standard_False)) {
      return Error{errors::to_shape_failed,
                   "an edge has no image in the parameters of its face, and none can be found",
                   {f, e},
                   as_array(model_.edge_point(e, model_.range(e).middle()))};
    }
    return {};
  }

  // The boundary cycles of a loop in the sense of the surface. Inner edges run there and back, nested like brackets:
  // what is between them is a cycle of its own.
  void split_loop(LoopId l, bool flip, std::vector<std::vector<Use>>& wires) {
    std::vector<CoedgeId> order;
    for (const CoedgeId c : k_.coedges(l)) order.push_back(c);
    if (flip) std::reverse(order.begin(), order.end());
    std::vector<std::vector<Use>> open(1);
    std::vector<EdgeId> brackets;
    const FaceId f = k_.face(l);
    for (const CoedgeId c : order) {
      const EdgeId e = k_.edge(c);
      if (is_inner(c, f)) {
        if (!brackets.empty() && brackets.back() == e) {
          brackets.pop_back();
          if (!open.back().empty()) wires.push_back(std::move(open.back()));
          open.pop_back();
        } else {
          brackets.push_back(e);
          open.emplace_back();
        }
        continue;
      }
      open.back().push_back({c, k_.reversed(c) != flip});
    }
    for (auto& cycle : open) {
      if (!cycle.empty()) wires.push_back(std::move(cycle));
    }
  }

  bool is_inner(CoedgeId c, FaceId f) const {
    for (const CoedgeId other : k_.coedges(k_.edge(c))) {
      if (other != c && k_.face(other) == f) return !is_seam(c, other);
    }
    return false;
  }

  Status add_wire(FaceId f, TopoDS_Face& face, const std::vector<Use>& uses) {
    TopoDS_Wire wire;
    build_.MakeWire(wire);
    const bool is_plane = model_.surface(f).is_plane();
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const Use& use = uses[i];
      const EdgeId e = k_.edge(use.coedge);
      build_.Add(wire, out_.edges[e.index()].Oriented(use.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
      if (!is_plane) ARESTA_CHECK(bridge_gap(f, face, wire, use, uses[(i + 1) % uses.size()]));
    }
    wire.Closed(Standard_True);
    build_.Add(face, wire);
    return {};
  }

  // Between the images of consecutive coedges there may be a gap only where a side of the surface is a point.
  Status bridge_gap(FaceId f, const TopoDS_Face& face, TopoDS_Wire& wire, const Use& from, const Use& to) {
    const Range range = model_.range(k_.edge(from.coedge)), next = model_.range(k_.edge(to.coedge));
    const Vec2 a = model_.uv(from.coedge, from.reversed ? range.low : range.high);
    const Vec2 b = model_.uv(to.coedge, to.reversed ? next.high : next.low);
    const Surface& surface = model_.surface(f);
    const Range2 domain = surface.domain();
    const auto share = [](double d, double whole) {
      return std::isfinite(whole) && whole > 0 ? std::abs(d) / whole : 0;
    };
    const Vec2 gap = b - a;
    if (share(gap.x, domain.u.length()) < 1e-6 && share(gap.y, domain.v.length()) < 1e-6) return {};
    const EdgeId e = k_.edge(from.coedge);
    const VertexId v = from.reversed ? k_.start(e) : k_.end(e);
    const double allowed = vertex_tolerance_[v.index()];
    const SurfaceJet jet = surface.jet(0.5 * (a + b));
    const double stretch = norm(gap.x * jet.du + gap.y * jet.dv);
    const double off = distance(jet.point, model_.point(v));
    if (stretch > allowed || off > 2 * allowed) {
      // A short step within tolerance is an ordinary meeting of inexact images.
      if (off <= 2 * allowed && share(gap.x, domain.u.length()) < 0.01 && share(gap.y, domain.v.length()) < 0.01)
        return {};
      return Error{errors::to_shape_failed,
                   "the images of two consecutive edges of a face do not meet in its parameters",
                   {f, e, k_.edge(to.coedge)},
                   as_array(model_.point(v)),
                   "a side that closes on itself needs a seam edge"};
    }
    TopoDS_Edge pole;
    build_.MakeEdge(pole);
    const double length = norm(gap);
    const bool backwards = gap.x < 0 || (gap.x == 0 && gap.y < 0);
    const Vec2 origin = backwards ? b : a, direction = (backwards ? -1.0 : 1.0) / length * gap;
    // Parameters of the image are those of the surface where only u or v changes, as the library's own primitives do.
    const double low = direction.y == 0 ? origin.x : direction.x == 0 ? origin.y : 0;
    const Vec2 start = origin - low * direction;
    build_.UpdateEdge(pole, new Geom2d_Line(gp_Pnt2d(start.x, start.y), gp_Dir2d(direction.x, direction.y)), face,
                      allowed);
    build_.Range(pole, low, low + length);
    build_.Add(pole, out_.vertices[v.index()].Oriented(TopAbs_FORWARD));
    build_.Add(pole, out_.vertices[v.index()].Oriented(TopAbs_REVERSED));
    build_.Degenerated(pole, Standard_True);
    build_.Add(wire, pole.Oriented(backwards ? TopAbs_REVERSED : TopAbs_FORWARD));
    return {};
  }

  void add_inner(TopoDS_Face& face, const std::vector<EdgeId>& inner) {
    if (inner.empty()) return;
    UnionFind sets(inner.size());
    std::map<VertexId, std::size_t> first;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      for (const VertexId v : {k_.start(inner[i]), k_.end(inner[i])}) {
        sets.unite(first.emplace(v, i).first->second, i);
      }
    }
    std::map<std::uint32_t, TopoDS_Wire> wires;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      auto [found, is_new] = wires.try_emplace(sets.find(i));
      if (is_new) build_.MakeWire(found->second);
      build_.Add(found->second, out_.edges[inner[i].index()].Oriented(TopAbs_INTERNAL));
    }
    for (auto& [root, wire] : wires) build_.Add(face, wire);
  }

  bool bounds_region(FaceUse use) const {
    return k_.region(use) != k_.region(use.opposite()) && model_.is_region(k_.region(use));
  }

  // Sides of a region that share a sector about an edge make one shell; faces within the region do not part them.
  void make_regions() {
    UnionFind sides(2 * k_.face_count());
    for (const CoedgeId c : k_.coedges()) {
      const FaceUse use = k_.side_after(c);
      if (!bounds_region(use)) continue;
      CoedgeId next = k_.radial(c);
      while (!bounds_region(k_.side_before(next))) next = k_.radial(next);
      sides.unite(use.index(), k_.side_before(next).index());
    }
    out_.regions.resize(k_.region_count());
    for (const RegionId r : model_.regions()) {
      TopoDS_Solid solid;
      build_.MakeSolid(solid);
      std::vector<std::pair<std::uint32_t, TopoDS_Shell>> shells;
      std::map<std::uint32_t, std::size_t> shell_of;
      TopoDS_Shell internal;
      for (const ShellId s : k_.shells(r)) {
        for (const FaceUse use : k_.face_uses(s)) {
          const TopoDS_Face& face = out_.faces[use.face().index()];
          if (!bounds_region(use)) {
            if (!options_.internal_faces_in_solids || use.side() == 1) continue;
            if (internal.IsNull()) build_.MakeShell(internal);
            build_.Add(internal, face.Oriented(TopAbs_INTERNAL));
            continue;
          }
          const std::uint32_t root = sides.find(use.index());
          const auto [found, is_new] = shell_of.emplace(root, shells.size());
          if (is_new) {
            shells.emplace_back(root, TopoDS_Shell());
            build_.MakeShell(shells.back().second);
          }
          build_.Add(shells[found->second].second, use.side() == 1 ? TopoDS_Shape(face) : face.Reversed());
        }
      }
      for (auto& [root, shell] : shells) {
        shell.Closed(Standard_True);
        build_.Add(solid, shell);
      }
      if (!internal.IsNull()) build_.Add(solid, internal);
      out_.regions[r.index()] = solid;
    }
  }

  void make_whole() {
    build_.MakeCompound(out_.whole);
    if (options_.solids) {
      for (const TopoDS_Shape& solid : out_.regions) {
        if (!solid.IsNull()) build_.Add(out_.whole, solid);
      }
    }
    for (const FaceId f : k_.faces()) {
      const FaceUse front(f, 0), back(f, 1);
      const bool in_solid = bounds_region(front) || bounds_region(back) ||
                            (options_.internal_faces_in_solids && k_.region(front) == k_.region(back) &&
                             model_.is_region(k_.region(front)));
      if (!options_.solids || !in_solid) build_.Add(out_.whole, out_.faces[f.index()]);
    }
    for (const EdgeId e : k_.edges()) {
      if (k_.is_wire(e)) build_.Add(out_.whole, out_.edges[e.index()]);
    }
    for (const VertexId v : k_.vertices()) {
      if (k_.isolated_in_shell(v).valid()) build_.Add(out_.whole, out_.vertices[v.index()]);
    }
  }

  const Model& model_;
  const Complex& k_;
  const ToShapeOptions& options_;
  const Context& context_;
  BRep_Builder build_;
  ModelShape::Data out_;
  std::vector<double> face_tolerance_, edge_tolerance_, vertex_tolerance_;
  std::map<std::uint32_t, Handle(Geom_Curve)> curves_;
  std::map<std::uint32_t, Handle(Geom_Surface)> surfaces_;
  // Of the face being made.
  std::vector<std::uint32_t> in_face_;
  std::vector<CoedgeId> first_use_, single_, inner_images_;
  std::vector<std::pair<CoedgeId, CoedgeId>> seams_;
};

}  // namespace

OcctShape ModelShape::whole() const {
  return wrap(data_->whole);
}

OcctShape ModelShape::of(EntityRef entity) const {
  switch (entity.kind) {
    case EntityKind::vertex:
      return wrap(data_->vertices[entity.index]);
    case EntityKind::edge:
      return wrap(data_->edges[entity.index]);
    case EntityKind::face:
      return wrap(data_->faces[entity.index]);
    default:
      return wrap(data_->regions[entity.index]);
  }
}

Result<ModelShape> to_shape(const Model& model, const ToShapeOptions& options, const Context& context) {
  return guarded(errors::to_shape_failed, "converting a model", [&]() -> Result<ModelShape> {
    ARESTA_TRY(auto data, ShapeMaker(model, options, context).run());
    return ModelShape(std::move(data));
  });
}

}  // namespace aresta
