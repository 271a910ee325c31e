// SPDX-License-Identifier: Apache-2.0
// Only rows of pages that are not shared are looked at. A relation between two entities is kept in a row of one of
// them, so that a row that differs tells what changed at both; the region of an item is kept in the row of its shell,
// so that a shell whose region differs is walked.
#include "topology/difference.h"

#include <algorithm>
#include <set>

#include "topology/item.h"

namespace aresta {

namespace {

template <class IdType>
struct Collected {
  std::vector<IdType> made, removed, touched;
};

template <class IdType>
void sort_unique(std::vector<IdType>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

}  // namespace

struct ComplexDifference {
  const Complex &before, &after;
  Collected<VertexId> vertices;
  Collected<EdgeId> edges;
  Collected<CoedgeId> coedges;
  Collected<LoopId> loops;
  Collected<FaceId> faces;
  Collected<RegionId> regions;
  std::set<Item> moved;  ///< items whose region may differ

  ComplexDifference(const Complex& a, const Complex& b) : before(a), after(b) {}

  /// visit(id, in before, in after), where it lives in one of the two; notes what was made and removed.
  template <class IdType, class Rows, class Visit>
  void compare(const Rows& a, const Rows& b, Collected<IdType>& into, Visit&& visit) {
    a.for_each_difference(b, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const IdType id(i);
        const bool was = before.is_live(id), is = after.is_live(id);
        if (!was && !is) continue;
        if (was && !is) into.removed.push_back(id);
        if (!was) into.made.push_back(id);
        visit(id, was, is);
      }
    });
  }

  static RegionId region_in(const Complex& k, Item item) {
    ShellId s;
    switch (item.kind) {
      case Item::Kind::side:
        if (!k.is_live(item.side().face())) return {};
        break;
      case Item::Kind::wire:
        if (!k.is_live(item.wire())) return {};
        break;
      case Item::Kind::point:
        if (!k.is_live(item.point())) return {};
        break;
    }
    s = shell_of(k, item);
    return s.valid() ? k.region(s) : RegionId();
  }

  template <class Touch>
  void touch_loop_vertex(LoopId l, bool was, bool is, Touch&& touch) {
    const VertexId a = was ? before.loop_vertex(l) : VertexId(), b = is ? after.loop_vertex(l) : VertexId();
    if (a == b) return;
    for (const VertexId v : {a, b}) {
      if (v.valid()) vertices.touched.push_back(v);
    }
    touch();
  }

  void read() {
    compare<VertexId>(before.vertices_, after.vertices_, vertices,
                      [&](VertexId v, bool, bool) { moved.insert(Item(v)); });
    compare<EdgeId>(before.edges_, after.edges_, edges, [&](EdgeId e, bool was, bool is) {
      moved.insert(Item(e));
      for (int end = 0; end < 2; ++end) {
        const VertexId a = was ? before.vertex({e, end}) : VertexId(), b = is ? after.vertex({e, end}) : VertexId();
        if (a == b) continue;
        edges.touched.push_back(e);
        for (const VertexId v : {a, b}) {
          if (v.valid()) vertices.touched.push_back(v);
        }
      }
    });
    // A wire's shell; the row may have become another edge's.
    before.wires_.for_each_difference(after.wires_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        for (const Complex* k : {&before, &after}) {
          if (i < k->wires_.size() && k->wires_[i].edge != Complex::dead) {
            moved.insert(Item(EdgeId(k->wires_[i].edge)));
          }
        }
      }
    });
    compare<CoedgeId>(before.coedges_, after.coedges_, coedges, [&](CoedgeId c, bool was, bool is) {
      const EdgeId e = was ? before.edge(c) : EdgeId(), f = is ? after.edge(c) : EdgeId();
      const LoopId l = was ? before.loop(c) : LoopId(), m = is ? after.loop(c) : LoopId();
      const bool both = was && is;
      const bool edge_differs = e != f || (both && before.reversed(c) != after.reversed(c));
      if (edge_differs || (both && before.radial(c) != after.radial(c))) {
        for (const EdgeId x : {e, f}) {
          if (x.valid()) edges.touched.push_back(x);
        }
      }
      if (edge_differs || l != m || (both && before.next(c) != after.next(c))) {
        coedges.touched.push_back(c);
        for (const LoopId x : {l, m}) {
          if (x.valid()) loops.touched.push_back(x);
        }
      }
    });
    compare<LoopId>(before.loops_, after.loops_, loops, [&](LoopId l, bool was, bool is) {
      const FaceId f = was ? before.face(l) : FaceId(), g = is ? after.face(l) : FaceId();
      if (f != g) {
        loops.touched.push_back(l);
        for (const FaceId x : {f, g}) {
          if (x.valid()) faces.touched.push_back(x);
        }
      }
      touch_loop_vertex(l, was, is, [&] { loops.touched.push_back(l); });
    });
    compare<FaceId>(before.faces_, after.faces_, faces, [&](FaceId f, bool, bool) {
      moved.insert(Item(FaceUse(f, 0)));
      moved.insert(Item(FaceUse(f, 1)));
    });
    compare<RegionId>(before.regions_, after.regions_, regions, [&](RegionId r, bool was, bool is) {
      if (was && is && before.is_filled(r) != after.is_filled(r)) regions.touched.push_back(r);
    });
    before.shells_.for_each_difference(after.shells_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const ShellId s(i);
        const bool was = before.is_live(s), is = after.is_live(s);
        if (was && is && before.region(s) == after.region(s)) continue;
        if (was) add_items(before, s);
        if (is) add_items(after, s);
      }
    });
    for (const Item item : moved) {
      const RegionId a = region_in(before, item), b = region_in(after, item);
      if (a == b) continue;
      for (const RegionId r : {a, b}) {
        if (r.valid()) regions.touched.push_back(r);
      }
      switch (item.kind) {
        case Item::Kind::side:
          faces.touched.push_back(item.side().face());
          break;
        case Item::Kind::wire:
          edges.touched.push_back(item.wire());
          break;
        case Item::Kind::point:
          vertices.touched.push_back(item.point());
          break;
      }
    }
    // A loop's change is its face's.
    for (const LoopId l : loops.touched) {
      for (const Complex* k : {&before, &after}) {
        if (k->is_live(l)) faces.touched.push_back(k->face(l));
      }
    }
  }

  void add_items(const Complex& k, ShellId s) {
    for (const FaceUse u : k.face_uses(s)) moved.insert(Item(u));
    for (const EdgeId e : k.wires(s)) moved.insert(Item(e));
    if (k.shell_vertex(s).valid()) moved.insert(Item(k.shell_vertex(s)));
  }

  template <class IdType>
  Changes<IdType> result(Collected<IdType>& from) const {
    std::erase_if(from.touched, [&](IdType id) { return !before.is_live(id) || !after.is_live(id); });
    sort_unique(from.touched);
    return {std::move(from.made), std::move(from.touched), std::move(from.removed)};
  }
};

Difference difference(const Complex& before, const Complex& after) {
  ComplexDifference d(before, after);
  d.read();
  return {d.result(d.vertices), d.result(d.edges), d.result(d.coedges),
          d.result(d.loops),    d.result(d.faces), d.result(d.regions)};
}

}  // namespace aresta
