// SPDX-License-Identifier: Apache-2.0
// Where a point of a face's plane lies relative to the face.
//
// The point is within tolerance of the plane already. Contract: nearer than the tolerance to a vertex or to edges it is
// on them, and on nothing else; else it is inside or outside by the parity of crossings, which no rounding can change
// since every edge is farther away than the tolerance. Cost: the face's edges, or their logarithm where there are many.
#pragma once

#include <memory>

#include "math/box_tree.h"
#include "planar/plane_faces.h"

namespace aresta::planar {

struct Located {
  enum class Place : std::uint8_t { outside, inside, vertex, edges };
  Place place = Place::outside;
  Index vertex = none;
  std::array<Index, 6> edge{};  ///< as many as are near
  int edge_count = 0;
};

class FacePlaces {
 public:
  explicit FacePlaces(const PlaneFaces& faces);
  Located locate(Index face, Vec3 p) const;
  /// visit(edge) for each edge of the face near the box, some perhaps twice.
  template <class Visit>
  void edges_near(Index face, const Box3& box, Visit&& visit) const {
    const auto coedges = faces_.coedges_of(face);
    if (trees_[face] != nullptr) return trees_[face]->overlapping(box, [&](Index i) { visit(coedges[i] / 2); });
    for (const Index c : coedges) visit(c / 2);
  }

 private:
  PlaneFaces faces_;
  std::vector<std::unique_ptr<BoxTree>> trees_;  // for faces of many edges, in flat coordinates
};

}  // namespace aresta::planar
