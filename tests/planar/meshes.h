// SPDX-License-Identifier: Apache-2.0
// Small triangle meshes for tests.
#pragma once

#include "planar/box.h"
#include "planar/triangle_mesh.h"

namespace aresta::planar::test {

inline void add_box(TriangleMesh& mesh, Vec3 low, Vec3 high) {
  const auto first = static_cast<Index>(mesh.points.size());
  const auto corners = aresta::test::box_corners(low, high);
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  for (const auto& s : aresta::test::box_sides) {
    mesh.triangles.push_back({first + s[0], first + s[1], first + s[2]});
    mesh.triangles.push_back({first + s[0], first + s[2], first + s[3]});
  }
}

inline double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) sum += dot(mesh.points[i], cross(mesh.points[j], mesh.points[k]));
  return sum / 6;
}

}  // namespace aresta::planar::test
