// SPDX-License-Identifier: Apache-2.0
#include "model/patch_detail.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "math/quadrature.h"

namespace aresta::model_detail {

namespace {

/// out += w (a b^T + b a^T) / 2, as xx, yy, zz, xy, yz, zx.
void add_product(double* out, Vec3 a, Vec3 b, double w) {
  out[0] += w * a.x * b.x;
  out[1] += w * a.y * b.y;
  out[2] += w * a.z * b.z;
  out[3] += 0.5 * w * (a.x * b.y + a.y * b.x);
  out[4] += 0.5 * w * (a.y * b.z + a.z * b.y);
  out[5] += 0.5 * w * (a.z * b.x + a.x * b.z);
}

void put(double* out, Vec3 a) {
  out[0] = a.x, out[1] = a.y, out[2] = a.z;
}

double handedness(const Frame& f) {
  return f.right_handed() ? 1 : -1;
}

/// A surface's frame with the origin seen from the reference, in units of size.
struct LocalFrame {
  Vec3 origin, radial, z;
};

LocalFrame local(const Frame& f, double u, const PatchOptions& o) {
  return {(f.origin - o.reference) / o.size, std::cos(u) * f.x + std::sin(u) * f.y, f.z};
}

void scale_flux(PatchMoments& m) {
  m[1] /= 3;
  for (int i = 2; i < 5; ++i) m[i] /= 4;
  for (int i = 5; i < 11; ++i) m[i] /= 5;
}

}  // namespace

Patch::Patch(const Surface& surface, const Range2& box, bool swapped, const PatchOptions& options)
    : surface_(surface), options_(options), swapped_(swapped) {
  constexpr double pi = std::numbers::pi;
  const Range along = swapped ? box.u : box.v;
  const bool empty = along.low > along.high;
  v0_ = empty ? 0 : along.middle();
  if (surface.get_if<Sphere>() != nullptr) {
    low_end = -pi / 2, high_end = pi / 2;
    closed = true;
  } else if (const auto* torus = surface.get_if<Torus>()) {
    closed = true;
    low_end = v0_ - pi, high_end = v0_ + pi;
    if (torus->minor > torus->major) {  // self-intersecting: the face lies on the outer or the inner part
      const double crossing = std::acos(-torus->major / torus->minor);
      sign_ = torus->major + torus->minor * std::cos(v0_) < 0 ? -1 : 1;
      const double turn = 2 * pi * std::round((v0_ - (sign_ < 0 ? pi : 0)) / (2 * pi));
      low_end = turn + (sign_ < 0 ? crossing : -crossing);
      high_end = turn + (sign_ < 0 ? 2 * pi - crossing : crossing);
    }
  } else if (const auto* cone = surface.get_if<Cone>()) {
    low_end = high_end = -cone->radius / std::sin(cone->half_angle);
    sign_ = v0_ < *low_end ? -1 : 1;
    start_at_singular_end(along, *low_end);
  } else if (surface.get_if<FreeSurface>() != nullptr) {
    const Range2 domain = surface.domain();
    const Range d = swapped ? domain.u : domain.v, across = swapped ? domain.v : domain.u;
    const Vec2 period = surface.period();
    const double period_along = swapped ? period.x : period.y;
    if (empty) v0_ = d.middle();
    const auto at = [&](double u, double v) { return swapped ? Vec2{v, u} : Vec2{u, v}; };
    const auto collapsed = [&](double v) {
      if (!std::isfinite(v) || !std::isfinite(across.low) || !std::isfinite(across.high)) return false;
      const Vec3 p = surface.point(at(across.low, v));
      for (int i = 1; i <= 4; ++i) {
        if (distance(p, surface.point(at(across.at(i * 0.23), v))) > 1e-9 * options.size) return false;
      }
      return true;
    };
    if (period_along > 0) {
      low_end = v0_ - 0.5 * period_along, high_end = v0_ + 0.5 * period_along;
      closed = (swapped ? period.y : period.x) > 0;
    } else {
      if (collapsed(d.low)) low_end = d.low;
      if (collapsed(d.high)) high_end = d.high;
      if (high_end && !empty) start_at_singular_end(along, *high_end);
      if (low_end && !empty) start_at_singular_end(along, *low_end);
      closed = low_end && high_end && (swapped ? period.y : period.x) > 0;
    }
    if (std::string_view(surface.kind()) == "nurbs" && std::isfinite(domain.u.length()) &&
        std::isfinite(domain.v.length())) {
      const NurbsSurfaceData data = surface.to_nurbs(domain);
      knots_ = swapped ? data.knots_u : data.knots_v;
      breaks_ = swapped ? data.knots_v : data.knots_u;
      breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
      period_ = swapped ? period.y : period.x;
      if (period_along > 0) {
        const std::vector<double> once = knots_;
        for (const double turn : {-1.0, 1.0}) {
          for (const double k : once) knots_.push_back(k + turn * period_along);
        }
        std::sort(knots_.begin(), knots_.end());
      }
    }
  }
}

// Near an apex or pole the image of an edge means little: an edge that misses the point by a rounding runs half around
// it. Strips that start there are empty there, so that it does not matter.
void Patch::start_at_singular_end(Range along, double end) {
  const double near = 1e-3 * along.length();
  if (std::abs(along.low - end) <= near || std::abs(along.high - end) <= near) v0_ = end;
}

std::vector<double> Patch::breaks(double from, double to) const {
  std::vector<double> found;
  const double low = std::min(from, to), high = std::max(from, to);
  for (const double k : breaks_) {
    const double first = period_ > 0 ? k + period_ * std::ceil((low - k) / period_) : k;
    for (double u = first; u < high; u += period_) {
      if (u > low) found.push_back(u);
      if (!(period_ > 0)) break;
    }
  }
  std::sort(found.begin(), found.end());
  // The ends of a period are one place.
  const double near = 1e-9 * (high - low);
  found.erase(std::unique(found.begin(), found.end(), [&](double a, double b) { return b - a < near; }), found.end());
  if (from > to) std::reverse(found.begin(), found.end());
  return found;
}

PatchMoments Patch::strip(double u, double v) const {
  if (surface_.get_if<Cylinder>() != nullptr || surface_.get_if<Cone>() != nullptr) return ruled(u, v);
  if (surface_.get_if<Sphere>() != nullptr || surface_.get_if<Torus>() != nullptr) return round(u, v);
  return free(u, v);
}

// q = a + w d with w = v - v0; density of flux k0 + k1 w, of area a0 + a1 w.
PatchMoments Patch::ruled(double u, double v) const {
  const double size = options_.size;
  Vec3 a, d;
  double k0 = 0, k1 = 0, a0 = 0, a1 = 0;
  const double w = (v - v0_) / size;
  if (const auto* s = surface_.get_if<Cylinder>()) {
    const LocalFrame f = local(s->frame, u, options_);
    const double r = s->radius / size;
    a = f.origin + r * f.radial + (v0_ / size) * f.z;
    d = f.z;
    k0 = handedness(s->frame) * r * dot(a, f.radial);
    a0 = r;
  } else {
    const auto& cone = *surface_.get_if<Cone>();
    const LocalFrame f = local(cone.frame, u, options_);
    const double sn = std::sin(cone.half_angle), cs = std::cos(cone.half_angle);
    const double p0 = v0_ / size + cone.radius / size / sn;  // v0 from the apex
    d = sn * f.radial + cs * f.z;
    a = f.origin + (cone.radius / size) * f.radial + (v0_ / size) * d;
    const Vec3 apex = a - p0 * d;
    // Normal at distance p from the apex: p m. The part along d vanishes, so q.m = apex.m.
    const double k = dot(apex, handedness(cone.frame) * sn * (cs * f.radial - sn * f.z));
    k0 = k * p0, k1 = k;
    a0 = std::abs(p0 * sn), a1 = sign_ * std::abs(sn);
  }
  PatchMoments m{};
  m[0] = w * (a0 + 0.5 * w * a1);
  const double f0 = options_.flux ? k0 : a0, f1 = options_.flux ? k1 : a1;
  const double i0 = w * (f0 + w * f1 / 2), i1 = w * w * (f0 / 2 + w * f1 / 3), i2 = w * w * w * (f0 / 3 + w * f1 / 4);
  m[1] = i0;
  put(&m[2], i0 * a + i1 * d);
  add_product(&m[5], a, a, i0);
  add_product(&m[5], a, d, 2 * i1);
  add_product(&m[5], d, d, i2);
  if (options_.flux) scale_flux(m);
  return m;
}

// q = a + cos v d + sin v e; the densities are polynomials in cos v and sin v.
PatchMoments Patch::round(double u, double v) const {
  const double size = options_.size;
  double major = 0, r = 0;
  const Frame* frame = nullptr;
  if (const auto* s = surface_.get_if<Sphere>()) {
    r = s->radius / size;
    frame = &s->frame;
  } else {
    const auto& torus = *surface_.get_if<Torus>();
    major = torus.major / size, r = torus.minor / size;
    frame = &torus.frame;
  }
  const LocalFrame f = local(*frame, u, options_);
  const Vec3 a = f.origin + major * f.radial, d = r * f.radial, e = r * f.z;

  // Integrals of cos(k v) and sin(k v), without cancellation where v is near v0.
  const double t = v - v0_, middle = 0.5 * (v + v0_);
  double c[5], s[5];
  for (int k = 1; k <= 4; ++k) {
    const double chord = 2.0 / k * std::sin(0.5 * k * t);
    c[k] = std::cos(k * middle) * chord;
    s[k] = std::sin(k * middle) * chord;
  }
  // j[a][b]: integral of cos^a sin^b.
  const double j[5][5] = {{t, s[1], (t - c[2]) / 2, (3 * s[1] - s[3]) / 4, (3 * t - 4 * c[2] + c[4]) / 8},
                          {c[1], s[2] / 2, (c[1] - c[3]) / 4, (2 * s[2] - s[4]) / 8, 0},
                          {(t + c[2]) / 2, (s[1] + s[3]) / 4, (t - c[4]) / 8, 0, 0},
                          {(3 * c[1] + c[3]) / 4, (2 * s[2] + s[4]) / 8, 0, 0, 0},
                          {(3 * t + 4 * c[2] + c[4]) / 8, 0, 0, 0, 0}};
  const double a0 = sign_ * r * major, a1 = sign_ * r * r;  // area density a0 + a1 cos v
  double p00 = a0, p10 = a1, p01 = 0, p20 = 0, p11 = 0;
  if (options_.flux) {
    const double h = handedness(*frame) * r, x = dot(a, f.radial), z = dot(a, f.z);
    p00 = h * major * r;
    p10 = h * (major * x + r * r);
    p01 = h * major * z;
    p20 = h * r * x;
    p11 = h * r * z;
  }
  const auto integral = [&](int p, int q) {
    double sum = p00 * j[p][q] + p10 * j[p + 1][q];
    if (options_.flux) sum += p01 * j[p][q + 1] + p20 * j[p + 2][q] + p11 * j[p + 1][q + 1];
    return sum;
  };
  const double i00 = integral(0, 0), i10 = integral(1, 0), i01 = integral(0, 1), i20 = integral(2, 0),
               i11 = integral(1, 1), i02 = integral(0, 2);
  PatchMoments m{};
  m[0] = a0 * t + a1 * c[1];
  m[1] = i00;
  put(&m[2], i00 * a + i10 * d + i01 * e);
  add_product(&m[5], a, a, i00);
  add_product(&m[5], a, d, 2 * i10);
  add_product(&m[5], a, e, 2 * i01);
  add_product(&m[5], d, d, i20);
  add_product(&m[5], d, e, 2 * i11);
  add_product(&m[5], e, e, i02);
  if (options_.flux) scale_flux(m);
  return m;
}

PatchMoments Patch::free(double u, double v) const {
  const double size = options_.size;
  const auto density = [&](double w) {
    const SurfaceJet jet = surface_.jet(swapped_ ? Vec2{w, u} : Vec2{u, w});
    const Vec3 q = (jet.point - options_.reference) / size;
    const Vec3 n = cross(jet.du, jet.dv) / (size * size);
    PatchMoments m{};
    m[0] = norm(n);
    const double k = options_.flux ? dot(q, n) : m[0];
    m[1] = k;
    put(&m[2], k * q);
    add_product(&m[5], q, q, k);
    return m;
  };
  PatchMoments sum{};
  double error = 0;
  const auto piece = [&](double from, double to) {
    const auto part = integrate(
        density, from, to, QuadratureOptions{.absolute = 1e-15, .relative = options_.relative, .max_intervals = 40});
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part.value[i];
    error += part.error;
  };
  const double low = std::min(v0_, v), high = std::max(v0_, v);
  double from = low;
  for (const double k : knots_) {
    if (k <= from || k >= high) continue;
    piece(from, k);
    from = k;
  }
  if (high > from) piece(from, high);
  if (v < v0_) {
    for (double& x : sum) x = -x;
  }
  worst_ = std::max(worst_, error);
  if (options_.flux) scale_flux(sum);
  return sum;
}

}  // namespace aresta::model_detail
