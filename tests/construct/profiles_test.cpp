// SPDX-License-Identifier: Apache-2.0
#include "construct/profiles.h"

#include <numbers>

#include "audit.h"
#include "construct/spline.h"

namespace aresta {
namespace {

constexpr double pi = std::numbers::pi;
using Points = std::vector<Vec3>;

const Points square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
const Points hole{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};

TEST(Polygon, NormalFollowsTheRightHand) {
  const auto up = polygon(square);
  ASSERT_BUILT(up);
  EXPECT_EQ(counts(*up), (Counts{4, 4, 1, 0}));
  EXPECT_EQ(up->normal(FaceId(0), {0, 0}), (Vec3{0, 0, 1}));
  const auto down = polygon(Points(square.rbegin(), square.rend()));
  EXPECT_EQ(down->normal(FaceId(0), {0, 0}), (Vec3{0, 0, -1}));
  EXPECT_NEAR(image_area(*up, FaceId(0)), 16, 1e-12);
  EXPECT_NEAR(image_area(*down, FaceId(0)), 16, 1e-12);
}

TEST(Polygon, HolesRunEitherWayAndPointsMayClose) {
  const Points other{{3, 3, 0}, {3, 2.5, 0}, {2.5, 3, 0}};
  for (const Points& h : {hole, Points(hole.rbegin(), hole.rend())}) {
    const auto m = polygon(square, std::vector<Points>{h, other});
    ASSERT_BUILT(m);
    EXPECT_EQ(counts(*m), (Counts{11, 11, 1, 0}));
    EXPECT_EQ(m->topology().loop_count(), 3u);
    EXPECT_NEAR(image_area(*m, FaceId(0)), 16 - 1 - 0.125, 1e-12);
  }
  Points closed = square;
  closed.push_back(square[0]);
  EXPECT_EQ(counts(*polygon(closed)), (Counts{4, 4, 1, 0}));
}

TEST(Polygon, WrongOnesAreRefused) {
  const auto with_hole = [](Points h) { return polygon(square, std::vector<Points>{std::move(h)}); };
  const auto crossing = polygon(Points{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {4, 4, 0}, {0, 4, 0}, {1, -1, 0}});
  expect_error(crossing, errors::self_intersection, "points from 0 to 1 and points from 4 to 5");
  ASSERT_TRUE(crossing.error().place.has_value());
  EXPECT_NEAR((*crossing.error().place)[0], 0.8, 1e-12);
  EXPECT_NEAR((*crossing.error().place)[1], 0, 1e-12);
  expect_error(polygon(Points{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}), errors::self_intersection, "meets itself");
  expect_error(polygon(Points{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}}), errors::self_intersection,
               "meets itself");
  expect_error(polygon(Points{{0, 0, 0}, {4, 0, 0}, {6, 0, 0}, {4, 0, 0}, {4, 4, 0}}), errors::self_intersection,
               "meets itself");
  expect_error(polygon(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), errors::bad_size, "on one line");
  expect_error(polygon(Points{{0, 0, 0}, {1, 0, 0}}), errors::bad_size, "three or more");
  expect_error(polygon(Points{{0, 0, 0}, {1, 0, 0}, {1, 0, 1e-12}, {0, 1, 0}}), errors::points_coincide,
               "points 1 and 2");
  expect_error(polygon(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}), errors::not_planar, "off the plane");
  expect_error(polygon(Points{{0, 0, 0}, {1, 0, 0}, {INFINITY, 1, 0}}), errors::bad_size, "points[2]");
  expect_error(with_hole({{1, 1, 0}, {2, 1, 0}}), errors::bad_size, "holes[0]");
  expect_error(with_hole({{1, 1, 0}, {5, 1, 0}, {1, 2, 0}}), errors::self_intersection, "holes[0]");
  expect_error(with_hole({{0, 1, 0}, {1, 1, 0}, {1, 2, 0}}), errors::self_intersection, "holes[0]");
  expect_error(with_hole({{5, 5, 0}, {6, 5, 0}, {6, 6, 0}}), errors::bad_profile, "outside");
  expect_error(with_hole({{1, 1, 1}, {2, 1, 1}, {2, 2, 1}}), errors::not_planar, "holes[0]");
  const Points inner{{1.2, 1.2, 0}, {1.4, 1.2, 0}, {1.4, 1.4, 0}};
  expect_error(polygon(square, std::vector<Points>{hole, inner}), errors::bad_profile, "holes[1] lies inside holes[0]");
}

TEST(Disk, OneVertexOneEdgeOneFace) {
  const auto m = disk(2, {{1, 2, 3}, {1, 1, 1}});
  ASSERT_BUILT(m);
  EXPECT_EQ(counts(*m), (Counts{1, 1, 1, 0}));
  EXPECT_LT(largest_gap(*m), 1e-13);
  EXPECT_TRUE(loops_enclose(*m));
  EXPECT_NEAR(distance(m->normal(FaceId(0), {0, 0}), normalized(Vec3{1, 1, 1})), 0, 1e-15);
  expect_error(disk(-1), errors::bad_size, "disk: r must be positive");
}

TEST(Wires, PolylineLineAndPoint) {
  const auto open = polyline(square);
  EXPECT_EQ(counts(*open), (Counts{4, 3, 0, 0}));
  const auto closed = polyline(square, true);
  EXPECT_EQ(counts(*closed), (Counts{4, 4, 0, 0}));
  EXPECT_TRUE(closed->topology().is_wire(EdgeId(3)));
  EXPECT_EQ(counts(*line({0, 0, 0}, {1, 2, 3})), (Counts{2, 1, 0, 0}));
  EXPECT_EQ(counts(*point({1, 2, 3})), (Counts{1, 0, 0, 0}));
  EXPECT_EQ(point({1, 2, 3})->point(VertexId(0)), (Vec3{1, 2, 3}));
  expect_error(line({1, 1, 1}, {1, 1, 1}), errors::points_coincide, "points 0 and 1");
  expect_error(polyline(Points{{0, 0, 0}}), errors::bad_size, "2 or more");
  expect_error(polyline(Points{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, -1, 0}}), errors::self_intersection,
               "edge 0 and edge 2 meet");
  expect_error(polyline(Points{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}), errors::self_intersection, "edge 0 and edge 1 meet");
  expect_error(point({0, NAN, 0}), errors::bad_size, "point: p must be");
  // Skew edges pass each other.
  EXPECT_TRUE(polyline(Points{{0, 0, 0}, {2, 0, 0}, {2, 1, 1}, {1, -1, 1}}).ok());
}

double wire_length(const Model& m) {
  double sum = 0;
  for (const EdgeId e : m.topology().edges()) sum += m.curve(e).length(m.range(e));
  return sum;
}

TEST(Wires, ArcsHaveTheirLengthAndPassTheirPoints) {
  const auto quarter = arc({1, 1, 0}, {3, 1, 0}, {1, 3, 0});
  ASSERT_BUILT(quarter);
  EXPECT_NEAR(wire_length(*quarter), pi, 1e-14);
  EXPECT_LT(largest_gap(*quarter), 1e-15);
  const auto long_way = arc_about({1, 1, 0}, {3, 1, 0}, {1, 3, 0}, {0, 0, -1});
  EXPECT_NEAR(wire_length(*long_way), 3 * pi, 1e-13);
  EXPECT_LT(largest_gap(*long_way), 1e-14);
  const auto half = arc_about({0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(wire_length(*half), pi, 1e-14);
  EXPECT_NEAR(distance(half->edge_point(EdgeId(0), pi / 2), {0, 0, -1}), 0, 1e-15);
  const auto through = arc_through({1, 0, 5}, {-1, 0, 5}, {0, -1, 5});
  EXPECT_NEAR(wire_length(*through), 1.5 * pi, 1e-13);
  EXPECT_LT(largest_gap(*through), 1e-14);
  EXPECT_NEAR(distance(through->edge_point(EdgeId(0), pi), {-1, 0, 5}), 0, 1e-14);

  expect_error(arc({0, 0, 0}, {1, 0, 0}, {-1, 0, 0}), errors::bad_size, "opposite sides");
  expect_error(arc({0, 0, 0}, {1, 0, 0}, {0, 2, 0}), errors::bad_size, "end must be as far from the centre");
  expect_error(arc({0, 0, 0}, {1, 0, 0}, {1, 0, 0}), errors::points_coincide, "start and end");
  expect_error(arc_about({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}), errors::bad_size, "right angles");
  expect_error(arc_through({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), errors::bad_size, "one line");
  expect_error(arc_through({0, 0, 0}, {1, 0, 0}, {0, 0, 0}), errors::points_coincide, "coincide");
}

TEST(Wires, CircleAndEllipseAreClosedEdges) {
  const auto c = circle(2, {{0, 0, 1}, {1, 0, 0}});
  EXPECT_EQ(counts(*c), (Counts{1, 1, 0, 0}));
  EXPECT_NEAR(wire_length(*c), 4 * pi, 1e-13);
  for (const auto& [a, b] : {std::pair{3.0, 1.0}, {1.0, 3.0}}) {
    const auto e = ellipse(a, b);
    ASSERT_BUILT(e);
    EXPECT_EQ(counts(*e), (Counts{1, 1, 0, 0}));
    EXPECT_NEAR(wire_length(*e), 13.364893220555258, 1e-9);  // 12 E(8/9)
    const Box3 box = e->bounds();
    EXPECT_NEAR(box.high.x, a, 1e-12);
    EXPECT_NEAR(box.high.y, b, 1e-12);
    EXPECT_LT(largest_gap(*e), 1e-14);
  }
  expect_error(circle(0), errors::bad_size, "circle: r");
  expect_error(ellipse(1, 0), errors::bad_size, "ellipse: b");
}

TEST(Spline, PassesThroughItsPointsWithContinuousSecondDerivative) {
  const Points points{{0, 0, 0}, {1, 2, 0}, {3, 3, 1}, {4, 1, 2}, {6, 0, 0}, {6.5, 2, 1}};
  for (const bool closed : {false, true}) {
    const auto m = spline(points, closed);
    ASSERT_BUILT(m);
    EXPECT_EQ(counts(*m), (closed ? Counts{1, 1, 0, 0} : Counts{2, 1, 0, 0}));
    EXPECT_LT(largest_gap(*m), 1e-13);
    double t = 0;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
      EXPECT_NEAR(distance(m->edge_point(EdgeId(0), t), points[i]), 0, 1e-13);
      if (i > 0) {
        const CurveJet before = m->edge_jet(EdgeId(0), t - 1e-9), after = m->edge_jet(EdgeId(0), t + 1e-9);
        EXPECT_LT(norm(before.d1 - after.d1), 1e-7);
        EXPECT_LT(norm(before.d2 - after.d2), 1e-7);
      }
      t += distance(points[i], points[(i + 1) % points.size()]);
    }
    if (closed) {
      const CurveJet first = m->edge_jet(EdgeId(0), 0), last = m->edge_jet(EdgeId(0), t);
      EXPECT_LT(norm(first.d1 - last.d1), 1e-12);
      EXPECT_LT(norm(first.d2 - last.d2), 1e-11);
    }
  }
}

TEST(Spline, ReproducesLinesAndRejectsRepeats) {
  const auto straight = spline(Points{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {4, 4, 4}});
  for (int i = 0; i <= 10; ++i) {
    const Vec3 p = straight->edge_point(EdgeId(0), straight->range(EdgeId(0)).at(i / 10.0));
    EXPECT_NEAR(distance(p, Vec3{0.4 * i, 0.4 * i, 0.4 * i}), 0, 1e-13);
  }
  EXPECT_TRUE(spline(Points{{0, 0, 0}, {1, 0, 0}}).ok());
  EXPECT_TRUE(spline(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}).ok());
  EXPECT_TRUE(spline(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, true).ok());
  expect_error(spline(Points{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}), errors::points_coincide, "points 1 and 2");
  expect_error(spline(Points{{0, 0, 0}, {1, 0, 0}}, true), errors::bad_size, "3 or more");
}

}  // namespace
}  // namespace aresta
