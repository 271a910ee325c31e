// SPDX-License-Identifier: Apache-2.0
#include <Geom_OffsetSurface.hxx>

#include "geometry/analytic.h"
#include "geometry/fit.h"
#include "geometry/nurbs_bound.h"
#include "geometry/occt_handles.h"
#include "geometry/recognize.h"

namespace aresta {

namespace {

constexpr long evaluation_budget = 5'000'000;
constexpr int grid = 12;  ///< cells per direction; samples lie in their middles, away from degenerate sides

/// What all candidates share: the piece, its samples, and its NURBS form once one candidate passes the samples.
struct Patch {
  const Surface& surface;
  Range2 piece;
  double tolerance, size = 0, noise = 0;
  fit::Samples samples;
  std::optional<NurbsSurfaceData> data = {};
  std::optional<Surface> nurbs = {};

  Vec3 at(double u, double v) const { return surface.point({piece.u.at(u), piece.v.at(v)}); }
  SurfaceJet jet_at(double u, double v) const { return surface.jet({piece.u.at(u), piece.v.at(v)}); }

  bool convert() {
    if (nurbs) return true;
    data = surface.to_nurbs(piece);
    if (data->degree_u == 0 || data->periodic_u || data->periodic_v) return false;
    auto made = FreeSurface::from_nurbs(*data);
    if (!made.ok()) return false;
    nurbs = Surface(*made);
    Box3 box;
    for (const Vec3 q : data->poles) box.add(q);
    noise = 16 * analytic::epsilon * (norm(box.low) + norm(box.high));
    return true;
  }
};

bool sampled_within(const Patch& p, const Surface& s) {
  for (const Vec3 q : p.samples.points) {
    if (!(s.project(q).distance <= p.tolerance)) return false;
  }
  return true;
}

/// Bound of the distance, from an implicit function of degree k and what its value says about the distance. A piece
/// whose bound is too large is split only when that can help: `splits` says so (the bound of a cone grows tighter off
/// its apex).
template <class F, class Height, class Distance>
std::optional<double> proven(Patch& p, int k, F&& f, Height&& height, Distance&& distance_for, bool splits = false) {
  if (!p.convert()) return std::nullopt;
  double deviation = 0;
  const bool done = bound_over(
      *p.data, k, evaluation_budget, [&](Vec2 uv) { return p.nurbs->point(uv); }, f, height,
      [&](double bound, double low, double high) {
        const double here = distance_for(bound, low, high) + p.noise;
        if (here <= p.tolerance || !splits) deviation = std::max(deviation, here);
        return here <= p.tolerance || !splits;
      });
  if (!done || !(deviation <= p.tolerance)) return std::nullopt;
  return deviation;
}

template <class F, class Distance>
std::optional<double> proven(Patch& p, int k, F&& f, Distance&& distance_for) {
  return proven(
      p, k, f, [](Vec3) { return 0.0; }, [&](double bound, double, double) { return distance_for(bound); });
}

/// Which parameter runs round the axis, and how.
struct Rotation {
  bool around_u = true;
  Vec3 start{};          ///< a point where that parameter is lowest
  Vec3 forward{};        ///< derivative along the other parameter, in the middle
  double sense = 1;      ///< of the growth round the axis
  double full_turn = 0;  ///< angle gone round, unsigned
};

Rotation rotation(const Patch& p, const Frame& axis) {
  Rotation r;
  const SurfaceJet mid = p.jet_at(0.5, 0.5);
  const Vec3 d = mid.point - axis.origin;
  const Vec3 around = normalized(cross(axis.z, d - dot(d, axis.z) * axis.z));
  const double lu = norm(mid.du), lv = norm(mid.dv);
  const double ru = lu > 0 ? dot(mid.du, around) / lu : 0, rv = lv > 0 ? dot(mid.dv, around) / lv : 0;
  r.around_u = std::abs(ru) >= std::abs(rv);
  r.sense = (r.around_u ? ru : rv) < 0 ? -1 : 1;
  r.forward = r.around_u ? mid.dv : mid.du;
  r.start = r.around_u ? p.at(0, 0.5) : p.at(0.5, 0);
  double last = 0;
  for (int i = 0; i <= 4 * grid; ++i) {
    const double s = i / (4.0 * grid);
    const Vec3 l = axis.to_local(r.around_u ? p.at(s, 0.5) : p.at(0.5, s));
    const double angle = std::atan2(l.y, l.x);
    const double next = i == 0 ? angle : analytic::angle_near(angle, last);
    if (i > 0) r.full_turn += std::abs(next - last);
    last = next;
  }
  return r;
}

/// The frame at `origin` about `axis` with x towards the start of the piece.
Frame seamed(Vec3 origin, Vec3 axis, Vec3 start) {
  const Vec3 z = normalized(axis), d = start - origin;
  const Vec3 x = d - dot(d, z) * z;
  if (!(norm(x) > 1e-9 * norm(d))) return Frame::along(origin, z);
  return Frame::along(origin, z, x);
}

std::optional<RecognizedSurface> as_plane(Patch& p) {
  const auto fitted = fit::plane(p.samples.points);
  if (!fitted || !sampled_within(p, *fitted) || !p.convert()) return std::nullopt;
  Frame f = fitted->frame;
  double deviation = 0;
  for (const Vec3 q : p.data->poles) deviation = std::max(deviation, std::abs(dot(q - f.origin, f.z)) + p.noise);
  if (!(deviation <= p.tolerance)) return std::nullopt;
  const SurfaceJet corner = p.jet_at(0, 0), mid = p.jet_at(0.5, 0.5);
  const Vec3 natural = cross(mid.du, mid.dv);
  const Vec3 z = dot(natural, f.z) < 0 ? -f.z : f.z;
  if (!(norm(mid.du - dot(mid.du, z) * z) > 0)) return std::nullopt;
  const Vec3 foot = corner.point - dot(corner.point - f.origin, z) * z;
  f = Frame::along(foot, z, mid.du);
  // Unit speed along x and y keeps the parameters, with the origin where they are zero.
  if (std::abs(norm(mid.du) - 1) < 1e-6 && std::abs(norm(mid.dv) - 1) < 1e-6) {
    f.origin = f.origin - p.piece.u.low * f.x - p.piece.v.low * f.y;
  }
  return RecognizedSurface{Plane{f}, deviation, false, true};
}

/// Directions from the centre to collapsed sides, or the axis that the parameter lines show, else one that keeps the
/// piece away from the poles.
Vec3 sphere_axis(const Patch& p, Vec3 centre) {
  const auto side = [&](int which, double s) {
    switch (which) {
      case 0:
        return p.at(s, 0);
      case 1:
        return p.at(s, 1);
      case 2:
        return p.at(0, s);
      default:
        return p.at(1, s);
    }
  };
  for (const int which : {1, 0, 3, 2}) {
    bool collapsed = true;
    for (int i = 1; i <= 4; ++i) collapsed = collapsed && distance(side(which, 0), side(which, i / 4.0)) <= p.tolerance;
    if (collapsed) return (which % 2 == 1 ? 1.0 : -1.0) * (side(which, 0) - centre);
  }
  const auto normal_of = [&](bool along_u, double other) -> Vec3 {
    std::vector<Vec3> line;
    for (int i = 0; i <= 16; ++i) line.push_back(along_u ? p.at(i / 16.0, other) : p.at(other, i / 16.0));
    const auto c = fit::circle(line);
    return c ? c->frame.z : Vec3{};
  };
  for (const bool along_u : {true, false}) {
    const Vec3 a = normal_of(along_u, 0.25), b = normal_of(along_u, 0.75);
    if (a != Vec3{} && b != Vec3{} && norm(cross(a, b)) < 1e-5) return a;
  }
  const SurfaceJet mid = p.jet_at(0.5, 0.5);
  const Vec3 out = normalized(mid.point - centre);
  const Vec3 up = mid.dv - dot(mid.dv, out) * out;
  return norm(up) > 0 ? up : any_perpendicular(out);
}

std::optional<RecognizedSurface> as_sphere(Patch& p) {
  const auto fitted = fit::sphere(p.samples.points);
  if (!fitted || !(fitted->radius > p.tolerance) || fitted->radius > 1e5 * p.size || !sampled_within(p, *fitted)) {
    return std::nullopt;
  }
  const Vec3 centre = fitted->frame.origin;
  const double r = fitted->radius;
  const auto deviation = proven(
      p, 2,
      [&](Vec3 q) {
        const double n = distance(q, centre);
        return (n - r) * (n + r);
      },
      [&](double f) { return f / r; });
  if (!deviation) return std::nullopt;
  Vec3 axis = sphere_axis(p, centre);
  Rotation turn = rotation(p, Frame::along(centre, axis));
  if (turn.full_turn > analytic::two_pi * (1 + 1e-6)) return std::nullopt;
  const Vec3 mid = p.at(0.5, 0.5) - centre;
  // Away from parallels and meridians: the seam goes opposite to the middle of the piece.
  const bool closed = turn.full_turn > analytic::two_pi * (1 - 1e-6);
  const Vec3 start = closed || turn.full_turn > analytic::pi ? turn.start : centre - mid;
  if (dot(turn.forward, axis) < 0) axis = -axis;
  return RecognizedSurface{Sphere{seamed(centre, axis, start), r}, *deviation, false, true};
}

std::optional<RecognizedSurface> as_cylinder(Patch& p) {
  const auto fitted = fit::cylinder(p.samples);
  if (!fitted || !(fitted->radius > p.tolerance) || fitted->radius > 1e5 * p.size || !sampled_within(p, *fitted)) {
    return std::nullopt;
  }
  const Frame& f = fitted->frame;
  const double r = fitted->radius;
  const auto deviation = proven(
      p, 2,
      [&](Vec3 q) {
        const double n = norm(cross(q - f.origin, f.z));
        return (n - r) * (n + r);
      },
      [&](double value) { return value / r; });
  if (!deviation) return std::nullopt;
  const Rotation turn = rotation(p, f);
  if (turn.full_turn > analytic::two_pi * (1 + 1e-6)) return std::nullopt;
  const Vec3 axis = dot(turn.forward, f.z) < 0 ? -f.z : f.z;
  const Vec3 origin = f.origin + dot(p.at(0, 0) - f.origin, f.z) * f.z;
  return RecognizedSurface{Cylinder{seamed(origin, axis, turn.start), r}, *deviation, false, true};
}

std::optional<RecognizedSurface> as_cone(Patch& p) {
  auto fitted = fit::cone(p.samples);
  if (!fitted || !sampled_within(p, *fitted)) return std::nullopt;
  if (fitted->half_angle < 0) {
    fitted->half_angle = -fitted->half_angle;
    fitted->frame.z = -fitted->frame.z;
    fitted->frame.y = -fitted->frame.y;
  }
  const Vec3 axis = fitted->frame.z;
  const double sn = std::sin(fitted->half_angle), cs = std::cos(fitted->half_angle);
  const Vec3 apex = fitted->frame.origin - fitted->radius * cs / sn * axis;
  // Steeper than this the axis is far away, flatter is a plane: neither is anybody's cone.
  if (sn < 1e-5 || cs < 1e-5) return std::nullopt;
  const auto factors = [&](Vec3 q) {
    const Vec3 d = q - apex;
    const double h = dot(d, axis), rho = norm(d - h * axis);
    return std::pair{cs * rho - sn * std::abs(h), cs * rho + sn * std::abs(h)};
  };
  const auto deviation = proven(
      p, 2,
      [&](Vec3 q) {
        const auto [near, far] = factors(q);
        return near * far;
      },
      [&](Vec3 q) { return dot(q - apex, axis); },
      [&](double f, double low, double high) {
        // |near| = F / far with far >= sin |height|, and near^2 <= F.
        const double far = sn * (low > 0 ? low : high < 0 ? -high : 0);
        return std::min(std::sqrt(f), far > 0 ? f / far : analytic::infinity);
      },
      true);
  if (!deviation) return std::nullopt;
  const Rotation turn = rotation(p, {apex, fitted->frame.x, fitted->frame.y, axis});
  if (turn.full_turn > analytic::two_pi * (1 + 1e-6)) return std::nullopt;
  double lowest = analytic::infinity;
  for (const double u : {0.0, 0.5, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0}) lowest = std::min(lowest, dot(p.at(u, v) - apex, axis));
  }
  if (lowest * sn / cs <= 10 * p.tolerance) lowest = 0;  // an apex that is a side of the piece, or inside
  return RecognizedSurface{Cone{seamed(apex + lowest * axis, axis, turn.start), lowest * sn / cs, fitted->half_angle},
                           *deviation, false, true};
}

std::optional<RecognizedSurface> as_torus(Patch& p) {
  const auto fitted = fit::torus(p.samples);
  if (!fitted || !(fitted->minor > p.tolerance) || fitted->major > 1e5 * p.size || !sampled_within(p, *fitted)) {
    return std::nullopt;
  }
  const Frame& f = fitted->frame;
  const double big = fitted->major, small = fitted->minor;
  // The implicit quartic is the product of these two squared-distance differences; the first is at least r times the
  // distance, the second at least R^2 - r^2.
  const auto deviation = proven(
      p, 4,
      [&](Vec3 q) {
        const Vec3 d = q - f.origin;
        const double h = dot(d, f.z), rho = norm(d - h * f.z);
        const double inner = std::hypot(rho - big, h), outer = std::hypot(rho + big, h);
        return (inner - small) * (inner + small) * (outer - small) * (outer + small);
      },
      [&](double value) { return value / (small * (big - small) * (big + small)); });
  if (!deviation) return std::nullopt;
  const Rotation turn = rotation(p, f);
  if (turn.full_turn > analytic::two_pi * (1 + 1e-6)) return std::nullopt;
  return RecognizedSurface{Torus{seamed(f.origin, turn.sense * f.z, turn.start), big, small}, *deviation, false, true};
}

/// The offset of an analytic form is one, with the same parameters; of a cone, on the nappe where the radius is
/// positive.
std::optional<Surface> offset_form(const Surface& basis, const Range2& piece, double d) {
  if (const auto* s = basis.get_if<Plane>()) {
    Plane moved = *s;
    moved.frame.origin += d * analytic::normal(*s, {});
    return Surface(moved);
  }
  std::optional<Surface> result;
  if (const auto* s = basis.get_if<Cylinder>()) {
    const double r = s->radius + analytic::handedness(s->frame) * d;
    if (r > 0) result = Cylinder{s->frame, r};
  } else if (const auto* c = basis.get_if<Cone>()) {
    const double out = analytic::handedness(c->frame) * d;
    Cone moved = *c;
    moved.radius += out * std::cos(c->half_angle);
    moved.frame.origin -= out * std::sin(c->half_angle) * c->frame.z;
    const double sn = std::sin(c->half_angle);
    const double least = c->radius + std::min(piece.v.low * sn, piece.v.high * sn);
    if (moved.radius >= 0 && least >= 0 && least + out * std::cos(c->half_angle) >= 0) result = moved;
  } else if (const auto* b = basis.get_if<Sphere>()) {
    const double r = b->radius + analytic::handedness(b->frame) * d;
    if (r > 0) result = Sphere{b->frame, r};
  } else if (const auto* t = basis.get_if<Torus>()) {
    const double r = t->minor + analytic::handedness(t->frame) * d;
    if (r > 0 && r < t->major && t->minor < t->major) result = Torus{t->frame, t->major, r};
  }
  return result;
}

/// Do the natural normals agree (+1), disagree (-1), or change sides (0: the piece folds)?
int normal_sense(const Patch& p, const Surface& form) {
  int sense = 0;
  for (std::size_t i = 0; i < p.samples.points.size(); ++i) {
    const double d = dot(p.samples.normals[i], form.normal(form.project(p.samples.points[i]).uv));
    if (std::abs(d) < 0.2) continue;
    const int here = d > 0 ? 1 : -1;
    if (sense != 0 && here != sense) return 0;
    sense = here;
  }
  return sense;
}

}  // namespace

std::optional<RecognizedSurface> recognize_piece(const Surface& surface, const Range2& piece, double tolerance) {
  const auto bounded = [](Range r) { return std::isfinite(r.low) && std::isfinite(r.high) && r.low < r.high; };
  if (!(tolerance > 0) || !bounded(piece.u) || !bounded(piece.v)) return std::nullopt;
  const auto* free = surface.get_if<FreeSurface>();
  if (free == nullptr) return RecognizedSurface{surface, 0, true, true};
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(free->handle().surface)) {
    const auto form = offset_form(from_occt(offset->BasisSurface()), piece, offset->Offset());
    if (!form) return std::nullopt;
    return RecognizedSurface{*form, 0, true, true};
  }
  Patch p{surface, piece, tolerance, 0, 0, {}};
  Box3 box;
  for (int i = 0; i < grid; ++i) {
    for (int j = 0; j < grid; ++j) {
      const Vec2 uv{piece.u.at((i + 0.5) / grid), piece.v.at((j + 0.5) / grid)};
      p.samples.points.push_back(surface.point(uv));
      p.samples.normals.push_back(surface.normal(uv));
      if (!is_finite(p.samples.points.back()) || !is_finite(p.samples.normals.back())) return std::nullopt;
      box.add(p.samples.points.back());
    }
  }
  p.size = box.diagonal();
  if (!(p.size > 4 * tolerance)) return std::nullopt;
  std::optional<RecognizedSurface> found = as_plane(p);
  if (!found) found = as_cylinder(p);
  if (!found) found = as_sphere(p);
  if (!found) found = as_cone(p);
  if (!found) found = as_torus(p);
  if (!found) return std::nullopt;
  const int sense = normal_sense(p, found->surface);
  if (sense == 0) return std::nullopt;
  found->same_normal = sense > 0;
  found->same_parameters = true;
  for (int i = 0; i <= grid && found->same_parameters; ++i) {
    for (int j = 0; j <= grid; ++j) {
      const Vec2 uv{piece.u.at(static_cast<double>(i) / grid), piece.v.at(static_cast<double>(j) / grid)};
      if (!(distance(found->surface.point(uv), surface.point(uv)) <= tolerance)) {
        found->same_parameters = false;
        break;
      }
    }
  }
  return found;
}

std::optional<Surface> recognize(const Surface& surface, const Range2& piece, double tolerance) {
  auto found = recognize_piece(surface, piece, tolerance);
  if (!found) return std::nullopt;
  return std::move(found->surface);
}

}  // namespace aresta
