// SPDX-License-Identifier: Apache-2.0
#include "construct/copy.h"

#include <algorithm>
#include <numbers>

#include "geometry/swept.h"

namespace aresta {

namespace {

/// A plane under any map that is not singular; images in planes are not stored, so its axes are free to choose.
Surface mapped_plane(const Plane& plane, const Transform& map) {
  const Vec3 x = map.vector(plane.frame.x), y = map.vector(plane.frame.y);
  return Plane{Frame::along(map.point(plane.frame.origin), cross(x, y), x)};
}

}  // namespace

ModelCopier::ModelCopier(const Model& source, ModelBuilder& target, const Transform& map)
    : vertices(source.topology().vertex_count()),
      edges(source.topology().edge_count()),
      source_(source),
      target_(target),
      map_(map),
      curves_(source.curve_count()),
      surfaces_(source.surface_count()) {
  const Transform identity;
  moves_ = map.rows != identity.rows || map.offset != identity.offset;
  scale_ = std::cbrt(std::abs(map.determinant()));
  if (map.is_rigid()) scale_ = 1;
}

VertexId ModelCopier::vertex(VertexId v) {
  VertexId& copy = vertices[v.index()];
  if (!copy.valid()) {
    const Vec3 p = source_.point(v);
    copy = target_.add_vertex(moves_ ? map_.point(p) : p, scale_ * source_.tolerance(v));
  }
  return copy;
}

/// By how much the edge's parameters grow: those of lines are lengths.
double ModelCopier::edge_factor(EdgeId e) const {
  if (!moves_ || !source_.is_straight(e)) return 1;
  return norm(map_.vector(normalized(source_.edge_jet(e, source_.range(e).low).d1)));
}

Result<EdgeId> ModelCopier::edge(EdgeId e) {
  EdgeId& copy = edges[e.index()];
  if (copy.valid()) return copy;
  const VertexId start = vertex(source_.topology().start(e)), end = vertex(source_.topology().end(e));
  const EdgeGeometry& g = source_.geometry(e);
  CurveId curve;
  if (g.curve.valid()) {
    CurveId& mapped = curves_[g.curve.index()];
    if (!mapped.valid()) {
      if (moves_) {
        ARESTA_TRY(Curve moved, source_.curve(g.curve).transformed(map_));
        mapped = target_.add_curve(std::move(moved));
      } else {
        mapped = target_.add_curve(source_.curve(g.curve));
      }
    }
    curve = mapped;
  }
  const double factor = edge_factor(e);
  copy = target_.add_edge(start, end, curve, {factor * g.range.low, factor * g.range.high}, scale_ * g.tolerance);
  return copy;
}

Result<ModelCopier::MappedSurface> ModelCopier::surface(SurfaceId s) {
  MappedSurface& mapped = surfaces_[s.index()];
  if (mapped.id.valid()) return mapped;
  const Surface& old = source_.surface(s);
  if (!moves_) {
    mapped.id = target_.add_surface(old);
  } else if (const Plane* plane = old.get_if<Plane>()) {
    mapped.id = target_.add_surface(mapped_plane(*plane, map_));
  } else {
    ARESTA_TRY(Surface moved, old.transformed(map_, &mapped.uv_scale));
    mapped.id = target_.add_surface(std::move(moved));
  }
  return mapped;
}

Result<FaceDraft> ModelCopier::face(FaceId f) {
  const Complex& k = source_.topology();
  const FaceGeometry& g = source_.geometry(f);
  ARESTA_TRY(const MappedSurface mapped, surface(g.surface));
  const bool keeps_images = !moves_ || !source_.surface(f).is_plane();
  FaceDraft face{.surface = mapped.id,
                 .reversed = g.reversed,
                 .constraint = g.constraint,
                 .tolerance = scale_ * g.tolerance,
                 .loops = {}};
  for (const LoopId l : k.loops(f)) {
    LoopDraft& loop = face.loops.emplace_back();
    if (k.is_vertex_loop(l)) {
      loop.vertex = vertex(k.loop_vertex(l));
      continue;
    }
    for (const CoedgeId c : k.coedges(l)) {
      ARESTA_TRY(const EdgeId e, edge(k.edge(c)));
      CoedgeDraft& coedge = loop.coedges.emplace_back(CoedgeDraft{e, k.reversed(c)});
      const Curve2* image = source_.pcurve(c);
      if (image == nullptr || !keeps_images) continue;
      ARESTA_TRY(coedge.pcurve, rescaled(*image, mapped.uv_scale, edge_factor(k.edge(c)), source_.range(k.edge(c))));
    }
  }
  return face;
}

void copy_labels(const Labels& source, const std::map<EntityRef, EntityRef>& image, Labels& target) {
  for (const auto& [entity, attributes] : source.attributes) {
    const auto at = image.find(entity);
    if (at != image.end()) target.attributes[at->second] = attributes;
  }
  for (const Group& group : source.groups) {
    const auto same =
        std::find_if(target.groups.begin(), target.groups.end(), [&](const Group& g) { return g.name == group.name; });
    Group& copy = same == target.groups.end() ? target.groups.emplace_back(Group{group.name, {}}) : *same;
    for (const EntityRef entity : group.entities) {
      const auto at = image.find(entity);
      if (at != image.end()) copy.entities.push_back(at->second);
    }
    std::sort(copy.entities.begin(), copy.entities.end());
    copy.entities.erase(std::unique(copy.entities.begin(), copy.entities.end()), copy.entities.end());
  }
}

}  // namespace aresta
