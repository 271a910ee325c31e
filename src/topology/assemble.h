// SPDX-License-Identifier: Apache-2.0
// Building a whole complex at once from incidences: what imports and fragments do. Single changes are for operators.
#pragma once

#include <array>
#include <vector>

#include "base/result.h"
#include "topology/complex.h"
#include "topology/errors.h"

namespace aresta {

/// A complex as flat arrays. Entity i of an array becomes the entity with id i; radial_next and the regions are filled
/// in by whoever knows the geometry. `none` marks what does not apply; where nothing applies to any, as for most
/// meshes, the arrays that say so may be empty.
struct Incidence {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t vertex_count = 0;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< start and end vertex
  std::vector<std::uint32_t> coedges;               ///< 2 * edge + reversed, in loop order
  std::vector<std::uint32_t> loop_begin{0};         ///< loop l holds coedges [loop_begin[l], loop_begin[l + 1])
  std::vector<std::uint32_t> loop_vertex;           ///< for a loop without coedges its vertex, else none; or empty
  std::vector<std::uint32_t> face_begin{0};         ///< face f holds loops [face_begin[f], face_begin[f + 1])

  std::vector<std::uint32_t> radial_next;  ///< per coedge: the next one counterclockwise about the edge

  std::uint32_t region_count = 1;              ///< region 0 is the infinite one
  std::vector<bool> region_filled;             ///< per region; [0] is false
  std::vector<std::uint32_t> face_use_region;  ///< per face-use
  std::vector<std::uint32_t> edge_region;      ///< per edge: for wires, else none; or empty
  std::vector<std::uint32_t> vertex_region;    ///< per vertex: for isolated vertices of no face, else none; or empty

  std::uint32_t edge_count() const { return static_cast<std::uint32_t>(edges.size()); }
  std::uint32_t loop_count() const { return static_cast<std::uint32_t>(loop_begin.size() - 1); }
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(face_begin.size() - 1); }

  void add_coedge(std::uint32_t edge, bool reversed) { coedges.push_back(2 * edge + (reversed ? 1u : 0u)); }
  /// Closes the loop that the coedges added since the last call make.
  void close_loop() {
    loop_begin.push_back(static_cast<std::uint32_t>(coedges.size()));
    loop_vertex.push_back(none);
  }
  void add_vertex_loop(std::uint32_t vertex) {
    loop_begin.push_back(static_cast<std::uint32_t>(coedges.size()));
    loop_vertex.push_back(vertex);
  }
  void close_face() { face_begin.push_back(loop_count()); }
};

/// The face of every loop and the loop of every coedge, by index.
std::vector<std::uint32_t> face_of_loop(const Incidence& incidence);
std::vector<std::uint32_t> loop_of_coedge(const Incidence& incidence);

/// Joins the sides of faces that share a sector about some edge: for every face-use the smallest face-use of its
/// component. Needs radial_next. Linear.
std::vector<std::uint32_t> side_components(const Incidence& incidence);

/// The complex. Shells are found here: sides, wires and points of one region that share an edge or a vertex are one
/// shell; shells are ordered by their smallest member. Errors: bad_incidence names the offending entity (an open loop,
/// an index out of range, a radial cycle that mixes edges, sides of one sector in two regions, a wire without a
/// region).
Result<Complex> assemble(const Incidence& incidence);

}  // namespace aresta
