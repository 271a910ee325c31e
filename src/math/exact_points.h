// SPDX-License-Identifier: Apache-2.0
// Planes through points of a lattice, the side of a plane on which a point lies, and the points where lines and planes
// meet: decisions that are never wrong, points with a proven error.
//
// Guarantees. side() and compare_along_line() return the sign of the exact value. line_plane_point() and
// three_plane_point() return a point each of whose coordinates is within `precision` of the exact one or is the double
// nearest to it (ties to even), and std::nullopt if and only if there is not exactly one such point. Results depend on
// the arguments alone: plain double arithmetic without contraction, and integers; no state.
// Not guaranteed: a computed point lies on no lattice; side() of a point rounded to one is that of the rounded point.
//
// Laws, held for values and stages alike:
//   side(flipped(p), x) = -side(p, x)
//   compare_along_line(a, b, p, q) = -compare_along_line(a, b, q, p) = -compare_along_line(b, a, p, q), and flips of
//     planes change nothing
//   line_plane_point is the same, to the bit, for (a, b) and (b, a) and for a flipped plane
//   three_plane_point is the same, to the bit, for all orders of the planes and for flipped planes
// Signs, but not stages, are also the same for each point and multiple of the normal that describe the same plane.
//
// Preconditions: coordinates within Lattice::range, asserted where planes are made, not in the functions that decide.
//
// Stages. A double evaluation comes first, with a bound of its error; what the bound leaves open is decided by integers
// of a fixed width. Stages counts, in the caller's variable, which of the two it was.
//
// Error bounds of the filter. u = 2^-53. All quantities are integers below 2^421 or sums, products and quotients of
// them, so nothing overflows or underflows, and each operation has a relative error of at most u. Let v be a sum of
// products, S the same sum of the products' absolute values, both exact, and let v', S' be the doubles computed for
// them, with at most k roundings on the way of each product (the rounding of leaves to doubles included). Then
//   |v' - v| <= ((1 + u)^k - 1) S  and  S' >= (1 - u)^k S,  hence  |v' - v| < (k + 1) u S'  for k <= 100,
// with room for the roundings of that bound itself. S' = 0 only if all products are zero: then v' = v = 0 is proven.
//
// Widths of the integers. What is in a row is below the power of two in absolute value, so one bit more holds the sign.
//   coordinate                      2^51     (at most)         int64
//   difference of points            2^52     (at most)         int64
//   normal of three points          2^105    two products      Int128
//   normal of a polygon             2^121    2^16 of these     Int128
//   n . (p - o), n . (b - a)        2^175    3 * 2^173         192 bits
//   meeting of line and plane       2^228    numerator         256 bits, denominator 192
//   products that compare meetings  2^350    2^175 * 2^175     384 bits
//   cross product of normals        2^243    at most           256 bits
//   determinant of three normals    2^366    3 * 2^121 * 2^243 384 bits
//   meeting of three planes         2^420    numerator         448 bits, denominator 384
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "math/lattice.h"
#include "math/vec.h"
#include "math/wide_int.h"

namespace aresta {

/// How many decisions each stage took.
struct Stages {
  std::uint64_t by_name = 0;  // known from identities, without numbers: counted by callers
  std::uint64_t filter = 0;   // doubles with an error bound
  std::uint64_t exact = 0;    // integers
};

/// A plane through a point of the lattice, with its sides told apart: the normal is never zero.
class ExactPlane {
 public:
  static constexpr Int128 normal_range = Int128{1} << 121;

  /// The normal is not zero and each component within normal_range.
  ExactPlane(const std::array<Int128, 3>& normal, const LatticePoint& origin);

  /// In squared steps; exact.
  const std::array<Int128, 3>& normal() const { return normal_; }
  /// A point of the plane.
  const LatticePoint& origin() const { return origin_; }
  /// The normal, each component the nearest double.
  Vec3 rounded_normal() const { return rounded_normal_; }

 private:
  std::array<Int128, 3> normal_;
  LatticePoint origin_;
  Vec3 rounded_normal_;
};

/// The plane through three points, seen counterclockwise from its positive side; std::nullopt when they lie on a line.
std::optional<ExactPlane> plane_through(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

/// The plane through the first vertex of a polygon of at most 2^16 vertices, at right angles to its vector area (half
/// the normal, by Newell's sum, which is the same whichever vertex is first). std::nullopt when that is zero. The
/// vertices need not lie in one plane.
std::optional<ExactPlane> plane_of_polygon(std::span<const LatticePoint> vertices);

/// The same points, the sides exchanged.
ExactPlane flipped(const ExactPlane& plane);

/// Each component has a relative error of at most 6 u, however thin the triangle was that made the plane.
Vec3 unit_normal(const ExactPlane& plane);

/// 1 when the normal points to the side on which p lies, -1 on the other side, 0 in the plane and only there.
int side(const ExactPlane& plane, const LatticePoint& p, Stages& stages);

/// In which order a traveller from a through b, coming from infinitely far, meets two planes: -1 when p is first, 1
/// when q is, 0 when they are met in the same point; std::nullopt when a = b or a plane is parallel to the line.
std::optional<int> compare_along_line(const LatticePoint& a, const LatticePoint& b, const ExactPlane& p,
                                      const ExactPlane& q, Stages& stages);

/// Where the line through a and b meets the plane, in the document's units, as is `precision` (0 or more);
/// std::nullopt when a = b or the line is parallel to the plane.
std::optional<Vec3> line_plane_point(const LatticePoint& a, const LatticePoint& b, const ExactPlane& plane,
                                     const Lattice& lattice, double precision, Stages& stages);

/// Where three planes meet, in the document's units, as is `precision` (0 or more); std::nullopt when they have no
/// point or more than one in common.
std::optional<Vec3> three_plane_point(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r,
                                      const Lattice& lattice, double precision, Stages& stages);

}  // namespace aresta
