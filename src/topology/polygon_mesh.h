// SPDX-License-Identifier: Apache-2.0
// Meshes of polygons on shared vertices as incidences: how triangles and other polygons become a complex in bulk.
//
// Polygon p has the corners [begin[p], begin[p + 1]) of an array of vertices; an edge runs from each corner to the next
// and from the last to the first. Edges are numbered as they first occur and run from the smaller vertex to the larger,
// so that the ids follow from the corners alone. All of it is linear in the number of corners, whatever the valences.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "topology/assemble.h"

namespace aresta {

struct PolygonEdges {
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< smaller vertex, larger vertex
  std::vector<std::uint32_t> of_corner;             ///< the edge that leaves the corner
};

/// Corners must be below vertex_count, and `begin` must rise from 0 to the number of corners.
PolygonEdges edges_of_polygons(std::uint32_t vertex_count, std::span<const std::uint32_t> corners,
                               std::span<const std::uint32_t> begin);

/// Every polygon is a face that runs as its corners do. The radial cycle of an edge takes its coedges as they occur:
/// with one or two uses there is no other; for more the caller puts radial_next in order. Regions are left to the
/// caller. Errors: bad_incidence for corners out of range, and for polygons without corners.
Result<Incidence> incidence_of_polygons(std::uint32_t vertex_count, std::span<const std::uint32_t> corners,
                                        std::span<const std::uint32_t> begin);
Result<Incidence> incidence_of_triangles(std::uint32_t vertex_count,
                                         std::span<const std::array<std::uint32_t, 3>> triangles);

/// Two regions: all fronts look into the infinite one, all backs into a filled one; vertices of no face are isolated in
/// the infinite one. What is not closed and oriented alike `assemble` refuses.
void enclose_one_region(Incidence& incidence);

}  // namespace aresta
