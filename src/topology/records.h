// SPDX-License-Identifier: Apache-2.0
// A complex as lists of what it has, under ids that may have gaps: what a reader of some notation fills in.
// (Incidence in assemble.h is for what has no ids yet.)
#pragma once

#include <vector>

#include "base/result.h"
#include "topology/complex.h"
#include "topology/errors.h"
#include "topology/item.h"

namespace aresta {

/// Flat lists. Members of type std::uint32_t that are not lines are places in other lists. Loops of a face, coedges of
/// a loop, uses of an edge and items of a shell are listed one after another, so that these places grow.
struct ComplexRecords {
  struct Region {
    RegionId id;
    bool filled = false;
    std::uint32_t line = 0;  ///< where errors are reported; 0: nowhere
  };
  struct Shell {
    RegionId region;
    std::uint32_t line = 0;
  };
  struct ShellItem {
    Item item;
    std::uint32_t shell = 0;
  };
  struct Face {
    FaceId id;
    std::uint32_t line = 0;
  };
  struct Loop {
    LoopId id;
    VertexId vertex;  ///< of a loop without coedges
    std::uint32_t face = 0, line = 0;
  };
  struct Coedge {
    CoedgeId id;
    EdgeId edge;
    bool reversed = false;
    std::uint32_t loop = 0, line = 0;
  };
  struct Edge {
    EdgeId id;
    VertexId start, end;
    std::uint32_t line = 0;
  };
  struct Use {  ///< counterclockwise about the edge
    CoedgeId coedge;
    std::uint32_t edge = 0;
  };
  struct Vertex {
    VertexId id;
    std::uint32_t line = 0;
  };

  std::vector<Region> regions;
  std::vector<Shell> shells;
  std::vector<ShellItem> items;
  std::vector<Face> faces;
  std::vector<Loop> loops;
  std::vector<Coedge> coedges;
  std::vector<Edge> edges;
  std::vector<Use> uses;
  std::vector<Vertex> vertices;

  std::size_t count() const {
    return regions.size() + faces.size() + loops.size() + coedges.size() + edges.size() + vertices.size();
  }
};

/// Ids below this are taken from so many records, so that a few records cannot ask for much memory.
constexpr std::size_t id_limit(std::size_t records) {
  const std::size_t limit = (std::size_t{1} << 20) + 16 * records, most = std::size_t{1} << 30;
  return limit < most ? limit : most;
}

/// The complex with these ids. Every invariant of complex.h is checked: ids are unique and known; loops close; the uses
/// of an edge are its coedges, once each; every side, wire and isolated vertex, and nothing else, lies in one shell;
/// sides of one sector are in one region, and so are a wire and what it hangs on; a shell is what is connected in its
/// region; region 0 is there and not filled, any other has a shell; a vertex loop meets no other loop of its face. What
/// must hold in space besides (check.h, full) is not asked for.
/// Errors: record_ids, record_invariant; both say the line and name the entities. n log n.
Result<Complex> rebuild(const ComplexRecords& records);

}  // namespace aresta
