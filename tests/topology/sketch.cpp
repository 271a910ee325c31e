// SPDX-License-Identifier: Apache-2.0
#include "sketch.h"

#include <algorithm>
#include <stdexcept>

namespace aresta {

using Index = Sketch::Index;

Index Sketch::add_region(bool filled) {
  filled_.push_back(filled);
  return in_.region_count++;
}

Index Sketch::add_edge(Index start, Index end) {
  touch(start);
  touch(end);
  in_.edges.push_back({start, end});
  return in_.edge_count() - 1;
}

Index Sketch::edge(Index a, Index b) {
  for (Index e = 0; e < in_.edge_count(); ++e) {
    if (in_.edges[e] == std::array{a, b} || in_.edges[e] == std::array{b, a}) return e;
  }
  return add_edge(a, b);
}

Sketch::Loop Sketch::path(const std::vector<Index>& vertices) {
  Loop loop;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Index a = vertices[i], e = edge(a, vertices[(i + 1) % vertices.size()]);
    loop.steps.push_back({e, in_.edges[e][0] != a});
  }
  return loop;
}

Index Sketch::add_face(const std::vector<Loop>& loops, Sides sides) {
  for (const Loop& loop : loops) {
    if (loop.steps.empty()) {
      touch(loop.vertex);
      in_.add_vertex_loop(loop.vertex);
      continue;
    }
    for (const Step step : loop.steps) in_.add_coedge(step.edge, step.reversed);
    in_.close_loop();
  }
  in_.close_face();
  sides_.push_back(sides);
  return in_.face_count() - 1;
}

void Sketch::add_point(Index v, Index region) {
  touch(v);
  point_region_[v] = region;
}

Index Sketch::face_of(Index coedge) const {
  const auto loop = std::upper_bound(in_.loop_begin.begin(), in_.loop_begin.end(), coedge) - in_.loop_begin.begin() - 1;
  const auto face = std::upper_bound(in_.face_begin.begin(), in_.face_begin.end(), loop) - in_.face_begin.begin() - 1;
  return static_cast<Index>(face);
}

std::vector<Index> Sketch::cycle_about(Index edge, const std::vector<Index>& uses) const {
  if (const auto order = order_.find(edge); order != order_.end()) {
    std::vector<Index> cycle, left = uses;
    for (const Index f : order->second) {
      const auto use = std::find_if(left.begin(), left.end(), [&](Index c) { return face_of(c) == f; });
      if (use == left.end()) throw std::runtime_error("an order about an edge names a face that does not use it");
      cycle.push_back(*use);
      left.erase(use);
    }
    return cycle;
  }
  const auto region = [&](Index c, bool after) {
    const bool front = after == ((in_.coedges[c] & 1u) == 0);
    return front ? sides_[face_of(c)].front : sides_[face_of(c)].back;
  };
  std::vector<Index> cycle{uses.front()}, left(uses.begin() + 1, uses.end());
  const std::function<bool()> extend = [&] {
    if (left.empty()) return region(cycle.back(), true) == region(cycle.front(), false);
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Index c = left[i];
      if (region(cycle.back(), true) != region(c, false)) continue;
      cycle.push_back(c);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      if (extend()) return true;
      left.insert(left.begin() + static_cast<std::ptrdiff_t>(i), c);
      cycle.pop_back();
    }
    return false;
  };
  if (!extend()) throw std::runtime_error("the regions about edge " + std::to_string(edge) + " fit in no order");
  return cycle;
}

Complex Sketch::complex() const {
  Incidence in = in_;
  in.region_filled = filled_;
  for (const Sides sides : sides_) in.face_use_region.insert(in.face_use_region.end(), {sides.front, sides.back});
  in.edge_region.assign(in.edge_count(), Incidence::none);
  in.vertex_region.assign(in.vertex_count, Incidence::none);
  for (const auto& [edge, region] : wire_region_) in.edge_region[edge] = region;
  for (const auto& [vertex, region] : point_region_) in.vertex_region[vertex] = region;
  std::vector<std::vector<Index>> uses(in.edge_count());
  for (Index c = 0; c < in.coedges.size(); ++c) uses[in.coedges[c] >> 1].push_back(c);
  in.radial_next.assign(in.coedges.size(), Incidence::none);
  for (Index e = 0; e < in.edge_count(); ++e) {
    if (uses[e].empty()) continue;
    const auto cycle = cycle_about(e, uses[e]);
    for (std::size_t i = 0; i < cycle.size(); ++i) in.radial_next[cycle[i]] = cycle[(i + 1) % cycle.size()];
  }
  auto result = assemble(in);
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(result).value();
}

void add_polyhedron(Sketch& sketch, const Polygons& polygons, Sketch::Sides sides, Index first_vertex) {
  for (std::vector<Index> polygon : polygons) {
    for (Index& v : polygon) v += first_vertex;
    sketch.add_polygon(polygon, sides);
  }
}

Polygons tetrahedron() {
  return {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
}

Polygons cube() {
  return {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
}

Polygons torus(Index n) {
  Polygons polygons;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index ring = n * i, next_ring = n * ((i + 1) % n), next = (j + 1) % n;
      polygons.push_back({ring + j, next_ring + j, next_ring + next, ring + next});
    }
  }
  return polygons;
}

void add_cells(Sketch& sketch, std::array<int, 3> size, const std::function<Index(int, int, int)>& region) {
  using Place = std::array<int, 3>;
  const auto moved = [](Place p, int axis, int by) {
    p[static_cast<std::size_t>(axis)] += by;
    return p;
  };
  const auto region_at = [&](Place p) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] < 0 || p[i] >= size[i]) return Sketch::outside;
    }
    return region(p[0], p[1], p[2]);
  };
  const auto for_all_places = [&](auto&& visit) {
    for (int z = 0; z <= size[2]; ++z) {
      for (int y = 0; y <= size[1]; ++y) {
        for (int x = 0; x <= size[0]; ++x) visit(Place{x, y, z});
      }
    }
  };
  std::map<Place, Index> vertices;
  const auto vertex_at = [&](Place p) {
    return vertices.emplace(p, sketch.vertex_count() + static_cast<Index>(vertices.size())).first->second;
  };
  // The vertices must be known before the edges name them.
  std::map<std::pair<Place, int>, std::vector<Index>> corners;  // by the lowest corner and the normal
  for_all_places([&](Place p) {
    for (int axis = 0; axis < 3; ++axis) {
      if (region_at(p) == region_at(moved(p, axis, -1))) continue;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      corners[{p, axis}] = {vertex_at(p), vertex_at(moved(p, u, 1)), vertex_at(moved(moved(p, u, 1), v, 1)),
                            vertex_at(moved(p, v, 1))};
    }
  });
  std::map<std::pair<Place, int>, Index> squares;
  for (const auto& [key, polygon] : corners) {
    const auto& [p, axis] = key;
    squares[key] = sketch.add_polygon(polygon, {region_at(p), region_at(moved(p, axis, -1))});
  }
  // About an edge along an axis: the squares that go from it along u, along v, against u, against v.
  for_all_places([&](Place p) {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      std::vector<Index> about;
      for (const auto& key : {std::pair{p, v}, {p, u}, {moved(p, u, -1), v}, {moved(p, v, -1), u}}) {
        if (const auto square = squares.find(key); square != squares.end()) about.push_back(square->second);
      }
      if (about.empty()) continue;
      const Index a = vertices.at(p), b = vertices.at(moved(p, axis, 1));
      const Index e = sketch.edge(a, b);
      if (sketch.start(e) != a) std::reverse(about.begin(), about.end());
      sketch.order_about(e, about);
    }
  });
}

}  // namespace aresta
