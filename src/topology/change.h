// SPDX-License-Identifier: Apache-2.0
// Elementary changes of a complex, each of which can be made and taken back exactly.
//
// Every operator (operators.h) is a list of these. A change holds all that both directions need, ids among them: a
// change made, taken back and made again gives the same complex with the same ids (those of shells apart, which follow
// from what is connected). Each is described in its forward direction; `take_back` does the reverse. Changes are not
// checked: they are right when they come from an operator and are made and taken back in order.
//
// The face's orientation, the senses of coedges and the radial order are those of complex.h.
#pragma once

#include <variant>
#include <vector>

#include "topology/item.h"

namespace aresta {

/// An isolated vertex comes into a region.
struct PointChange {
  VertexId vertex;
  RegionId region;
};

/// A wire comes between two vertices that both touch the region.
struct WireChange {
  EdgeId edge;
  VertexId start, end;
  RegionId region;
};

/// Where a new coedge goes: behind `after` counterclockwise about its edge. Invalid: the edge is a wire.
struct Placement {
  EdgeId edge;
  bool reversed = false;
  CoedgeId after;
  int after_new = -1;  ///< instead of `after`: an earlier placement of the same face, counted from its first
  CoedgeId id;
};

struct LoopPlacement {
  LoopId id;
  VertexId vertex;  ///< of a loop without coedges
  std::vector<Placement> coedges;
};

/// A region that a change divides off another one.
struct Division {
  enum class Extent {
    found,  ///< what is no longer connected with what stays goes too: wires and parts that hang on the new region alone
    exact,  ///< `others` is all that goes
    nothing  ///< nothing is divided, even where sides are not connected (in complexes that do not fit into space)
  };
  RegionId region;  ///< the new one; invalid: nothing is divided
  RegionId of;      ///< the old one, filled in where it is divided
  Extent extent = Extent::found;
  bool filled = false;
  int side = 1;              ///< which of the two separated sides the new region gets
  std::vector<Item> others;  ///< what else of the old region goes to the new one; one side stands for its component
};

/// A face comes into a region. When its two sides are not connected afterwards, the region is divided.
struct FaceChange {
  FaceId face;
  RegionId region;
  std::vector<LoopPlacement> loops;
  Division division;
};

/// A vertex comes into the inside of faces, as a loop of each. They share a region about it.
struct LoopPointChange {
  VertexId vertex;
  std::vector<LoopPlacement> loops;  ///< each with its vertex
  std::vector<FaceId> faces;         ///< of the loops
};

/// An edge comes across a face between two corners of one loop, or at a loop that is a vertex, and divides the face.
/// The coedge `ahead` runs between the corners and closes the old loop, `back` runs back and begins the new face's.
struct AcrossChange {
  EdgeId edge;
  bool reversed = false;  ///< `ahead` runs against the edge
  CoedgeId ahead, back;
  LoopId loop, new_loop;
  CoedgeId from,
      to;           ///< the coedges that start at the corners where `ahead` starts and ends; invalid at a vertex loop
  VertexId vertex;  ///< of a vertex loop
  FaceId face, new_face;
  std::vector<LoopId> moved;  ///< other loops that go to the new face
};

/// An edge comes across a face between two of its loops, which become one: `loop`, without `other`.
struct JoiningChange {
  EdgeId edge;
  CoedgeId ahead, back;
  LoopId loop, other;
  CoedgeId from, to;  ///< the coedges that start where the edge starts and ends; invalid at a vertex loop
  VertexId start, end;
};

/// Two vertices become one: `gone` goes into `kept`. With an edge: that edge between them goes too (contraction).
struct VertexMergeChange {
  VertexId kept, gone;
  std::vector<EdgeEnd> ends;   ///< that were at `gone`
  std::vector<LoopId> points;  ///< loops that were `gone`
  RegionId isolated_in;        ///< the region in which `gone` was isolated
  RegionId kept_isolated_in;   ///< the same of `kept`

  EdgeId edge;                ///< contracted; invalid: none
  bool kept_is_start = true;  ///< of the edge
  RegionId wire_region;       ///< where the edge was a wire
  struct Use {
    CoedgeId id;
    bool reversed = false;
    LoopId loop;
    CoedgeId prev;   ///< in the loop when it is put back; invalid: the loop is a vertex then
    CoedgeId after;  ///< about the edge when it is put back; invalid: the first
  };
  std::vector<Use> uses;  ///< in the order in which they are put back

  EdgeId split_of;  ///< of a division of this edge in the middle: `edge` is a piece of it, `gone` a point of it
};

/// Two edges between the same vertices become one: the uses of `gone` go about `kept` behind `after`.
struct EdgeMergeChange {
  EdgeId kept, gone;
  bool flipped = false;        ///< gone runs against kept
  std::vector<CoedgeId> uses;  ///< of gone, in the order in which they stand about kept
  CoedgeId after;              ///< of kept; invalid when kept was a wire
  RegionId wire_region;        ///< of whichever of the two was a wire
  Division division;           ///< side 0: the sector behind `after`; side 1: the one behind the last use
};

/// A face with two edges goes, and its edges become one.
struct DigonChange {
  FaceId face;
  LoopId loop;
  CoedgeId kept_use, gone_use;  ///< the face's own
  EdgeId kept, gone;
  bool flipped = false;        ///< gone runs against kept
  bool kept_reversed = false;  ///< sense of kept_use
  std::vector<CoedgeId> uses;  ///< of gone, but for the face's own, in the order in which they stand about kept
  CoedgeId after;              ///< about kept; invalid when it has no other use
  RegionId front, back;        ///< of the face's sides
};

/// Two faces with the same boundary and nothing but a region between them become one.
struct FaceMergeChange {
  FaceId kept, gone;
  bool flipped = false;  ///< gone has the opposite orientation
  int kept_side = 0;     ///< the side of kept that looked into the region
  RegionId region;
  bool filled = false;
  struct Use {
    CoedgeId id, beside;    ///< of gone, and of kept about the same edge
    bool is_after = false;  ///< id follows beside about the edge
  };
  struct LoopPair {
    LoopId id, beside;
    std::vector<Use> uses;  ///< in the order of gone's loop; empty: vertex loops
  };
  std::vector<LoopPair> loops;
};

using AnyChange = std::variant<PointChange, WireChange, FaceChange, LoopPointChange, AcrossChange, JoiningChange,
                               VertexMergeChange, EdgeMergeChange, DigonChange, FaceMergeChange>;

/// A change and its direction: a reversed one is made by taking back what it describes.
struct Change {
  AnyChange what;
  bool reversed = false;
};

/// Makes a change. Ids in it that are invalid are chosen and filled in.
void make(Complex& k, Change& change);
/// Takes a change back; the complex must be as the change left it, as far as the change reaches.
void take_back(Complex& k, Change& change);

}  // namespace aresta
