// SPDX-License-Identifier: Apache-2.0
#include "model/query.h"

#include <cmath>
#include <limits>

#include "math/box_tree.h"
#include "model/measure.h"

namespace aresta {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// Directions for rays, by turns of the golden angle: none is special for boxes, axes or diagonals.
Vec3 ray_direction(int i) {
  const double z = 1 - 2 * std::fmod(0.5545497 + 0.618033988749895 * i, 1.0);
  const double angle = 0.7390851332151607 + 2.399963229728653 * i, r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}
constexpr int direction_count = 40;

Status known(const Model& model, EntityRef entity) {
  const Complex& t = model.topology();
  const std::size_t counts[] = {t.vertex_count(), t.edge_count(), t.face_count(), t.region_count()};
  if (entity.index < counts[static_cast<int>(entity.kind)]) return {};
  return Error{errors::unknown_entity,
               std::string("the model has no ") + to_string(entity.kind) + " " + std::to_string(entity.index),
               {entity}};
}

Status finite(Vec3 p) {
  if (is_finite(p)) return {};
  return Error{errors::invalid_argument, "a point has a coordinate that is not a finite number"};
}

double distance_to_vertex(const Model& model, VertexId v, Vec3 p) {
  return distance(model.point(v), p);
}

double distance_to_edge(const Model& model, EdgeId e, Vec3 p) {
  const Range range = model.range(e);
  const double ends =
      std::min(distance(model.point(model.topology().start(e)), p), distance(model.point(model.topology().end(e)), p));
  if (model.is_straight(e)) {
    const Vec3 a = model.edge_point(e, range.low), d = model.edge_point(e, range.high) - a;
    const double dd = norm2(d);
    const double t = dd > 0 ? std::clamp(dot(p - a, d) / dd, 0.0, 1.0) : 0;
    return std::min(ends, distance(a + t * d, p));
  }
  return std::min(ends, model.curve(e).project(p, range).distance);
}

double distance_to_face_boundary(const Model& model, FaceId f, Vec3 p) {
  const Complex& topology = model.topology();
  double best = infinity;
  for (const LoopId l : topology.loops(f)) {
    if (topology.is_vertex_loop(l)) {
      best = std::min(best, distance(model.point(topology.loop_vertex(l)), p));
      continue;
    }
    for (const CoedgeId c : topology.coedges(l)) {
      best = std::min(best, distance_to_edge(model, topology.edge(c), p));
    }
  }
  return best;
}

/// The nearest point of the surface may lie outside the face while another foot point lies inside it. On a plane and a
/// sphere there is one; on the others the opposite foot points are asked too.
double distance_to_face(const Model& model, FaceId f, Vec3 p, const FaceTrim* trim = nullptr) {
  const Surface& surface = model.surface(f);
  std::optional<FaceTrim> own;
  if (trim == nullptr) trim = &own.emplace(model, f);
  double best = infinity;
  const auto consider = [&](Vec2 uv) {
    const Vec3 q = surface.point(uv);
    const double d = distance(q, p);
    if (d < best && trim->locate(uv, 0) != Position::outside) best = d;
  };
  const SurfaceProjection foot = surface.project(p);
  consider(foot.uv);
  if (best <= foot.distance) return best;
  best = distance_to_face_boundary(model, f, p);
  if (surface.is_plane()) return best;
  // Feet on the other branches: the line through p and the nearest foot meets the surface at right angles again there
  // on spheres, cylinders and tori (in the plane through the axis); Newton from points of the face finds those on
  // others.
  const Range2 box = trim->box();
  const Range2 domain = surface.domain();
  const auto bounded = [](Range r, Range d) {
    if (!std::isfinite(r.low)) r.low = std::isfinite(d.low) ? d.low : 0;
    if (!std::isfinite(r.high)) r.high = std::isfinite(d.high) ? d.high : 0;
    return r;
  };
  const Range u = bounded(box.u, domain.u), v = bounded(box.v, domain.v);
  constexpr int steps = 4;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      Vec2 uv{u.at(i / double{steps}), v.at(j / double{steps})};
      for (int k = 0; k < 20; ++k) {
        const SurfaceJet s = surface.jet(uv);
        const Vec3 r = p - s.point;
        double a = dot(s.du, s.du) - dot(r, s.duu), b = dot(s.du, s.dv) - dot(r, s.duv),
               c = dot(s.dv, s.dv) - dot(r, s.dvv);
        if (!(a > 0 && a * c - b * b > 1e-12 * a * std::abs(c))) {  // not near a minimum: a Gauss-Newton step
          a = dot(s.du, s.du), b = dot(s.du, s.dv), c = dot(s.dv, s.dv);
        }
        const double determinant = a * c - b * b;
        if (!(determinant > 1e-14 * a * c)) break;
        const double ru = dot(r, s.du), rv = dot(r, s.dv);
        const Vec2 step{(c * ru - b * rv) / determinant, (a * rv - b * ru) / determinant};
        uv += step;
        uv = {std::isfinite(domain.u.length()) && surface.period().x == 0 ? domain.u.clamp(uv.x) : uv.x,
              std::isfinite(domain.v.length()) && surface.period().y == 0 ? domain.v.clamp(uv.y) : uv.y};
        if (norm(step.x * s.du + step.y * s.dv) <= 1e-14 * (1 + norm(p))) break;
      }
      if (std::isfinite(uv.x) && std::isfinite(uv.y)) consider(uv);
    }
  }
  return best;
}

/// Boxes of all entities of a kind, then exact distances nearest first.
template <class Boxes, class Distance>
std::uint32_t nearest_of(std::size_t count, Boxes boxes, Distance exact, Vec3 p, double* out = nullptr) {
  std::vector<Box3> list(count);
  for (std::uint32_t i = 0; i < count; ++i) list[i] = boxes(i);
  const BoxTree tree(std::move(list));
  double best = infinity;
  std::uint32_t id = 0xffffffffu;
  tree.nearest(p, [&](std::uint32_t i, double) {
    const double d = exact(i);
    if (d < best || (d == best && i < id)) {
      best = d;
      id = i;
    }
    return best * best * (1 + 1e-12);
  });
  if (out != nullptr) *out = best;
  return id;
}

/// The region that a ray from the point sees first.
Result<RegionId> region_around(const Model& model, const RayCaster& caster, Vec3 p) {
  for (int i = 0; i < direction_count; ++i) {
    const auto hits = caster.cast(p, ray_direction(i));
    if (hits.empty()) return Complex::infinite_region();
    // Only the first meeting must be beyond doubt, and none in doubt may come before it.
    if (!hits.front().doubtful) return model.topology().region(hits.front().facing);
  }
  return Error{errors::measure_failed,
               "no ray decides where a point lies: it is too near to edges of the model",
               {},
               as_array(p),
               "a larger tolerance"};
}

bool bounds(const Model& model, FaceId f, RegionId region) {
  const Complex& t = model.topology();
  return (t.region(FaceUse(f, 0)) == region) != (t.region(FaceUse(f, 1)) == region);
}

}  // namespace

bool point_on_vertex(const Model& model, VertexId vertex, Vec3 point, double tolerance) {
  return distance_to_vertex(model, vertex, point) <= tolerance;
}

bool point_on_edge(const Model& model, EdgeId edge, Vec3 point, double tolerance) {
  return distance_to_edge(model, edge, point) <= tolerance;
}

bool point_on_face(const Model& model, FaceId face, Vec3 point, double tolerance) {
  return model.bounds(face).grown(tolerance).contains(point) && distance_to_face(model, face, point) <= tolerance;
}

Result<EntityRef> locate_point(const Model& model, Vec3 point, double tolerance) {
  ARESTA_CHECK(finite(point));
  const Complex& topology = model.topology();
  // Of several entities of one dimension within tolerance the nearest.
  const auto nearest_within = [&](auto ids, auto box_holds, auto exact) {
    EntityRef found;
    double best = tolerance;
    for (const auto id : ids) {
      if (!box_holds(id)) continue;
      const double d = exact(id);
      if (d < best || (d <= best && found.index == 0xffffffffu)) {
        best = d;
        found = id;
      }
    }
    return found;
  };
  const auto none = EntityRef().index;
  EntityRef hit = nearest_within(
      topology.vertices(), [](VertexId) { return true; },
      [&](VertexId v) { return distance_to_vertex(model, v, point); });
  if (hit.index != none) return hit;
  hit = nearest_within(
      topology.edges(), [&](EdgeId e) { return model.bounds(e).grown(tolerance).contains(point); },
      [&](EdgeId e) { return distance_to_edge(model, e, point); });
  if (hit.index != none) return hit;
  hit = nearest_within(
      topology.faces(), [&](FaceId f) { return model.bounds(f).grown(tolerance).contains(point); },
      [&](FaceId f) { return distance_to_face(model, f, point); });
  if (hit.index != none) return hit;
  ARESTA_TRY(const RegionId region, region_around(model, RayCaster(model), point));
  return EntityRef(region);
}

Result<Position> point_in_region(const Model& model, RegionId region, Vec3 point, double tolerance) {
  ARESTA_CHECK(known(model, region));
  ARESTA_CHECK(finite(point));
  const Complex& topology = model.topology();
  for (const ShellId s : topology.shells(region)) {
    for (const FaceUse use : topology.face_uses(s)) {
      if (bounds(model, use.face(), region) && point_on_face(model, use.face(), point, tolerance)) {
        return Position::boundary;
      }
    }
  }
  ARESTA_TRY(const RegionId around, region_around(model, RayCaster(model), point));
  return around == region ? Position::inside : Position::outside;
}

Result<Vec3> interior_point(const Model& model, RegionId region) {
  ARESTA_CHECK(known(model, region));
  const Complex& topology = model.topology();
  const RayCaster caster(model);
  if (region == Complex::infinite_region()) {
    const Box3 box = model.bounds();
    if (box.empty()) return Vec3{};
    const double d = box.diagonal() > 0 ? box.diagonal() : 1;
    return box.high + Vec3{0.31 * d, 0.37 * d, 0.41 * d};
  }
  // From points inside the region's sides rays go into it; the middle of the longest first stretch is well inside.
  Vec3 best{};
  double longest = 0;
  int tried = 0;
  for (const ShellId s : topology.shells(region)) {
    for (const FaceUse use : topology.face_uses(s)) {
      if (tried >= 12 && longest > 0) break;
      const auto uv = FaceTrim(model, use.face()).interior_point();
      if (!uv.ok()) continue;
      ++tried;
      const Vec3 p = model.surface(use.face()).point(*uv);
      const Vec3 n = use.side() == 0 ? model.normal(use.face(), *uv) : -model.normal(use.face(), *uv);
      for (int i = -1; i < 6; ++i) {
        Vec3 direction = i < 0 ? n : ray_direction(i);
        const double along = dot(direction, n);
        if (std::abs(along) < 0.2) continue;
        if (along < 0) direction = -direction;
        const auto hits = caster.cast(p, direction);
        if (hits.empty() || hits.front().doubtful || topology.region(hits.front().facing) != region) continue;
        if (hits.front().t > longest * (1 + 1e-9)) {
          longest = hits.front().t;
          best = p + 0.5 * longest * direction;
        }
      }
    }
  }
  if (longest > 2 * model.tolerance()) return best;
  return Error{
      errors::measure_failed, "no point was found inside a region: it is thinner than its tolerance", {region}};
}

Result<double> distance_to(const Model& model, EntityRef entity, Vec3 point) {
  ARESTA_CHECK(known(model, entity));
  ARESTA_CHECK(finite(point));
  switch (entity.kind) {
    case EntityKind::vertex:
      return distance_to_vertex(model, VertexId(entity.index), point);
    case EntityKind::edge:
      return distance_to_edge(model, EdgeId(entity.index), point);
    case EntityKind::face:
      return distance_to_face(model, FaceId(entity.index), point);
    case EntityKind::region:
      break;
  }
  const RegionId region(entity.index);
  const Complex& topology = model.topology();
  std::vector<FaceId> faces;
  for (const ShellId s : topology.shells(region)) {
    for (const FaceUse use : topology.face_uses(s)) {
      if (bounds(model, use.face(), region)) faces.push_back(use.face());
    }
  }
  double to_boundary = infinity;
  nearest_of(
      faces.size(), [&](std::uint32_t i) { return model.bounds(faces[i]); },
      [&](std::uint32_t i) { return distance_to_face(model, faces[i], point); }, point, &to_boundary);
  if (to_boundary <= model.tolerance()) return to_boundary;
  ARESTA_TRY(const RegionId around, region_around(model, RayCaster(model), point));
  return around == region ? 0.0 : to_boundary;
}

Result<EntityRef> nearest(const Model& model, EntityKind kind, Vec3 point) {
  ARESTA_CHECK(finite(point));
  const Complex& t = model.topology();
  std::uint32_t id = 0xffffffffu;
  switch (kind) {
    case EntityKind::vertex: {
      double best = infinity;
      for (const VertexId v : t.vertices()) {
        const double d = distance_to_vertex(model, v, point);
        if (d < best) {
          best = d;
          id = v.value;
        }
      }
      break;
    }
    case EntityKind::edge:
      id = nearest_of(
          t.edge_count(), [&](std::uint32_t i) { return model.bounds(EdgeId(i)); },
          [&](std::uint32_t i) { return distance_to_edge(model, EdgeId(i), point); }, point);
      break;
    case EntityKind::face:
      id = nearest_of(
          t.face_count(), [&](std::uint32_t i) { return model.bounds(FaceId(i)); },
          [&](std::uint32_t i) { return distance_to_face(model, FaceId(i), point); }, point);
      break;
    case EntityKind::region: {
      // The one that holds the point, else the one with the nearest boundary.
      double best = infinity;
      for (const RegionId r : model.regions()) {
        ARESTA_TRY(const double d, distance_to(model, r, point));
        if (d < best) {
          best = d;
          id = r.value;
        }
      }
      break;
    }
  }
  if (id == 0xffffffffu) {
    return Error{errors::unknown_entity, std::string("the model has no ") + to_string(kind)};
  }
  return EntityRef(kind, id);
}

}  // namespace aresta
