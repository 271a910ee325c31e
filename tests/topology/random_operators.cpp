// SPDX-License-Identifier: Apache-2.0
#include "random_operators.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>

#include "topology/item.h"

namespace aresta {

namespace {

template <class IdType, class Range>
std::vector<IdType> list(const Range& range) {
  std::vector<IdType> all;
  for (const IdType id : range) all.push_back(id);
  return all;
}

std::vector<RegionId> regions_at(const Complex& k, VertexId v) {
  std::vector<RegionId> all;
  for_each_item_at(k, v, [&](Item item) { all.push_back(region_of(k, item)); });
  return all;
}

bool touches(const Complex& k, EdgeId e, RegionId r) {
  if (k.is_wire(e)) return k.region(k.wire_shell(e)) == r;
  for (const CoedgeId c : k.coedges(e)) {
    if (k.region(k.side_after(c)) == r) return true;
  }
  return false;
}

}  // namespace

template <class IdType>
void RandomOperators::note(const char* kind, IdType id) {
  tried_ += ' ';
  tried_ += kind;
  tried_ += id.valid() ? std::to_string(id.value) : "-";
}

std::optional<Applied> RandomOperators::apply(Complex& k) {
  tried_.clear();
  Result<Applied> result = one(k);
  if (!result.ok()) {
    refusal_ = result.error();
    return {};
  }
  refusal_.reset();
  return std::move(result).value();
}

Corner RandomOperators::any_corner(const Complex& k, FaceId f) {
  const auto loops = list<LoopId>(k.loops(f));
  const LoopId l = loops[below(loops.size())];
  if (k.is_vertex_loop(l)) return {{}, l};
  const auto coedges = list<CoedgeId>(k.coedges(l));
  return {coedges[below(coedges.size())], {}};
}

/// A circuit of edges that touch the region, by a random search from the end of one edge to its start.
std::vector<EdgeUseSpec> RandomOperators::any_circuit(const Complex& k, RegionId r) {
  auto edges = list<EdgeId>(k.edges());
  std::erase_if(edges, [&](EdgeId e) { return !touches(k, e, r); });
  if (edges.empty()) return {};
  const EdgeId first = edges[below(edges.size())];
  const bool reversed = chance(50);
  const VertexId from = reversed ? k.start(first) : k.end(first), to = reversed ? k.end(first) : k.start(first);
  std::vector<EdgeUseSpec> circuit{{first, reversed, {}}};
  if (from != to) {
    std::map<VertexId, EdgeUseSpec> came;
    std::queue<VertexId> queue;
    queue.push(from);
    came[from] = {};
    while (!queue.empty() && !came.contains(to)) {
      const VertexId v = queue.front();
      queue.pop();
      auto ends = list<EdgeEnd>(k.edge_ends(v));
      std::shuffle(ends.begin(), ends.end(), random_);
      for (const EdgeEnd end : ends) {
        if (end.edge == first || !touches(k, end.edge, r)) continue;
        const VertexId w = k.vertex({end.edge, 1 - end.end});
        if (came.try_emplace(w, EdgeUseSpec{end.edge, end.end == 1, {}}).second) queue.push(w);
      }
    }
    if (!came.contains(to)) {
      // There and back along the same edge.
      circuit.push_back({first, !reversed, {}});
    } else {
      std::vector<EdgeUseSpec> path;
      for (VertexId v = to; v != from;) {
        const EdgeUseSpec use = came[v];
        path.push_back(use);
        v = use.reversed ? k.end(use.edge) : k.start(use.edge);
      }
      circuit.insert(circuit.end(), path.rbegin(), path.rend());
    }
  }
  for (EdgeUseSpec& use : circuit) {
    auto sectors = list<CoedgeId>(k.coedges(use.edge));
    std::erase_if(sectors, [&](CoedgeId c) { return k.region(k.side_after(c)) != r; });
    if (!sectors.empty() && chance(90)) use.after = sectors[below(sectors.size())];
  }
  return circuit;
}

std::optional<FaceSpec> RandomOperators::any_face(const Complex& k) {
  FaceSpec spec;
  const auto regions = list<RegionId>(k.regions());
  spec.region = regions[below(regions.size())];
  spec.division.filled = chance(50);
  spec.division.side = chance(80) ? 1 : 0;
  auto circuit = any_circuit(k, spec.region);
  if (circuit.empty()) return {};
  spec.circuits.push_back({std::move(circuit), {}});
  if (chance(15)) {
    if (auto second = any_circuit(k, spec.region); !second.empty()) spec.circuits.push_back({std::move(second), {}});
  }
  if (chance(8)) {
    const auto vertices = list<VertexId>(k.vertices());
    spec.circuits.push_back({{}, vertices[below(vertices.size())]});
  }
  // A face that uses an edge twice in one sense has one side only; closed, it would have no place in space.
  std::set<std::pair<EdgeId, bool>> used;
  for (const Circuit& c : spec.circuits) {
    for (const EdgeUseSpec& use : c.uses) {
      if (!used.emplace(use.edge, use.reversed).second) return {};
    }
  }
  return spec;
}

Result<Applied> RandomOperators::one(Complex& k) {
  const auto vertices = list<VertexId>(k.vertices());
  const auto edges = list<EdgeId>(k.edges());
  const auto faces = list<FaceId>(k.faces());
  const auto regions = list<RegionId>(k.regions());
  const auto vertex = [&] { return vertices.empty() ? VertexId() : vertices[below(vertices.size())]; };
  const auto edge = [&] { return edges.empty() ? EdgeId() : edges[below(edges.size())]; };
  const auto face = [&] { return faces.empty() ? FaceId() : faces[below(faces.size())]; };
  const auto region_at = [&](VertexId v) {
    const auto here = v.valid() ? regions_at(k, v) : std::vector<RegionId>();
    return here.empty() ? RegionId() : here[below(here.size())];
  };
  const bool large = vertices.size() + edges.size() + faces.size() > 60;
  // Weights: 0-9 build, 10-14 take apart, 15-19 glue and compose.
  const std::size_t choice = large ? 10 + below(10) : below(100) < 65 ? below(10) : 10 + below(10);
  switch (choice) {
    case 0:
      tried_ = "M_SV";
      return m_sv(k, regions[below(regions.size())]);
    case 1: {
      const VertexId v = vertex();
      const RegionId r = region_at(v);
      tried_ = "M_EV";
      note("v", v);
      note("r", r);
      return m_ev(k, v, r);
    }
    case 2:
    case 3: {
      const VertexId v = vertex(), w = chance(8) ? v : vertex();
      RegionId r = region_at(v);
      if (chance(20)) r = RegionId();
      tried_ = "M_E";
      note("v", v);
      note("v", w);
      note("r", r);
      return m_e(k, v, w, r);
    }
    case 4:
    case 5:
    case 6: {
      tried_ = "M_F";
      const auto spec = any_face(k);
      if (!spec) return m_f(k, {});
      for (const Circuit& circuit : spec->circuits) {
        note("/v", circuit.vertex);
        for (const EdgeUseSpec& use : circuit.uses) {
          note(use.reversed ? "-e" : "+e", use.edge);
          note("c", use.after);
        }
      }
      note("r", spec->region);
      return m_f(k, *spec);
    }
    case 7: {
      const VertexId v = vertex();
      tried_ = "M_RSFL";
      note("v", v);
      return m_rsfl(k, v, region_at(v), chance(50));
    }
    case 8: {
      const FaceId f = face();
      if (!f.valid() || chance(40)) {
        tried_ = "MM_VL";
        note("f", f);
        return mm_vl(k, f);
      }
      tried_ = "MM_EV";
      const Corner at = any_corner(k, f);
      note("c", at.coedge);
      note("l", at.vertex_loop);
      return mm_ev(k, at);
    }
    case 9: {
      tried_ = "MM_E";
      const FaceId f = face();
      if (!f.valid()) return mm_e(k, {}, {});
      const Corner from = any_corner(k, f), to = any_corner(k, f);
      std::vector<LoopId> moved;
      const LoopId a = from.coedge.valid() ? k.loop(from.coedge) : from.vertex_loop;
      const LoopId b = to.coedge.valid() ? k.loop(to.coedge) : to.vertex_loop;
      for (const LoopId l : k.loops(f)) {
        if (a == b && l != a && chance(50)) moved.push_back(l);
      }
      note("c", from.coedge);
      note("l", from.vertex_loop);
      note("c", to.coedge);
      note("l", to.vertex_loop);
      return mm_e(k, from, to, moved);
    }
    case 10: {
      const VertexId v = vertex();
      tried_ = "K_V";
      note("v", v);
      return k_v(k, v);
    }
    case 11:
    case 12: {
      const EdgeId e = edge();
      tried_ = "K_E";
      note("e", e);
      return k_e(k, e, chance(10) ? face() : FaceId());
    }
    case 13:
    case 14: {
      const FaceId f = face();
      tried_ = "K_F";
      note("f", f);
      const RegionId kept = f.valid() && chance(30) ? k.region(FaceUse(f, static_cast<int>(below(2)))) : RegionId();
      note("r", kept);
      return k_f(k, f, kept);
    }
    case 15: {
      const VertexId v = vertex(), w = vertex();
      tried_ = "G_V";
      note("v", v);
      note("v", w);
      return g_v(k, v, w);
    }
    case 16: {
      const EdgeId e = edge();
      EdgeId d = edge();
      // Often an edge beside it.
      if (e.valid() && chance(60)) {
        const auto ends = list<EdgeEnd>(k.edge_ends(chance(50) ? k.start(e) : k.end(e)));
        d = ends[below(ends.size())].edge;
      }
      tried_ = "G_E";
      note("e", e);
      note("e", d);
      EdgeGluing gluing;
      gluing.opposite = chance(50);
      gluing.division.filled = chance(50);
      gluing.division.side = chance(50) ? 1 : 0;
      if (e.valid() && d.valid()) {
        const auto of_e = list<CoedgeId>(k.coedges(e)), of_d = list<CoedgeId>(k.coedges(d));
        if (!of_e.empty() && chance(80)) gluing.kept_after = of_e[below(of_e.size())];
        if (!of_d.empty() && chance(80)) gluing.gone_after = of_d[below(of_d.size())];
      }
      note("c", gluing.kept_after);
      note("c", gluing.gone_after);
      return g_e(k, e, d, gluing);
    }
    case 17: {
      tried_ = "G_F";
      const FaceId f = face(), g = face();
      if (!f.valid()) return g_f(k, {}, {}, {});
      const FaceUse a(f, static_cast<int>(below(2))), b(g, static_cast<int>(below(2)));
      std::vector<std::pair<CoedgeId, CoedgeId>> pairs;
      auto p = list<LoopId>(k.loops(f)), q = list<LoopId>(k.loops(g));
      std::erase_if(p, [&](LoopId l) { return k.is_vertex_loop(l); });
      std::erase_if(q, [&](LoopId l) { return k.is_vertex_loop(l); });
      for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
        const auto of_q = list<CoedgeId>(k.coedges(q[i]));
        pairs.emplace_back(k.first_coedge(p[i]), of_q[below(of_q.size())]);
        note("c", pairs.back().first);
        note("c", pairs.back().second);
      }
      return g_f(k, a, b, pairs);
    }
    case 18: {
      const EdgeId e = edge();
      tried_ = "ESPLIT";
      note("e", e);
      return esplit(k, e);
    }
    default: {
      const EdgeId e = edge();
      tried_ = "ESQUEEZE";
      note("e", e);
      return esqueeze(k, e, e.valid() && chance(50) ? k.end(e) : VertexId());
    }
  }
}

}  // namespace aresta
