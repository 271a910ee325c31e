// SPDX-License-Identifier: Apache-2.0
#include "draw/screen_scene.h"

namespace aresta::draw {

double near_depth(const View& view) {
  return 1e-4 * distance(view.camera.eye, view.camera.target);
}

ScreenScene project(const View& view, const Projector& projector, int samples, bool faces,
                    const std::vector<DrawnLine>& lines, double edge_radius, double point_radius) {
  const bool clips = projector.perspective();
  const double near = near_depth(view);
  const auto screen = [&](Vec3 v) {
    const Vec3 s = projector.view_to_screen(v);
    return Vec3{s.x * samples, s.y * samples, s.z};
  };
  const auto at_near = [&](Vec3 a, Vec3 b) { return lerp(a, b, (near - a.z) / (b.z - a.z)); };

  ScreenScene result;
  std::vector<Vec3> in_view;
  for (std::uint32_t f = 0; faces && f < view.scene.faces.size(); ++f) {
    const FacePatch& patch = view.scene.faces[f];
    in_view.clear();
    for (const Vec3 p : patch.points) in_view.push_back(projector.to_view(p));
    for (std::uint32_t t = 0; t < patch.triangles.size(); ++t) {
      const auto& [i, j, k] = patch.triangles[t];
      const std::array<Vec3, 3> corners{in_view[i], in_view[j], in_view[k]};
      std::array<Vec3, 4> polygon;
      int n = 0;
      for (int c = 0; c < 3; ++c) {
        const Vec3 p = corners[c], q = corners[(c + 1) % 3];
        const bool p_in = !clips || p.z >= near, q_in = !clips || q.z >= near;
        if (p_in) polygon[n++] = p;
        if (p_in != q_in) polygon[n++] = at_near(p, q);
      }
      for (int c = 2; c < n; ++c) {
        result.triangles.push_back({{screen(polygon[0]), screen(polygon[c - 1]), screen(polygon[c])}, f, t});
      }
    }
  }

  // Wires last: where one coincides with an edge of a face, the edge is seen.
  for (const bool wires : {false, true}) {
    for (std::uint32_t source = 0; source < lines.size(); ++source) {
      const DrawnLine& line = lines[source];
      if ((line.kind == LineKind::wire) != wires) continue;
      const double radius = line.kind == LineKind::silhouette ? 0.75 * edge_radius : edge_radius;
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        if (!line.behind.empty() && line.behind[i - 1]) continue;
        Vec3 a = projector.to_view(line.points[i - 1]), b = projector.to_view(line.points[i]);
        if (clips && a.z < near && b.z < near) continue;
        if (clips && a.z < near) a = at_near(a, b);
        if (clips && b.z < near) b = at_near(b, a);
        result.lines.push_back({screen(a), screen(b), radius, line.color, source});
      }
    }
  }
  for (const PointMark& mark : view.scene.points) {
    const Vec3 v = projector.to_view(mark.point);
    if (clips && v.z < near) continue;
    result.lines.push_back({screen(v), screen(v), point_radius, mark.color});
  }
  return result;
}

}  // namespace aresta::draw
