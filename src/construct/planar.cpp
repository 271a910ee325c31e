// SPDX-License-Identifier: Apache-2.0
#include "construct/planar.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace aresta {

Vec3 newell(std::span<const Vec3> points, const IndexLoop& loop) {
  const Vec3 origin = points[loop[0]];
  Vec3 sum{};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(points[loop[i]] - origin, points[loop[i + 1]] - origin);
  return sum;
}

Frame plane_of(std::span<const Vec3> points, const IndexLoop& loop, double* deviation) {
  const Vec3 first = points[loop[0]];
  const Vec3 normal = normalized(newell(points, loop));
  Vec3 along = points[loop[1]] - first;
  double height = 0;
  for (const std::size_t i : loop) {
    height += dot(points[i] - first, normal);
    if (norm2(points[i] - first) > norm2(along) * 4) along = points[i] - first;  // a long edge gives a good direction
  }
  height /= static_cast<double>(loop.size());
  if (deviation != nullptr) {
    *deviation = 0;
    for (const std::size_t i : loop)
      *deviation = std::max(*deviation, std::abs(dot(points[i] - first, normal) - height));
  }
  return Frame::along(first + height * normal, normal, along);
}

namespace {

struct Segment {
  Vec2 a, b;
  std::size_t loop = 0, place = 0, loop_size = 0;
  double low_x() const { return std::min(a.x, b.x); }
  double high_x() const { return std::max(a.x, b.x); }
};

Vec2 nearest_on(const Segment& s, Vec2 p) {
  const Vec2 d = s.b - s.a;
  const double dd = dot(d, d);
  const double t = dd > 0 ? std::clamp(dot(p - s.a, d) / dd, 0.0, 1.0) : 0;
  return s.a + t * d;
}

/// Nearest points of two segments, or where they cross.
double segment_distance(const Segment& s, const Segment& t, Vec2& place) {
  const Vec2 d = s.b - s.a, e = t.b - t.a;
  const double a1 = cross(d, t.a - s.a), a2 = cross(d, t.b - s.a);
  const double b1 = cross(e, s.a - t.a), b2 = cross(e, s.b - t.a);
  if (((a1 > 0 && a2 < 0) || (a1 < 0 && a2 > 0)) && ((b1 > 0 && b2 < 0) || (b1 < 0 && b2 > 0))) {
    place = t.a + (a1 / (a1 - a2)) * e;
    return 0;
  }
  double best = std::numeric_limits<double>::infinity();
  const auto offer = [&](Vec2 p, Vec2 q) {
    if (distance(p, q) < best) {
      best = distance(p, q);
      place = 0.5 * (p + q);
    }
  };
  offer(s.a, nearest_on(t, s.a));
  offer(s.b, nearest_on(t, s.b));
  offer(t.a, nearest_on(s, t.a));
  offer(t.b, nearest_on(s, t.b));
  return best;
}

/// Neighbours share an end; they conflict when the far end of one lies on the other, that is when they fold back.
bool neighbours_conflict(const Segment& s, const Segment& next, double tolerance, Vec2& place) {
  const bool s_folds = distance(nearest_on(next, s.a), s.a) <= tolerance;
  const bool next_folds = distance(nearest_on(s, next.b), next.b) <= tolerance;
  place = s_folds ? s.a : next.b;
  return s_folds || next_folds;
}

bool conflict(const Segment& s, const Segment& t, double tolerance, Vec2& place) {
  if (s.loop == t.loop && s.loop_size > 2) {
    if ((s.place + 1) % s.loop_size == t.place) return neighbours_conflict(s, t, tolerance, place);
    if ((t.place + 1) % t.loop_size == s.place) return neighbours_conflict(t, s, tolerance, place);
  }
  return segment_distance(s, t, place) <= tolerance;
}

}  // namespace

std::optional<Crossing> find_crossing(std::span<const Vec3> points, std::span<const IndexLoop> loops,
                                      const Frame& frame, double tolerance) {
  std::vector<Segment> segments;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      const Vec3 a = frame.to_local(points[loops[l][i]]);
      const Vec3 b = frame.to_local(points[loops[l][(i + 1) % loops[l].size()]]);
      segments.push_back({{a.x, a.y}, {b.x, b.y}, l, i, loops[l].size()});
    }
  }
  std::vector<std::size_t> order(segments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::pair(segments[i].low_x(), i) < std::pair(segments[j].low_x(), j);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Segment& s = segments[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Segment& t = segments[order[j]];
      if (t.low_x() > s.high_x() + tolerance) break;
      Vec2 place;
      if (conflict(s, t, tolerance, place)) {
        return Crossing{frame.to_world({place.x, place.y, 0}), std::min(order[i], order[j]),
                        std::max(order[i], order[j])};
      }
    }
  }
  return std::nullopt;
}

bool inside_loop(std::span<const Vec3> points, const IndexLoop& loop, const Frame& frame, Vec3 p) {
  const Vec3 at = frame.to_local(p);
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = frame.to_local(points[loop[i]]), b = frame.to_local(points[loop[(i + 1) % loop.size()]]);
    if ((a.y > at.y) == (b.y > at.y)) continue;
    const double x = a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x > at.x) inside = !inside;
  }
  return inside;
}

PlanarParts::PlanarParts(ModelBuilder& builder, std::span<const Vec3> points) : builder_(builder), points_(points) {
  for (const Vec3& p : points) vertices_.push_back(builder.add_vertex(p));
}

FaceId PlanarParts::add_face(std::span<const IndexLoop> loops, const std::string& name) {
  const SurfaceId surface = builder_.add_surface(Plane{plane_of(points_, loops[0])});
  const FaceId face = builder_.begin_face(surface, false);
  for (const IndexLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t a = loop[i], b = loop[(i + 1) % loop.size()];
      const auto [at, is_new] = edges_.try_emplace(std::minmax(a, b), EdgeId());
      if (is_new) at->second = builder_.add_edge(vertices_[std::min(a, b)], vertices_[std::max(a, b)]);
      builder_.add_coedge(at->second, a > b);
    }
    builder_.close_loop();
  }
  builder_.end_face();
  builder_.set_fill(Fill::empty, Fill::filled);
  if (!name.empty()) builder_.labels.set_name(face, name);
  return face;
}

}  // namespace aresta
