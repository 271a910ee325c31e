// SPDX-License-Identifier: Apache-2.0
// Constructive operators.
#include <algorithm>
#include <map>

#include "topology/operation_detail.h"

namespace aresta {

using namespace detail;

namespace {

constexpr const char* made_letters = "eflrsv";
constexpr const char* killed_letters = "lsvefr";

Error wrong(std::string message, std::vector<EntityRef> entities) {
  return Error{errors::wrong_place, std::move(message), std::move(entities)};
}

/// The sector of an edge, by the coedge it follows, in which a face in `r` may use the edge.
Result<CoedgeId> sector_in(const Complex& k, const EdgeUseSpec& use, RegionId r) {
  if (use.after.valid()) {
    ARESTA_CHECK(want(k, use.after, "coedge"));
    if (k.edge(use.after) != use.edge) {
      return wrong("coedge " + std::to_string(use.after.value) + " is no use of " + name_of(use.edge), {use.edge});
    }
    if (k.region(k.side_after(use.after)) != r) {
      return Error{errors::not_in_region,
                   "behind coedge " + std::to_string(use.after.value) + " lies " +
                       name_of(k.region(k.side_after(use.after))) + ", not " + name_of(r),
                   {use.edge, r}};
    }
    return use.after;
  }
  CoedgeId found;
  for (const CoedgeId c : k.coedges(use.edge)) {
    if (k.region(k.side_after(c)) != r) continue;
    if (found.valid()) {
      return Error{errors::ambiguous_place,
                   name_of(use.edge) + " has several sectors in " + name_of(r),
                   {use.edge, r},
                   {},
                   "name the coedge behind which the face comes"};
    }
    found = c;
  }
  if (!found.valid()) {
    return Error{errors::not_in_region, name_of(use.edge) + " has no sector in " + name_of(r), {use.edge, r}};
  }
  return found;
}

Status check_circuit(const Complex& k, const Circuit& circuit) {
  if (circuit.uses.empty()) {
    ARESTA_CHECK(want(k, circuit.vertex, "vertex"));
    return {};
  }
  const auto vertex = [&](const EdgeUseSpec& use, bool last) {
    return use.reversed != last ? k.end(use.edge) : k.start(use.edge);
  };
  for (const EdgeUseSpec& use : circuit.uses) ARESTA_CHECK(want(k, use.edge, "edge"));
  for (std::size_t i = 0; i < circuit.uses.size(); ++i) {
    const EdgeUseSpec &use = circuit.uses[i], &next = circuit.uses[(i + 1) % circuit.uses.size()];
    if (vertex(use, true) != vertex(next, false)) {
      return Error{errors::open_circuit,
                   "the circuit is open: " + name_of(use.edge) + " ends at vertex " +
                       std::to_string(vertex(use, true).value) + ", " + name_of(next.edge) + " starts at vertex " +
                       std::to_string(vertex(next, false).value),
                   {use.edge, next.edge}};
    }
  }
  return {};
}

std::vector<VertexId> vertices_of(const Complex& k, const FaceSpec& spec) {
  std::vector<VertexId> result;
  for (const Circuit& circuit : spec.circuits) {
    if (circuit.uses.empty()) result.push_back(circuit.vertex);
    for (const EdgeUseSpec& use : circuit.uses) result.push_back(use.reversed ? k.end(use.edge) : k.start(use.edge));
  }
  return result;
}

/// Places for all uses; an edge used twice gets its second use behind its first.
Result<std::vector<LoopPlacement>> place(const Complex& k, const FaceSpec& spec, RegionId r) {
  std::vector<LoopPlacement> loops;
  std::map<EdgeId, int> first_use;
  int index = 0;
  for (const Circuit& circuit : spec.circuits) {
    LoopPlacement& loop = loops.emplace_back();
    if (circuit.uses.empty()) loop.vertex = circuit.vertex;
    for (const EdgeUseSpec& use : circuit.uses) {
      Placement& p = loop.coedges.emplace_back();
      p.edge = use.edge;
      p.reversed = use.reversed;
      const auto [at, fresh] = first_use.emplace(use.edge, index);
      if (!fresh && at->second < 0) {
        return wrong(name_of(use.edge) + " occurs more than twice in one face", {use.edge});
      }
      if (!fresh && !use.after.valid()) {
        p.after_new = at->second;
      } else if (!k.is_wire(use.edge)) {
        ARESTA_TRY(p.after, sector_in(k, use, r));
      } else if (k.region(k.wire_shell(use.edge)) != r) {
        return Error{errors::not_in_region, name_of(use.edge) + " does not lie in " + name_of(r), {use.edge, r}};
      }
      if (!fresh) at->second = -1;
      ++index;
    }
  }
  return loops;
}

/// Is it a wire or an isolated vertex that the face is made of, and so no longer is?
bool is_taken(const FaceSpec& spec, Item item) {
  return std::any_of(spec.circuits.begin(), spec.circuits.end(), [&](const Circuit& circuit) {
    return item == Item(circuit.vertex) || std::any_of(circuit.uses.begin(), circuit.uses.end(),
                                                       [&](const EdgeUseSpec& use) { return item == Item(use.edge); });
  });
}

Status check_others(const Complex& k, const FaceSpec& spec, RegionId r) {
  for (const Item item : spec.division.others) {
    const bool live = item.kind == Item::Kind::side ? k.is_live(item.side().face())
                      : item.kind == Item::Kind::wire
                          ? k.is_live(item.wire()) && k.is_wire(item.wire())
                          : k.is_live(item.point()) && k.isolated_in_shell(item.point()).valid();
    if (!live) return Error{errors::unknown_part, "what should go into the new region is not there"};
    if (region_of(k, item) != r) {
      return Error{errors::not_in_region, "what should go into the new region does not lie in " + name_of(r), {r}};
    }
    if (is_taken(spec, item)) return wrong("what should go into the new region is part of the face", {});
  }
  return {};
}

Status check_corner(const Complex& k, const Corner& corner) {
  if (corner.vertex_loop.valid()) {
    ARESTA_CHECK(want(k, corner.vertex_loop, "loop"));
    if (k.is_vertex_loop(corner.vertex_loop)) return {};
    return wrong("loop " + std::to_string(corner.vertex_loop.value) + " is not a single vertex", {});
  }
  return want(k, corner.coedge, "coedge");
}

LoopId loop_of(const Complex& k, const Corner& corner) {
  return corner.vertex_loop.valid() ? corner.vertex_loop : k.loop(corner.coedge);
}
VertexId vertex_of(const Complex& k, const Corner& corner) {
  return corner.vertex_loop.valid() ? k.loop_vertex(corner.vertex_loop) : k.start(corner.coedge);
}

}  // namespace

Complex m_mr() {
  return Complex();
}

Result<Applied> m_sv(Complex& k, RegionId region, VertexId wanted) {
  ARESTA_CHECK(want(k, region, "region"));
  if (wanted.valid() && (k.is_live(wanted) || wanted.index() > k.vertex_bound())) {
    return Error{errors::in_use, k.is_live(wanted) ? name_of(wanted) + " exists already"
                                                   : "the next free vertex is " + std::to_string(k.vertex_bound())};
  }
  Operation op(k, "M_SV");
  const PointChange& x = op.make(PointChange{wanted, region});
  op.applied().vertex = x.vertex;
  return op.finish("", "sv", killed_letters, false);
}

Result<Applied> m_ev(Complex& k, VertexId at, RegionId region) {
  ARESTA_CHECK(want(k, at, "vertex"));
  ARESTA_TRY(const RegionId r, common_region(k, std::array{at}, region));
  Operation op(k, "M_EV");
  op.applied().vertex = op.make(PointChange{{}, r}).vertex;
  op.applied().edge = op.make(WireChange{{}, at, op.applied().vertex, r}).edge;
  return op.finish("", made_letters, killed_letters, false);
}

Result<Applied> m_e(Complex& k, VertexId start, VertexId end, RegionId region) {
  ARESTA_CHECK(want(k, start, "vertex"));
  ARESTA_CHECK(want(k, end, "vertex"));
  ARESTA_TRY(const RegionId r, common_region(k, std::array{start, end}, region));
  Operation op(k, "M_E");
  op.applied().edge = op.make(WireChange{{}, start, end, r}).edge;
  return op.finish("", made_letters, killed_letters, false);
}

Result<Applied> m_f(Complex& k, const FaceSpec& spec) {
  if (spec.circuits.empty()) return Error{errors::open_circuit, "a face needs at least one circuit"};
  for (const Circuit& circuit : spec.circuits) ARESTA_CHECK(check_circuit(k, circuit));
  ARESTA_TRY(const RegionId r, common_region(k, vertices_of(k, spec), spec.region));
  ARESTA_TRY(auto loops, place(k, spec, r));
  ARESTA_CHECK(check_others(k, spec, r));

  Operation op(k, "M_F");
  FaceChange change;
  change.region = r;
  change.loops = std::move(loops);
  change.division = spec.division;
  change.division.region = RegionId();
  change.division.extent = Division::Extent::found;
  const FaceChange& made = op.make(std::move(change));
  for (const LoopPlacement& loop : made.loops) {
    if (loop.coedges.empty()) ARESTA_CHECK(require_no_double_corner(k, loop.vertex));
  }
  ARESTA_CHECK(require_fans_fit(k, vertices_of(k, spec)));
  const Division& d = made.division;
  if (d.region.valid()) {
    if (k.region(FaceUse(made.face, 1 - d.side)) != r) {
      return wrong("what should go into the new region is connected with what stays outside", {made.face});
    }
    ARESTA_CHECK(require_regions_meet(k, d.region));
  } else if (!d.others.empty()) {
    return wrong("the face closes nothing off, so that there is no new region for anything to go into", {});
  }
  op.applied().face = made.face;
  op.applied().region = d.region;
  return op.finish("", made_letters, killed_letters, false);
}

Result<Applied> m_rsfl(Complex& k, VertexId at, RegionId region, bool filled) {
  ARESTA_CHECK(want(k, at, "vertex"));
  FaceSpec spec;
  spec.circuits.push_back({{}, at});
  spec.region = region;
  spec.division.filled = filled;
  ARESTA_TRY(Applied applied, m_f(k, spec));
  applied.name = "M_RSFL";
  applied.sub_case = "mrsfl";
  return applied;
}

Result<Applied> mm_vl(Complex& k, FaceId face) {
  ARESTA_CHECK(want(k, face, "face"));
  Operation op(k, "MM_VL");
  const LoopPointChange& x = op.make(LoopPointChange{{}, {LoopPlacement{}}, {face}});
  op.applied().vertex = x.vertex;
  op.applied().loop = x.loops.front().id;
  return op.finish("", "vl", killed_letters, false);
}

Result<Applied> mm_ev(Complex& k, Corner at) {
  ARESTA_CHECK(check_corner(k, at));
  const LoopId loop = loop_of(k, at);
  Operation op(k, "MM_EV");
  const LoopPointChange point = op.make(LoopPointChange{{}, {LoopPlacement{}}, {k.face(loop)}});
  JoiningChange edge;
  edge.loop = loop;
  edge.other = point.loops.front().id;
  edge.from = at.coedge;
  edge.start = vertex_of(k, at);
  edge.end = point.vertex;
  op.applied().vertex = point.vertex;
  op.applied().edge = op.make(edge).edge;
  return op.finish("", made_letters, killed_letters, false);
}

Result<Applied> mm_e(Complex& k, Corner from, Corner to, std::span<const LoopId> moved) {
  ARESTA_CHECK(check_corner(k, from));
  ARESTA_CHECK(check_corner(k, to));
  const LoopId first = loop_of(k, from), second = loop_of(k, to);
  const FaceId f = k.face(first);
  if (k.face(second) != f) {
    return wrong("the corners lie on different faces, " + std::to_string(f.value) + " and " +
                     std::to_string(k.face(second).value),
                 {f, k.face(second)});
  }
  Operation op(k, "MM_E");
  if (first != second) {
    if (!moved.empty()) return wrong("the face is not divided, so that no loop can go to a new face", {f});
    JoiningChange x;
    x.loop = first;
    x.other = second;
    x.from = from.coedge;
    x.to = to.coedge;
    x.start = vertex_of(k, from);
    x.end = vertex_of(k, to);
    op.applied().edge = op.make(x).edge;
    return op.finish("", made_letters, killed_letters, false);
  }
  for (std::size_t i = 0; i < moved.size(); ++i) {
    ARESTA_CHECK(want(k, moved[i], "loop"));
    if (k.face(moved[i]) != f || moved[i] == first) {
      return wrong("loop " + std::to_string(moved[i].value) + " is no other loop of " + name_of(f), {f});
    }
    if (std::find(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(i), moved[i]) !=
        moved.begin() + static_cast<std::ptrdiff_t>(i)) {
      return wrong("loop " + std::to_string(moved[i].value) + " is named twice", {f});
    }
  }
  AcrossChange x;
  x.loop = first;
  x.face = f;
  x.from = from.coedge;
  x.to = to.coedge;
  x.vertex = k.loop_vertex(first);
  x.moved.assign(moved.begin(), moved.end());
  const AcrossChange& made = op.make(x);
  op.applied().edge = made.edge;
  op.applied().face = made.new_face;
  op.applied().loop = made.new_loop;
  return op.finish("", made_letters, killed_letters, false);
}

}  // namespace aresta
