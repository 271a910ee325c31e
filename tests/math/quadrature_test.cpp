// SPDX-License-Identifier: Apache-2.0
#include "math/quadrature.h"

#include <gtest/gtest.h>

#include <numbers>

namespace aresta {
namespace {

TEST(Quadrature, OneRuleIsExactForPolynomials) {
  // 15 points are exact to degree 22; the 7 that tell the error, to degree 13.
  const auto r = integrate([](double x) { return std::pow(x, 13); }, 0, 1);
  EXPECT_NEAR(r.value, 1.0 / 14, 1e-16);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.evaluations, 15);
  const auto high = integrate([](double x) { return std::pow(x, 22); }, 0, 1, 1.0);
  EXPECT_EQ(high.evaluations, 15);
  EXPECT_NEAR(high.value, 1.0 / 23, 1e-16);
}

TEST(Quadrature, KnownIntegrals) {
  EXPECT_NEAR(integrate([](double x) { return std::sin(x); }, 0, std::numbers::pi).value, 2, 4e-15);
  EXPECT_NEAR(integrate([](double x) { return std::exp(-x * x); }, -8, 8).value, std::sqrt(std::numbers::pi), 4e-15);
  EXPECT_NEAR(integrate([](double x) { return std::sqrt(x); }, 0, 1).value, 2.0 / 3, 1e-12);
  EXPECT_NEAR(integrate([](double x) { return 1 / (1e-4 + x * x); }, -1, 1).value, 200 * std::atan(100), 1e-9);
  EXPECT_NEAR(integrate([](double x) { return std::abs(x - 0.3); }, 0, 1).value, 0.29, 1e-12);
}

TEST(Quadrature, ReversedAndEmptyIntervals) {
  EXPECT_NEAR(integrate([](double x) { return x; }, 1, 0).value, -0.5, 1e-16);
  EXPECT_EQ(integrate([](double x) { return x; }, 3, 3).value, 0);
}

TEST(Quadrature, ArraysShareTheirPoints) {
  const auto r = integrate([](double x) { return std::array<double, 3>{1, x, std::cos(x)}; }, 0, 2, 1e-13);
  EXPECT_NEAR(r.value[0], 2, 1e-15);
  EXPECT_NEAR(r.value[1], 2, 1e-15);
  EXPECT_NEAR(r.value[2], std::sin(2), 1e-15);
}

TEST(Quadrature, TheErrorEstimateCoversTheError) {
  for (const double relative : {1e-4, 1e-7, 1e-10}) {
    const auto r = integrate([](double x) { return std::sqrt(x) * std::cos(20 * x); }, 0, 1, relative);
    // Reference by tanh-sinh quadrature with 30 digits.
    EXPECT_LE(std::abs(r.value - 0.0391784611980048221), r.error + 1e-16);
    EXPECT_TRUE(r.converged);
  }
}

TEST(Quadrature, SaysWhenItFails) {
  const auto pole = integrate([](double x) { return 1 / x; }, 0, 1);
  EXPECT_FALSE(pole.converged);
  const auto nan = integrate([](double) { return std::nan(""); }, 0, 1);
  EXPECT_FALSE(nan.converged);
  const auto unbounded = integrate([](double x) { return x; }, 0, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(unbounded.converged);
  const auto budget = integrate([](double x) { return std::sin(1e6 * x); }, 0, 1,
                                QuadratureOptions{.relative = 1e-12, .max_intervals = 10});
  EXPECT_FALSE(budget.converged);
  EXPECT_LE(budget.evaluations, 15 + 30 * 10);
}

}  // namespace
}  // namespace aresta
