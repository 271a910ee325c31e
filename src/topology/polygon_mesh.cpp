// SPDX-License-Identifier: Apache-2.0
#include "topology/polygon_mesh.h"

#include <algorithm>

#include "base/large_pages.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;

/// Numbers the pairs of a smaller and a larger vertex. The pairs of one smaller vertex have a hash table of their own
/// within one array, as large as the number of corners asks for: neighbours in the mesh are neighbours in memory.
class EdgeTable {
 public:
  EdgeTable(std::uint32_t vertex_count, std::span<const std::uint32_t> corners, std::span<const std::uint32_t> begin)
      : begin_(std::size_t{vertex_count} + 1, 0) {
    for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
      const std::uint32_t first = begin[p], last = begin[p + 1];
      for (std::uint32_t c = first; c < last; ++c) {
        ++begin_[std::min(corners[c], corners[c + 1 < last ? c + 1 : first])];
      }
    }
    std::uint32_t slots = 0;
    for (std::uint32_t& item : begin_) {
      const std::uint32_t pairs = item;
      item = slots;
      slots += pairs <= short_table ? pairs : 2 * pairs;
    }
    slots_ = vector_in_large_pages(slots, none);
    edges_.reserve(corners.size() / 2 + 1);
    prefer_large_pages(edges_);
  }

  std::uint32_t number(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = std::min(a, b), high = std::max(a, b);
    std::uint32_t* const first = slots_.data() + begin_[low];
    const std::uint32_t size = begin_[low + 1] - begin_[low];
    // Fibonacci hashing; a short table is searched from its start.
    std::uint32_t i = size <= short_table ? 0 : (std::uint64_t{high * 0x9e3779b9u} * size) >> 32;
    while (first[i] != none && edges_[first[i]][1] != high) i = i + 1 < size ? i + 1 : 0;
    if (first[i] == none) {
      first[i] = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({low, high});
    }
    return first[i];
  }

  std::vector<std::array<std::uint32_t, 2>> take() { return std::move(edges_); }

 private:
  static constexpr std::uint32_t short_table = 8;
  std::vector<std::uint32_t> begin_, slots_;  // per smaller vertex its slots; in each an edge
  std::vector<std::array<std::uint32_t, 2>> edges_;
};

}  // namespace

PolygonEdges edges_of_polygons(std::uint32_t vertex_count, std::span<const std::uint32_t> corners,
                               std::span<const std::uint32_t> begin) {
  EdgeTable table(vertex_count, corners, begin);
  PolygonEdges result;
  result.of_corner = vector_in_large_pages(corners.size(), none);
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
    const std::uint32_t first = begin[p], last = begin[p + 1];
    for (std::uint32_t c = first; c < last; ++c) {
      result.of_corner[c] = table.number(corners[c], corners[c + 1 < last ? c + 1 : first]);
    }
  }
  result.edges = table.take();
  return result;
}

static Result<Incidence> incidence_of(std::uint32_t vertex_count, std::span<const std::uint32_t> corners,
                                      std::vector<std::uint32_t> begin) {
  for (const std::uint32_t v : corners) {
    if (v >= vertex_count) return Error{errors::bad_incidence, "a corner names a vertex that does not exist"};
  }
  PolygonEdges found = edges_of_polygons(vertex_count, corners, begin);
  Incidence in;
  in.vertex_count = vertex_count;
  in.edges = std::move(found.edges);
  in.coedges = std::move(found.of_corner);
  in.loop_begin = std::move(begin);
  in.face_begin = vector_in_large_pages(in.loop_begin.size(), 0u);
  for (std::uint32_t f = 0; f < in.face_begin.size(); ++f) in.face_begin[f] = f;
  in.radial_next = vector_in_large_pages(corners.size(), none);
  auto last_use = vector_in_large_pages(in.edge_count(), none);
  for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
    const std::uint32_t e = in.coedges[c];
    in.coedges[c] = 2 * e + (corners[c] == in.edges[e][0] ? 0u : 1u);
    std::uint32_t& last = last_use[e];
    if (last == none) {
      in.radial_next[c] = c;
    } else {
      in.radial_next[c] = in.radial_next[last];
      in.radial_next[last] = c;
    }
    last = c;
  }
  return in;
}

Result<Incidence> incidence_of_polygons(std::uint32_t vertex_count, std::span<const std::uint32_t> corners,
                                        std::span<const std::uint32_t> begin) {
  if (begin.empty() || begin.front() != 0 || begin.back() != corners.size()) {
    return Error{errors::bad_incidence, "the polygons do not cover the corners"};
  }
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
    if (begin[p] >= begin[p + 1]) return Error{errors::bad_incidence, "a polygon has no corners", {FaceId(p)}};
  }
  return incidence_of(vertex_count, corners, {begin.begin(), begin.end()});
}

Result<Incidence> incidence_of_triangles(std::uint32_t vertex_count,
                                         std::span<const std::array<std::uint32_t, 3>> triangles) {
  auto begin = vector_in_large_pages(triangles.size() + 1, 0u);
  for (std::uint32_t t = 0; t < begin.size(); ++t) begin[t] = 3 * t;
  return incidence_of(vertex_count,
                      std::span(triangles.empty() ? nullptr : triangles.front().data(), 3 * triangles.size()),
                      std::move(begin));
}

void enclose_one_region(Incidence& in) {
  in.region_count = 2;
  in.region_filled = {false, true};
  in.face_use_region = vector_in_large_pages(2 * std::size_t{in.face_count()}, none);
  for (std::size_t u = 0; u < in.face_use_region.size(); ++u) in.face_use_region[u] = u % 2;
  in.edge_region.clear();
  in.vertex_region.assign(in.vertex_count, Complex::infinite_region().value);
  for (const auto& e : in.edges) in.vertex_region[e[0]] = in.vertex_region[e[1]] = none;
}

}  // namespace aresta
