// SPDX-License-Identifier: Apache-2.0
#include "boolean/sweeps/convex.h"

#include <cmath>

#include "planar/box.h"

namespace aresta::sweeps {

namespace {

Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Twice the area, along the normal.
Point area_vector(const std::vector<Point>& loop) {
  Point sum;
  for (std::size_t i = 2; i < loop.size(); ++i) {
    const Point s = cross(loop[i - 1] - loop[0], loop[i] - loop[0]);
    sum = {sum.x + s.x, sum.y + s.y, sum.z + s.z};
  }
  return sum;
}

/// Nearer to the plane than this is on it: far below what the sweeps tell apart.
constexpr Real on_plane = 1e-12L;

/// What lies behind a plane; the cut gets a face of its own.
Convex clip(const Convex& solid, Point origin, Point normal) {
  const Real length = std::sqrt(dot(normal, normal));
  normal = {normal.x / length, normal.y / length, normal.z / length};
  Convex result;
  std::vector<Point> cut;
  bool cuts = false;
  for (const auto& face : solid.faces) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Point a = face[i], b = face[(i + 1) % face.size()];
      const Real at_a = dot(a - origin, normal), at_b = dot(b - origin, normal);
      if (at_a <= on_plane) kept.push_back(a);
      if (std::abs(at_a) <= on_plane) cut.push_back(a);
      cuts = cuts || at_a > on_plane;
      if (std::min(at_a, at_b) >= -on_plane || std::max(at_a, at_b) <= on_plane) continue;
      const Real t = at_a / (at_a - at_b);
      const Point p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
      kept.push_back(p);
      cut.push_back(p);
    }
    const Point n = area_vector(kept.empty() ? face : kept);
    if (kept.size() >= 3 && dot(n, n) > 0) result.faces.push_back(std::move(kept));
  }
  if (!cuts) return solid;
  if (cut.size() < 3) return result;
  // The cut's points in order about its middle.
  Point middle;
  for (const Point p : cut) middle = {middle.x + p.x, middle.y + p.y, middle.z + p.z};
  const auto n = static_cast<Real>(cut.size());
  middle = {middle.x / n, middle.y / n, middle.z / n};
  const Real ax = std::abs(normal.x), ay = std::abs(normal.y), az = std::abs(normal.z);
  const Point helper = ax <= ay && ax <= az ? Point{1, 0, 0} : ay <= az ? Point{0, 1, 0} : Point{0, 0, 1};
  const Point u = cross(normal, helper), v = cross(normal, u);
  const auto angle = [&](Point p) { return std::atan2(dot(p - middle, v), dot(p - middle, u)); };
  std::vector<std::pair<Real, Point>> sorted;
  for (const Point p : cut) {
    auto at = sorted.begin();
    const Real a = angle(p);
    while (at != sorted.end() && at->first < a) ++at;
    sorted.insert(at, {a, p});
  }
  auto& face = result.faces.emplace_back();
  for (const auto& [a, p] : sorted) face.push_back(p);
  return result;
}

}  // namespace

Convex hexahedron(const std::array<Vec3, 8>& corners) {
  Convex solid;
  for (const auto& side : test::box_sides) {
    auto& face = solid.faces.emplace_back();
    for (const std::size_t i : side) face.push_back({corners[i].x, corners[i].y, corners[i].z});
  }
  return solid;
}

Real volume(const Convex& solid) {
  if (solid.faces.empty()) return 0;
  const Point o = solid.faces[0][0];
  Real sum = 0;
  for (const auto& face : solid.faces) sum += dot(face[0] - o, area_vector(face));
  return sum / 6;
}

Real area(const Convex& solid) {
  Real sum = 0;
  for (const auto& face : solid.faces) {
    const Point n = area_vector(face);
    sum += std::sqrt(dot(n, n)) / 2;
  }
  return sum;
}

Real common_volume(const Convex& a, const Convex& b) {
  Convex rest = a;
  for (const auto& face : b.faces) {
    rest = clip(rest, face[0], area_vector(face));
    if (rest.faces.empty()) return 0;
  }
  return volume(rest);
}

}  // namespace aresta::sweeps
