// SPDX-License-Identifier: Apache-2.0
// What was made, changed and removed between two states of one complex.
//
// Changed means that what an entity consists of or bounds is different, not how lists are linked. Both sides live, and:
//   vertex   the set of edge ends at it, the set of loops that are it, or the region in which it is isolated
//   edge     its ends; its uses: which coedges, their senses, and their cyclic order; or the region of a wire
//   coedge   its edge, sense or loop, or the coedge that follows it in the loop
//   loop     its face, its vertex, which coedges it has, or any of these changed
//   face     which loops it has, any of these changed, or the region of a side
//   region   whether it is filled, or which sides, wires and isolated vertices lie in it
//
// Guarantees: exact, for any two states, by ids: an entity killed whose id another one took counts as changed if they
// differ at all. Lists grow. Time: proportional to the pages of records that the two do not share and to the items of
// shells that changed region, times log; states that share no page cost a comparison of everything.
#pragma once

#include <vector>

#include "topology/complex.h"

namespace aresta {

template <class IdType>
struct Changes {
  std::vector<IdType> made, changed, removed;
  bool empty() const { return made.empty() && changed.empty() && removed.empty(); }
  bool operator==(const Changes&) const = default;
};

struct Difference {
  Changes<VertexId> vertices;
  Changes<EdgeId> edges;
  Changes<CoedgeId> coedges;
  Changes<LoopId> loops;
  Changes<FaceId> faces;
  Changes<RegionId> regions;

  bool empty() const {
    return vertices.empty() && edges.empty() && coedges.empty() && loops.empty() && faces.empty() && regions.empty();
  }
  bool operator==(const Difference&) const = default;
};

Difference difference(const Complex& before, const Complex& after);

}  // namespace aresta
