// SPDX-License-Identifier: Apache-2.0
// Real roots of polynomials to degree 4, and of a function in a bracket.
#pragma once

#include <array>
#include <cmath>
#include <span>

namespace aresta {

/// Real roots, growing. A multiple root (a touch of the axis, as far as doubles can tell) is listed once and marked.
struct RealRoots {
  std::array<double, 4> value{};
  std::array<bool, 4> multiple{};
  int count = 0;

  void push(double root, bool is_multiple = false) {
    value[static_cast<std::size_t>(count)] = root;
    multiple[static_cast<std::size_t>(count)] = is_multiple;
    ++count;
  }
  std::span<const double> span() const { return {value.data(), static_cast<std::size_t>(count)}; }
};

/// Value of c[0] + c[1] x + ... and, in `error` when given, a bound of its rounding error.
double evaluate_polynomial(std::span<const double> c, double x, double* error = nullptr);

/// Real roots of c[0] + c[1] x + ... + c[n] x^n, n <= 4. Leading zeros lower the degree; a constant has none (nor has
/// the zero polynomial); coefficients that are not finite give none. Simple roots are accurate to a few ulps of their
/// condition; two roots nearer than rounding can tell are one, marked multiple.
/// Method: between neighbouring roots of the derivative the polynomial is monotone and has at most one root, found in
/// its bracket; a root of the derivative where the value is below its rounding error is a multiple root.
RealRoots polynomial_roots(std::span<const double> c);

/// a x^2 + b x + c: no cancellation in the discriminant (fused multiply-add) nor in the roots. A discriminant that the
/// rounding of the coefficients alone could have made counts as zero.
RealRoots quadratic_roots(double a, double b, double c);

/// A root of f in [low, high], where f changes sign (a zero end is returned); to the last bit or two. Brent's method
/// with a bisection safeguard: at most about 200 evaluations whatever f does. `f` must be finite on the bracket.
template <class F>
double root_in_bracket(F&& f, double low, double high, double f_low, double f_high) {
  if (f_low == 0) return low;
  if (f_high == 0) return high;
  double a = low, b = high, fa = f_low, fb = f_high, c = a, fc = fa, step = b - a, previous = step;
  for (int i = 0; i < 200; ++i) {
    if ((fb > 0) == (fc > 0)) {
      c = a, fc = fa;
      step = previous = b - a;
    }
    if (std::abs(fc) < std::abs(fb)) {
      a = b, b = c, c = a;
      fa = fb, fb = fc, fc = fa;
    }
    const double tolerance = 2.2e-16 * std::abs(b);
    const double half = 0.5 * (c - b);
    if (std::abs(half) <= tolerance || fb == 0) break;
    if (std::abs(previous) >= tolerance && std::abs(fa) > std::abs(fb)) {
      const double s = fb / fa;
      double p, q;
      if (a == c) {
        p = 2 * half * s;
        q = 1 - s;
      } else {
        const double r = fb / fc, t = fa / fc;
        p = s * (2 * half * t * (t - r) - (b - a) * (r - 1));
        q = (t - 1) * (r - 1) * (s - 1);
      }
      if (p > 0) q = -q;
      p = std::abs(p);
      if (2 * p < std::min(3 * half * q - std::abs(tolerance * q), std::abs(previous * q))) {
        previous = step;
        step = p / q;
      } else {
        step = previous = half;
      }
    } else {
      step = previous = half;
    }
    a = b, fa = fb;
    b += std::abs(step) > tolerance ? step : half > 0 ? tolerance : -tolerance;
    // At zero the relative tolerance vanishes; an unmoved b would loop, so step by the smallest bracket left.
    if (b == a) b = 0.5 * (b + c);
    fb = f(b);
  }
  return b;
}

}  // namespace aresta
