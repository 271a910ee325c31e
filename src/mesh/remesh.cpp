// SPDX-License-Identifier: Apache-2.0
#include "mesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aresta::mesh {

namespace {

using Index = std::uint32_t;
using Corners = std::array<Index, 3>;

/// Triangles whose normal is within this cosine of the surface's are good; only worse ones may become worse no further.
constexpr double good_alignment = 0.5;
constexpr double split_above = 4.0 / 3, collapse_below = 0.8;  // times the wished size; Botsch and Kobbelt
constexpr int rounds = 6, polish_rounds = 6;

class Remesher {
 public:
  Remesher(const RemeshInput& input, const Context& context)
      : in_(input), context_(context), vertices_(input.vertices) {
    around_.resize(vertices_.size());
    sizes_.reserve(vertices_.size());
    for (const auto& v : vertices_) sizes_.push_back(in_.size(v.point));
    for (const auto& t : input.triangles) add(t);
    for (auto e : input.constrained) {
      if (e[0] > e[1]) std::swap(e[0], e[1]);
      constrained_.push_back(e);
    }
    std::sort(constrained_.begin(), constrained_.end());
  }

  Result<RemeshOutput> run() {
    flip_all();
    for (int round = 0; round < rounds; ++round) {
      ARESTA_CHECK(split_long());
      ARESTA_CHECK(collapse_short());
      flip_all();
      for (int sweep = 0; sweep < 2; ++sweep) smooth_all(round + 1 == rounds);
      ARESTA_CHECK(context_.step(static_cast<double>(round) / rounds, "surface mesh"));
      flip_all();
    }
    for (int round = 0; round < polish_rounds; ++round) {
      smooth_all(true);
      search_worst();
      const bool flipped = flip_all();
      ARESTA_CHECK(context_.step(1, "surface mesh"));
      if (!flipped && round > 2) break;
    }
    return pack();
  }

 private:
  // --- the triangulation ---

  Index add(const Corners& t) {
    const auto index = static_cast<Index>(triangles_.size());
    triangles_.push_back(t);
    alive_.push_back(1);
    for (const Index v : t) around_[v].push_back(index);
    return index;
  }

  void detach(Index t, Index v) {
    auto& list = around_[v];
    list.erase(std::find(list.begin(), list.end(), t));
  }

  void remove(Index t) {
    for (const Index v : triangles_[t]) detach(t, v);
    alive_[t] = 0;
  }

  static bool has(const Corners& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }
  static Index third(const Corners& t, Index a, Index b) {
    return t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
  }
  /// Does t run from a to b (rather than from b to a)?
  static bool runs(const Corners& t, Index a, Index b) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  }

  /// The two triangles of an edge that has exactly two; the first one runs from a to b.
  bool wings(Index a, Index b, Index& first, Index& second) const {
    int count = 0;
    Index found[2] = {0, 0};
    for (const Index t : around_[a]) {
      if (!has(triangles_[t], b)) continue;
      if (count == 2) return false;
      found[count++] = t;
    }
    if (count != 2) return false;
    first = found[0], second = found[1];
    if (!runs(triangles_[first], a, b)) std::swap(first, second);
    return runs(triangles_[first], a, b) && runs(triangles_[second], b, a);
  }

  bool connected(Index a, Index b) const {
    return std::any_of(around_[a].begin(), around_[a].end(), [&](Index t) { return has(triangles_[t], b); });
  }

  bool is_constrained(Index a, Index b) const {
    if (!vertices_[a].fixed || !vertices_[b].fixed) return false;
    return std::binary_search(constrained_.begin(), constrained_.end(),
                              std::array<Index, 2>{std::min(a, b), std::max(a, b)});
  }

  /// All edges with two triangles that may change, sorted.
  std::vector<std::array<Index, 2>> free_edges() const {
    std::vector<std::array<Index, 2>> edges;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!alive_[t]) continue;
      for (int i = 0; i < 3; ++i) {
        const Index a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b)});
      }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::array<Index, 2>> inner;
    for (std::size_t i = 0; i < edges.size();) {
      std::size_t end = i;
      while (end < edges.size() && edges[end] == edges[i]) ++end;
      if (end - i == 2 && !is_constrained(edges[i][0], edges[i][1])) inner.push_back(edges[i]);
      i = end;
    }
    return inner;
  }

  // --- measures ---

  Vec3 at(Index v) const { return vertices_[v].point; }
  double wished(Index a, Index b) const { return std::min(sizes_[a], sizes_[b]); }
  double relative_length(Index a, Index b) const { return distance(at(a), at(b)) / wished(a, b); }

  /// Cosine between the triangle's normal and the surface's, by the normals at its corners.
  double alignment(Vec3 area, const Corners& t) const {
    const Vec3 normal = vertices_[t[0]].normal + vertices_[t[1]].normal + vertices_[t[2]].normal;
    const double product = norm(area) * norm(normal);
    return product > 0 ? dot(area, normal) / product : (norm2(area) > 0 ? 1 : 0);
  }

  struct Score {
    double shape = 0, alignment = 0;
    /// Shape as long as the triangle looks the right way, below zero when it does not.
    double value() const { return alignment >= good_alignment ? shape : alignment - good_alignment; }
  };

  Score score(const Corners& t) const {
    const Vec3 a = at(t[0]), b = at(t[1]), c = at(t[2]);
    return {triangle_shape(a, b, c), alignment(area_vector(a, b, c), t)};
  }

  double worst_around(Index v) const {
    double worst = 1;
    for (const Index t : around_[v]) worst = std::min(worst, score(triangles_[t]).value());
    return worst;
  }

  // --- new places ---

  /// A vertex on the surface near p. `helpers` are vertices whose parameters may serve as a start.
  RemeshVertex place(Vec3 p, std::initializer_list<Index> helpers, double reach) const {
    RemeshVertex best;
    double best_distance = HUGE_VAL;
    // Parameters of free vertices are unambiguous, those of fixed ones may belong to the other side of a seam.
    for (const bool fixed : {false, true}) {
      for (const Index v : helpers) {
        if (vertices_[v].fixed != fixed) continue;
        Vec2 uv = vertices_[v].uv;
        const Vec3 q = in_.project(p, uv);
        const double d = distance(p, q);
        if (d < best_distance) best_distance = d, best.point = q, best.uv = uv;
        if (best_distance <= 0.2 * reach) break;
      }
      if (best_distance <= 0.2 * reach) break;
    }
    best.normal = in_.normal(best.uv);
    return best;
  }

  // --- operations ---

  Status split_long() {
    std::size_t done = 0;
    for (int pass = 0; pass < 40; ++pass) {
      auto edges = free_edges();
      std::vector<std::pair<double, std::array<Index, 2>>> too_long;
      for (const auto& e : edges) {
        const double length = relative_length(e[0], e[1]);
        if (length > split_above) too_long.emplace_back(-length, e);
      }
      if (too_long.empty()) break;
      std::sort(too_long.begin(), too_long.end());
      std::size_t count = 0;
      for (const auto& [length, e] : too_long) {
        // Only edges near the longest of their surroundings, so that shapes stay round.
        if (split(e[0], e[1])) ++count;
        if ((++done & 1023u) == 0) ARESTA_CHECK(context_.step(0, "surface mesh"));
      }
      if (count == 0) break;
    }
    return {};
  }

  bool split(Index a, Index b) {
    Index first, second;
    if (!wings(a, b, first, second)) return false;
    const Index c = third(triangles_[first], a, b), d = third(triangles_[second], a, b);
    const double length = distance(at(a), at(b));
    // A longer side of a neighbour goes first.
    for (const Index o : {c, d}) {
      for (const Index e : {a, b}) {
        Index x, y;
        if (distance(at(o), at(e)) > 1.2 * length && !is_constrained(o, e) && wings(o, e, x, y)) return false;
      }
    }
    const double before = std::min(score(triangles_[first]).alignment, score(triangles_[second]).alignment);
    const RemeshVertex middle = place(0.5 * (at(a) + at(b)), {a, b, c, d}, length);
    if (!is_finite(middle.point)) return false;
    const auto m = static_cast<Index>(vertices_.size());
    vertices_.push_back(middle);
    sizes_.push_back(in_.size(middle.point));
    around_.emplace_back();
    const Corners made[4] = {{a, m, c}, {m, b, c}, {b, m, d}, {m, a, d}};
    double after = 1;
    for (const auto& t : made) after = std::min(after, score(t).alignment);
    if (after < good_alignment && after < before) {
      vertices_.pop_back(), sizes_.pop_back(), around_.pop_back();
      return false;
    }
    remove(first), remove(second);
    for (const auto& t : made) add(t);
    return true;
  }

  Status collapse_short() {
    std::vector<std::pair<double, std::array<Index, 2>>> too_short;
    for (const auto& e : free_edges()) {
      const double length = relative_length(e[0], e[1]);
      if (length < collapse_below) too_short.emplace_back(length, e);
    }
    std::sort(too_short.begin(), too_short.end());
    std::size_t done = 0;
    for (const auto& [length, e] : too_short) {
      if ((++done & 1023u) == 0) ARESTA_CHECK(context_.step(0, "surface mesh"));
      if (around_[e[0]].empty() || around_[e[1]].empty() || !connected(e[0], e[1])) continue;
      if (relative_length(e[0], e[1]) >= collapse_below) continue;
      if (!collapse(e[0], e[1], 1.2)) collapse(e[1], e[0], 1.2);
    }
    return {};
  }

  /// Moves the free vertex v into w when topology and shape allow.
  bool collapse(Index v, Index w, double longest_allowed) {
    if (vertices_[v].fixed) return false;
    Index first, second;
    if (!wings(v, w, first, second)) return false;
    const Index c = third(triangles_[first], v, w), d = third(triangles_[second], v, w);
    if (c == d) return false;
    int common = 0;
    std::vector<Index> ring = neighbours(v);
    for (const Index n : ring) common += n != w && connected(n, w) ? 1 : 0;
    if (common != 2) return false;
    for (const Index o : {c, d}) {
      if (!vertices_[o].fixed && around_[o].size() <= 3) return false;
    }
    const double before = worst_around(v);
    double after = 1;
    for (const Index t : around_[v]) {
      if (t == first || t == second) continue;
      Corners moved = triangles_[t];
      for (Index& corner : moved) {
        if (corner == v) corner = w;
      }
      after = std::min(after, score(moved).value());
    }
    for (const Index n : ring) {
      if (n != w && n != c && n != d && relative_length(n, w) > longest_allowed) return false;
    }
    if (after < std::min(before, 0.25)) return false;
    remove(first), remove(second);
    const std::vector<Index> moving = around_[v];
    for (const Index t : moving) {
      for (Index& corner : triangles_[t]) {
        if (corner == v) corner = w;
      }
      around_[w].push_back(t);
    }
    around_[v].clear();
    return true;
  }

  std::vector<Index> neighbours(Index v) const {
    std::vector<Index> ring;
    for (const Index t : around_[v]) {
      for (const Index n : triangles_[t]) {
        if (n != v && std::find(ring.begin(), ring.end(), n) == ring.end()) ring.push_back(n);
      }
    }
    return ring;
  }

  bool flip_all() {
    bool any = false;
    for (int pass = 0; pass < 12; ++pass) {
      bool flipped = false;
      for (const auto& e : free_edges()) flipped = flip(e[0], e[1]) || flipped;
      any = any || flipped;
      if (!flipped) break;
    }
    return any;
  }

  /// Turns the edge when the worse of the two triangles becomes better.
  bool flip(Index a, Index b) {
    Index first, second;
    if (!wings(a, b, first, second)) return false;
    const Index c = third(triangles_[first], a, b), d = third(triangles_[second], a, b);
    if (c == d || connected(c, d)) return false;
    for (const Index v : {a, b}) {
      if (around_[v].size() <= 3 && !vertices_[v].fixed) return false;
    }
    const Corners left{c, d, b}, right{d, c, a};
    const double before = std::min(score(triangles_[first]).value(), score(triangles_[second]).value());
    const double after = std::min(score(left).value(), score(right).value());
    if (after <= before + 1e-9) return false;
    // first = (a, b, c), second = (b, a, d): c, d, b runs counterclockwise as a, d, b, c does.
    remove(first), remove(second);
    add({left[0], left[1], left[2]});
    add({right[0], right[1], right[2]});
    return true;
  }

  bool try_move(Index v, Vec3 target, double least) {
    const RemeshVertex old = vertices_[v];
    RemeshVertex moved = place(target, {v}, distance(target, old.point));
    if (!is_finite(moved.point)) return false;
    vertices_[v] = moved;
    if (worst_around(v) >= least) {
      sizes_[v] = in_.size(moved.point);
      return true;
    }
    vertices_[v] = old;
    return false;
  }

  /// Moves every free vertex towards the weighted mean of its triangles' centres. `strict`: only if its worst triangle
  /// does not get worse.
  void smooth_all(bool strict) {
    for (Index v = 0; v < vertices_.size(); ++v) {
      if (vertices_[v].fixed || around_[v].empty()) continue;
      Vec3 sum{};
      double weights = 0;
      for (const Index t : around_[v]) {
        const auto& c = triangles_[t];
        const double h = (sizes_[c[0]] + sizes_[c[1]] + sizes_[c[2]]) / 3;
        const double weight = norm(area_vector(at(c[0]), at(c[1]), at(c[2]))) / (h * h * h);
        sum += weight / 3 * (at(c[0]) + at(c[1]) + at(c[2]));
        weights += weight;
      }
      if (!(weights > 0)) continue;
      const Vec3 target = sum / weights;
      const double before = worst_around(v);
      const double least = strict ? before : std::min(before, 0.35);
      if (!try_move(v, target, least)) try_move(v, lerp(at(v), target, 0.5), least);
    }
  }

  /// Tries small tangential steps for the vertices of poor triangles.
  void search_worst() {
    constexpr double poor = 0.65;
    for (Index v = 0; v < vertices_.size(); ++v) {
      if (vertices_[v].fixed || around_[v].empty()) continue;
      double before = worst_around(v);
      if (before > poor) continue;
      double reach = 0;
      for (const Index n : neighbours(v)) reach += distance(at(v), at(n));
      reach /= static_cast<double>(around_[v].size());
      for (double step = 0.25 * reach; step > 0.01 * reach; step *= 0.5) {
        const Vec3 x = any_perpendicular(vertices_[v].normal), y = cross(vertices_[v].normal, x);
        const Vec3 centre = at(v);
        for (int k = 0; k < 8; ++k) {
          const double angle = k * std::numbers::pi / 4;
          if (try_move(v, centre + step * (std::cos(angle) * x + std::sin(angle) * y), before + 1e-4)) {
            before = worst_around(v);
            break;
          }
        }
      }
    }
  }

  RemeshOutput pack() const {
    RemeshOutput output;
    std::vector<Index> number(vertices_.size(), 0);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (!vertices_[v].fixed && around_[v].empty()) continue;
      number[v] = static_cast<Index>(output.vertices.size());
      output.vertices.push_back(vertices_[v]);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (alive_[t])
        output.triangles.push_back({number[triangles_[t][0]], number[triangles_[t][1]], number[triangles_[t][2]]});
    }
    return output;
  }

  const RemeshInput& in_;
  const Context& context_;
  std::vector<RemeshVertex> vertices_;
  std::vector<double> sizes_;
  std::vector<Corners> triangles_;
  std::vector<char> alive_;
  std::vector<std::vector<Index>> around_;
  std::vector<std::array<Index, 2>> constrained_;
};

}  // namespace

Result<RemeshOutput> remesh(const RemeshInput& input, const Context& context) {
  return Remesher(input, context).run();
}

}  // namespace aresta::mesh
