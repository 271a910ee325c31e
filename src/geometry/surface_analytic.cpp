// SPDX-License-Identifier: Apache-2.0
// Projection and bounds of plane, cylinder, cone, sphere and torus.
#include <algorithm>

#include "geometry/analytic.h"
#include "geometry/bounds_parts.h"

namespace aresta::analytic {

namespace {

/// Distance from the axis, azimuth in the frame, and height.
struct Cylindrical {
  double rho, angle, height;
};

Cylindrical cylindrical(const Frame& f, Vec3 p, const Vec2* hint) {
  const Vec3 l = f.to_local(p);
  const double rho = std::hypot(l.x, l.y);
  if (rho == 0) return {0, hint != nullptr ? hint->x : 0, l.z};
  return {rho, std::atan2(l.y, l.x), l.z};
}

double angle_for(double angle, const double* hint) {
  return hint != nullptr ? angle_near(angle, *hint) : angle_from(angle, 0);
}

template <class Form>
SurfaceProjection at(const Form& s, Vec3 p, Vec2 uv) {
  const Vec3 q = point(s, uv);
  return {uv, q, distance(p, q)};
}

}  // namespace

SurfaceProjection project(const Plane& s, Vec3 p, const Vec2*) {
  const Vec3 d = p - s.frame.origin;
  return at(s, p, {dot(d, s.frame.x), dot(d, s.frame.y)});
}

SurfaceProjection project(const Cylinder& s, Vec3 p, const Vec2* hint) {
  const auto [rho, angle, height] = cylindrical(s.frame, p, hint);
  return at(s, p, {angle_for(angle, hint != nullptr ? &hint->x : nullptr), height});
}

SurfaceProjection project(const Cone& s, Vec3 p, const Vec2* hint) {
  // In the half plane of p's azimuth the cone is the line (r + v sin a, v cos a); the opposite azimuth gives the other.
  const auto [rho, angle, height] = cylindrical(s.frame, p, hint);
  const double sn = std::sin(s.half_angle), cs = std::cos(s.half_angle);
  const double here = std::abs((rho - s.radius) * cs - height * sn);
  const double there = std::abs((-rho - s.radius) * cs - height * sn);
  const bool opposite = there < here;
  const double signed_rho = opposite ? -rho : rho;
  const double v = (signed_rho - s.radius) * sn + height * cs;
  double u = opposite ? angle + pi : angle;
  if (hint != nullptr && s.radius + v * sn == 0) u = hint->x;  // the apex has every u
  return at(s, p, {angle_for(u, hint != nullptr ? &hint->x : nullptr), v});
}

SurfaceProjection project(const Sphere& s, Vec3 p, const Vec2* hint) {
  const auto [rho, angle, height] = cylindrical(s.frame, p, hint);
  double v = std::atan2(height, rho);
  if (rho == 0 && height == 0) v = hint != nullptr ? std::clamp(hint->y, -pi / 2, pi / 2) : 0;
  return at(s, p, {angle_for(angle, hint != nullptr ? &hint->x : nullptr), v});
}

SurfaceProjection project(const Torus& s, Vec3 p, const Vec2* hint) {
  const auto [rho, angle, height] = cylindrical(s.frame, p, hint);
  double radial = rho - s.major, u = angle;
  if (s.minor > s.major) {
    // A spindle: the circle of the opposite side reaches across the axis.
    const double here = std::abs(std::hypot(rho - s.major, height) - s.minor);
    const double there = std::abs(std::hypot(rho + s.major, height) - s.minor);
    if (there < here) {
      radial = -rho - s.major;
      u = angle + pi;
    }
  }
  double v = std::atan2(height, radial);
  if (radial == 0 && height == 0) v = hint != nullptr ? hint->y : 0;
  return at(s, p,
            {angle_for(u, hint != nullptr ? &hint->x : nullptr), angle_for(v, hint != nullptr ? &hint->y : nullptr)});
}

Box3 bounds(const Plane& s, const Range2& piece) {
  BoxSum sum(s.frame.origin);
  sum.add(s.frame.x, piece.u);
  sum.add(s.frame.y, piece.v);
  return sum.box();
}

Box3 bounds(const Cylinder& s, const Range2& piece) {
  BoxSum sum(s.frame.origin);
  sum.add_turn(s.radius * s.frame.x, s.radius * s.frame.y, piece.u);
  sum.add(s.frame.z, piece.v);
  return sum.box();
}

// Cone, sphere and torus: a coordinate is linear in C(u) = cos u x_i + sin u y_i for fixed v, so its extremes lie at
// the extremes of C; what remains depends on v alone.
Box3 bounds(const Cone& s, const Range2& piece) {
  const double sn = std::sin(s.half_angle), cs = std::cos(s.half_angle);
  BoxSum sum(s.frame.origin);
  for (int i = 0; i < 3; ++i) {
    const Range c = turn_range(s.frame.x[i], s.frame.y[i], piece.u);
    const auto along = [&](double ci) {
      const Range r = scaled(piece.v, sn * ci + cs * s.frame.z[i]);
      return Range{s.radius * ci + r.low, s.radius * ci + r.high};
    };
    sum.add(i, hull(along(c.low), along(c.high)));
  }
  return sum.box();
}

Box3 bounds(const Sphere& s, const Range2& piece) {
  BoxSum sum(s.frame.origin);
  for (int i = 0; i < 3; ++i) {
    const Range c = turn_range(s.frame.x[i], s.frame.y[i], piece.u);
    const auto along = [&](double ci) { return turn_range(s.radius * ci, s.radius * s.frame.z[i], piece.v); };
    sum.add(i, hull(along(c.low), along(c.high)));
  }
  return sum.box();
}

Box3 bounds(const Torus& s, const Range2& piece) {
  BoxSum sum(s.frame.origin);
  for (int i = 0; i < 3; ++i) {
    const Range c = turn_range(s.frame.x[i], s.frame.y[i], piece.u);
    const auto along = [&](double ci) {
      const Range r = turn_range(s.minor * ci, s.minor * s.frame.z[i], piece.v);
      return Range{s.major * ci + r.low, s.major * ci + r.high};
    };
    sum.add(i, hull(along(c.low), along(c.high)));
  }
  return sum.box();
}

}  // namespace aresta::analytic
