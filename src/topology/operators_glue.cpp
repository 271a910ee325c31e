// SPDX-License-Identifier: Apache-2.0
// Gluing and composed operators.
#include <algorithm>

#include "topology/components.h"
#include "topology/operation_detail.h"

namespace aresta {

using namespace detail;

namespace {

constexpr const char* made_letters = "rs";
constexpr const char* killed_letters = "sflevr";

Error pinch(std::string message, std::vector<EntityRef> entities) {
  return Error{errors::would_pinch, std::move(message), std::move(entities)};
}

Status merge_vertices(Complex& k, Operation& op, VertexId kept, VertexId gone) {
  VertexMergeChange x;
  x.kept = kept;
  x.gone = gone;
  op.make(x);
  return require_no_double_corner(k, kept);
}

/// A sector of each edge, behind the coedges given, in one region.
struct Sectors {
  CoedgeId kept_after, gone_after;
};

struct Sector {
  CoedgeId after;
  RegionId region;
};

Result<std::vector<Sector>> sectors(const Complex& k, EdgeId e, CoedgeId wanted) {
  std::vector<Sector> all;
  if (k.is_wire(e)) {
    if (wanted.valid()) return Error{errors::wrong_place, name_of(e) + " is a wire and has no uses", {e}};
    all.push_back({{}, k.region(k.wire_shell(e))});
    return all;
  }
  if (wanted.valid()) {
    ARESTA_CHECK(want(k, wanted, "coedge"));
    if (k.edge(wanted) != e) {
      return Error{errors::wrong_place, "coedge " + std::to_string(wanted.value) + " is no use of " + name_of(e), {e}};
    }
    all.push_back({wanted, k.region(k.side_after(wanted))});
    return all;
  }
  for (const CoedgeId c : k.coedges(e)) all.push_back({c, k.region(k.side_after(c))});
  return all;
}

Result<Sectors> choose_sectors(const Complex& k, EdgeId kept, EdgeId gone, const EdgeGluing& gluing) {
  ARESTA_TRY(const auto of_kept, sectors(k, kept, gluing.kept_after));
  ARESTA_TRY(const auto of_gone, sectors(k, gone, gluing.gone_after));
  Sectors found;
  int count = 0;
  for (const Sector& a : of_kept) {
    for (const Sector& b : of_gone) {
      if (a.region != b.region) continue;
      if (count++ == 0) found = {a.after, b.after};
    }
  }
  if (count == 1) return found;
  if (count == 0) {
    return Error{errors::not_in_region,
                 name_of(kept) + " and " + name_of(gone) + " have no sectors in one region there",
                 {kept, gone}};
  }
  return Error{errors::ambiguous_place,
               name_of(kept) + " and " + name_of(gone) + " have several sectors in one region",
               {kept, gone},
               {},
               "name the coedges behind which the sectors lie"};
}

/// The uses of `gone` in the order in which they come to stand about the other edge, when its sector behind `after` is
/// closed.
std::vector<CoedgeId> uses_from(const Complex& k, EdgeId gone, CoedgeId after, bool flipped) {
  std::vector<CoedgeId> uses;
  if (k.is_wire(gone)) return uses;
  for (CoedgeId c = k.radial(after);; c = k.radial(c)) {
    uses.push_back(c);
    if (c == after) break;
  }
  if (flipped) std::reverse(uses.begin(), uses.end());
  return uses;
}

/// A face whose only loop is these two edges.
FaceId digon_between(const Complex& k, EdgeId kept, EdgeId gone) {
  for (const CoedgeId c : k.coedges(kept)) {
    const CoedgeId d = k.next(c);
    if (k.edge(d) == gone && k.next(d) == c && k.loops(k.face(c)).count() == 1) return k.face(c);
  }
  return {};
}

/// The coedge behind which the sector lies that a side of a face sees at one of the face's coedges.
CoedgeId sector_at(const Complex& k, CoedgeId c, FaceUse side) {
  return k.side_after(c) == side ? c : k.radial_prev(c);
}

}  // namespace

Result<Applied> g_v(Complex& k, VertexId kept, VertexId gone) {
  ARESTA_CHECK(want(k, kept, "vertex"));
  ARESTA_CHECK(want(k, gone, "vertex"));
  if (kept == gone) return Error{errors::wrong_place, name_of(kept) + " cannot be glued to itself", {kept}};
  const std::vector<RegionId> a = regions_at(k, kept), b = regions_at(k, gone);
  if (std::none_of(a.begin(), a.end(), [&](RegionId r) { return std::binary_search(b.begin(), b.end(), r); })) {
    return Error{
        errors::not_in_region, name_of(kept) + " and " + name_of(gone) + " touch no common region", {kept, gone}};
  }
  Operation op(k, "G_V");
  ARESTA_CHECK(merge_vertices(k, op, kept, gone));
  op.applied().vertex = kept;
  return op.finish("gv", made_letters, killed_letters, true);
}

Result<Applied> g_e(Complex& k, EdgeId kept, EdgeId gone, const EdgeGluing& gluing) {
  ARESTA_CHECK(want(k, kept, "edge"));
  ARESTA_CHECK(want(k, gone, "edge"));
  if (kept == gone) return Error{errors::wrong_place, name_of(kept) + " cannot be glued to itself", {kept}};
  if (k.is_closed(kept) != k.is_closed(gone)) {
    return Error{
        errors::wrong_place, "only one of " + name_of(kept) + " and " + name_of(gone) + " is closed", {kept, gone}};
  }
  bool flipped = gluing.opposite;
  if (!k.is_closed(kept)) {
    const bool same = k.start(kept) == k.start(gone) || k.end(kept) == k.end(gone);
    const bool opposite = k.start(kept) == k.end(gone) || k.end(kept) == k.start(gone);
    if (same != opposite) flipped = opposite;
  }
  Operation op(k, "G_E");
  op.applied().edge = kept;
  const FaceId digon = digon_between(k, kept, gone);
  Sectors at;
  if (!digon.valid()) {
    ARESTA_TRY(at, choose_sectors(k, kept, gone, gluing));
  }
  for (int end = 0; end < 2; ++end) {
    const VertexId v = k.vertex({kept, end}), w = k.vertex({gone, flipped ? 1 - end : end});
    if (v != w) ARESTA_CHECK(merge_vertices(k, op, v, w));
  }
  if (k.start(kept) != (flipped ? k.end(gone) : k.start(gone)) ||
      k.end(kept) != (flipped ? k.start(gone) : k.end(gone))) {
    return Error{errors::wrong_place,
                 "the ends of " + name_of(kept) + " and " + name_of(gone) + " do not fit together",
                 {kept, gone}};
  }
  if (digon.valid()) {
    DigonChange x;
    x.face = digon;
    const LoopId l = *k.loops(digon).begin();
    x.kept_use = k.first_coedge(l);
    x.gone_use = k.next(x.kept_use);
    if (k.edge(x.kept_use) != kept) std::swap(x.kept_use, x.gone_use);
    op.make(x);
    return op.finish("ge", made_letters, killed_letters, true);
  }
  EdgeMergeChange x;
  x.kept = kept;
  x.gone = gone;
  x.flipped = flipped;
  x.after = at.kept_after;
  x.uses = uses_from(k, gone, at.gone_after, flipped);
  x.division = gluing.division;
  x.division.region = RegionId();
  x.division.extent = Division::Extent::found;
  const EdgeMergeChange& made = op.make(x);
  ARESTA_CHECK(require_fans_fit(k, {k.start(kept), k.end(kept)}));
  if (made.division.region.valid()) {
    const FaceUse stays = made.division.side == 1 ? k.side_after(made.after) : k.side_after(made.uses.back());
    if (k.region(stays) == made.division.region) {
      return Error{
          errors::wrong_place, "what should go into the new region is connected with what stays outside", {kept}};
    }
    ARESTA_CHECK(require_regions_meet(k, made.division.region));
    op.applied().region = made.division.region;
  } else if (!made.division.others.empty()) {
    return Error{
        errors::wrong_place, "the gluing closes nothing off, so that nothing can go into a new region", {kept}};
  }
  return op.finish("ge", made_letters, killed_letters, true);
}

Result<Applied> g_f(Complex& k, FaceUse kept, FaceUse gone, std::span<const std::pair<CoedgeId, CoedgeId>> pairs) {
  const FaceId f = kept.face(), g = gone.face();
  ARESTA_CHECK(want(k, f, "face"));
  ARESTA_CHECK(want(k, g, "face"));
  if (f == g) return Error{errors::wrong_place, name_of(f) + " cannot be glued to itself", {f}};
  const RegionId r = k.region(kept);
  if (k.region(gone) != r) {
    return Error{errors::not_in_region,
                 "the sides of " + name_of(f) + " and " + name_of(g) + " do not look into one region",
                 {f, g}};
  }
  const bool flipped = kept.side() == gone.side();
  struct Pair {
    CoedgeId c, d;
  };
  std::vector<std::vector<Pair>> loops;
  std::vector<LoopId> paired, points_f, points_g;
  for (const auto& [c, d] : pairs) {
    ARESTA_CHECK(want(k, c, "coedge"));
    ARESTA_CHECK(want(k, d, "coedge"));
    if (k.face(c) != f || k.face(d) != g) {
      return Error{errors::wrong_place, "a pair of coedges is not one of each face", {f, g}};
    }
    if (k.coedges(k.loop(c)).count() != k.coedges(k.loop(d)).count()) {
      return Error{errors::wrong_place, "loops with different numbers of edges cannot be laid on each other", {f, g}};
    }
    for (const LoopId l : {k.loop(c), k.loop(d)}) {
      if (std::find(paired.begin(), paired.end(), l) != paired.end()) {
        return Error{errors::wrong_place, "loop " + std::to_string(l.value) + " is paired twice", {f, g}};
      }
      paired.push_back(l);
    }
    auto& loop = loops.emplace_back();
    CoedgeId b = d;
    CoedgeId a = c;
    do {
      loop.push_back({a, b});
      a = k.next(a);
      b = flipped ? k.prev(b) : k.next(b);
    } while (a != c);
  }
  for (const LoopId l : k.loops(f)) {
    if (k.is_vertex_loop(l)) points_f.push_back(l);
  }
  for (const LoopId l : k.loops(g)) {
    if (k.is_vertex_loop(l)) points_g.push_back(l);
  }
  if (points_f.size() != points_g.size() || k.loops(f).count() != pairs.size() + points_f.size() ||
      k.loops(g).count() != pairs.size() + points_g.size()) {
    return Error{
        errors::wrong_place, "the loops of " + name_of(f) + " and " + name_of(g) + " are not all paired", {f, g}};
  }

  Operation op(k, "G_F");
  op.applied().face = f;
  // First the corners, then the edges, of which the last closes the space between the faces; then that space goes.
  for (const auto& loop : loops) {
    for (const Pair& p : loop) {
      const VertexId v = k.start(p.c), w = flipped ? k.end(p.d) : k.start(p.d);
      if (v != w) ARESTA_CHECK(merge_vertices(k, op, v, w));
    }
  }
  for (std::size_t i = 0; i < points_f.size(); ++i) {
    const VertexId v = k.loop_vertex(points_f[i]), w = k.loop_vertex(points_g[i]);
    if (v != w) ARESTA_CHECK(merge_vertices(k, op, v, w));
  }
  const auto is_between = [&] {
    const RegionId between = k.region(kept);
    if (between == Complex::infinite_region() || k.region(gone) != between || k.shells(between).count() != 1)
      return false;
    const ShellId s = k.shell(kept);
    return k.face_uses(s).count() == 2 && k.wires(s).empty() && k.shell(gone) == s;
  };
  for (const auto& loop : loops) {
    for (const Pair& p : loop) {
      const EdgeId e = k.edge(p.c), d = k.edge(p.d);
      if (e == d) {
        if ((k.reversed(p.c) != k.reversed(p.d)) == flipped) continue;
        return Error{errors::senses_disagree, "the loops would run against each other along " + name_of(e), {e}};
      }
      EdgeMergeChange x;
      x.kept = e;
      x.gone = d;
      // c and d run along each other, or against each other when the faces' orientations are opposite.
      x.flipped = (k.reversed(p.c) != k.reversed(p.d)) != flipped;
      const bool after_c = k.side_after(p.c) == kept;
      const CoedgeId sector_c = sector_at(k, p.c, kept), sector_d = sector_at(k, p.d, gone);
      if (k.region(k.side_after(sector_c)) != k.region(k.side_after(sector_d))) {
        return Error{
            errors::senses_disagree, "the sides of the faces do not look at each other along " + name_of(e), {e, d}};
      }
      x.after = sector_c;
      x.uses = uses_from(k, d, sector_d, x.flipped);
      x.division.side = after_c ? 0 : 1;
      const EdgeMergeChange made = op.make(x);
      if ((after_c ? made.uses.front() : made.uses.back()) != p.d) {
        return Error{errors::senses_disagree, "the faces' orientations do not fit along " + name_of(e), {e, d}};
      }
      if (made.division.region.valid() && !is_between()) {
        return pinch("gluing " + name_of(f) + " and " + name_of(g) + " encloses more than the space between them",
                     {f, g});
      }
    }
  }
  if (!is_between()) {
    return pinch("the space between " + name_of(f) + " and " + name_of(g) + " is not theirs alone", {f, g});
  }
  ARESTA_CHECK(require_regions_meet(k, k.region(kept)));
  for (const auto& loop : loops) {
    for (const Pair& p : loop) ARESTA_CHECK(require_fans_fit(k, {k.start(p.c)}));
  }
  FaceMergeChange x;
  x.kept = f;
  x.gone = g;
  x.flipped = flipped;
  x.kept_side = kept.side();
  x.region = k.region(kept);
  x.filled = k.is_filled(x.region);
  // The order about an edge is noted as it will be when the uses before have gone.
  std::vector<CoedgeId> taken;
  const auto was_taken = [&](CoedgeId c) { return std::find(taken.begin(), taken.end(), c) != taken.end(); };
  for (const auto& loop : loops) {
    auto& pair = x.loops.emplace_back();
    pair.id = k.loop(loop.front().d);
    pair.beside = k.loop(loop.front().c);
    // In the order of the loop that goes.
    std::vector<Pair> ordered = loop;
    if (flipped) std::reverse(ordered.begin(), ordered.end());
    for (const Pair& p : ordered) {
      CoedgeId before = k.radial_prev(p.d);
      while (was_taken(before)) before = k.radial_prev(before);
      pair.uses.push_back({p.d, p.c, before == p.c});
      taken.push_back(p.d);
    }
  }
  for (std::size_t i = 0; i < points_f.size(); ++i) x.loops.push_back({points_g[i], points_f[i], {}});
  op.make(x);
  return op.finish("gf", made_letters, killed_letters, true);
}

Result<Applied> esplit(Complex& k, EdgeId e) {
  ARESTA_CHECK(want(k, e, "edge"));
  // The split is an edge contraction taken back; its ids are chosen here.
  VertexMergeChange x;
  {
    Editor ids(k);
    x.gone = ids.make_vertex();
    x.edge = ids.make_edge();
    for (const CoedgeId c : k.coedges(e)) {
      VertexMergeChange::Use use;
      use.id = ids.make_coedge();
      use.reversed = k.reversed(c);
      use.loop = k.loop(c);
      if (!x.uses.empty()) use.after = x.uses.back().id;
      x.uses.push_back(use);
    }
    for (auto use = x.uses.rbegin(); use != x.uses.rend(); ++use) ids.free(use->id);
    ids.free(x.edge);
    ids.free(x.gone);
  }
  x.kept = k.end(e);
  x.kept_is_start = false;
  x.ends = {{e, 1}};
  x.split_of = e;
  if (k.is_wire(e)) x.wire_region = k.region(k.wire_shell(e));
  // A use along e is followed by one of the new edge; a use against e is preceded by one.
  std::size_t i = 0;
  std::vector<std::pair<CoedgeId, CoedgeId>> followed;
  for (const CoedgeId c : k.coedges(e)) {
    auto& use = x.uses[i++];
    use.prev = use.reversed ? k.prev(c) : c;
    for (const auto& [old, fresh] : followed) {
      if (use.reversed && old == use.prev) use.prev = fresh;
    }
    if (!use.reversed) followed.emplace_back(c, use.id);
  }
  Operation op(k, "ESPLIT");
  op.applied().vertex = x.gone;
  op.applied().edge = x.edge;
  op.kill(x);
  return op.finish("", "eflrsv", "lsvefr", false);
}

Result<Applied> esqueeze(Complex& k, EdgeId e, VertexId kept) {
  ARESTA_CHECK(want(k, e, "edge"));
  if (!kept.valid()) kept = k.start(e);
  if (kept != k.start(e) && kept != k.end(e)) {
    return Error{errors::wrong_place, "vertex " + std::to_string(kept.value) + " is no end of " + name_of(e), {e}};
  }
  Operation op(k, "ESQUEEZE");
  op.applied().vertex = kept;
  if (k.is_closed(e)) {
    if (!k.is_wire(e)) {
      return pinch(name_of(e) + " is closed and bounds faces: a ring of theirs cannot shrink to a point", {e});
    }
    op.kill(WireChange{e, kept, kept, k.region(k.wire_shell(e))});
    return op.finish("", "sl", "evsflr", true);
  }
  std::vector<std::pair<FaceUse, FaceUse>> beside;
  for (const CoedgeId c : k.coedges(e)) beside.emplace_back(k.side_after(c), k.side_before(k.radial(c)));
  VertexMergeChange x;
  x.kept = kept;
  x.gone = kept == k.start(e) ? k.end(e) : k.start(e);
  x.edge = e;
  op.make(x);
  ARESTA_CHECK(require_no_double_corner(k, kept));
  for (const auto& [a, b] : beside) {
    if (!sides_connected(k, a, b)) {
      return pinch(name_of(a.face()) + " and " + name_of(b.face()) + " enclose space together along " + name_of(e) +
                       ", which would be lost",
                   {e, a.face(), b.face()});
    }
  }
  return op.finish("", "sl", "evsflr", true);
}

}  // namespace aresta
