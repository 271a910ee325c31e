// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface.h"

#include "geometry/analytic.h"
#include "geometry/analytic_nurbs.h"
#include "geometry/free_eval.h"

namespace aresta {

namespace {

using analytic::infinity;
using analytic::two_pi;

/// Calls f with the analytic form, or g with the free one.
template <class F, class G>
auto dispatch(const Surface::Form& form, F&& f, G&& g) {
  switch (form.index()) {
    case 0:
      return f(std::get<0>(form));
    case 1:
      return f(std::get<1>(form));
    case 2:
      return f(std::get<2>(form));
    case 3:
      return f(std::get<3>(form));
    case 4:
      return f(std::get<4>(form));
    default:
      return g(std::get<5>(form));
  }
}

Error bad_map(const char* what) {
  return {errors::bad_transform,
          std::string("this transformation turns a ") + what +
              " into a surface that cannot keep its parameters; only similarities (moves, turns, mirrors, uniform "
              "scalings) and scalings along its axes can",
          {},
          {},
          "convert the surface to NURBS first"};
}

/// Images of the axes: unit vectors, made orthonormal again, and their stretches.
struct MappedFrame {
  Frame frame;
  double sx, sy, sz;
  bool orthogonal;
};

MappedFrame mapped(const Frame& f, const Transform& t) {
  const Vec3 x = t.vector(f.x), y = t.vector(f.y), z = t.vector(f.z);
  MappedFrame m{{}, norm(x), norm(y), norm(z), false};
  constexpr double tolerance = 4e-12;
  m.orthogonal = m.sx > 0 && m.sy > 0 && m.sz > 0 && std::isfinite(m.sx + m.sy + m.sz) &&
                 std::abs(dot(x, y)) <= tolerance * m.sx * m.sy && std::abs(dot(y, z)) <= tolerance * m.sy * m.sz &&
                 std::abs(dot(z, x)) <= tolerance * m.sz * m.sx;
  m.frame.origin = t.point(f.origin);
  m.frame.z = normalized(z);
  m.frame.x = normalized(x - dot(x, m.frame.z) * m.frame.z);
  m.frame.y = cross(m.frame.z, m.frame.x);
  if (dot(m.frame.y, y) < 0) m.frame.y = -m.frame.y;
  return m;
}

bool alike(double a, double b) {
  return std::abs(a - b) <= 4e-12 * std::max(a, b);
}

}  // namespace

const char* Surface::kind() const {
  static constexpr const char* names[] = {"plane", "cylinder", "cone", "sphere", "torus"};
  if (const auto* f = get_if<FreeSurface>()) return free_form::kind(*f);
  return names[form_.index()];
}

Vec3 Surface::point(Vec2 uv) const {
  return dispatch(
      form_, [&](const auto& s) { return analytic::point(s, uv); },
      [&](const FreeSurface& s) { return free_form::point(s, uv); });
}

SurfaceJet Surface::jet(Vec2 uv) const {
  return dispatch(
      form_, [&](const auto& s) { return analytic::jet(s, uv); },
      [&](const FreeSurface& s) { return free_form::jet(s, uv); });
}

Vec3 Surface::normal(Vec2 uv) const {
  return dispatch(
      form_, [&](const auto& s) { return analytic::normal(s, uv); },
      [&](const FreeSurface& s) { return free_form::normal(s, uv); });
}

Vec2 Surface::period() const {
  static constexpr Vec2 periods[] = {{0, 0}, {two_pi, 0}, {two_pi, 0}, {two_pi, 0}, {two_pi, two_pi}};
  if (const auto* f = get_if<FreeSurface>()) return free_form::period(*f);
  return periods[form_.index()];
}

Range2 Surface::domain() const {
  static constexpr Range whole{-infinity, infinity}, turn{0, two_pi}, half{-analytic::pi / 2, analytic::pi / 2};
  static constexpr Range2 domains[] = {{whole, whole}, {turn, whole}, {turn, whole}, {turn, half}, {turn, turn}};
  if (const auto* f = get_if<FreeSurface>()) return free_form::domain(*f);
  return domains[form_.index()];
}

SurfaceProjection Surface::project(Vec3 p, const Vec2* hint) const {
  return dispatch(
      form_, [&](const auto& s) { return analytic::project(s, p, hint); },
      [&](const FreeSurface& s) { return free_form::project(s, p, hint); });
}

Box3 Surface::bounds(const Range2& piece) const {
  return dispatch(
      form_, [&](const auto& s) { return analytic::bounds(s, piece); },
      [&](const FreeSurface& s) { return free_form::bounds(s, piece); });
}

std::vector<LineHit> Surface::intersect(const Line& line, const Range2& near) const {
  if (!is_finite(line.origin) || !is_finite(line.direction)) return {};
  return dispatch(
      form_,
      [&](const auto& s) {
        std::vector<LineHit> hits;
        for (const double t : analytic::line_hits(s, line)) {
          hits.push_back({t, analytic::project(s, analytic::point(line, t), nullptr).uv});
        }
        return hits;
      },
      [&](const FreeSurface& s) { return free_form::intersect(s, line, near); });
}

Result<Surface> Surface::transformed(const Transform& t, Vec2* uv_scale) const {
  if (const auto* f = get_if<FreeSurface>()) return free_form::transformed(*f, t, uv_scale);
  const auto done = [&](Surface s, Vec2 scale) {
    if (uv_scale != nullptr) *uv_scale = scale;
    return Result<Surface>(std::move(s));
  };
  if (const auto* s = get_if<Plane>()) {
    // The image of z need not be the normal of the image.
    const Vec3 x = t.vector(s->frame.x), y = t.vector(s->frame.y);
    const double sx = norm(x), sy = norm(y);
    if (!(sx > 0 && sy > 0) || !std::isfinite(sx + sy) || std::abs(dot(x, y)) > 4e-12 * sx * sy)
      return bad_map("plane");
    Frame f{t.point(s->frame.origin), normalized(x), {}, {}};
    f.y = normalized(y - dot(y, f.x) * f.x);
    const Vec3 natural = cross(f.x, f.y);
    // z keeps its side of the material: for a left-handed frame it is opposite to the natural normal.
    const bool keeps = dot(t.vector(s->frame.z), natural) >= 0;
    f.z = keeps ? natural : -natural;
    return done(Plane{f}, {sx, sy});
  }
  const Frame& frame = std::visit(
      [](const auto& s) -> const Frame& {
        if constexpr (requires { s.frame; }) {
          return s.frame;
        } else {
          static const Frame none;
          return none;
        }
      },
      form_);
  const MappedFrame m = mapped(frame, t);
  if (!m.orthogonal || !alike(m.sx, m.sy)) return bad_map(kind());
  if (const auto* s = get_if<Cylinder>()) return done(Cylinder{m.frame, s->radius * m.sx}, {1, m.sz});
  if (const auto* s = get_if<Cone>()) {
    if (alike(m.sx, m.sz)) return done(Cone{m.frame, s->radius * m.sx, s->half_angle}, {1, m.sz});
    const double rise = m.sx * std::sin(s->half_angle), run = m.sz * std::cos(s->half_angle);
    return done(Cone{m.frame, s->radius * m.sx, std::atan2(rise, run)}, {1, std::hypot(rise, run)});
  }
  if (!alike(m.sx, m.sz)) return bad_map(kind());
  if (const auto* s = get_if<Sphere>()) return done(Sphere{m.frame, s->radius * m.sx}, {1, 1});
  const auto* s = get_if<Torus>();
  return done(Torus{m.frame, s->major * m.sx, s->minor * m.sx}, {1, 1});
}

NurbsSurfaceData Surface::to_nurbs(const Range2& piece) const {
  if (const auto* f = get_if<FreeSurface>()) return free_form::to_nurbs(*f, piece);
  return analytic::to_nurbs(*this, piece);
}

}  // namespace aresta
