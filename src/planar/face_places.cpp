// SPDX-License-Identifier: Apache-2.0
#include "planar/face_places.h"

#include <limits>

namespace aresta::planar {

namespace {

constexpr std::size_t many_edges = 24;

}  // namespace

FacePlaces::FacePlaces(const PlaneFaces& faces) : faces_(faces), trees_(faces.shape.face_count()) {
  for (Index f = 0; f < faces.shape.face_count(); ++f) {
    const auto coedges = faces.coedges_of(f);
    if (coedges.size() < many_edges) continue;
    std::vector<Box3> boxes(coedges.size());
    for (std::size_t i = 0; i < coedges.size(); ++i) {
      for (const Index v : faces.shape.edges[coedges[i] / 2]) boxes[i].add(faces.points[v]);
    }
    trees_[f] = std::make_unique<BoxTree>(std::move(boxes));
  }
}

Located FacePlaces::locate(Index face, Vec3 p) const {
  const double tolerance = faces_.tolerance;
  const Plane& plane = faces_.planes[face];
  Located found;
  const auto near_edge = [&](Index e) {
    const auto [a, b] = faces_.shape.edges[e];
    const Vec3 start = faces_.points[a], along = faces_.points[b] - start, to = p - start;
    const double length2 = norm2(along), t = dot(to, along) / length2;
    if (t <= 0 || t >= 1) {
      if (norm2(t <= 0 ? to : to - along) <= tolerance * tolerance) {
        found.place = Located::Place::vertex;
        found.vertex = t <= 0 ? a : b;
      }
      return;
    }
    if (norm2(to - t * along) > tolerance * tolerance) return;
    if (norm2(to) <= tolerance * tolerance || norm2(to - along) <= tolerance * tolerance) {
      found.place = Located::Place::vertex;
      found.vertex = norm2(to) <= norm2(to - along) ? a : b;
    } else if (found.place != Located::Place::vertex) {
      found.place = Located::Place::edges;
      for (int i = 0; i < found.edge_count; ++i) {
        if (found.edge[static_cast<std::size_t>(i)] == e) return;
      }
      if (found.edge_count < static_cast<int>(found.edge.size()))
        found.edge[static_cast<std::size_t>(found.edge_count++)] = e;
    }
  };
  Box3 here;
  here.add(p);
  edges_near(face, here.grown(tolerance), near_edge);
  if (found.place != Located::Place::outside) return found;

  const Vec2 q = plane.flat(p);
  bool inside = false;
  const auto cross_edge = [&](Index e) {
    const auto [a, b] = faces_.shape.edges[e];
    const Vec2 s = plane.flat(faces_.points[a]), t = plane.flat(faces_.points[b]);
    if ((s.y > q.y) == (t.y > q.y)) return;
    if (q.x < s.x + (t.x - s.x) * ((q.y - s.y) / (t.y - s.y))) inside = !inside;
  };
  if (trees_[face] == nullptr) {
    for (const Index c : faces_.coedges_of(face)) cross_edge(c / 2);
  } else {
    // The boxes on the ray along flat x.
    constexpr double inf = std::numeric_limits<double>::infinity();
    const int x = plane.normal[plane.axis] > 0 ? (plane.axis + 1) % 3 : (plane.axis + 2) % 3;
    Box3 ray;
    ray.add(p);
    ray.low[plane.axis] = -inf;
    ray.high[plane.axis] = ray.high[x] = inf;
    edges_near(face, ray, cross_edge);
  }
  if (inside) found.place = Located::Place::inside;
  return found;
}

}  // namespace aresta::planar
