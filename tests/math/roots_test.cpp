// SPDX-License-Identifier: Apache-2.0
#include "math/roots.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace aresta {
namespace {

RealRoots roots(std::vector<double> c) {
  return polynomial_roots(c);
}

/// Coefficients of lead * product of (x - r).
std::vector<double> from_roots(const std::vector<double>& r, double lead = 1) {
  std::vector<double> c{lead};
  for (const double x : r) {
    c.push_back(0);
    for (std::size_t i = c.size(); i-- > 0;) c[i] = (i > 0 ? c[i - 1] : 0) - x * c[i];
  }
  return c;
}

TEST(Quadratic, LosesNothingToCancellation) {
  // x^2 - 1e8 x + 1: the textbook formula has no right digit in the small root.
  const RealRoots r = quadratic_roots(1, -1e8, 1);
  ASSERT_EQ(r.count, 2);
  EXPECT_NEAR(r.value[0], 1e-8 * (1 + 1e-16), 1e-23);
  EXPECT_DOUBLE_EQ(r.value[1], 1e8 - 1e-8);
}

TEST(Quadratic, NearbyRootsKeepTheirDistance) {
  // (x - 1)(x - 1 - 2^-23): exact coefficients; a rounded discriminant would get the distance wrong in its second
  // digit.
  const double gap = std::ldexp(1.0, -23);
  const RealRoots r = quadratic_roots(1, -2 - gap, 1 + gap);
  ASSERT_EQ(r.count, 2);
  EXPECT_DOUBLE_EQ(r.value[0], 1);
  EXPECT_NEAR(r.value[1] - r.value[0], gap, 3e-16);
}

TEST(Quadratic, ScalesFromTinyToHuge) {
  for (const double s : {1e-150, 1e-100, 1.0, 1e100, 1e150}) {
    const RealRoots r = quadratic_roots(s, -3 * s, 2 * s);
    ASSERT_EQ(r.count, 2);
    EXPECT_DOUBLE_EQ(r.value[0], 1);
    EXPECT_DOUBLE_EQ(r.value[1], 2);
    const RealRoots far = quadratic_roots(1, -3 * s, 2 * s * s);
    ASSERT_EQ(far.count, 2) << s;
    EXPECT_DOUBLE_EQ(far.value[0], s);
    EXPECT_DOUBLE_EQ(far.value[1], 2 * s);
  }
}

TEST(Quadratic, DoubleRootOnceAndNoneWhenComplex) {
  const RealRoots twice = quadratic_roots(1, -6, 9);
  ASSERT_EQ(twice.count, 1);
  EXPECT_EQ(twice.value[0], 3);
  EXPECT_TRUE(twice.multiple[0]);
  EXPECT_EQ(quadratic_roots(1, 0, 1).count, 0);
  EXPECT_EQ(quadratic_roots(0, 2, -6).value[0], 3);
  EXPECT_EQ(quadratic_roots(0, 0, 1).count, 0);
  EXPECT_EQ(quadratic_roots(1, 0, 0).value[0], 0);
  EXPECT_EQ(quadratic_roots(std::nan(""), 0, 1).count, 0);
}

TEST(Polynomial, DegreesAndLeadingZeros) {
  EXPECT_EQ(roots({}).count, 0);
  EXPECT_EQ(roots({5}).count, 0);
  EXPECT_EQ(roots({0, 0, 0, 0, 0}).count, 0);
  EXPECT_EQ(roots({-6, 2, 0, 0, 0}).value[0], 3);
  EXPECT_EQ(roots({1, 2, std::numeric_limits<double>::infinity()}).count, 0);
  EXPECT_EQ(roots({1, 1, 1, 1, 1, 1}).count, 0);  // degree 5 is refused
}

TEST(Polynomial, KnownQuartics) {
  const RealRoots r = roots(from_roots({-3, -1, 2, 5}));
  ASSERT_EQ(r.count, 4);
  EXPECT_DOUBLE_EQ(r.value[0], -3);
  EXPECT_DOUBLE_EQ(r.value[1], -1);
  EXPECT_DOUBLE_EQ(r.value[2], 2);
  EXPECT_DOUBLE_EQ(r.value[3], 5);
  EXPECT_EQ(roots({1, 0, 0, 0, 1}).count, 0);  // x^4 + 1
  const RealRoots two = roots({-1, 0, 0, 0, 1});
  ASSERT_EQ(two.count, 2);
  EXPECT_DOUBLE_EQ(two.value[1], 1);
}

TEST(Polynomial, MultipleRootsAreListedOnce) {
  const auto expect = [](const std::vector<double>& given, const std::vector<double>& distinct, double tolerance) {
    const RealRoots r = roots(from_roots(given));
    ASSERT_EQ(r.count, static_cast<int>(distinct.size())) << ::testing::PrintToString(given);
    for (std::size_t i = 0; i < distinct.size(); ++i) EXPECT_NEAR(r.value[i], distinct[i], tolerance);
  };
  expect({2, 2, -1, 4}, {-1, 2, 4}, 1e-7);
  expect({2, 2, 3, 3}, {2, 3}, 1e-7);
  expect({1, 1, 1, 7}, {1, 7}, 1e-4);
  expect({1, 1, 1, 1}, {1}, 1e-3);
  expect({0, 0, 0, 0}, {0}, 0);
  expect({5, 5, 5}, {5}, 1e-4);
  expect({-0.1, -0.1, 0.3}, {-0.1, 0.3}, 1e-7);
}

TEST(Polynomial, NearDoubleRootsStayTwoWhileDoublesCanTell) {
  for (const double gap : {1e-2, 1e-4, 1e-6}) {
    const RealRoots r = roots(from_roots({1, 1 + gap, -2, 3}));
    ASSERT_EQ(r.count, 4) << gap;
    EXPECT_NEAR(r.value[2] - r.value[1], gap, 1e-14 / gap * 10);
  }
  EXPECT_EQ(roots(from_roots({1, 1 + 1e-12, -2, 3})).count, 3);
}

TEST(Polynomial, WideScales) {
  const RealRoots r = roots(from_roots({1e-6, 1, 1e6, 1e9}));
  ASSERT_EQ(r.count, 4);
  EXPECT_NEAR(r.value[0] / 1e-6, 1, 1e-14);
  EXPECT_NEAR(r.value[1], 1, 1e-14);
  EXPECT_NEAR(r.value[2] / 1e6, 1, 1e-14);
  EXPECT_NEAR(r.value[3] / 1e9, 1, 1e-14);
  const RealRoots tiny = roots(from_roots({1e-60, 3e-60, 1e-59, 2e-59}));
  ASSERT_EQ(tiny.count, 4);
  EXPECT_NEAR(tiny.value[3] / 2e-59, 1, 1e-13);
}

TEST(Polynomial, RandomRootsAreFoundAgain) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-10, 10);
  for (int round = 0; round < 5000; ++round) {
    std::vector<double> given(4);
    for (double& x : given) x = place(random);
    std::sort(given.begin(), given.end());
    double gap = 1e9;
    for (std::size_t i = 1; i < 4; ++i) gap = std::min(gap, given[i] - given[i - 1]);
    if (gap < 1e-3) continue;
    const RealRoots r = roots(from_roots(given, 3.7));
    ASSERT_EQ(r.count, 4) << ::testing::PrintToString(given);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(r.value[i], given[i], 1e-10 / gap);
  }
}

TEST(Bracket, FindsTheRootToTheLastBits) {
  const auto f = [](double x) { return std::cos(x) - x; };
  const double x = root_in_bracket(f, 0.0, 1.0, f(0), f(1));
  EXPECT_NEAR(x, 0.73908513321516064, 2e-16);
  int calls = 0;
  const auto step = [&](double t) { return ++calls, t < 0.123 ? -1.0 : 1e30; };
  EXPECT_NEAR(root_in_bracket(step, -1e10, 1e10, -1.0, 1e30), 0.123, 1e-15);
  EXPECT_LE(calls, 200);
  const auto cubic = [](double t) { return t * t * t; };
  EXPECT_NEAR(root_in_bracket(cubic, -1.0, 2.0, -1.0, 8.0), 0, 1e-16);
}

}  // namespace
}  // namespace aresta
