// SPDX-License-Identifier: Apache-2.0
// What operators change records with: allocation of rows, links of lists, and the shells and regions that follow from
// them. No check of what is meant; that is for operators.h.
//
// Guarantees: each function leaves every list linked. The functions on shells and regions restore, after links have
// changed, that a shell is what is connected (through vertices) in one region, and that sides which share a sector lie
// in one region.
//
// Cost: lists in constant time, save for the radial predecessor (uses of the edge). Searches go on from all their
// starts in turn and stop as soon as one part is left, so that they cost the smaller parts only; merging shells
// relabels the smaller one.
#pragma once

#include <span>

#include "topology/complex.h"
#include "topology/item.h"

namespace aresta {

class Editor {
 public:
  explicit Editor(Complex& k) : k_(k) {}

  // Rows. A wanted id must not be live; an invalid one leaves the choice.
  VertexId make_vertex(VertexId wanted = {});
  EdgeId make_edge(EdgeId wanted = {});
  CoedgeId make_coedge(CoedgeId wanted = {});
  LoopId make_loop(LoopId wanted = {});
  FaceId make_face(FaceId wanted = {});
  RegionId make_region(bool filled, RegionId wanted = {});
  ShellId make_shell(RegionId region);
  void free(VertexId v);
  void free(EdgeId e);
  void free(CoedgeId c);
  void free(LoopId l);
  void free(FaceId f);
  void free(RegionId r);
  void free(ShellId s);  ///< leaves its region's list
  void set_filled(RegionId r, bool filled) { k_.regions_.edit(r.index()).filled = filled ? 1 : 0; }

  // Edge ends at vertices.
  void attach(EdgeEnd end, VertexId v);
  void detach(EdgeEnd end);

  // Loops of a face, coedges of a loop. A loop without coedges is a vertex loop.
  void append_loop(FaceId f, LoopId l);
  void remove_loop(LoopId l);
  void set_vertex_loop(LoopId l, VertexId v);  ///< the loop becomes this vertex
  void unset_vertex_loop(LoopId l);            ///< before the loop gets coedges or goes
  /// Puts c behind `prev` in prev's loop, or makes it the only coedge of `l`.
  void insert_coedge(CoedgeId c, CoedgeId prev, LoopId l);
  void remove_coedge(CoedgeId c);
  void link(CoedgeId c, CoedgeId next);
  void set_loop(CoedgeId c, LoopId l) { k_.coedges_.edit(c.index()).loop = l.value; }
  void set_first(LoopId l, CoedgeId c) { k_.loops_.edit(l.index()).first = c.value; }
  void set_face(LoopId l, FaceId f) { k_.loops_.edit(l.index()).face = f.value; }

  // The radial cycle of an edge.
  void set_edge(CoedgeId c, EdgeId e, bool reversed);
  /// Puts c behind `after` about its edge, or makes it the edge's only coedge.
  void insert_radially(CoedgeId c, CoedgeId after);
  void remove_radially(CoedgeId c);

  // Items of shells. An item put into a shell must be in none.
  void put(Item item, ShellId s);
  void take(Item item);
  bool is_empty(ShellId s) const;

  // Shells and regions.
  /// Joins shells of one region that meet at the vertex.
  void unite_at(VertexId v);
  /// Splits the shell that holds items of `r` at the seeds, where these are no longer connected.
  void separate(RegionId r, std::span<const VertexId> seeds);
  /// Drops the shell when nothing is in it, else separates it.
  void tidy(ShellId s, std::span<const VertexId> seeds);
  /// Moves items to another region; they must be whole components of sides, wires and points.
  void move_to_region(std::span<const Item> items, RegionId to);
  /// Everything in `from` goes to `to`; `from` is killed.
  void merge_regions(RegionId to, RegionId from);

  const Complex& complex() const { return k_; }

 private:
  template <class Rows, class Link>
  std::uint32_t allocate(Rows& rows, Complex::Rows kind, std::uint32_t wanted, Link&& free_link);
  template <class Rows, class Link>
  void release(Rows& rows, Complex::Rows kind, std::uint32_t row, Link&& free_link);
  void merge_shells(ShellId a, ShellId b);
  void smaller_first(ShellId& a, ShellId& b) const;

  Complex& k_;
};

}  // namespace aresta
