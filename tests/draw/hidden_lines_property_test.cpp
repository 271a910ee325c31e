// SPDX-License-Identifier: Apache-2.0
// Hidden lines against an independent judge: points of edges are tried by casting a ray to the eye through every
// triangle.
#include <gtest/gtest.h>

#include <ctime>
#include <random>

#include "draw/hidden_lines.h"
#include "draw/scenes.h"

namespace aresta::draw {
namespace {

enum class Verdict { visible, hidden, unsure };

/// Solves P + s * towards = a + u (b - a) + v (c - a); unsure near any border of the three conditions. A triangle that
/// passes through P itself does not hide it.
Verdict judge_triangle(Vec3 p, Vec3 towards, Vec3 a, Vec3 b, Vec3 c, double reach) {
  constexpr double close = 1e-6;
  const Vec3 e1 = b - a, e2 = c - a;
  if (norm(cross(e1, e2)) <= 1e-14) return Verdict::visible;  // no triangle
  const double det = dot(cross(e1, e2), -towards);
  if (std::abs(det) <= close * norm(e1) * norm(e2) * norm(towards)) return Verdict::unsure;
  const Vec3 r = p - a;
  const double s = dot(cross(e1, e2), r) / det;
  const double u = dot(cross(r, e2), -towards) / det, v = dot(cross(e1, r), -towards) / det;
  const double inside = std::min({u, v, 1 - u - v});
  if (inside < -close || s < 1e-9 || s > reach) return Verdict::visible;
  if (inside < close || s < close) return Verdict::unsure;
  return Verdict::hidden;
}

Verdict judge(const Scene& scene, const Camera& camera, Vec3 p) {
  const bool perspective = camera.projection == Projection::perspective;
  const Vec3 towards = perspective ? camera.eye - p : normalized(camera.eye - camera.target);
  Verdict verdict = Verdict::visible;
  for (const FacePatch& f : scene.faces) {
    for (const auto& t : f.triangles) {
      const Verdict v =
          judge_triangle(p, towards, f.points[t[0]], f.points[t[1]], f.points[t[2]], perspective ? 1 : 1e30);
      if (v == Verdict::hidden) return v;
      if (v == Verdict::unsure) verdict = v;
    }
  }
  return verdict;
}

struct Tally {
  int tried = 0, unsure = 0, wrong = 0, hidden = 0;
};

void compare(const Scene& scene, const Camera& camera, std::mt19937_64& random, int samples, Tally& tally) {
  const auto lines = hidden_lines(scene, camera, {}, {});
  ASSERT_TRUE(lines.ok()) << lines.error().to_line();
  std::vector<std::vector<const LinePiece*>> by_line(lines->lines.size());
  for (const LinePiece& p : lines->pieces) by_line[p.line].push_back(&p);
  std::uniform_real_distribution<double> unit(0, 1);
  for (std::size_t l = 0; l < lines->lines.size(); ++l) {
    const EdgeId edge = lines->lines[l].edge;
    if (edge.valid() && std::count(lines->end_on.begin(), lines->end_on.end(), edge) > 0) {
      EXPECT_TRUE(by_line[l].empty());
      continue;
    }
    const auto& points = lines->lines[l].points;
    const auto& behind = lines->lines[l].behind;
    for (std::uint32_t s = 0; s + 1 < points.size(); ++s) {
      if (!behind.empty() && behind[s]) continue;  // the triangles alone know nothing of it
      for (int k = 0; k < samples; ++k) {
        const double t = unit(random);
        const LinePiece* at = nullptr;
        bool near_event = false;
        for (const LinePiece* p : by_line[l]) {
          if (p->segment != s) continue;
          if (t >= p->from && t <= p->to) at = p;
          for (const double end : {p->from, p->to}) near_event = near_event || std::abs(t - end) < 1e-5;
        }
        ++tally.tried;
        const Verdict v = near_event ? Verdict::unsure : judge(scene, camera, lerp(points[s], points[s + 1], t));
        if (v == Verdict::unsure) {
          ++tally.unsure;
          continue;
        }
        tally.hidden += v == Verdict::hidden;
        const bool agrees = at != nullptr && at->visible == (v == Verdict::visible);
        tally.wrong += !agrees;
        EXPECT_TRUE(agrees) << "line " << l << " segment " << s << " at " << t << " from " << points[s].x << ' '
                            << points[s].y << ' ' << points[s].z << " to " << points[s + 1].x << ' ' << points[s + 1].y
                            << ' ' << points[s + 1].z
                            << (at ? at->visible ? " given as visible" : " given as hidden" : " not given") << " eye "
                            << camera.eye.x << " " << camera.eye.y << " " << camera.eye.z
                            << (camera.projection == Projection::perspective ? " perspective" : "");

        if (!agrees) return;
      }
    }
  }
}

Camera random_camera(std::mt19937_64& random, bool perspective) {
  std::uniform_real_distribution<double> side(-1, 1);
  Camera camera = standard_camera(StandardView::iso, perspective ? Projection::perspective : Projection::parallel);
  camera.target = {side(random), side(random), side(random)};
  const Vec3 direction = normalized(Vec3{side(random), side(random), side(random)});
  camera.eye = camera.target + 12.0 * direction;
  return camera;
}

TEST(HiddenLinesProperty, RandomBlocksAgreeWithRays) {
  constexpr std::uint64_t seed = 20240607;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> side(-2, 2), size(0.2, 1.5);
  Tally tally;
  for (int round = 0; round < 60 && !HasFailure(); ++round) {
    Scene scene;
    for (int i = 0; i < 6; ++i) {
      const Vec3 low{side(random), side(random), side(random)};
      test::add_block(scene, low, low + Vec3{size(random), size(random), size(random)});
    }
    compare(scene, random_camera(random, round % 2 == 1), random, 20, tally);
  }
  std::printf("seed %llu: %d places, %d hidden, %d near events, %d wrong\n", (unsigned long long)seed, tally.tried,
              tally.hidden, tally.unsure, tally.wrong);
  EXPECT_GT(tally.tried, 80000);
  EXPECT_LT(tally.unsure, tally.tried / 4);
  EXPECT_GT(tally.hidden, tally.tried / 5);
}

TEST(HiddenLinesProperty, BlocksOnALatticeAgreeWithRays) {
  // Faces that touch and coincide, edges behind edges and behind diagonals: every kind of coincidence, seen along
  // lattice directions.
  constexpr std::uint64_t seed = 4711;
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> place(0, 4), size(1, 3), direction(-2, 2);
  Tally tally;
  for (int round = 0; round < 200 && !HasFailure(); ++round) {
    Scene scene;
    for (int i = 0; i < 5; ++i) {
      const Vec3 low{double(place(random)), double(place(random)), double(place(random))};
      test::add_block(scene, low, low + Vec3{double(size(random)), double(size(random)), double(size(random))});
    }
    Camera camera = standard_camera(StandardView::iso);
    camera.eye = {double(direction(random)), double(direction(random)), double(direction(random))};
    camera.target = {0, 0, 0};
    camera.up = {0.1, 0.2, 1};
    if (norm(camera.eye) == 0) camera.eye = {1, 1, 1};
    if (round % 2 == 1) {
      camera.projection = Projection::perspective;
      camera.eye = 10.0 * camera.eye;
    }
    compare(scene, camera, random, 5, tally);
  }
  std::printf("seed %llu: %d places, %d hidden, %d near events, %d wrong\n", (unsigned long long)seed, tally.tried,
              tally.hidden, tally.unsure, tally.wrong);
  EXPECT_GT(tally.tried, 50000);
  EXPECT_LT(tally.unsure, tally.tried / 2);
  EXPECT_GT(tally.hidden, tally.tried / 5);
}

TEST(HiddenLinesProperty, RandomTrianglesThatPierceEachOtherAgreeWithRays) {
  constexpr std::uint64_t seed = 77;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> side(-2, 2);
  const auto point = [&] { return Vec3{side(random), side(random), side(random)}; };
  Tally tally;
  for (int round = 0; round < 60 && !HasFailure(); ++round) {
    Scene scene;
    for (int i = 0; i < 25; ++i) {
      const Vec3 a = point(), b = point(), c = point();
      const FaceId f = test::add_polygon(scene, {a, b, c}, {}, {});
      test::add_edge(scene, {a, b}, {f});
      test::add_edge(scene, {b, c}, {f});
      test::add_edge(scene, {c, a}, {f});
      test::add_edge(scene, {point(), point()});
    }
    compare(scene, random_camera(random, round % 2 == 1), random, 10, tally);
  }
  std::printf("seed %llu: %d places, %d hidden, %d near events, %d wrong\n", (unsigned long long)seed, tally.tried,
              tally.hidden, tally.unsure, tally.wrong);
  EXPECT_GT(tally.tried, 50000);
  EXPECT_LT(tally.unsure, tally.tried / 10);
  EXPECT_GT(tally.hidden, tally.tried / 5);
}

TEST(HiddenLinesProperty, CurvedBodiesWithSilhouettesAgreeWithRays) {
  constexpr std::uint64_t seed = 5;
  std::mt19937_64 random(seed);
  Tally tally;
  for (int round = 0; round < 8 && !HasFailure(); ++round) {
    Scene scene;
    test::add_torus(scene, {0, 0, 0}, 2, 0.7, 32, 16);
    test::add_cylinder(scene, {0.3, 0.2, -1.5}, 0.8, 3, 24);
    test::add_sphere(scene, {1.5, 1.5, 0.5}, 1, 24, 12);
    compare(scene, random_camera(random, round % 2 == 1), random, 6, tally);
  }
  std::printf("seed %llu: %d places, %d hidden, %d near events, %d wrong\n", (unsigned long long)seed, tally.tried,
              tally.hidden, tally.unsure, tally.wrong);
  EXPECT_GT(tally.tried, 3000);
  EXPECT_LT(tally.unsure, tally.tried / 10);
  EXPECT_GT(tally.hidden, tally.tried / 10);
}

/// A sea of round hills: n x n quadrilaterals, every line of the grid an edge of the picture.
Scene hills(int n, bool all_lines) {
  Scene scene;
  const auto height = [](double x, double y) { return 0.06 * std::sin(25 * x) * std::cos(21 * y); };
  const auto point = [&](int i, int j) {
    const double x = double(i) / n, y = double(j) / n;
    return Vec3{x, y, height(x, y)};
  };
  test::add_surface(scene, n, n, point, [](int, int) { return Vec3{0, 0, 1}; }, {}, {});
  for (int k = 0; k <= n; ++k) {
    if (!all_lines && k % n != 0) continue;
    std::vector<Vec3> along, across;
    for (int i = 0; i <= n; ++i) along.push_back(point(i, k)), across.push_back(point(k, i));
    test::add_edge(scene, along, {FaceId(0)});
    test::add_edge(scene, across, {FaceId(0)});
  }
  return scene;
}

TEST(HiddenLinesProperty, HalfAMillionTrianglesInSeconds) {
  const Scene scene = hills(500, false);
  ASSERT_EQ(scene.faces[0].triangles.size(), 500000u);
  Camera camera = standard_camera(StandardView::iso);
  camera.eye = {3, -2, 0.8};
  const std::clock_t start = std::clock();  // of the processor, whatever else the machine does
  const auto lines = hidden_lines(scene, camera, {}, {});
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  ASSERT_TRUE(lines.ok());
  std::printf("500000 triangles, %zu lines, %zu pieces: %.2f s\n", lines->lines.size(), lines->pieces.size(), seconds);
  EXPECT_GT(lines->pieces.size(), 2000u);
  EXPECT_LT(seconds, 60);

  const Scene grid = hills(500, true);
  const std::clock_t restart = std::clock();
  const auto all = hidden_lines(grid, camera, {}, {});
  const double all_seconds = double(std::clock() - restart) / CLOCKS_PER_SEC;
  ASSERT_TRUE(all.ok());
  std::printf("500000 triangles, 501000 segments, %zu pieces: %.2f s\n", all->pieces.size(), all_seconds);
  EXPECT_GT(all->pieces.size(), 500000u);
  EXPECT_LT(all_seconds, 120);
}

}  // namespace
}  // namespace aresta::draw
