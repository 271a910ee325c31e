// SPDX-License-Identifier: Apache-2.0
#include "planar/imprint.h"

#include <gtest/gtest.h>

#include <random>

#include "math/transform.h"
#include "planar/soups.h"

namespace aresta::planar {
namespace {

using test::rectangle;
using test::SoupMaker;

constexpr double tolerance = 1e-9;

Imprinted take(SoupMaker& maker, double tol = tolerance) {
  auto result = imprint(maker.soup(), tol, {});
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().to_line());
  return result.ok() ? std::move(*result) : Imprinted{};
}

/// "vertices/edges/faces"
std::string counts(const Imprinted& i) {
  return std::to_string(i.points.size()) + "/" + std::to_string(i.shape.edge_count()) + "/" +
         std::to_string(i.shape.face_count());
}

std::string counts(SoupMaker& maker) {
  return counts(take(maker));
}

double area(const Imprinted& i, Index f) {
  Vec3 sum;
  const Vec3 origin = i.points[i.shape.edges[i.shape.coedges[i.shape.loop_begin[i.shape.face_begin[f]]] / 2][0]];
  for (Index l = i.shape.face_begin[f]; l < i.shape.face_begin[f + 1]; ++l) {
    for (Index c = i.shape.loop_begin[l]; c < i.shape.loop_begin[l + 1]; ++c) {
      const Index code = i.shape.coedges[c];
      sum += cross(i.points[i.shape.edges[code / 2][code % 2]] - origin,
                   i.points[i.shape.edges[code / 2][1 - code % 2]] - origin);
    }
  }
  return 0.5 * dot(sum, i.planes[f].normal);
}

double whole_area(const Imprinted& i) {
  double sum = 0;
  for (Index f = 0; f < i.shape.face_count(); ++f) sum += area(i, f);
  return sum;
}

TEST(PlanarImprint, EntitiesThatCoincideAreOne) {
  EXPECT_EQ(counts(SoupMaker().operand().box({0, 0, 0}, {1, 1, 1}).operand().box({0, 0, 0}, {1, 1, 1})), "8/12/6");
  EXPECT_EQ(counts(SoupMaker().operand().box({0, 0, 0}, {1, 1, 1}).operand().box({1, 0, 0}, {2, 1, 1})), "12/20/11");
  EXPECT_EQ(counts(SoupMaker().operand().segment({0, 0, 0}, {1, 0, 0}).operand().segment({1, 0, 0}, {0, 0, 0})),
            "2/1/0");
  // Nearer than the tolerance is the same; the first gives the place.
  SoupMaker near;
  near.operand().point({1, 2, 3}).operand().point({1, 2, 3 + 5e-10});
  const Imprinted one = take(near);
  ASSERT_EQ(one.points.size(), 1u);
  EXPECT_EQ(one.points[0], (Vec3{1, 2, 3}));
  EXPECT_EQ(one.vertex_names[0].size(), 2u);
}

TEST(PlanarImprint, EdgesCrossTouchAndOverlap) {
  EXPECT_EQ(counts(SoupMaker().operand().segment({-1, 0, 0}, {1, 0, 0}).operand().segment({0, -1, 0}, {0, 1, 0})),
            "5/4/0");
  EXPECT_EQ(counts(SoupMaker().operand().segment({-1, 0, 0}, {1, 0, 0}).operand().segment({0, 0, 0}, {0, 1, 0})),
            "4/3/0");
  EXPECT_EQ(counts(SoupMaker().operand().segment({0, 0, 0}, {2, 0, 0}).operand().segment({1, 0, 0}, {3, 0, 0})),
            "4/3/0");
  EXPECT_EQ(counts(SoupMaker().operand().segment({0, 0, 0}, {3, 0, 0}).operand().segment({1, 0, 0}, {2, 0, 0})),
            "4/3/0");
  EXPECT_EQ(counts(SoupMaker().operand().segment({-1, 0, 0}, {1, 0, 0}).operand().segment({0, -1, 1e-8}, {0, 1, 1e-8})),
            "4/2/0");
  EXPECT_EQ(counts(SoupMaker().operand().segment({0, 0, 0}, {1, 1, 1}).operand().point({0.5, 0.5, 0.5})), "3/2/0");
}

TEST(PlanarImprint, PointsAndWiresOnFaces) {
  EXPECT_EQ(counts(SoupMaker().operand().polygon(rectangle(0, 0, 2, 2, 0)).operand().point({1, 1, 0})), "5/4/1");
  EXPECT_EQ(counts(SoupMaker().operand().polygon(rectangle(0, 0, 2, 2, 0)).operand().point({1, 0, 0})), "5/5/1");
  // Through it, into it, in it, across it, from its boundary inwards, along its boundary.
  const auto with = [](Vec3 a, Vec3 b) {
    return counts(SoupMaker().operand().polygon(rectangle(0, 0, 2, 2, 0)).operand().segment(a, b));
  };
  EXPECT_EQ(with({1, 1, -1}, {1, 1, 1}), "7/6/1");
  EXPECT_EQ(with({1, 1, 0}, {1, 1, 1}), "6/5/1");
  EXPECT_EQ(with({0.5, 1, 0}, {1.5, 1, 0}), "6/5/1");
  EXPECT_EQ(with({-1, 1, 0}, {3, 1, 0}), "8/9/2");
  EXPECT_EQ(with({0, 1, 0}, {1, 1, 0}), "6/6/1");
  EXPECT_EQ(with({-1, 0, 0}, {1, 0, 0}), "6/6/1");
  EXPECT_EQ(with({0, 0, 0}, {2, 2, 0}), "4/5/2");
}

TEST(PlanarImprint, SheetsCross) {
  const auto upright = [](double x0, double x1, double z0, double z1) {
    return std::vector<Vec3>{{x0, 1, z0}, {x1, 1, z0}, {x1, 1, z1}, {x0, 1, z1}};
  };
  const auto with = [&](const std::vector<Vec3>& other) {
    return counts(SoupMaker().operand().polygon(rectangle(0, 0, 2, 2, 0)).operand().polygon(other));
  };
  EXPECT_EQ(with(upright(-1, 3, -1, 1)), "10/11/3");     // wider: cut in two, with a slit
  EXPECT_EQ(with(upright(0.5, 1.5, -1, 1)), "10/11/3");  // a slit inside: one face with a loose edge
  EXPECT_EQ(with(upright(1, 3, -1, 1)), "10/11/2");      // to the middle
  EXPECT_EQ(with(upright(0.5, 1.5, 0, 1)), "8/8/2");     // standing on it
  EXPECT_EQ(with(upright(0, 2, -1, 1)), "10/13/4");      // exactly as wide
}

TEST(PlanarImprint, ThreeSheetsMeetInAPoint) {
  SoupMaker maker;
  maker.operand().polygon(rectangle(-1, -1, 1, 1, 0));
  maker.operand().polygon({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}});
  maker.operand().polygon({{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}});
  const Imprinted i = take(maker);
  // 12 corners, 2 ends of each of 3 lines but each end is in the middle of a side of two sheets, and the point.
  EXPECT_EQ(counts(i), "19/30/12");
  EXPECT_NEAR(whole_area(i), 12, 1e-12);
  bool found = false;
  for (Index v = 0; v < i.points.size(); ++v) {
    if (i.points[v] == Vec3{}) found = i.vertex_names[v].size() == 3;
  }
  EXPECT_TRUE(found);
}

TEST(PlanarImprint, CoplanarSheetsShareTheirCommonPart) {
  const auto pair = [](const std::vector<Vec3>& one, const std::vector<Vec3>& two) {
    return counts(SoupMaker().operand().polygon(one).operand().polygon(two));
  };
  EXPECT_EQ(pair(rectangle(0, 0, 2, 2, 0), rectangle(1, 1, 3, 3, 0)), "10/12/3");
  EXPECT_EQ(pair(rectangle(0, 0, 3, 3, 0), rectangle(1, 1, 2, 2, 0)), "8/8/2");  // a ring and its filling
  EXPECT_EQ(pair(rectangle(0, 0, 2, 2, 0), rectangle(0, 0, 1, 1, 0)), "7/8/2");
  EXPECT_EQ(pair(rectangle(0, 0, 1, 1, 0), rectangle(1, 0, 2, 1, 0)), "6/7/2");
  EXPECT_EQ(pair(rectangle(0, 0, 1, 1, 0), rectangle(1, 0.5, 2, 1.5, 0)), "8/9/2");
  EXPECT_EQ(pair(rectangle(0, 0, 1, 1, 0), rectangle(1, 1, 2, 2, 0)), "7/8/2");
  std::vector<Vec3> down = rectangle(0, 0, 2, 2, 0);
  std::reverse(down.begin(), down.end());
  EXPECT_EQ(pair(rectangle(0, 0, 2, 2, 0), down), "4/4/1");  // the other way round: still one
}

TEST(PlanarImprint, HolesStayHoles) {
  std::vector<Vec3> hole = rectangle(1, 1, 2, 2, 0);
  std::reverse(hole.begin(), hole.end());
  SoupMaker ring;
  ring.operand()
      .polygon({rectangle(0, 0, 3, 3, 0), hole})
      .operand()
      .polygon({{-1, 1.5, -1}, {4, 1.5, -1}, {4, 1.5, 1}, {-1, 1.5, 1}});
  const Imprinted i = take(ring);
  EXPECT_NEAR(whole_area(i), 8 + 10, 1e-12);
  EXPECT_EQ(counts(i), "16/18/3");  // two halves of the ring, the upright one with two slits
  SoupMaker filled;
  filled.operand().polygon({rectangle(0, 0, 3, 3, 0), hole}).operand().polygon(rectangle(1, 1, 2, 2, 0));
  EXPECT_EQ(counts(filled), "8/8/2");
  // A point in the hole is in no face.
  SoupMaker point;
  point.operand().polygon({rectangle(0, 0, 3, 3, 0), hole}).operand().point({1.5, 1.5, 0});
  const Imprinted p = take(point);
  EXPECT_EQ(p.vertex_names[8].size(), 1u);
}

TEST(PlanarImprint, AFlatAngleIsResolvedByIntegers) {
  // Two squares through the same line, a hundred-millionth of a radian apart.
  SoupMaker maker;
  const double rise = 3e-7;
  maker.operand().polygon(rectangle(-1, -1, 1, 1, 0));
  maker.operand().polygon({{-1.25, -0.75, -rise}, {1.25, -0.75, -rise}, {1.25, 0.5, rise}, {-1.25, 0.5, rise}});
  const Imprinted i = take(maker, 1e-9);
  EXPECT_NEAR(whole_area(i), 4 + 2.5 * 1.25, 1e-9);
  for (const Vec3 p : i.points) {
    if (std::abs(p.x) == 1 && std::abs(p.y) != 1) {
      EXPECT_NEAR(p.y, -0.125, 1e-9);
    }
  }
  EXPECT_EQ(counts(i), "10/11/3");
}

TEST(PlanarImprint, ThinFacesVanishAndTheirNeighboursStayWhole) {
  // Two triangles and a sliver between them: together a square.
  SoupMaker maker;
  const Vec3 a{0, 0, 0}, b{2, 0, 0}, c{2, 2, 0}, d{0, 2, 0}, m{1, 1 + 2e-10, 0};
  maker.operand(false).polygon({a, b, c}).polygon({a, c, m}).polygon({a, m, d}).polygon({m, c, d});
  const Imprinted i = take(maker);
  EXPECT_EQ(counts(i), "5/7/3");
  EXPECT_NEAR(whole_area(i), 4, 1e-8);
}

TEST(PlanarImprint, SelfIntersectingOperandsAreImprintedOnThemselves) {
  SoupMaker maker;
  maker.operand(false).box({0, 0, 0}, {2, 2, 2}).box({1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(counts(maker), "22/36/18");
  SoupMaker apart;
  apart.operand().box({0, 0, 0}, {2, 2, 2}).operand().box({1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(counts(apart), "22/36/18");
}

TEST(PlanarImprint, WhatCannotBeToldIsRefused) {
  SoupMaker chain;
  chain.operand().point({0, 0, 0}).operand().point({8e-4, 0, 0}).operand().point({16e-4, 0, 0});
  const auto wide = imprint(chain.soup(), 1e-3, {});
  ASSERT_FALSE(wide.ok());
  EXPECT_EQ(wide.error().code, errors::cluster_too_wide);
  EXPECT_EQ(wide.error().entities.size(), 3u);

  SoupMaker bent;
  bent.operand().polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}});
  const auto crooked = imprint(bent.soup(), tolerance, {});
  ASSERT_FALSE(crooked.ok());
  EXPECT_EQ(crooked.error().code, errors::face_not_planar);

  SoupMaker bow;  // crosses itself
  bow.operand(false).polygon({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}});
  const auto crossed = imprint(bow.soup(), tolerance, {});
  ASSERT_FALSE(crossed.ok());
  EXPECT_EQ(crossed.error().code, errors::planar_unresolved);
}

TEST(PlanarImprint, CanBeCancelled) {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  SoupMaker maker;
  maker.operand().box({0, 0, 0}, {2, 2, 2}).operand().box({1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(imprint(maker.soup(), tolerance, context).error().code, errors::cancelled);
}

/// Random boxes, sheets, wires and points on a small grid, where everything that can touch does.
SoupMaker random_grid(std::mt19937& random, int operands) {
  const auto pick = [&](int below) { return static_cast<double>(random() % static_cast<unsigned>(below)); };
  SoupMaker maker;
  for (int o = 0; o < operands; ++o) {
    maker.operand();
    const Vec3 at{pick(4), pick(4), pick(4)}, size{1 + pick(3), 1 + pick(3), 1 + pick(3)};
    switch (random() % 4) {
      case 0:
      case 1:
        maker.box(at, at + size);
        break;
      case 2: {
        const int axis = static_cast<int>(random() % 3);
        Vec3 u, w;
        u[(axis + 1) % 3] = size.x;
        w[(axis + 2) % 3] = size.y;
        maker.polygon({at, at + u, at + u + w, at + w});
        break;
      }
      default:
        maker.segment(at, at + size);
    }
  }
  return maker;
}

std::vector<double> sorted_areas(const Imprinted& i) {
  std::vector<double> areas;
  for (Index f = 0; f < i.shape.face_count(); ++f) areas.push_back(area(i, f));
  std::sort(areas.begin(), areas.end());
  return areas;
}

TEST(PlanarImprint, CommutesWithRigidMotions) {
  std::mt19937 random(20240229);
  for (int run = 0; run < 200; ++run) {
    SoupMaker maker = random_grid(random, 5);
    const Imprinted here = take(maker);
    Soup turned = maker.soup();
    const Transform motion = Transform::rotation(37.0 + run, {1, 2, 3}, {0.3, -0.2, 0.1});
    for (Vec3& p : turned.points) p = motion.point(p);
    const auto there = imprint(turned, tolerance, {});
    ASSERT_TRUE(there.ok()) << run << ": " << there.error().to_line();
    EXPECT_EQ(counts(here), counts(*there)) << run;
    const auto one = sorted_areas(here), two = sorted_areas(*there);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t f = 0; f < one.size(); ++f) EXPECT_NEAR(one[f], two[f], 1e-12);
  }
}

}  // namespace
}  // namespace aresta::planar
