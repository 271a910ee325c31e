// SPDX-License-Identifier: Apache-2.0
// Small models by hand for the tests of measures, queries and checks. Every shape may be moved by a similarity.
#pragma once

#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "model/builder.h"

namespace aresta::testing {

inline constexpr double pi = std::numbers::pi;

/// A use of an edge, with its image where one is wanted.
struct Use {
  EdgeId edge;
  bool reversed = false;
  std::optional<Curve2> image = {};
};
inline Use along(EdgeId e) {
  return {e, false};
}
inline Use against(EdgeId e) {
  return {e, true};
}
inline Use along(EdgeId e, Vec2 origin, Vec2 direction) {
  return {e, false, Line2{origin, direction}};
}
inline Use against(EdgeId e, Vec2 origin, Vec2 direction) {
  return {e, true, Line2{origin, direction}};
}

/// A builder whose geometry goes through a similarity.
class Draft {
 public:
  explicit Draft(Transform t = {}) : transform(t) {}

  Transform transform;
  ModelBuilder builder;

  bool mirrored() const { return transform.determinant() < 0; }
  VertexId vertex(Vec3 p, double tolerance = 0) { return builder.add_vertex(transform.point(p), tolerance); }
  EdgeId segment(VertexId a, VertexId b) { return builder.add_edge(a, b); }
  EdgeId arc(VertexId a, VertexId b, const Curve& c, double from, double to) {
    return builder.add_edge(a, b, builder.add_curve(moved(c)), {from, to});
  }
  /// A face whose front looks out of the solid when `solid`. Loops counterclockwise about the face's normal.
  FaceId face(const Surface& s, bool reversed, const std::vector<std::vector<Use>>& loops, bool solid = true) {
    const FaceId f = builder.begin_face(builder.add_surface(moved(s)), reversed);
    for (const auto& loop : loops) {
      for (const Use& use : loop) {
        use.image ? builder.add_coedge(use.edge, use.reversed, *use.image) : builder.add_coedge(use.edge, use.reversed);
      }
      builder.close_loop();
    }
    finish(solid);
    return f;
  }
  FaceId point_face(const Surface& s, bool reversed, VertexId v, bool solid = true) {
    const FaceId f = builder.begin_face(builder.add_surface(moved(s)), reversed);
    builder.add_point_loop(v);
    finish(solid);
    return f;
  }
  void finish(bool solid) {
    builder.end_face();
    // A mirror turns natural normals round.
    if (solid) {
      mirrored() ? builder.set_fill(Fill::filled, Fill::empty) : builder.set_fill(Fill::empty, Fill::filled);
    }
  }
  Curve moved(const Curve& c) const {
    auto r = c.transformed(transform);
    return r.ok() ? *r : c;
  }
  Surface moved(const Surface& s) const {
    auto r = s.transformed(transform);
    return r.ok() ? *r : s;
  }
};

inline Frame frame(Vec3 origin, Vec3 z, Vec3 x) {
  return Frame::along(origin, z, x);
}

/// A plane face through the points (counterclockwise about its normal), with its own vertices' edges given.
inline Plane plane_through(Vec3 a, Vec3 b, Vec3 c) {
  return {Frame::along(a, cross(b - a, c - a), b - a)};
}

/// Faces of a polyhedron: loops of vertex indices, first the outer one; edges are shared.
inline void add_polyhedron(Draft& d, const std::vector<Vec3>& points,
                           const std::vector<std::vector<std::vector<std::size_t>>>& faces, bool solid = true) {
  std::vector<VertexId> v;
  for (const Vec3 p : points) v.push_back(d.vertex(p));
  std::map<std::pair<std::size_t, std::size_t>, EdgeId> edges;
  for (const auto& loops : faces) {
    std::vector<std::vector<Use>> uses;
    for (const auto& loop : loops) {
      uses.emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t a = loop[i], b = loop[(i + 1) % loop.size()];
        if (const auto found = edges.find({b, a}); found != edges.end()) {
          uses.back().push_back(against(found->second));
        } else {
          const auto [at, added] = edges.try_emplace({a, b});
          if (added) at->second = d.segment(v[a], v[b]);
          uses.back().push_back(along(at->second));
        }
      }
    }
    const auto at = [&](std::size_t i) { return points[loops[0][i]]; };
    d.face(plane_through(at(0), at(1), at(2)), false, uses, solid);
  }
}

inline void add_block(Draft& d, Vec3 a, Vec3 b) {
  add_polyhedron(d,
                 {{a.x, a.y, a.z},
                  {b.x, a.y, a.z},
                  {b.x, b.y, a.z},
                  {a.x, b.y, a.z},
                  {a.x, a.y, b.z},
                  {b.x, a.y, b.z},
                  {b.x, b.y, b.z},
                  {a.x, b.y, b.z}},
                 {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}});
}

/// A square frame: outer side 4, hole side 2, height 1.
inline void add_frame(Draft& d) {
  add_polyhedron(d,
                 {{0, 0, 0},
                  {4, 0, 0},
                  {4, 4, 0},
                  {0, 4, 0},
                  {0, 0, 1},
                  {4, 0, 1},
                  {4, 4, 1},
                  {0, 4, 1},
                  {1, 1, 0},
                  {3, 1, 0},
                  {3, 3, 0},
                  {1, 3, 0},
                  {1, 1, 1},
                  {3, 1, 1},
                  {3, 3, 1},
                  {1, 3, 1}},
                 {{{0, 3, 2, 1}, {8, 9, 10, 11}},
                  {{4, 5, 6, 7}, {12, 15, 14, 13}},
                  {{0, 1, 5, 4}},
                  {{1, 2, 6, 5}},
                  {{2, 3, 7, 6}},
                  {{3, 0, 4, 7}},
                  {{9, 8, 12, 13}},
                  {{10, 9, 13, 14}},
                  {{11, 10, 14, 15}},
                  {{8, 11, 15, 12}}});
}

enum class Seam { none, bare, with_images };

/// A frustum about the z axis from z = 0 (radius r0) to z = h (radius r1); a cylinder when they are equal; an apex when
/// r1 = 0.
inline void add_frustum(Draft& d, double r0, double r1, double h, Seam seam) {
  const Frame base;
  const VertexId a = d.vertex({r0, 0, 0}), b = d.vertex({r1, 0, h});
  const EdgeId bottom = d.arc(a, a, Circle{base, r0}, 0, 2 * pi);
  const double slant = std::hypot(h, r1 - r0);
  const Surface side = r0 == r1 ? Surface(Cylinder{base, r0}) : Surface(Cone{base, r0, std::atan2(r1 - r0, h)});
  const double k = std::cbrt(std::abs(d.transform.determinant()));  // images along v are lengths
  EdgeId top;
  if (r1 > 0) top = d.arc(b, b, Circle{{{0, 0, h}, base.x, base.y, base.z}, r1}, 0, 2 * pi);
  if (seam == Seam::none) {
    std::vector<std::vector<Use>> loops{{along(bottom)}};
    if (r1 > 0) loops.push_back({against(top)});
    d.face(side, false, loops);
  } else {
    const EdgeId s = d.segment(a, b);
    if (seam == Seam::bare) {
      std::vector<Use> loop{along(bottom), along(s)};
      if (r1 > 0) loop.push_back(against(top));
      loop.push_back(against(s));
      d.face(side, false, {loop});
    } else {
      std::vector<Use> loop{along(bottom, {0, 0}, {1, 0}), along(s, {2 * pi, 0}, {0, 1})};
      if (r1 > 0) loop.push_back(against(top, {0, k * slant}, {1, 0}));
      loop.push_back(against(s, {0, 0}, {0, 1}));
      d.face(side, false, {loop});
    }
  }
  d.face(Plane{{{0, 0, 0}, base.x, -base.y, -base.z}}, false, {{against(bottom)}});
  if (r1 > 0) d.face(Plane{{{0, 0, h}, base.x, base.y, base.z}}, false, {{along(top)}});
}

/// A whole sphere: no edge but a point, or a seam from pole to pole.
inline void add_sphere(Draft& d, double r, Seam seam) {
  const Frame f;
  if (seam == Seam::none) {
    d.point_face(Sphere{f, r}, false, d.vertex({r, 0, 0}));
    return;
  }
  const VertexId south = d.vertex({0, 0, -r}), north = d.vertex({0, 0, r});
  const EdgeId s = d.arc(south, north, Circle{{{}, f.x, f.z, -f.y}, r}, -pi / 2, pi / 2);
  if (seam == Seam::bare) {
    d.face(Sphere{f, r}, false, {{along(s), against(s)}});
  } else {
    d.face(Sphere{f, r}, false, {{along(s, {2 * pi, 0}, {0, 1}), against(s, {0, 0}, {0, 1})}});
  }
}

/// The part of the sphere of radius r about the origin above the plane z = c, closed by the plane.
inline void add_cap(Draft& d, double r, double c) {
  const double q = std::sqrt(r * r - c * c);
  const VertexId a = d.vertex({q, 0, c});
  const Frame f{{0, 0, c}};
  const EdgeId rim = d.arc(a, a, Circle{f, q}, 0, 2 * pi);
  d.face(Sphere{{}, r}, false, {{along(rim)}});
  d.face(Plane{{{0, 0, c}, f.x, -f.y, -f.z}}, false, {{against(rim)}});
}

/// The part of the same sphere with x >= c: the circle goes around no pole of the sphere.
inline void add_side_cap(Draft& d, double r, double c) {
  const double q = std::sqrt(r * r - c * c);
  const Frame f = Frame::along({c, 0, 0}, {1, 0, 0});
  const VertexId a = d.vertex(f.origin + q * f.x);
  const EdgeId rim = d.arc(a, a, Circle{f, q}, 0, 2 * pi);
  d.face(Sphere{{}, r}, false, {{along(rim)}});
  d.face(Plane{{f.origin, f.x, -f.y, -f.z}}, false, {{against(rim)}});
}

/// A whole torus: one vertex and no edge, or both seams.
inline void add_torus(Draft& d, double major, double minor, Seam seam) {
  const Frame f;
  const VertexId a = d.vertex({major + minor, 0, 0});
  if (seam == Seam::none) {
    d.point_face(Torus{f, major, minor}, false, a);
    return;
  }
  const EdgeId around = d.arc(a, a, Circle{f, major + minor}, 0, 2 * pi);
  const EdgeId across = d.arc(a, a, Circle{{{major, 0, 0}, f.x, f.z, -f.y}, minor}, 0, 2 * pi);
  if (seam == Seam::bare) {
    d.face(Torus{f, major, minor}, false, {{along(around), along(across), against(around), against(across)}});
  } else {
    d.face(Torus{f, major, minor}, false,
           {{along(around, {0, 0}, {1, 0}), along(across, {2 * pi, 0}, {0, 1}), against(around, {0, 2 * pi}, {1, 0}),
             against(across, {0, 0}, {0, 1})}});
  }
}

/// The part of the torus with y >= 0 (angles 0 to pi), closed by two discs: its loops wind around the tube.
inline void add_half_torus(Draft& d, double major, double minor) {
  const Frame f;
  const Frame disc0{{major, 0, 0}, f.x, f.z, -f.y}, disc1{{-major, 0, 0}, -f.x, f.z, f.y};
  const VertexId a = d.vertex({major + minor, 0, 0}), b = d.vertex({-major - minor, 0, 0});
  const EdgeId e0 = d.arc(a, a, Circle{disc0, minor}, 0, 2 * pi), e1 = d.arc(b, b, Circle{disc1, minor}, 0, 2 * pi);
  d.face(Torus{f, major, minor}, false, {{against(e0)}, {along(e1)}});
  d.face(Plane{disc0}, false, {{along(e0)}});
  d.face(Plane{{disc1.origin, disc1.x, -disc1.y, -disc1.z}}, false, {{against(e1)}});
}

/// The part of the torus with z >= 0: its loops wind around the axis.
inline void add_upper_torus(Draft& d, double major, double minor) {
  const Frame f;
  const VertexId a = d.vertex({major + minor, 0, 0}), b = d.vertex({major - minor, 0, 0});
  const EdgeId outer = d.arc(a, a, Circle{f, major + minor}, 0, 2 * pi);
  const EdgeId inner = d.arc(b, b, Circle{f, major - minor}, 0, 2 * pi);
  d.face(Torus{f, major, minor}, false, {{along(outer)}, {against(inner)}});
  d.face(Plane{{{}, f.x, -f.y, -f.z}}, false, {{against(outer)}, {along(inner)}});
}

/// A cylinder of radius r about z from z = 0 up to the plane z = h + slope x.
inline void add_oblique(Draft& d, double r, double h, double slope) {
  const Frame base;
  const Vec3 major = normalized({1, 0, slope});
  const VertexId a = d.vertex({r, 0, 0}), b = d.vertex({r, 0, h + slope * r});
  const Frame cut{{0, 0, h}, major, {0, 1, 0}, cross(major, Vec3{0, 1, 0})};
  const EdgeId bottom = d.arc(a, a, Circle{base, r}, 0, 2 * pi);
  const EdgeId top = d.arc(b, b, Ellipse{cut, r * std::sqrt(1 + slope * slope), r}, 0, 2 * pi);
  const EdgeId s = d.segment(a, b);
  d.face(Cylinder{base, r}, false, {{along(bottom), along(s), against(top), against(s)}});
  d.face(Plane{{{}, base.x, -base.y, -base.z}}, false, {{against(bottom)}});
  d.face(Plane{cut}, false, {{along(top)}});
}

/// Steinmetz's solid: common part of two cylinders of radius r about x and about y. Four faces, four half ellipses, two
/// vertices.
inline void add_steinmetz(Draft& d, double r) {
  const VertexId top = d.vertex({0, 0, r}), bottom = d.vertex({0, 0, -r});
  const double q = std::sqrt(0.5);
  // Half ellipses in the planes x = y and x = -y: from the bottom through (sx r, sy r, 0) to the top.
  const auto half = [&](double sx, double sy) {
    const Vec3 out{q * sx, q * sy, 0}, up{0, 0, 1};
    return d.arc(bottom, top, Ellipse{{{}, out, up, cross(out, up)}, r / q, r}, -pi / 2, pi / 2);
  };
  const EdgeId pp = half(1, 1), pm = half(1, -1), mp = half(-1, 1), mm = half(-1, -1);
  const Surface about_x = Cylinder{Frame{{}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, r};
  const Surface about_y = Cylinder{Frame{{}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, r};
  // Where |x| <= |y| the cylinder about x bounds.
  d.face(about_x, false, {{along(mp), against(pp)}});
  d.face(about_x, false, {{along(pm), against(mm)}});
  d.face(about_y, false, {{along(pp), against(pm)}});
  d.face(about_y, false, {{along(mm), against(mp)}});
}

}  // namespace aresta::testing
