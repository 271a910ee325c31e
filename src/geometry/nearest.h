// SPDX-License-Identifier: Apache-2.0
// Nearest parameters on smooth curves and surfaces given by their derivatives; the search behind free-form projection.
#pragma once

#include <cmath>

#include "geometry/curve.h"
#include "geometry/surface.h"

namespace aresta::nearest {

/// Local minimum of |c(t) - p| on [low, high] from `start`. Newton on the derivative of the squared distance; a step
/// that does not lessen the distance is replaced by halving, and the ends are minima too. `jet` gives point, d1, d2.
template <class Jet>
CurveProjection on_curve(Jet&& jet, Vec3 p, double start, double low, double high) {
  double t = std::min(std::max(start, low), high);
  CurveJet j = jet(t);
  double square = norm2(j.point - p);
  for (int i = 0; i < 60; ++i) {
    const Vec3 r = j.point - p;
    const double slope = dot(r, j.d1), speed2 = norm2(j.d1);
    if (slope == 0 || (slope > 0 && t == low) || (slope < 0 && t == high)) break;
    const double curvature = speed2 + dot(r, j.d2);
    // Newton where the squared distance is convex; else a Gauss-Newton step, downhill in any case.
    double step = curvature > 0.1 * speed2 ? -slope / curvature : speed2 > 0 ? -slope / speed2 : 0;
    if (step == 0) break;
    double next = std::min(std::max(t + step, low), high);
    bool better = false;
    CurveJet k;
    for (int halving = 0; halving < 40 && next != t; ++halving) {
      k = jet(next);
      const double candidate = norm2(k.point - p);
      // Near the minimum rounding hides progress in the distance; the slope still shows it.
      const double slope_next = dot(k.point - p, k.d1);
      if (candidate < square || (candidate <= square * (1 + 1e-14) && std::abs(slope_next) < std::abs(slope))) {
        better = true;
        square = candidate;
        break;
      }
      step *= 0.5;
      next = std::min(std::max(t + step, low), high);
    }
    if (!better) break;
    const double moved = std::abs(next - t);
    t = next;
    j = k;
    if (moved <= 1e-16 * std::max(std::abs(t), high - low)) break;
  }
  return {t, j.point, std::sqrt(norm2(j.point - p))};
}

struct OnSurface {
  SurfaceProjection projection;
  bool converged = false;
};

/// Local minimum of |s(u, v) - p| in the box from `start`: damped Newton with the full Hessian where it is positive
/// definite, else Gauss-Newton; a parameter at its bound with the gradient pointing outwards is held there.
template <class Jet>
OnSurface on_surface(Jet&& jet, Vec3 p, Vec2 start, const Range2& box) {
  const auto clamp = [&](Vec2 w) { return Vec2{box.u.clamp(w.x), box.v.clamp(w.y)}; };
  Vec2 w = clamp(start);
  SurfaceJet j = jet(w);
  double square = norm2(j.point - p);
  OnSurface result;
  for (int i = 0; i < 80; ++i) {
    const Vec3 r = j.point - p;
    double gu = dot(r, j.du), gv = dot(r, j.dv);
    const bool hold_u = (w.x == box.u.low && gu > 0) || (w.x == box.u.high && gu < 0);
    const bool hold_v = (w.y == box.v.low && gv > 0) || (w.y == box.v.high && gv < 0);
    if (hold_u) gu = 0;
    if (hold_v) gv = 0;
    const double e = norm2(j.du), f = dot(j.du, j.dv), g = norm2(j.dv);
    // The angle between the residual and the tangents, both relative to sizes, tells the end.
    const double size = std::sqrt(square), slack = 1e-15 * (norm(j.point) + norm(p));
    if (std::abs(gu) <= 1e-14 * std::sqrt(e) * size + slack * std::sqrt(e) * 0.5 &&
        std::abs(gv) <= 1e-14 * std::sqrt(g) * size + slack * std::sqrt(g) * 0.5) {
      result.converged = true;
      break;
    }
    double huu = e + dot(r, j.duu), huv = f + dot(r, j.duv), hvv = g + dot(r, j.dvv);
    const bool convex = huu > 0 && hvv > 0 && huu * hvv - huv * huv > 1e-3 * huu * hvv;
    if (!convex) huu = e * (1 + 1e-6), huv = f, hvv = g * (1 + 1e-6);
    Vec2 step{};
    if (hold_u || !(huu > 0)) {
      if (!hold_v && hvv > 0) step.y = -gv / hvv;
    } else if (hold_v || !(hvv > 0)) {
      step.x = -gu / huu;
    } else {
      const double det = huu * hvv - huv * huv;
      if (det > 0) {
        step = {(-gu * hvv + gv * huv) / det, (-gv * huu + gu * huv) / det};
      } else {
        step = {-gu / huu, -gv / hvv};
      }
    }
    if (step == Vec2{} || !std::isfinite(step.x) || !std::isfinite(step.y)) break;
    bool better = false;
    Vec2 next = clamp(w + step);
    SurfaceJet k;
    const double before = std::abs(gu) * std::sqrt(g) + std::abs(gv) * std::sqrt(e);
    for (int halving = 0; halving < 30 && next != w; ++halving) {
      k = jet(next);
      const Vec3 rk = k.point - p;
      const double candidate = norm2(rk);
      if (candidate < square) {
        better = true;
      } else if (candidate <= square * (1 + 1e-14) + slack * slack) {
        const double after = (hold_u ? 0 : std::abs(dot(rk, k.du))) * std::sqrt(g) +
                             (hold_v ? 0 : std::abs(dot(rk, k.dv))) * std::sqrt(e);
        better = after < before;
      }
      if (better) {
        square = candidate;
        break;
      }
      step = 0.5 * step;
      next = clamp(w + step);
    }
    if (!better) {
      // No step helps: at the minimum as far as doubles can tell, if the gradient is small.
      result.converged = std::abs(gu) <= 1e-9 * std::sqrt(e) * size + 4 * slack * std::sqrt(e) &&
                         std::abs(gv) <= 1e-9 * std::sqrt(g) * size + 4 * slack * std::sqrt(g);
      break;
    }
    w = next;
    j = k;
  }
  result.projection = {w, j.point, std::sqrt(norm2(j.point - p))};
  return result;
}

}  // namespace aresta::nearest
