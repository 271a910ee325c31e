// SPDX-License-Identifier: Apache-2.0
#include "math/exact_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace aresta {

namespace {

constexpr double u = 0x1p-53;

// ---- doubles ------------------------------------------------------------------------------------------------------

/// A sum of products, and the same sum of the absolute values of the products.
struct Sized {
  double value = 0, size = 0;
};

Sized leaf(double x) {
  return {x, std::abs(x)};
}
Sized operator*(Sized a, Sized b) {
  return {a.value * b.value, a.size * b.size};
}
Sized operator+(Sized a, Sized b) {
  return {a.value + b.value, a.size + b.size};
}
Sized operator-(Sized a, Sized b) {
  return {a.value - b.value, a.size + b.size};
}

using SizedVector = std::array<Sized, 3>;

SizedVector leaves(Vec3 a) {
  return {leaf(a.x), leaf(a.y), leaf(a.z)};
}
Sized dot(const SizedVector& a, const SizedVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
SizedVector cross(const SizedVector& a, const SizedVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A double, and how far it may be from the exact value; an error of 0 is a proof.
struct Estimate {
  double value = 0, error = 0;
  bool sign_is_known() const { return std::abs(value) > error || error == 0; }
  int sign() const { return (value > 0) - (value < 0); }
};

/// `roundings` is k of the contract.
Estimate estimate(Sized a, int roundings) {
  return {a.value, (roundings + 1) * u * a.size};
}

/// Makes up for the roundings in a bound that is computed by less than a hundred operations on non-negative doubles.
constexpr double slack = 1 + 0x1p-40;

/// base + factor * numerator / denominator, where base and factor are exact and the denominator's sign is known and
/// not 0. Let n = n' + dn and d = d' + dd be the exact numerator and denominator. Then
///   n' / d' - n / d = (n' / d' * dd - dn) / d  and  |d| >= |d'| - error of d,
/// to which come the roundings of the quotient, of the product and of the sum.
Estimate meeting(double base, double factor, Estimate numerator, Estimate denominator) {
  const double ratio = numerator.value / denominator.value;
  const double at_least = std::abs(denominator.value) - denominator.error;
  const double ratio_error = (numerator.error + std::abs(ratio) * denominator.error) / at_least + u * std::abs(ratio);
  const double offset = factor * ratio;
  const double value = base + offset;
  return {value, slack * (std::abs(factor) * ratio_error + u * (std::abs(offset) + std::abs(value)))};
}

Vec3 to_vec(const LatticePoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

LatticePoint difference(const LatticePoint& a, const LatticePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// normal . direction; four roundings, of the normal, of the product and of two sums: differences of points are exact.
Estimate estimate_along(const ExactPlane& plane, const LatticePoint& direction) {
  return estimate(dot(leaves(plane.rounded_normal()), leaves(to_vec(direction))), 4);
}

/// The point, if each coordinate is as precise as asked for.
std::optional<Vec3> if_precise(const std::array<Estimate, 3>& point, const Lattice& lattice, double precision) {
  const double allowed = lattice.in_steps(precision);
  for (const Estimate& x : point) {
    if (!(x.error <= allowed)) return std::nullopt;
  }
  return lattice.step() * Vec3{point[0].value, point[1].value, point[2].value};
}

// ---- integers -----------------------------------------------------------------------------------------------------

std::array<Int128, 3> cross(const LatticePoint& a, const LatticePoint& b) {
  const auto minor = [&](int i, int j) { return static_cast<Int128>(a[i]) * b[j] - static_cast<Int128>(a[j]) * b[i]; };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

std::array<WideInt<256>, 3> cross(const std::array<Int128, 3>& a, const std::array<Int128, 3>& b) {
  const auto minor = [&](int i, int j) {
    return multiply(WideInt<128>(a[i]), WideInt<128>(b[j])) - multiply(WideInt<128>(a[j]), WideInt<128>(b[i]));
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// normal . direction
WideInt<192> along(const ExactPlane& plane, const LatticePoint& direction) {
  const std::array<Int128, 3>& n = plane.normal();
  const auto term = [&](int i) { return multiply(WideInt<128>(n[i]), WideInt<64>(direction[i])); };
  return term(0) + term(1) + term(2);
}

// ---- order --------------------------------------------------------------------------------------------------------

bool is_zero(const std::array<Int128, 3>& normal) {
  return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

std::array<Int128, 3> negated(const std::array<Int128, 3>& n) {
  return {-n[0], -n[1], -n[2]};
}

/// The normal or its opposite, whichever has its first component that is not zero above zero.
std::array<Int128, 3> without_sense(const std::array<Int128, 3>& normal) {
  return normal < std::array<Int128, 3>{} ? negated(normal) : normal;
}

/// An order of planes in which flipped planes are equal.
bool comes_before(const ExactPlane& p, const ExactPlane& q) {
  if (p.origin() != q.origin()) return p.origin() < q.origin();
  return without_sense(p.normal()) < without_sense(q.normal());
}

std::optional<Vec3> three_plane_point_by_filter(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r,
                                                const Lattice& lattice, double precision, bool& singular) {
  // Cramer's rule with p's origin as the origin, so that p's constant is 0 and the others are of the size of the
  // planes' distances.
  const SizedVector np = leaves(p.rounded_normal()), nq = leaves(q.rounded_normal()), nr = leaves(r.rounded_normal());
  const SizedVector qr = cross(nq, nr), rp = cross(nr, np), pq = cross(np, nq);
  // Roundings on the way of a product: a cross product has 4 (two normals, product, sum), a determinant 4 more (normal,
  // product, two sums), a constant 4, a numerator 4 + 4 + 2.
  const Estimate denominator = estimate(dot(np, qr), 8);
  if (!denominator.sign_is_known()) return std::nullopt;
  singular = denominator.value == 0;
  if (singular) return std::nullopt;
  const Sized q_constant = dot(nq, leaves(to_vec(difference(q.origin(), p.origin()))));
  const Sized r_constant = dot(nr, leaves(to_vec(difference(r.origin(), p.origin()))));
  const Vec3 base = to_vec(p.origin());
  std::array<Estimate, 3> point;
  for (int i = 0; i < 3; ++i) {
    const Estimate numerator = estimate(q_constant * rp[i] + r_constant * pq[i], 10);
    point[i] = meeting(base[i], 1, numerator, denominator);
  }
  return if_precise(point, lattice, precision);
}

std::optional<Vec3> three_plane_point_exactly(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r,
                                              const Lattice& lattice) {
  const auto qr = cross(q.normal(), r.normal());
  const auto determinant_term = [&](int i) { return multiply(WideInt<128>(p.normal()[i]), qr[i]); };
  const WideInt<384> denominator = determinant_term(0) + determinant_term(1) + determinant_term(2);
  if (denominator.sign() == 0) return std::nullopt;
  const auto rp = cross(r.normal(), p.normal()), pq = cross(p.normal(), q.normal());
  const WideInt<192> q_constant = along(q, difference(q.origin(), p.origin()));
  const WideInt<192> r_constant = along(r, difference(r.origin(), p.origin()));
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    const WideInt<448> numerator =
        multiply(WideInt<64>(p.origin()[i]), denominator) + multiply(q_constant, rp[i]) + multiply(r_constant, pq[i]);
    point[i] = ratio_to_double(numerator, denominator);
  }
  return lattice.step() * point;
}

}  // namespace

ExactPlane::ExactPlane(const std::array<Int128, 3>& normal, const LatticePoint& origin)
    : normal_(normal), origin_(origin) {
  assert(!is_zero(normal) && in_lattice_range(origin));
  for (int i = 0; i < 3; ++i) {
    assert(-normal_range <= normal[i] && normal[i] <= normal_range);
    rounded_normal_[i] = WideInt<128>(normal[i]).to_double();
  }
}

std::optional<ExactPlane> plane_through(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return plane_of_polygon(std::array{a, b, c});
}

std::optional<ExactPlane> plane_of_polygon(std::span<const LatticePoint> vertices) {
  assert(vertices.size() <= std::size_t{1} << 16);
  assert(std::all_of(vertices.begin(), vertices.end(), in_lattice_range));
  std::array<Int128, 3> normal{};
  for (std::size_t i = 2; i < vertices.size(); ++i) {
    const auto triangle = cross(difference(vertices[i - 1], vertices[0]), difference(vertices[i], vertices[0]));
    for (int k = 0; k < 3; ++k) normal[k] += triangle[k];
  }
  if (is_zero(normal)) return std::nullopt;
  return ExactPlane(normal, vertices[0]);
}

ExactPlane flipped(const ExactPlane& plane) {
  return {negated(plane.normal()), plane.origin()};
}

Vec3 unit_normal(const ExactPlane& plane) {
  // Squares are below 2^243: neither overflow nor, as integers, underflow. Their sum has a relative error of at most
  // 5 u (normals twice, product, two sums), the length one of 3.5 u, the quotient one of 5.5 u, to first order.
  const Vec3 n = plane.rounded_normal();
  return n / norm(n);
}

int side(const ExactPlane& plane, const LatticePoint& p, Stages& stages) {
  const LatticePoint offset = difference(p, plane.origin());
  const Estimate distance = estimate_along(plane, offset);
  if (distance.sign_is_known()) {
    ++stages.filter;
    return distance.sign();
  }
  ++stages.exact;
  return along(plane, offset).sign();
}

std::optional<int> compare_along_line(const LatticePoint& a, const LatticePoint& b, const ExactPlane& p,
                                      const ExactPlane& q, Stages& stages) {
  if (b < a) {
    const std::optional<int> backwards = compare_along_line(b, a, p, q, stages);
    return backwards ? std::optional(-*backwards) : std::nullopt;
  }
  // A plane is met at a + t (b - a) with t = n . (o - a) / n . (b - a).
  const LatticePoint direction = difference(b, a);
  const LatticePoint to_p = difference(p.origin(), a), to_q = difference(q.origin(), a);
  const SizedVector np = leaves(p.rounded_normal()), nq = leaves(q.rounded_normal());
  const SizedVector d = leaves(to_vec(direction));
  const Sized p_slope = dot(np, d), q_slope = dot(nq, d);
  const Estimate p_run = estimate(p_slope, 4), q_run = estimate(q_slope, 4);
  if (p_run.sign_is_known() && q_run.sign_is_known()) {
    const int sense = p_run.sign() * q_run.sign();
    const Sized difference_of_products =
        dot(np, leaves(to_vec(to_p))) * q_slope - dot(nq, leaves(to_vec(to_q))) * p_slope;
    const Estimate order = estimate(difference_of_products, 10);
    if (sense == 0 || order.sign_is_known()) {
      ++stages.filter;
      return sense == 0 ? std::nullopt : std::optional(sense * order.sign());
    }
  }
  ++stages.exact;
  const WideInt<192> exact_p_run = along(p, direction), exact_q_run = along(q, direction);
  const int sense = exact_p_run.sign() * exact_q_run.sign();
  if (sense == 0) return std::nullopt;
  return sense * (multiply(along(p, to_p), exact_q_run) - multiply(along(q, to_q), exact_p_run)).sign();
}

std::optional<Vec3> line_plane_point(const LatticePoint& a, const LatticePoint& b, const ExactPlane& plane,
                                     const Lattice& lattice, double precision, Stages& stages) {
  if (b < a) return line_plane_point(b, a, plane, lattice, precision, stages);
  // The point is a + (b - a) rise / run.
  const LatticePoint direction = difference(b, a), to_plane = difference(plane.origin(), a);
  const Estimate run = estimate_along(plane, direction);
  if (run.sign_is_known()) {
    if (run.value == 0) {
      ++stages.filter;
      return std::nullopt;
    }
    const Estimate rise = estimate_along(plane, to_plane);
    const Vec3 base = to_vec(a), factor = to_vec(direction);
    std::array<Estimate, 3> point;
    for (int i = 0; i < 3; ++i) point[i] = meeting(base[i], factor[i], rise, run);
    if (const auto precise = if_precise(point, lattice, precision)) {
      ++stages.filter;
      return precise;
    }
  }
  ++stages.exact;
  const WideInt<192> exact_run = along(plane, direction);
  if (exact_run.sign() == 0) return std::nullopt;
  const WideInt<192> exact_rise = along(plane, to_plane);
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    const WideInt<256> numerator =
        multiply(WideInt<64>(a[i]), exact_run) + multiply(WideInt<64>(direction[i]), exact_rise);
    point[i] = ratio_to_double(numerator, exact_run);
  }
  return lattice.step() * point;
}

std::optional<Vec3> three_plane_point(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r,
                                      const Lattice& lattice, double precision, Stages& stages) {
  // Always in the same order, for the sake of the laws.
  std::array<const ExactPlane*, 3> plane{&p, &q, &r};
  const auto sort_two = [&](int i, int j) {
    if (comes_before(*plane[j], *plane[i])) std::swap(plane[i], plane[j]);
  };
  sort_two(0, 1);
  sort_two(1, 2);
  sort_two(0, 1);
  bool singular = false;
  const auto by_filter = three_plane_point_by_filter(*plane[0], *plane[1], *plane[2], lattice, precision, singular);
  if (by_filter || singular) {
    ++stages.filter;
    return by_filter;
  }
  ++stages.exact;
  return three_plane_point_exactly(*plane[0], *plane[1], *plane[2], lattice);
}

}  // namespace aresta
