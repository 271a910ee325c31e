// SPDX-License-Identifier: Apache-2.0
#include "boolean/select.h"

#include <algorithm>

#include "base/union_find.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = GroupCells::none;

class Selector {
 public:
  Selector(const Surroundings& around, const std::vector<GroupCells>& groups, Operation operation)
      : around_(around), k_(around.model.topology()), groups_(groups), operation_(operation) {
    out_.vertices.resize(k_.vertex_count());
    out_.edges.resize(k_.edge_count());
    out_.faces.resize(k_.face_count());
    out_.constraint.assign(k_.face_count(), false);
  }

  Decisions run(const Regularisation& regularisation) {
    find_volume();
    for (const FaceId f : k_.faces()) decide_face(f);
    gather_bounds();
    for (const EdgeId e : k_.edges()) decide_edge(e);
    for (const VertexId v : k_.vertices()) decide_vertex(v);
    support();
    drop_floating_edges();
    drop_floating_vertices();
    if (regularisation.regularise) regularise(regularisation.keep_partitions);
    return std::move(out_);
  }

 private:
  bool contains(const GroupCells& g, RegionId cell) const { return g.region[cell.index()] != none; }

  void find_volume() {
    out_.volume.assign(k_.region_count(), false);
    for (std::size_t c = 1; c < k_.region_count(); ++c) {
      std::size_t inside = 0;
      for (const GroupCells& g : groups_) inside += g.region[c] != none;
      switch (operation_) {
        case Operation::unite:
          out_.volume[c] = inside > 0;
          break;
        case Operation::intersect:
          out_.volume[c] = inside == groups_.size();
          break;
        case Operation::subtract:
          out_.volume[c] = groups_[0].region[c] != none && groups_[1].region[c] == none;
          break;
      }
    }
  }

  struct Held {
    bool any = false;       // some group holds the entity
    bool in_some = false;   // it lies inside a region of a group that does not hold it
    bool out_some = false;  // it lies outside a group that does not hold it
    std::size_t count = 0, first = 0;
  };

  template <class Holds>
  Held held(Holds holds, RegionId cell) const {
    Held h;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (holds(groups_[i])) {
        if (h.count++ == 0) h.first = i;
      } else {
        (contains(groups_[i], cell) ? h.in_some : h.out_some) = true;
      }
    }
    h.any = h.count > 0;
    return h;
  }

  Class class_of(const Held& h) const {
    bool in = h.in_some, out = h.out_some;
    if (operation_ == Operation::intersect) {
      in = in && !out;
    } else {
      out = out && !in;
    }
    // With two groups an entity that both hold is neither in nor out.
    const bool a = h.first == 0;
    if (h.count >= 2 && !(operation_ == Operation::intersect ? out : in)) return Class::shared;
    if (in) return a ? Class::a_in_b : Class::b_in_a;
    return a ? Class::a_out_b : Class::b_out_a;
  }

  int most_bounded_by_own(FaceId f) const {
    int most = 0;
    for (const GroupCells& g : groups_) most = std::max(most, g.bounded_regions(k_, f));
    return most;
  }

  bool bounds_two_of_all_own(FaceId f) const {
    return std::all_of(groups_.begin(), groups_.end(),
                       [&](const GroupCells& g) { return !g.face[f.index()] || g.bounded_regions(k_, f) == 2; });
  }

  /// Two regions of one group, or one each of two groups on opposite sides.
  bool is_wall(FaceId f) const {
    bool on_side[2] = {false, false};
    for (const GroupCells& g : groups_) {
      const int bounded = g.bounded_regions(k_, f);
      if (bounded == 2) return true;
      if (bounded == 1) on_side[contains(g, k_.region(FaceUse(f, 0))) ? 0 : 1] = true;
    }
    return on_side[0] && on_side[1];
  }

  void decide_face(FaceId f) {
    Decision& d = out_.faces[f.index()];
    const RegionId front = k_.region(FaceUse(f, 0)), back = k_.region(FaceUse(f, 1));
    const Held h = held([&](const GroupCells& g) { return bool(g.face[f.index()]); }, front);
    d.sides = static_cast<std::uint8_t>(out_.volume[front.index()] + out_.volume[back.index()]);
    if (!h.any) return;
    d.in_groups = true;
    d.reason = Reason::table;
    d.cls = class_of(h);
    d.rule = face_rule(d.cls, d.sides, operation_);
    switch (d.rule) {
      case Rule::keep:
        d.kept = true;
        break;
      case Rule::remove_if_bounds_own:
        d.kept = most_bounded_by_own(f) == 0;
        break;
      case Rule::remove_if_bounds_two_own:
        d.kept = most_bounded_by_own(f) < 2;
        break;
      case Rule::remove_if_bounds_two_all:
        d.kept = !bounds_two_of_all_own(f);
        break;
      case Rule::remove_if_wall:
        d.kept = !is_wall(f);
        break;
      case Rule::keep_if_one_side:
        d.kept = d.sides == 1;
        break;
      default:
        d.kept = false;
    }
    out_.constraint[f.index()] = d.kept && most_bounded_by_own(f) == 0;
  }

  /// Which edges and vertices bound a region of a group that holds them, or lie inside a face, kept or removed.
  void gather_bounds() {
    edge_bounds_region_.assign(k_.edge_count(), false);
    edge_bounds_face_ = edge_inner_removed_ = edge_bounds_region_;
    vertex_bounds_region_.assign(k_.vertex_count(), false);
    vertex_inner_removed_ = vertex_has_group_edge_ = vertex_bounds_region_;
    for (const FaceId f : k_.faces()) {
      const Decision& d = out_.faces[f.index()];
      if (!d.in_groups) continue;
      const bool bounds = most_bounded_by_own(f) > 0;
      for (const LoopId l : k_.loops(f)) {
        if (const VertexId v = k_.loop_vertex(l); v.valid() && !d.kept) vertex_inner_removed_[v.index()] = true;
        for (const CoedgeId c : k_.coedges(l)) {
          const EdgeId e = k_.edge(c);
          if (around_.inner_use[c.index()]) {
            if (!d.kept) {
              edge_inner_removed_[e.index()] = true;
              vertex_inner_removed_[k_.start(e).index()] = vertex_inner_removed_[k_.end(e).index()] = true;
            }
          } else {
            edge_bounds_face_[e.index()] = true;
            if (bounds) edge_bounds_region_[e.index()] = true;
          }
        }
      }
    }
    for (const EdgeId e : k_.edges()) {
      const bool in_groups =
          std::any_of(groups_.begin(), groups_.end(), [&](const GroupCells& g) { return bool(g.edge[e.index()]); });
      for (const VertexId v : {k_.start(e), k_.end(e)}) {
        if (edge_bounds_region_[e.index()]) vertex_bounds_region_[v.index()] = true;
        if (in_groups) vertex_has_group_edge_[v.index()] = true;
      }
    }
  }

  template <class Entity>
  RegionId some_cell(Entity entity) const {
    RegionId cell;
    around_.cells_around(entity, [&](RegionId c) { cell = c; });
    return cell;
  }

  void apply_low_rule(Decision& d, const Held& h, bool bounds_region, bool inner_removed) {
    if (!h.any) return;
    d.in_groups = true;
    d.reason = Reason::table;
    d.cls = class_of(h);
    d.rule = low_rule(d.cls, operation_);
    d.kept = d.rule == Rule::keep || (d.rule == Rule::remove_if_bounds_or_inner && !bounds_region && !inner_removed);
  }

  void decide_edge(EdgeId e) {
    const Held h = held([&](const GroupCells& g) { return bool(g.edge[e.index()]); }, some_cell(e));
    apply_low_rule(out_.edges[e.index()], h, edge_bounds_region_[e.index()], edge_inner_removed_[e.index()]);
  }

  void decide_vertex(VertexId v) {
    const Held h = held([&](const GroupCells& g) { return bool(g.vertex[v.index()]); }, some_cell(v));
    apply_low_rule(out_.vertices[v.index()], h, vertex_bounds_region_[v.index()], vertex_inner_removed_[v.index()]);
  }

  static void keep_as_support(Decision& d) {
    if (d.kept) return;
    d.kept = true;
    d.reason = Reason::support;
  }

  void support() {
    edge_supports_.assign(k_.edge_count(), false);
    for (const CoedgeId c : k_.coedges()) {
      if (!out_.faces[k_.face(c).index()].kept || around_.inner_use[c.index()]) continue;
      edge_supports_[k_.edge(c).index()] = true;
      keep_as_support(out_.edges[k_.edge(c).index()]);
    }
    support_vertices();
  }

  void support_vertices() {
    for (const EdgeId e : k_.edges()) {
      if (!out_.edges[e.index()].kept) continue;
      keep_as_support(out_.vertices[k_.start(e).index()]);
      keep_as_support(out_.vertices[k_.end(e).index()]);
    }
  }

  template <class Entity>
  bool surrounded_by_volume(Entity entity) const {
    bool all = true;
    around_.cells_around(entity, [&](RegionId c) { all = all && out_.volume[c.index()]; });
    return all;
  }

  bool listed(const std::vector<bool> GroupCells::*list, std::size_t index) const {
    return std::any_of(groups_.begin(), groups_.end(), [&](const GroupCells& g) { return bool((g.*list)[index]); });
  }

  void drop_floating_edges() {
    std::vector<EdgeId> dropped;
    for (const EdgeId e : k_.edges()) {
      Decision& d = out_.edges[e.index()];
      if (!d.kept || edge_supports_[e.index()] || !surrounded_by_volume(e)) continue;
      if (listed(&GroupCells::listed_edge, e.index())) continue;
      if (!edge_bounds_face_[e.index()] && !edge_inner_removed_[e.index()]) continue;
      d.kept = false;
      d.reason = Reason::leftover;
      dropped.push_back(e);
    }
    // Vertices kept only because a dropped edge had them are judged anew.
    for (const EdgeId e : dropped) {
      for (const VertexId v : {k_.start(e), k_.end(e)}) {
        Decision& d = out_.vertices[v.index()];
        if (d.reason == Reason::support) d.kept = false;
      }
    }
    support_vertices();
  }

  void drop_floating_vertices() {
    std::vector<bool> supports(k_.vertex_count(), false);
    for (const EdgeId e : k_.edges()) {
      if (out_.edges[e.index()].kept) supports[k_.start(e).index()] = supports[k_.end(e).index()] = true;
    }
    for (const VertexId v : k_.vertices()) {
      Decision& d = out_.vertices[v.index()];
      if (!d.kept || supports[v.index()] || !surrounded_by_volume(v)) continue;
      if (listed(&GroupCells::listed_vertex, v.index())) continue;
      if (!vertex_has_group_edge_[v.index()] && !vertex_inner_removed_[v.index()]) continue;
      d.kept = false;
      d.reason = Reason::leftover;
    }
  }

  static void take_away(Decision& d) {
    if (!d.kept) return;
    d.kept = false;
    d.reason = Reason::regularised;
  }

  /// Only faces with the result's volume on exactly one side stay, and what bounds them.
  void regularise(bool keep_partitions) {
    UnionFind cells(k_.region_count());
    for (const FaceId f : k_.faces()) {
      if (!out_.faces[f.index()].kept) cells.unite(k_.region(FaceUse(f, 0)).index(), k_.region(FaceUse(f, 1)).index());
    }
    std::vector<bool> edge_needed(k_.edge_count(), false), vertex_needed(k_.vertex_count(), false);
    for (const FaceId f : k_.faces()) {
      Decision& d = out_.faces[f.index()];
      const bool partition =
          d.sides == 2 && cells.find(k_.region(FaceUse(f, 0)).index()) != cells.find(k_.region(FaceUse(f, 1)).index());
      if (d.sides != 1 && !(keep_partitions && partition)) take_away(d);
      out_.constraint[f.index()] = out_.constraint[f.index()] && d.kept;
    }
    for (const CoedgeId c : k_.coedges()) {
      if (out_.faces[k_.face(c).index()].kept && !around_.inner_use[c.index()]) edge_needed[k_.edge(c).index()] = true;
    }
    for (const EdgeId e : k_.edges()) {
      if (!edge_needed[e.index()])
        take_away(out_.edges[e.index()]);
      else
        vertex_needed[k_.start(e).index()] = vertex_needed[k_.end(e).index()] = true;
    }
    for (const VertexId v : k_.vertices()) {
      if (!vertex_needed[v.index()]) take_away(out_.vertices[v.index()]);
    }
  }

  const Surroundings& around_;
  const Complex& k_;
  const std::vector<GroupCells>& groups_;
  Operation operation_;
  Decisions out_;
  std::vector<bool> edge_bounds_region_, edge_bounds_face_, edge_inner_removed_, edge_supports_;
  std::vector<bool> vertex_bounds_region_, vertex_inner_removed_, vertex_has_group_edge_;
};

std::vector<bool> kept(const std::vector<Decision>& decisions) {
  std::vector<bool> result(decisions.size());
  for (std::size_t i = 0; i < decisions.size(); ++i) result[i] = decisions[i].kept;
  return result;
}

}  // namespace

Decisions decide(const Surroundings& around, const std::vector<GroupCells>& groups, Operation operation,
                 const Regularisation& regularisation) {
  return Selector(around, groups, operation).run(regularisation);
}

GroupCells as_group(const Surroundings& around, const Decisions& decisions, std::string name) {
  const Complex& k = around.model.topology();
  GroupCells g;
  g.name = std::move(name);
  g.vertex = kept(decisions.vertices);
  g.edge = kept(decisions.edges);
  g.face = kept(decisions.faces);
  g.constraint = decisions.constraint;
  g.listed_face = decisions.constraint;
  g.listed_vertex.assign(k.vertex_count(), false);
  g.listed_edge.assign(k.edge_count(), false);
  UnionFind cells(k.region_count());
  for (const FaceId f : k.faces()) {
    if (!g.face[f.index()]) cells.unite(k.region(FaceUse(f, 0)).index(), k.region(FaceUse(f, 1)).index());
  }
  g.region.assign(k.region_count(), GroupCells::none);
  for (std::size_t c = 1; c < k.region_count(); ++c) {
    if (decisions.volume[c]) g.region[c] = cells.find(c);
  }
  std::vector<bool> bounds_face(k.edge_count(), false), has_edge(k.vertex_count(), false);
  for (const CoedgeId c : k.coedges()) {
    if (g.face[k.face(c).index()] && !around.inner_use[c.index()]) bounds_face[k.edge(c).index()] = true;
  }
  for (const EdgeId e : k.edges()) {
    if (!g.edge[e.index()]) continue;
    has_edge[k.start(e).index()] = has_edge[k.end(e).index()] = true;
    g.listed_edge[e.index()] = !bounds_face[e.index()];
  }
  for (const VertexId v : k.vertices()) g.listed_vertex[v.index()] = g.vertex[v.index()] && !has_edge[v.index()];
  return g;
}

Selection to_selection(const Decisions& d) {
  return {kept(d.vertices), kept(d.edges), kept(d.faces), d.volume, d.constraint};
}

}  // namespace aresta
