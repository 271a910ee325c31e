// SPDX-License-Identifier: Apache-2.0
// Where a straight line meets the analytic surfaces.
//
// Contract: every meeting is found; a touch (the line comes within a few ulps of the model's size of the surface and
// does not cross it) is listed once; parameters grow. Lines that lie in the surface (in the plane, along a ruling) have
// no isolated meetings and give none. The line's parameter is first moved to the point nearest the surface's centre, so
// that a far origin costs ulps of its distance and not of its square.
#include <algorithm>
#include <array>

#include "geometry/analytic.h"
#include "math/roots.h"

namespace aresta::analytic {

namespace {

/// The line in the surface's axes, its parameter counted from `shift`.
struct LocalLine {
  Vec3 origin, direction;
  double shift;  ///< t on the given line = t here + shift
  double noise;  ///< rounding error of `origin`, a length
};

LocalLine localize(const Frame& f, const Line& line) {
  const Vec3 from = line.origin - f.origin;
  const double shift = -dot(from, line.direction);
  const Vec3 near = from + shift * line.direction;
  const auto local = [&](Vec3 v) { return Vec3{dot(v, f.x), dot(v, f.y), dot(v, f.z)}; };
  const double noise = 4 * epsilon * (norm(line.origin) + norm(f.origin) + std::abs(shift));
  return {local(near), local(line.direction), shift, noise};
}

std::vector<double> shifted(std::initializer_list<double> hits, double shift) {
  std::vector<double> result;
  for (const double t : hits) result.push_back(t + shift);
  return result;
}

}  // namespace

std::vector<double> line_hits(const Plane& s, const Line& line) {
  const Vec3 n = cross(s.frame.x, s.frame.y);
  const double speed = dot(n, line.direction);
  if (std::abs(speed) <= 4 * epsilon) return {};
  return {dot(n, s.frame.origin - line.origin) / speed};
}

std::vector<double> line_hits(const Cylinder& s, const Line& line) {
  const LocalLine l = localize(s.frame, line);
  const double across = std::hypot(l.direction.x, l.direction.y);
  if (across <= 4 * epsilon) return {};
  // In the plane across the axis: foot of the perpendicular, then the half chord from (r - d)(r + d).
  const Vec2 e{l.direction.x / across, l.direction.y / across}, q{l.origin.x, l.origin.y};
  const double d = std::abs(cross(e, q));
  const double foot = -dot(e, q) / across;
  if (std::abs(d - s.radius) <= l.noise + 4 * epsilon * s.radius) return shifted({foot}, l.shift);
  if (d > s.radius) return {};
  const double half = std::sqrt((s.radius - d) * (s.radius + d)) / across;
  return shifted({foot - half, foot + half}, l.shift);
}

std::vector<double> line_hits(const Sphere& s, const Line& line) {
  const LocalLine l = localize(s.frame, line);
  const double d = norm(l.origin);
  if (std::abs(d - s.radius) <= l.noise + 4 * epsilon * s.radius) return shifted({0.0}, l.shift);
  if (d > s.radius) return {};
  const double half = std::sqrt((s.radius - d) * (s.radius + d));
  return shifted({-half, half}, l.shift);
}

std::vector<double> line_hits(const Cone& s, const Line& line) {
  // From the apex: x^2 + y^2 = (z tan a)^2, written with cos and sin so that steep cones do no harm:
  // cos^2 (x^2 + y^2) - sin^2 z^2 = 0. The factors (c rho - s |z|)(c rho + s |z|) keep tangency exact to rounding.
  const double sn = std::sin(std::abs(s.half_angle)), cs = std::cos(s.half_angle);
  const double apex_v = -s.radius / std::sin(s.half_angle);
  Frame at_apex = s.frame;
  at_apex.origin += apex_v * cs * s.frame.z;
  LocalLine l = localize(at_apex, line);
  l.noise += 4 * epsilon * std::abs(apex_v);
  const Vec3 q = l.origin, d = l.direction;
  const auto form = [&](Vec3 a, Vec3 b) { return cs * cs * (a.x * b.x + a.y * b.y) - sn * sn * a.z * b.z; };
  if (norm(q) <= l.noise) {  // through the apex: one meeting, unless the line is a ruling
    if (std::abs(cs * std::hypot(d.x, d.y) - sn * std::abs(d.z)) <= 8 * epsilon) return {};
    return shifted({0.0}, l.shift);
  }
  const double slope = cs * std::hypot(d.x, d.y) - sn * std::abs(d.z);
  const double a = slope * (cs * std::hypot(d.x, d.y) + sn * std::abs(d.z));
  const double b = 2 * form(q, d), c = form(q, q);
  const auto height = [&](double t) {  // signed distance to the nearer nappe
    const Vec3 p = q + t * d;
    return cs * std::hypot(p.x, p.y) - sn * std::abs(p.z);
  };
  if (std::abs(slope) <= 8 * epsilon) {  // parallel to a ruling: one meeting, or none when in a tangent plane
    if (std::abs(b) <= 8 * epsilon * norm(q)) return {};
    return shifted({-c / b}, l.shift);
  }
  const double turning = -b / (2 * a);
  if (std::abs(height(turning)) <= l.noise + 8 * epsilon * norm(q + turning * d)) {
    return shifted({turning}, l.shift);
  }
  const RealRoots roots = quadratic_roots(a, b, c);
  if (roots.count == 2) return shifted({roots.value[0], roots.value[1]}, l.shift);
  if (roots.count == 1) return shifted({roots.value[0]}, l.shift);
  return {};
}

std::vector<double> line_hits(const Torus& s, const Line& line) {
  // With p = q + t d, q nearest the centre and d a unit vector, |p|^2 = |q|^2 + t^2, and the torus is
  //   (t^2 + A)^2 = 4 R^2 (p_x^2 + p_y^2),  A = |q|^2 + R^2 - r^2,
  // a quartic without cubic term. Its turning points part the line into pieces with at most one crossing each; there
  // the sign and the crossing itself come from the distance to the tube, which is well conditioned.
  const LocalLine l = localize(s.frame, line);
  const Vec3 q = l.origin, d = l.direction;
  const double size = s.major + s.minor;
  if (norm(q) > size + l.noise + 4 * epsilon * size) return {};
  const double q2 = norm2(q), r2 = s.major * s.major;
  const double a = q2 + (s.major - s.minor) * (s.major + s.minor);
  const std::array<double, 4> derivative = {-8 * r2 * (q.x * d.x + q.y * d.y), 4 * a - 8 * r2 * (d.x * d.x + d.y * d.y),
                                            0, 4};
  const RealRoots turning = polynomial_roots(derivative);
  const auto tube = [&](double t) {
    const Vec3 p = q + t * d;
    const double rho = std::hypot(p.x, p.y);
    const double outer = std::hypot(rho - s.major, p.z) - s.minor;
    if (s.minor <= s.major) return outer;
    return outer * (std::hypot(rho + s.major, p.z) - s.minor) / size;  // a spindle has an inner sheet too
  };
  const double reach = 2 * size + std::abs(norm(q));
  const double touch = 2 * l.noise + 8 * epsilon * size;
  std::vector<double> hits;
  double previous = -reach, f_previous = tube(previous);
  for (int i = 0; i <= turning.count; ++i) {
    const bool last = i == turning.count;
    const double t = last ? reach : turning.value[static_cast<std::size_t>(i)];
    if (!(t > previous)) continue;
    double f = tube(t);
    if (!last && std::abs(f) <= touch) f = 0;
    if (f == 0 && f_previous == 0 && std::abs(tube(0.5 * (previous + t))) <= touch) {
      // Turning points of one flat touch.
    } else if (f == 0) {
      hits.push_back(t + l.shift);
    } else if (f_previous != 0 && (f > 0) != (f_previous > 0)) {
      hits.push_back(root_in_bracket(tube, previous, t, f_previous, f) + l.shift);
    }
    previous = t;
    f_previous = f;
  }
  return hits;
}

}  // namespace aresta::analytic
