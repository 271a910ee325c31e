// SPDX-License-Identifier: Apache-2.0
// Groups of entities of any dimension, re-expressed in the cells of a fragment (steps 0 and 1 of a boolean).
//
// A listed region stays one region: a set of cells. A group is closed downwards: a region brings its bounding faces
// and, unless internals are left out, the faces, wires and points it had inside before the imprint; a face its edges
// and what lies loose, dangling or isolated in it; an edge its vertices.
#pragma once

#include "fragment/fragment.h"

namespace aresta {

/// An entity of one of the fragment's operands.
struct GroupMember {
  std::uint32_t operand = 0;
  EntityRef entity;
  constexpr auto operator<=>(const GroupMember&) const = default;
};

struct GroupSpec {
  std::string name;
  std::vector<GroupMember> members;
  bool internals = true;  ///< bring what listed regions had inside
};

/// All that an operand lists as a whole: see Model::listed.
GroupSpec whole_operand(std::string name, std::uint32_t operand, const Model& model);

/// A group in terms of a fragment's entities and cells.
struct GroupCells {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::string name;
  std::vector<bool> vertex, edge, face;                       ///< the closure
  std::vector<bool> listed_vertex, listed_edge, listed_face;  ///< listed by themselves, or constraints
  std::vector<bool> constraint;                               ///< faces that bound no region whatever they separate
  std::vector<std::uint32_t> region;                          ///< per cell: the listed region that contains it, or none

  /// How many listed regions the face bounds: 0, 1 or 2.
  int bounded_regions(const Complex& k, FaceId f) const;
};

/// Entities by cells around them, and which edges and vertices merely lie inside a face; for one fragment.
struct Surroundings {
  explicit Surroundings(const Model& model);
  const Model& model;
  std::vector<bool> inner_use;  ///< per coedge: its edge is loose or dangling in its face

  template <class Visit>
  void cells_around(VertexId v, Visit visit) const;
  template <class Visit>
  void cells_around(EdgeId e, Visit visit) const;
};

/// Errors: unknown_member; regions_overlap, naming the regions (a group's regions may meet only in their boundaries).
Result<std::vector<GroupCells>> gather_groups(const Fragment& fragment, const Surroundings& around,
                                              const std::vector<GroupSpec>& specs);

template <class Visit>
void Surroundings::cells_around(EdgeId e, Visit visit) const {
  const Complex& k = model.topology();
  if (k.is_wire(e)) return visit(k.region(k.wire_shell(e)));
  for (const CoedgeId c : k.coedges(e)) visit(k.region(k.side_after(c)));
}

template <class Visit>
void Surroundings::cells_around(VertexId v, Visit visit) const {
  const Complex& k = model.topology();
  if (const ShellId s = k.isolated_in_shell(v); s.valid()) visit(k.region(s));
  for (const LoopId l : k.vertex_loops(v)) {
    for (int side = 0; side < 2; ++side) visit(k.region(FaceUse(k.face(l), side)));
  }
  for (const EdgeEnd end : k.edge_ends(v)) cells_around(end.edge, visit);
}

}  // namespace aresta
