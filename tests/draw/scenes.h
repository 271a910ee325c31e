// SPDX-License-Identifier: Apache-2.0
// Hand-made scenes for the tests of pictures: blocks, round bodies, sheets and wires with shared boundary points.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "draw/view.h"

namespace aresta::draw::test {

inline RegionId add_region(Scene& scene, const std::string& name, Color color, double volume) {
  const RegionId id(scene.regions.size());
  scene.regions.push_back({id, name, color, volume});
  return id;
}

/// A flat face through corners in counterclockwise order, as a fan.
inline FaceId add_polygon(Scene& scene, std::vector<Vec3> corners, RegionId front, RegionId back) {
  FacePatch patch;
  patch.face = FaceId(scene.faces.size());
  patch.regions = {front, back};
  patch.points = std::move(corners);
  for (std::uint32_t i = 2; i < patch.points.size(); ++i) patch.triangles.push_back({0, i - 1, i});
  scene.faces.push_back(std::move(patch));
  return scene.faces.back().face;
}

inline EdgeId add_edge(Scene& scene, std::vector<Vec3> points, std::vector<FaceId> faces = {}, bool smooth = false) {
  EdgeLine line;
  line.edge = EdgeId(scene.edges.size());
  line.points = std::move(points);
  line.faces = std::move(faces);
  line.smooth = smooth;
  scene.edges.push_back(std::move(line));
  return scene.edges.back().edge;
}

/// Corner i of a block has bit 0 of i for x, bit 1 for y, bit 2 for z. Twelve edges: 4 along x, 4 along y, 4 along z.
/// Faces in the order x-, x+, y-, y+, z-, z+.
inline RegionId add_block(Scene& scene, Vec3 low, Vec3 high, Color color = palette(0),
                          const std::string& name = "block") {
  const Vec3 d = high - low;
  const RegionId region = add_region(scene, name, color, d.x * d.y * d.z);
  const auto corner = [&](int i) {
    return Vec3{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  };
  constexpr int loops[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  std::array<FaceId, 6> faces;
  for (int f = 0; f < 6; ++f) {
    std::vector<Vec3> corners;
    for (const int i : loops[f]) corners.push_back(corner(i));
    faces[f] = add_polygon(scene, corners, RegionId{}, region);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (int k = 0; k < 4; ++k) {
      const int from = ((k & 1) << b) | ((k >> 1) << c);
      add_edge(scene, {corner(from), corner(from | (1 << axis))}, {faces[2 * b + (k & 1)], faces[2 * c + (k >> 1)]});
    }
  }
  return region;
}

/// A grid of points as one patch of n x m quadrilaterals; normals by the function.
template <class Point, class Normal>
FaceId add_surface(Scene& scene, int n, int m, const Point& point, const Normal& normal, RegionId front,
                   RegionId back) {
  FacePatch patch;
  patch.face = FaceId(scene.faces.size());
  patch.regions = {front, back};
  for (int j = 0; j <= m; ++j) {
    for (int i = 0; i <= n; ++i) {
      patch.points.push_back(point(i, j));
      patch.normals.push_back(normal(i, j));
    }
  }
  const auto at = [&](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < n; ++i) {
      patch.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      patch.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  scene.faces.push_back(std::move(patch));
  return scene.faces.back().face;
}

/// An upright cylinder: side, bottom, top; two circles and a smooth seam.
inline RegionId add_cylinder(Scene& scene, Vec3 base, double r, double h, int n, Color color = palette(1)) {
  const RegionId region = add_region(scene, "cylinder", color, std::numbers::pi * r * r * h);
  const auto dir = [&](int i) {
    const double a = 2 * std::numbers::pi * (i % n) / n;
    return Vec3{std::cos(a), std::sin(a), 0};
  };
  const auto ring = [&](int i, int j) { return base + r * dir(i) + Vec3{0, 0, j * h}; };
  const FaceId side = add_surface(
      scene, n, 1, ring, [&](int i, int) { return dir(i); }, RegionId{}, region);
  std::vector<Vec3> bottom, top;
  for (int i = 0; i <= n; ++i) bottom.push_back(ring(i, 0)), top.push_back(ring(i, 1));
  const FaceId low = add_polygon(scene, {bottom.rbegin() + 1, bottom.rend()}, RegionId{}, region);
  const FaceId high = add_polygon(scene, {top.begin(), top.end() - 1}, RegionId{}, region);
  add_edge(scene, bottom, {side, low});
  add_edge(scene, top, {side, high});
  add_edge(scene, {bottom[0], top[0]}, {side, side}, true);
  return region;
}

inline RegionId add_torus(Scene& scene, Vec3 centre, double big, double small, int n, int m, Color color = palette(3)) {
  const RegionId region =
      add_region(scene, "torus", color, 2 * std::numbers::pi * std::numbers::pi * big * small * small);
  const auto normal = [&](int i, int j) {
    const double u = 2 * std::numbers::pi * (i % n) / n, v = 2 * std::numbers::pi * (j % m) / m;
    return Vec3{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
  };
  const auto point = [&](int i, int j) {
    const double u = 2 * std::numbers::pi * (i % n) / n;
    return centre + big * Vec3{std::cos(u), std::sin(u), 0} + small * normal(i, j);
  };
  const FaceId face = add_surface(scene, n, m, point, normal, RegionId{}, region);
  std::vector<Vec3> seam;
  for (int j = 0; j <= m; ++j) seam.push_back(point(0, j));
  add_edge(scene, seam, {face, face}, true);
  return region;
}

inline RegionId add_sphere(Scene& scene, Vec3 centre, double r, int n, int m, Color color = palette(2)) {
  const RegionId region = add_region(scene, "sphere", color, 4 * std::numbers::pi * r * r * r / 3);
  const auto normal = [&](int i, int j) {
    const double u = 2 * std::numbers::pi * (i % n) / n, v = std::numbers::pi * (double(j) / m - 0.5);
    if (j == 0) return Vec3{0, 0, -1};
    if (j == m) return Vec3{0, 0, 1};
    return Vec3{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
  };
  add_surface(
      scene, n, m, [&](int i, int j) { return centre + r * normal(i, j); }, normal, RegionId{}, region);
  return region;
}

}  // namespace aresta::draw::test
