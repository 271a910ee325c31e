// SPDX-License-Identifier: Apache-2.0
// Small models for mesh tests, put together vertex by vertex.
#pragma once

#include <map>
#include <numbers>
#include <stdexcept>

#include "model/builder.h"

namespace aresta::test {

inline constexpr double pi = std::numbers::pi;

/// A builder that reuses vertices and straight edges by their places.
class Shapes {
 public:
  ModelBuilder builder;

  VertexId vertex(Vec3 p) {
    const auto [it, added] = vertices_.try_emplace({p.x, p.y, p.z}, VertexId());
    if (added) it->second = builder.add_vertex(p);
    return it->second;
  }

  /// What lies before and behind the face ended last: 1 a region, 0 none.
  void set_regions(int front, int back) {
    const auto fill = [](int region) { return region > 0 ? Fill::filled : Fill::empty; };
    builder.set_fill(fill(front), fill(back));
  }

  /// A straight edge of its own.
  EdgeId wire(Vec3 a, Vec3 b) {
    bool reversed = false;
    return edge(a, b, reversed);
  }

  /// Straight; `reversed` tells that it was made the other way round.
  EdgeId edge(Vec3 a, Vec3 b, bool& reversed) {
    const VertexId va = vertex(a), vb = vertex(b);
    reversed = vb < va;
    const auto [it, added] = edges_.try_emplace({std::min(va, vb), std::max(va, vb)}, EdgeId());
    if (added) it->second = builder.add_edge(std::min(va, vb), std::max(va, vb));
    return it->second;
  }

  void polygon_loop(const std::vector<Vec3>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool reversed = false;
      const EdgeId e = edge(points[i], points[(i + 1) % points.size()], reversed);
      builder.add_coedge(e, reversed);
    }
    builder.close_loop();
  }

  /// Begins a plane face with the polygon as outer loop, counterclockwise about the normal; end_face is the caller's.
  FaceId begin_polygon(const std::vector<Vec3>& points) {
    const Vec3 normal = cross(points[1] - points[0], points[2] - points[0]);
    const FaceId f = builder.begin_face(builder.add_surface(Plane{Frame::along(points[0], normal)}), false);
    polygon_loop(points);
    return f;
  }

  FaceId polygon(const std::vector<Vec3>& points, int front, int back) {
    const FaceId f = begin_polygon(points);
    builder.end_face();
    set_regions(front, back);
    return f;
  }

  /// Six faces: -x, +x, -y, +y, -z, +z, normals outward; `skip` leaves one out.
  void box(Vec3 a, Vec3 b, int inside = 1, int outside = 0, int skip = -1) {
    const auto c = [&](int i) { return Vec3{i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z}; };
    const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (int f = 0; f < 6; ++f) {
      if (f != skip) polygon({c(faces[f][0]), c(faces[f][1]), c(faces[f][2]), c(faces[f][3])}, outside, inside);
    }
  }

  /// A circle as one closed edge starting at centre + r x.
  EdgeId circle(const Frame& frame, double radius) {
    const VertexId v = vertex(frame.origin + radius * frame.x);
    return builder.add_edge(v, v, builder.add_curve(Circle{frame, radius}), {0, 2 * pi});
  }

  /// The side of a cylinder between two circles of radius r about the z axis through `base`, normal outward, with a
  /// seam. The circles are given by their edges, both counterclockwise about z.
  FaceId cylinder_side(Vec3 base, double radius, double height, EdgeId bottom, EdgeId top, int outside, int inside) {
    const Frame frame{base};
    bool reversed = false;
    const EdgeId seam = edge(base + Vec3{radius, 0, 0}, base + Vec3{radius, 0, height}, reversed);
    const FaceId f = builder.begin_face(builder.add_surface(Cylinder{frame, radius}), false);
    const auto line = [](Vec2 o, Vec2 d) { return Curve2(Line2{o, d}); };
    builder.add_coedge(bottom, false, line({0, 0}, {1, 0}));
    const double s = reversed ? -1 : 1, start = reversed ? height : 0;
    builder.add_coedge(seam, reversed, line({2 * pi, start}, {0, s}));
    builder.add_coedge(top, true, line({0, height}, {1, 0}));
    builder.add_coedge(seam, !reversed, line({0, start}, {0, s}));
    builder.close_loop();
    builder.end_face();
    set_regions(outside, inside);
    return f;
  }

  /// A disc with normal along z (up) or against it, bounded by a circle that runs counterclockwise about z.
  FaceId disc(Vec3 centre, EdgeId rim, bool up, int front, int back) {
    const FaceId f = builder.begin_face(builder.add_surface(Plane{Frame{centre}}), !up);
    builder.add_coedge(rim, !up);
    builder.close_loop();
    builder.end_face();
    set_regions(front, back);
    return f;
  }

  void cylinder(Vec3 base, double radius, double height) {
    const EdgeId bottom = circle(Frame{base}, radius), top = circle(Frame{base + Vec3{0, 0, height}}, radius);
    cylinder_side(base, radius, height, bottom, top, 0, 1);
    disc(base, bottom, false, 0, 1);
    disc(base + Vec3{0, 0, height}, top, true, 0, 1);
  }

  /// A whole sphere: one face, one seam from pole to pole; normal outward.
  FaceId sphere(Vec3 centre, double radius, int outside, int inside) {
    const Frame frame{centre};
    const VertexId south = vertex(centre - Vec3{0, 0, radius}), north = vertex(centre + Vec3{0, 0, radius});
    // In the plane of x and z, from -pi/2 to pi/2.
    const Frame meridian{centre, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    const EdgeId seam = builder.add_edge(south, north, builder.add_curve(Circle{meridian, radius}), {-pi / 2, pi / 2});
    const FaceId f = builder.begin_face(builder.add_surface(Sphere{frame, radius}), false);
    builder.add_coedge(seam, false, Curve2(Line2{{2 * pi, 0}, {0, 1}}));
    builder.add_coedge(seam, true, Curve2(Line2{{0, 0}, {0, 1}}));
    builder.close_loop();
    builder.end_face();
    set_regions(outside, inside);
    return f;
  }

  /// A whole torus about z: one face, two seams, one vertex.
  FaceId torus(Vec3 centre, double major, double minor, int outside, int inside) {
    const Frame frame{centre};
    const VertexId v = vertex(centre + Vec3{major + minor, 0, 0});
    const EdgeId equator = builder.add_edge(v, v, builder.add_curve(Circle{frame, major + minor}), {0, 2 * pi});
    const Frame section{centre + Vec3{major, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    const EdgeId around = builder.add_edge(v, v, builder.add_curve(Circle{section, minor}), {0, 2 * pi});
    const FaceId f = builder.begin_face(builder.add_surface(Torus{frame, major, minor}), false);
    builder.add_coedge(equator, false, Curve2(Line2{{0, 0}, {1, 0}}));
    builder.add_coedge(around, false, Curve2(Line2{{2 * pi, 0}, {0, 1}}));
    builder.add_coedge(equator, true, Curve2(Line2{{0, 2 * pi}, {1, 0}}));
    builder.add_coedge(around, true, Curve2(Line2{{0, 0}, {0, 1}}));
    builder.close_loop();
    builder.end_face();
    set_regions(outside, inside);
    return f;
  }

  /// A plane ring between two circles that run counterclockwise about z, normal up or down; a solid lies behind it.
  FaceId ring(Vec3 centre, EdgeId outer, EdgeId inner, bool up) {
    const FaceId f = builder.begin_face(builder.add_surface(Plane{Frame{centre}}), !up);
    builder.add_coedge(outer, !up);
    builder.close_loop();
    builder.add_coedge(inner, up);
    builder.close_loop();
    builder.end_face();
    set_regions(0, 1);
    return f;
  }

  /// The block [-half, half]^2 x [0, height] with a hole of radius r along z through its middle.
  void block_with_hole(double half, double height, double radius) {
    const EdgeId bottom = circle(Frame{}, radius), top = circle(Frame{{0, 0, height}}, radius);
    const auto corner = [&](int i, double z) {
      return Vec3{i == 1 || i == 2 ? half : -half, i >= 2 ? half : -half, z};
    };
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      polygon({corner(i, 0), corner(j, 0), corner(j, height), corner(i, height)}, 0, 1);
    }
    begin_polygon({corner(0, height), corner(1, height), corner(2, height), corner(3, height)});
    builder.add_coedge(top, true);
    builder.close_loop();
    builder.end_face();
    set_regions(0, 1);
    begin_polygon({corner(3, 0), corner(2, 0), corner(1, 0), corner(0, 0)});
    builder.add_coedge(bottom, false);
    builder.close_loop();
    builder.end_face();
    set_regions(0, 1);
    cylinder_side({}, radius, height, bottom, top, 1, 0);
  }

  Model model() {
    auto built = builder.build(Context{});
    if (!built.ok()) throw std::runtime_error(built.error().to_line());
    return std::move(built).value();
  }

 private:
  std::map<std::array<double, 3>, VertexId> vertices_;
  std::map<std::pair<VertexId, VertexId>, EdgeId> edges_;
};

}  // namespace aresta::test
