// SPDX-License-Identifier: Apache-2.0
#include "model/model.h"

#include <algorithm>

namespace aresta {

namespace {

constexpr std::uint32_t no_pcurve = 0xffffffffu;

}  // namespace

std::string Labels::name(EntityRef entity) const {
  const auto found = attributes.find(entity);
  if (found == attributes.end()) return {};
  const auto name = found->second.find("name");
  if (name == found->second.end()) return {};
  const auto* text = std::get_if<std::string>(&name->second);
  return text != nullptr ? *text : std::string();
}

std::span<const Parent> Provenance::of(EntityRef entity) const {
  const auto found = parents.find(entity);
  return found == parents.end() ? std::span<const Parent>() : std::span<const Parent>(found->second);
}

std::vector<EntityRef> Provenance::images(Parent parent) const {
  std::vector<EntityRef> result;
  for (const auto& [entity, from] : parents) {
    if (entity.kind == parent.entity.kind && std::binary_search(from.begin(), from.end(), parent))
      result.push_back(entity);
  }
  return result;
}

Curve Model::curve(EdgeId e) const {
  const EdgeGeometry& geometry = edges_[e.index()];
  if (geometry.curve.valid()) return curves_[geometry.curve.index()];
  const Vec3 a = point(topology_.start(e)), b = point(topology_.end(e));
  return Line{a, normalized(b - a)};
}

bool Model::is_straight(EdgeId e) const {
  const EdgeGeometry& geometry = edges_[e.index()];
  return !geometry.curve.valid() || curves_[geometry.curve.index()].is_line();
}

Vec3 Model::edge_point(EdgeId e, double t) const {
  const EdgeGeometry& geometry = edges_[e.index()];
  if (geometry.curve.valid()) return curves_[geometry.curve.index()].point(t);
  const Vec3 a = point(topology_.start(e)), b = point(topology_.end(e));
  const double length = geometry.range.high;
  return length > 0 ? lerp(a, b, t / length) : a;
}

CurveJet Model::edge_jet(EdgeId e, double t) const {
  const EdgeGeometry& geometry = edges_[e.index()];
  if (geometry.curve.valid()) return curves_[geometry.curve.index()].jet(t);
  const Vec3 a = point(topology_.start(e)), b = point(topology_.end(e));
  return {edge_point(e, t), normalized(b - a), {}};
}

const Curve2* Model::pcurve(CoedgeId c) const {
  const std::uint32_t index = coedge_pcurve_[c.index()];
  return index == no_pcurve ? nullptr : &pcurves_[index];
}

Vec2 Model::uv(CoedgeId c, double t) const {
  if (const Curve2* image = pcurve(c)) return image->point(t);
  const Vec3 p = edge_point(topology_.edge(c), t);
  const Surface& surface = this->surface(topology_.face(c));
  if (const Plane* plane = surface.get_if<Plane>()) {
    const Vec3 local = plane->frame.to_local(p);
    return {local.x, local.y};
  }
  return surface.project(p).uv;
}

Vec3 Model::normal(FaceId f, Vec2 uv) const {
  const Vec3 natural = surface(f).normal(uv);
  return is_reversed(f) ? -natural : natural;
}

bool Model::is_planar() const {
  return std::all_of(curves_.begin(), curves_.end(), [](const Curve& c) { return c.is_line(); }) &&
         std::all_of(surfaces_.begin(), surfaces_.end(), [](const Surface& s) { return s.is_plane(); });
}

Box3 Model::bounds(EdgeId e) const {
  Box3 box;
  box.add(point(topology_.start(e)));
  box.add(point(topology_.end(e)));
  if (!is_straight(e)) box.add(curve(e).bounds(range(e)));
  return box;
}

Box3 Model::bounds(FaceId f) const {
  Box3 box;
  Range2 piece{{1, -1}, {1, -1}};
  const bool is_plane = surface(f).is_plane();
  const auto widen = [](Range& r, double value, bool first) {
    r = first ? Range{value, value} : Range{std::min(r.low, value), std::max(r.high, value)};
  };
  bool first = true, straight_images = true;
  for (const LoopId l : topology_.loops(f)) {
    if (topology_.is_vertex_loop(l)) {
      box.add(point(topology_.loop_vertex(l)));
      continue;
    }
    for (const CoedgeId c : topology_.coedges(l)) {
      const EdgeId e = topology_.edge(c);
      box.add(bounds(e));
      if (is_plane) continue;
      const Curve2* image = pcurve(c);
      straight_images = straight_images && image != nullptr && image->get_if<Line2>() != nullptr;
      constexpr int samples = 16;
      for (int i = 0; i <= samples; ++i) {
        const Vec2 uv = this->uv(c, range(e).at(static_cast<double>(i) / samples));
        widen(piece.u, uv.x, first);
        widen(piece.v, uv.y, first);
        first = false;
      }
    }
  }
  if (is_plane) return box;
  const Surface& surface = this->surface(f);
  const Range2 domain = surface.domain();
  const Vec2 period = surface.period();
  if (first) return surface.bounds(domain);
  // Straight images reach no further than their ends. Others may between samples; and a loop that goes around a
  // period may leave its side.
  const auto grow = [&](Range& r, double whole, Range limits) {
    if (whole > 0 && r.length() > (straight_images ? 0.999 : 0.5) * whole) {
      r = {r.low, r.low + whole};
      return;
    }
    const double margin = straight_images ? 0 : 0.1 * r.length();
    r = {r.low - margin, r.high + margin};
    if (whole == 0) r = {std::max(r.low, limits.low), std::min(r.high, limits.high)};
  };
  grow(piece.u, period.x, domain.u);
  grow(piece.v, period.y, domain.v);
  if (surface.get_if<Sphere>() != nullptr && (!straight_images || piece.u.length() >= period.x)) {
    piece.v = domain.v;  // a pole inside the face has no image on its boundary
    piece.u = domain.u;
  }
  box.add(surface.bounds(piece));
  return box;
}

Box3 Model::bounds() const {
  Box3 box;
  for (const VertexId v : topology_.vertices()) box.add(point(v));
  for (const EdgeId e : topology_.edges()) {
    if (!is_straight(e)) box.add(bounds(e));
  }
  for (const FaceId f : topology_.faces()) {
    if (!surface(f).is_plane()) box.add(bounds(f));
  }
  return box;
}

std::vector<RegionId> Model::regions() const {
  std::vector<RegionId> result;
  for (const RegionId r : topology_.regions()) {
    if (is_region(r)) result.push_back(r);
  }
  return result;
}

std::vector<EntityRef> Model::listed() const {
  std::vector<EntityRef> result;
  for (const VertexId v : topology_.vertices()) {
    if (topology_.isolated_in_shell(v).valid()) result.push_back(v);
  }
  for (const EdgeId e : topology_.edges()) {
    if (topology_.is_wire(e)) result.push_back(e);
  }
  for (const FaceId f : topology_.faces()) {
    const RegionId front = topology_.region(FaceUse(f, 0)), back = topology_.region(FaceUse(f, 1));
    const bool bounds_region = front != back && (is_region(front) || is_region(back));
    if (is_constraint(f) || !bounds_region) result.push_back(f);
  }
  for (const RegionId r : regions()) result.push_back(r);
  return result;
}

}  // namespace aresta
