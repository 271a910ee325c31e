// SPDX-License-Identifier: Apache-2.0
// Against GMP: sides, orders and points of random and of nearly degenerate planes, and the laws of the contract.
#include "math/exact_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "math/gmp_oracle.h"

namespace aresta {
namespace {

using oracle::nearest_double;
using oracle::Random;
using oracle::to_gmp;

constexpr std::int64_t range = Lattice::range;

// ---- the oracle ---------------------------------------------------------------------------------------------------

using GmpVector = std::array<mpz_class, 3>;

GmpVector gmp(const LatticePoint& p) {
  return {p[0], p[1], p[2]};
}
GmpVector gmp(const std::array<Int128, 3>& n) {
  return {to_gmp(n[0]), to_gmp(n[1]), to_gmp(n[2])};
}
GmpVector operator-(const GmpVector& a, const GmpVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
mpz_class dot(const GmpVector& a, const GmpVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
GmpVector cross(const GmpVector& a, const GmpVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class ratio(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class result(numerator, denominator);
  result.canonicalize();
  return result;
}

using GmpPoint = std::optional<std::array<mpq_class, 3>>;

GmpPoint gmp_line_plane(const LatticePoint& a, const LatticePoint& b, const ExactPlane& plane) {
  const GmpVector n = gmp(plane.normal()), d = gmp(b) - gmp(a);
  const mpz_class run = dot(n, d), rise = dot(n, gmp(plane.origin()) - gmp(a));
  if (run == 0) return std::nullopt;
  std::array<mpq_class, 3> point;
  for (int i = 0; i < 3; ++i) point[i] = a[i] + d[i] * ratio(rise, run);
  return point;
}

/// Not translated, unlike the code under test.
GmpPoint gmp_three_planes(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r) {
  const GmpVector np = gmp(p.normal()), nq = gmp(q.normal()), nr = gmp(r.normal());
  const mpz_class determinant = dot(np, cross(nq, nr));
  if (determinant == 0) return std::nullopt;
  const mpz_class cp = dot(np, gmp(p.origin())), cq = dot(nq, gmp(q.origin())), cr = dot(nr, gmp(r.origin()));
  const GmpVector qr = cross(nq, nr), rp = cross(nr, np), pq = cross(np, nq);
  std::array<mpq_class, 3> point;
  for (int i = 0; i < 3; ++i) point[i] = ratio(cp * qr[i] + cq * rp[i] + cr * pq[i], determinant);
  return point;
}

// ---- inputs -------------------------------------------------------------------------------------------------------

/// Points and planes of all kinds: spread over the range, at its corners, in small boxes far from the origin, triangles
/// like needles, points a few steps off a plane.
class Inputs {
 public:
  explicit Inputs(std::uint64_t seed) : random(seed) {}

  LatticePoint point() {
    switch (random.word() % 4) {
      case 0:
        return {corner(), corner(), corner()};
      case 1:
        return near(far_, 1000);
      default:
        return near({}, random.word() % 2 == 0 ? range : 100);
    }
  }
  LatticePoint near(const LatticePoint& p, std::int64_t reach) {
    LatticePoint q;
    for (int i = 0; i < 3; ++i) q[i] = std::clamp(p[i] + random.between(-reach, reach), -range, range);
    return q;
  }
  /// The third point is a few steps off the line of the others, or off their middle.
  std::array<LatticePoint, 3> needle() {
    const LatticePoint a = point(), b = point();
    LatticePoint middle;
    for (int i = 0; i < 3; ++i) middle[i] = (a[i] + b[i]) / 2;
    const std::int64_t reach = random.between(1, 3);
    return {a, b, near(random.word() % 2 == 0 ? middle : b, reach)};
  }
  ExactPlane plane() {
    while (true) {
      last_ = random.word() % 2 == 0 ? needle() : std::array{point(), point(), point()};
      if (const auto plane = plane_through(last_[0], last_[1], last_[2])) return *plane;
    }
  }
  /// A point exactly in the plane that plane() made last, as whole multiples of its triangle's sides.
  LatticePoint in_last_plane() {
    while (true) {
      const std::int64_t i = random.between(-2, 2), j = random.between(-2, 2);
      LatticePoint p;
      for (int k = 0; k < 3; ++k)
        p[k] = last_[0][k] + i * (last_[1][k] - last_[0][k]) + j * (last_[2][k] - last_[0][k]);
      if (in_lattice_range(p)) return p;
    }
  }
  /// The same, then up to three steps off.
  LatticePoint off_last_plane() {
    LatticePoint p = in_last_plane();
    auto& x = p[random.word() % 3];
    x = std::clamp(x + random.between(-3, 3), -range, range);
    return p;
  }
  /// Off `plane` by turning one of three points a few steps: nearly parallel, with or without a point in common.
  ExactPlane nearly_parallel(const ExactPlane& plane) {
    while (true) {
      const LatticePoint o = plane.origin();
      const LatticePoint a = random.word() % 2 == 0 ? o : near(o, 2);
      const LatticePoint b = near(near_plane(plane), 1), c = near(near_plane(plane), 1);
      if (const auto other = plane_through(a, b, c)) return *other;
    }
  }
  /// A point at most some steps off the plane, often in it.
  LatticePoint near_plane(const ExactPlane& plane) {
    const Vec3 n = unit_normal(plane);
    const int axis = std::abs(n.x) > std::abs(n.y) ? (std::abs(n.x) > std::abs(n.z) ? 0 : 2)
                                                   : (std::abs(n.y) > std::abs(n.z) ? 1 : 2);
    const LatticePoint o = plane.origin();
    const LatticePoint start = random.word() % 8 == 0 ? o : near(o, random.word() % 2 == 0 ? range / 8 : 1000);
    double rise = 0;
    for (int i = 0; i < 3; ++i) rise += i == axis ? 0 : n[i] * static_cast<double>(start[i] - o[i]);
    LatticePoint p = start;
    p[axis] = o[axis] - static_cast<std::int64_t>(std::clamp(std::nearbyint(rise / n[axis]), -0x1p52, 0x1p52));
    for (int i = 0; i < 3; ++i) p[i] = std::clamp(p[i] + random.between(-3, 3) * (i == axis), -range, range);
    return p;
  }
  Lattice lattice() { return Lattice(static_cast<int>(random.between(-60, 60))); }

  Random random;

 private:
  std::int64_t corner() { return random.word() % 2 == 0 ? range - random.between(0, 1) : -range; }
  std::array<LatticePoint, 3> last_{};
  LatticePoint far_{range / 3, -range / 5, range - 2000};
};

enum class Stage { filter, exact };

Stage stage_of(const Stages& stages) {
  EXPECT_EQ(stages.filter + stages.exact, 1U);
  EXPECT_EQ(stages.by_name, 0U) << "only callers count these";
  return stages.filter == 1 ? Stage::filter : Stage::exact;
}

struct Totals {
  std::uint64_t zero = 0, filter = 0, exact = 0;
  void add(bool is_zero, Stage stage) {
    zero += is_zero ? 1 : 0;
    (stage == Stage::filter ? filter : exact) += 1;
  }
};

LatticePoint at(std::int64_t x, std::int64_t y, std::int64_t z) {
  return {x, y, z};
}

ExactPlane plane_of(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return *plane_through(a, b, c);
}

// ---- planes -------------------------------------------------------------------------------------------------------

TEST(ExactPlane, PointsOnALineHaveNone) {
  EXPECT_FALSE(plane_through({1, 2, 3}, {1, 2, 3}, {7, 8, 8}));
  EXPECT_FALSE(plane_through({0, 0, 0}, {1, 2, 3}, {-5, -10, -15}));
  EXPECT_FALSE(plane_through({-range, -range, -range}, {0, 0, 0}, {range, range, range}));
  EXPECT_TRUE(plane_through({-range, -range, -range}, {0, 0, 1}, {range, range, range}));
  EXPECT_FALSE(plane_of_polygon({}));
  EXPECT_FALSE(plane_of_polygon(std::vector<LatticePoint>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}));
}

TEST(ExactPlane, NormalOfThreePointsIsTheCrossProduct) {
  Inputs inputs(1);
  for (int i = 0; i < 20000; ++i) {
    const auto t = inputs.needle();
    const GmpVector expected = cross(gmp(t[1]) - gmp(t[0]), gmp(t[2]) - gmp(t[0]));
    const auto plane = plane_through(t[0], t[1], t[2]);
    ASSERT_EQ(plane.has_value(), expected != (GmpVector{0, 0, 0}));
    if (plane) {
      ASSERT_EQ(gmp(plane->normal()), expected);
    }
  }
}

/// Newell's sum as it is usually written, without a point that triangles fan out from.
GmpVector newell(const std::vector<LatticePoint>& vertices) {
  GmpVector sum;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const GmpVector a = gmp(vertices[i]), b = gmp(vertices[(i + 1) % vertices.size()]);
    for (int k = 0; k < 3; ++k) {
      const int x = (k + 1) % 3, y = (k + 2) % 3;
      sum[k] += (a[x] - b[x]) * (a[y] + b[y]);
    }
  }
  return sum;
}

TEST(ExactPlane, NormalOfAPolygonIsNewellsSum) {
  Inputs inputs(2);
  for (int i = 0; i < 2000; ++i) {
    std::vector<LatticePoint> vertices(static_cast<std::size_t>(inputs.random.between(3, 40)));
    for (auto& v : vertices) v = inputs.point();
    const auto plane = plane_of_polygon(vertices);
    ASSERT_EQ(plane ? gmp(plane->normal()) : GmpVector{}, newell(vertices));
    if (!plane) continue;
    std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
    ASSERT_EQ(plane_of_polygon(vertices)->normal(), plane->normal()) << "whichever vertex is first";
    std::reverse(vertices.begin(), vertices.end());
    ASSERT_EQ(plane_of_polygon(vertices)->normal(), flipped(*plane).normal());
  }
}

TEST(ExactPlane, ThePolygonOfTheMostVerticesFits) {
  // 2^14 times around the largest square; the sum is 2^14 times its doubled area, 2 * 2^104.
  std::vector<LatticePoint> vertices;
  for (int i = 0; i < 1 << 14; ++i) {
    for (const auto& corner :
         {at(-range, -range, 5), at(range, -range, 5), at(range, range, 5), at(-range, range, 5)}) {
      vertices.push_back(corner);
    }
  }
  const auto plane = plane_of_polygon(vertices);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->normal(), (std::array<Int128, 3>{0, 0, Int128{1} << 119}));
  Stages stages;
  EXPECT_EQ(side(*plane, {range, -range, 5}, stages), 0);
  EXPECT_EQ(side(*plane, {range, -range, 6}, stages), 1);
}

/// Each component of n / |n|, relative error at most 6 * 2^-53, by squaring: no root is needed to compare.
TEST(ExactPlane, UnitNormalsOfNeedlesAreRight) {
  Inputs inputs(3);
  for (int i = 0; i < 20000; ++i) {
    const ExactPlane plane = inputs.plane();
    const Vec3 unit = unit_normal(plane);
    const GmpVector n = gmp(plane.normal());
    const mpz_class length2 = dot(n, n);
    for (int k = 0; k < 3; ++k) {
      const mpq_class got2 = mpq_class(unit[k]) * mpq_class(unit[k]);
      const mpq_class wanted2 = ratio(n[k] * n[k], length2);
      ASSERT_LE(abs(got2 - wanted2), wanted2 * mpq_class(12.001 * 0x1p-53)) << unit[k];
      ASSERT_EQ(sgn(n[k]), (unit[k] > 0) - (unit[k] < 0));
    }
  }
}

// ---- side ---------------------------------------------------------------------------------------------------------

TEST(Side, AgreesWithGmpAndIsAntisymmetric) {
  Inputs inputs(4);
  Totals totals;
  for (int i = 0; i < 300000; ++i) {
    const ExactPlane plane = inputs.plane();
    LatticePoint p;
    switch (i % 4) {
      case 0:
        p = inputs.point();
        break;
      case 1:
        p = inputs.near_plane(plane);
        break;
      case 2:
        p = inputs.in_last_plane();
        break;
      default:
        p = inputs.off_last_plane();
    }
    Stages stages, flipped_stages;
    const int s = side(plane, p, stages);
    ASSERT_EQ(s, sgn(dot(gmp(plane.normal()), gmp(p) - gmp(plane.origin()))));
    ASSERT_EQ(side(flipped(plane), p, flipped_stages), -s);
    ASSERT_EQ(stage_of(stages), stage_of(flipped_stages));
    totals.add(s == 0, stage_of(stages));
  }
  // The inputs are worth something: each case is there by the ten thousand.
  EXPECT_GT(totals.zero, 10000U);
  EXPECT_GT(totals.filter, 10000U);
  EXPECT_GT(totals.exact, 10000U);
}

TEST(Side, IsThatOfAllOrdersOfTheThreePoints) {
  Inputs inputs(5);
  for (int i = 0; i < 50000; ++i) {
    const auto t = inputs.needle();
    const auto plane = plane_through(t[0], t[1], t[2]);
    if (!plane) continue;
    const LatticePoint p = inputs.near_plane(*plane);
    Stages stages;
    const int s = side(*plane, p, stages);
    ASSERT_EQ(side(plane_of(t[1], t[2], t[0]), p, stages), s);
    ASSERT_EQ(side(plane_of(t[2], t[0], t[1]), p, stages), s);
    ASSERT_EQ(side(plane_of(t[1], t[0], t[2]), p, stages), -s);
    ASSERT_EQ(side(plane_of(t[0], t[2], t[1]), p, stages), -s);
    ASSERT_EQ(side(plane_of(t[2], t[1], t[0]), p, stages), -s);
    // The fourth point against three and one of the three against the others.
    if (s != 0) {
      ASSERT_EQ(side(plane_of(t[1], t[0], p), t[2], stages), s) << "two exchanges: the orientation of four points";
    }
    for (const auto& vertex : t) ASSERT_EQ(side(*plane, vertex, stages), 0);
  }
}

TEST(Side, StagesOfChosenPoints) {
  struct Case {
    const char* what;
    ExactPlane plane;
    LatticePoint point;
    int side;
    Stage stage;
  };
  const ExactPlane level = plane_of({0, 0, 0}, {range, 0, 0}, {0, range, 0});
  // x + y + z = 0, with a normal that doubles hold, and a plane whose normal they do not.
  const ExactPlane oblique = plane_of({1, -1, 0}, {0, 1, -1}, {-1, 0, 1});
  const ExactPlane crooked = plane_of({range, 0, 0}, {0, range - 1, 0}, {0, 0, range - 2});
  const Case cases[] = {
      {"far above", level, {5, 5, range}, 1, Stage::filter},
      {"one step below", level, {range, -range, -1}, -1, Stage::filter},
      {"in a plane along the axes: all products are zero", level, {17, -range, 0}, 0, Stage::filter},
      {"the origin of the plane", crooked, crooked.origin(), 0, Stage::filter},
      {"a vertex", crooked, {0, range - 1, 0}, 0, Stage::exact},
      {"a step off a vertex", crooked, {0, range - 1, 1}, 1, Stage::exact},
      {"four steps off a vertex", crooked, {0, range - 1, 4}, 1, Stage::filter},
      {"in an oblique plane", oblique, {range, -range, 0}, 0, Stage::exact},
      {"a step off, near", oblique, {100, -100, 1}, 1, Stage::filter},
      {"a step off, at the corner of the range", oblique, {range, -range, -1}, -1, Stage::exact},
      {"many steps off, at the corner of the range", oblique, {range, -range, -100}, -1, Stage::filter},
  };
  for (const Case& c : cases) {
    Stages stages;
    EXPECT_EQ(side(c.plane, c.point, stages), c.side) << c.what;
    EXPECT_EQ(stage_of(stages), c.stage) << c.what;
  }
}

// ---- order along a line -------------------------------------------------------------------------------------------

TEST(CompareAlongLine, AgreesWithGmpAndKeepsItsLaws) {
  Inputs inputs(6);
  Totals totals;
  for (int i = 0; i < 100000; ++i) {
    const LatticePoint a = inputs.point(), b = inputs.random.word() % 8 == 0 ? inputs.near(a, 1) : inputs.point();
    const ExactPlane p = inputs.plane();
    // Planes through a common point of the line meet it together; nearly parallel ones almost do.
    std::optional<ExactPlane> q;
    const LatticePoint c = inputs.point(), e = inputs.point();
    if (inputs.random.word() % 2 == 0) q = plane_through(c, p.origin(), e);
    if (!q) q = inputs.random.word() % 2 == 0 ? inputs.nearly_parallel(p) : inputs.plane();
    const LatticePoint from = inputs.random.word() % 2 == 0 ? p.origin() : a;

    Stages stages;
    const auto order = compare_along_line(from, b, p, *q, stages);
    const GmpVector d = gmp(b) - gmp(from), np = gmp(p.normal()), nq = gmp(q->normal());
    const mpz_class p_run = dot(np, d), q_run = dot(nq, d);
    ASSERT_EQ(order.has_value(), p_run != 0 && q_run != 0);
    if (order) {
      const mpq_class tp = ratio(dot(np, gmp(p.origin()) - gmp(from)), p_run);
      const mpq_class tq = ratio(dot(nq, gmp(q->origin()) - gmp(from)), q_run);
      ASSERT_EQ(*order, cmp(tp, tq) > 0 ? 1 : cmp(tp, tq) < 0 ? -1 : 0);
    }
    const auto minus = order ? std::optional(-*order) : std::nullopt;
    Stages others[4];
    ASSERT_EQ(compare_along_line(from, b, *q, p, others[0]), minus);
    ASSERT_EQ(compare_along_line(b, from, p, *q, others[1]), minus);
    ASSERT_EQ(compare_along_line(from, b, flipped(p), *q, others[2]), order);
    ASSERT_EQ(compare_along_line(from, b, p, flipped(*q), others[3]), order);
    for (const Stages& other : others) ASSERT_EQ(stage_of(other), stage_of(stages));
    totals.add(order == 0, stage_of(stages));
  }
  EXPECT_GT(totals.zero, 10000U);
  EXPECT_GT(totals.filter, 10000U);
  EXPECT_GT(totals.exact, 10000U);
}

TEST(CompareAlongLine, ChosenLines) {
  const ExactPlane level = plane_of({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const ExactPlane above = plane_of({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  Stages stages;
  EXPECT_EQ(compare_along_line({0, 0, -9}, {0, 0, -8}, level, above, stages), -1);
  EXPECT_EQ(compare_along_line({0, 0, -8}, {0, 0, -9}, level, above, stages), 1);
  EXPECT_EQ(compare_along_line({0, 0, -9}, {0, 0, -8}, level, level, stages), 0);
  EXPECT_EQ(compare_along_line({0, 0, 0}, {1, 1, 0}, level, above, stages), std::nullopt) << "parallel";
  EXPECT_EQ(compare_along_line({3, 3, 3}, {3, 3, 3}, level, above, stages), std::nullopt) << "no line";
}

// ---- points -------------------------------------------------------------------------------------------------------

/// Is the point there when it should be, and as precise as the stage that found it promises?
void expect_right(const std::optional<Vec3>& point, const GmpPoint& expected, const Lattice& lattice, double precision,
                  Stage stage) {
  ASSERT_EQ(point.has_value(), expected.has_value());
  if (!point) return;
  for (int i = 0; i < 3; ++i) {
    const mpq_class exact = (*expected)[i] * mpq_class(lattice.step());
    if (stage == Stage::exact || precision == 0) {
      ASSERT_EQ((*point)[i], nearest_double(exact));
    } else {
      ASSERT_LE(abs(mpq_class((*point)[i]) - exact), mpq_class(precision));
    }
  }
}

void expect_same_bits(const std::optional<Vec3>& a, const std::optional<Vec3>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(std::bit_cast<std::uint64_t>((*a)[i]), std::bit_cast<std::uint64_t>((*b)[i]));
  }
}

/// In steps: always exact, about what doubles reach for points of all sizes, the usual, and what only wild
/// intersections miss.
double some_precision(Random& random) {
  const double choices[] = {0, std::ldexp(1.0, static_cast<int>(random.between(-60, 2))), 100, 1e9};
  return choices[random.word() % 4];
}

TEST(LinePlanePoint, AgreesWithGmpAndKeepsItsLaws) {
  Inputs inputs(7);
  Totals totals;
  for (int i = 0; i < 100000; ++i) {
    const ExactPlane plane = inputs.plane();
    const auto end = [&] {
      const std::uint64_t kind = inputs.random.word() % 4;
      return kind == 0 ? inputs.in_last_plane() : kind == 1 ? inputs.near_plane(plane) : inputs.point();
    };
    const LatticePoint a = end(), b = end();
    const Lattice lattice = inputs.lattice();
    const double precision = some_precision(inputs.random) * lattice.step();
    Stages stages;
    const auto point = line_plane_point(a, b, plane, lattice, precision, stages);
    expect_right(point, gmp_line_plane(a, b, plane), lattice, precision, stage_of(stages));
    Stages others[2];
    expect_same_bits(line_plane_point(b, a, plane, lattice, precision, others[0]), point);
    expect_same_bits(line_plane_point(a, b, flipped(plane), lattice, precision, others[1]), point);
    for (const Stages& other : others) ASSERT_EQ(stage_of(other), stage_of(stages));
    if (HasFatalFailure()) FAIL() << "input " << i;
    totals.add(!point, stage_of(stages));
  }
  EXPECT_GT(totals.zero, 1000U);
  EXPECT_GT(totals.filter, 10000U);
  EXPECT_GT(totals.exact, 10000U);
}

TEST(LinePlanePoint, StagesOfChosenLines) {
  const ExactPlane level = plane_of({0, 0, 0}, {range, 0, 0}, {0, range, 0});
  const ExactPlane oblique = plane_of({range, 0, 0}, {0, range - 1, 0}, {0, 0, range - 2});
  const Lattice lattice(-51);
  struct Case {
    const char* what;
    ExactPlane plane;
    LatticePoint a, b;
    double precision;
    std::optional<Vec3> point;
    Stage stage;
  };
  const Case cases[] = {
      {"square to it", level, {0, range, -range}, {0, range, range}, 1e-12, Vec3{0, 1, 0}, Stage::filter},
      {"the same, for all bits", level, {0, range, -range}, {0, range, range}, 0, Vec3{0, 1, 0}, Stage::exact},
      {"a third", level, {0, 0, -1}, {1, -1, 2}, 0, Vec3{0x1p-51 / 3, -0x1p-51 / 3, 0}, Stage::exact},
      {"along the plane", level, {0, 0, 7}, {range, 3, 7}, 1e-12, std::nullopt, Stage::filter},
      {"in the plane", level, {0, 0, 0}, {range, 3, 0}, 1e-12, std::nullopt, Stage::filter},
      {"in an oblique plane", oblique, {range, 0, 0}, {0, range - 1, 0}, 1e-12, std::nullopt, Stage::exact},
      {"no line", oblique, {3, 4, 5}, {3, 4, 5}, 1e-12, std::nullopt, Stage::filter},
      {"a step from parallel", level, {-range, 0, 0}, {range, 0, 1}, 1e-12, Vec3{-1, 0, 0}, Stage::filter},
      {"almost parallel",
       oblique,
       {range, 0, 1},
       {0, range - 1, 2},
       1e-12,
       Vec3{2, -0x1.ffffffffffffcp-1, 0},
       Stage::exact},
  };
  for (const Case& c : cases) {
    Stages stages;
    EXPECT_EQ(line_plane_point(c.a, c.b, c.plane, lattice, c.precision, stages), c.point) << c.what;
    EXPECT_EQ(stage_of(stages), c.stage) << c.what;
  }
}

TEST(ThreePlanePoint, AgreesWithGmpAndKeepsItsLaws) {
  Inputs inputs(8);
  Totals totals;
  for (int i = 0; i < 60000; ++i) {
    const ExactPlane p = inputs.plane();
    const ExactPlane q = inputs.random.word() % 4 == 0 ? inputs.nearly_parallel(p) : inputs.plane();
    std::optional<ExactPlane> r;
    // Now and then one that has a line in common with the others, or is one of them.
    const auto point_of_p_and_q = inputs.random.word() % 8 == 0 ? std::optional(p.origin()) : std::nullopt;
    if (point_of_p_and_q) r = inputs.random.word() % 2 == 0 ? flipped(p) : inputs.nearly_parallel(q);
    if (!r) r = inputs.random.word() % 4 == 0 ? inputs.nearly_parallel(p) : inputs.plane();
    const Lattice lattice = inputs.lattice();
    const double precision = some_precision(inputs.random) * lattice.step();
    Stages stages;
    const auto point = three_plane_point(p, q, *r, lattice, precision, stages);
    expect_right(point, gmp_three_planes(p, q, *r), lattice, precision, stage_of(stages));
    Stages others[6];
    expect_same_bits(three_plane_point(p, *r, q, lattice, precision, others[0]), point);
    expect_same_bits(three_plane_point(q, p, *r, lattice, precision, others[1]), point);
    expect_same_bits(three_plane_point(q, *r, p, lattice, precision, others[2]), point);
    expect_same_bits(three_plane_point(*r, p, q, lattice, precision, others[3]), point);
    expect_same_bits(three_plane_point(*r, q, p, lattice, precision, others[4]), point);
    expect_same_bits(three_plane_point(flipped(p), q, flipped(*r), lattice, precision, others[5]), point);
    for (const Stages& other : others) ASSERT_EQ(stage_of(other), stage_of(stages));
    if (HasFatalFailure()) FAIL() << "input " << i;
    totals.add(!point, stage_of(stages));
  }
  EXPECT_GT(totals.zero, 1000U);
  EXPECT_GT(totals.filter, 10000U);
  EXPECT_GT(totals.exact, 10000U);
}

TEST(ThreePlanePoint, StagesOfChosenPlanes) {
  const ExactPlane x = plane_of({5, 0, 0}, {5, 1, 0}, {5, 0, 1});
  const ExactPlane y = plane_of({0, -7, 0}, {0, -7, 1}, {1, -7, 0});
  const ExactPlane z = plane_of({0, 0, 9}, {1, 0, 9}, {0, 1, 9});
  const ExactPlane diagonal = plane_of({5, -7, 0}, {5, -7, 1}, {6, -6, 0});
  // Three planes through one line, none along an axis; and two that only differ in the last bit of a point.
  const LatticePoint a = at(range, 3, 1), b = at(-range + 5, 17, range - 2);
  const ExactPlane fan[] = {plane_of(a, b, {7, 8, 9}), plane_of(a, b, {-7, 1 << 30, 9}),
                            plane_of(a, b, {1, 1, -range})};
  const ExactPlane tilted = plane_of({range, 3, 2}, b, {7, 8, 9});
  const ExactPlane floor = plane_of({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  const Lattice lattice(0);
  const auto expect = [&](const ExactPlane& p, const ExactPlane& q, const ExactPlane& r, double precision,
                          std::optional<Vec3> point, Stage stage, const char* what) {
    Stages one;
    EXPECT_EQ(three_plane_point(p, q, r, lattice, precision, one), point) << what;
    EXPECT_EQ(stage_of(one), stage) << what;
  };
  expect(x, y, z, 1e-9, Vec3{5, -7, 9}, Stage::filter, "along the axes");
  expect(x, y, z, 0, Vec3{5, -7, 9}, Stage::exact, "the same, for all bits");
  expect(x, y, x, 1e-9, std::nullopt, Stage::filter, "twice the same along an axis");
  expect(x, y, diagonal, 1e-9, std::nullopt, Stage::filter, "through one line along an axis: all products are zero");
  expect(fan[0], fan[1], fan[2], 1e-9, std::nullopt, Stage::exact, "through one long line");
  expect(fan[0], fan[0], fan[2], 1e-9, std::nullopt, Stage::exact, "twice the same");
  expect(fan[0], fan[1], floor, 1e-9, Vec3{0x1p51, 3, 1}, Stage::exact, "a lattice point, found to the last bit");
  expect(fan[0], tilted, fan[1], 1, Vec3{-0x1p51 + 5, 17, 0x1p51 - 2}, Stage::exact, "nearly parallel");
}

// ---- all compilers ------------------------------------------------------------------------------------------------

/// The bits of 40,000 results and the stages that found them, as one number, the same for all compilers and options.
TEST(ExactPoints, SameBitsWithAllCompilers) {
  Random random(9);
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a, by words
  const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 1099511628211U; };
  const auto add_point = [&](const std::optional<Vec3>& point) {
    for (int i = 0; i < 3; ++i) add(point ? std::bit_cast<std::uint64_t>((*point)[i]) : 0);
  };
  const auto point = [&] {
    const std::int64_t reach = random.word() % 2 == 0 ? range : 20;
    LatticePoint p;
    for (auto& x : p) x = random.between(-reach, reach);
    return p;
  };
  const Lattice lattice(-40);
  Stages stages;
  for (int i = 0; i < 10000; ++i) {
    const LatticePoint a = point(), b = point(), c = point(), d = point(), e = point();
    const auto p = plane_through(a, d, e), q = plane_through(b, point(), c), r = plane_through(c, a, b);
    if (!p || !q || !r) continue;
    add(static_cast<std::uint64_t>(side(*p, c, stages)));
    add(static_cast<std::uint64_t>(compare_along_line(b, c, *p, *q, stages).value_or(2)));
    add_point(line_plane_point(b, c, *p, lattice, lattice.step(), stages));
    add_point(three_plane_point(*p, *q, *r, lattice, lattice.step(), stages));
    add_point(unit_normal(*p));
  }
  add(stages.filter);
  add(stages.exact);
  EXPECT_EQ(hash, 4262938793255495300U);
}

}  // namespace
}  // namespace aresta
