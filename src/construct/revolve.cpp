// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include "construct/arguments.h"
#include "construct/drafts.h"
#include "construct/sweep.h"
#include "construct/sweep_core.h"
#include "geometry/swept.h"

namespace aresta {

namespace {

constexpr double pi = std::numbers::pi;

/// A point about the axis: distance, height, and the unit direction away from the axis (zero on it).
struct Polar {
  double radius = 0, height = 0;
  Vec3 out{};
};

class Rotation : public SweepMotion {
 public:
  /// `angle` in degrees, in (0, 360].
  Rotation(double angle, Vec3 origin, Vec3 axis, double tolerance)
      : degrees_(angle), angle_(angle * pi / 180), origin_(origin), axis_(axis), tolerance_(tolerance) {}

  std::string name() const override { return "revolve"; }
  Vec3 velocity(Vec3 p) const override { return cross(axis_, p - origin_); }
  bool is_fixed(Vec3 p) const override { return norm(velocity(p)) <= tolerance_; }
  bool is_closed() const override { return degrees_ == 360; }
  Transform end() const override { return Transform::rotation(degrees_, axis_, origin_); }

  SweptPath path(Vec3 p) const override {
    const Polar at = polar(p);
    return {Circle{frame(at.height, at.out), at.radius}, {0, angle_}};
  }

  Status check_face(const Model& profile, FaceId f, Vec3 normal) const override {
    // The faces' points move across its plane at the speed `away . (p - origin)`, which must keep its sign.
    const Vec3 away = cross(normal, axis_);
    if (norm(away) <= 1e-9) {
      return Error{
          errors::bad_profile, "revolve: a face is at right angles to the axis, so that it turns in itself", {f}};
    }
    double low = 0, high = 0;
    for (const LoopId l : profile.topology().loops(f)) {
      for (const CoedgeId c : profile.topology().coedges(l)) {
        const EdgeId e = profile.topology().edge(c);
        const Range reach = reach_along(profile, e, normalized(away));
        low = std::min(low, reach.low);
        high = std::max(high, reach.high);
      }
    }
    if (std::min(-low, high) > tolerance_) {
      return Error{errors::bad_profile, "revolve: a face of the profile reaches to both sides of the axis", {f}};
    }
    return {};
  }

  Result<SweptSurface> surface(const Model& profile, EdgeId e) const override {
    if (profile.is_straight(e)) return line_surface(profile, e);
    ARESTA_CHECK(check_off_axis(profile, e));
    const Curve curve = profile.curve(e);
    const Range range = profile.range(e);
    if (const Circle* c = curve.get_if<Circle>()) {
      if (auto swept = arc_surface(*c, curve.point(range.middle()), range)) return std::move(*swept);
    }
    return free_surface(curve, range);
  }

 private:
  Polar polar(Vec3 p) const {
    const Vec3 d = p - origin_;
    const double height = dot(d, axis_);
    const Vec3 out = d - height * axis_;
    return {norm(out), height, normalized(out)};
  }

  Frame frame(double height, Vec3 out) const {
    // Made orthonormal again: `out` comes from a difference.
    const Vec3 x = normalized(out - dot(out, axis_) * axis_);
    return {origin_ + height * axis_, x, cross(axis_, x), axis_};
  }

  /// Least and largest of direction . (p - origin) along the edge: exact for analytic curves.
  Range reach_along(const Model& profile, EdgeId e, Vec3 direction) const {
    const Curve curve = profile.curve(e);
    const Range range = profile.range(e);
    const auto height = [&](Vec3 p) { return dot(p - origin_, direction); };
    Range reach{height(curve.point(range.low)), height(curve.point(range.low))};
    const auto widen = [&](double h) { reach = {std::min(reach.low, h), std::max(reach.high, h)}; };
    widen(height(curve.point(range.high)));
    if (curve.is_line()) return reach;
    // Extremes lie where the derivative changes sign.
    constexpr int samples = 256;
    const auto slope = [&](double t) { return dot(curve.jet(t).d1, direction); };
    for (int i = 0; i < samples; ++i) {
      double a = range.at(double(i) / samples), b = range.at((i + 1.0) / samples);
      widen(height(curve.point(b)));
      const double sa = slope(a);
      if (sa * slope(b) >= 0) continue;
      for (int k = 0; k < 60; ++k) (slope(0.5 * (a + b)) * sa > 0 ? a : b) = 0.5 * (a + b);
      widen(height(curve.point(a)));
    }
    return reach;
  }

  /// An edge may end on the axis but not meet it in between.
  Status check_off_axis(const Model& profile, EdgeId e) const {
    const Curve curve = profile.curve(e);
    const Range range = profile.range(e);
    const auto radius = [&](double t) { return norm(velocity(curve.point(t))); };
    constexpr int samples = 256;
    for (int i = 1; i < samples; ++i) {
      double a = range.at((i - 1.0) / samples), b = range.at((i + 1.0) / samples);
      const double middle = radius(range.at(double(i) / samples));
      if (middle > radius(a) || middle > radius(b)) continue;
      constexpr double golden = 0.3819660112501051;
      for (int k = 0; k < 80; ++k) {
        const double p = a + golden * (b - a), q = b - golden * (b - a);
        (radius(p) < radius(q) ? b : a) = radius(p) < radius(q) ? q : p;
      }
      if (radius(a) <= tolerance_) return crosses_axis(e, curve.point(a));
    }
    return {};
  }

  static Error crosses_axis(EdgeId e, Vec3 place) {
    return Error{errors::bad_profile,
                 "revolve: an edge of the profile meets the axis between its ends",
                 {e},
                 std::array{place.x, place.y, place.z}};
  }

  Result<SweptSurface> line_surface(const Model& profile, EdgeId e) const {
    const Range range = profile.range(e);
    Polar start = polar(profile.edge_point(e, range.low)), end = polar(profile.edge_point(e, range.high));
    if (start.radius <= tolerance_) start = {0, start.height, end.out};
    if (end.radius <= tolerance_) end = {0, end.height, start.out};
    const double wide = std::max(start.radius, end.radius);
    const double rise = end.height - start.height, spread = end.radius - start.radius;
    const bool one_half_plane = wide * norm(start.out - end.out) <= tolerance_;
    if (std::abs(rise) <= tolerance_) {  // the line turns in a plane
      const CurveJet jet = profile.edge_jet(e, range.low);
      const Vec3 foot_from_start = origin_ + start.height * axis_ - jet.point;
      const double foot = range.low + dot(foot_from_start, jet.d1);
      const double nearest = norm(velocity(jet.point + (foot - range.low) * jet.d1));
      if (foot > range.low + tolerance_ && foot < range.high - tolerance_) {
        if (nearest <= tolerance_) return crosses_axis(e, profile.edge_point(e, foot));
        return Error{errors::bad_profile, "revolve: an edge of the profile sweeps part of a plane twice", {e}};
      }
      const Polar& outer = start.radius > end.radius ? start : end;
      return SweptSurface{Plane{frame(start.height, outer.out)}};
    }
    if (!one_half_plane) {
      if (wide * norm(start.out + end.out) <= tolerance_)
        return crosses_axis(e, origin_ + (start.height + rise * start.radius / (start.radius + end.radius)) * axis_);
      return free_surface(profile.curve(e), range);
    }
    const double up = rise > 0 ? 1 : -1;
    const auto images = [&](Surface surface, double v_start, double v_end) {
      return SweptSurface{std::move(surface), straight_image(0, v_start - up * range.low, 0, up),
                          straight_image(angle_, v_start - up * range.low, 0, up), straight_image(0, v_start, 1, 0),
                          straight_image(0, v_end, 1, 0)};
    };
    if (std::abs(spread) <= tolerance_) {
      return images(Cylinder{frame(start.height, start.out), 0.5 * (start.radius + end.radius)}, 0, rise);
    }
    const double length = up * std::hypot(rise, spread);
    const double half_angle = std::atan2(up * spread, up * rise);
    if (start.radius > end.radius)
      return images(Cone{frame(start.height, start.out), start.radius, half_angle}, 0, length);
    return images(Cone{frame(end.height, end.out), end.radius, half_angle}, -length, 0);
  }

  /// Sphere or torus, when the arc lies in a half-plane of the axis and its centre allows.
  std::optional<Result<SweptSurface>> arc_surface(const Circle& c, Vec3 middle, Range range) const {
    const double tilt = std::abs(dot(c.frame.z, axis_)) * c.radius;
    const Vec3 out = polar(middle).out;
    const Vec3 centre = c.frame.origin - origin_;
    const double off = std::abs(dot(centre, cross(axis_, out))) + std::abs(dot(c.frame.z, out)) * c.radius;
    if (tilt > 0.1 * tolerance_ || off > 0.1 * tolerance_) return std::nullopt;
    const double radius = dot(centre, out), height = dot(centre, axis_);
    const Vec2 x{dot(c.frame.x, out), dot(c.frame.x, axis_)}, y{dot(c.frame.y, out), dot(c.frame.y, axis_)};
    const double turn = cross(x, y) > 0 ? 1 : -1;
    double first = std::atan2(x.y, x.x);  // v = first + turn * t
    const auto images = [&](Surface surface) {
      const double v_start = first + turn * range.low, v_end = first + turn * range.high;
      return SweptSurface{std::move(surface), straight_image(0, first, 0, turn), straight_image(angle_, first, 0, turn),
                          straight_image(0, v_start, 1, 0), straight_image(0, v_end, 1, 0)};
    };
    if (std::abs(radius) <= 0.1 * tolerance_) {
      first -= 2 * pi * std::round((first + turn * range.middle()) / (2 * pi));
      return images(Sphere{frame(height, out), c.radius});
    }
    if (radius - c.radius > tolerance_) return images(Torus{frame(height, out), radius, c.radius});
    return std::nullopt;
  }

  Result<SweptSurface> free_surface(const Curve& curve, Range range) const {
    ARESTA_TRY(Surface swept, revolution_surface(curve, origin_, axis_));
    return SweptSurface{std::move(swept), straight_image(0, 0, 0, 1), straight_image(angle_, 0, 0, 1),
                        straight_image(0, range.low, 1, 0), straight_image(0, range.high, 1, 0)};
  }

  double degrees_, angle_;
  Vec3 origin_, axis_;
  double tolerance_;
};

}  // namespace

Result<Model> revolve(const std::shared_ptr<const Model>& profile, double angle, Vec3 about, Vec3 axis,
                      const ConstructOptions& options, const Context& context) {
  Arguments arguments("revolve");
  arguments.finite("angle", angle);
  arguments.require(angle != 0 && std::abs(angle) <= 360 + 1e-9, "angle", "between -360 and 360 and not 0",
                    number_text(angle));
  arguments.point("about", about);
  arguments.direction("axis", axis);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  axis = normalized(axis);
  if (angle < 0) {
    angle = -angle;
    axis = -axis;
  }
  if (360 - angle <= 1e-9) angle = 360;

  // The axis's point nearest to the profile serves precision; all of the sweep lies in a box about it.
  const Box3 flat = profile->bounds();
  Box3 box;
  double radius = 0;
  if (!flat.empty()) {
    about = about + dot(flat.centre() - about, axis) * axis;
    const double reach = distance(about, flat.centre()) + 0.5 * flat.diagonal();
    box.add(about - Vec3{reach, reach, reach});
    box.add(about + Vec3{reach, reach, reach});
    for (const EdgeId e : profile->topology().edges()) {
      for (const Vec3& p : sample_edge(*profile, e, 8)) radius = std::max(radius, norm(cross(axis, p - about)));
    }
    for (const VertexId v : profile->topology().vertices())
      radius = std::max(radius, norm(cross(axis, profile->point(v) - about)));
  }
  const double rounding = std::max({options.tolerance, profile->tolerance(), rounding_tolerance(box)});
  const double tolerance = std::max(rounding, 1e-9 * radius);
  const double pace = radius * pi / 180;
  if (angle < 360 && radius > tolerance) {
    arguments.resolvable("the way of the profile's outermost point", pace * angle, tolerance);
    arguments.resolvable("the gap that the angle leaves to a full turn", pace * (360 - angle), tolerance);
    ARESTA_CHECK(arguments.status());
  }
  return sweep(profile, Rotation(angle, about, axis, tolerance), rounding, options.names, context);
}

}  // namespace aresta
