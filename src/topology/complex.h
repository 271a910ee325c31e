// SPDX-License-Identifier: Apache-2.0
// The radial edge structure: a non-manifold cell complex of vertices, edges, faces and regions, without coordinates.
//
// Space is divided completely: every side of every face, every wire and every isolated vertex lies in exactly one
// region. Region 0 is the infinite one. A finite region is `filled` when it is a volume of the model, and empty when it
// is merely enclosed space (the inside of a closed shell of faces that bounds no volume).
//
// Conventions
//   coedge   use of an edge by a loop; `reversed` when it runs against the edge. Loops run counterclockwise around
//   their
//            face when seen from the face's front (side 0, where its normal points): the face lies to the left.
//   radial   coedges of one edge form a cycle, counterclockwise about the edge's direction. Between a coedge c and
//            radial(c) lies one sector of space; it touches side_after(c) of c's face and side_before(radial(c)).
//   loop     a cycle of coedges, or a single vertex. A dangling edge inside a face occurs twice in one loop.
//   shell    the part of a region's boundary that is connected (through edges or vertices): face-uses, wire edges,
//            or one isolated vertex.
//   wire     an edge of no face; it lies in the one region of its shell.
//
// Ids. A complex that was assembled in bulk is compact: ids run from 0 to count - 1. Operators (operators.h) leave gaps
// where they kill something and fill them later; then an id is below `..._bound()`, `is_live` tells gaps, and ranges
// step over them. Shells are not named by users: they follow from what is connected in a region.
//
// Stored: vertex 8 bytes, edge 28, coedge 20, loop 16, face 28, shell 24, region 8, and 16 for each wire and 8 for each
// loop that is a vertex; uses are implied by arithmetic. All lists that a change has to leave are linked both ways.
// After K. Weiler, "Topological structures for geometric modeling", 1986; implied uses as in S. Lee and K. Lee, 2001.
#pragma once

#include <array>
#include <cassert>
#include <vector>

#include "base/ids.h"
#include "base/pages.h"
#include "topology/chain.h"

namespace aresta {

/// One end of an edge: 0 its start, 1 its end.
struct EdgeEnd {
  EdgeId edge;
  int end = 0;
  constexpr auto operator<=>(const EdgeEnd&) const = default;
};

enum class EdgeUseKind { wire, lamina, manifold, non_manifold };

struct Compaction;

class Complex {
 public:
  Complex();

  /// How many there are.
  std::size_t vertex_count() const { return vertices_.size() - free_[vertex_rows].count; }
  std::size_t edge_count() const { return edges_.size() - free_[edge_rows].count; }
  std::size_t coedge_count() const { return coedges_.size() - free_[coedge_rows].count; }
  std::size_t loop_count() const { return loops_.size() - free_[loop_rows].count; }
  std::size_t face_count() const { return faces_.size() - free_[face_rows].count; }
  std::size_t shell_count() const { return shells_.size() - free_[shell_rows].count; }
  /// All regions, the infinite one and empty ones included.
  std::size_t region_count() const { return regions_.size() - free_[region_rows].count; }

  /// All ids are below these; equal to the counts when the complex is compact.
  std::size_t vertex_bound() const { return vertices_.size(); }
  std::size_t edge_bound() const { return edges_.size(); }
  std::size_t coedge_bound() const { return coedges_.size(); }
  std::size_t loop_bound() const { return loops_.size(); }
  std::size_t face_bound() const { return faces_.size(); }
  std::size_t shell_bound() const { return shells_.size(); }
  std::size_t region_bound() const { return regions_.size(); }
  bool is_compact() const;

  /// Does the id name something? False for any id out of range or killed.
  bool is_live(VertexId v) const { return v.index() < vertices_.size() && vertices_[v.index()].first_end != dead; }
  bool is_live(EdgeId e) const { return e.index() < edges_.size() && edges_[e.index()].vertex[0] != dead; }
  bool is_live(CoedgeId c) const { return c.index() < coedges_.size() && coedges_[c.index()].loop != dead; }
  bool is_live(LoopId l) const { return l.index() < loops_.size() && loops_[l.index()].face != dead; }
  bool is_live(FaceId f) const { return f.index() < faces_.size() && faces_[f.index()].first_loop != dead; }
  bool is_live(ShellId s) const { return s.index() < shells_.size() && shells_[s.index()].region != dead; }
  bool is_live(RegionId r) const { return r.index() < regions_.size() && regions_[r.index()].filled != dead; }
  bool is_live(EntityRef entity) const;

  auto vertices() const { return LiveRange<VertexId, Complex>(this, vertex_bound()); }
  auto edges() const { return LiveRange<EdgeId, Complex>(this, edge_bound()); }
  auto coedges() const { return LiveRange<CoedgeId, Complex>(this, coedge_bound()); }
  auto loops() const { return LiveRange<LoopId, Complex>(this, loop_bound()); }
  auto faces() const { return LiveRange<FaceId, Complex>(this, face_bound()); }
  auto shells() const { return LiveRange<ShellId, Complex>(this, shell_bound()); }
  auto regions() const { return LiveRange<RegionId, Complex>(this, region_bound()); }

  // Edge.
  VertexId start(EdgeId e) const { return VertexId(edges_[e.index()].vertex[0]); }
  VertexId end(EdgeId e) const { return VertexId(edges_[e.index()].vertex[1]); }
  VertexId vertex(EdgeEnd e) const { return VertexId(edges_[e.edge.index()].vertex[e.end]); }
  bool is_closed(EdgeId e) const { return start(e) == end(e); }
  bool is_wire(EdgeId e) const {
    const std::uint32_t use = edges_[e.index()].first_use;
    return (use & tag) != 0 && use != none;
  }
  /// The shell of a wire; invalid for an edge of a face.
  ShellId wire_shell(EdgeId e) const {
    return is_wire(e) ? ShellId(wires_[edges_[e.index()].first_use & ~tag].shell) : ShellId();
  }
  CoedgeId first_coedge(EdgeId e) const { return is_wire(e) ? CoedgeId() : CoedgeId(edges_[e.index()].first_use); }
  EdgeUseKind use_kind(EdgeId e) const;

  // Coedge.
  CoedgeId next(CoedgeId c) const { return CoedgeId(coedges_[c.index()].next); }
  CoedgeId prev(CoedgeId c) const { return CoedgeId(coedges_[c.index()].prev); }
  CoedgeId radial(CoedgeId c) const { return CoedgeId(coedges_[c.index()].radial); }
  /// The coedge before c counterclockwise about the edge; in time proportional to the edge's uses.
  CoedgeId radial_prev(CoedgeId c) const {
    CoedgeId before = c;
    while (radial(before) != c) before = radial(before);
    return before;
  }
  EdgeId edge(CoedgeId c) const { return EdgeId(coedges_[c.index()].edge_sense >> 1); }
  bool reversed(CoedgeId c) const { return (coedges_[c.index()].edge_sense & 1u) != 0; }
  LoopId loop(CoedgeId c) const { return LoopId(coedges_[c.index()].loop); }
  FaceId face(CoedgeId c) const { return face(loop(c)); }
  VertexId start(CoedgeId c) const { return reversed(c) ? end(edge(c)) : start(edge(c)); }
  VertexId end(CoedgeId c) const { return reversed(c) ? start(edge(c)) : end(edge(c)); }
  /// The side of c's face in the sector that follows c counterclockwise about the edge, and in the one before it.
  FaceUse side_after(CoedgeId c) const { return FaceUse(face(c), reversed(c) ? 1 : 0); }
  FaceUse side_before(CoedgeId c) const { return FaceUse(face(c), reversed(c) ? 0 : 1); }

  // Loop.
  FaceId face(LoopId l) const { return FaceId(loops_[l.index()].face); }
  bool is_vertex_loop(LoopId l) const {
    const std::uint32_t first = loops_[l.index()].first;
    return (first & tag) != 0 && first != none;
  }
  /// The vertex of a loop that is a single vertex; else invalid.
  VertexId loop_vertex(LoopId l) const {
    return is_vertex_loop(l) ? VertexId(loops_[l.index()].first & ~tag) : VertexId();
  }
  CoedgeId first_coedge(LoopId l) const { return is_vertex_loop(l) ? CoedgeId() : CoedgeId(loops_[l.index()].first); }

  // Face.
  LoopId first_loop(FaceId f) const { return LoopId(faces_[f.index()].first_loop); }
  ShellId shell(FaceUse u) const { return ShellId(faces_[u.face().index()].shell[u.side()]); }
  RegionId region(FaceUse u) const { return region(shell(u)); }

  // Shell.
  RegionId region(ShellId s) const { return RegionId(shells_[s.index()].region); }
  /// The vertex of a shell that is a single vertex; else invalid.
  VertexId shell_vertex(ShellId s) const { return VertexId(shells_[s.index()].vertex); }

  // Region.
  static constexpr RegionId infinite_region() { return RegionId(0); }
  bool is_filled(RegionId r) const { return regions_[r.index()].filled != 0; }

  // Vertex.
  /// The shell of an isolated vertex inside a region; else invalid.
  ShellId isolated_in_shell(VertexId v) const;
  /// Has the vertex no edge? (It may still be a loop of faces.)
  bool has_no_edge(VertexId v) const { return vertices_[v.index()].first_end == none; }

  // Ranges, each in time proportional to its length.
  auto coedges(LoopId l) const {
    return cycle(first_coedge(l), [this](CoedgeId c) { return next(c); });
  }
  /// The coedges of an edge, counterclockwise about it; empty for a wire.
  auto coedges(EdgeId e) const {
    return cycle(first_coedge(e), [this](CoedgeId c) { return radial(c); });
  }
  auto loops(FaceId f) const {
    return chain(first_loop(f), [this](LoopId l) { return LoopId(loops_[l.index()].next); });
  }
  auto face_uses(ShellId s) const {
    return chain(FaceUse::from_index(shells_[s.index()].first_face_use),
                 [this](FaceUse u) { return FaceUse::from_index(faces_[u.face().index()].next_in_shell[u.side()]); });
  }
  auto wires(ShellId s) const {
    return chain(wire_edge(shells_[s.index()].first_wire), [this](EdgeId e) { return next_wire(e); });
  }
  auto shells(RegionId r) const {
    return chain(ShellId(regions_[r.index()].first_shell),
                 [this](ShellId s) { return ShellId(shells_[s.index()].next); });
  }
  /// The edge ends at a vertex; a closed edge comes twice.
  auto edge_ends(VertexId v) const {
    return cycle(decode(vertices_[v.index()].first_end),
                 [this](EdgeEnd e) { return decode(edges_[e.edge.index()].next[e.end]); });
  }

  /// The loops that are this single vertex: of the faces that have it inside. Several where faces touch in a point.
  std::vector<LoopId> vertex_loops(VertexId v) const;

  /// Is the face two-sided within one region (an internal or dangling sheet), so that it bounds nothing?
  bool has_same_region_on_both_sides(FaceId f) const { return region(FaceUse(f, 0)) == region(FaceUse(f, 1)); }

  /// Bytes allocated for all of it, shared pages included; and those not shared with an earlier state of it.
  std::size_t allocated_bytes() const;
  std::size_t bytes_not_shared_with(const Complex& earlier) const;

 private:
  friend class Assembler;  // writes all records at once (assemble.cpp)
  friend class Editor;     // what operators change the records with (editor.h)
  friend struct ComplexDifference;
  friend Compaction compact(Complex& k);  // renumbers them (compaction.h)
  friend struct ComplexRows;              // reads the records as they are (rows_detail.h)
  friend struct ComplexBreaker;           // breaks them, in tests of the checker

  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr std::uint32_t dead = 0xfffffffeu;
  static constexpr std::uint32_t tag = 0x80000000u;

  // A killed record says `dead` in the member marked (*) and the next free row in the one marked (+).
  struct VertexRecord {
    std::uint32_t first_end = none;  // (*) 2 * edge + end
    std::uint32_t owner = none;      // (+) its first point use, or, when isolated in a region, its shell, tagged
  };
  struct EdgeRecord {
    std::uint32_t vertex[2] = {none, none};                        // (*) (+)
    std::uint32_t next[2] = {none, none}, prev[2] = {none, none};  // the cycle of edge ends at each vertex
    std::uint32_t first_use = none;                                // a coedge; for a wire its wire use, tagged
  };
  struct WireRecord {  // the use of an edge by a shell, where no face uses it
    std::uint32_t edge = none, shell = none, next = none, prev = none;  // (*) (+); prev of the first is the last
  };
  struct CoedgeRecord {
    std::uint32_t next = none, prev = none, radial = none, edge_sense = none, loop = none;  // next (+), loop (*)
  };
  struct PointUseRecord {                    // a loop that is a single vertex; few
    std::uint32_t loop = none, next = none;  // (*) (+)
  };
  struct LoopRecord {
    std::uint32_t first = none;                           // a coedge, or a vertex, tagged
    std::uint32_t next = none, prev = none, face = none;  // (+); prev of the first is the last; (*)
  };
  struct FaceRecord {
    std::uint32_t first_loop = none;                                                 // (*)
    std::uint32_t shell[2] = {none, none};                                           // [0] (+)
    std::uint32_t next_in_shell[2] = {none, none}, prev_in_shell[2] = {none, none};  // prev of the first is the last
  };
  struct ShellRecord {
    std::uint32_t region = none, next = none, prev = none;  // (*) (+); prev of the first is the last
    std::uint32_t first_face_use = none, first_wire = none, vertex = none;
  };
  struct RegionRecord {
    std::uint32_t first_shell = none;  // (+)
    std::uint32_t filled = 0;          // (*)
  };

  enum Rows {
    vertex_rows,
    edge_rows,
    wire_rows,
    coedge_rows,
    point_rows,
    loop_rows,
    face_rows,
    shell_rows,
    region_rows,
    row_kinds
  };
  struct FreeRows {
    std::uint32_t first = none, count = 0;
  };

  static EdgeEnd decode(std::uint32_t code) {
    return code == none ? EdgeEnd{} : EdgeEnd{EdgeId(code >> 1), static_cast<int>(code & 1u)};
  }
  EdgeId wire_edge(std::uint32_t wire) const { return wire == none ? EdgeId() : EdgeId(wires_[wire].edge); }
  EdgeId next_wire(EdgeId e) const { return wire_edge(wires_[edges_[e.index()].first_use & ~tag].next); }

  Pages<VertexRecord> vertices_;
  Pages<EdgeRecord> edges_;
  Pages<WireRecord> wires_;
  Pages<CoedgeRecord> coedges_;
  Pages<PointUseRecord> point_uses_;
  Pages<LoopRecord> loops_;
  Pages<FaceRecord> faces_;
  Pages<ShellRecord> shells_;
  Pages<RegionRecord> regions_;
  std::array<FreeRows, row_kinds> free_;
};

}  // namespace aresta
