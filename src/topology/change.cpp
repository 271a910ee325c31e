// SPDX-License-Identifier: Apache-2.0
#include "topology/change.h"

#include <algorithm>

#include "topology/components.h"
#include "topology/editor.h"

namespace aresta {

namespace {

bool is_bare(const Complex& k, VertexId v) {
  return k.has_no_edge(v) && k.vertex_loops(v).empty() && !k.isolated_in_shell(v).valid();
}

std::vector<VertexId> vertices_of(const Complex& k, FaceId f) {
  std::vector<VertexId> result;
  for_each_vertex_of(k, Item(FaceUse(f, 0)), [&](VertexId v) { result.push_back(v); });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<RegionId> regions_at(const Complex& k, std::initializer_list<VertexId> vertices) {
  std::vector<RegionId> result;
  for (const VertexId v : vertices) {
    for_each_item_at(k, v, [&](Item item) { result.push_back(region_of(k, item)); });
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

class Maker {
 public:
  explicit Maker(Complex& k) : k_(k), edit_(k) {}

  // --- points and wires

  void make(PointChange& x) {
    x.vertex = edit_.make_vertex(x.vertex);
    edit_.put(Item(x.vertex), edit_.make_shell(x.region));
  }

  void back(const PointChange& x) {
    unisolate(x.vertex, {});
    edit_.free(x.vertex);
  }

  void make(WireChange& x) {
    x.edge = edit_.make_edge(x.edge);
    const ShellId s = shell_at(k_, x.start, x.region);
    unisolate(x.start, s);
    unisolate(x.end, s);
    edit_.attach({x.edge, 0}, x.start);
    edit_.attach({x.edge, 1}, x.end);
    edit_.put(Item(x.edge), s);
    edit_.unite_at(x.start);
    edit_.unite_at(x.end);
  }

  void back(const WireChange& x) {
    const ShellId s = k_.wire_shell(x.edge);
    edit_.take(Item(x.edge));
    edit_.detach({x.edge, 0});
    edit_.detach({x.edge, 1});
    edit_.free(x.edge);
    isolate_if_bare(x.start, x.region);
    isolate_if_bare(x.end, x.region);
    edit_.tidy(s, std::array{x.start, x.end});
  }

  // --- faces

  void make(FaceChange& x) {
    x.face = edit_.make_face(x.face);
    ShellId s;
    std::vector<CoedgeId> made;
    for (LoopPlacement& loop : x.loops) {
      loop.id = edit_.make_loop(loop.id);
      edit_.append_loop(x.face, loop.id);
      if (loop.coedges.empty()) {
        if (!s.valid()) s = shell_at(k_, loop.vertex, x.region);
        unisolate(loop.vertex, s);
        edit_.set_vertex_loop(loop.id, loop.vertex);
        continue;
      }
      CoedgeId prev;
      for (Placement& p : loop.coedges) {
        if (p.after_new >= 0) p.after = made[static_cast<std::size_t>(p.after_new)];
        p.id = edit_.make_coedge(p.id);
        made.push_back(p.id);
        edit_.set_edge(p.id, p.edge, p.reversed);
        edit_.insert_coedge(p.id, prev, loop.id);
        prev = p.id;
        if (k_.is_wire(p.edge)) {
          const ShellId old = k_.wire_shell(p.edge);
          if (!s.valid()) s = old;
          edit_.take(Item(p.edge));
          if (old != s && edit_.is_empty(old)) edit_.free(old);
        } else if (!s.valid()) {
          s = k_.shell(k_.side_after(p.after));
        }
        edit_.insert_radially(p.id, p.after);
      }
    }
    edit_.put(Item(FaceUse(x.face, 0)), s);
    edit_.put(Item(FaceUse(x.face, 1)), s);
    for (const VertexId v : vertices_of(k_, x.face)) edit_.unite_at(v);
    divide(FaceUse(x.face, 0), FaceUse(x.face, 1), x.division);
  }

  void back(const FaceChange& x) {
    if (x.division.region.valid()) edit_.merge_regions(x.region, x.division.region);
    const std::vector<VertexId> touched = vertices_of(k_, x.face);
    const ShellId s = k_.shell(FaceUse(x.face, 0));
    for (auto loop = x.loops.rbegin(); loop != x.loops.rend(); ++loop) {
      if (loop->coedges.empty()) {
        edit_.unset_vertex_loop(loop->id);
      } else {
        for (auto p = loop->coedges.rbegin(); p != loop->coedges.rend(); ++p) {
          const bool is_last_use = k_.radial(p->id) == p->id;
          edit_.remove_radially(p->id);
          if (is_last_use) edit_.put(Item(p->edge), s);
          edit_.free(p->id);
        }
      }
      edit_.remove_loop(loop->id);
      edit_.free(loop->id);
    }
    edit_.take(Item(FaceUse(x.face, 0)));
    edit_.take(Item(FaceUse(x.face, 1)));
    edit_.free(x.face);
    for (const VertexId v : touched) isolate_if_bare(v, x.region);
    edit_.tidy(s, touched);
  }

  void make(LoopPointChange& x) {
    x.vertex = edit_.make_vertex(x.vertex);
    for (std::size_t i = 0; i < x.loops.size(); ++i) {
      x.loops[i].id = edit_.make_loop(x.loops[i].id);
      x.loops[i].vertex = x.vertex;
      edit_.append_loop(x.faces[i], x.loops[i].id);
      edit_.set_vertex_loop(x.loops[i].id, x.vertex);
    }
    edit_.unite_at(x.vertex);
  }

  void back(const LoopPointChange& x) {
    const std::vector<RegionId> regions = regions_at(k_, {x.vertex});
    for (const LoopPlacement& loop : x.loops) {
      edit_.unset_vertex_loop(loop.id);
      edit_.remove_loop(loop.id);
      edit_.free(loop.id);
    }
    edit_.free(x.vertex);
    if (x.faces.size() == 1) return;
    std::vector<VertexId> seeds;
    for (const FaceId f : x.faces) seeds.push_back(vertices_of(k_, f).front());
    for (const RegionId r : regions) edit_.separate(r, seeds);
  }

  // --- edges across faces

  void make(AcrossChange& x) {
    x.edge = edit_.make_edge(x.edge);
    x.ahead = edit_.make_coedge(x.ahead);
    x.back = edit_.make_coedge(x.back);
    x.new_loop = edit_.make_loop(x.new_loop);
    x.new_face = edit_.make_face(x.new_face);
    edit_.append_loop(x.new_face, x.new_loop);
    const VertexId start = x.from.valid() ? k_.start(x.from) : x.vertex, end = x.to.valid() ? k_.start(x.to) : x.vertex;
    use_edge(x.edge, start, end, x.ahead, x.back, x.reversed);
    if (!x.from.valid()) {
      edit_.unset_vertex_loop(x.loop);
      edit_.insert_coedge(x.ahead, {}, x.loop);
      edit_.insert_coedge(x.back, {}, x.new_loop);
    } else if (x.from == x.to) {
      edit_.insert_coedge(x.ahead, k_.prev(x.from), x.loop);
      edit_.insert_coedge(x.back, {}, x.new_loop);
    } else {
      const CoedgeId before_from = k_.prev(x.from), before_to = k_.prev(x.to);
      edit_.link(before_from, x.ahead);
      edit_.link(x.ahead, x.to);
      edit_.link(before_to, x.back);
      edit_.link(x.back, x.from);
      edit_.set_loop(x.ahead, x.loop);
      edit_.set_first(x.loop, x.ahead);
      relabel(x.back, x.back, x.new_loop);
    }
    for (const LoopId l : x.moved) move_loop(l, x.new_face);
    for (int side = 0; side < 2; ++side) edit_.put(Item(FaceUse(x.new_face, side)), k_.shell(FaceUse(x.face, side)));
  }

  void back(const AcrossChange& x) {
    for (const LoopId l : x.moved) move_loop(l, x.face);
    for (int side = 0; side < 2; ++side) edit_.take(Item(FaceUse(x.new_face, side)));
    if (!x.from.valid()) {
      edit_.set_vertex_loop(x.loop, x.vertex);
    } else if (x.from == x.to) {
      edit_.remove_coedge(x.ahead);
    } else {
      edit_.link(k_.prev(x.ahead), x.from);
      edit_.link(k_.prev(x.back), x.to);
      relabel(x.from, x.to, x.loop);
      edit_.set_first(x.loop, x.from);
    }
    drop_edge(x.edge, x.ahead, x.back);
    edit_.free(x.new_loop);
    edit_.free(x.new_face);
  }

  void make(JoiningChange& x) {
    x.edge = edit_.make_edge(x.edge);
    x.ahead = edit_.make_coedge(x.ahead);
    x.back = edit_.make_coedge(x.back);
    use_edge(x.edge, x.start, x.end, x.ahead, x.back);
    edit_.set_loop(x.ahead, x.loop);
    edit_.set_loop(x.back, x.loop);
    if (x.from.valid()) {
      edit_.link(k_.prev(x.from), x.ahead);
    } else {
      edit_.unset_vertex_loop(x.loop);
    }
    if (x.to.valid()) {
      const CoedgeId before_to = k_.prev(x.to);
      relabel(x.to, x.to, x.loop);
      edit_.link(x.ahead, x.to);
      edit_.link(before_to, x.back);
    } else {
      edit_.unset_vertex_loop(x.other);
      edit_.link(x.ahead, x.back);
    }
    edit_.link(x.back, x.from.valid() ? x.from : x.ahead);
    edit_.set_first(x.loop, x.ahead);
    edit_.remove_loop(x.other);
    edit_.free(x.other);
  }

  void back(JoiningChange& x) {
    const LoopId other = x.other = edit_.make_loop(x.other);
    edit_.append_loop(k_.face(x.loop), other);
    const CoedgeId before_ahead = k_.prev(x.ahead), before_back = k_.prev(x.back);
    if (x.to.valid()) {
      edit_.link(before_back, x.to);
      relabel(x.to, x.to, other);
      edit_.set_first(other, x.to);
    } else {
      edit_.set_vertex_loop(other, x.end);
    }
    if (x.from.valid()) {
      edit_.link(before_ahead, x.from);
      edit_.set_first(x.loop, x.from);
    } else {
      edit_.set_vertex_loop(x.loop, x.start);
    }
    drop_edge(x.edge, x.ahead, x.back);
  }

  // --- merging

  void make(VertexMergeChange& x) {
    x.ends.clear();
    x.uses.clear();
    x.isolated_in = x.kept_isolated_in = x.wire_region = RegionId();
    if (const ShellId s = k_.isolated_in_shell(x.gone); s.valid()) {
      x.isolated_in = k_.region(s);
      unisolate(x.gone, {});
    } else if (const ShellId t = k_.isolated_in_shell(x.kept); t.valid()) {
      x.kept_isolated_in = k_.region(t);
      unisolate(x.kept, {});
    }
    x.points = k_.vertex_loops(x.gone);
    if (x.edge.valid()) contract(x);
    for (const LoopId l : x.points) {
      edit_.unset_vertex_loop(l);
      edit_.set_vertex_loop(l, x.kept);
    }
    while (!k_.has_no_edge(x.gone)) {
      const EdgeEnd end = *k_.edge_ends(x.gone).begin();
      x.ends.push_back(end);
      edit_.detach(end);
      edit_.attach(end, x.kept);
    }
    edit_.free(x.gone);
    isolate_if_bare(x.kept, x.wire_region);
    edit_.unite_at(x.kept);
  }

  void back(const VertexMergeChange& x) {
    const std::vector<RegionId> regions = regions_at(k_, {x.kept});
    if (k_.isolated_in_shell(x.kept).valid() && !x.isolated_in.valid()) unisolate(x.kept, {});
    const VertexId gone = edit_.make_vertex(x.gone);
    for (const EdgeEnd end : x.ends) {
      edit_.detach(end);
      edit_.attach(end, gone);
    }
    for (const LoopId l : x.points) {
      edit_.unset_vertex_loop(l);
      edit_.set_vertex_loop(l, gone);
    }
    if (x.edge.valid()) expand(x);
    if (x.isolated_in.valid()) edit_.put(Item(gone), edit_.make_shell(x.isolated_in));
    if (x.kept_isolated_in.valid()) edit_.put(Item(x.kept), edit_.make_shell(x.kept_isolated_in));
    for (const RegionId r : regions) edit_.separate(r, std::array{x.kept, gone});
  }

  void make(EdgeMergeChange& x) {
    if (k_.is_wire(x.gone)) {
      x.wire_region = k_.region(k_.wire_shell(x.gone));
      edit_.take(Item(x.gone));
    } else if (k_.is_wire(x.kept)) {
      x.wire_region = k_.region(k_.wire_shell(x.kept));
      edit_.take(Item(x.kept));
    }
    CoedgeId after = x.after;
    for (const CoedgeId c : x.uses) {
      edit_.set_edge(c, x.kept, k_.reversed(c) != x.flipped);
      edit_.insert_radially(c, after);
      after = c;
    }
    edit_.detach({x.gone, 0});
    edit_.detach({x.gone, 1});
    edit_.free(x.gone);
    if (x.after.valid() && !x.uses.empty()) {
      divide(k_.side_after(x.after), k_.side_after(x.uses.back()), x.division);
    }
  }

  void back(const EdgeMergeChange& x) {
    if (x.division.region.valid()) {
      const FaceUse stays = x.division.side == 1 ? k_.side_after(x.after) : k_.side_after(x.uses.back());
      edit_.merge_regions(k_.region(stays), x.division.region);
    }
    const EdgeId gone = edit_.make_edge(x.gone);
    edit_.attach({gone, 0}, x.flipped ? k_.end(x.kept) : k_.start(x.kept));
    edit_.attach({gone, 1}, x.flipped ? k_.start(x.kept) : k_.end(x.kept));
    move_uses(x.uses, gone, x.flipped, {});
    if (x.uses.empty()) {
      edit_.put(Item(gone), shell_at(k_, k_.start(gone), x.wire_region));
    } else if (!x.after.valid()) {
      edit_.put(Item(x.kept), shell_at(k_, k_.start(x.kept), x.wire_region));
    }
  }

  void make(DigonChange& x) {
    x.loop = k_.loop(x.kept_use);
    x.kept = k_.edge(x.kept_use);
    x.gone = k_.edge(x.gone_use);
    x.kept_reversed = k_.reversed(x.kept_use);
    x.flipped = k_.reversed(x.kept_use) == k_.reversed(x.gone_use);
    x.front = k_.region(FaceUse(x.face, 0));
    x.back = k_.region(FaceUse(x.face, 1));
    x.after = k_.radial_prev(x.kept_use);
    if (x.after == x.kept_use) x.after = CoedgeId();
    x.uses.clear();
    for (CoedgeId c = k_.radial(x.gone_use); c != x.gone_use; c = k_.radial(c)) x.uses.push_back(c);
    if (x.flipped) std::reverse(x.uses.begin(), x.uses.end());

    const std::array shells{k_.shell(FaceUse(x.face, 0)), k_.shell(FaceUse(x.face, 1))};
    edit_.remove_radially(x.kept_use);
    CoedgeId after = x.after;
    for (const CoedgeId c : x.uses) {
      edit_.set_edge(c, x.kept, k_.reversed(c) != x.flipped);
      edit_.insert_radially(c, after);
      after = c;
    }
    if (!after.valid()) edit_.put(Item(x.kept), shells[0]);
    edit_.take(Item(FaceUse(x.face, 0)));
    edit_.take(Item(FaceUse(x.face, 1)));
    edit_.free(x.kept_use);
    edit_.free(x.gone_use);
    edit_.free(x.loop);
    edit_.free(x.face);
    edit_.detach({x.gone, 0});
    edit_.detach({x.gone, 1});
    edit_.free(x.gone);
  }

  void back(const DigonChange& x) {
    const VertexId a = k_.start(x.kept), b = k_.end(x.kept);
    const std::array shells{shell_at(k_, a, x.front), shell_at(k_, a, x.back)};
    if (k_.is_wire(x.kept)) edit_.take(Item(x.kept));
    edit_.make_face(x.face);
    edit_.make_loop(x.loop);
    edit_.append_loop(x.face, x.loop);
    edit_.make_edge(x.gone);
    edit_.attach({x.gone, 0}, x.flipped ? b : a);
    edit_.attach({x.gone, 1}, x.flipped ? a : b);
    edit_.make_coedge(x.gone_use);
    edit_.make_coedge(x.kept_use);
    edit_.set_edge(x.gone_use, x.gone, x.flipped == x.kept_reversed);
    edit_.insert_radially(x.gone_use, {});
    move_uses(x.uses, x.gone, x.flipped, x.gone_use);
    edit_.set_edge(x.kept_use, x.kept, x.kept_reversed);
    edit_.insert_radially(x.kept_use, x.after);
    edit_.insert_coedge(x.kept_use, {}, x.loop);
    edit_.insert_coedge(x.gone_use, x.kept_use, x.loop);
    edit_.put(Item(FaceUse(x.face, 0)), shells[0]);
    edit_.put(Item(FaceUse(x.face, 1)), shells[1]);
  }

  void make(FaceMergeChange& x) {
    const FaceUse inner(x.kept, x.kept_side), gone_inner(x.gone, x.flipped ? x.kept_side : 1 - x.kept_side);
    const ShellId between = k_.shell(inner), beyond = k_.shell(gone_inner.opposite());
    edit_.take(Item(inner));
    edit_.put(Item(inner), beyond);
    edit_.take(Item(gone_inner));
    edit_.take(Item(gone_inner.opposite()));
    edit_.free(between);
    edit_.free(x.region);
    for (const auto& pair : x.loops) {
      if (pair.uses.empty()) edit_.unset_vertex_loop(pair.id);
      for (const auto& use : pair.uses) {
        edit_.remove_radially(use.id);
        edit_.free(use.id);
      }
      edit_.free(pair.id);
    }
    edit_.free(x.gone);
  }

  void back(const FaceMergeChange& x) {
    const FaceUse inner(x.kept, x.kept_side), gone_inner(x.gone, x.flipped ? x.kept_side : 1 - x.kept_side);
    edit_.make_face(x.gone);
    for (auto pair = x.loops.rbegin(); pair != x.loops.rend(); ++pair) {
      edit_.make_loop(pair->id);
      edit_.append_loop(x.gone, pair->id);
      if (pair->uses.empty()) edit_.set_vertex_loop(pair->id, k_.loop_vertex(pair->beside));
      // Taken out in order, so put back from the last: where an edge occurs twice, the order about it comes out right.
      for (auto use = pair->uses.rbegin(); use != pair->uses.rend(); ++use) {
        edit_.make_coedge(use->id);
        edit_.set_edge(use->id, k_.edge(use->beside), k_.reversed(use->beside) != x.flipped);
        edit_.insert_radially(use->id, use->is_after ? use->beside : k_.radial_prev(use->beside));
      }
      CoedgeId prev;
      for (const auto& use : pair->uses) {
        edit_.insert_coedge(use.id, prev, pair->id);
        prev = use.id;
      }
    }
    const ShellId beyond = k_.shell(inner);
    const ShellId between = edit_.make_shell(edit_.make_region(x.filled, x.region));
    edit_.take(Item(inner));
    edit_.put(Item(inner), between);
    edit_.put(Item(gone_inner), between);
    edit_.put(Item(gone_inner.opposite()), beyond);
  }

 private:
  /// The vertex, if isolated, is so no longer; its shell goes unless it is `stays`.
  void unisolate(VertexId v, ShellId stays) {
    const ShellId s = k_.isolated_in_shell(v);
    if (!s.valid()) return;
    edit_.take(Item(v));
    if (s != stays) edit_.free(s);
  }

  void isolate_if_bare(VertexId v, RegionId r) {
    if (is_bare(k_, v)) edit_.put(Item(v), edit_.make_shell(r));
  }

  void use_edge(EdgeId e, VertexId start, VertexId end, CoedgeId ahead, CoedgeId back, bool reversed = false) {
    edit_.attach({e, reversed ? 1 : 0}, start);
    edit_.attach({e, reversed ? 0 : 1}, end);
    edit_.set_edge(ahead, e, reversed);
    edit_.set_edge(back, e, !reversed);
    edit_.insert_radially(ahead, {});
    edit_.insert_radially(back, ahead);
  }

  void drop_edge(EdgeId e, CoedgeId ahead, CoedgeId back) {
    edit_.detach({e, 0});
    edit_.detach({e, 1});
    edit_.free(back);
    edit_.free(ahead);
    edit_.free(e);
  }

  void relabel(CoedgeId from, CoedgeId until, LoopId l) {
    CoedgeId c = from;
    do {
      edit_.set_loop(c, l);
      c = k_.next(c);
    } while (c != until);
    if (from == until) edit_.set_first(l, from);
  }

  void move_loop(LoopId l, FaceId to) {
    edit_.remove_loop(l);
    edit_.append_loop(to, l);
  }

  /// Takes uses out of their edge's cycle and makes them, in their own order, the cycle of `to`, behind `after`.
  void move_uses(std::vector<CoedgeId> uses, EdgeId to, bool flipped, CoedgeId after) {
    for (const CoedgeId c : uses) edit_.remove_radially(c);
    if (flipped) std::reverse(uses.begin(), uses.end());
    for (const CoedgeId c : uses) {
      edit_.set_edge(c, to, k_.reversed(c) != flipped);
      edit_.insert_radially(c, after);
      after = c;
    }
  }

  void divide(FaceUse a, FaceUse b, Division& d) {
    std::vector<FaceUse> part;
    if (d.extent == Division::Extent::nothing || sides_connected(k_, a, b, d.side == 1, &part)) return;
    std::vector<Item> items(part.begin(), part.end());
    for (const Item item : d.others) {
      if (item.kind == Item::Kind::side) {
        const auto component = side_component(k_, item.side());
        items.insert(items.end(), component.begin(), component.end());
      } else {
        items.push_back(item);
      }
    }
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    const RegionId old = d.of = region_of(k_, items.front());
    d.region = edit_.make_region(d.filled, d.region);
    edit_.move_to_region(items, d.region);
    if (d.extent == Division::Extent::found) follow(items, old, d.side == 1 ? a : b, d.region);
  }

  /// A connected complex meets a region in one shell. So where items have left a shell that has fallen apart, all of it
  /// but the part that `stays` is in goes with them.
  void follow(std::vector<Item> items, RegionId old, FaceUse stays, RegionId region) {
    while (!items.empty()) {
      std::vector<VertexId> touched;
      for (const Item item : items) for_each_vertex_of(k_, item, [&](VertexId v) { touched.push_back(v); });
      std::sort(touched.begin(), touched.end());
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      for (const VertexId v : touched) edit_.unite_at(v);
      items.clear();
      for (const VertexId v : touched) {
        const ShellId s = shell_at(k_, v, old);
        if (!s.valid() || s == k_.shell(stays)) continue;
        std::vector<Item> left;
        for (const FaceUse u : k_.face_uses(s)) left.push_back(u);
        for (const EdgeId e : k_.wires(s)) left.push_back(e);
        edit_.move_to_region(left, region);
        items.insert(items.end(), left.begin(), left.end());
      }
    }
  }

  /// Takes the edge of a contraction out of all loops, or out of its shell.
  void contract(VertexMergeChange& x) {
    x.kept_is_start = k_.start(x.edge) == x.kept;
    if (k_.is_wire(x.edge)) {
      const ShellId s = k_.wire_shell(x.edge);
      x.wire_region = k_.region(s);
      edit_.take(Item(x.edge));
      if (edit_.is_empty(s)) edit_.free(s);
    } else {
      std::vector<CoedgeId> cycle;
      for (const CoedgeId c : k_.coedges(x.edge)) cycle.push_back(c);
      for (auto it = cycle.rbegin(); it != cycle.rend(); ++it) {
        const CoedgeId c = *it;
        const LoopId l = k_.loop(c);
        VertexMergeChange::Use use{c, k_.reversed(c), l, k_.prev(c), k_.radial_prev(c)};
        if (use.after == c) use.after = CoedgeId();
        edit_.remove_radially(c);
        if (use.prev == c) {
          use.prev = CoedgeId();
          edit_.set_vertex_loop(l, x.kept);
        } else {
          edit_.remove_coedge(c);
        }
        edit_.free(c);
        x.uses.push_back(use);
      }
      std::reverse(x.uses.begin(), x.uses.end());
    }
    edit_.detach({x.edge, 0});
    edit_.detach({x.edge, 1});
    edit_.free(x.edge);
  }

  void expand(const VertexMergeChange& x) {
    edit_.make_edge(x.edge);
    edit_.attach({x.edge, x.kept_is_start ? 0 : 1}, x.kept);
    edit_.attach({x.edge, x.kept_is_start ? 1 : 0}, x.gone);
    for (const auto& use : x.uses) {
      edit_.make_coedge(use.id);
      edit_.set_edge(use.id, x.edge, use.reversed);
      if (!use.prev.valid()) edit_.unset_vertex_loop(use.loop);
      edit_.insert_coedge(use.id, use.prev, use.loop);
      edit_.insert_radially(use.id, use.after);
    }
    if (x.uses.empty()) {
      ShellId s = shell_at(k_, x.kept, x.wire_region);
      if (!s.valid()) s = shell_at(k_, x.gone, x.wire_region);
      if (!s.valid()) s = edit_.make_shell(x.wire_region);
      edit_.put(Item(x.edge), s);
    }
  }

  Complex& k_;
  Editor edit_;
};

}  // namespace

namespace {

void run(Complex& k, Change& change, bool forward) {
  std::visit(
      [&](auto& x) {
        if (forward) {
          Maker(k).make(x);
        } else {
          Maker(k).back(x);
        }
      },
      change.what);
}

}  // namespace

void make(Complex& k, Change& change) {
  run(k, change, !change.reversed);
}

void take_back(Complex& k, Change& change) {
  run(k, change, change.reversed);
}

}  // namespace aresta
