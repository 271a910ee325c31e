// SPDX-License-Identifier: Apache-2.0
#include "geometry/bezier_patches.h"

#include <Geom_BSplineSurface.hxx>
#include <algorithm>
#include <array>

#include "geometry/analytic.h"
#include "geometry/free_eval.h"
#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"

namespace aresta {

namespace {

std::vector<BezierPatch> cut(const Handle(Geom_BSplineSurface) & given) {
  const Handle(Geom_BSplineSurface) s = Handle(Geom_BSplineSurface)::DownCast(given->Copy());
  s->SetUNotPeriodic();
  s->SetVNotPeriodic();
  double u0, u1, v0, v1;
  s->Bounds(u0, u1, v0, v1);
  s->Segment(u0, u1, v0, v1);  // clamps the ends
  const int p = s->UDegree(), q = s->VDegree();
  if (s->NbUKnots() > 2) s->IncreaseUMultiplicity(2, s->NbUKnots() - 1, p);
  if (s->NbVKnots() > 2) s->IncreaseVMultiplicity(2, s->NbVKnots() - 1, q);
  std::vector<BezierPatch> patches;
  for (int a = 0; a + 1 < s->NbUKnots(); ++a) {
    for (int b = 0; b + 1 < s->NbVKnots(); ++b) {
      BezierPatch patch;
      patch.domain = {{s->UKnot(a + 1), s->UKnot(a + 2)}, {s->VKnot(b + 1), s->VKnot(b + 2)}};
      patch.degree_u = p;
      patch.degree_v = q;
      for (int i = 0; i <= p; ++i) {
        for (int j = 0; j <= q; ++j) {
          const Vec3 pole = occt::vec(s->Pole(a * p + i + 1, b * q + j + 1));
          const double w = s->Weight(a * p + i + 1, b * q + j + 1);
          patch.box.add(pole);
          patch.weighted.push_back(w * pole);
          patch.weights.push_back(w);
        }
      }
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

/// Does the line come within `slack` of the box?
bool reaches(const Line& line, const Box3& box, double slack) {
  double low = -analytic::infinity, high = analytic::infinity;
  for (int i = 0; i < 3; ++i) {
    const double from = box.low[i] - slack - line.origin[i], to = box.high[i] + slack - line.origin[i];
    const double d = line.direction[i];
    if (std::abs(d) < 1e-300) {
      if (from > 0 || to < 0) return false;
      continue;
    }
    low = std::max(low, std::min(from / d, to / d));
    high = std::min(high, std::max(from / d, to / d));
  }
  return low <= high * (1 + 1e-12 * (high > 0 ? 1 : -1)) + slack;
}

/// The patch seen along the line: two Bezier coefficient nets over a cell of [0, 1]^2.
struct Cell {
  double u0, u1, v0, v1;
  std::vector<Vec2> net;
};

class Search {
 public:
  Search(const BezierPatch& patch, const Surface& evaluate, const Line& line, double noise, std::vector<PatchHit>& hits)
      : patch_(patch), evaluate_(evaluate), line_(line), noise_(noise), hits_(hits) {
    n1_ = any_perpendicular(line.direction);
    n2_ = cross(line.direction, n1_);
    nu_ = patch.degree_u + 1;
    nv_ = patch.degree_v + 1;
    least_weight_ = *std::min_element(patch.weights.begin(), patch.weights.end());
    most_weight_ = *std::max_element(patch.weights.begin(), patch.weights.end());
    size_ = patch.box.diagonal();
  }

  void run() {
    Cell whole{0, 1, 0, 1, {}};
    for (std::size_t k = 0; k < patch_.weights.size(); ++k) {
      const Vec3 d = patch_.weighted[k] - patch_.weights[k] * line_.origin;
      whole.net.push_back({dot(n1_, d), dot(n2_, d)});
    }
    std::vector<Cell> todo;
    todo.push_back(std::move(whole));
    std::vector<PatchHit> touches;
    int budget = 8000;
    while (!todo.empty() && --budget > 0) {
      const Cell c = std::move(todo.back());
      todo.pop_back();
      if (misses(c)) continue;
      if (single_root(c)) {
        if (const auto hit = newton(c, false)) {
          hits_.push_back(*hit);
          continue;
        }
      }
      // Smaller than this a root that is not transversal is a touch, if it is one at all.
      if (extent(c) <= 1e-7 * size_ || c.u1 - c.u0 < 1e-12 || c.v1 - c.v0 < 1e-12) {
        if (const auto hit = newton(c, true)) touches.push_back(*hit);
        continue;
      }
      split(c, todo);
    }
    // When the budget is gone the line runs inside the surface: what looked like touches are not isolated.
    if (budget > 0) hits_.insert(hits_.end(), touches.begin(), touches.end());
  }

 private:
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(nv_) + static_cast<std::size_t>(j);
  }

  /// The hull lies to one side of one of eight lines through the origin.
  bool misses(const Cell& c) const {
    const double slack = noise_ * most_weight_;
    static constexpr std::array<Vec2, 8> sides = {{{1, 0},
                                                   {0, 1},
                                                   {0.70710678118654752, 0.70710678118654752},
                                                   {0.70710678118654752, -0.70710678118654752},
                                                   {0.92387953251128674, 0.38268343236508977},
                                                   {0.38268343236508977, 0.92387953251128674},
                                                   {0.92387953251128674, -0.38268343236508977},
                                                   {0.38268343236508977, -0.92387953251128674}}};
    for (const Vec2 side : sides) {
      double low = analytic::infinity, high = -analytic::infinity;
      for (const Vec2 b : c.net) {
        const double d = dot(side, b);
        low = std::min(low, d);
        high = std::max(high, d);
      }
      if (low > slack || high < -slack) return true;
    }
    return false;
  }

  double extent(const Cell& c) const {
    Vec2 low = c.net[0], high = c.net[0];
    for (const Vec2 b : c.net) {
      low = {std::min(low.x, b.x), std::min(low.y, b.y)};
      high = {std::max(high.x, b.x), std::max(high.y, b.y)};
    }
    return (std::abs(high.x - low.x) + std::abs(high.y - low.y)) / least_weight_;
  }

  /// With the inverse of the middle Jacobian in front, is the Jacobian diagonally dominant all over the cell? Then the
  /// map is one to one there.
  bool single_root(const Cell& c) const {
    Vec2 du{}, dv{};
    for (int j = 0; j < nv_; ++j) du += (c.net[at(nu_ - 1, j)] - c.net[at(0, j)]) / nv_;
    for (int i = 0; i < nu_; ++i) dv += (c.net[at(i, nv_ - 1)] - c.net[at(i, 0)]) / nu_;
    const double det = cross(du, dv);
    if (!(std::abs(det) > 1e-9 * norm(du) * norm(dv))) return false;
    const auto ahead = [&](Vec2 d) {  // inverse of [du dv]
      return Vec2{cross(d, dv) / det, cross(du, d) / det};
    };
    double uu = analytic::infinity, vv = analytic::infinity, uv = 0, vu = 0;
    for (int i = 0; i + 1 < nu_; ++i) {
      for (int j = 0; j < nv_; ++j) {
        const Vec2 g = (nu_ - 1) * ahead(c.net[at(i + 1, j)] - c.net[at(i, j)]);
        uu = std::min(uu, g.x);
        vu = std::max(vu, std::abs(g.y));
      }
    }
    for (int i = 0; i < nu_; ++i) {
      for (int j = 0; j + 1 < nv_; ++j) {
        const Vec2 g = (nv_ - 1) * ahead(c.net[at(i, j + 1)] - c.net[at(i, j)]);
        vv = std::min(vv, g.y);
        uv = std::max(uv, std::abs(g.x));
      }
    }
    return uu > uv && vv > vu;
  }

  /// Newton (or, for touches, Gauss-Newton with damping) from the cell's middle; the answer must lie in the cell.
  std::optional<PatchHit> newton(const Cell& c, bool touch) const {
    const Range2& d = patch_.domain;
    const Range2 cell{{d.u.at(c.u0), d.u.at(c.u1)}, {d.v.at(c.v0), d.v.at(c.v1)}};
    const double margin = touch ? 20 : 1e-9;
    const double mu = margin * cell.u.length() + 1e-13 * d.u.length(),
                 mv = margin * cell.v.length() + 1e-13 * d.v.length();
    const Range2 wide{{cell.u.low - mu, cell.u.high + mu}, {cell.v.low - mv, cell.v.high + mv}};
    Vec2 w{cell.u.middle(), cell.v.middle()};
    Vec2 best = w;
    double least = analytic::infinity;
    for (int i = 0; i < 40; ++i) {
      const SurfaceJet j = evaluate_.jet(w);
      const Vec3 r = j.point - line_.origin;
      const Vec2 f{dot(n1_, r), dot(n2_, r)};
      if (norm(f) < least) {
        least = norm(f);
        best = w;
      } else if (i > 8) {
        break;
      }
      const Vec2 a{dot(n1_, j.du), dot(n2_, j.du)}, b{dot(n1_, j.dv), dot(n2_, j.dv)};
      const double det = cross(a, b);
      Vec2 step;
      if (std::abs(det) > 1e-6 * norm(a) * norm(b)) {
        step = Vec2{-cross(f, b), -cross(a, f)} / det;
      } else {
        // Nearly dependent columns: the shortest step of least squares.
        const double e = dot(a, a), g = dot(b, b), m = dot(a, b), damp = 1e-10 * (e + g);
        const double normal = (e + damp) * (g + damp) - m * m;
        if (!(normal > 0)) break;
        const double fa = -dot(a, f), fb = -dot(b, f);
        step = Vec2{fa * (g + damp) - fb * m, fb * (e + damp) - fa * m} / normal;
      }
      const Vec2 next{wide.u.clamp(w.x + step.x), wide.v.clamp(w.y + step.y)};
      if (next == w) break;
      w = next;
    }
    if (!(least <= noise_)) return std::nullopt;
    // Inside the patch, to rounding.
    const double pu = 1e-12 * d.u.length(), pv = 1e-12 * d.v.length();
    if (best.x < d.u.low - pu || best.x > d.u.high + pu || best.y < d.v.low - pv || best.y > d.v.high + pv) {
      return std::nullopt;
    }
    best = {d.u.clamp(best.x), d.v.clamp(best.y)};
    return PatchHit{best, dot(evaluate_.point(best) - line_.origin, line_.direction), touch};
  }

  void split(const Cell& c, std::vector<Cell>& todo) const {
    // The direction along which the net is longer, halved.
    double lu = 0, lv = 0;
    for (int i = 0; i < nu_; ++i) {
      for (int j = 0; j < nv_; ++j) {
        if (i + 1 < nu_) lu = std::max(lu, distance(c.net[at(i, j)], c.net[at(i + 1, j)]) * (nu_ - 1));
        if (j + 1 < nv_) lv = std::max(lv, distance(c.net[at(i, j)], c.net[at(i, j + 1)]) * (nv_ - 1));
      }
    }
    const bool along_u = lu >= lv;
    Cell low = c, high = c;
    const int n = along_u ? nu_ : nv_, lines = along_u ? nv_ : nu_;
    const auto index = [&](int k, int line) { return along_u ? at(k, line) : at(line, k); };
    std::vector<Vec2> row(static_cast<std::size_t>(n));
    for (int line = 0; line < lines; ++line) {
      for (int k = 0; k < n; ++k) row[static_cast<std::size_t>(k)] = c.net[index(k, line)];
      for (int level = 0; level < n; ++level) {
        low.net[index(level, line)] = row[0];
        high.net[index(n - 1 - level, line)] = row[static_cast<std::size_t>(n - 1 - level)];
        for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(n - level); ++k) row[k] = 0.5 * (row[k] + row[k + 1]);
      }
    }
    if (along_u) {
      low.u1 = high.u0 = 0.5 * (c.u0 + c.u1);
    } else {
      low.v1 = high.v0 = 0.5 * (c.v0 + c.v1);
    }
    todo.push_back(std::move(high));
    todo.push_back(std::move(low));
  }

  const BezierPatch& patch_;
  const Surface& evaluate_;
  const Line& line_;
  double noise_, size_ = 0, least_weight_ = 1, most_weight_ = 1;
  std::vector<PatchHit>& hits_;
  Vec3 n1_, n2_;
  int nu_ = 0, nv_ = 0;
};

}  // namespace

std::vector<BezierPatch> bezier_patches(const FreeSurface& surface, const Range2& piece) {
  return occt::guarded(
      [&] {
        if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface.handle().surface)) return cut(spline);
        const auto made = FreeSurface::from_nurbs(free_form::to_nurbs(surface, piece));
        if (!made.ok()) return std::vector<BezierPatch>{};
        return cut(Handle(Geom_BSplineSurface)::DownCast(made->handle().surface));
      },
      std::vector<BezierPatch>{});
}

void line_meets_patch(const BezierPatch& patch, const Surface& evaluate, const Line& line, double noise,
                      std::vector<PatchHit>& hits) {
  if (!reaches(line, patch.box, noise)) return;
  Search(patch, evaluate, line, noise, hits).run();
}

}  // namespace aresta
