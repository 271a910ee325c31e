// SPDX-License-Identifier: Apache-2.0
// Second stage: every list of the structure, by one walk. All links lead to rows in use by now, but a walk may still
// meet itself: it ends at the first member that was seen before.
#include <utility>

#include "topology/check_detail.h"

namespace aresta::check_detail {

namespace {

using namespace structure;

constexpr std::uint32_t none = ComplexRows::none;

/// A kind of list: owners hold members, each of which names its owner. Codes are row indices, or 2 * row + half.
template <class First, class Owner, class Next, class Prev, class Live>
struct Lists {
  std::uint32_t owners, members;  ///< bounds of their codes
  bool closed;                    ///< cycles; else chains, in which the first member's prev is the last one
  Live is_live;                   ///< of a member
  First first;                    ///< of an owner; none for an empty list or an owner that is not in use
  Owner owner;                    ///< of a member
  Next next;
  Prev prev;
};
template <class First, class Owner, class Next, class Prev, class Live>
Lists(std::uint32_t, std::uint32_t, bool, Live, First, Owner, Next, Prev) -> Lists<First, Owner, Next, Prev, Live>;

/// Reports, by (owner, member): links that are broken; a member that names another owner; one that is missing in its
/// owner's list. An owner about which there is something else is not reported to miss members as well.
template <class L, class Broken, class Foreign, class Missing>
void check(const L& lists, Broken&& broken, Foreign&& foreign, Missing&& missing) {
  bool links_answer = true;
  for (std::uint32_t m = 0; m < lists.members; ++m) {
    if (!lists.is_live(m)) continue;
    const std::uint32_t next = lists.next(m);
    if ((lists.closed || next != none) && lists.prev(next) != m) {
      links_answer = false;
      broken(lists.owner(m), m);
    }
  }
  if (!links_answer) return;

  std::vector<bool> seen(lists.members, false), strange(lists.members, false), reported(lists.owners, false);
  for (std::uint32_t o = 0; o < lists.owners; ++o) {
    const std::uint32_t first = lists.first(o);
    if (first == none) continue;
    if (lists.owner(first) != o) {
      foreign(o, first);
      strange[first] = reported[o] = true;
      continue;
    }
    for (std::uint32_t m = first;;) {
      if (seen[m]) {
        broken(o, m);
        reported[o] = true;
        break;
      }
      seen[m] = true;
      if (lists.owner(m) != o) {
        foreign(o, m);
        reported[o] = true;
      }
      const std::uint32_t next = lists.next(m);
      if (lists.closed && next == first) break;
      if (next == none) {
        if (lists.prev(first) != m) {
          broken(o, first);
          reported[o] = true;
        }
        break;
      }
      m = next;
    }
  }
  for (std::uint32_t m = 0; m < lists.members; ++m) {
    if (lists.is_live(m) && !seen[m] && !strange[m] && !reported[lists.owner(m)]) missing(lists.owner(m), m);
  }
}

std::uint32_t bound(std::size_t size) {
  return static_cast<std::uint32_t>(size);
}

EdgeEnd edge_end(std::uint32_t code) {
  return {EdgeId(code >> 1), static_cast<int>(code & 1u)};
}

void check_edge_ends(const ComplexRows& rows, Findings& findings) {
  const auto& edges = rows.edges();
  const auto vertex = [&](std::uint32_t end) { return edges[end >> 1].vertex[end & 1u]; };
  const Lists lists{bound(rows.vertices().size()),
                    2 * bound(edges.size()),
                    true,
                    [&](std::uint32_t end) { return rows.k.is_live(EdgeId(end >> 1)); },
                    [&](std::uint32_t v) { return rows.k.is_live(VertexId(v)) ? rows.vertices()[v].first_end : none; },
                    vertex,
                    [&](std::uint32_t end) { return edges[end >> 1].next[end & 1u]; },
                    [&](std::uint32_t end) { return edges[end >> 1].prev[end & 1u]; }};
  check(
      lists,
      [&](std::uint32_t v, std::uint32_t end) {
        findings.push_back(EndCycleBroken{VertexId(v), edge_end(end)});
      },
      [&](std::uint32_t v, std::uint32_t end) {
        findings.push_back(EndInOtherCycle{VertexId(v), edge_end(end)});
      },
      [&](std::uint32_t v, std::uint32_t end) {
        findings.push_back(EndNotInCycle{VertexId(v), edge_end(end)});
      });
}

void check_loop_cycles(const ComplexRows& rows, Findings& findings) {
  const auto& coedges = rows.coedges();
  const auto first = [&](std::uint32_t l) {
    const bool has_coedges = rows.k.is_live(LoopId(l)) && !ComplexRows::is_tagged(rows.loops()[l].first);
    return has_coedges ? rows.loops()[l].first : none;
  };
  const Lists lists{bound(rows.loops().size()),
                    bound(coedges.size()),
                    true,
                    [&](std::uint32_t c) { return rows.k.is_live(CoedgeId(c)); },
                    first,
                    [&](std::uint32_t c) { return coedges[c].loop; },
                    [&](std::uint32_t c) { return coedges[c].next; },
                    [&](std::uint32_t c) { return coedges[c].prev; }};
  check(
      lists,
      [&](std::uint32_t l, std::uint32_t c) {
        findings.push_back(LoopCycleBroken{LoopId(l), CoedgeId(c)});
      },
      [&](std::uint32_t l, std::uint32_t c) {
        findings.push_back(CoedgeInOtherLoop{LoopId(l), CoedgeId(c)});
      },
      [&](std::uint32_t l, std::uint32_t c) {
        findings.push_back(CoedgeNotInLoop{LoopId(l), CoedgeId(c)});
      });
}

void check_radial_cycles(const ComplexRows& rows, Findings& findings) {
  const auto& coedges = rows.coedges();
  // Linked one way only: the other way is whoever comes to the coedge first.
  std::vector<std::uint32_t> prev(coedges.size(), none);
  for (std::uint32_t c = 0; c < coedges.size(); ++c) {
    if (rows.k.is_live(CoedgeId(c)) && prev[coedges[c].radial] == none) prev[coedges[c].radial] = c;
  }
  const auto first = [&](std::uint32_t e) {
    const bool has_coedges = rows.k.is_live(EdgeId(e)) && !ComplexRows::is_tagged(rows.edges()[e].first_use);
    return has_coedges ? rows.edges()[e].first_use : none;
  };
  const Lists lists{bound(rows.edges().size()),
                    bound(coedges.size()),
                    true,
                    [&](std::uint32_t c) { return rows.k.is_live(CoedgeId(c)); },
                    first,
                    [&](std::uint32_t c) { return coedges[c].edge_sense >> 1; },
                    [&](std::uint32_t c) { return coedges[c].radial; },
                    [&](std::uint32_t c) { return prev[c]; }};
  check(
      lists,
      [&](std::uint32_t e, std::uint32_t c) {
        findings.push_back(RadialCycleBroken{EdgeId(e), CoedgeId(c)});
      },
      [&](std::uint32_t e, std::uint32_t c) {
        findings.push_back(CoedgeInOtherRadialCycle{EdgeId(e), CoedgeId(c)});
      },
      [&](std::uint32_t e, std::uint32_t c) {
        findings.push_back(CoedgeNotInRadialCycle{EdgeId(e), CoedgeId(c)});
      });
}

void check_loop_chains(const ComplexRows& rows, Findings& findings) {
  const auto& loops = rows.loops();
  const Lists lists{bound(rows.faces().size()),
                    bound(loops.size()),
                    false,
                    [&](std::uint32_t l) { return rows.k.is_live(LoopId(l)); },
                    [&](std::uint32_t f) { return rows.k.is_live(FaceId(f)) ? rows.faces()[f].first_loop : none; },
                    [&](std::uint32_t l) { return loops[l].face; },
                    [&](std::uint32_t l) { return loops[l].next; },
                    [&](std::uint32_t l) { return loops[l].prev; }};
  check(
      lists,
      [&](std::uint32_t f, std::uint32_t l) {
        findings.push_back(LoopChainBroken{FaceId(f), LoopId(l)});
      },
      [&](std::uint32_t f, std::uint32_t l) {
        findings.push_back(LoopInOtherFace{FaceId(f), LoopId(l)});
      },
      [&](std::uint32_t f, std::uint32_t l) {
        findings.push_back(LoopNotInFace{FaceId(f), LoopId(l)});
      });
}

void check_side_chains(const ComplexRows& rows, Findings& findings) {
  const auto& faces = rows.faces();
  const auto use = [](std::uint32_t u) { return FaceUse::from_index(u); };
  const Lists lists{
      bound(rows.shells().size()),
      2 * bound(faces.size()),
      false,
      [&](std::uint32_t u) { return rows.k.is_live(FaceId(u >> 1)); },
      [&](std::uint32_t s) { return rows.k.is_live(ShellId(s)) ? rows.shells()[s].first_face_use : none; },
      [&](std::uint32_t u) { return faces[u >> 1].shell[u & 1u]; },
      [&](std::uint32_t u) { return faces[u >> 1].next_in_shell[u & 1u]; },
      [&](std::uint32_t u) { return faces[u >> 1].prev_in_shell[u & 1u]; }};
  check(
      lists,
      [&](std::uint32_t s, std::uint32_t u) {
        findings.push_back(SideChainBroken{ShellId(s), use(u)});
      },
      [&](std::uint32_t s, std::uint32_t u) {
        findings.push_back(SideInOtherShell{ShellId(s), use(u)});
      },
      [&](std::uint32_t s, std::uint32_t u) {
        findings.push_back(SideNotInShell{ShellId(s), use(u)});
      });
}

void check_wire_chains(const ComplexRows& rows, Findings& findings) {
  const auto& wires = rows.wires();
  const auto edge = [&](std::uint32_t w) { return EdgeId(wires[w].edge); };
  const Lists lists{bound(rows.shells().size()),
                    bound(wires.size()),
                    false,
                    [&](std::uint32_t w) {
                      return rows.is_live({RowKind::wire, w});
                    },
                    [&](std::uint32_t s) { return rows.k.is_live(ShellId(s)) ? rows.shells()[s].first_wire : none; },
                    [&](std::uint32_t w) { return wires[w].shell; },
                    [&](std::uint32_t w) { return wires[w].next; },
                    [&](std::uint32_t w) { return wires[w].prev; }};
  check(
      lists,
      [&](std::uint32_t s, std::uint32_t w) {
        findings.push_back(WireChainBroken{ShellId(s), edge(w)});
      },
      [&](std::uint32_t s, std::uint32_t w) {
        findings.push_back(WireInOtherShell{ShellId(s), edge(w)});
      },
      [&](std::uint32_t s, std::uint32_t w) {
        findings.push_back(WireNotInShell{ShellId(s), edge(w)});
      });
}

void check_shell_chains(const ComplexRows& rows, Findings& findings) {
  const auto& shells = rows.shells();
  const Lists lists{bound(rows.regions().size()),
                    bound(shells.size()),
                    false,
                    [&](std::uint32_t s) { return rows.k.is_live(ShellId(s)); },
                    [&](std::uint32_t r) { return rows.k.is_live(RegionId(r)) ? rows.regions()[r].first_shell : none; },
                    [&](std::uint32_t s) { return shells[s].region; },
                    [&](std::uint32_t s) { return shells[s].next; },
                    [&](std::uint32_t s) { return shells[s].prev; }};
  check(
      lists,
      [&](std::uint32_t r, std::uint32_t s) {
        findings.push_back(ShellChainBroken{RegionId(r), ShellId(s)});
      },
      [&](std::uint32_t r, std::uint32_t s) {
        findings.push_back(ShellInOtherRegion{RegionId(r), ShellId(s)});
      },
      [&](std::uint32_t r, std::uint32_t s) {
        findings.push_back(ShellNotInRegion{RegionId(r), ShellId(s)});
      });
}

/// Edges and wire records name each other.
void check_wire_uses(const ComplexRows& rows, Findings& findings) {
  for (const EdgeId e : rows.k.edges()) {
    const std::uint32_t use = rows.edges()[e.index()].first_use;
    if (use == none || !ComplexRows::is_tagged(use)) continue;
    const std::uint32_t wire = use & ~ComplexRows::tag;
    if (rows.wires()[wire].edge != e.value) findings.push_back(WireUseBroken{e, wire});
  }
  for (std::uint32_t w = 0; w < rows.wires().size(); ++w) {
    if (!rows.is_live({RowKind::wire, w})) continue;
    const std::uint32_t e = rows.wires()[w].edge;
    if (rows.edges()[e].first_use != (w | ComplexRows::tag)) findings.push_back(WireUseBroken{EdgeId(e), w});
  }
}

/// Loops that are vertices and the lists of the vertices' point uses name each other.
void check_point_uses(const ComplexRows& rows, Findings& findings) {
  const auto& uses = rows.point_uses();
  std::vector<bool> seen(uses.size(), false), listed(rows.loops().size(), false);
  std::vector<bool> reported(rows.loops().size(), false);
  for (const VertexId v : rows.k.vertices()) {
    const std::uint32_t owner = rows.vertices()[v.index()].owner;
    if (ComplexRows::is_tagged(owner)) continue;  // isolated, or none
    for (std::uint32_t use = owner; use != none; use = uses[use].next) {
      const LoopId l(uses[use].loop);
      if (seen[use]) {
        findings.push_back(PointUseChainBroken{v, l});
        reported[l.index()] = true;
        break;
      }
      seen[use] = true;
      if (rows.loops()[l.index()].first != (v.value | ComplexRows::tag)) {
        findings.push_back(PointUseOfOtherLoop{v, l});
      } else if (listed[l.index()]) {
        findings.push_back(PointUseChainBroken{v, l});
        reported[l.index()] = true;
      } else {
        listed[l.index()] = true;
      }
    }
  }
  for (const LoopId l : rows.k.loops()) {
    const std::uint32_t first = rows.loops()[l.index()].first;
    if (first == none || !ComplexRows::is_tagged(first) || listed[l.index()]) continue;
    findings.push_back(VertexLoopNotListed{VertexId(first & ~ComplexRows::tag), l});
    reported[l.index()] = true;
  }
  for (std::uint32_t use = 0; use < uses.size(); ++use) {
    if (!rows.is_live({RowKind::point_use, use}) || seen[use] || reported[uses[use].loop]) continue;
    findings.push_back(PointUseStray{use, LoopId(uses[use].loop)});
  }
}

/// Isolated vertices and their shells name each other.
void check_isolation(const ComplexRows& rows, Findings& findings) {
  for (const VertexId v : rows.k.vertices()) {
    const std::uint32_t owner = rows.vertices()[v.index()].owner;
    if (owner == none || !ComplexRows::is_tagged(owner)) continue;
    const ShellId s(owner & ~ComplexRows::tag);
    if (rows.shells()[s.index()].vertex != v.value) findings.push_back(IsolationBroken{v, s});
  }
  for (const ShellId s : rows.k.shells()) {
    const std::uint32_t v = rows.shells()[s.index()].vertex;
    if (v == none || rows.vertices()[v].owner == (s.value | ComplexRows::tag)) continue;
    findings.push_back(IsolationBroken{VertexId(v), s});
  }
}

}  // namespace

void check_lists(const ComplexRows& rows, Findings& findings) {
  check_edge_ends(rows, findings);
  check_loop_cycles(rows, findings);
  check_radial_cycles(rows, findings);
  check_loop_chains(rows, findings);
  check_side_chains(rows, findings);
  check_wire_chains(rows, findings);
  check_shell_chains(rows, findings);
  check_wire_uses(rows, findings);
  check_point_uses(rows, findings);
  check_isolation(rows, findings);
}

}  // namespace aresta::check_detail
