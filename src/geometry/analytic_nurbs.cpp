// SPDX-License-Identifier: Apache-2.0
// Piegl, Tiller: The NURBS Book, 7.3 (circular arcs) and 8.3 to 8.5 (surfaces of revolution).
#include "geometry/analytic_nurbs.h"

#include "geometry/analytic.h"

namespace aresta::analytic {

namespace {

/// A rational curve in a plane; x and y multiply whatever axes the caller has.
struct PlaneNurbs {
  int degree = 1;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<Vec2> poles;
  std::vector<double> weights;
};

/// Arc of the unit circle, in pieces of at most a quarter turn; knots are the angles of the joints.
PlaneNurbs unit_arc(Range angles) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(angles.length() / (pi / 2) * (1 - 4 * epsilon))));
  PlaneNurbs arc;
  arc.degree = 2;
  const double step = angles.length() / pieces, w = std::cos(step / 2);
  for (int i = 0; i <= pieces; ++i) {
    const double a = i == pieces ? angles.high : angles.low + i * step;
    if (i > 0) {
      const double m = a - step / 2;
      arc.poles.push_back(Vec2{std::cos(m), std::sin(m)} / w);
      arc.weights.push_back(w);
    }
    arc.poles.push_back({std::cos(a), std::sin(a)});
    arc.weights.push_back(1);
    arc.knots.push_back(a);
    arc.multiplicities.push_back(i == 0 || i == pieces ? 3 : 2);
  }
  return arc;
}

/// The segment s in [low, high] -> a + s b.
PlaneNurbs segment(Range range, Vec2 a, Vec2 b) {
  return {1, {range.low, range.high}, {2, 2}, {a + range.low * b, a + range.high * b}, {1, 1}};
}

bool usable(Range r) {
  return std::isfinite(r.low) && std::isfinite(r.high) && r.low < r.high;
}

NurbsCurveData in_frame(const PlaneNurbs& n, const Frame& f, double a, double b) {
  NurbsCurveData data{n.degree, false, n.knots, n.multiplicities, {}, n.weights};
  for (const Vec2 p : n.poles) data.poles.push_back(f.origin + a * p.x * f.x + b * p.y * f.y);
  return data;
}

/// The profile (distance from the axis, height) turned about the axis.
NurbsSurfaceData revolved(const Frame& f, Range angles, const PlaneNurbs& profile) {
  const PlaneNurbs arc = unit_arc(angles);
  NurbsSurfaceData data;
  data.degree_u = arc.degree;
  data.degree_v = profile.degree;
  data.knots_u = arc.knots;
  data.knots_v = profile.knots;
  data.multiplicities_u = arc.multiplicities;
  data.multiplicities_v = profile.multiplicities;
  data.count_u = arc.poles.size();
  data.count_v = profile.poles.size();
  for (std::size_t i = 0; i < data.count_u; ++i) {
    const Vec3 radial = arc.poles[i].x * f.x + arc.poles[i].y * f.y;
    for (std::size_t j = 0; j < data.count_v; ++j) {
      data.poles.push_back(f.origin + profile.poles[j].x * radial + profile.poles[j].y * f.z);
      data.weights.push_back(arc.weights[i] * profile.weights[j]);
    }
  }
  return data;
}

}  // namespace

NurbsCurveData to_nurbs(const Curve& curve, Range range) {
  if (!usable(range)) return {};
  if (const auto* c = curve.get_if<Line>()) {
    return {1, false, {range.low, range.high}, {2, 2}, {point(*c, range.low), point(*c, range.high)}, {}};
  }
  if (const auto* c = curve.get_if<Circle>()) return in_frame(unit_arc(range), c->frame, c->radius, c->radius);
  if (const auto* c = curve.get_if<Ellipse>()) return in_frame(unit_arc(range), c->frame, c->major, c->minor);
  return {};
}

NurbsSurfaceData to_nurbs(const Surface& surface, const Range2& piece) {
  if (!usable(piece.u) || !usable(piece.v)) return {};
  if (const auto* s = surface.get_if<Plane>()) {
    NurbsSurfaceData data;
    data.degree_u = data.degree_v = 1;
    data.knots_u = {piece.u.low, piece.u.high};
    data.knots_v = {piece.v.low, piece.v.high};
    data.multiplicities_u = data.multiplicities_v = {2, 2};
    data.count_u = data.count_v = 2;
    for (const double u : data.knots_u) {
      for (const double v : data.knots_v) data.poles.push_back(point(*s, {u, v}));
    }
    return data;
  }
  if (const auto* s = surface.get_if<Cylinder>()) {
    return revolved(s->frame, piece.u, segment(piece.v, {s->radius, 0}, {0, 1}));
  }
  if (const auto* s = surface.get_if<Cone>()) {
    return revolved(s->frame, piece.u,
                    segment(piece.v, {s->radius, 0}, {std::sin(s->half_angle), std::cos(s->half_angle)}));
  }
  if (const auto* s = surface.get_if<Sphere>()) {
    PlaneNurbs profile = unit_arc(piece.v);
    for (Vec2& p : profile.poles) p = s->radius * p;
    return revolved(s->frame, piece.u, profile);
  }
  if (const auto* s = surface.get_if<Torus>()) {
    PlaneNurbs profile = unit_arc(piece.v);
    for (Vec2& p : profile.poles) p = Vec2{s->major, 0} + s->minor * p;
    return revolved(s->frame, piece.u, profile);
  }
  return {};
}

}  // namespace aresta::analytic
