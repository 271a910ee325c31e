// SPDX-License-Identifier: Apache-2.0
#include "topology/operation_detail.h"

#include <algorithm>
#include <set>

#include "base/union_find.h"
#include "topology/components.h"

namespace aresta {

void take_back(Complex& k, Applied& applied) {
  for (auto step = applied.steps.rbegin(); step != applied.steps.rend(); ++step) take_back(k, *step);
}

void make_again(Complex& k, Applied& applied) {
  for (Change& step : applied.steps) make(k, step);
}

}  // namespace aresta

namespace aresta::detail {

Totals::Totals(const Complex& k)
    : vertices(static_cast<int>(k.vertex_count())),
      edges(static_cast<int>(k.edge_count())),
      faces(static_cast<int>(k.face_count())),
      loops(static_cast<int>(k.loop_count())),
      shells(static_cast<int>(k.shell_count())),
      regions(static_cast<int>(k.region_count())) {}

CountChange Totals::operator-(const Totals& b) const {
  return {vertices - b.vertices, edges - b.edges,   faces - b.faces,
          loops - b.loops,       shells - b.shells, regions - b.regions};
}

Operation::~Operation() {
  if (!finished_) take_back(k_, applied_);
}

void Operation::kill(AnyChange change) {
  applied_.steps.push_back({std::move(change), true});
  aresta::make(k_, applied_.steps.back());
}

Applied Operation::finish(const char* prefix, const char* made, const char* killed, bool killed_first) {
  finished_ = true;
  const CountChange d = applied_.change = Totals(k_) - before_;
  const auto count = [&](char letter) {
    switch (letter) {
      case 'v':
        return d.vertices;
      case 'e':
        return d.edges;
      case 'f':
        return d.faces;
      case 'l':
        return d.loops;
      case 's':
        return d.shells;
      default:
        return d.regions;
    }
  };
  std::string more, fewer;
  for (const char* c = made; *c != 0; ++c) {
    if (count(*c) > 0) more += *c;
  }
  for (const char* c = killed; *c != 0; ++c) {
    if (count(*c) < 0) fewer += *c;
  }
  if (!more.empty()) more = "m" + more;
  if (!fewer.empty()) fewer = "k" + fewer;
  applied_.sub_case = prefix + (killed_first ? fewer + more : more + fewer);
  return std::move(applied_);
}

std::string name_of(EntityRef entity) {
  return std::string(to_string(entity.kind)) + " " + std::to_string(entity.index);
}

Error unknown(const char* what, std::uint32_t id) {
  if (id == 0xffffffffu) return Error{errors::unknown_part, std::string("no ") + what + " is given"};
  return Error{errors::unknown_part, std::string("there is no ") + what + " " + std::to_string(id)};
}

std::vector<RegionId> regions_at(const Complex& k, VertexId v) {
  std::set<RegionId> regions;
  for_each_item_at(k, v, [&](Item item) { regions.insert(region_of(k, item)); });
  return {regions.begin(), regions.end()};
}

Result<RegionId> common_region(const Complex& k, std::span<const VertexId> vertices, RegionId wanted) {
  if (wanted.valid()) ARESTA_CHECK(want(k, wanted, "region"));
  std::vector<RegionId> common;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::vector<RegionId> here = regions_at(k, vertices[i]);
    if (wanted.valid() && !std::binary_search(here.begin(), here.end(), wanted)) {
      return Error{
          errors::not_in_region, name_of(vertices[i]) + " does not touch " + name_of(wanted), {vertices[i], wanted}};
    }
    if (i == 0) {
      common = here;
    } else {
      std::erase_if(common, [&](RegionId r) { return !std::binary_search(here.begin(), here.end(), r); });
    }
  }
  if (wanted.valid()) return wanted;
  if (common.size() == 1) return common.front();
  Error error{common.empty() ? errors::not_in_region : errors::ambiguous_place, {}};
  for (const VertexId v : vertices) {
    error.message += (error.message.empty() ? "" : " and ") + name_of(v);
    error.entities.push_back(v);
  }
  if (common.empty()) {
    error.message += " touch no common region";
    return error;
  }
  error.message += vertices.size() == 1 ? " touches several regions:" : " touch several regions together:";
  for (const RegionId r : common) {
    error.message += ' ' + std::to_string(r.value);
    error.entities.push_back(r);
  }
  error.hint = "name the region";
  return error;
}

FaceChange face_removal(const Complex& k, FaceId f, RegionId kept) {
  FaceChange x;
  x.face = f;
  const RegionId front = k.region(FaceUse(f, 0)), back = k.region(FaceUse(f, 1));
  if (front != back) {
    const bool back_stays = kept.valid() ? kept == back : back == Complex::infinite_region();
    Division& d = x.division;
    d.side = back_stays ? 0 : 1;
    d.region = back_stays ? front : back;
    d.filled = k.is_filled(d.region);
    std::set<FaceUse> covered;
    const auto cover = [&](FaceUse u) {
      const auto component = side_component(k, u);
      covered.insert(component.begin(), component.end());
    };
    cover(FaceUse(f, d.side));
    for (const ShellId s : k.shells(d.region)) {
      for (const FaceUse u : k.face_uses(s)) {
        if (covered.contains(u)) continue;
        d.others.push_back(Item(u));
        cover(u);
      }
      for (const EdgeId e : k.wires(s)) d.others.push_back(Item(e));
      if (k.shell_vertex(s).valid()) d.others.push_back(Item(k.shell_vertex(s)));
    }
    std::sort(d.others.begin(), d.others.end());
  }
  x.division.extent = front == back ? Division::Extent::nothing : Division::Extent::exact;
  x.region = x.division.side == 0 && x.division.region.valid() ? back : front;
  std::vector<CoedgeId> all;
  for (const LoopId l : k.loops(f)) {
    for (const CoedgeId c : k.coedges(l)) all.push_back(c);
  }
  std::sort(all.begin(), all.end());
  std::vector<CoedgeId> earlier;  // sorted: placements so far
  for (const LoopId l : k.loops(f)) {
    LoopPlacement& loop = x.loops.emplace_back();
    loop.id = l;
    loop.vertex = k.loop_vertex(l);
    for (const CoedgeId c : k.coedges(l)) {
      Placement& p = loop.coedges.emplace_back();
      p.id = c;
      p.edge = k.edge(c);
      p.reversed = k.reversed(c);
      // Taken out from the last to the first: what stands before it then is no later coedge of this face.
      const auto goes_before = [&](CoedgeId d) {
        return d != c && std::binary_search(all.begin(), all.end(), d) &&
               !std::binary_search(earlier.begin(), earlier.end(), d);
      };
      CoedgeId before = k.radial_prev(c);
      while (goes_before(before)) before = k.radial_prev(before);
      if (before != c) p.after = before;
      earlier.insert(std::upper_bound(earlier.begin(), earlier.end(), c), c);
    }
  }
  return x;
}

Status require_no_double_corner(const Complex& k, VertexId v) {
  for (const LoopId l : k.vertex_loops(v)) {
    const FaceId f = k.face(l);
    for (const LoopId other : k.loops(f)) {
      if (other == l) continue;
      bool meets = k.loop_vertex(other) == v;
      for (const CoedgeId c : k.coedges(other)) meets = meets || k.start(c) == v;
      if (meets) {
        return Error{errors::wrong_place,
                     name_of(v) + " would be a loop of " + name_of(f) + " and in another loop of it",
                     {v, f}};
      }
    }
  }
  return {};
}

namespace {

/// Does the graph of edge ends (nodes) and corners (arcs) about the vertex fit on a sphere, with the radial orders
/// given? Each connected part of it must: nodes - arcs + fans = 2.
bool fans_fit(const Complex& k, VertexId v) {
  std::vector<CoedgeId> corners;  // as the coedges that start at v
  std::vector<EdgeEnd> ends;
  for (const EdgeEnd end : k.edge_ends(v)) {
    if (k.is_wire(end.edge)) continue;
    ends.push_back(end);
    for (const CoedgeId c : k.coedges(end.edge)) {
      if (k.reversed(c) == (end.end == 1)) corners.push_back(c);
    }
  }
  std::sort(corners.begin(), corners.end());
  std::sort(ends.begin(), ends.end());
  const auto corner = [&](CoedgeId c) {
    return static_cast<std::size_t>(std::lower_bound(corners.begin(), corners.end(), c) - corners.begin());
  };
  const auto node = [&](CoedgeId c, bool at_start) {
    const EdgeEnd end{k.edge(c), k.reversed(c) == at_start ? 1 : 0};
    return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), end) - ends.begin());
  };
  UnionFind parts(ends.size()), fans(2 * corners.size());
  for (const CoedgeId c : corners) parts.unite(node(c, true), node(k.prev(c), false));
  for (const EdgeEnd end : ends) {
    for (const CoedgeId c : k.coedges(end.edge)) {
      const CoedgeId d = k.radial(c);
      const auto corner_of = [&](CoedgeId x) { return corner(k.reversed(x) == (end.end == 1) ? x : k.next(x)); };
      fans.unite(2 * corner_of(c) + static_cast<std::size_t>(k.side_after(c).side()),
                 2 * corner_of(d) + static_cast<std::size_t>(k.side_before(d).side()));
    }
  }
  std::vector<int> euler(ends.size(), 0);
  for (std::size_t n = 0; n < ends.size(); ++n) ++euler[parts.find(n)];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    int& sum = euler[parts.find(node(corners[i], true))];
    --sum;
    for (std::size_t side = 2 * i; side < 2 * i + 2; ++side) sum += fans.find(side) == side;
  }
  for (std::size_t n = 0; n < ends.size(); ++n) {
    if (parts.find(n) == n && euler[n] != 2) return false;
  }
  return true;
}

}  // namespace

Status require_regions_meet(const Complex& k, RegionId region) {
  std::vector<VertexId> vertices;
  const auto gather = [&](Item item) { for_each_vertex_of(k, item, [&](VertexId v) { vertices.push_back(v); }); };
  for (const ShellId s : k.shells(region)) {
    for (const FaceUse u : k.face_uses(s)) gather(u);
    for (const EdgeId e : k.wires(s)) gather(e);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const VertexId v : vertices) {
    const std::vector<RegionId> here = regions_at(k, v);
    const auto index = [&](RegionId r) { return std::lower_bound(here.begin(), here.end(), r) - here.begin(); };
    UnionFind met(here.size());
    for_each_item_at(k, v, [&](Item item) {
      if (item.kind != Item::Kind::side) return;
      met.unite(static_cast<std::size_t>(index(k.region(item.side()))),
                static_cast<std::size_t>(index(k.region(item.side().opposite()))));
    });
    for (std::size_t i = 1; i < here.size(); ++i) {
      if (met.find(i) != 0) {
        return Error{errors::cuts_wire,
                     "at " + name_of(v) + " something in " + name_of(here[0] == region ? here[i] : here[0]) +
                         " would be cut off by the new region",
                     {v}};
      }
    }
  }
  return {};
}

Status require_fans_fit(const Complex& k, std::vector<VertexId> vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const VertexId v : vertices) {
    if (!fans_fit(k, v)) {
      return Error{errors::no_space,
                   "at " + name_of(v) + " faces would have to pass through each other",
                   {v},
                   {},
                   "other sectors of the edges there"};
    }
  }
  return {};
}

}  // namespace aresta::detail
