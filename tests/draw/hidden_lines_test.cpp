// SPDX-License-Identifier: Apache-2.0
#include "draw/hidden_lines.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "draw/errors.h"
#include "draw/scenes.h"

namespace aresta::draw {
namespace {

constexpr double infinitesimal = 1e-9;

HiddenLines lines_of(const Scene& scene, const Camera& camera, const HiddenLineOptions& options = {}) {
  Result<HiddenLines> result = hidden_lines(scene, camera, options, {});
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().to_line());
  return result.ok() ? *result : HiddenLines{};
}

struct Part {
  double from, to;
};

/// The parts of an edge of one segment that are visible (or hidden), by edge.
std::map<EdgeId, std::vector<Part>> parts(const HiddenLines& lines, bool visible) {
  std::map<EdgeId, std::vector<Part>> result;
  for (const LinePiece& p : lines.pieces) {
    if (p.visible == visible) result[lines.lines[p.line].edge].push_back({p.from, p.to});
  }
  return result;
}

/// The edge of a scene between two places.
EdgeId edge_between(const Scene& scene, Vec3 a, Vec3 b) {
  for (const EdgeLine& e : scene.edges) {
    if ((e.points.front() == a && e.points.back() == b) || (e.points.front() == b && e.points.back() == a))
      return e.edge;
  }
  ADD_FAILURE() << "no such edge";
  return {};
}

void expect_parts(const HiddenLines& lines, bool visible, EdgeId edge, const std::vector<Part>& expected) {
  const auto all = parts(lines, visible);
  const auto found = all.find(edge);
  const std::vector<Part> actual = found == all.end() ? std::vector<Part>{} : found->second;
  ASSERT_EQ(actual.size(), expected.size()) << "edge " << edge.value << (visible ? " visible" : " hidden");
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual[i].from, expected[i].from, infinitesimal) << "edge " << edge.value;
    EXPECT_NEAR(actual[i].to, expected[i].to, infinitesimal) << "edge " << edge.value;
  }
}

void expect_visible(const HiddenLines& lines, EdgeId edge, const std::vector<Part>& visible) {
  expect_parts(lines, true, edge, visible);
  // What is not visible is hidden: nothing is lost, nothing is given twice.
  std::vector<Part> hidden;
  double at = 0;
  for (const Part& p : visible) {
    if (p.from > at) hidden.push_back({at, p.from});
    at = p.to;
  }
  if (at < 1) hidden.push_back({at, 1});
  expect_parts(lines, false, edge, hidden);
}

TEST(HiddenLines, UnitCubeFromItsCorner) {
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::iso));
  ASSERT_EQ(lines.pieces.size(), 12u);
  // The eye is at (1, -1, 1): the corner (0, 1, 0) is the far one and its three edges are hidden. They run behind
  // diagonals of the front faces, which is where those are split into triangles.
  const Vec3 far{0, 1, 0};
  int visible = 0;
  for (const LinePiece& p : lines.pieces) {
    const auto& points = lines.lines[p.line].points;
    EXPECT_EQ(p.visible, points[0] != far && points[1] != far);
    EXPECT_EQ(p.from, 0);
    EXPECT_EQ(p.to, 1);
    EXPECT_EQ(p.a, points[0]);
    EXPECT_EQ(p.b, points[1]);
    visible += p.visible;
  }
  EXPECT_EQ(visible, 9);
}

TEST(HiddenLines, CubeFromEachStandardViewAndFromItsEightCorners) {
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < 8; ++i) {
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
      Camera camera = standard_camera(StandardView::iso, projection);
      camera.target = {0.5, 0.5, 0.5};
      camera.eye = camera.target + Vec3{i & 1 ? 3.0 : -3.0, i & 2 ? 3.0 : -3.0, i & 4 ? 3.0 : -3.0};
      const auto visible = parts(lines_of(scene, camera), true), hidden = parts(lines_of(scene, camera), false);
      EXPECT_EQ(visible.size(), 9u);
      EXPECT_EQ(hidden.size(), 3u);
    }
  }
  for (const StandardView view : {StandardView::front, StandardView::back, StandardView::left, StandardView::right,
                                  StandardView::top, StandardView::bottom}) {
    const HiddenLines lines = lines_of(scene, standard_camera(view));
    EXPECT_EQ(parts(lines, true).size(), 4u) << to_string(view);
    EXPECT_EQ(parts(lines, false).size(), 4u) << to_string(view);  // exactly behind the border of the near face
    EXPECT_EQ(lines.end_on.size(), 4u) << to_string(view);
    HiddenLineOptions options;
    options.merge_coincident = true;
    EXPECT_EQ(parts(lines_of(scene, standard_camera(view), options), false).size(), 0u);
  }
}

TEST(HiddenLines, BlockBehindABlockWithAGap) {
  // Seen along (-1, 1, -1): the place P is hidden by the front block when P + s (1, -1, 1) lies in it for some s > 0.
  Scene scene;
  test::add_block(scene, {0, -3, 0}, {2, 0, 2.5});
  test::add_block(scene, {-2, 0, 0}, {-1, 1, 1});
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::iso));
  const auto edge = [&](Vec3 a, Vec3 b) { return edge_between(scene, a, b); };
  // x + s >= 0 and 1 + s <= 2.5 on the upper edges along x: hidden from x = -1.5 on.
  expect_visible(lines, edge({-2, 0, 1}, {-1, 0, 1}), {{0, 0.5}});
  expect_visible(lines, edge({-2, 1, 1}, {-1, 1, 1}), {{0, 0.5}});
  expect_visible(lines, edge({-2, 0, 1}, {-2, 1, 1}), {{0, 1}});
  expect_visible(lines, edge({-1, 0, 1}, {-1, 1, 1}), {});
  // -2 + s >= 0 and z + s <= 2.5: hidden up to z = 0.5.
  expect_visible(lines, edge({-2, 0, 0}, {-2, 0, 1}), {{0.5, 1}});
  expect_visible(lines, edge({-1, 0, 0}, {-1, 0, 1}), {});
  expect_visible(lines, edge({-1, 1, 0}, {-1, 1, 1}), {});
  expect_visible(lines, edge({-2, 1, 0}, {-2, 1, 1}), {});
  for (const double y : {0.0, 1.0}) expect_visible(lines, edge({-2, y, 0}, {-1, y, 0}), {});
  for (const double x : {-2.0, -1.0}) expect_visible(lines, edge({x, 0, 0}, {x, 1, 0}), {});
  // The front block is seen as if it stood alone.
  for (const EdgeLine& e : scene.edges) {
    if (e.edge.index() >= 12) continue;
    const Vec3 far{0, 0, 0};
    const bool hidden = e.points[0] == far || e.points[1] == far;
    expect_visible(lines, e.edge, hidden ? std::vector<Part>{} : std::vector<Part>{{0, 1}});
  }
}

TEST(HiddenLines, ATowerHidesTheMiddleOfAWall) {
  Scene scene;
  test::add_block(scene, {1, 0, -1}, {2, 1, 3});
  test::add_block(scene, {0, 5, 0}, {4, 6, 2});
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::front));
  for (const double z : {0.0, 2.0}) {
    expect_visible(lines, edge_between(scene, {0, 5, z}, {4, 5, z}), {{0, 0.25}, {0.5, 1}});
    expect_visible(lines, edge_between(scene, {0, 6, z}, {4, 6, z}), {});
  }
  for (const double x : {0.0, 4.0}) expect_visible(lines, edge_between(scene, {x, 5, 0}, {x, 5, 2}), {{0, 1}});
  EXPECT_EQ(lines.end_on.size(), 8u);
}

TEST(HiddenLines, ASheetThroughACube) {
  // Not imprinted: the sheet z = 0.5 pierces the upright edges half way.
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  const std::vector<Vec3> corners{{-1, -1, 0.5}, {2, -1, 0.5}, {2, 2, 0.5}, {-1, 2, 0.5}};
  const FaceId sheet = test::add_polygon(scene, corners, {}, {});
  for (int i = 0; i < 4; ++i) test::add_edge(scene, {corners[i], corners[(i + 1) % 4]}, {sheet});
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::iso));
  for (const Vec3 foot : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}}) {
    expect_visible(lines, edge_between(scene, foot, foot + Vec3{0, 0, 1}), {{0.5, 1}});
  }
  expect_visible(lines, edge_between(scene, {0, 1, 0}, {0, 1, 1}), {});
  const Vec3 ring[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (int i = 0; i < 4; ++i) {
    const Vec3 a = ring[i], b = ring[(i + 1) % 4], up{0, 0, 1};
    expect_visible(lines, edge_between(scene, a, b), {});
    expect_visible(lines, edge_between(scene, a + up, b + up), {{0, 1}});
    expect_visible(lines, edge_between(scene, corners[i], corners[(i + 1) % 4]), {{0, 1}});
  }
}

TEST(HiddenLines, PerspectiveShadowsGrow) {
  Scene scene;
  test::add_polygon(scene, {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {}, {});
  const EdgeId across = test::add_edge(scene, {{-6, 10, 0}, {6, 10, 0}});
  const EdgeId slanting = test::add_edge(scene, {{-6, 10, 0}, {6, 0, 0}});
  const EdgeId before = test::add_edge(scene, {{-6, -1, 0}, {6, -1, 0}});
  const EdgeId through = test::add_edge(scene, {{0, -4, 0.5}, {0, 4, 0.5}});
  Camera camera = standard_camera(StandardView::front, Projection::perspective);
  camera.eye = {0, -10, 0};
  camera.target = {0, 0, 0};
  const HiddenLines lines = lines_of(scene, camera);
  // The square's shadow is twice as wide ten behind it.
  expect_visible(lines, across, {{0, 1.0 / 3}, {2.0 / 3, 1}});
  // 10 x / (10 + y) = -1 and 1 with x = -6 + 12 t, y = 10 - 10 t.
  expect_visible(lines, slanting, {{0, 4.0 / 11}, {8.0 / 13, 1}});
  expect_visible(lines, before, {{0, 1}});
  expect_visible(lines, through, {{0, 0.5}});
}

TEST(HiddenLines, ParameterIsInSpaceAndPartsBehindTheEyeAreLeftOut) {
  Scene scene;
  const EdgeId e = test::add_edge(scene, {{1, -20, 0}, {1, 20, 0}});
  Camera camera = standard_camera(StandardView::front, Projection::perspective);
  camera.eye = {0, -10, 0};
  camera.target = {0, 0, 0};
  const HiddenLines lines = lines_of(scene, camera);
  // Drawn from a ten-thousandth of the distance to the target in front of the eye: y = -9.999.
  expect_parts(lines, true, e, {{10.001 / 40, 1}});
  expect_parts(lines, false, e, {});
}

TEST(HiddenLines, ATriangleThatReachesBehindTheEyeHides) {
  // A floor under and behind the eye hides what lies below it, up to the horizon.
  Scene scene;
  test::add_polygon(scene, {{-100, -100, -1}, {100, -100, -1}, {100, 100, -1}, {-100, 100, -1}}, {}, {});
  const EdgeId post = test::add_edge(scene, {{0, 10, -3}, {0, 10, 1}});
  Camera camera = standard_camera(StandardView::front, Projection::perspective);
  camera.eye = {0, -10, 0};
  camera.target = {0, 0, 0};
  expect_visible(lines_of(scene, camera), post, {{0.5, 1}});
}

TEST(HiddenLines, PolylinesAreCutBySegment) {
  Scene scene;
  test::add_polygon(scene, {{1, 0, -1}, {3, 0, -1}, {3, 0, 1}, {1, 0, 1}}, {}, {});
  const EdgeId wire = test::add_edge(scene, {{0, 5, 0}, {2, 5, 0}, {2, 5, 4}});
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::front));
  ASSERT_EQ(lines.pieces.size(), 4u);
  EXPECT_EQ(lines.lines[0].kind, LineKind::wire);
  EXPECT_EQ(lines.lines[0].edge, wire);
  const auto expect = [&](int i, std::uint32_t segment, double from, double to, bool visible) {
    EXPECT_EQ(lines.pieces[i].segment, segment);
    EXPECT_NEAR(lines.pieces[i].from, from, infinitesimal);
    EXPECT_NEAR(lines.pieces[i].to, to, infinitesimal);
    EXPECT_EQ(lines.pieces[i].visible, visible);
  };
  expect(0, 0, 0, 0.5, true);
  expect(1, 0, 0.5, 1, false);
  expect(2, 1, 0, 0.25, false);
  expect(3, 1, 0.25, 1, true);
}

TEST(HiddenLines, CoincidentLinesOnce) {
  Scene scene;
  const EdgeId near = test::add_edge(scene, {{4, 0, 0}, {0, 0, 0}}),
               far = test::add_edge(scene, {{2, 5, 0}, {6, 5, 0}});
  HiddenLineOptions once;
  once.merge_coincident = true;
  const Camera front = standard_camera(StandardView::front);
  expect_parts(lines_of(scene, front), true, far, {{0, 1}});
  const HiddenLines lines = lines_of(scene, front, once);
  expect_parts(lines, true, near, {{0, 1}});
  expect_parts(lines, true, far, {{0.5, 1}});

  // In perspective: x / depth up to 0.1 is taken; 6 t / (20 + 10 t) = 0.1 at t = 0.4.
  Scene deep;
  const EdgeId a = test::add_edge(deep, {{0, 0, 0}, {1, 0, 0}}), b = test::add_edge(deep, {{6, 20, 0}, {0, 10, 0}});
  Camera camera = standard_camera(StandardView::front, Projection::perspective);
  camera.eye = {0, -10, 0};
  camera.target = {0, 0, 0};
  const HiddenLines seen = lines_of(deep, camera, once);
  expect_parts(seen, true, a, {{0, 1}});
  expect_parts(seen, true, b, {{0, 0.6}});  // it starts at its far end
}

TEST(HiddenLines, EdgesOfTouchingBlocksOnce) {
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  test::add_block(scene, {1, 0, 0}, {2, 1, 1});
  HiddenLineOptions once;
  once.merge_coincident = true;
  double length = 0;
  for (const LinePiece& p : lines_of(scene, standard_camera(StandardView::iso), once).pieces) {
    if (p.visible) length += distance(p.a, p.b);
  }
  // The outline of a 2 x 1 x 1 block with three edges at its near corner: 3 * (2 + 1 + 1); and the seam over top and
  // front: 2.
  EXPECT_NEAR(length, 14, 1e-9);
}

TEST(HiddenLines, PointsAreSeenOrHidden) {
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  for (const Vec3 p : {Vec3{2, -1, 2}, Vec3{0.5, 0.5, 0.5}, Vec3{0.5, 0, 0.5}, Vec3{-1, 2, -1}, Vec3{0.5, 2, 0.5},
                       Vec3{0.5, 3, 0.5}}) {
    scene.points.push_back({VertexId(scene.points.size()), p, {}});
  }
  // In front; inside; on the near face; behind; (0.5, 2, 0.5) passes over the upper edge: z is 1.5 at y = 1; farther.
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::iso));
  EXPECT_EQ(lines.point_visible, (std::vector<bool>{true, false, true, false, true, true}));
}

TEST(HiddenLines, SilhouettesOfACylinder) {
  Scene scene;
  test::add_cylinder(scene, {0, 0, 0}, 2, 3, 8);
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::front));
  // Eight sides with corners at multiples of 45 degrees, seen along y: the outline is at x = 2 (the seam) and x = -2.
  int count = 0;
  for (const LinePiece& p : lines.pieces) {
    const DrawnLine& line = lines.lines[p.line];
    if (line.kind != LineKind::silhouette) continue;
    ++count;
    EXPECT_TRUE(p.visible);
    EXPECT_EQ(line.face, FaceId(0));
    EXPECT_NEAR(std::abs(p.a.x), 2, 1e-12);
    EXPECT_NEAR(distance(p.a, p.b), 3, 1e-12);
    EXPECT_EQ(line.edge.valid(), p.a.x > 0);  // along the smooth edge it has that edge's name
  }
  EXPECT_EQ(count, 2);
  // From the top no side of a cylinder turns away.
  for (const DrawnLine& line : lines_of(scene, standard_camera(StandardView::top)).lines) {
    EXPECT_EQ(line.kind, LineKind::feature);
  }
  HiddenLineOptions without;
  without.silhouettes = false;
  EXPECT_EQ(lines_of(scene, standard_camera(StandardView::front), without).lines.size(), 2u);
}

TEST(HiddenLines, SilhouetteAcrossASmoothEdgeOfFacesWithOppositeSenses) {
  // Two halves of a roof that meet smoothly, the second turned over: the ridge is a silhouette only when they face
  // apart.
  for (const bool turned : {false, true}) {
    Scene scene;
    const FaceId a = test::add_polygon(scene, {{-1, 0, 0}, {-1, -1, 0}, {0, -1, 1}, {0, 0, 1}}, {}, {});
    const FaceId b = turned ? test::add_polygon(scene, {{0, 0, 1}, {1, 0, 0}, {1, -1, 0}, {0, -1, 1}}, {}, {})
                            : test::add_polygon(scene, {{0, 0, 1}, {0, -1, 1}, {1, -1, 0}, {1, 0, 0}}, {}, {});
    test::add_edge(scene, {{0, -1, 1}, {0, 0, 1}}, {a, b}, true);
    EXPECT_EQ(lines_of(scene, standard_camera(StandardView::right)).lines.size(), 1u) << turned;
    EXPECT_EQ(lines_of(scene, standard_camera(StandardView::top)).pieces.size(), 0u) << turned;
  }
}

TEST(HiddenLines, OutlineOfASphereIsACircle) {
  Scene scene;
  test::add_sphere(scene, {1, 2, 3}, 2, 96, 48);
  const HiddenLines lines = lines_of(scene, standard_camera(StandardView::iso));
  ASSERT_EQ(lines.lines.size(), 1u);
  EXPECT_EQ(lines.lines[0].points.front(), lines.lines[0].points.back());
  double area2 = 0;  // of the outline in the picture
  const Projector p(standard_camera(StandardView::iso), {});
  for (const LinePiece& piece : lines.pieces) {
    EXPECT_TRUE(piece.visible);
    const Vec3 a = p.to_view(piece.a), b = p.to_view(piece.b), c = p.to_view({1, 2, 3});
    area2 += cross(Vec2{a.x - c.x, a.y - c.y}, Vec2{b.x - c.x, b.y - c.y});
  }
  EXPECT_NEAR(std::abs(area2) / 2, std::numbers::pi * 4, 0.02);
}

TEST(HiddenLines, ATriangleWithoutAreaTakesItsNeighboursSide) {
  // A roof with its ridge along y; on the ridge a triangle without area, as tessellations have them.
  Scene scene;
  FacePatch patch;
  patch.face = FaceId(0);
  patch.points = {{-1, 0, 0}, {-1, 2, 0}, {0, 0, 1}, {0, 2, 1}, {1, 0, 0}, {1, 2, 0}, {0, 1, 1}};
  patch.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 6, 3}, {4, 5, 6}, {4, 6, 2}, {5, 3, 6}};
  scene.faces.push_back(patch);
  double length = 0;
  for (const LinePiece& p : lines_of(scene, standard_camera(StandardView::right)).pieces) {
    EXPECT_TRUE(p.visible);
    length += distance(p.a, p.b);
  }
  EXPECT_NEAR(length, 2, 1e-12);
  EXPECT_TRUE(lines_of(scene, standard_camera(StandardView::top)).pieces.empty());
}

TEST(HiddenLines, TorusFromTheTopShowsTwoCircles) {
  Scene scene;
  test::add_torus(scene, {0, 0, 0}, 3, 1, 96, 48);
  double length = 0;
  for (const LinePiece& p : lines_of(scene, standard_camera(StandardView::top)).pieces) {
    EXPECT_TRUE(p.visible);
    length += distance(p.a, p.b);
  }
  // Inscribed polygons of 96 sides with radii 4 and 2.
  EXPECT_NEAR(length, 96 * 2 * 6 * std::sin(std::numbers::pi / 96), 1e-9);
}

TEST(HiddenLines, TheOutlineOfAHoleEndsAtItsCusps) {
  // The hole of a fat torus, seen from the side: its near rim ends in two cusps. With n . sight = 0 the outline has
  // tan v = -cos u cot e, u from the eye's direction and e its height; the cusps are where its picture stands still.
  constexpr double big = 10, small = 5;
  const double e = std::atan(std::sqrt(0.5));
  const auto picture = [&](double u) {
    const double v = std::atan2(-std::cos(u) * std::cos(e), std::sin(e)) + std::numbers::pi;
    const double rho = big + small * std::cos(v);
    return Vec2{rho * std::sin(u), small * std::sin(v) * std::cos(e) - rho * std::cos(u) * std::sin(e)};
  };
  double slowest = 1e300;
  Vec2 cusp;
  for (double u = 0.8; u < 1.6; u += 1e-4) {
    const double speed = distance(picture(u), picture(u + 1e-4));
    if (speed < slowest) slowest = speed, cusp = picture(u);
  }
  Scene scene;
  test::add_torus(scene, {0, 0, 0}, big, small, 96, 48);
  const Camera camera = standard_camera(StandardView::iso);
  const Projector projector(camera, {});
  const Vec3 middle = projector.to_view({0, 0, 0});
  double highest = -1e300;  // that is seen around the hole
  for (const LinePiece& p : lines_of(scene, camera).pieces) {
    if (!p.visible) continue;
    for (const Vec3 end : {p.a, p.b}) {
      const Vec3 at = projector.to_view(end) - middle;
      if (std::abs(at.x) < 7 && std::abs(at.y) < 4 && std::abs(at.x) > 4) highest = std::max(highest, at.y);
    }
  }
  EXPECT_GT(highest, cusp.y - 0.1);
  EXPECT_LT(highest, cusp.y + 0.1) << "a side of a triangle behind the cusp is seen";
}

TEST(HiddenLines, TheSameForOneAndThreeThreads) {
  Scene scene;
  test::add_torus(scene, {0, 0, 0}, 3, 1, 60, 30);
  for (int i = 0; i < 60; ++i) test::add_block(scene, {i * 0.1 - 3, -0.2, -0.3}, {i * 0.1 - 2.95, 0.3, 0.2 + 0.01 * i});
  Context three;
  three.threads = 3;
  const HiddenLines a = lines_of(scene, standard_camera(StandardView::iso));
  const auto b = hidden_lines(scene, standard_camera(StandardView::iso), {}, three);
  ASSERT_TRUE(b.ok());
  ASSERT_EQ(a.pieces.size(), b->pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    EXPECT_EQ(a.pieces[i].a, b->pieces[i].a);
    EXPECT_EQ(a.pieces[i].b, b->pieces[i].b);
    EXPECT_EQ(a.pieces[i].visible, b->pieces[i].visible);
  }
}

TEST(HiddenLines, BadInputIsRefused) {
  const Camera camera = standard_camera(StandardView::iso);
  EXPECT_EQ(hidden_lines({}, camera, {}, {}).error().code, errors::draw_empty);
  Scene scene;
  test::add_block(scene, {0, 0, 0}, {1, 1, 1});
  Camera bad = camera;
  bad.target = bad.eye;
  EXPECT_EQ(hidden_lines(scene, bad, {}, {}).error().code, errors::draw_bad_camera);
  HiddenLineOptions options;
  options.tolerance = -1;
  EXPECT_EQ(hidden_lines(scene, camera, options, {}).error().code, errors::invalid_argument);
  scene.faces[4].points[2].z = std::nan("");
  EXPECT_EQ(hidden_lines(scene, camera, {}, {}).error().code, errors::draw_not_finite);
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  scene.faces[4].points[2].z = 0;
  EXPECT_EQ(hidden_lines(scene, camera, {}, context).error().code, errors::cancelled);
}

}  // namespace
}  // namespace aresta::draw
