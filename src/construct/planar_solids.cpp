// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "construct/arguments.h"
#include "construct/drafts.h"
#include "construct/planar.h"
#include "construct/primitives.h"
#include "construct/turn.h"

namespace aresta {

namespace {

struct NamedLoop {
  IndexLoop loop;
  const char* name;
};

Box3 box_of(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

/// One solid of plane faces that look outward.
Result<Model> planar_solid(std::span<const Vec3> points, std::span<const NamedLoop> faces,
                           const ConstructOptions& options) {
  ModelBuilder builder;
  builder.tolerance = std::max(options.tolerance, rounding_tolerance(box_of(points)));
  builder.length_unit = options.length_unit;
  PlanarParts parts(builder, points);
  for (const NamedLoop& face : faces) parts.add_face(face.loop, options.names ? face.name : "");
  return builder.build(one_solid(parts.face_count(), parts.edge_count(), parts.vertex_count()), {false, true});
}

const NamedLoop block_faces[] = {{{0, 4, 6, 2}, "left"}, {{1, 3, 7, 5}, "right"},  {{0, 1, 5, 4}, "front"},
                                 {{2, 6, 7, 3}, "back"}, {{0, 2, 3, 1}, "bottom"}, {{4, 5, 7, 6}, "top"}};

/// Corners by bits: 1 for x, 2 for y, 4 for z.
std::array<Vec3, 8> corners(const Frame& frame, Vec3 low, Vec3 high) {
  std::array<Vec3, 8> points;
  for (unsigned i = 0; i < 8; ++i) {
    points[i] = frame.to_world({(i & 1u) ? high.x : low.x, (i & 2u) ? high.y : low.y, (i & 4u) ? high.z : low.z});
  }
  return points;
}

/// Corner i of a regular n-gon: bottom corners 0 .. n - 1.
std::vector<Vec3> regular_polygon(int n, double r, const Frame& frame, double z) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const auto [c, s] = part_of_turn(i, n);
    points.push_back(frame.to_world({r * c, r * s, z}));
  }
  return points;
}

void check_regular(Arguments& arguments, int n, double r, double h, const Placement& placement,
                   const ConstructOptions& options) {
  arguments.count("n", n, 3, 100000);
  arguments.length("r", r);
  arguments.length("h", h);
  arguments.placement(placement);
  arguments.options(options);
  if (!arguments.ok()) return;
  Box3 box;
  const Frame frame = Frame::along(placement.at, placement.axis);
  for (const double x : {-r, r}) {
    for (const double y : {-r, r}) {
      for (const double z : {0.0, h}) box.add(frame.to_world({x, y, z}));
    }
  }
  const double tolerance = working_tolerance(box, options);
  arguments.resolvable("the base's side", 2 * r * std::sin(std::numbers::pi / n), tolerance);
  arguments.resolvable("r", r, tolerance);
  arguments.resolvable("h", h, tolerance);
}

}  // namespace

Result<Model> block(double dx, double dy, double dz, Vec3 at, const ConstructOptions& options) {
  Arguments arguments("block");
  arguments.length("dx", dx);
  arguments.length("dy", dy);
  arguments.length("dz", dz);
  arguments.point("at", at);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const std::array<Vec3, 8> points = corners(Frame{}, at, at + Vec3{dx, dy, dz});
  const double tolerance = working_tolerance(box_of(points), options);
  arguments.resolvable("dx", dx, tolerance);
  arguments.resolvable("dy", dy, tolerance);
  arguments.resolvable("dz", dz, tolerance);
  ARESTA_CHECK(arguments.status());
  return planar_solid(points, block_faces, options);
}

Result<Model> wedge(double dx, double dy, double dz, double ltx, const Placement& placement,
                    const ConstructOptions& options) {
  Arguments arguments("wedge");
  arguments.length("dx", dx);
  arguments.length("dy", dy);
  arguments.length("dz", dz);
  arguments.length_or_zero("ltx", ltx);
  arguments.placement(placement);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const Frame frame = Frame::along(placement.at, placement.axis);
  std::array<Vec3, 8> points = corners(frame, {}, {dx, dy, dz});
  points[3] = frame.to_world({ltx, dy, 0});
  points[7] = frame.to_world({ltx, dy, dz});
  const double tolerance = working_tolerance(box_of(points), options);
  arguments.resolvable("dx", dx, tolerance);
  arguments.resolvable("dy", dy, tolerance);
  arguments.resolvable("dz", dz, tolerance);
  if (ltx != 0) arguments.resolvable("ltx", ltx, tolerance);
  ARESTA_CHECK(arguments.status());
  if (ltx != 0) return planar_solid(points, block_faces, options);
  const std::array<Vec3, 6> sharp = {points[0], points[1], points[2], points[4], points[5], points[6]};
  const NamedLoop faces[] = {{{0, 3, 5, 2}, "left"},
                             {{1, 2, 5, 4}, "right"},
                             {{0, 1, 4, 3}, "front"},
                             {{0, 2, 1}, "bottom"},
                             {{3, 4, 5}, "top"}};
  return planar_solid(sharp, faces, options);
}

Result<Model> prism(int n, double r, double h, const Placement& placement, const ConstructOptions& options) {
  Arguments arguments("prism");
  check_regular(arguments, n, r, h, placement, options);
  ARESTA_CHECK(arguments.status());
  const Frame frame = Frame::along(placement.at, placement.axis);
  std::vector<Vec3> points = regular_polygon(n, r, frame, 0);
  const std::vector<Vec3> upper = regular_polygon(n, r, frame, h);
  points.insert(points.end(), upper.begin(), upper.end());
  const auto count = static_cast<std::size_t>(n);
  std::vector<NamedLoop> faces{{{}, "bottom"}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    faces[0].loop.push_back(count - 1 - i);
    faces.push_back({{i, j, count + j, count + i}, "side"});
  }
  faces.push_back({{}, "top"});
  for (std::size_t i = 0; i < count; ++i) faces.back().loop.push_back(count + i);
  return planar_solid(points, faces, options);
}

Result<Model> pyramid(int n, double r, double h, const Placement& placement, const ConstructOptions& options) {
  Arguments arguments("pyramid");
  check_regular(arguments, n, r, h, placement, options);
  ARESTA_CHECK(arguments.status());
  const Frame frame = Frame::along(placement.at, placement.axis);
  std::vector<Vec3> points = regular_polygon(n, r, frame, 0);
  points.push_back(frame.to_world({0, 0, h}));
  const auto count = static_cast<std::size_t>(n);
  std::vector<NamedLoop> faces{{{}, "bottom"}};
  for (std::size_t i = 0; i < count; ++i) {
    faces[0].loop.push_back(count - 1 - i);
    faces.push_back({{i, (i + 1) % count, count}, "side"});
  }
  return planar_solid(points, faces, options);
}

Result<Model> half_space_block(const HalfSpace& half_space, const Box3& box, const ConstructOptions& options) {
  Arguments arguments("half_space");
  arguments.point("point", half_space.point);
  arguments.direction("normal", half_space.normal);
  arguments.options(options);
  arguments.require(!box.empty() && box.diagonal() > 0, "box", "a box with some extent", "empty");
  if (!box.empty()) {
    arguments.point("box.low", box.low);
    arguments.point("box.high", box.high);
  }
  ARESTA_CHECK(arguments.status());
  // The plane's point moves to the foot of the box's centre, so that a far point costs no precision.
  const Vec3 normal = normalized(half_space.normal);
  const Vec3 foot = box.centre() - dot(box.centre() - half_space.point, normal) * normal;
  const Frame frame = Frame::along(foot, normal);
  Box3 local;
  for (const Vec3& corner : corners(Frame{}, box.low, box.high)) local.add(frame.to_local(corner));
  const double margin = 0.25 * box.diagonal();
  const Vec3 low{local.low.x - margin, local.low.y - margin, std::min(local.low.z, 0.0) - margin};
  const std::array<Vec3, 8> points = corners(frame, low, {local.high.x + margin, local.high.y + margin, 0});
  arguments.resolvable("box", box.diagonal(), working_tolerance(box_of(points), options));
  ARESTA_CHECK(arguments.status());
  return planar_solid(points, block_faces, options);
}

}  // namespace aresta
