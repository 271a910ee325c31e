// SPDX-License-Identifier: Apache-2.0
#include "math/plane_triangulation.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace aresta {

namespace {

constexpr int nobody = -1;
constexpr int next3[3] = {1, 2, 0};
constexpr int previous3[3] = {2, 0, 1};

/// Sign of a sum of doubles, by exact growth of an expansion.
double exact_sum(const double* terms, int count) {
  double expansion[16];
  int size = 0;
  for (int i = 0; i < count; ++i) {
    double q = terms[i];
    int kept = 0;
    for (int j = 0; j < size; ++j) {
      const double sum = q + expansion[j];
      const double part = sum - q;
      const double error = (q - (sum - part)) + (expansion[j] - part);
      q = sum;
      if (error != 0) expansion[kept++] = error;
    }
    if (q != 0) expansion[kept++] = q;
    size = kept;
  }
  return size == 0 ? 0 : expansion[size - 1];
}

struct Triangle {
  int v[3];
  int n[3];            ///< across the side opposite to v[i]
  bool fixed[3] = {};  ///< that side is a segment
};

struct Side {
  int triangle = nobody, index = 0;
};

class Triangulation {
 public:
  explicit Triangulation(const PlaneInput& input) : input_(input), points_(input.points) {}

  PlaneOutput run() {
    PlaneOutput output;
    const int count = static_cast<int>(points_.size());
    enclose();
    for (int p = 0; p < count && bad_ == nobody; ++p) insert(p);
    for (const auto& s : input_.segments) {
      if (bad_ != nobody) break;
      recover(static_cast<int>(s[0]), static_cast<int>(s[1]));
    }
    if (bad_ == nobody) select(output);
    if (bad_ != nobody) {
      output.triangles.clear();
      output.bad_point = static_cast<std::uint32_t>(std::min(bad_, std::max(0, count - 1)));
    }
    return output;
  }

 private:
  Vec2 at(int p) const { return points_[static_cast<std::size_t>(p)]; }
  Triangle& tri(int t) { return triangles_[static_cast<std::size_t>(t)]; }

  void enclose() {
    Vec2 low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
    for (const Vec2& p : points_) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double size = points_.empty() ? 1 : std::max({high.x - low.x, high.y - low.y, 1e-300});
    const Vec2 centre = points_.empty() ? Vec2{} : 0.5 * (low + high);
    first_outer_ = static_cast<int>(points_.size());
    points_.push_back(centre + Vec2{-60 * size, -40 * size});
    points_.push_back(centre + Vec2{60 * size, -40 * size});
    points_.push_back(centre + Vec2{0, 80 * size});
    triangles_.push_back({{first_outer_, first_outer_ + 1, first_outer_ + 2}, {nobody, nobody, nobody}});
    some_triangle_.assign(points_.size(), nobody);
    for (std::size_t i = 0; i < 3; ++i) some_triangle_[static_cast<std::size_t>(first_outer_) + i] = 0;
  }

  int locate(Vec2 p) {
    int t = last_;
    for (std::size_t steps = 0; steps < 4 * triangles_.size() + 16; ++steps) {
      int towards = nobody;
      for (int i = 0; i < 3 && towards == nobody; ++i) {
        // The first side tried varies with the step, so that a walk cannot circle for ever.
        const int k = (i + static_cast<int>(steps)) % 3;
        if (orient2d(at(tri(t).v[next3[k]]), at(tri(t).v[previous3[k]]), p) < 0) towards = tri(t).n[k];
      }
      if (towards == nobody) return t;
      t = towards;
    }
    for (t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      bool inside = true;
      for (int k = 0; k < 3; ++k)
        inside = inside && orient2d(at(tri(t).v[next3[k]]), at(tri(t).v[previous3[k]]), p) >= 0;
      if (inside) return t;
    }
    return last_;
  }

  /// Replaces, in the neighbour `t`, the neighbour `from` by `to`.
  void relink(int t, int from, int to) {
    if (t == nobody) return;
    for (int& n : tri(t).n) {
      if (n == from) {
        n = to;
        return;
      }
    }
  }

  void note(int t) {
    for (const int v : tri(t).v) some_triangle_[static_cast<std::size_t>(v)] = t;
  }

  void insert(int p) {
    const int t = locate(at(p));
    last_ = t;
    int on_side = nobody;
    for (int k = 0; k < 3; ++k) {
      if (at(tri(t).v[k]) == at(p)) {
        bad_ = p;
        return;
      }
      if (orient2d(at(tri(t).v[next3[k]]), at(tri(t).v[previous3[k]]), at(p)) == 0) on_side = k;
    }
    std::vector<Side> doubtful;
    if (on_side == nobody) {
      const Triangle old = tri(t);
      const int b = static_cast<int>(triangles_.size()), c = b + 1;
      triangles_.resize(triangles_.size() + 2);
      tri(t) = {{p, old.v[0], old.v[1]}, {old.n[2], b, c}};
      tri(b) = {{p, old.v[1], old.v[2]}, {old.n[0], c, t}};
      tri(c) = {{p, old.v[2], old.v[0]}, {old.n[1], t, b}};
      relink(old.n[0], t, b);
      relink(old.n[1], t, c);
      for (const int i : {t, b, c}) note(i), doubtful.push_back({i, 0});
    } else {
      split_side(t, on_side, p, doubtful);
    }
    legalise(doubtful);
  }

  void split_side(int t, int k, int p, std::vector<Side>& doubtful) {
    const int other = tri(t).n[k];
    const Triangle old = tri(t);
    const int apex = old.v[k], left = old.v[next3[k]], right = old.v[previous3[k]];
    const int b = static_cast<int>(triangles_.size());
    triangles_.resize(triangles_.size() + (other == nobody ? 1 : 2));
    const int c = other == nobody ? nobody : b + 1;
    tri(t) = {{p, apex, left}, {old.n[previous3[k]], other, b}};
    tri(b) = {{p, right, apex}, {old.n[next3[k]], t, c}};
    relink(old.n[next3[k]], t, b);
    if (other != nobody) {
      const Triangle was = tri(other);
      int j = 0;
      while (was.n[j] != t) ++j;
      const int far = was.v[j];  // next: right, previous: left
      tri(other) = {{p, left, far}, {was.n[next3[j]], c, t}};
      tri(c) = {{p, far, right}, {was.n[previous3[j]], b, other}};
      relink(was.n[previous3[j]], other, c);
      note(other), note(c);
      doubtful.push_back({other, 0});
      doubtful.push_back({c, 0});
    }
    note(t), note(b);
    doubtful.push_back({t, 0});
    doubtful.push_back({b, 0});
  }

  bool in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) const {
    const Vec2 p = a - d, q = b - d, r = c - d;
    const double pp = dot(p, p), qq = dot(q, q), rr = dot(r, r);
    const double value = pp * cross(q, r) - qq * cross(p, r) + rr * cross(p, q);
    const double size = pp * (std::abs(q.x * r.y) + std::abs(q.y * r.x)) +
                        qq * (std::abs(p.x * r.y) + std::abs(p.y * r.x)) +
                        rr * (std::abs(p.x * q.y) + std::abs(p.y * q.x));
    return value > 1e-14 * size;
  }

  /// Turns the diagonal of the two triangles at side k of t; they must form a strictly convex quadrilateral.
  /// Afterwards t = (a, b', c') keeps its corner k first.
  void flip(int t, int k) {
    const int o = tri(t).n[k];
    const Triangle x = tri(t), y = tri(o);
    int j = 0;
    while (y.n[j] != t) ++j;
    const int a = x.v[k], l = x.v[next3[k]], r = x.v[previous3[k]], d = y.v[j];
    tri(t) = {{a, l, d}, {y.n[next3[j]], o, x.n[previous3[k]]}, {y.fixed[next3[j]], false, x.fixed[previous3[k]]}};
    tri(o) = {{a, d, r}, {y.n[previous3[j]], x.n[next3[k]], t}, {y.fixed[previous3[j]], x.fixed[next3[k]], false}};
    relink(y.n[next3[j]], o, t);
    relink(x.n[next3[k]], t, o);
    note(t), note(o);
  }

  bool convex(int t, int k) {
    const int o = tri(t).n[k];
    int j = 0;
    while (tri(o).n[j] != t) ++j;
    const Vec2 a = at(tri(t).v[k]), l = at(tri(t).v[next3[k]]), r = at(tri(t).v[previous3[k]]), d = at(tri(o).v[j]);
    return orient2d(a, l, d) > 0 && orient2d(a, d, r) > 0;
  }

  void legalise(std::vector<Side>& doubtful) {
    std::size_t budget = 100 * triangles_.size() + 1000;
    while (!doubtful.empty() && budget-- > 0) {
      const Side side = doubtful.back();
      doubtful.pop_back();
      const int o = tri(side.triangle).n[side.index];
      if (o == nobody || tri(side.triangle).fixed[side.index]) continue;
      int j = 0;
      while (tri(o).n[j] != side.triangle) ++j;
      const auto& v = tri(side.triangle).v;
      if (!in_circle(at(v[0]), at(v[1]), at(v[2]), at(tri(o).v[j])) || !convex(side.triangle, side.index)) continue;
      flip(side.triangle, side.index);
      doubtful.push_back({side.triangle, 0});
      doubtful.push_back({o, 0});
    }
  }

  /// Calls visit(triangle, index of p in it) round p until it answers true.
  template <class Visit>
  bool around(int p, Visit visit) {
    const int start = some_triangle_[static_cast<std::size_t>(p)];
    int t = start;
    do {
      int k = 0;
      while (tri(t).v[k] != p) ++k;
      if (visit(t, k)) return true;
      t = tri(t).n[next3[k]];
    } while (t != start && t != nobody);
    return false;
  }

  /// The side from a to b (to the left of it lies the triangle); nobody when there is none.
  Side find(int a, int b) {
    Side found;
    around(a, [&](int t, int k) {
      if (tri(t).v[next3[k]] != b) return false;
      found = {t, previous3[k]};
      return true;
    });
    return found;
  }

  void fix(Side side) {
    const int o = tri(side.triangle).n[side.index];
    tri(side.triangle).fixed[side.index] = true;
    if (o == nobody) return;
    for (int j = 0; j < 3; ++j) {
      if (tri(o).n[j] == side.triangle) tri(o).fixed[j] = true;
    }
  }

  void recover(int a, int b) {
    if (a == b) {
      bad_ = a;
      return;
    }
    if (const Side side = find(a, b); side.triangle != nobody) {
      fix(side);
      return;
    }
    std::deque<std::array<int, 2>> crossing;
    if (!collect_crossing(a, b, crossing)) return;
    std::size_t budget = 50 * (crossing.size() + 10) * (crossing.size() + 10);
    while (!crossing.empty()) {
      if (budget-- == 0) {
        bad_ = a;
        return;
      }
      const auto [p, q] = crossing.front();
      crossing.pop_front();
      const Side side = find(p, q);
      if (side.triangle == nobody) continue;
      if (!convex(side.triangle, side.index)) {
        crossing.push_back({p, q});
        continue;
      }
      const int o = tri(side.triangle).n[side.index];
      const int c = tri(side.triangle).v[side.index];
      int j = 0;
      while (tri(o).n[j] != side.triangle) ++j;
      const int d = tri(o).v[j];
      flip(side.triangle, side.index);
      const bool ends = c == a || c == b || d == a || d == b;
      if (!ends && (orient2d(at(a), at(b), at(c)) > 0) != (orient2d(at(a), at(b), at(d)) > 0))
        crossing.push_back({c, d});
    }
    const Side side = find(a, b);
    if (side.triangle == nobody) {
      bad_ = a;
    } else {
      fix(side);
    }
  }

  /// All sides that the segment crosses, from a to b, left end first. False (and bad_ set) at a point or segment on the
  /// way.
  bool collect_crossing(int a, int b, std::deque<std::array<int, 2>>& crossing) {
    Side entry;
    const bool started = around(a, [&](int t, int k) {
      const int r = tri(t).v[next3[k]], l = tri(t).v[previous3[k]];
      const double side_r = orient2d(at(a), at(b), at(r)), side_l = orient2d(at(a), at(b), at(l));
      if (side_r == 0 && dot(at(r) - at(a), at(b) - at(a)) > 0) {
        bad_ = r;
        return true;
      }
      if (side_r < 0 && side_l > 0) {
        entry = {t, k};
        return true;
      }
      return false;
    });
    if (!started) bad_ = a;
    while (bad_ == nobody) {
      const int r = tri(entry.triangle).v[next3[entry.index]], l = tri(entry.triangle).v[previous3[entry.index]];
      if (tri(entry.triangle).fixed[entry.index]) {
        bad_ = r;
        break;
      }
      crossing.push_back({r, l});
      const int o = tri(entry.triangle).n[entry.index];
      int j = 0;
      while (tri(o).n[j] != entry.triangle) ++j;
      const int d = tri(o).v[j];
      if (d == b) return true;
      const double side = orient2d(at(a), at(b), at(d));
      if (side == 0) {
        bad_ = d;
      } else {
        // In o the side (l, r) has l next after d. Go on through (r, d) when d is left, through (d, l) when d is right.
        entry = {o, side > 0 ? next3[j] : previous3[j]};
      }
    }
    return false;
  }

  void select(PlaneOutput& output) {
    auto segments = input_.segments;
    std::sort(segments.begin(), segments.end());
    const auto has = [&](int a, int b) {
      return std::binary_search(
          segments.begin(), segments.end(),
          std::array<std::uint32_t, 2>{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    };
    std::vector<char> seen(triangles_.size(), 0);
    for (int seed = 0; seed < static_cast<int>(triangles_.size()); ++seed) {
      if (seen[static_cast<std::size_t>(seed)]) continue;
      std::vector<int> component{seed};
      seen[static_cast<std::size_t>(seed)] = 1;
      int inside = nobody, outside = nobody;  // a corner that tells
      for (std::size_t i = 0; i < component.size(); ++i) {
        const int t = component[i];
        for (int k = 0; k < 3; ++k) {
          const int a = tri(t).v[next3[k]], b = tri(t).v[previous3[k]];
          const bool forward = has(a, b), backward = has(b, a);
          if (forward && !backward) inside = a;
          if (backward && !forward) outside = a;
          if (tri(t).n[k] == nobody) outside = tri(t).v[k];
          if (forward != backward || tri(t).n[k] == nobody) continue;
          const auto n = static_cast<std::size_t>(tri(t).n[k]);
          if (!seen[n]) seen[n] = 1, component.push_back(tri(t).n[k]);
        }
      }
      if (inside != nobody && outside != nobody) {
        bad_ = inside;
        return;
      }
      if (inside == nobody) continue;
      for (const int t : component) {
        output.triangles.push_back({static_cast<std::uint32_t>(tri(t).v[0]), static_cast<std::uint32_t>(tri(t).v[1]),
                                    static_cast<std::uint32_t>(tri(t).v[2])});
      }
    }
  }

  const PlaneInput& input_;
  std::vector<Vec2> points_;
  std::vector<Triangle> triangles_;
  std::vector<int> some_triangle_;
  int first_outer_ = 0, last_ = 0, bad_ = nobody;
};

}  // namespace

double orient2d(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double value = left - right;
  // Bound of the rounding error: J. R. Shewchuk, Discrete & Computational Geometry 18 (1997), first stage.
  if (std::abs(value) > 3.3306690738754716e-16 * (std::abs(left) + std::abs(right))) return value;
  double terms[12];
  int count = 0;
  const auto add = [&](double x, double y) {
    const double product = x * y;
    terms[count++] = std::fma(x, y, -product);
    terms[count++] = product;
  };
  add(a.x, b.y), add(-a.x, c.y), add(-c.x, b.y), add(-a.y, b.x), add(a.y, c.x), add(c.y, b.x);
  return exact_sum(terms, count);
}

PlaneOutput triangulate_plane(const PlaneInput& input) {
  return Triangulation(input).run();
}

}  // namespace aresta
