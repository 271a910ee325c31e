// SPDX-License-Identifier: Apache-2.0
// Small dense systems of fixed size: linear solve, symmetric eigenvectors, least squares.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace aresta {

template <std::size_t n>
using Row = std::array<double, n>;
template <std::size_t n>
using Matrix = std::array<Row<n>, n>;

/// x with m x = b, by elimination with full row pivoting; nothing when m is singular to rounding.
template <std::size_t n>
std::optional<Row<n>> solve(Matrix<n> m, Row<n> b) {
  double largest = 0;
  for (const Row<n>& row : m) {
    for (const double x : row) largest = std::max(largest, std::abs(x));
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    if (!(std::abs(m[pivot][k]) > 1e-15 * largest)) return std::nullopt;
    std::swap(m[k], m[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double f = m[i][k] / m[k][k];
      for (std::size_t j = k; j < n; ++j) m[i][j] -= f * m[k][j];
      b[i] -= f * b[k];
    }
  }
  Row<n> x{};
  for (std::size_t k = n; k-- > 0;) {
    double sum = b[k];
    for (std::size_t j = k + 1; j < n; ++j) sum -= m[k][j] * x[j];
    x[k] = sum / m[k][k];
  }
  return x;
}

template <std::size_t n>
struct EigenSystem {
  Row<n> values{};      ///< growing
  Matrix<n> vectors{};  ///< vectors[k] is the unit vector of values[k]; its largest component is positive
};

/// Eigenvectors of a symmetric matrix by cyclic Jacobi rotations: orthonormal to rounding, equal values included.
template <std::size_t n>
EigenSystem<n> symmetric_eigen(Matrix<n> a) {
  Matrix<n> v{};
  for (std::size_t i = 0; i < n; ++i) v[i][i] = 1;
  for (int sweep = 0; sweep < 60; ++sweep) {
    double off = 0, all = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) (i == j ? all : off) += a[i][j] * a[i][j];
    }
    if (!(off > 1e-36 * (all + off))) break;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1 / std::hypot(t, 1.0), s = t * c;
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = v[p][k], y = v[q][k];
          v[p][k] = c * x - s * y;
          v[q][k] = s * x + c * y;
        }
      }
    }
  }
  std::array<std::size_t, n> order{};
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (a[order[j]][order[j]] < a[order[i]][order[i]]) std::swap(order[i], order[j]);
    }
  }
  EigenSystem<n> result;
  for (std::size_t k = 0; k < n; ++k) {
    result.values[k] = a[order[k]][order[k]];
    result.vectors[k] = v[order[k]];
    double largest = 0;
    for (const double x : result.vectors[k]) {
      if (std::abs(x) > std::abs(largest) * (1 + 1e-12)) largest = x;
    }
    if (largest < 0) {
      for (double& x : result.vectors[k]) x = -x;
    }
  }
  return result;
}

/// Least squares of residual(x, i), i < count, from x, by damped Gauss-Newton with differences for derivatives (`step`
/// is their width). Returns the best x seen; x itself when nothing is better.
template <std::size_t n, class Residual>
Row<n> least_squares(Row<n> x, std::size_t count, Residual&& residual, double step = 1e-6, int iterations = 30) {
  const auto cost = [&](const Row<n>& at) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double r = residual(at, i);
      sum += r * r;
    }
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  };
  double best = cost(x), damping = 1e-9;
  for (int iteration = 0; iteration < iterations && best > 0; ++iteration) {
    Matrix<n> normal{};
    Row<n> right{};
    for (std::size_t i = 0; i < count; ++i) {
      const double r = residual(x, i);
      Row<n> gradient{};
      for (std::size_t k = 0; k < n; ++k) {
        Row<n> more = x, less = x;
        more[k] += step;
        less[k] -= step;
        gradient[k] = (residual(more, i) - residual(less, i)) / (2 * step);
      }
      for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t l = 0; l < n; ++l) normal[k][l] += gradient[k] * gradient[l];
        right[k] -= gradient[k] * r;
      }
    }
    bool better = false;
    for (int attempt = 0; attempt < 8; ++attempt) {
      Matrix<n> damped = normal;
      for (std::size_t k = 0; k < n; ++k) damped[k][k] *= 1 + damping;
      const auto move = solve<n>(damped, right);
      if (move) {
        Row<n> next = x;
        for (std::size_t k = 0; k < n; ++k) next[k] += (*move)[k];
        const double c = cost(next);
        if (c < best) {
          better = c < best * (1 - 1e-6);
          best = c;
          x = next;
          damping = std::max(damping * 0.1, 1e-12);
          break;
        }
      }
      damping = std::max(damping * 30, 1e-9);
    }
    if (!better) break;
  }
  return x;
}

}  // namespace aresta
