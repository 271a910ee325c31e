// SPDX-License-Identifier: Apache-2.0
// Lineage: what an operator did to vertices, edges, faces and regions, for all that hangs on them: attributes, groups,
// geometry, persistent ids.
//
//   event    entity   other                  what it says
//   made     new      that it lies on        the entity is there and was not; `other` only where an edge was divided
//   killed   gone     none                   the entity is there no longer
//   split    old      new                    the new one is a piece of the old one; both live on
//   merged   gone     kept                   the first went into the second
//
// Guarantees: the net effect. An entity made and killed within one operator does not appear; what went into one that
// died afterwards appears as what became of that one. Events come in the order in which things happened, so that each
// names only what lives at that point. An operator and its reverse have reverse events, save that the order in which
// pieces of one entity part may differ.
//
// Which change gives what:
//   PointChange        vertex made                        WireChange, JoiningChange   edge made
//   FaceChange         face made; with a division: region split
//   LoopPointChange    vertex made                        AcrossChange                edge made, face split
//   VertexMergeChange  vertex merged; with an edge: edge killed. With split_of: vertex killed, edge merged into it
//   EdgeMergeChange    edge merged; with a division: region split
//   DigonChange        edge merged, face killed           FaceMergeChange             face merged, region killed
// A change taken back gives the opposite: made for killed, split for merged.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "topology/operators.h"

namespace aresta {

struct LineageEvent {
  enum class Kind : std::uint8_t { made, killed, split, merged };
  Kind kind = Kind::made;
  EntityRef entity;
  EntityRef other;
  bool operator==(const LineageEvent&) const = default;
};

/// "split face 3 -> face 9", "merged vertex 2 -> vertex 0", "made edge 7", "killed region 1".
std::string describe(const LineageEvent& event);

/// What the operator did when it was applied, and what taking it back does. Linear in its steps.
std::vector<LineageEvent> lineage(const Applied& applied);
std::vector<LineageEvent> lineage_of_take_back(const Applied& applied);

/// What one change says by itself; `reversed` as in Change.
std::vector<LineageEvent> lineage(const Change& change);

/// The net effect of events in order, as said above.
std::vector<LineageEvent> net_effect(std::span<const LineageEvent> events);

}  // namespace aresta
