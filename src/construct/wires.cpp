// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include "construct/arguments.h"
#include "construct/drafts.h"
#include "construct/profiles.h"
#include "construct/spline.h"

namespace aresta {

namespace {

constexpr double pi = std::numbers::pi;

Box3 box_of(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

ModelBuilder new_builder(const Box3& box, const ConstructOptions& options) {
  ModelBuilder builder;
  builder.tolerance = std::max(options.tolerance, rounding_tolerance(box));
  builder.length_unit = options.length_unit;
  return builder;
}

/// One edge on a curve; closed when both ends are one point.
Result<Model> one_edge(Curve curve, Range range, Vec3 start, Vec3 end, bool closed, const ConstructOptions& options) {
  ModelBuilder builder = new_builder(curve.bounds(range), options);
  const VertexId a = builder.add_vertex(start);
  const VertexId b = closed ? a : builder.add_vertex(end);
  builder.add_edge(a, b, builder.add_curve(std::move(curve)), range);
  return builder.build(no_solid(0, {true}, std::vector<bool>(closed ? 1 : 2)), {false});
}

/// Neighbouring points must be apart; non-neighbours too, where the wire would meet itself in a vertex.
Status check_apart(const std::string& function, std::span<const Vec3> points, bool closed, double tolerance) {
  for (std::size_t i = 0; i + 1 < points.size() + (closed ? 1 : 0); ++i) {
    const std::size_t j = (i + 1) % points.size();
    if (distance(points[i], points[j]) <= tolerance) {
      return Error{errors::points_coincide,
                   function + ": points " + std::to_string(i) + " and " + std::to_string(j) +
                       " coincide within the tolerance " + number_text(tolerance),
                   {},
                   std::array{points[i].x, points[i].y, points[i].z}};
    }
  }
  return {};
}

/// Without the last point when it repeats the first of a closed wire.
std::span<const Vec3> without_repeat(std::span<const Vec3> points, bool closed, double tolerance) {
  if (closed && points.size() > 3 && distance(points.front(), points.back()) <= tolerance)
    return points.first(points.size() - 1);
  return points;
}

/// Nearest distance of two segments in space, and the place.
double segment_distance(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3& place) {
  double best = std::numeric_limits<double>::infinity();
  const auto offer = [&](Vec3 p, Vec3 q) {
    if (distance(p, q) < best) {
      best = distance(p, q);
      place = 0.5 * (p + q);
    }
  };
  const auto nearest = [](Vec3 p, Vec3 s, Vec3 e) {
    const double t = std::clamp(dot(p - s, e - s) / norm2(e - s), 0.0, 1.0);
    return lerp(s, e, t);
  };
  offer(a, nearest(a, c, d));
  offer(b, nearest(b, c, d));
  offer(nearest(c, a, b), c);
  offer(nearest(d, a, b), d);
  const Vec3 u = b - a, v = d - c, w = a - c, n = cross(u, v);
  if (norm2(n) > 1e-24 * norm2(u) * norm2(v)) {
    const double s = dot(cross(v, w), n) / norm2(n), t = dot(cross(u, w), n) / norm2(n);
    if (s > 0 && s < 1 && t > 0 && t < 1) offer(lerp(a, b, s), lerp(c, d, t));
  }
  return best;
}

/// Edges of a wire meet only in the vertices that they share.
Status check_no_crossing(std::span<const Vec3> points, bool closed, double tolerance) {
  const std::size_t n = points.size(), edges = closed ? n : n - 1;
  std::vector<std::size_t> order(edges);
  for (std::size_t i = 0; i < edges; ++i) order[i] = i;
  const auto low = [&](std::size_t e) { return std::min(points[e].x, points[(e + 1) % n].x); };
  const auto high = [&](std::size_t e) { return std::max(points[e].x, points[(e + 1) % n].x); };
  std::sort(order.begin(), order.end(),
            [&](std::size_t e, std::size_t f) { return std::pair(low(e), e) < std::pair(low(f), f); });
  for (std::size_t i = 0; i < edges; ++i) {
    for (std::size_t j = i + 1; j < edges && low(order[j]) <= high(order[i]) + tolerance; ++j) {
      const auto [e, f] = std::minmax(order[i], order[j]);
      const Vec3 a = points[e], b = points[(e + 1) % n], c = points[f], d = points[(f + 1) % n];
      Vec3 place;
      bool meet = false;
      const bool follows = e + 1 == f, wraps = closed && e == 0 && f == n - 1;
      if (follows || wraps) {  // they share one end: then the others must keep off
        Vec3 unused;
        meet = segment_distance(follows ? a : b, follows ? a : b, c, d, place) <= tolerance ||
               segment_distance(follows ? d : c, follows ? d : c, a, b, unused) <= tolerance;
      } else {
        meet = segment_distance(a, b, c, d, place) <= tolerance;
      }
      if (meet) {
        return Error{errors::self_intersection,
                     "polyline: edge " + std::to_string(e) + " and edge " + std::to_string(f) + " meet",
                     {},
                     std::array{place.x, place.y, place.z},
                     "make lines one by one and join them by union or fragment"};
      }
    }
  }
  return {};
}

struct ArcShape {
  Frame frame;  ///< x to the start, counterclockwise to the end
  double radius = 0, angle = 0;
};

Result<Model> build_arc(const ArcShape& shape, Vec3 start, Vec3 end, const ConstructOptions& options) {
  return one_edge(Circle{shape.frame, shape.radius}, {0, shape.angle}, start, end, false, options);
}

Status check_arc(const std::string& function, Vec3 centre, Vec3 start, Vec3 end, const ConstructOptions& options) {
  Arguments arguments(function);
  arguments.point("centre", centre);
  arguments.point("start", start);
  arguments.point("end", end);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const Vec3 all[] = {centre, start, end};
  const double tolerance = working_tolerance(box_of(all), options);
  const double r = distance(centre, start), s = distance(centre, end);
  arguments.resolvable("the distance from centre to start", r, tolerance);
  arguments.require(std::abs(r - s) <= tolerance, "end", "as far from the centre as start, " + number_text(r),
                    number_text(s) + " away");
  ARESTA_CHECK(arguments.status());
  if (distance(start, end) <= tolerance) {
    return Error{errors::points_coincide, function + ": start and end coincide", {}, {}, "use circle for a full turn"};
  }
  return {};
}

}  // namespace

Result<Model> polyline(std::span<const Vec3> points, bool closed, const ConstructOptions& options) {
  Arguments arguments("polyline");
  const std::size_t least = closed ? 3 : 2;
  arguments.require(points.size() >= least, "points", "a list of " + std::to_string(least) + " or more",
                    std::to_string(points.size()));
  arguments.points("points", points);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const Box3 box = box_of(points);
  const double tolerance = working_tolerance(box, options);
  // An open one that comes back to its first point is closed.
  if (points.size() > 3 && distance(points.front(), points.back()) <= tolerance) closed = true;
  points = without_repeat(points, closed, tolerance);
  ARESTA_CHECK(check_apart("polyline", points, closed, tolerance));
  ARESTA_CHECK(check_no_crossing(points, closed, tolerance));
  ModelBuilder builder = new_builder(box, options);
  std::vector<VertexId> vertices;
  for (const Vec3& p : points) vertices.push_back(builder.add_vertex(p));
  const std::size_t edges = points.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < edges; ++i) builder.add_edge(vertices[i], vertices[(i + 1) % points.size()]);
  return builder.build(no_solid(0, std::vector<bool>(edges, true), std::vector<bool>(points.size())), {false});
}

Result<Model> line(Vec3 p, Vec3 q, const ConstructOptions& options) {
  Arguments arguments("line");
  arguments.point("p", p);
  arguments.point("q", q);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const Vec3 ends[] = {p, q};
  const Box3 box = box_of(ends);
  ARESTA_CHECK(check_apart("line", ends, false, working_tolerance(box, options)));
  ModelBuilder builder = new_builder(box, options);
  const VertexId a = builder.add_vertex(p), b = builder.add_vertex(q);
  builder.add_edge(a, b);
  return builder.build(no_solid(0, {true}, {false, false}), {false});
}

Result<Model> arc(Vec3 centre, Vec3 start, Vec3 end, const ConstructOptions& options) {
  ARESTA_CHECK(check_arc("arc", centre, start, end, options));
  const Vec3 a = start - centre, b = end - centre;
  const Vec3 axis = cross(a, b);
  if (norm(axis) <= 1e-9 * norm(a) * norm(b)) {
    return Error{errors::bad_size,
                 "arc: start and end lie on opposite sides of the centre, so that the plane of the arc is not known",
                 {},
                 {},
                 "give an axis, or three points on the arc"};
  }
  return arc_about(centre, start, end, axis, options);
}

Result<Model> arc_about(Vec3 centre, Vec3 start, Vec3 end, Vec3 axis, const ConstructOptions& options) {
  ARESTA_CHECK(check_arc("arc", centre, start, end, options));
  Arguments arguments("arc");
  arguments.direction("axis", axis);
  ARESTA_CHECK(arguments.status());
  const Vec3 all[] = {centre, start, end}, n = normalized(axis);
  const double tolerance = working_tolerance(box_of(all), options);
  const double off = std::max(std::abs(dot(start - centre, n)), std::abs(dot(end - centre, n)));
  arguments.require(off <= tolerance, "axis", "at right angles to the lines from the centre to start and end",
                    number_text(axis));
  ARESTA_CHECK(arguments.status());
  ArcShape shape;
  shape.frame = Frame::along(centre, n, start - centre);
  shape.radius = distance(centre, start);
  const Vec3 local = shape.frame.to_local(end);
  shape.angle = std::atan2(local.y, local.x);
  if (shape.angle <= 0) shape.angle += 2 * pi;
  return build_arc(shape, start, end, options);
}

Result<Model> arc_through(Vec3 start, Vec3 middle, Vec3 end, const ConstructOptions& options) {
  Arguments arguments("arc");
  arguments.point("start", start);
  arguments.point("middle", middle);
  arguments.point("end", end);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const Vec3 all[] = {start, middle, end};
  const double tolerance = working_tolerance(box_of(all), options);
  ARESTA_CHECK(check_apart("arc", all, true, tolerance));
  const Vec3 a = middle - start, b = end - start, n = cross(a, b);
  // Height of the triangle over its longest side.
  const double longest = std::max({norm(a), norm(b), distance(middle, end)});
  if (norm(n) / longest <= tolerance) {
    return Error{errors::bad_size, "arc: the three points lie on one line", {}, {}, "use line"};
  }
  const Vec3 centre = start + cross(norm2(a) * b - norm2(b) * a, n) / (2 * norm2(n));
  ArcShape shape;
  shape.frame = Frame::along(centre, n, start - centre);
  shape.radius = distance(centre, start);
  const Vec3 local = shape.frame.to_local(end);
  shape.angle = std::atan2(local.y, local.x);
  if (shape.angle <= 0) shape.angle += 2 * pi;
  arguments.require(shape.radius <= largest_length, "the points", "less nearly on one line",
                    "on a circle of radius " + number_text(shape.radius));
  ARESTA_CHECK(arguments.status());
  return build_arc(shape, start, end, options);
}

Result<Model> circle(double r, const Placement& placement, const ConstructOptions& options) {
  Arguments arguments("circle");
  arguments.length("r", r);
  arguments.placement(placement);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const Frame frame = Frame::along(placement.at, placement.axis);
  const Curve curve = Circle{frame, r};
  arguments.resolvable("r", r, working_tolerance(curve.bounds({0, 2 * pi}), options));
  ARESTA_CHECK(arguments.status());
  const Vec3 start = frame.to_world({r, 0, 0});
  return one_edge(curve, {0, 2 * pi}, start, start, true, options);
}

Result<Model> ellipse(double a, double b, const Placement& placement, const ConstructOptions& options) {
  Arguments arguments("ellipse");
  arguments.length("a", a);
  arguments.length("b", b);
  arguments.placement(placement);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  Frame frame = Frame::along(placement.at, placement.axis);
  if (b > a) {  // the first axis of an ellipse is its larger one
    frame = {frame.origin, frame.y, -frame.x, frame.z};
    std::swap(a, b);
  }
  const Curve curve = Ellipse{frame, a, b};
  const double tolerance = working_tolerance(curve.bounds({0, 2 * pi}), options);
  arguments.resolvable("the smaller semi-axis", b, tolerance);
  ARESTA_CHECK(arguments.status());
  const Vec3 start = frame.to_world({a, 0, 0});
  if (a - b <= tolerance) return one_edge(Circle{frame, a}, {0, 2 * pi}, start, start, true, options);
  return one_edge(curve, {0, 2 * pi}, start, start, true, options);
}

Result<Model> spline(std::span<const Vec3> points, bool closed, const ConstructOptions& options) {
  Arguments arguments("spline");
  const std::size_t least = closed ? 3 : 2;
  arguments.require(points.size() >= least, "points", "a list of " + std::to_string(least) + " or more",
                    std::to_string(points.size()));
  arguments.points("points", points);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const double tolerance = working_tolerance(box_of(points), options);
  if (points.size() > 3 && distance(points.front(), points.back()) <= tolerance) closed = true;
  points = without_repeat(points, closed, tolerance);
  ARESTA_CHECK(check_apart("spline", points, closed, tolerance));
  NurbsCurveData data = interpolating_spline(points, closed);
  const Range range{data.knots.front(), data.knots.back()};
  ARESTA_TRY(FreeCurve curve, FreeCurve::from_nurbs(data));
  return one_edge(std::move(curve), range, points.front(), points.back(), closed, options);
}

Result<Model> point(Vec3 p, const ConstructOptions& options) {
  Arguments arguments("point");
  arguments.point("p", p);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  Box3 box;
  box.add(p);
  ModelBuilder builder = new_builder(box, options);
  builder.add_vertex(p);
  return builder.build(no_solid(0, {}, {true}), {false});
}

}  // namespace aresta
