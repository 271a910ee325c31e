// SPDX-License-Identifier: Apache-2.0
// The full level: entities that are not neighbours and meet.
#include <gtest/gtest.h>

#include "model/check.h"
#include "model/measure_shapes.h"
#include "support/stitched.h"

using namespace aresta;
using namespace aresta::testing;
using aresta::test::Stitched;

namespace {

Model built(ModelBuilder& b) {
  auto model = b.build(Context{});
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().to_line());
  return model.ok() ? std::move(model).value() : Model{};
}

std::vector<Finding> found(const Model& m) {
  EXPECT_TRUE(check(m, CheckLevel::fast)->empty()) << "only the full level sees it";
  auto findings = check(m, CheckLevel::full);
  return findings.ok() ? *findings : std::vector<Finding>{};
}

std::size_t count(const std::vector<Finding>& findings, FindingKind kind, std::vector<EntityRef> entities = {}) {
  std::size_t n = 0;
  for (const Finding& f : findings) n += f.kind == kind && (entities.empty() || f.entities == entities);
  return n;
}

}  // namespace

TEST(CheckMeetings, VerticesCoincide) {
  ModelBuilder b;
  const VertexId u = b.add_vertex({1, 0, 0}), v = b.add_vertex({1, 1e-10, 0});
  b.add_vertex({2, 0, 0});
  const auto f = found(built(b));
  ASSERT_EQ(f.size(), 1u);
  EXPECT_EQ(f[0].kind, FindingKind::vertices_coincide);
  EXPECT_EQ(f[0].entities, (std::vector<EntityRef>{u, v}));
  EXPECT_NEAR(f[0].value, 1e-10, 1e-20);
}

TEST(CheckMeetings, EdgesMeet) {
  ModelBuilder b;
  const auto line = [&](Vec3 p, Vec3 q) { return b.add_edge(b.add_vertex(p), b.add_vertex(q)); };
  const EdgeId a = line({0, 0, 0}, {4, 0, 0}), crossing = line({1, -1, 0}, {1, 1, 0}),
               touching = line({2, 0, 0}, {2, 0, 3}), overlapping = line({3, 0, 0}, {6, 0, 0}),
               near = line({0, 0.01, 0}, {0.5, 0.01, 0});
  const EdgeId arc = b.add_edge(b.add_vertex({4, 5, 0}), b.add_vertex({6, 5, 0}),
                                b.add_curve(Circle{{{5, 5, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, 1}), {0, pi});
  const EdgeId chord = line({4, 4.5, 0}, {6, 4.5, 0});
  const auto f = found(built(b));
  const auto pair = [&](EdgeId x, EdgeId y) { return count(f, FindingKind::edges_coincide, {x, y}); };
  EXPECT_EQ(pair(a, crossing), 1u);
  EXPECT_EQ(pair(a, touching), 1u);
  EXPECT_EQ(pair(a, overlapping), 1u);
  EXPECT_EQ(pair(a, near), 0u);
  EXPECT_EQ(pair(arc, chord), 1u);
  EXPECT_EQ(f.size(), 4u);
}

TEST(CheckMeetings, EdgesThatShareAVertexMayBeTangentThere) {
  ModelBuilder b;
  const VertexId o = b.add_vertex({0, 0, 0}), p = b.add_vertex({3, 0, 0}), q = b.add_vertex({2, 2, 0}),
                 r = b.add_vertex({0.5, 0, 0}), s = b.add_vertex({4, 0, 1e-3});
  b.add_edge(o, p);
  b.add_edge(o, q, b.add_curve(Circle{{{0, 2, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}}, 2}), {0, pi / 2});
  b.add_edge(o, s);
  EXPECT_EQ(count(found(built(b)), FindingKind::edges_coincide), 0u);
  const EdgeId shorter = b.add_edge(o, r);  // overlaps the first one from the shared vertex on
  const auto f = found(built(b));
  EXPECT_EQ(count(f, FindingKind::edges_coincide, {EdgeId(0), shorter}), 1u);
}

TEST(CheckMeetings, EdgeCrossesFace) {
  Stitched s;
  const FaceId f = s.face({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}});
  const EdgeId through = s.edge({0.5, 0.5, -1}, {0.5, 0.5, 1}), hole = s.edge({2, 2, -1}, {2, 2, 1}),
               ends = s.edge({3.5, 3.5, 0}, {3.5, 3.5, 1}), in_plane = s.edge({0.5, 2, 0}, {0.5, 3, 0}),
               corner = s.edge({4, 4, 0}, {5, 5, 1}), beyond = s.edge({4.5, 2, -1}, {4.5, 2, 1});
  const auto found_ = found(built(s.builder));
  const auto pair = [&](EdgeId e) { return count(found_, FindingKind::edge_crosses_face, {e, f}); };
  EXPECT_EQ(pair(through), 1u);
  EXPECT_EQ(pair(ends), 1u);
  EXPECT_EQ(pair(in_plane), 1u);
  EXPECT_EQ(pair(hole), 0u);
  EXPECT_EQ(pair(corner), 0u);
  EXPECT_EQ(pair(beyond), 0u);
  EXPECT_EQ(found_.size(), 3u);
}

TEST(CheckMeetings, EdgeCrossesCurvedFace) {
  Draft d;
  add_frustum(d, 2, 2, 5, Seam::none);
  const auto line = [&](Vec3 p, Vec3 q) { return d.segment(d.vertex(p), d.vertex(q)); };
  const EdgeId out = line({0, 0, 2}, {5, 1, 3}), within = line({0.5, 0, 1}, {0.5, 0.5, 4}),
               above = line({-5, 0, 6}, {5, 0, 6}), touching = line({2, -4, 2.5}, {2, 4, 2.5});
  const VertexId v = d.vertex({1, 0, 3.6});
  const EdgeId ring = d.arc(v, v, Circle{{{2, 0, 3.6}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, 1}, 0, 2 * pi);
  const auto f = found(built(d.builder));
  EXPECT_EQ(count(f, FindingKind::edge_crosses_face, {out, FaceId(0)}), 1u);
  EXPECT_EQ(count(f, FindingKind::edge_crosses_face, {ring, FaceId(0)}), 1u);
  for (const EdgeId e : {within, above, touching}) {
    EXPECT_EQ(count(f, FindingKind::edge_crosses_face, {e, FaceId(0)}), 0u);
  }
  EXPECT_EQ(f.size(), 2u);
}

TEST(CheckMeetings, PlaneFacesIntersect) {
  {
    // Two squares that share opposite corners and cross along the diagonal between them: no edge pierces a face.
    Stitched s;
    s.face({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}});
    s.face({{{0, 0, 0}, {1, 1, -1}, {2, 2, 0}, {1, 1, 1}}});
    const auto f = found(built(s.builder));
    ASSERT_EQ(f.size(), 1u);
    EXPECT_EQ(f[0].kind, FindingKind::faces_intersect);
    EXPECT_NEAR(f[0].place.z, 0, 1e-9);
  }
  {
    // Coplanar faces: one inside the other; beside it, one in its hole that shares the hole's edges.
    Stitched s;
    s.face({{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}});
    s.face({{{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}}});
    EXPECT_TRUE(found(built(s.builder)).empty());
    s.face({{{5, 5, 0}, {6, 5, 0}, {6, 6, 0}, {5, 6, 0}}});
    const auto f = found(built(s.builder));
    EXPECT_EQ(count(f, FindingKind::faces_intersect, {FaceId(0), FaceId(2)}), 1u);
    EXPECT_EQ(count(f, FindingKind::faces_intersect), 1u);
  }
  {
    // A disc through a square.
    Draft d;
    const VertexId v = d.vertex({1, 0, 0});
    const EdgeId ring = d.arc(v, v, Circle{{}, 1}, 0, 2 * pi);
    d.face(Plane{}, false, {{along(ring)}}, false);
    add_polyhedron(d, {{0, -0.5, -0.5}, {0, 0.5, -0.5}, {0, 0.5, 0.5}, {0, -0.5, 0.5}}, {{{0, 1, 2, 3}}}, false);
    const auto f = found(built(d.builder));
    EXPECT_EQ(count(f, FindingKind::faces_intersect, {FaceId(0), FaceId(1)}), 1u);
    EXPECT_EQ(count(f, FindingKind::edge_crosses_face), 2u);
  }
}

TEST(CheckMeetings, CurvedFacesIntersect) {
  {
    // Two spheres without edges that overlap, as sheets; then the same apart.
    for (const double x : {2.5, 4.5}) {
      Draft d;
      d.point_face(Sphere{{}, 2}, false, d.vertex({-2, 0, 0}), false);
      d.point_face(Sphere{{{x, 0, 0}}, 2}, false, d.vertex({x + 2, 0, 0}), false);
      const Model m = built(d.builder);
      const auto f = *check(m, CheckLevel::full);
      EXPECT_EQ(count(f, FindingKind::faces_intersect), x < 4 ? 1u : 0u);
    }
  }
  {
    // Pieces of one cylinder: a whole band and a narrower one on it.
    Draft d;
    const auto ring = [&](double z) {
      const VertexId v = d.vertex({2, 0, z});
      return d.arc(v, v, Circle{{{0, 0, z}}, 2}, 0, 2 * pi);
    };
    const EdgeId a = ring(0), b = ring(5), p = ring(1), q = ring(2);
    d.face(Cylinder{{}, 2}, false, {{along(a)}, {against(b)}}, false);
    d.face(Cylinder{{}, 2}, false, {{along(p)}, {against(q)}}, false);
    const auto f = found(built(d.builder));
    EXPECT_EQ(count(f, FindingKind::faces_intersect, {FaceId(0), FaceId(1)}), 1u);
  }
}
