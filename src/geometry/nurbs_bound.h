// SPDX-License-Identifier: Apache-2.0
// Proven bounds of polynomial functions over NURBS: the Chebyshev sampling behind recognition.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/free_form.h"
#include "math/vec.h"

namespace aresta {

/// One span of one direction: its parameters and the poles that act on it (first to last, both included).
struct NurbsSpan {
  double low, high;
  std::size_t first, last;
};

/// The spans of a form that is not periodic.
inline std::vector<NurbsSpan> nurbs_spans(int degree, const std::vector<double>& knots,
                                          const std::vector<int>& multiplicities, std::size_t poles) {
  std::vector<NurbsSpan> spans;
  std::size_t sum = 0;
  const auto p = static_cast<std::size_t>(degree);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    sum += static_cast<std::size_t>(multiplicities[i]);
    if (sum < p + 1 || sum > poles) continue;  // outside the domain of an unclamped form
    spans.push_back({knots[i], knots[i + 1], sum - 1 - p, sum - 1});
  }
  return spans;
}

/// How much larger a polynomial of degree d can be than at these points: 1 / cos(pi d / 2 N) for N + 1 of them.
struct ChebyshevPoints {
  int n;
  double factor;
  explicit ChebyshevPoints(int degree) : n(2 * degree), factor(1 / std::cos(std::numbers::pi * degree / (2.0 * n))) {}
  double at(double low, double high, int j) const {
    return 0.5 * (low + high) + 0.5 * (high - low) * std::cos(std::numbers::pi * j / n);
  }
};

/// Largest |f| over the curve is at most the answer, where f(p) is a polynomial of degree k in the point's coordinates.
template <class Point, class F>
double bound_over(const NurbsCurveData& d, int k, Point&& point, F&& f) {
  const ChebyshevPoints nodes(k * d.degree);
  double bound = 0;
  for (const NurbsSpan& s : nurbs_spans(d.degree, d.knots, d.multiplicities, d.poles.size())) {
    double least = 1, most = 1;
    if (!d.weights.empty()) {
      least = most = d.weights[s.first];
      for (std::size_t i = s.first; i <= s.last; ++i) {
        least = std::min(least, d.weights[i]);
        most = std::max(most, d.weights[i]);
      }
    }
    double seen = 0;
    for (int j = 0; j <= nodes.n; ++j) seen = std::max(seen, std::abs(f(point(nodes.at(s.low, s.high, j)))));
    bound = std::max(bound, seen * nodes.factor * std::pow(most / least, k));
  }
  return bound;
}

/// The same over a surface, piece by piece of its spans. `height` is some linear function of the point;
/// `accept(bound, low, high)` gets a bound of |f| and one of the heights over the piece. Where it answers false the
/// piece is split in four, as long as at most `budget` points are evaluated in all. True when every piece was accepted.
template <class Point, class F, class Height, class Accept>
bool bound_over(const NurbsSurfaceData& d, int k, long budget, Point&& point, F&& f, Height&& height, Accept&& accept) {
  const ChebyshevPoints nu(k * d.degree_u), nv(k * d.degree_v);
  // Heights are of degree one in the point: many more samples than degrees.
  const double linear = 1 / (std::cos(std::numbers::pi * d.degree_u / (2.0 * nu.n)) *
                             std::cos(std::numbers::pi * d.degree_v / (2.0 * nv.n)));
  const auto us = nurbs_spans(d.degree_u, d.knots_u, d.multiplicities_u, d.count_u);
  const auto vs = nurbs_spans(d.degree_v, d.knots_v, d.multiplicities_v, d.count_v);
  const double each = static_cast<double>(nu.n + 1) * (nv.n + 1);
  double left = static_cast<double>(budget) - static_cast<double>(us.size() * vs.size()) * each;
  if (left < 0) return false;
  struct Cell {
    double u0, u1, v0, v1;
  };
  std::vector<double> heights;
  for (const NurbsSpan& a : us) {
    for (const NurbsSpan& b : vs) {
      double least = 1, most = 1;
      if (!d.weights.empty()) {
        least = most = d.weights[a.first * d.count_v + b.first];
        for (std::size_t i = a.first; i <= a.last; ++i) {
          for (std::size_t j = b.first; j <= b.last; ++j) {
            least = std::min(least, d.weights[i * d.count_v + j]);
            most = std::max(most, d.weights[i * d.count_v + j]);
          }
        }
      }
      std::vector<Cell> todo{{a.low, a.high, b.low, b.high}};
      while (!todo.empty()) {
        const Cell c = todo.back();
        todo.pop_back();
        double seen = 0;
        heights.clear();
        for (int i = 0; i <= nu.n; ++i) {
          for (int j = 0; j <= nv.n; ++j) {
            const Vec3 p = point({nu.at(c.u0, c.u1, i), nv.at(c.v0, c.v1, j)});
            seen = std::max(seen, std::abs(f(p)));
            heights.push_back(height(p));
          }
        }
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        const double middle = 0.5 * (*low + *high), reach = 0.5 * (*high - *low) * linear * most / least;
        const double bound = seen * nu.factor * nv.factor * std::pow(most / least, k);
        if (accept(bound, middle - reach, middle + reach)) continue;
        left -= 4 * each;
        const double um = 0.5 * (c.u0 + c.u1), vm = 0.5 * (c.v0 + c.v1);
        if (left < 0 || um <= c.u0 || um >= c.u1 || vm <= c.v0 || vm >= c.v1 || !std::isfinite(seen)) return false;
        todo.insert(todo.end(),
                    {{c.u0, um, c.v0, vm}, {um, c.u1, c.v0, vm}, {c.u0, um, vm, c.v1}, {um, c.u1, vm, c.v1}});
      }
    }
  }
  return true;
}

}  // namespace aresta
