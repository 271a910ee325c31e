// SPDX-License-Identifier: Apache-2.0
// Adaptive quadrature of numbers and of small fixed arrays of numbers.
//
// Rule: Gauss-Kronrod with 7 and 15 points (Piessens, de Doncker, Kahaner, Ueberhuber: QUADPACK, 1983); the worst
// interval is halved until the error estimates sum to less than the tolerance. The order of the work depends on the
// integrand alone, so results are the same everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace aresta {

template <class Value>
struct Integral {
  Value value{};
  double error = 0;        ///< estimate of the largest component's absolute error
  bool converged = false;  ///< error <= the tolerance asked for
  int evaluations = 0;
};

struct QuadratureOptions {
  double absolute = 0;       ///< the error may be this large,
  double relative = 1e-12;   ///< or this part of the largest component of the integral of |f|, whichever is larger
  int max_intervals = 2000;  ///< when more would be needed, `converged` stays false
};

namespace quadrature_detail {

inline double add_scaled(double& sum, double w, double f) {
  return sum += w * f;
}
template <std::size_t size>
void add_scaled(std::array<double, size>& sum, double w, const std::array<double, size>& f) {
  for (std::size_t i = 0; i < size; ++i) sum[i] += w * f[i];
}
inline double largest_difference(double a, double b) {
  return std::abs(a - b);
}
template <std::size_t size>
double largest_difference(const std::array<double, size>& a, const std::array<double, size>& b) {
  double m = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double d = std::abs(a[i] - b[i]);
    if (!(d <= m)) m = d;  // keeps NaN
  }
  return m;
}
inline double largest_size(double a) {
  return std::abs(a);
}
template <std::size_t size>
double largest_size(const std::array<double, size>& a) {
  return largest_difference(a, std::array<double, size>{});
}

template <class Value>
struct Interval {
  double low, high, error, size;
  Value value;
};

template <class Value, class F>
Interval<Value> gauss_kronrod(F& f, double low, double high) {
  static constexpr std::array<double, 8> node = {
      0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
      0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
      0.586087235467691130294144691258480, 0.405845151377397166906606412076961,
      0.207784955007898467600689403773245, 0.0};
  static constexpr std::array<double, 8> kronrod = {
      0.022935322010529224963732008058970, 0.063092092629978553290700663189204, 0.104790010322250183839876322541518,
      0.140653259715525918745189590510238, 0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
      0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
  static constexpr std::array<double, 4> gauss = {
      0.129484966168869693270611432679082, 0.279705391489276667901467771423780, 0.381830050505118944950369775488975,
      0.417959183673469387755102040816327};
  const double centre = 0.5 * (low + high), half = 0.5 * (high - low);
  Value fine{}, coarse{};
  double size = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    for (int side = 0; side < (i == 7 ? 1 : 2); ++side) {
      const Value v = f(side == 0 ? centre - half * node[i] : centre + half * node[i]);
      add_scaled(fine, half * kronrod[i], v);
      if (i % 2 == 1) add_scaled(coarse, half * gauss[i / 2], v);
      size += std::abs(half) * kronrod[i] * largest_size(v);
    }
  }
  // |K - G| is the error of the 7-point rule; QUADPACK's scaling gives that of the 15-point one, down to rounding.
  const double difference = largest_difference(fine, coarse);
  double error = difference;
  if (size > 0 && difference > 0) error = size * std::min(1.0, std::pow(200 * difference / size, 1.5));
  error = std::max(error, 4 * std::numeric_limits<double>::epsilon() * size);
  if (!std::isfinite(difference)) error = std::numeric_limits<double>::infinity();
  return {low, high, error, size, fine};
}

}  // namespace quadrature_detail

/// Integral of f over [a, b]. f takes a double and returns double or std::array<double, size>. Ends finite; a > b gives
/// the negative. Ends after a bounded number of evaluations whatever f is; ask `converged` whether the tolerance is
/// met.
template <class F>
auto integrate(F&& f, double a, double b, const QuadratureOptions& options) {
  using Value = std::decay_t<decltype(f(a))>;
  namespace detail = quadrature_detail;
  Integral<Value> result;
  if (a == b) {
    result.converged = true;
    return result;
  }
  if (!std::isfinite(a) || !std::isfinite(b)) {
    result.error = std::numeric_limits<double>::infinity();
    return result;
  }
  const auto by_error = [](const auto& x, const auto& y) { return x.error < y.error; };
  std::vector<detail::Interval<Value>> heap{detail::gauss_kronrod<Value>(f, a, b)};
  result.evaluations = 15;
  double error = heap[0].error, size = heap[0].size;
  const auto tolerance = [&] {
    // Rounding noise alone sums to a few ulps of the size; nothing smaller can be asked for.
    return std::max({options.absolute, options.relative * size, 8 * std::numeric_limits<double>::epsilon() * size});
  };
  while (std::isfinite(size) && !(error <= tolerance()) &&
         heap.size() < static_cast<std::size_t>(options.max_intervals)) {
    std::pop_heap(heap.begin(), heap.end(), by_error);
    const auto worst = heap.back();
    const double middle = 0.5 * (worst.low + worst.high);
    if (middle == worst.low || middle == worst.high) {
      std::push_heap(heap.begin(), heap.end(), by_error);
      break;
    }
    heap.back() = detail::gauss_kronrod<Value>(f, worst.low, middle);
    std::push_heap(heap.begin(), heap.end(), by_error);
    heap.push_back(detail::gauss_kronrod<Value>(f, middle, worst.high));
    std::push_heap(heap.begin(), heap.end(), by_error);
    result.evaluations += 30;
    error = size = 0;
    for (const auto& i : heap) {
      error += i.error;
      size += i.size;
    }
  }
  std::sort(heap.begin(), heap.end(),
            [](const auto& x, const auto& y) { return std::abs(x.error) < std::abs(y.error); });
  for (const auto& i : heap) detail::add_scaled(result.value, 1.0, i.value);
  result.error = error;
  result.converged = std::isfinite(size) && error <= tolerance();
  return result;
}

/// The same with one tolerance, relative to the integral of |f|.
template <class F>
auto integrate(F&& f, double a, double b, double relative = 1e-12) {
  return integrate(f, a, b, QuadratureOptions{.relative = relative});
}

}  // namespace aresta
