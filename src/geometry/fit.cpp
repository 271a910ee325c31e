// SPDX-License-Identifier: Apache-2.0
// All fits work in coordinates moved to the points' centroid and scaled to unit size, linear first, then refined by the
// true distances.
#include "geometry/fit.h"

#include "geometry/analytic.h"
#include "math/box.h"
#include "math/small_matrix.h"

namespace aresta::fit {

namespace {

struct Normalized {
  Vec3 centre;
  double size = 0;
  std::vector<Vec3> points;
};

Normalized normalized_points(std::span<const Vec3> points) {
  Normalized n;
  Box3 box;
  for (const Vec3 p : points) {
    n.centre += p / static_cast<double>(points.size());
    box.add(p);
  }
  n.size = box.diagonal();
  if (!(n.size > 0) || !std::isfinite(n.size)) n.size = 0;
  for (const Vec3 p : points) n.points.push_back((p - n.centre) / n.size);
  return n;
}

Vec3 vec(const Row<3>& r) {
  return {r[0], r[1], r[2]};
}

EigenSystem<3> covariance(std::span<const Vec3> points, Vec3 mean) {
  Matrix<3> m{};
  for (const Vec3 q : points) {
    const Vec3 d = q - mean;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += d[i] * d[j];
    }
  }
  return symmetric_eigen<3>(m);
}

/// Circle through points of the plane: centre and radius; algebraic, then geometric.
struct Circle2 {
  Vec2 centre;
  double radius;
};
std::optional<Circle2> circle2(std::span<const Vec2> points) {
  Matrix<3> m{};
  Row<3> b{};
  for (const Vec2 p : points) {
    const Row<3> row{p.x, p.y, 1};
    const double right = dot(p, p);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) m[i][j] += row[i] * row[j];
      b[i] += row[i] * right;
    }
  }
  const auto s = solve<3>(m, b);
  if (!s) return std::nullopt;
  const Vec2 c{(*s)[0] / 2, (*s)[1] / 2};
  const double r2 = (*s)[2] + dot(c, c);
  if (!(r2 > 0)) return std::nullopt;
  const Row<3> best = least_squares<3>({c.x, c.y, std::sqrt(r2)}, points.size(), [&](const Row<3>& x, std::size_t i) {
    return std::hypot(points[i].x - x[0], points[i].y - x[1]) - x[2];
  });
  if (!(best[2] > 0)) return std::nullopt;
  return Circle2{{best[0], best[1]}, best[2]};
}

/// An axis near the z of `f`: turned by a along x and b along y.
Vec3 tilted(const Frame& f, double a, double b) {
  return normalized(f.z + a * f.x + b * f.y);
}

/// Distance from the line and height along it.
struct Around {
  double rho, height;
};
Around around(Vec3 q, Vec3 on_axis, Vec3 axis) {
  const Vec3 d = q - on_axis;
  const double h = dot(d, axis);
  return {norm(d - h * axis), h};
}

}  // namespace

std::optional<Plane> plane(std::span<const Vec3> points) {
  const Normalized n = normalized_points(points);
  if (points.size() < 3 || n.size == 0) return std::nullopt;
  const EigenSystem<3> e = covariance(n.points, {});
  if (!(e.values[1] > 1e-20)) return std::nullopt;  // on a line
  return Plane{Frame::along(n.centre, vec(e.vectors[0]), vec(e.vectors[2]))};
}

std::optional<Sphere> sphere(std::span<const Vec3> points) {
  const Normalized n = normalized_points(points);
  if (points.size() < 4 || n.size == 0) return std::nullopt;
  Matrix<4> m{};
  Row<4> b{};
  for (const Vec3 p : n.points) {
    const Row<4> row{p.x, p.y, p.z, 1};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) m[i][j] += row[i] * row[j];
      b[i] += row[i] * norm2(p);
    }
  }
  const auto s = solve<4>(m, b);
  if (!s) return std::nullopt;
  const Vec3 c{(*s)[0] / 2, (*s)[1] / 2, (*s)[2] / 2};
  const double r2 = (*s)[3] + norm2(c);
  if (!(r2 > 0)) return std::nullopt;
  const Row<4> best =
      least_squares<4>({c.x, c.y, c.z, std::sqrt(r2)}, n.points.size(), [&](const Row<4>& x, std::size_t i) {
        return distance(n.points[i], {x[0], x[1], x[2]}) - x[3];
      });
  if (!(best[3] > 0)) return std::nullopt;
  return Sphere{Frame::along(n.centre + n.size * Vec3{best[0], best[1], best[2]}, {0, 0, 1}), best[3] * n.size};
}

std::optional<Cylinder> cylinder(const Samples& samples) {
  const Normalized n = normalized_points(samples.points);
  if (samples.points.size() < 5 || n.size == 0) return std::nullopt;
  // Normals stand at right angles to the axis.
  const EigenSystem<3> e = covariance(samples.normals, {});
  if (!(e.values[1] > 1e-14 * e.values[2])) return std::nullopt;
  const Frame f = Frame::along({}, vec(e.vectors[0]), vec(e.vectors[2]));
  std::vector<Vec2> flat;
  for (const Vec3 q : n.points) flat.push_back({dot(q, f.x), dot(q, f.y)});
  const auto c = circle2(flat);
  if (!c) return std::nullopt;
  const auto at = [&](const Row<5>& x) { return x[2] * f.x + x[3] * f.y; };
  const Row<5> best = least_squares<5>(
      {0, 0, c->centre.x, c->centre.y, c->radius}, n.points.size(),
      [&](const Row<5>& x, std::size_t i) { return around(n.points[i], at(x), tilted(f, x[0], x[1])).rho - x[4]; });
  if (!(best[4] > 0)) return std::nullopt;
  return Cylinder{Frame::along(n.centre + n.size * at(best), tilted(f, best[0], best[1])), best[4] * n.size};
}

std::optional<Cone> cone(const Samples& samples) {
  const Normalized n = normalized_points(samples.points);
  if (samples.points.size() < 6 || n.size == 0) return std::nullopt;
  // Normals make one angle with the axis; all tangent planes hold the apex.
  Vec3 mean{};
  std::vector<Vec3> normals;
  for (const Vec3 m : samples.normals) {
    if (m != Vec3{}) normals.push_back(m);
  }
  if (normals.size() < 6) return std::nullopt;
  for (const Vec3 m : normals) mean += m / static_cast<double>(normals.size());
  const EigenSystem<3> e = covariance(normals, mean);
  if (!(e.values[1] > 1e-14 * e.values[2])) return std::nullopt;
  Vec3 axis = vec(e.vectors[0]);
  Matrix<3> m{};
  Row<3> b{};
  for (std::size_t k = 0; k < n.points.size(); ++k) {
    const Vec3 v = samples.normals[k];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += v[i] * v[j];
      b[static_cast<std::size_t>(i)] += v[i] * dot(v, n.points[k]);
    }
  }
  const auto apex = solve<3>(m, b);
  if (!apex) return std::nullopt;
  // The axis points from the apex to the piece.
  if (dot(-vec(*apex), axis) < 0) axis = -axis;
  const Frame f = Frame::along({}, axis);
  double half = std::asin(std::min(1.0, std::abs(dot(mean, axis))));
  const double height = -dot(vec(*apex), axis);  // of the centroid above the apex
  const Vec3 foot = vec(*apex) + height * axis;  // on the axis beside the centroid
  const auto at = [&](const Row<6>& x) { return foot + x[2] * f.x + x[3] * f.y; };
  const auto residual = [&](const Row<6>& x, std::size_t i) {
    const Around q = around(n.points[i], at(x), tilted(f, x[0], x[1]));
    const double here = (q.rho - x[4]) * std::cos(x[5]) - q.height * std::sin(x[5]);
    const double there = (-q.rho - x[4]) * std::cos(x[5]) - q.height * std::sin(x[5]);
    return std::abs(there) < std::abs(here) ? there : here;
  };
  const Row<6> best = least_squares<6>({0, 0, 0, 0, height * std::tan(half), half}, n.points.size(), residual);
  half = best[5];
  if (!(std::abs(half) > 1e-7) || !(std::abs(half) < analytic::pi / 2 - 1e-7)) return std::nullopt;
  Cone result{Frame::along(n.centre + n.size * at(best), tilted(f, best[0], best[1])), best[4] * n.size, half};
  if (result.radius < 0) return std::nullopt;
  return result;
}

std::optional<Torus> torus(const Samples& samples) {
  const Normalized n = normalized_points(samples.points);
  if (samples.points.size() < 7 || n.size == 0) return std::nullopt;
  // Every normal line meets the axis (direction a, moment b): n . b + (p x n) . a = 0.
  Matrix<6> m{};
  for (std::size_t k = 0; k < n.points.size(); ++k) {
    const Vec3 v = samples.normals[k], w = cross(n.points[k], v);
    const Row<6> row{w.x, w.y, w.z, v.x, v.y, v.z};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) m[i][j] += row[i] * row[j];
    }
  }
  const EigenSystem<6> e = symmetric_eigen<6>(m);
  const Row<6>& x0 = e.vectors[0];
  Vec3 axis{x0[0], x0[1], x0[2]};
  const double length = norm(axis);
  if (!(length > 1e-9)) return std::nullopt;
  axis = axis / length;
  const Vec3 moment = Vec3{x0[3], x0[4], x0[5]} / length;
  const Vec3 on_axis = cross(axis, moment);
  std::vector<Vec2> meridian;
  for (const Vec3 q : n.points) {
    const Around a = around(q, on_axis, axis);
    meridian.push_back({a.rho, a.height});
  }
  const auto c = circle2(meridian);
  if (!c || !(c->centre.x > 0)) return std::nullopt;
  const Frame f = Frame::along({}, axis);
  const Vec3 centre = on_axis + c->centre.y * axis;
  const auto at = [&](const Row<7>& x) { return centre + x[2] * f.x + x[3] * f.y + x[4] * f.z; };
  const Row<7> best =
      least_squares<7>({0, 0, 0, 0, 0, c->centre.x, c->radius}, n.points.size(), [&](const Row<7>& x, std::size_t i) {
        const Around q = around(n.points[i], at(x), tilted(f, x[0], x[1]));
        return std::hypot(q.rho - x[5], q.height) - x[6];
      });
  if (!(best[6] > 0) || !(best[5] > best[6])) return std::nullopt;  // a spindle is nobody's intent
  return Torus{Frame::along(n.centre + n.size * at(best), tilted(f, best[0], best[1])), best[5] * n.size,
               best[6] * n.size};
}

std::optional<Circle> circle(std::span<const Vec3> points) {
  const auto in = plane(points);
  if (!in) return std::nullopt;
  const Normalized n = normalized_points(points);
  std::vector<Vec2> flat;
  for (const Vec3 q : n.points) flat.push_back({dot(q, in->frame.x), dot(q, in->frame.y)});
  const auto c = circle2(flat);
  if (!c) return std::nullopt;
  Frame f = in->frame;
  f.origin = n.centre + n.size * (c->centre.x * f.x + c->centre.y * f.y);
  return Circle{f, c->radius * n.size};
}

std::optional<Ellipse> ellipse(std::span<const Vec3> points) {
  const auto in = plane(points);
  if (!in || points.size() < 6) return std::nullopt;
  const Normalized n = normalized_points(points);
  std::vector<Vec2> flat;
  for (const Vec3 q : n.points) flat.push_back({dot(q, in->frame.x), dot(q, in->frame.y)});
  // A x^2 + B x y + C y^2 + D x + E y + F = 0 with unit coefficients: the smallest eigenvector.
  Matrix<6> m{};
  for (const Vec2 p : flat) {
    const Row<6> row{p.x * p.x, p.x * p.y, p.y * p.y, p.x, p.y, 1};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) m[i][j] += row[i] * row[j];
    }
  }
  const Row<6> k = symmetric_eigen<6>(m).vectors[0];
  const auto centre = solve<2>({{{2 * k[0], k[1]}, {k[1], 2 * k[2]}}}, {-k[3], -k[4]});
  if (!centre || !(4 * k[0] * k[2] - k[1] * k[1] > 1e-12)) return std::nullopt;
  const Vec2 c{(*centre)[0], (*centre)[1]};
  const double level = -(k[5] + 0.5 * (k[3] * c.x + k[4] * c.y));
  const EigenSystem<2> q =
      symmetric_eigen<2>({{{k[0] / level, k[1] / (2 * level)}, {k[1] / (2 * level), k[2] / level}}});
  if (!(q.values[0] > 0) || !(q.values[1] > 0)) return std::nullopt;
  const double a = 1 / std::sqrt(q.values[0]), b = 1 / std::sqrt(q.values[1]);
  const double turn = std::atan2(q.vectors[0][1], q.vectors[0][0]);
  const Row<5> best = least_squares<5>({c.x, c.y, a, b, turn}, flat.size(), [&](const Row<5>& x, std::size_t i) {
    const double cs = std::cos(x[4]), sn = std::sin(x[4]);
    const Vec2 d{flat[i].x - x[0], flat[i].y - x[1]};
    const Vec2 s{(cs * d.x + sn * d.y) / x[2], (cs * d.y - sn * d.x) / x[3]};
    return (norm(s) - 1) * std::min(std::abs(x[2]), std::abs(x[3]));
  });
  if (!(best[2] > best[3]) || !(best[3] > 0)) return std::nullopt;
  Frame f = in->frame;
  const Vec3 x = std::cos(best[4]) * f.x + std::sin(best[4]) * f.y;
  f.origin = n.centre + n.size * (best[0] * f.x + best[1] * f.y);
  f.x = normalized(x);
  f.y = cross(f.z, f.x);
  return Ellipse{f, best[2] * n.size, best[3] * n.size};
}

}  // namespace aresta::fit
