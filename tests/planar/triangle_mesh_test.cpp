// SPDX-License-Identifier: Apache-2.0
#include "planar/triangle_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "math/transform.h"
#include "planar/active_triangles.h"
#include "planar/meshes.h"

namespace aresta::planar {
namespace {

TriangleMesh box(Vec3 low, Vec3 high) {
  TriangleMesh mesh;
  test::add_box(mesh, low, high);
  return mesh;
}

/// An octahedron with n parts a side, on a sphere.
TriangleMesh sphere(int n, Vec3 centre, double radius) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, Index> known;
  for (int octant = 0; octant < 8; ++octant) {
    const int x = (octant & 1) != 0 ? -1 : 1, y = (octant & 2) != 0 ? -1 : 1, z = (octant & 4) != 0 ? -1 : 1;
    const auto vertex = [&](int i, int j) {
      const std::array<int, 3> at{x * i, y * j, z * (n - i - j)};
      const auto [found, fresh] = known.try_emplace(at, static_cast<Index>(mesh.points.size()));
      if (fresh)
        mesh.points.push_back(centre + radius * normalized(Vec3{static_cast<double>(at[0]), static_cast<double>(at[1]),
                                                                static_cast<double>(at[2])}));
      return found->second;
    };
    const auto add = [&](Index a, Index b, Index c) {
      if (x * y * z < 0) std::swap(b, c);
      mesh.triangles.push_back({a, b, c});
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n - i; ++j) {
        add(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        if (i + j + 1 < n) add(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  }
  return mesh;
}

using test::volume;

double volume(const TriangleMesh& a, const TriangleMesh& b, MeshOperation operation) {
  const auto result = combine(a, b, operation, {}, {});
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().to_line());
  if (!result.ok()) return std::nan("");
  EXPECT_EQ(result->source.size(), result->mesh.triangles.size());
  EXPECT_NEAR(volume(result->mesh), result->volume, 1e-12);
  return result->volume;
}

/// "union, intersection, a - b, b - a"
std::array<double, 4> volumes(const TriangleMesh& a, const TriangleMesh& b) {
  return {volume(a, b, MeshOperation::unite), volume(a, b, MeshOperation::intersect),
          volume(a, b, MeshOperation::subtract), volume(b, a, MeshOperation::subtract)};
}

void expect_volumes(const TriangleMesh& a, const TriangleMesh& b, double common, double tolerance = 1e-12) {
  const double one = volume(a), two = volume(b);
  const auto got = volumes(a, b);
  EXPECT_NEAR(got[0], one + two - common, tolerance);
  EXPECT_NEAR(got[1], common, tolerance);
  EXPECT_NEAR(got[2], one - common, tolerance);
  EXPECT_NEAR(got[3], two - common, tolerance);
}

TEST(CombineMeshes, BoxesInEveryPosition) {
  const TriangleMesh unit = box({0, 0, 0}, {2, 2, 2});
  expect_volumes(unit, box({1, 1, 1}, {3, 3, 3}), 1);              // corner in corner
  expect_volumes(unit, box({1, 0, 0}, {3, 2, 2}), 4);              // four coplanar sides
  expect_volumes(unit, box({0.5, 0.5, -1}, {1.5, 1.5, 3}), 2);     // through
  expect_volumes(unit, box({0.5, 0.5, 0}, {1.5, 1.5, 2}), 2);      // through, flush with both sides
  expect_volumes(unit, box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}), 1);  // inside
  expect_volumes(unit, box({5, 5, 5}, {6, 6, 6}), 0);              // apart
  expect_volumes(unit, box({2, 0, 0}, {4, 2, 2}), 0);              // face to face
  expect_volumes(unit, box({2, 0.5, 0.5}, {4, 1.5, 1.5}), 0);      // a face on a face
  expect_volumes(unit, box({2, 2, 0}, {4, 4, 2}), 0);              // edge to edge
  expect_volumes(unit, box({2, 2, 2}, {4, 4, 4}), 0);              // corner to corner
  expect_volumes(unit, unit, 8);                                   // the same
  expect_volumes(unit, box({0, 0, 0}, {1, 1, 1}), 1);              // three coplanar sides
}

TEST(CombineMeshes, WhatIsNotTouchedStaysAsItIs) {
  const TriangleMesh a = sphere(20, {0, 0, 0}, 1), b = sphere(20, {1.5, 0.1, 0.2}, 1);
  const auto result = combine(a, b, MeshOperation::unite, {}, {});
  ASSERT_TRUE(result.ok()) << result.error().to_line();
  EXPECT_LT(result->imprinted, a.triangles.size() / 2);
  std::size_t whole = 0;
  for (std::size_t t = 0; t < result->source.size(); ++t) {
    const bool of_a = result->source[t] < a.triangles.size();
    const TriangleMesh& from = of_a ? a : b;
    const auto& source = from.triangles[of_a ? result->source[t] : result->source[t] - a.triangles.size()];
    const auto& corners = result->mesh.triangles[t];
    bool same = true;
    for (std::size_t i = 0; i < 3; ++i) same = same && result->mesh.points[corners[i]] == from.points[source[i]];
    whole += same ? 1 : 0;
  }
  EXPECT_GT(whole, a.triangles.size());
}

TEST(CombineMeshes, SpheresConvergeToTheirLens) {
  const double d = 0.8, lens = std::numbers::pi * (4 + d) * (2 - d) * (2 - d) / 12;
  double last = 1;
  for (const int n : {8, 16, 32, 64}) {
    const double common = volume(sphere(n, {0, 0, 0}, 1), sphere(n, {d, 0, 0}, 1), MeshOperation::intersect);
    EXPECT_LT(std::abs(common - lens), 0.35 * last) << n;
    last = std::abs(common - lens);
  }
}

TEST(CombineMeshes, VolumesDoNotDependOnPlaceAndOrder) {
  const TriangleMesh a = sphere(9, {0, 0, 0}, 1), b = sphere(7, {0.4, 0.3, 0.2}, 0.9);
  const double common = volume(a, b, MeshOperation::intersect);
  EXPECT_NEAR(volume(b, a, MeshOperation::intersect), common, 1e-14);
  TriangleMesh turned_a = a, turned_b = b;
  const Transform motion = Transform::rotation(33, {3, 1, 2}, {0.1, 0.2, 0.3});
  for (TriangleMesh* m : {&turned_a, &turned_b}) {
    for (Vec3& p : m->points) p = motion.point(p);
  }
  EXPECT_NEAR(volume(turned_a, turned_b, MeshOperation::intersect), common, 1e-13);
}

TEST(CombineMeshes, AShellInAShell) {
  // A ball with a void, less a ball that fills the void and more.
  TriangleMesh hollow = sphere(10, {0, 0, 0}, 2);
  const TriangleMesh inner = sphere(10, {0, 0, 0}, 1);
  const auto first = static_cast<Index>(hollow.points.size());
  hollow.points.insert(hollow.points.end(), inner.points.begin(), inner.points.end());
  for (const auto& [i, j, k] : inner.triangles) hollow.triangles.push_back({first + i, first + k, first + j});
  const TriangleMesh plug = sphere(10, {0, 0, 0}, 1.5);
  EXPECT_NEAR(volume(hollow, plug, MeshOperation::unite), volume(sphere(10, {0, 0, 0}, 2)), 1e-12);
  EXPECT_NEAR(volume(hollow, inner, MeshOperation::unite), volume(sphere(10, {0, 0, 0}, 2)), 1e-12);
  EXPECT_NEAR(volume(hollow, inner, MeshOperation::intersect), 0, 1e-12);
  EXPECT_NEAR(volume(hollow, plug, MeshOperation::intersect), volume(plug) - volume(inner), 1e-12);
}

TEST(CombineMeshes, BadInputIsRefused) {
  TriangleMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  const TriangleMesh good = box({0, 0, 0}, {1, 1, 1});
  const auto refused = combine(good, open, MeshOperation::unite, {}, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, errors::mesh_open);
  EXPECT_NE(refused.error().message.find("the second"), std::string::npos);
  EXPECT_EQ(refused.error().entities.size(), 2u);
  TriangleMesh wild = good;
  wild.points[3].y = std::nan("");
  EXPECT_EQ(combine(wild, good, MeshOperation::unite, {}, {}).error().code, errors::invalid_argument);
  wild = good;
  wild.triangles[0][1] = 99;
  EXPECT_EQ(combine(wild, good, MeshOperation::unite, {}, {}).error().code, errors::invalid_argument);
  EXPECT_NEAR(volume(good, {}, MeshOperation::unite), 1, 1e-15);
  EXPECT_NEAR(volume({}, {}, MeshOperation::unite), 0, 1e-15);
}

TEST(ActiveTriangles, NothingThatMayTouchIsMissed) {
  const TriangleMesh a = sphere(12, {0, 0, 0}, 1), b = sphere(9, {0.7, 0.5, 0}, 0.8);
  const auto active = active_triangles(a, b, 1e-9);
  const auto box_of = [](const TriangleMesh& m, Index t) {
    Box3 box;
    for (const Index v : m.triangles[t]) box.add(m.points[v]);
    return box;
  };
  for (Index s = 0; s < a.triangles.size(); ++s) {
    for (Index t = 0; t < b.triangles.size(); ++t) {
      if (!box_of(a, s).overlaps(box_of(b, t))) continue;
      EXPECT_TRUE(std::binary_search(active[0].begin(), active[0].end(), s));
      EXPECT_TRUE(std::binary_search(active[1].begin(), active[1].end(), t));
    }
  }
  EXPECT_LT(active[0].size(), a.triangles.size());
}

}  // namespace
}  // namespace aresta::planar
