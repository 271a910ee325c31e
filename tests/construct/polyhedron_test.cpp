// SPDX-License-Identifier: Apache-2.0
#include "audit.h"
#include "construct/primitives.h"

namespace aresta {
namespace {

std::vector<Vec3> cube_points(double low, double high) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back({(i & 1) ? high : low, (i & 2) ? high : low, (i & 4) ? high : low});
  return points;
}

std::vector<PolyhedronFace> cube_faces(std::size_t first = 0, bool inward = false) {
  std::vector<PolyhedronFace> faces;
  for (std::vector<std::size_t> loop :
       {std::vector<std::size_t>{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    if (inward) std::reverse(loop.begin(), loop.end());
    for (std::size_t& i : loop) i += first;
    faces.push_back({{loop}});
  }
  return faces;
}

template <class T>
std::vector<T> joined(std::vector<T> a, const std::vector<T>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(Polyhedron, Cube) {
  const auto m = polyhedron(cube_points(0, 2), cube_faces());
  ASSERT_BUILT(m);
  EXPECT_EQ(counts(*m), (Counts{8, 12, 6, 1}));
  EXPECT_TRUE(looks_outward(*m));
  EXPECT_EQ(euler(*m), 2);
}

TEST(Polyhedron, VoidAndSeparateSolids) {
  const auto hollow =
      polyhedron(joined(cube_points(0, 3), cube_points(1, 2)), joined(cube_faces(), cube_faces(8, true)));
  ASSERT_BUILT(hollow);
  EXPECT_EQ(counts(*hollow), (Counts{16, 24, 12, 1}));
  EXPECT_EQ(hollow->topology().region_count(), 3u);  // infinite space, the solid, the void
  const auto two = polyhedron(joined(cube_points(0, 1), cube_points(2, 3)), joined(cube_faces(), cube_faces(8)));
  ASSERT_BUILT(two);
  EXPECT_EQ(counts(*two), (Counts{16, 24, 12, 2}));
}

TEST(Polyhedron, FaceWithAHole) {
  // A square frame: [0,3]^2 x [0,1] less [1,2]^2.
  std::vector<Vec3> points;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [low, high] : {std::pair{0.0, 3.0}, {1.0, 2.0}}) {
      points.insert(points.end(), {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}});
    }
  }
  std::vector<PolyhedronFace> faces{{{{8, 9, 10, 11}, {12, 13, 14, 15}}}, {{{3, 2, 1, 0}, {4, 5, 6, 7}}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    faces.push_back({{{i, j, 8 + j, 8 + i}}});
    faces.push_back({{{4 + j, 4 + i, 12 + i, 12 + j}}});
  }
  const auto m = polyhedron(points, faces);
  ASSERT_BUILT(m);
  EXPECT_EQ(counts(*m), (Counts{16, 24, 10, 1}));
  EXPECT_EQ(euler(*m), 0);  // one handle
  EXPECT_TRUE(loops_enclose(*m));
}

TEST(Polyhedron, TouchingSolidsMayShareAnEdge) {
  std::vector<Vec3> points = joined(cube_points(0, 1), cube_points(1, 2));
  for (std::size_t i = 8; i < 16; ++i) points[i].z -= 1;  // now they share the edge x = y = 1, 0 <= z <= 1
  const auto m = polyhedron(points, joined(cube_faces(), cube_faces(8)));
  ASSERT_BUILT(m);
  EXPECT_EQ(counts(*m), (Counts{14, 23, 12, 2}));
}

TEST(Polyhedron, WrongInputIsRefusedAndNamed) {
  const auto points = cube_points(0, 1);
  const auto faces = cube_faces();
  const auto without_last = std::vector<PolyhedronFace>(faces.begin(), faces.end() - 1);
  expect_error(polyhedron(points, without_last), errors::not_closed, "has no other face");
  expect_error(polyhedron(points, cube_faces(0, true)), errors::inside_out, "they look inward");
  auto one_turned = faces;
  std::reverse(one_turned[2].loops[0].begin(), one_turned[2].loops[0].end());
  expect_error(polyhedron(points, one_turned), errors::inside_out, "do not look the same way");
  auto bent = points;
  bent[7].z += 0.01;
  expect_error(polyhedron(bent, faces), errors::not_planar, "face 5 do not lie in one plane");
  auto crossed = faces;
  std::swap(crossed[0].loops[0][1], crossed[0].loops[0][2]);
  expect_error(polyhedron(points, crossed), errors::bad_size, "face 0 has no area");
  auto bow_tie = joined(points, {{0, 0.5, 3}});
  auto pierced = faces;
  pierced[5].loops[0] = {4, 5, 7, 6, 5};
  expect_error(polyhedron(points, pierced), errors::self_intersection, "boundary of face 5 meets itself");
  auto unknown = faces;
  unknown[3].loops[0][1] = 8;
  expect_error(polyhedron(points, unknown), errors::bad_size, "face 3 must be made of indices below");
  auto short_loop = faces;
  short_loop[3].loops[0] = {1, 2};
  expect_error(polyhedron(points, short_loop), errors::bad_size, "loops of three points or more");
  auto twice = points;
  twice[1] = twice[0];
  expect_error(polyhedron(twice, faces), errors::points_coincide, "coincide");
  auto closing = faces;
  closing[0].loops[0].push_back(0);
  expect_error(polyhedron(points, closing), errors::points_coincide, "first and last point");
  auto broken = points;
  broken[3].y = NAN;
  expect_error(polyhedron(broken, faces), errors::bad_size, "points[3] must be a point with finite coordinates");
  expect_error(polyhedron(std::vector<Vec3>(3), faces), errors::bad_size, "points must be a list of four or more");
  // Two cubes, one of them inside out outside the other: no void to look into.
  const auto apart = joined(points, cube_points(2, 2.5));
  expect_error(polyhedron(apart, joined(faces, cube_faces(8, true))), errors::inside_out, "inside out");
}

}  // namespace
}  // namespace aresta
