// SPDX-License-Identifier: Apache-2.0
// Complexes in a few lines: vertices are integers, edges are found by their vertices, and the order about an edge
// follows from the regions that its faces have on their sides.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include "topology/assemble.h"

namespace aresta {

class Sketch {
 public:
  using Index = std::uint32_t;
  struct Step {
    Index edge = 0;
    bool reversed = false;
  };
  /// Steps along edges, or one vertex.
  struct Loop {
    std::vector<Step> steps;
    Index vertex = Incidence::none;
  };
  /// The region in front of a face and the one behind it.
  struct Sides {
    Index front = 0, back = 0;
  };
  static constexpr Index outside = 0;

  Index add_region(bool filled = true);
  /// A new edge, also where there is one between the two vertices.
  Index add_edge(Index start, Index end);
  /// The first edge between two vertices, made if there is none.
  Index edge(Index a, Index b);

  Loop path(const std::vector<Index>& vertices);  ///< round through the vertices
  static Loop steps(std::vector<Step> steps) { return {std::move(steps), Incidence::none}; }
  static Loop point(Index v) { return {{}, v}; }

  Index add_face(const std::vector<Loop>& loops, Sides sides);
  Index add_polygon(const std::vector<Index>& vertices, Sides sides) { return add_face({path(vertices)}, sides); }
  void add_wire(Index a, Index b, Index region) { add_wire_along(edge(a, b), region); }
  void add_wire_along(Index edge, Index region) { wire_region_[edge] = region; }
  void add_point(Index v, Index region);

  /// The faces about an edge, counterclockwise about its direction; otherwise the order is the first one found in
  /// which the regions fit. A face that uses the edge twice is named twice.
  void order_about(Index edge, std::vector<Index> faces) { order_[edge] = std::move(faces); }

  Index vertex_count() const { return in_.vertex_count; }
  Index start(Index edge) const { return in_.edges[edge][0]; }
  /// Throws std::runtime_error when the sketch makes no complex.
  Complex complex() const;

 private:
  void touch(Index vertex) { in_.vertex_count = std::max(in_.vertex_count, vertex + 1); }
  std::vector<Index> cycle_about(Index edge, const std::vector<Index>& uses) const;
  Index face_of(Index coedge) const;

  Incidence in_;
  std::vector<Sides> sides_;
  std::vector<bool> filled_{false};
  std::map<Index, Index> wire_region_, point_region_;
  std::map<Index, std::vector<Index>> order_;
};

/// Faces of a polyhedron, each counterclockwise seen from outside.
using Polygons = std::vector<std::vector<Sketch::Index>>;
/// Adds them with `first_vertex` added to each vertex.
void add_polyhedron(Sketch& sketch, const Polygons& polygons, Sketch::Sides sides, Sketch::Index first_vertex = 0);
Polygons tetrahedron();
Polygons cube();  ///< bit 0 of a vertex is its x, bit 1 y, bit 2 z
/// A torus of n * n quadrilaterals; n is at least 3. Vertices are n * ring + place in the ring; rings go round the
/// tube.
Polygons torus(Sketch::Index n);

/// Adds the squares between unit cells of different regions. Cells outside the box are in region 0.
void add_cells(Sketch& sketch, std::array<int, 3> size, const std::function<Sketch::Index(int, int, int)>& region);

}  // namespace aresta
