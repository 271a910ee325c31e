// SPDX-License-Identifier: Apache-2.0
// Coincidence: first by object, then by closed forms where both have the same form, then by points.
#include <algorithm>

#include "geometry/analytic.h"
#include "geometry/free_eval.h"

namespace aresta {

namespace {

using analytic::infinity;

bool finite(Range r) {
  return std::isfinite(r.low) && std::isfinite(r.high);
}

/// How far apart two closed forms may lie at most, over all parameters; infinity when not comparable.
double bound(const Circle& a, const Circle& b) {
  const double tilt = std::min(norm(cross(a.frame.x, a.frame.y) - cross(b.frame.x, b.frame.y)),
                               norm(cross(a.frame.x, a.frame.y) + cross(b.frame.x, b.frame.y)));
  return distance(a.frame.origin, b.frame.origin) + std::abs(a.radius - b.radius) + a.radius * tilt;
}

std::vector<double> sample_parameters(const Curve& a, Range range) {
  std::vector<double> breaks{range.low, range.high};
  if (const auto* f = a.get_if<FreeCurve>()) breaks = free_form::smooth_breaks(*f, range);
  const std::size_t spans = breaks.size() - 1;
  const int each = spans > 100 ? 3 : spans > 20 ? 6 : spans > 2 ? 12 : 24;
  std::vector<double> t;
  for (std::size_t i = 0; i < spans; ++i) {
    for (int k = 0; k < each; ++k) t.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * k / each);
  }
  t.push_back(range.high);
  return t;
}

/// A finite stand-in for an unbounded range: straight generators agree everywhere when they agree far enough out.
Range clipped(Range r, double size) {
  const double reach = 1e3 * std::max(size, 1.0);
  if (!std::isfinite(r.low) && !std::isfinite(r.high)) return {-reach, reach};
  if (!std::isfinite(r.low)) return {r.high - reach, r.high};
  if (!std::isfinite(r.high)) return {r.low, r.low + reach};
  return r;
}

double size_of(const Surface& s) {
  if (const auto* f = s.get_if<Cylinder>()) return f->radius;
  if (const auto* f = s.get_if<Cone>()) return f->radius;
  return 1;
}

}  // namespace

bool coincident(const Curve& a, Range range, const Curve& b, double tolerance, bool* same_direction) {
  if (!(range.low <= range.high) || !(tolerance >= 0)) return false;
  const auto* fa = a.get_if<FreeCurve>();
  const auto* fb = b.get_if<FreeCurve>();
  if (fa != nullptr && fb != nullptr && fa->same_object(*fb)) {
    if (same_direction != nullptr) *same_direction = true;
    return true;
  }
  const auto* la = a.get_if<Line>();
  const auto* lb = b.get_if<Line>();
  if (la != nullptr && lb != nullptr) {
    if (same_direction != nullptr) *same_direction = dot(la->direction, lb->direction) > 0;
    const auto off = [&](double t) {
      return norm(cross(analytic::point(*la, t) - lb->origin, lb->direction)) <= tolerance;
    };
    if (finite(range)) return off(range.low) && off(range.high);
    const Range part = clipped(range, 1);
    return norm(cross(la->direction, lb->direction)) <= 1e-12 && off(part.low) && off(part.high);
  }
  if (!finite(range)) return false;
  const auto say_direction = [&] {
    if (same_direction == nullptr) return;
    const CurveJet j = a.jet(range.middle());
    const CurveProjection q = b.project(j.point, b.domain());
    *same_direction = dot(j.d1, b.jet(q.parameter).d1) > 0;
  };
  const auto* ca = a.get_if<Circle>();
  const auto* cb = b.get_if<Circle>();
  if (ca != nullptr && cb != nullptr && bound(*ca, *cb) <= tolerance) {
    say_direction();
    return true;
  }
  // A box apart by more than the tolerance settles most pairs at once.
  if (b.period() > 0 || finite(b.domain())) {
    if (!a.bounds(range).grown(tolerance).overlaps(b.bounds(b.domain()))) return false;
  }
  const Range whole = b.domain();
  for (const double t : sample_parameters(a, range)) {
    if (!(b.project(a.point(t), whole).distance <= tolerance)) return false;
  }
  say_direction();
  return true;
}

bool coincident(const Surface& a, const Range2& piece, const Surface& b, double tolerance, bool* same_normal) {
  if (!(piece.u.low <= piece.u.high) || !(piece.v.low <= piece.v.high) || !(tolerance >= 0)) return false;
  const auto* fa = a.get_if<FreeSurface>();
  const auto* fb = b.get_if<FreeSurface>();
  if (fa != nullptr && fb != nullptr && fa->same_object(*fb)) {
    if (same_normal != nullptr) *same_normal = true;
    return true;
  }
  Range2 part{clipped(piece.u, size_of(a)), clipped(piece.v, size_of(a))};
  const bool flat = a.is_plane() && b.is_plane();
  // Unbounded pieces: what is straight must also be parallel.
  if (!finite(piece.u) || !finite(piece.v)) {
    const auto axis = [](const Surface& s) {
      if (const auto* f = s.get_if<Plane>()) return f->frame.z;
      if (const auto* f = s.get_if<Cylinder>()) return f->frame.z;
      if (const auto* f = s.get_if<Cone>()) return f->frame.z;
      return Vec3{};
    };
    if (a.form().index() != b.form().index() || norm(cross(axis(a), axis(b))) > 1e-12) return false;
  }
  const int n = flat ? 1 : fa != nullptr ? 24 : 12;
  const Vec2 hint_at{part.u.middle(), part.v.middle()};
  bool said = false;
  Vec2 hint{};
  bool has_hint = false;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const Vec2 uv{part.u.at(static_cast<double>(i) / n), part.v.at(static_cast<double>(j) / n)};
      const Vec3 p = a.point(uv);
      SurfaceProjection q = b.project(p, has_hint ? &hint : nullptr);
      // A free-form search from a hint may stop at a local minimum; ask the whole surface before saying no.
      if (!(q.distance <= tolerance) && has_hint) q = b.project(p);
      if (!(q.distance <= tolerance)) return false;
      hint = q.uv;
      has_hint = true;
      if (!said && same_normal != nullptr) {
        const double agreement = dot(a.normal(uv), b.normal(q.uv));
        if (std::abs(agreement) > 0.5) {
          *same_normal = agreement > 0;
          said = true;
        }
      }
    }
  }
  if (!said && same_normal != nullptr) {
    const Vec3 p = a.point(hint_at);
    *same_normal = dot(a.normal(hint_at), b.normal(b.project(p).uv)) > 0;
  }
  return true;
}

}  // namespace aresta
