// SPDX-License-Identifier: Apache-2.0
#include "construct/spline.h"

#include <algorithm>

namespace aresta {

namespace {

/// Derivative at x[0] of the polynomial through the first points (at most four): Newton's divided differences.
Vec3 end_derivative(const std::vector<double>& x, const std::vector<Vec3>& y) {
  const std::size_t n = std::min<std::size_t>(4, x.size());
  std::vector<Vec3> d(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n));
  Vec3 sum{};
  double product = 1;
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t i = n - 1; i >= k; --i) d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - k]);
    sum += product * d[k];
    product *= x[0] - x[k];
  }
  return sum;
}

/// Solves a tridiagonal, diagonally dominant system in place.
void solve_tridiagonal(std::vector<double> low, std::vector<double> mid, std::vector<double> high,
                       std::vector<Vec3>& right) {
  const std::size_t n = mid.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double w = low[i] / mid[i - 1];
    mid[i] -= w * high[i - 1];
    right[i] -= w * right[i - 1];
  }
  right[n - 1] = right[n - 1] / mid[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) right[i] = (right[i] - high[i] * right[i + 1]) / mid[i];
}

/// Derivatives at the knots of the open spline.
std::vector<Vec3> open_derivatives(const std::vector<double>& t, const std::vector<Vec3>& p) {
  const std::size_t n = t.size();
  if (n == 2) return std::vector<Vec3>(2, (p[1] - p[0]) / (t[1] - t[0]));
  std::vector<double> low(n, 0), mid(n, 1), high(n, 0);
  std::vector<Vec3> m(n);
  m[0] = end_derivative(t, p);
  m[n - 1] = end_derivative({t.rbegin(), t.rend()}, {p.rbegin(), p.rend()});
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double h = t[i] - t[i - 1], k = t[i + 1] - t[i];
    low[i] = k;
    mid[i] = 2 * (h + k);
    high[i] = h;
    m[i] = 3 * (k / h * (p[i] - p[i - 1]) + h / k * (p[i + 1] - p[i]));
  }
  solve_tridiagonal(low, mid, high, m);
  return m;
}

/// Derivatives of the closed spline: p.back() == p.front(). Sherman-Morrison for the two corners of the cyclic system.
std::vector<Vec3> closed_derivatives(const std::vector<double>& t, const std::vector<Vec3>& p) {
  const std::size_t n = t.size() - 1;  // unknowns 0 .. n - 1
  std::vector<double> low(n), mid(n), high(n);
  std::vector<Vec3> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = i == 0 ? n - 1 : i - 1;
    const double h = t[before + 1] - t[before], k = t[i + 1] - t[i];
    low[i] = k;
    mid[i] = 2 * (h + k);
    high[i] = h;
    right[i] = 3 * (k / h * (p[i] - p[before]) + h / k * (p[i + 1] - p[i]));
  }
  const double corner_high = low[0], corner_low = high[n - 1];  // A[0][n-1], A[n-1][0]
  const double gamma = -mid[0];
  std::vector<double> mid2 = mid;
  mid2[0] -= gamma;
  mid2[n - 1] -= corner_low * corner_high / gamma;
  std::vector<Vec3> u(n);
  u[0] = {gamma, 0, 0};
  u[n - 1] = {corner_low, 0, 0};
  solve_tridiagonal(low, mid2, high, right);
  solve_tridiagonal(low, mid2, high, u);
  const double v = corner_high / gamma;  // the second vector is (1, 0, ..., 0, v)
  const Vec3 fraction = (right[0] + v * right[n - 1]) / (1 + u[0].x + v * u[n - 1].x);
  std::vector<Vec3> m(n + 1);
  for (std::size_t i = 0; i < n; ++i) m[i] = right[i] - u[i].x * fraction;
  m[n] = m[0];
  return m;
}

struct Bezier {
  double low, high;
  std::array<Vec3, 4> poles;

  /// The polar form at three parameters.
  Vec3 blossom(double a, double b, double c) const {
    const auto blend = [&](Vec3 p, Vec3 q, double x) { return lerp(p, q, (x - low) / (high - low)); };
    const Vec3 p0 = blend(poles[0], poles[1], a), p1 = blend(poles[1], poles[2], a), p2 = blend(poles[2], poles[3], a);
    return blend(blend(p0, p1, b), blend(p1, p2, b), c);
  }
};

}  // namespace

NurbsCurveData interpolating_spline(std::span<const Vec3> points, bool closed) {
  std::vector<Vec3> p(points.begin(), points.end());
  if (closed) p.push_back(p.front());
  std::vector<double> t{0};
  for (std::size_t i = 1; i < p.size(); ++i) t.push_back(t.back() + distance(p[i - 1], p[i]));
  const std::vector<Vec3> m = closed ? closed_derivatives(t, p) : open_derivatives(t, p);
  std::vector<Bezier> pieces;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const double third = (t[i + 1] - t[i]) / 3;
    pieces.push_back({t[i], t[i + 1], {p[i], p[i] + third * m[i], p[i + 1] - third * m[i + 1], p[i + 1]}});
  }
  NurbsCurveData data;
  data.degree = 3;
  data.knots = t;
  data.multiplicities.assign(t.size(), 1);
  data.multiplicities.front() = data.multiplicities.back() = 4;
  std::vector<double> flat(3, t.front());
  flat.insert(flat.end(), t.begin(), t.end());
  flat.insert(flat.end(), 3, t.back());
  // Pole j is the blossom at flat[j + 1 .. j + 3], taken of a piece between these knots.
  for (std::size_t j = 0; j + 4 < flat.size(); ++j) {
    const std::size_t piece = std::clamp<std::size_t>(j < 2 ? 0 : j - 2, 0, pieces.size() - 1);
    data.poles.push_back(pieces[piece].blossom(flat[j + 1], flat[j + 2], flat[j + 3]));
  }
  return data;
}

}  // namespace aresta
