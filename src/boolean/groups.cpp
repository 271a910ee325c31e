// SPDX-License-Identifier: Apache-2.0
#include "boolean/groups.h"

#include <algorithm>

#include "boolean/errors.h"
#include "model/extract.h"

namespace aresta {

namespace {

class Gatherer {
 public:
  Gatherer(const Fragment& fragment, const Surroundings& around, const GroupSpec& spec)
      : fragment_(fragment), around_(around), k_(fragment.model->topology()), spec_(spec) {
    group_.name = spec.name;
    group_.vertex.assign(k_.vertex_count(), false);
    group_.edge.assign(k_.edge_count(), false);
    group_.face.assign(k_.face_count(), false);
    group_.listed_vertex = group_.vertex;
    group_.listed_edge = group_.edge;
    group_.listed_face = group_.face;
    group_.constraint = group_.face;
    bounding_ = group_.face;
    group_.region.assign(k_.region_count(), GroupCells::none);
  }

  Result<GroupCells> run() {
    for (const GroupMember& member : spec_.members) ARESTA_CHECK(add(member));
    for (const FaceId f : k_.faces()) {
      // Held both as a constraint and as some region's plain wall, it is a wall.
      if (bounding_[f.index()]) group_.constraint[f.index()] = false;
      if (!group_.face[f.index()]) continue;
      for (const LoopId l : k_.loops(f)) {
        for (const CoedgeId c : k_.coedges(l)) {
          if (!around_.inner_use[c.index()]) group_.edge[k_.edge(c).index()] = true;
        }
      }
    }
    for (const EdgeId e : k_.edges()) {
      if (group_.edge[e.index()]) group_.vertex[k_.start(e).index()] = group_.vertex[k_.end(e).index()] = true;
    }
    return std::move(group_);
  }

 private:
  Status add(const GroupMember& member) {
    if (member.operand >= fragment_.operands.size()) return unknown(member);
    const Model& operand = *fragment_.operands[member.operand];
    const Complex& k = operand.topology();
    const std::size_t limits[] = {k.vertex_count(), k.edge_count(), k.face_count(), k.region_count()};
    if (member.entity.index >= limits[static_cast<int>(member.entity.kind)]) return unknown(member);
    switch (member.entity.kind) {
      case EntityKind::vertex:
        mark_pieces(member, group_.listed_vertex, group_.vertex);
        break;
      case EntityKind::edge:
        mark_pieces(member, group_.listed_edge, group_.edge);
        add_edge_closure(member.operand, EdgeId(member.entity.index));
        break;
      case EntityKind::face:
        mark_pieces(member, group_.listed_face, group_.face);
        if (operand.is_constraint(FaceId(member.entity.index)))
          mark_constraint(member);
        else
          mark_wall(member);
        add_face_closure(member.operand, FaceId(member.entity.index));
        break;
      case EntityKind::region:
        return add_region(member);
    }
    return {};
  }

  Error unknown(const GroupMember& member) const {
    return Error{errors::unknown_member,
                 "group " + spec_.name + " lists an entity that its operand does not have",
                 {member.entity}};
  }

  void mark_pieces(const GroupMember& member, std::vector<bool>& first, std::vector<bool>& second) {
    for (const std::uint32_t piece : fragment_.pieces(member.operand, member.entity))
      first[piece] = second[piece] = true;
  }

  void mark_constraint(const GroupMember& member) { mark_pieces(member, group_.constraint, group_.listed_face); }

  void mark_wall(const GroupMember& member) { mark_pieces(member, bounding_, bounding_); }

  void add_edge_closure(std::uint32_t operand, EdgeId e) {
    const Complex& k = fragment_.operands[operand]->topology();
    mark_pieces({operand, e}, group_.edge, group_.edge);
    mark_pieces({operand, k.start(e)}, group_.vertex, group_.vertex);
    mark_pieces({operand, k.end(e)}, group_.vertex, group_.vertex);
  }

  void add_face_closure(std::uint32_t operand, FaceId f) {
    const Complex& k = fragment_.operands[operand]->topology();
    mark_pieces({operand, f}, group_.face, group_.face);
    for (const LoopId l : k.loops(f)) {
      if (k.is_vertex_loop(l)) mark_pieces({operand, k.loop_vertex(l)}, group_.vertex, group_.vertex);
      for (const CoedgeId c : k.coedges(l)) add_edge_closure(operand, k.edge(c));
    }
  }

  Status add_region(const GroupMember& member) {
    const Model& operand = *fragment_.operands[member.operand];
    const Complex& k = operand.topology();
    const RegionId r{member.entity.index};
    if (!operand.is_region(r)) return unknown(member);
    const auto id = static_cast<std::uint32_t>(regions_.size());
    regions_.push_back(member);
    for (const RegionId c : fragment_.labels.cells_in({member.operand, r})) {
      if (const std::uint32_t other = group_.region[c.index()]; other != GroupCells::none) {
        if (regions_[other] == member) return {};  // listed twice
        return Error{errors::regions_overlap,
                     "two regions of group " + spec_.name + " overlap: region " +
                         std::to_string(regions_[other].entity.index) + " of operand " +
                         std::to_string(regions_[other].operand) + " and region " +
                         std::to_string(member.entity.index) + " of operand " + std::to_string(member.operand),
                     {regions_[other].entity, member.entity},
                     {},
                     "unite them first, or list one of them"};
      }
      group_.region[c.index()] = id;
    }
    for (const ShellId s : k.shells(r)) {
      for (const FaceUse u : k.face_uses(s)) {
        const FaceId f = u.face();
        const bool internal = k.has_same_region_on_both_sides(f);
        if (internal && !spec_.internals) continue;
        if (operand.is_constraint(f))
          mark_constraint({member.operand, f});
        else
          mark_wall({member.operand, f});
        add_face_closure(member.operand, f);
      }
      if (!spec_.internals) continue;
      for (const EdgeId e : k.wires(s)) add_edge_closure(member.operand, e);
      if (const VertexId v = k.shell_vertex(s); v.valid())
        mark_pieces({member.operand, v}, group_.vertex, group_.vertex);
    }
    return {};
  }

  const Fragment& fragment_;
  const Surroundings& around_;
  const Complex& k_;
  const GroupSpec& spec_;
  GroupCells group_;
  std::vector<bool> bounding_;  // faces held other than as constraints
  std::vector<GroupMember> regions_;
};

/// What lies loose, dangling or isolated in a group's face belongs to the group when some group brought it in.
void close_over_inner(const Surroundings& around, std::vector<GroupCells>& groups) {
  const Complex& k = around.model.topology();
  std::vector<bool> any_vertex(k.vertex_count(), false), any_edge(k.edge_count(), false);
  for (const GroupCells& g : groups) {
    for (std::size_t i = 0; i < any_vertex.size(); ++i) any_vertex[i] = any_vertex[i] || g.vertex[i];
    for (std::size_t i = 0; i < any_edge.size(); ++i) any_edge[i] = any_edge[i] || g.edge[i];
  }
  for (GroupCells& g : groups) {
    for (const FaceId f : k.faces()) {
      if (!g.face[f.index()]) continue;
      for (const LoopId l : k.loops(f)) {
        if (const VertexId v = k.loop_vertex(l); v.valid() && any_vertex[v.index()]) g.vertex[v.index()] = true;
        for (const CoedgeId c : k.coedges(l)) {
          const EdgeId e = k.edge(c);
          if (!around.inner_use[c.index()]) continue;
          if (any_edge[e.index()]) g.edge[e.index()] = true;
          for (const VertexId v : {k.start(e), k.end(e)}) {
            if (any_vertex[v.index()]) g.vertex[v.index()] = true;
          }
        }
      }
    }
  }
}

}  // namespace

GroupSpec whole_operand(std::string name, std::uint32_t operand, const Model& model) {
  GroupSpec spec{std::move(name), {}};
  for (const EntityRef entity : model.listed()) spec.members.push_back({operand, entity});
  return spec;
}

int GroupCells::bounded_regions(const Complex& k, FaceId f) const {
  if (constraint[f.index()] || !face[f.index()]) return 0;
  const std::uint32_t front = region[k.region(FaceUse(f, 0)).index()], back = region[k.region(FaceUse(f, 1)).index()];
  if (front == back) return 0;
  return (front != none ? 1 : 0) + (back != none ? 1 : 0);
}

Surroundings::Surroundings(const Model& m) : model(m) {
  const Complex& k = model.topology();
  inner_use.assign(k.coedge_count(), false);
  for (const CoedgeId c : k.coedges()) inner_use[c.index()] = is_inner_edge(model, k.edge(c), k.face(c));
}

Result<std::vector<GroupCells>> gather_groups(const Fragment& fragment, const Surroundings& around,
                                              const std::vector<GroupSpec>& specs) {
  std::vector<GroupCells> groups;
  for (const GroupSpec& spec : specs) {
    ARESTA_TRY(auto group, Gatherer(fragment, around, spec).run());
    groups.push_back(std::move(group));
  }
  close_over_inner(around, groups);
  return groups;
}

}  // namespace aresta
