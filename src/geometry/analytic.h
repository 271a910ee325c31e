// SPDX-License-Identifier: Apache-2.0
// Evaluation of the analytic forms, inlined: for loops that know which form they have. Curve and Surface dispatch here.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/curve.h"
#include "geometry/surface.h"

namespace aresta::analytic {

inline constexpr double pi = std::numbers::pi;
inline constexpr double two_pi = 2 * std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// +1 for a right-handed frame, -1 for a left-handed one.
inline double handedness(const Frame& f) {
  return f.right_handed() ? 1.0 : -1.0;
}

/// An angle moved by whole turns to the first one >= low.
inline double angle_from(double angle, double low) {
  if (!std::isfinite(angle) || !std::isfinite(low)) return angle;
  double a = angle - two_pi * std::floor((angle - low) / two_pi);
  if (a < low) a += two_pi;
  if (a >= low + two_pi) a -= two_pi;
  return a < low ? low : a;
}

/// An angle moved by whole turns to within half a turn of `near`.
inline double angle_near(double angle, double near) {
  return angle - two_pi * std::round((angle - near) / two_pi);
}

inline Vec3 point(const Line& c, double t) {
  return c.origin + t * c.direction;
}
inline CurveJet jet(const Line& c, double t) {
  return {point(c, t), c.direction, {}};
}

inline Vec3 point(const Circle& c, double t) {
  return c.frame.origin + c.radius * (std::cos(t) * c.frame.x + std::sin(t) * c.frame.y);
}
inline CurveJet jet(const Circle& c, double t) {
  const double cs = c.radius * std::cos(t), sn = c.radius * std::sin(t);
  const Vec3 radial = cs * c.frame.x + sn * c.frame.y;
  return {c.frame.origin + radial, cs * c.frame.y - sn * c.frame.x, -radial};
}

inline Vec3 point(const Ellipse& c, double t) {
  return c.frame.origin + c.major * std::cos(t) * c.frame.x + c.minor * std::sin(t) * c.frame.y;
}
inline CurveJet jet(const Ellipse& c, double t) {
  const double cs = std::cos(t), sn = std::sin(t);
  const Vec3 radial = c.major * cs * c.frame.x + c.minor * sn * c.frame.y;
  return {c.frame.origin + radial, c.minor * cs * c.frame.y - c.major * sn * c.frame.x, -radial};
}

inline Vec3 point(const Plane& s, Vec2 uv) {
  return s.frame.origin + uv.x * s.frame.x + uv.y * s.frame.y;
}
inline SurfaceJet jet(const Plane& s, Vec2 uv) {
  return {point(s, uv), s.frame.x, s.frame.y, {}, {}, {}};
}

/// Unit vectors away from the axis and along growing u.
struct Azimuth {
  Vec3 radial, around;
};
inline Azimuth azimuth(const Frame& f, double u) {
  const double c = std::cos(u), s = std::sin(u);
  return {c * f.x + s * f.y, c * f.y - s * f.x};
}

inline Vec3 point(const Cylinder& s, Vec2 uv) {
  return s.frame.origin + s.radius * azimuth(s.frame, uv.x).radial + uv.y * s.frame.z;
}
inline SurfaceJet jet(const Cylinder& s, Vec2 uv) {
  const auto [radial, around] = azimuth(s.frame, uv.x);
  return {
      s.frame.origin + s.radius * radial + uv.y * s.frame.z, s.radius * around, s.frame.z, -s.radius * radial, {}, {}};
}

inline Vec3 point(const Cone& s, Vec2 uv) {
  const double w = s.radius + uv.y * std::sin(s.half_angle);
  return s.frame.origin + w * azimuth(s.frame, uv.x).radial + uv.y * std::cos(s.half_angle) * s.frame.z;
}
inline SurfaceJet jet(const Cone& s, Vec2 uv) {
  const auto [radial, around] = azimuth(s.frame, uv.x);
  const double sn = std::sin(s.half_angle), cs = std::cos(s.half_angle);
  const double w = s.radius + uv.y * sn;
  return {s.frame.origin + w * radial + uv.y * cs * s.frame.z,
          w * around,
          sn * radial + cs * s.frame.z,
          -w * radial,
          sn * around,
          {}};
}

inline Vec3 point(const Sphere& s, Vec2 uv) {
  return s.frame.origin + s.radius * std::cos(uv.y) * azimuth(s.frame, uv.x).radial +
         s.radius * std::sin(uv.y) * s.frame.z;
}
inline SurfaceJet jet(const Sphere& s, Vec2 uv) {
  const auto [radial, around] = azimuth(s.frame, uv.x);
  const double c = s.radius * std::cos(uv.y), n = s.radius * std::sin(uv.y);
  const Vec3 out = c * radial + n * s.frame.z;
  return {s.frame.origin + out, c * around, c * s.frame.z - n * radial, -c * radial, -n * around, -out};
}

inline Vec3 point(const Torus& s, Vec2 uv) {
  return s.frame.origin + (s.major + s.minor * std::cos(uv.y)) * azimuth(s.frame, uv.x).radial +
         s.minor * std::sin(uv.y) * s.frame.z;
}
inline SurfaceJet jet(const Torus& s, Vec2 uv) {
  const auto [radial, around] = azimuth(s.frame, uv.x);
  const double c = s.minor * std::cos(uv.y), n = s.minor * std::sin(uv.y);
  const double w = s.major + c;
  return {s.frame.origin + w * radial + n * s.frame.z,
          w * around,
          c * s.frame.z - n * radial,
          -w * radial,
          -n * around,
          -c * radial - n * s.frame.z};
}

inline Vec3 normal(const Plane& s, Vec2) {
  return cross(s.frame.x, s.frame.y);
}
inline Vec3 normal(const Cylinder& s, Vec2 uv) {
  return handedness(s.frame) * azimuth(s.frame, uv.x).radial;
}
/// At the apex the limit from the side of growing radius.
inline Vec3 normal(const Cone& s, Vec2 uv) {
  const double side = s.radius + uv.y * std::sin(s.half_angle) < 0 ? -1.0 : 1.0;
  return side * handedness(s.frame) *
         (std::cos(s.half_angle) * azimuth(s.frame, uv.x).radial - std::sin(s.half_angle) * s.frame.z);
}
inline Vec3 normal(const Sphere& s, Vec2 uv) {
  const double c = std::cos(uv.y);
  const double side = c < -4 * epsilon ? -1.0 : 1.0;
  return side * handedness(s.frame) * (c * azimuth(s.frame, uv.x).radial + std::sin(uv.y) * s.frame.z);
}
inline Vec3 normal(const Torus& s, Vec2 uv) {
  const double c = std::cos(uv.y);
  const double side = s.major + s.minor * c < 0 ? -1.0 : 1.0;
  return side * handedness(s.frame) * (c * azimuth(s.frame, uv.x).radial + std::sin(uv.y) * s.frame.z);
}

// Projections, bounds and line meetings; see surface_analytic.cpp, surface_line.cpp and curve_analytic.cpp.
CurveProjection project(const Line&, Vec3 p, Range range);
CurveProjection project(const Circle&, Vec3 p, Range range);
CurveProjection project(const Ellipse&, Vec3 p, Range range);
Box3 bounds(const Line&, Range);
Box3 bounds(const Circle&, Range);
Box3 bounds(const Ellipse&, Range);
double length(const Ellipse&, Range, double relative);

SurfaceProjection project(const Plane&, Vec3 p, const Vec2* hint);
SurfaceProjection project(const Cylinder&, Vec3 p, const Vec2* hint);
SurfaceProjection project(const Cone&, Vec3 p, const Vec2* hint);
SurfaceProjection project(const Sphere&, Vec3 p, const Vec2* hint);
SurfaceProjection project(const Torus&, Vec3 p, const Vec2* hint);
Box3 bounds(const Plane&, const Range2&);
Box3 bounds(const Cylinder&, const Range2&);
Box3 bounds(const Cone&, const Range2&);
Box3 bounds(const Sphere&, const Range2&);
Box3 bounds(const Torus&, const Range2&);

/// Parameters on the line of all meetings, growing; a touch counts once.
std::vector<double> line_hits(const Plane&, const Line&);
std::vector<double> line_hits(const Cylinder&, const Line&);
std::vector<double> line_hits(const Cone&, const Line&);
std::vector<double> line_hits(const Sphere&, const Line&);
std::vector<double> line_hits(const Torus&, const Line&);

}  // namespace aresta::analytic
