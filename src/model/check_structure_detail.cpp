// SPDX-License-Identifier: Apache-2.0
// Links of the complex. Every id is looked at before it is followed, every walk is bounded by the number of records.
#include <algorithm>
#include <map>

#include "base/union_find.h"
#include "model/check_detail.h"

namespace aresta::model_detail {

namespace {

class StructureCheck {
 public:
  StructureCheck(const Model& model, Findings& findings) : model_(model), k_(model.topology()), findings_(findings) {}

  void run() {
    ends();
    if (!findings_.empty()) return;
    loops();
    radial_cycles();
    if (!findings_.empty()) return;
    shells();
    if (!findings_.empty()) return;
    sectors();
    shells_connected();
    regions();
    duplicates();
  }

 private:
  template <class Id>
  static bool in(Id id, std::size_t count) {
    return id.index() < count;
  }
  bool vertex(VertexId v) const { return in(v, k_.vertex_count()); }
  bool edge(EdgeId e) const { return in(e, k_.edge_count()); }
  bool coedge(CoedgeId c) const { return in(c, k_.coedge_count()); }
  bool loop(LoopId l) const { return in(l, k_.loop_count()); }
  bool face(FaceId f) const { return in(f, k_.face_count()); }
  bool shell(ShellId s) const { return in(s, k_.shell_count()); }
  bool region(RegionId r) const { return in(r, k_.region_count()); }

  void add(FindingKind kind, std::vector<EntityRef> entities, std::string message, Vec3 place = {}) {
    findings_.push_back({kind, std::move(entities), place, 0, 0, std::move(message)});
  }
  Vec3 place(VertexId v) const { return vertex(v) ? model_.point(v) : Vec3{}; }

  void ends() {
    for (const EdgeId e : k_.edges()) {
      if (!vertex(k_.start(e)) || !vertex(k_.end(e))) {
        add(FindingKind::isolated_use, {e}, name_of(e) + " has an end that is no vertex of the model");
      }
    }
    for (const CoedgeId c : k_.coedges()) {
      if (!edge(k_.edge(c)) || !loop(k_.loop(c)) || !face(k_.face(k_.loop(c)))) {
        add(FindingKind::isolated_use, {},
            "the use " + std::to_string(c.value) +
                " of an edge names an edge or a loop "
                "that is none of the model");
      }
    }
    std::vector<bool> listed(k_.loop_count(), false);
    for (const FaceId f : k_.faces()) {
      LoopId l = k_.first_loop(f);
      std::size_t steps = 0;
      // Loops of a face are chained by their records; a chain that runs on or names foreign loops is broken.
      for (const LoopId m : k_.loops(f)) {
        l = m;
        if (!loop(l) || k_.face(l) != f || listed[l.index()] || ++steps > k_.loop_count()) {
          add(FindingKind::loop_open, {f}, "the list of loops of " + name_of(f) + " is broken");
          break;
        }
        listed[l.index()] = true;
      }
      if (steps == 0 && !loop(l)) add(FindingKind::isolated_use, {f}, name_of(f) + " has no loop");
    }
  }

  void loops() {
    std::vector<bool> seen(k_.coedge_count(), false);
    for (const LoopId l : k_.loops()) {
      const FaceId f = k_.face(l);
      if (k_.is_vertex_loop(l)) {
        if (!vertex(k_.loop_vertex(l))) {
          add(FindingKind::loop_open, {f}, "a point in " + name_of(f) + " names a vertex that is none of the model");
        }
        continue;
      }
      CoedgeId c = k_.first_coedge(l);
      bool open = !coedge(c);
      VertexId at;
      for (std::size_t steps = 0; !open; ++steps) {
        if (steps > k_.coedge_count() || k_.loop(c) != l || seen[c.index()]) {
          open = true;
          break;
        }
        seen[c.index()] = true;
        at = k_.end(c);
        const CoedgeId next = k_.next(c);
        if (!coedge(next) || k_.prev(next) != c || k_.start(next) != at) {
          open = true;
          break;
        }
        c = next;
        if (c == k_.first_coedge(l)) break;
      }
      if (open) {
        std::vector<EntityRef> entities{f};
        std::string where;
        if (vertex(at)) {
          entities.insert(entities.begin(), at);
          where = " at " + name_of(at);
        }
        add(FindingKind::loop_open, std::move(entities), "a loop of " + name_of(f) + " is open" + where, place(at));
      }
    }
    for (const CoedgeId c : k_.coedges()) {
      if (!seen[c.index()] && findings_.empty()) {
        add(FindingKind::isolated_use, {k_.edge(c)}, "a use of " + name_of(k_.edge(c)) + " belongs to no loop");
      }
    }
  }

  void radial_cycles() {
    std::vector<std::uint32_t> uses(k_.edge_count(), 0);
    for (const CoedgeId c : k_.coedges()) ++uses[k_.edge(c).index()];
    for (const EdgeId e : k_.edges()) {
      if (k_.is_wire(e)) {
        if (uses[e.index()] > 0) {
          add(FindingKind::radial_cycle_broken, {e}, name_of(e) + " is a wire, yet loops use it");
        }
        continue;
      }
      const CoedgeId first = k_.first_coedge(e);
      CoedgeId c = first;
      std::uint32_t count = 0;
      bool broken = false;
      while (!broken) {
        broken = !coedge(c) || k_.edge(c) != e || ++count > uses[e.index()];
        if (broken) break;
        c = k_.radial(c);
        if (c == first) break;
      }
      if (broken && uses[e.index()] == 0) {
        add(FindingKind::isolated_use, {e}, name_of(e) + " is used by no loop and lies in no region",
            place(k_.start(e)));
      } else if (broken || count != uses[e.index()]) {
        add(FindingKind::radial_cycle_broken, {e},
            "the faces around " + name_of(e) + " are not one cycle: " + std::to_string(uses[e.index()]) + " uses, " +
                std::to_string(count) + " reached",
            place(k_.start(e)));
      }
    }
  }

  void shells() {
    bool broken = false;
    for (const ShellId s : k_.shells()) broken = broken || !region(k_.region(s));
    for (const FaceId f : k_.faces()) {
      for (int side = 0; side < 2; ++side) {
        if (!shell(k_.shell(FaceUse(f, side)))) {
          add(FindingKind::isolated_use, {f},
              std::string(side == 0 ? "the front" : "the back") + " of " + name_of(f) + " lies in no shell");
        }
      }
    }
    for (const EdgeId e : k_.edges()) {
      if (k_.is_wire(e) && !shell(k_.wire_shell(e))) {
        add(FindingKind::isolated_use, {e}, name_of(e) + " lies in no shell", place(k_.start(e)));
      }
    }
    for (const VertexId v : k_.vertices()) {
      if (!k_.has_no_edge(v)) continue;
      const ShellId s = k_.isolated_in_shell(v);
      if (!s.valid() && !k_.vertex_loops(v).empty()) continue;
      if (!shell(s) || k_.shell_vertex(s) != v) {
        add(FindingKind::isolated_use, {v}, name_of(v) + " has no edge and lies in no face and no region", place(v));
      }
    }
    if (broken) add(FindingKind::isolated_use, {}, "a shell lies in no region");
  }

  void sectors() {
    for (const CoedgeId c : k_.coedges()) {
      const CoedgeId next = k_.radial(c);
      const FaceUse a = k_.side_after(c), b = k_.side_before(next);
      if (k_.region(a) == k_.region(b)) continue;
      const EdgeId e = k_.edge(c);
      add(FindingKind::sector_in_two_regions, {e, a.face(), b.face(), k_.region(a), k_.region(b)},
          "between " + name_of(a.face()) + " and " + name_of(b.face()) + " at " + name_of(e) +
              " lies one space, which is " + name_of(k_.region(a)) + " for the one and " + name_of(k_.region(b)) +
              " for the other",
          place(k_.start(e)));
    }
  }

  /// Items of one shell hang together through edges and vertices, and items that do so in one region are one shell.
  void shells_connected() {
    const std::size_t uses = 2 * k_.face_count(), items = uses + k_.edge_count();
    UnionFind sets(items);
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> shell_of(items, none);
    for (const FaceId f : k_.faces()) {
      for (int side = 0; side < 2; ++side) shell_of[FaceUse(f, side).index()] = k_.shell(FaceUse(f, side)).value;
    }
    for (const EdgeId e : k_.edges()) {
      if (k_.is_wire(e)) shell_of[uses + e.index()] = k_.wire_shell(e).value;
    }
    for (const CoedgeId c : k_.coedges()) {
      sets.unite(k_.side_after(c).index(), k_.side_before(k_.radial(c)).index());
    }
    // Ties at vertices, by region: in vertex order, with the first item of each region remembered.
    std::vector<std::uint32_t> begin(k_.vertex_count() + 1, 0);
    const auto ties = [&](auto&& visit) {
      for (const CoedgeId c : k_.coedges()) {
        for (int side = 0; side < 2; ++side) visit(k_.start(c), FaceUse(k_.face(c), side).index());
      }
      for (const LoopId l : k_.loops()) {
        if (!k_.is_vertex_loop(l)) continue;
        for (int side = 0; side < 2; ++side) visit(k_.loop_vertex(l), FaceUse(k_.face(l), side).index());
      }
      for (const EdgeId e : k_.edges()) {
        if (!k_.is_wire(e)) continue;
        visit(k_.start(e), uses + e.index());
        visit(k_.end(e), uses + e.index());
      }
    };
    ties([&](VertexId v, std::size_t) { ++begin[v.index() + 1]; });
    for (std::size_t v = 0; v < k_.vertex_count(); ++v) begin[v + 1] += begin[v];
    std::vector<std::uint32_t> list(begin.back()), fill(begin.begin(), begin.end() - 1);
    ties([&](VertexId v, std::size_t item) { list[fill[v.index()]++] = static_cast<std::uint32_t>(item); });
    const auto region_of = [&](std::uint32_t item) { return k_.region(ShellId(shell_of[item])); };
    std::vector<std::uint32_t> first(k_.region_count(), none);
    for (std::size_t v = 0; v < k_.vertex_count(); ++v) {
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
        std::uint32_t& item = first[region_of(list[i]).index()];
        if (item == none) {
          item = list[i];
        } else {
          sets.unite(item, list[i]);
        }
      }
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) first[region_of(list[i]).index()] = none;
    }
    std::vector<std::uint32_t> set_of_shell(k_.shell_count(), none), shell_of_set(items, none);
    const auto entity = [&](std::uint32_t item) {
      return item < uses ? EntityRef(FaceId(item / 2)) : EntityRef(EdgeId(item - uses));
    };
    std::vector<bool> named(k_.shell_count(), false);
    for (std::uint32_t item = 0; item < items; ++item) {
      const std::uint32_t s = shell_of[item];
      if (s == none) continue;
      const std::uint32_t set = sets.find(item);
      if (set_of_shell[s] == none) set_of_shell[s] = set;
      if (shell_of_set[set] == none) shell_of_set[set] = s;
      if (named[s]) continue;
      if (set_of_shell[s] != set) {
        named[s] = true;
        add(FindingKind::shell_disconnected, {entity(set_of_shell[s]), entity(item)},
            "one shell holds " + name_of(entity(set_of_shell[s])) + " and " + name_of(entity(item)) +
                ", which do not hang together");
      } else if (shell_of_set[set] != s) {
        named[s] = true;
        add(FindingKind::shell_disconnected, {entity(set), entity(item)},
            name_of(entity(set)) + " and " + name_of(entity(item)) +
                " hang together in one region but belong to two shells");
      }
    }
  }

  void regions() {
    if (k_.is_filled(Complex::infinite_region())) {
      add(FindingKind::region_unbounded, {Complex::infinite_region()}, "the infinite region is marked as filled");
    }
    std::vector<bool> bounded(k_.region_count(), false);
    for (const FaceId f : k_.faces()) {
      const RegionId front = k_.region(FaceUse(f, 0)), back = k_.region(FaceUse(f, 1));
      if (front != back) bounded[front.index()] = bounded[back.index()] = true;
    }
    for (const RegionId r : k_.regions()) {
      if (r == Complex::infinite_region() || bounded[r.index()]) continue;
      add(FindingKind::region_unbounded, {r}, "no face bounds " + name_of(r));
    }
  }

  // Edges between the same vertices along the same curve.
  void duplicates() {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(k_.edge_count());
    for (const EdgeId e : k_.edges()) {
      const std::uint32_t a = std::min(k_.start(e).value, k_.end(e).value),
                          b = std::max(k_.start(e).value, k_.end(e).value);
      keys.emplace_back((std::uint64_t{a} << 32) | b, e.value);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      for (std::size_t j = i + 1; j < keys.size() && keys[j].first == keys[i].first; ++j) {
        const EdgeId a(keys[i].second), b(keys[j].second);
        if (!same_curve(a, b)) continue;
        add(FindingKind::duplicate_edge, {a, b},
            name_of(a) + " and " + name_of(b) + " join the same vertices along the same curve",
            model_.edge_point(a, model_.range(a).middle()));
      }
    }
  }

  bool same_curve(EdgeId a, EdgeId b) const {
    if (model_.is_straight(a) && model_.is_straight(b)) return true;
    if (model_.is_straight(a) != model_.is_straight(b)) {
      const EdgeId curved = model_.is_straight(a) ? b : a;
      if (!model_.geometry(curved).curve.valid()) return false;
    }
    const double tolerance = std::max({model_.tolerance(), model_.tolerance(a), model_.tolerance(b)});
    const Curve other = model_.curve(b);
    for (const double fraction : {0.5, 0.25, 0.8}) {
      const Vec3 p = model_.edge_point(a, model_.range(a).at(fraction));
      if (!is_finite(p)) return false;
      if (other.project(p, model_.range(b)).distance > tolerance) return false;
    }
    return true;
  }

  const Model& model_;
  const Complex& k_;
  Findings& findings_;
};

}  // namespace

void check_structure(const Model& model, Findings& findings) {
  StructureCheck(model, findings).run();
}

}  // namespace aresta::model_detail
