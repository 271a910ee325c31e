// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include "construct/arguments.h"
#include "construct/drafts.h"
#include "construct/planar.h"
#include "construct/profiles.h"

namespace aresta {

namespace {

std::string loop_name(std::size_t l) {
  return l == 0 ? "points" : "holes[" + std::to_string(l - 1) + "]";
}

std::optional<std::array<double, 3>> at(Vec3 p) {
  return std::array{p.x, p.y, p.z};
}

/// Segment number through all loops, as "holes[0] from point 2 to 3".
std::string segment_name(std::span<const IndexLoop> loops, std::size_t segment) {
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (segment < loops[l].size()) {
      return loop_name(l) + " from " + std::to_string(segment) + " to " +
             std::to_string((segment + 1) % loops[l].size());
    }
    segment -= loops[l].size();
  }
  return "a segment";
}

/// The points of all loops in one list.
struct Loops {
  std::vector<Vec3> points;
  std::vector<IndexLoop> loops;
};

Status add_loop(Loops& all, std::span<const Vec3> points, double tolerance) {
  const std::string name = loop_name(all.loops.size());
  std::size_t count = points.size();
  if (count > 3 && distance(points[0], points[count - 1]) <= tolerance) --count;
  IndexLoop& loop = all.loops.emplace_back();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if (distance(points[i], points[next]) <= tolerance) {
      return Error{errors::points_coincide,
                   "polygon: points " + std::to_string(i) + " and " + std::to_string(next) + " of " + name +
                       " coincide within the tolerance " + number_text(tolerance),
                   {},
                   at(points[i])};
    }
    loop.push_back(all.points.size());
    all.points.push_back(points[i]);
  }
  return {};
}

Error crossing_error(const Loops& all, const Crossing& crossing) {
  return Error{errors::self_intersection,
               "polygon: its boundary meets itself: " + segment_name(all.loops, crossing.first) + " and " +
                   segment_name(all.loops, crossing.second),
               {},
               at(crossing.place)};
}

/// A plane through three of the points that do not lie on one line.
std::optional<Frame> any_plane(std::span<const Vec3> points, double tolerance) {
  const Vec3 a = points[0];
  Vec3 b = a, normal{};
  for (const Vec3& p : points) {
    if (distance(p, a) > distance(b, a)) b = p;
  }
  for (const Vec3& p : points) {
    if (norm(cross(b - a, p - a)) > norm(normal)) normal = cross(b - a, p - a);
  }
  if (norm(normal) <= tolerance * distance(a, b)) return std::nullopt;
  return Frame::along(a, normal, b - a);
}

Status check_loops(Loops& all, double tolerance) {
  const IndexLoop& outer = all.loops[0];
  double extent = 0;
  for (const std::size_t i : outer) extent = std::max(extent, distance(all.points[i], all.points[outer[0]]));
  const Vec3 area = newell(all.points, outer);
  if (norm(area) <= extent * tolerance) {
    // A figure eight may have no area in all; its crossing is the better message.
    if (const auto plane = any_plane(all.points, tolerance)) {
      if (const auto crossing = find_crossing(all.points, all.loops, *plane, tolerance))
        return crossing_error(all, *crossing);
    }
    return Error{
        errors::bad_size, "polygon: the points enclose no area: they lie on one line", {}, at(all.points[outer[0]])};
  }
  const Frame plane = plane_of(all.points, outer);
  for (std::size_t l = 0; l < all.loops.size(); ++l) {
    for (std::size_t i = 0; i < all.loops[l].size(); ++i) {
      const Vec3 p = all.points[all.loops[l][i]];
      const double height = plane.to_local(p).z;
      if (std::abs(height) <= tolerance) continue;
      return Error{errors::not_planar,
                   "polygon: point " + std::to_string(i) + " of " + loop_name(l) + " lies " +
                       number_text(std::abs(height)) + " off the plane of the others; allowed is " +
                       number_text(tolerance),
                   {},
                   at(p)};
    }
  }
  if (const auto crossing = find_crossing(all.points, all.loops, plane, tolerance)) {
    return crossing_error(all, *crossing);
  }
  for (std::size_t l = 1; l < all.loops.size(); ++l) {
    const Vec3 p = all.points[all.loops[l][0]];
    if (!inside_loop(all.points, outer, plane, p)) {
      return Error{errors::bad_profile, "polygon: " + loop_name(l) + " lies outside the polygon", {}, at(p)};
    }
    for (std::size_t m = 1; m < all.loops.size(); ++m) {
      if (m != l && inside_loop(all.points, all.loops[m], plane, p)) {
        return Error{errors::bad_profile, "polygon: " + loop_name(l) + " lies inside " + loop_name(m), {}, at(p)};
      }
    }
    if (dot(newell(all.points, all.loops[l]), plane.z) > 0) std::reverse(all.loops[l].begin(), all.loops[l].end());
  }
  return {};
}

}  // namespace

Result<Model> polygon(std::span<const Vec3> points, std::span<const std::vector<Vec3>> holes,
                      const ConstructOptions& options) {
  Arguments arguments("polygon");
  arguments.require(points.size() >= 3, "points", "a list of three or more", std::to_string(points.size()));
  arguments.points("points", points);
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const std::string name = loop_name(i + 1);
    arguments.require(holes[i].size() >= 3, name, "a list of three or more points", std::to_string(holes[i].size()));
    arguments.points(name, holes[i]);
  }
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const double tolerance = working_tolerance(box, options);
  Loops all;
  ARESTA_CHECK(add_loop(all, points, tolerance));
  for (const auto& hole : holes) ARESTA_CHECK(add_loop(all, hole, tolerance));
  ARESTA_CHECK(check_loops(all, tolerance));
  ModelBuilder builder;
  builder.tolerance = std::max(options.tolerance, rounding_tolerance(box));
  builder.length_unit = options.length_unit;
  PlanarParts parts(builder, all.points);
  parts.add_face(all.loops);
  return builder.build(no_solid(1, std::vector<bool>(parts.edge_count()), std::vector<bool>(parts.vertex_count())),
                       {false});
}

Result<Model> disk(double r, const Placement& placement, const ConstructOptions& options) {
  Arguments arguments("disk");
  arguments.length("r", r);
  arguments.placement(placement);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const Frame frame = Frame::along(placement.at, placement.axis);
  const Curve rim = Circle{frame, r};
  const Box3 box = rim.bounds({0, 2 * std::numbers::pi});
  arguments.resolvable("r", r, working_tolerance(box, options));
  ARESTA_CHECK(arguments.status());
  ModelBuilder builder;
  builder.tolerance = std::max(options.tolerance, rounding_tolerance(box));
  builder.length_unit = options.length_unit;
  const VertexId v = builder.add_vertex(frame.to_world({r, 0, 0}));
  const EdgeId e = builder.add_edge(v, v, builder.add_curve(rim), {0, 2 * std::numbers::pi});
  builder.begin_face(builder.add_surface(Plane{frame}), false);
  builder.add_coedge(e, false);
  builder.close_loop();
  builder.end_face();
  return builder.build(no_solid(1, {false}, {false}), {false});
}

}  // namespace aresta
