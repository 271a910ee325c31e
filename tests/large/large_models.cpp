// SPDX-License-Identifier: Apache-2.0
#include "large/large_models.h"

#include <cmath>
#include <map>

namespace aresta::test {

TriangleMesh sphere_of_triangles(std::uint32_t n) {
  TriangleMesh mesh;
  // The corners: of three rectangles whose sides are in the golden ratio.
  const double g = (1 + std::sqrt(5.0)) / 2;
  mesh.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::uint32_t corners[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                            {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                            {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                            {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  const auto add_between = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, double wa, double wb, double wc) {
    std::array<double, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = wa * mesh.points[a][i] + wb * mesh.points[b][i] + wc * mesh.points[c][i];
    mesh.points.push_back(p);
    return static_cast<std::uint32_t>(mesh.points.size() - 1);
  };
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> first_on_edge;
  // The i-th point from a to b.
  const auto on_edge = [&](std::uint32_t a, std::uint32_t b, std::uint32_t i) {
    if (i == 0) return a;
    if (i == n) return b;
    const bool along = a < b;
    const std::array key{along ? a : b, along ? b : a};
    const auto [place, is_new] = first_on_edge.try_emplace(key, static_cast<std::uint32_t>(mesh.points.size()));
    for (std::uint32_t j = 1; is_new && j < n; ++j) add_between(key[0], key[1], key[1], n - j, j, 0);
    return place->second + (along ? i : n - i) - 1;
  };
  mesh.triangles.reserve(std::size_t{20} * n * n);
  for (const auto& [a, b, c] : corners) {
    // Row i runs parallel to ab, from the side ac to the side bc, and has n - i parts.
    std::vector<std::uint32_t> row(n + 1), above;
    for (std::uint32_t j = 0; j <= n; ++j) row[j] = on_edge(a, b, j);
    for (std::uint32_t i = 0; i < n; ++i, row.swap(above)) {
      above.clear();
      above.push_back(on_edge(a, c, i + 1));
      for (std::uint32_t j = 1; j + i + 1 < n; ++j) above.push_back(add_between(a, b, c, n - i - 1 - j, j, i + 1));
      if (i + 1 < n) above.push_back(on_edge(b, c, i + 1));
      for (std::uint32_t j = 0; j < n - i; ++j) {
        mesh.triangles.push_back({row[j], row[j + 1], above[j]});
        if (j + 1 < n - i) mesh.triangles.push_back({row[j + 1], above[j + 1], above[j]});
      }
    }
  }
  for (auto& p : mesh.points) {
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x /= length;
  }
  return mesh;
}

namespace {

/// Numbers the edges along, and the faces across, each axis: by place, all of axis 0 first.
class Grid {
 public:
  using Place = std::array<std::uint32_t, 3>;
  explicit Grid(std::uint32_t n) : n_(n) {}

  static Place moved(Place p, std::size_t axis) {
    ++p[axis];
    return p;
  }
  std::uint32_t vertex(Place p) const { return index(p, {n_ + 1, n_ + 1, n_ + 1}); }
  std::uint32_t edge(std::size_t axis, Place p) const {
    Place size{n_ + 1, n_ + 1, n_ + 1};
    size[axis] = n_;
    return static_cast<std::uint32_t>(axis) * n_ * (n_ + 1) * (n_ + 1) + index(p, size);
  }
  std::uint32_t face(std::size_t axis, Place p) const {
    Place size{n_, n_, n_};
    size[axis] = n_ + 1;
    return static_cast<std::uint32_t>(axis) * n_ * n_ * (n_ + 1) + index(p, size);
  }
  std::uint32_t region(Place p) const { return 1 + index(p, {n_, n_, n_}); }
  /// All places of an array that is as long as the grid along the axes in `whole`, and one longer along the others.
  template <class Visit>
  void for_each(std::array<bool, 3> whole, Visit&& visit) const {
    const auto size = [&](std::size_t axis) { return n_ + (whole[axis] ? 0 : 1); };
    Place p;
    for (p[2] = 0; p[2] < size(2); ++p[2]) {
      for (p[1] = 0; p[1] < size(1); ++p[1]) {
        for (p[0] = 0; p[0] < size(0); ++p[0]) visit(p);
      }
    }
  }

 private:
  static std::uint32_t index(Place p, Place size) { return p[0] + size[0] * (p[1] + size[1] * p[2]); }
  std::uint32_t n_;
};

}  // namespace

Incidence grid_of_cubes(std::uint32_t n) {
  const Grid grid(n);
  Incidence in;
  in.vertex_count = (n + 1) * (n + 1) * (n + 1);
  for (std::size_t a = 0; a < 3; ++a) {
    std::array<bool, 3> whole{};
    whole[a] = true;
    grid.for_each(whole, [&](Grid::Place p) { in.edges.push_back({grid.vertex(p), grid.vertex(Grid::moved(p, a))}); });
  }
  in.region_count = n * n * n + 1;
  in.region_filled.assign(in.region_count, true);
  in.region_filled[0] = false;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    std::array<bool, 3> whole{true, true, true};
    whole[a] = false;
    grid.for_each(whole, [&](Grid::Place p) {
      in.add_coedge(grid.edge(b, p), false);
      in.add_coedge(grid.edge(c, Grid::moved(p, b)), false);
      in.add_coedge(grid.edge(b, Grid::moved(p, c)), true);
      in.add_coedge(grid.edge(c, p), true);
      in.close_loop();
      in.close_face();
      Grid::Place behind = p;
      --behind[a];
      in.face_use_region.push_back(p[a] < n ? grid.region(p) : 0);
      in.face_use_region.push_back(p[a] > 0 ? grid.region(behind) : 0);
    });
  }
  // About an edge along a: the faces towards b, c, -b, -c, of which the first and third are across c.
  in.radial_next.resize(in.coedges.size());
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    std::array<bool, 3> whole{};
    whole[a] = true;
    grid.for_each(whole, [&](Grid::Place p) {
      std::vector<std::uint32_t> about;
      Grid::Place minus_b = p, minus_c = p;
      --minus_b[b];
      --minus_c[c];
      if (p[b] < n) about.push_back(4 * grid.face(c, p));
      if (p[c] < n) about.push_back(4 * grid.face(b, p) + 3);
      if (p[b] > 0) about.push_back(4 * grid.face(c, minus_b) + 2);
      if (p[c] > 0) about.push_back(4 * grid.face(b, minus_c) + 1);
      for (std::size_t i = 0; i < about.size(); ++i) in.radial_next[about[i]] = about[(i + 1) % about.size()];
    });
  }
  in.edge_region.assign(in.edge_count(), Incidence::none);
  in.vertex_region.assign(in.vertex_count, Incidence::none);
  return in;
}

}  // namespace aresta::test
