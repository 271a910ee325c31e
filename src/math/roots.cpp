// SPDX-License-Identifier: Apache-2.0
#include "math/roots.h"

#include <algorithm>
#include <limits>

namespace aresta {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// b*b - a*c with one rounding's worth of error (Kahan).
double difference_of_products(double b1, double b2, double a, double c) {
  const double ac = a * c;
  const double error = std::fma(-a, c, ac);
  return std::fma(b1, b2, -ac) + error;
}

/// All real roots lie within this distance of zero (Fujiwara's bound).
double root_bound(std::span<const double> c) {
  const std::size_t n = c.size() - 1;
  double bound = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double ratio = std::abs(c[i] / c[n]) * (i == 0 ? 0.5 : 1.0);
    bound = std::max(bound, std::pow(ratio, 1.0 / static_cast<double>(n - i)));
  }
  return 2 * bound * (1 + 1e-12);
}

RealRoots roots_of_degree(std::span<const double> c);

/// Degree 3 and 4: bracket between the derivative's roots.
RealRoots roots_by_derivative(std::span<const double> c) {
  const std::size_t n = c.size() - 1;
  std::array<double, 4> derivative{};
  for (std::size_t i = 1; i <= n; ++i) derivative[i - 1] = static_cast<double>(i) * c[i];
  const RealRoots turning = roots_of_degree({derivative.data(), n});
  const double bound = root_bound(c);
  RealRoots result;
  if (!std::isfinite(bound)) return result;
  if (bound == 0) {
    result.push(0, n > 1);
    return result;
  }
  const auto f = [&](double x) { return evaluate_polynomial(c, x); };
  double previous = -bound, f_previous = f(previous);
  bool previous_is_zero = false;
  for (int i = 0; i <= turning.count; ++i) {
    const bool last = i == turning.count;
    const double x = last ? bound : std::clamp(turning.value[static_cast<std::size_t>(i)], -bound, bound);
    double error = 0;
    double fx = evaluate_polynomial(c, x, &error);
    const bool is_zero = !last && std::abs(fx) <= 2 * error;
    if (!is_zero && !previous_is_zero && f_previous != 0 && fx != 0 && (f_previous > 0) != (fx > 0)) {
      result.push(root_in_bracket(f, previous, x, f_previous, fx));
    } else if (last && !previous_is_zero && fx == 0) {
      result.push(x);
    }
    if (is_zero) {
      if (previous_is_zero && x - previous <= 8 * std::sqrt(eps) * std::max(std::abs(x), std::abs(previous))) {
        // Two turning points on the axis as one: a triple or fourfold root, listed once.
      } else {
        result.push(x, true);
      }
    } else if (previous_is_zero && !last) {
      // Nothing lies between a touch and the next turning point: the polynomial is monotone there and leaves zero.
    }
    previous = x;
    f_previous = fx;
    previous_is_zero = is_zero;
  }
  return result;
}

RealRoots roots_of_degree(std::span<const double> c) {
  std::size_t n = c.size();
  while (n > 0 && c[n - 1] == 0) --n;
  RealRoots result;
  if (n <= 1) return result;
  if (n == 2) {
    const double x = -c[0] / c[1];
    if (std::isfinite(x)) result.push(x);
    return result;
  }
  if (n == 3) return quadratic_roots(c[2], c[1], c[0]);
  return roots_by_derivative(c.first(n));
}

}  // namespace

double evaluate_polynomial(std::span<const double> c, double x, double* error) {
  double value = 0, magnitude = 0;
  for (std::size_t i = c.size(); i-- > 0;) {
    value = value * x + c[i];
    magnitude = magnitude * std::abs(x) + std::abs(c[i]);
  }
  if (error != nullptr) *error = 2 * eps * static_cast<double>(c.size()) * magnitude;
  return value;
}

RealRoots polynomial_roots(std::span<const double> c) {
  if (c.size() > 5) return {};
  for (const double x : c) {
    if (!std::isfinite(x)) return {};
  }
  // A power of two brings the largest coefficient near one: no overflow, no change of the roots.
  double largest = 0;
  for (const double x : c) largest = std::max(largest, std::abs(x));
  if (largest == 0) return {};
  std::array<double, 5> scaled{};
  const int exponent = std::ilogb(largest);
  for (std::size_t i = 0; i < c.size(); ++i) scaled[i] = std::scalbn(c[i], -exponent);
  return roots_of_degree({scaled.data(), c.size()});
}

RealRoots quadratic_roots(double a, double b, double c) {
  RealRoots result;
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c)) return result;
  if (a == 0) {
    if (b != 0 && std::isfinite(-c / b)) result.push(-c / b);
    return result;
  }
  // x -> x 2^k makes the outer coefficients alike in size, and the whole then near one: no over- or underflow.
  int shift = 0;
  if (c != 0) shift = (std::ilogb(c) - std::ilogb(a)) / 2;
  const double b0 = std::scalbn(b, shift), a0 = std::scalbn(a, 2 * shift);
  const double largest = std::max({std::abs(a0), std::abs(b0), std::abs(c)});
  if (!std::isfinite(largest) || a0 == 0) {  // beyond the range of doubles: the two roots are far apart
    const double small = -c / b, large = -b / a;
    if (small < large) {
      if (std::isfinite(small)) result.push(small);
      if (std::isfinite(large)) result.push(large);
    } else {
      if (std::isfinite(large)) result.push(large);
      if (std::isfinite(small)) result.push(small);
    }
    return result;
  }
  const int exponent = -std::ilogb(largest);
  const double as = std::scalbn(a0, exponent), bs = std::scalbn(b0, exponent) / 2, cs = std::scalbn(c, exponent);
  const double discriminant = difference_of_products(bs, bs, as, cs);
  const double noise = 2 * eps * std::max(bs * bs, std::abs(as * cs));
  const auto push = [&](double x, bool multiple = false) {
    x = std::scalbn(x, shift);
    if (std::isfinite(x)) result.push(x, multiple);
  };
  if (std::abs(discriminant) <= noise) {
    push(-bs / as, true);
    return result;
  }
  if (discriminant < 0) return result;
  const double q = -(bs + std::copysign(std::sqrt(discriminant), bs));
  const double x1 = q / as, x2 = cs / q;
  push(std::min(x1, x2));
  push(std::max(x1, x2));
  return result;
}

}  // namespace aresta
