// SPDX-License-Identifier: Apache-2.0
// Independent looks at built models: counts, Euler-Poincare, and whether points, curves, images and surfaces agree.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "construct/options.h"
#include "model/model.h"

namespace aresta {

struct Counts {
  std::size_t vertices = 0, edges = 0, faces = 0, regions = 0;
  bool operator==(const Counts&) const = default;
  friend void PrintTo(const Counts& c, std::ostream* out) {
    *out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces, " << c.regions << " regions";
  }
};

inline Counts counts(const Model& m) {
  const Complex& k = m.topology();
  return {k.vertex_count(), k.edge_count(), k.face_count(), m.regions().size()};
}

/// V - E + F - (L - F) of everything: 2 for a solid without handles, 0 for a torus.
inline long euler(const Model& m) {
  const Complex& k = m.topology();
  return static_cast<long>(k.vertex_count()) - static_cast<long>(k.edge_count()) +
         2 * static_cast<long>(k.face_count()) - static_cast<long>(k.loop_count());
}

/// The largest gap between neighbouring geometry: ends of curves and vertices, images on surfaces and curves.
inline double largest_gap(const Model& m) {
  const Complex& k = m.topology();
  double gap = 0;
  for (const EdgeId e : k.edges()) {
    gap = std::max(gap, distance(m.edge_point(e, m.range(e).low), m.point(k.start(e))));
    gap = std::max(gap, distance(m.edge_point(e, m.range(e).high), m.point(k.end(e))));
  }
  for (const CoedgeId c : k.coedges()) {
    const Surface& surface = m.surface(k.face(c));
    for (int i = 0; i <= 8; ++i) {
      const double t = m.range(k.edge(c)).at(i / 8.0);
      gap = std::max(gap, distance(surface.point(m.uv(c, t)), m.edge_point(k.edge(c), t)));
    }
  }
  return gap;
}

/// Signed area of the face's images in its parameter plane, counterclockwise about the face's own normal positive: a
/// loop that runs the wrong way round, or a seam's images swapped, makes it negative or zero.
inline double image_area(const Model& m, FaceId f) {
  const Complex& k = m.topology();
  double twice = 0;
  for (const LoopId l : k.loops(f)) {
    std::vector<Vec2> path;
    for (const CoedgeId c : k.coedges(l)) {
      const Range r = m.range(k.edge(c));
      for (int i = 0; i < 64; ++i) path.push_back(m.uv(c, r.at(k.reversed(c) ? 1 - i / 64.0 : i / 64.0)));
      path.push_back(m.uv(c, k.reversed(c) ? r.low : r.high));
    }
    for (std::size_t i = 0; i < path.size(); ++i) twice += cross(path[i], path[(i + 1) % path.size()]);
  }
  return 0.5 * (m.is_reversed(f) ? -twice : twice);
}

inline bool loops_enclose(const Model& m) {
  for (const FaceId f : m.topology().faces()) {
    if (!(image_area(m, f) > 0)) return false;
  }
  return true;
}

/// Does the front of every face of a solid look outward: is every front in infinite space and every back filled?
inline bool looks_outward(const Model& m) {
  const Complex& k = m.topology();
  for (const FaceId f : k.faces()) {
    if (k.region(FaceUse(f, 0)) != Complex::infinite_region() || !m.is_region(k.region(FaceUse(f, 1)))) return false;
  }
  return true;
}

#define ASSERT_BUILT(result) ASSERT_TRUE((result).ok()) << (result).error().to_line()

template <class T>
void expect_error(const Result<T>& result, ErrorCode code, const std::string& says) {
  ASSERT_FALSE(result.ok()) << "expected an error that says: " << says;
  EXPECT_EQ(result.error().code.name, std::string(code.name)) << result.error().to_line();
  EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().to_line();
}

}  // namespace aresta
