// SPDX-License-Identifier: Apache-2.0
#include "planar/arrangement.h"

#include <algorithm>

#include "base/union_find.h"
#include "planar/errors.h"

namespace aresta::planar {

namespace {

struct Box2 {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool contains(Vec2 p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
};

class Arranging {
 public:
  explicit Arranging(const FaceDrawing& drawing) : in_(drawing) {}

  Result<std::vector<FaceCell>> run() {
    sort_about_vertices();
    trace_cycles();
    ARESTA_CHECK(find_components());
    nest_components();
    ARESTA_CHECK(wind());
    place_points();
    return collect();
  }

 private:
  // Half-edge 2 i runs line i from a to b, 2 i + 1 back.
  Index start(Index h) const { return h % 2 == 0 ? in_.lines[h / 2].a : in_.lines[h / 2].b; }
  Index end(Index h) const { return start(h ^ 1u); }
  Vec2 direction(Index h) const { return in_.points[end(h)] - in_.points[start(h)]; }

  void sort_about_vertices() {
    std::vector<IndexPair> pairs;
    for (Index h = 0; h < 2 * in_.lines.size(); ++h) pairs.emplace_back(start(h), h);
    out_ = group(in_.points.size(), pairs);
    place_.resize(pairs.size());
    for (std::size_t v = 0; v < in_.points.size(); ++v) {
      const auto first = out_.items.begin() + out_.begin[v], last = out_.items.begin() + out_.begin[v + 1];
      std::sort(first, last, [&](Index g, Index h) {
        const Vec2 a = direction(g), b = direction(h);
        const bool upper_a = a.y > 0 || (a.y == 0 && a.x > 0), upper_b = b.y > 0 || (b.y == 0 && b.x > 0);
        if (upper_a != upper_b) return upper_a;
        const double turn = cross(a, b);
        return turn != 0 ? turn > 0 : g < h;
      });
    }
    for (Index i = 0; i < out_.items.size(); ++i) place_[out_.items[i]] = i;
  }

  /// The half-edge that keeps the same cell to its left.
  Index next(Index h) const {
    const Index twin = h ^ 1u, v = start(twin), i = place_[twin];
    return out_.items[i == out_.begin[v] ? out_.begin[v + 1] - 1 : i - 1];
  }

  void trace_cycles() {
    cycle_of_.assign(2 * in_.lines.size(), none);
    for (Index h = 0; h < cycle_of_.size(); ++h) {
      if (cycle_of_[h] != none) continue;
      Cycle cycle;
      cycle.first = h;
      const Vec2 origin = in_.points[start(h)];
      Index g = h;
      do {
        cycle_of_[g] = static_cast<Index>(cycles_.size());
        cycle.area += cross(in_.points[start(g)] - origin, in_.points[end(g)] - origin);
        cycle.box.add(in_.points[start(g)]);
        g = next(g);
      } while (g != h);
      cycles_.push_back(cycle);
    }
  }

  /// Each component has one cycle round its outside.
  Status find_components() {
    UnionFind parts(in_.points.size());
    for (const auto& line : in_.lines) parts.unite(line.a, line.b);
    component_of_.assign(in_.points.size(), none);
    for (Index v = 0; v < in_.points.size(); ++v) component_of_[v] = parts.find(v);
    std::vector<Index> outside(in_.points.size(), none);
    for (Index c = 0; c < cycles_.size(); ++c) {
      Index& known = outside[component_of_[start(cycles_[c].first)]];
      if (cycles_[c].area > 0) continue;
      if (known != none) return failed(cycles_[c].first);
      known = c;
      cycles_[c].outer = false;
    }
    for (Index c = 0; c < cycles_.size(); ++c) {
      if (cycles_[c].outer && outside[component_of_[start(cycles_[c].first)]] == none) return failed(cycles_[c].first);
    }
    return {};
  }

  Error failed(Index h) const {
    return Error{errors::planar_unresolved,
                 "the pieces in a face cross each other near piece " + std::to_string(in_.lines[h / 2].piece)};
  }

  /// The smallest cell of another component that holds the point, or none.
  Index cell_around(Vec2 p, Index component) const {
    Index best = none;
    for (Index c = 0; c < cycles_.size(); ++c) {
      const Cycle& cycle = cycles_[c];
      if (!cycle.outer || !cycle.box.contains(p) || component_of_[start(cycle.first)] == component) continue;
      if (best != none && cycles_[best].area <= cycle.area) continue;
      if (holds(c, p)) best = c;
    }
    return best;
  }

  bool holds(Index c, Vec2 p) const {
    bool inside = false;
    Index h = cycles_[c].first;
    do {
      const Vec2 s = in_.points[start(h)], t = in_.points[end(h)];
      if ((s.y > p.y) != (t.y > p.y) && p.x < s.x + (t.x - s.x) * ((p.y - s.y) / (t.y - s.y))) inside = !inside;
      h = next(h);
    } while (h != cycles_[c].first);
    return inside;
  }

  void nest_components() {
    for (Index c = 0; c < cycles_.size(); ++c) {
      if (cycles_[c].outer) {
        cycles_[c].cell = c;
      } else {
        const Index v = start(cycles_[c].first);
        cycles_[c].cell = cell_around(in_.points[v], component_of_[v]);  // none: outside everything
      }
    }
  }

  /// Windings of the boundary about each cell, from the outside in.
  Status wind() {
    std::vector<IndexPair> neighbours;  // (cell + 1, half-edge that has it to its left); 0 is the outside
    const auto cell = [&](Index h) { return cycles_[cycle_of_[h]].cell + 1; };
    for (Index h = 0; h < cycle_of_.size(); ++h) neighbours.emplace_back(cell(h), h);
    const Lists around = group(cycles_.size() + 1, neighbours);
    winding_.assign(cycles_.size() + 1, unknown);
    winding_[0] = 0;
    std::vector<Index> pending{0};
    while (!pending.empty()) {
      const Index k = pending.back();
      pending.pop_back();
      for (const Index h : around[k]) {
        const Index other = cell(h ^ 1u);
        const int along = in_.lines[h / 2].winding * (h % 2 == 0 ? 1 : -1);
        const int there = winding_[k] - along;  // to the right of h
        if (winding_[other] == unknown) {
          winding_[other] = there;
          pending.push_back(other);
        } else if (winding_[other] != there) {
          return failed(h);
        }
      }
    }
    for (Index c = 0; c < cycles_.size(); ++c) {
      if (cycles_[c].outer && winding_[c + 1] != 0 && winding_[c + 1] != 1) return failed(cycles_[c].first);
    }
    return {};
  }

  void place_points() {
    for (Index v = 0; v < in_.points.size(); ++v) {
      if (out_[v].empty()) alone_.emplace_back(cell_around(in_.points[v], component_of_[v]), v);
    }
  }

  std::vector<FaceCell> collect() const {
    std::vector<FaceCell> cells;
    std::vector<Index> cell_at(cycles_.size(), none);
    for (Index c = 0; c < cycles_.size(); ++c) {
      if (!cycles_[c].outer || winding_[c + 1] != 1) continue;
      cell_at[c] = static_cast<Index>(cells.size());
      cells.emplace_back().loops.push_back(coedges(c));
    }
    for (Index c = 0; c < cycles_.size(); ++c) {
      if (const Index around = cycles_[c].cell; !cycles_[c].outer && around != none && cell_at[around] != none)
        cells[cell_at[around]].loops.push_back(coedges(c));
    }
    for (const auto& [c, v] : alone_) {
      if (c != none && cell_at[c] != none) cells[cell_at[c]].points.push_back(v);
    }
    return cells;
  }

  std::vector<Index> coedges(Index c) const {
    std::vector<Index> result;
    Index h = cycles_[c].first;
    do {
      result.push_back(2 * in_.lines[h / 2].piece + h % 2);
      h = next(h);
    } while (h != cycles_[c].first);
    return result;
  }

  static constexpr int unknown = 1 << 20;

  struct Cycle {
    Index first = none;
    double area = 0;
    Box2 box;
    bool outer = true;  // bounds a cell; else it runs round the outside of its component
    Index cell = none;  // the cell to its left
  };

  const FaceDrawing& in_;
  Lists out_;
  std::vector<Index> place_, cycle_of_, component_of_;
  std::vector<Cycle> cycles_;
  std::vector<int> winding_;
  std::vector<IndexPair> alone_;
};

}  // namespace

Result<std::vector<FaceCell>> arrange(const FaceDrawing& drawing) {
  return Arranging(drawing).run();
}

}  // namespace aresta::planar
