// SPDX-License-Identifier: Apache-2.0
#include "topology/records.h"

#include <algorithm>
#include <tuple>

#include "base/union_find.h"
#include "topology/editor.h"
#include "topology/names.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

Error at_line(ErrorCode code, std::uint32_t line, const std::string& message, std::vector<EntityRef> entities) {
  return Error{code, line == 0 ? message : "line " + std::to_string(line) + ": " + message, std::move(entities)};
}
Error bad_id(std::uint32_t line, const std::string& message) {
  return at_line(errors::record_ids, line, message, {});
}
Error broken(std::uint32_t line, const std::string& message, std::vector<EntityRef> entities) {
  return at_line(errors::record_invariant, line, message, std::move(entities));
}

/// Finds records by id.
class Index {
 public:
  template <class Record>
  Status build(const std::vector<Record>& records, std::size_t limit) {
    std::size_t bound = 0;
    for (const Record& record : records) {
      if (record.id.index() >= limit) {
        return bad_id(record.line, name(record.id) + ": for so few records ids must be below " + std::to_string(limit));
      }
      bound = std::max(bound, record.id.index() + 1);
    }
    place_.assign(bound, none);
    for (std::uint32_t i = 0; i < records.size(); ++i) {
      std::uint32_t& place = place_[records[i].id.index()];
      if (place != none) return bad_id(records[i].line, name(records[i].id) + " is there twice");
      place = i;
    }
    return {};
  }

  /// `none` for what is not there.
  template <class IdType>
  std::uint32_t find(IdType id) const {
    return id.index() < place_.size() ? place_[id.index()] : none;
  }
  std::size_t bound() const { return place_.size(); }

  /// Visits ids that are there, growing.
  template <class IdType, class Visit>
  void for_each(Visit&& visit) const {
    for (std::uint32_t id = 0; id < place_.size(); ++id) {
      if (place_[id] != none) visit(IdType(id), place_[id]);
    }
  }

 private:
  std::vector<std::uint32_t> place_;
};

class Rebuilder {
 public:
  explicit Rebuilder(const ComplexRecords& records) : in_(records) {}

  Result<Complex> run() {
    ARESTA_CHECK(check_places());
    ARESTA_CHECK(find_ids());
    ARESTA_CHECK(check_edges());
    ARESTA_CHECK(check_loops());
    ARESTA_CHECK(check_uses());
    ARESTA_CHECK(place_items());
    ARESTA_CHECK(check_sectors());
    meetings_ = find_meetings();
    ARESTA_CHECK(check_wires());
    ARESTA_CHECK(check_shells());
    ARESTA_CHECK(check_regions());
    ARESTA_CHECK(check_vertex_loops());
    return build();
  }

 private:
  /// Places in other lists grow and are there.
  Status check_places() const {
    const auto fits = [](const auto& list, auto place, std::size_t bound) {
      std::uint32_t last = 0;
      for (const auto& record : list) {
        if (record.*place < last || record.*place >= bound) return false;
        last = record.*place;
      }
      return true;
    };
    if (fits(in_.items, &ComplexRecords::ShellItem::shell, in_.shells.size()) &&
        fits(in_.loops, &ComplexRecords::Loop::face, in_.faces.size()) &&
        fits(in_.coedges, &ComplexRecords::Coedge::loop, in_.loops.size()) &&
        fits(in_.uses, &ComplexRecords::Use::edge, in_.edges.size())) {
      return {};
    }
    return bad_id(0, "the lists of records do not follow one another");
  }

  Status find_ids() {
    const std::size_t limit = id_limit(in_.count());
    ARESTA_CHECK(regions_.build(in_.regions, limit));
    ARESTA_CHECK(faces_.build(in_.faces, limit));
    ARESTA_CHECK(loops_.build(in_.loops, limit));
    ARESTA_CHECK(coedges_.build(in_.coedges, limit));
    ARESTA_CHECK(edges_.build(in_.edges, limit));
    ARESTA_CHECK(vertices_.build(in_.vertices, limit));
    const std::uint32_t infinite = regions_.find(Complex::infinite_region());
    if (infinite == none) return bad_id(0, "r0 is missing, the infinite region");
    if (in_.regions[infinite].filled) {
      return broken(in_.regions[infinite].line, "r0 is the infinite region and cannot be filled", {RegionId(0)});
    }
    return {};
  }

  template <class IdType>
  Status expect(const Index& index, IdType id, std::uint32_t line, const std::string& where) const {
    if (index.find(id) != none) return {};
    return bad_id(line, where + " names " + (id.valid() ? name(id) : "nothing") + ", which is not there");
  }

  Status check_edges() const {
    for (const auto& edge : in_.edges) {
      ARESTA_CHECK(expect(vertices_, edge.start, edge.line, name(edge.id)));
      ARESTA_CHECK(expect(vertices_, edge.end, edge.line, name(edge.id)));
    }
    return {};
  }

  VertexId start(const ComplexRecords::Coedge& coedge) const {
    const auto& edge = in_.edges[edges_.find(coedge.edge)];
    return coedge.reversed ? edge.end : edge.start;
  }
  VertexId end(const ComplexRecords::Coedge& coedge) const {
    const auto& edge = in_.edges[edges_.find(coedge.edge)];
    return coedge.reversed ? edge.start : edge.end;
  }

  Status check_loops() const {
    for (const auto& coedge : in_.coedges) {
      ARESTA_CHECK(expect(edges_, coedge.edge, coedge.line, name(coedge.id)));
    }
    std::vector<bool> has_loop(in_.faces.size(), false);
    std::uint32_t first = 0;
    for (std::uint32_t l = 0; l < in_.loops.size(); ++l) {
      const auto& loop = in_.loops[l];
      const FaceId face = in_.faces[loop.face].id;
      has_loop[loop.face] = true;
      std::uint32_t last = first;
      while (last < in_.coedges.size() && in_.coedges[last].loop == l) ++last;
      if ((first == last) != loop.vertex.valid()) {
        return broken(loop.line, name(loop.id) + " must have coedges or be a vertex, and not both", {face});
      }
      if (first == last) ARESTA_CHECK(expect(vertices_, loop.vertex, loop.line, name(loop.id)));
      for (std::uint32_t c = first; c < last; ++c) {
        const auto& coedge = in_.coedges[c];
        const auto& next = in_.coedges[c + 1 < last ? c + 1 : first];
        if (end(coedge) != start(next)) {
          return broken(coedge.line,
                        name(loop.id) + " is open: " + name(coedge.id) + " ends at " + name(end(coedge)) + ", but " +
                            name(next.id) + " starts at " + name(start(next)),
                        {face, coedge.edge, next.edge});
        }
      }
      first = last;
    }
    for (std::uint32_t f = 0; f < in_.faces.size(); ++f) {
      if (!has_loop[f]) return broken(in_.faces[f].line, name(in_.faces[f].id) + " has no loop", {in_.faces[f].id});
    }
    return {};
  }

  Status check_uses() {
    std::vector<bool> seen(in_.coedges.size(), false);
    radial_.assign(in_.coedges.size(), none);
    is_wire_.assign(in_.edges.size(), true);
    std::uint32_t first = none;
    for (std::size_t i = 0; i < in_.uses.size(); ++i) {
      const auto& use = in_.uses[i];
      const auto& edge = in_.edges[use.edge];
      ARESTA_CHECK(expect(coedges_, use.coedge, edge.line, name(edge.id)));
      const std::uint32_t c = coedges_.find(use.coedge);
      if (in_.coedges[c].edge != edge.id) {
        return broken(
            edge.line,
            name(use.coedge) + " is listed at " + name(edge.id) + ", but is a use of " + name(in_.coedges[c].edge),
            {edge.id, in_.coedges[c].edge});
      }
      if (seen[c]) return broken(edge.line, name(use.coedge) + " comes twice about " + name(edge.id), {edge.id});
      seen[c] = true;
      is_wire_[use.edge] = false;
      if (i == 0 || in_.uses[i - 1].edge != use.edge) {
        first = c;
      } else {
        radial_[coedges_.find(in_.uses[i - 1].coedge)] = c;
      }
      radial_[c] = first;
    }
    for (std::size_t c = 0; c < seen.size(); ++c) {
      if (seen[c]) continue;
      const EdgeId e = in_.coedges[c].edge;
      return broken(in_.coedges[c].line, name(in_.coedges[c].id) + " is missing among the uses of " + name(e), {e});
    }
    return {};
  }

  // Items by number: sides of faces, edges, vertices.
  std::uint32_t edge_item(std::uint32_t edge) const { return static_cast<std::uint32_t>(2 * in_.faces.size()) + edge; }
  std::uint32_t vertex_item(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(2 * in_.faces.size() + in_.edges.size()) + vertex;
  }
  std::size_t item_count() const { return 2 * in_.faces.size() + in_.edges.size() + in_.vertices.size(); }
  std::uint32_t side_item(std::uint32_t coedge, bool after) const {
    return 2 * in_.loops[in_.coedges[coedge].loop].face + (in_.coedges[coedge].reversed == after ? 1 : 0);
  }
  Item item(std::uint32_t number) const {
    if (number < edge_item(0)) return FaceUse(in_.faces[number / 2].id, static_cast<int>(number % 2));
    if (number < vertex_item(0)) return in_.edges[number - edge_item(0)].id;
    return in_.vertices[number - vertex_item(0)].id;
  }
  EntityRef entity(std::uint32_t number) const {
    const Item i = item(number);
    switch (i.kind) {
      case Item::Kind::side:
        return i.side().face();
      case Item::Kind::wire:
        return i.wire();
      case Item::Kind::point:
        return i.point();
    }
    return {};
  }

  Result<std::uint32_t> number_of(Item item, std::uint32_t line) const {
    const std::string where = "a shell";
    switch (item.kind) {
      case Item::Kind::side:
        ARESTA_CHECK(expect(faces_, item.side().face(), line, where));
        return 2 * faces_.find(item.side().face()) + static_cast<std::uint32_t>(item.side().side());
      case Item::Kind::wire:
        ARESTA_CHECK(expect(edges_, item.wire(), line, where));
        return edge_item(edges_.find(item.wire()));
      case Item::Kind::point:
        ARESTA_CHECK(expect(vertices_, item.point(), line, where));
        return vertex_item(vertices_.find(item.point()));
    }
    return none;
  }

  /// Is the numbered thing an item: a side, a wire, a vertex of nothing?
  std::vector<bool> find_items() const {
    std::vector<bool> is_item(item_count(), true);
    for (std::uint32_t e = 0; e < in_.edges.size(); ++e) is_item[edge_item(e)] = is_wire_[e];
    const auto touch = [&](VertexId v) { is_item[vertex_item(vertices_.find(v))] = false; };
    for (const auto& edge : in_.edges) {
      touch(edge.start);
      touch(edge.end);
    }
    for (const auto& loop : in_.loops) {
      if (loop.vertex.valid()) touch(loop.vertex);
    }
    return is_item;
  }

  Status place_items() {
    for (const auto& shell : in_.shells) ARESTA_CHECK(expect(regions_, shell.region, shell.line, "a shell"));
    const std::vector<bool> is_item = find_items();
    shell_.assign(item_count(), none);
    for (const auto& entry : in_.items) {
      const std::uint32_t line = in_.shells[entry.shell].line;
      std::uint32_t number;
      ARESTA_TRY(number, number_of(entry.item, line));
      if (!is_item[number]) {
        return broken(line,
                      name(entry.item) + (entry.item.kind == Item::Kind::wire
                                              ? " is an edge of a face, no wire, and lies in no shell"
                                              : " is a vertex of an edge or a face and lies in no shell"),
                      {entity(number)});
      }
      if (shell_[number] != none) return broken(line, name(entry.item) + " is in shells twice", {entity(number)});
      shell_[number] = entry.shell;
    }
    for (std::uint32_t number = 0; number < item_count(); ++number) {
      if (is_item[number] && shell_[number] == none) {
        return broken(0, name(item(number)) + " lies in no shell", {entity(number)});
      }
    }
    return {};
  }

  RegionId region(std::uint32_t number) const { return in_.shells[shell_[number]].region; }

  Status check_sectors() const {
    for (std::uint32_t c = 0; c < in_.coedges.size(); ++c) {
      const std::uint32_t d = radial_[c], a = side_item(c, true), b = side_item(d, false);
      if (region(a) == region(b)) continue;
      const EdgeId e = in_.coedges[c].edge;
      return broken(in_.edges[edges_.find(e)].line,
                    "the sector from " + name(in_.coedges[c].id) + " to " + name(in_.coedges[d].id) + " about " +
                        name(e) + " is in two regions: " + name(item(a)) + " in " + name(region(a)) + ", " +
                        name(item(b)) + " in " + name(region(b)),
                    {e, entity(a), entity(b), region(a), region(b)});
    }
    return {};
  }

  /// What meets at a vertex in one region is connected.
  struct Meeting {
    VertexId vertex;
    RegionId region;
    std::uint32_t item;
    auto operator<=>(const Meeting&) const = default;
  };
  std::vector<Meeting> find_meetings() const {
    std::vector<Meeting> result;
    const auto meet = [&](VertexId v, std::uint32_t number) { result.push_back({v, region(number), number}); };
    for (std::uint32_t c = 0; c < in_.coedges.size(); ++c) {
      for (const bool after : {false, true}) meet(start(in_.coedges[c]), side_item(c, after));
    }
    for (const auto& loop : in_.loops) {
      if (!loop.vertex.valid()) continue;
      for (std::uint32_t side = 0; side < 2; ++side) meet(loop.vertex, 2 * loop.face + side);
    }
    for (std::uint32_t e = 0; e < in_.edges.size(); ++e) {
      if (!is_wire_[e]) continue;
      meet(in_.edges[e].start, edge_item(e));
      meet(in_.edges[e].end, edge_item(e));
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// A wire lies in a region that its ends touch: there with a side of a face, or else with all wires there.
  Status check_wires() const {
    const auto is_side = [&](const Meeting& m) { return m.item < edge_item(0); };
    for (std::size_t i = 0, j; i < meetings_.size(); i = j) {
      const VertexId v = meetings_[i].vertex;
      bool has_face = false;
      for (j = i; j < meetings_.size() && meetings_[j].vertex == v; ++j) has_face = has_face || is_side(meetings_[j]);
      // Sides come before wires of their region.
      const Meeting* first = &meetings_[i];
      for (std::size_t n = i; n < j; ++n) {
        const Meeting& m = meetings_[n];
        if (has_face && m.region != first->region) first = &m;
        if (is_side(m) || (m.region == first->region && (!has_face || is_side(*first)))) continue;
        const EdgeId e = item(m.item).wire();
        const std::string other = has_face ? ", which no face has a side in at " : ", unlike another wire at ";
        return broken(in_.edges[m.item - edge_item(0)].line, name(e) + " is in " + name(m.region) + other + name(v),
                      {e, v, m.region});
      }
    }
    return {};
  }

  Status check_regions() const {
    std::vector<bool> has_shell(in_.regions.size(), false);
    for (const auto& shell : in_.shells) has_shell[regions_.find(shell.region)] = true;
    for (std::size_t r = 0; r < in_.regions.size(); ++r) {
      const RegionId id = in_.regions[r].id;
      if (has_shell[r] || id == Complex::infinite_region()) continue;
      return broken(in_.regions[r].line, name(id) + " has no shell, which only the infinite region may lack", {id});
    }
    return {};
  }

  /// A vertex that is a loop of a face is in no other loop of it.
  Status check_vertex_loops() const {
    std::vector<std::tuple<std::uint32_t, VertexId, bool>> uses;  // of vertices by faces; false: as a loop
    for (const auto& loop : in_.loops) {
      if (loop.vertex.valid()) uses.emplace_back(loop.face, loop.vertex, false);
    }
    if (uses.empty()) return {};
    for (const auto& coedge : in_.coedges) uses.emplace_back(in_.loops[coedge.loop].face, start(coedge), true);
    std::sort(uses.begin(), uses.end());
    for (std::size_t i = 1; i < uses.size(); ++i) {
      const auto& [face, vertex, in_edges] = uses[i];
      const auto& [other_face, other_vertex, in_other_edges] = uses[i - 1];
      if (face != other_face || vertex != other_vertex || in_other_edges) continue;
      const FaceId f = in_.faces[face].id;
      return broken(in_.faces[face].line, name(vertex) + " is a loop of " + name(f) + " and in another loop of it too",
                    {f, vertex});
    }
    return {};
  }

  Status check_shells() const {
    UnionFind sets(item_count());
    for (std::size_t i = 1; i < meetings_.size(); ++i) {
      const Meeting &a = meetings_[i - 1], &b = meetings_[i];
      if (a.vertex == b.vertex && a.region == b.region) sets.unite(a.item, b.item);
    }
    std::vector<std::uint32_t> root_of_shell(in_.shells.size(), none), shell_of_root(item_count(), none);
    for (std::uint32_t number = 0; number < item_count(); ++number) {
      const std::uint32_t s = shell_[number];
      if (s == none) continue;
      const std::uint32_t root = sets.find(number);  // the smallest of what is connected, so an item seen before
      if (root_of_shell[s] == none) root_of_shell[s] = root;
      if (shell_of_root[root] == none) shell_of_root[root] = s;
      if (root_of_shell[s] != root) {
        return broken(in_.shells[s].line,
                      name(item(root_of_shell[s])) + " and " + name(item(number)) +
                          " are in one shell, but not connected in " + name(in_.shells[s].region),
                      {entity(root_of_shell[s]), entity(number)});
      }
      if (shell_of_root[root] != s) {
        return broken(in_.shells[s].line,
                      name(item(root)) + " and " + name(item(number)) + " are connected in " +
                          name(in_.shells[s].region) + ", but in two shells",
                      {entity(root), entity(number)});
      }
    }
    for (std::uint32_t s = 0; s < in_.shells.size(); ++s) {
      if (root_of_shell[s] == none) return broken(in_.shells[s].line, "a shell has nothing in it", {});
    }
    return {};
  }

  /// Rows are made in growing order, so that no list of free rows is searched.
  Complex build() const {
    Complex k;
    Editor editor(k);
    vertices_.for_each<VertexId>([&](VertexId v, std::uint32_t) { editor.make_vertex(v); });
    edges_.for_each<EdgeId>([&](EdgeId e, std::uint32_t i) {
      editor.make_edge(e);
      editor.attach({e, 0}, in_.edges[i].start);
      editor.attach({e, 1}, in_.edges[i].end);
    });
    faces_.for_each<FaceId>([&](FaceId f, std::uint32_t) { editor.make_face(f); });
    loops_.for_each<LoopId>([&](LoopId l, std::uint32_t) { editor.make_loop(l); });
    coedges_.for_each<CoedgeId>([&](CoedgeId c, std::uint32_t i) {
      editor.make_coedge(c);
      editor.set_edge(c, in_.coedges[i].edge, in_.coedges[i].reversed);
    });
    regions_.for_each<RegionId>([&](RegionId r, std::uint32_t i) {
      if (r != Complex::infinite_region()) editor.make_region(in_.regions[i].filled, r);
    });
    for (const auto& loop : in_.loops) {
      editor.append_loop(in_.faces[loop.face].id, loop.id);
      if (loop.vertex.valid()) editor.set_vertex_loop(loop.id, loop.vertex);
    }
    for (std::size_t i = 0; i < in_.coedges.size(); ++i) {
      const auto& coedge = in_.coedges[i];
      const bool is_first = i == 0 || in_.coedges[i - 1].loop != coedge.loop;
      editor.insert_coedge(coedge.id, is_first ? CoedgeId() : in_.coedges[i - 1].id, in_.loops[coedge.loop].id);
    }
    for (std::size_t i = 0; i < in_.uses.size(); ++i) {
      const bool is_first = i == 0 || in_.uses[i - 1].edge != in_.uses[i].edge;
      editor.insert_radially(in_.uses[i].coedge, is_first ? CoedgeId() : in_.uses[i - 1].coedge);
    }
    std::vector<ShellId> shells;
    for (const auto& shell : in_.shells) shells.push_back(editor.make_shell(shell.region));
    for (const auto& entry : in_.items) editor.put(entry.item, shells[entry.shell]);
    return k;
  }

  const ComplexRecords& in_;
  Index regions_, faces_, loops_, coedges_, edges_, vertices_;
  std::vector<std::uint32_t> radial_;  ///< per coedge: the next about its edge
  std::vector<bool> is_wire_;          ///< per edge
  std::vector<std::uint32_t> shell_;   ///< per item
  std::vector<Meeting> meetings_;      ///< sorted
};

}  // namespace

Result<Complex> rebuild(const ComplexRecords& records) {
  return Rebuilder(records).run();
}

}  // namespace aresta
