// SPDX-License-Identifier: Apache-2.0
// The non-manifold operators: the only way to change a radial edge complex step by step.
//
// Each checks its arguments before anything changes and leaves the complex as it was when it fails; says which of its
// sub-cases happened, by what was made (m) and killed (k): v vertex, e edge, f face, l loop, s shell, r region; and
// gives the elementary changes that it consists of, which take_back() reverses exactly, ids included. Names after K.
// Weiler, "Topological structures for geometric modeling", 1986, chapter on non-manifold operators.
//
//   operator   sub-cases                                        inverse
//   M_MR       mmr                                              K_M
//   M_SV       msv                                              K_V kvs
//   M_EV       mev                                              K_V kve
//   M_E        me, meks                                         K_E ke, kems
//   M_F        mfl, mflrs (and with ks: joins shells)           K_F kfl, kflms, kflrs
//   M_RSFL     mrsfl                                            K_F kflrs
//   MM_VL      mvl                                              K_V kvl
//   MM_EV      mev                                              K_V kve
//   MM_E       mefl, mekl                                       K_E kefl, keml
//   K_V        kvs kve kvl kvlms kvfle kvsfle kvrsfl kvrsfle    what made them, in reverse
//   K_E        ke kems keml kefl keflms                         the same
//   K_F        kfl kflms kflrs                                  M_F
//   G_V        gvkv gvksv                                       take_back (the vertex is split again)
//   G_E        geke gekfle gekev geksev                         the same
//   G_F        gfkflev gfksflev                                 the same
//   ESPLIT     mev                                              ESQUEEZE kev
//   ESQUEEZE   kev, ke                                          take_back, ESPLIT
//
// What an operator makes or kills beyond the names above is added to the sub-case in the same letters (a face killed
// with its region and a shell split off: "kflrms"). Who keeps what: the entity named first (`kept`, the old face, the
// old edge) stays and keeps its attributes; lineage.h says how they follow.
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "topology/change.h"
#include "topology/errors.h"

namespace aresta {

/// How many more there are than before; negative when fewer.
struct CountChange {
  int vertices = 0, edges = 0, faces = 0, loops = 0, shells = 0, regions = 0;
  bool operator==(const CountChange&) const = default;
};

/// An operator that was applied.
struct Applied {
  std::string name;      ///< "M_EV"
  std::string sub_case;  ///< "mev"
  CountChange change;
  std::vector<Change> steps;  ///< in the order in which they were made

  // What was made, where the operator makes one.
  VertexId vertex;
  EdgeId edge;
  FaceId face;
  LoopId loop;
  RegionId region;
};

/// Reverses an operator; the complex must be as the operator left it.
void take_back(Complex& k, Applied& applied);
/// Applies it again after take_back, with the same ids.
void make_again(Complex& k, Applied& applied);

// --- constructive

/// A complex with nothing but infinite space.
///
///     (nothing)  ->  [ R0 ]                                                   R +1
Complex m_mr();

/// A vertex alone in a region.
///
///     [   ]  ->  [ . ]                                                        V +1  S +1
Result<Applied> m_sv(Complex& k, RegionId region, VertexId wanted = {});

/// A wire from a vertex to a new one, in a region that the vertex touches (invalid: the only one).
///
///     .  ->  .--.                                                             V +1  E +1
Result<Applied> m_ev(Complex& k, VertexId at, RegionId region = {});

/// A wire between two vertices that touch a common region (invalid: the only one); start and end may be one vertex.
///
///     .  .  ->  .--.                                                          E +1  (S -1: meks)
Result<Applied> m_e(Complex& k, VertexId start, VertexId end, RegionId region = {});

/// A use of an edge in a circuit. `after`: the coedge behind which the new one comes about the edge, where the edge has
/// several sectors in the face's region.
struct EdgeUseSpec {
  EdgeId edge;
  bool reversed = false;
  CoedgeId after;
};

/// A loop to be: edges head to tail, or a vertex.
struct Circuit {
  std::vector<EdgeUseSpec> uses;
  VertexId vertex;
};

struct FaceSpec {
  std::vector<Circuit> circuits;
  RegionId region;    ///< that the face lies in; invalid: the only one that all its edges touch
  Division division;  ///< if the face closes something off: what the new region is, and what goes into it
};

/// A face into circuits of edges that are there. If its sides are not connected afterwards the region is divided: wires
/// that hang inside follow, other components as `division.others` says. Errors: open_circuit, not_in_region,
/// ambiguous_place, cuts_wire.
///
///     .--.      .--.
///     |  |  ->  |##|                                                          F +1  L +n  (S, R +1: mflrs)
///     .--.      .--.
Result<Applied> m_f(Complex& k, const FaceSpec& spec);

/// A closed face (a sphere) at one vertex; what is inside is a new region.
///
///     .  ->  (.)                                                              R +1  S +1  F +1  L +1
Result<Applied> m_rsfl(Complex& k, VertexId at, RegionId region = {}, bool filled = true);

/// A vertex inside a face, as a loop of it.
///
///     |     |  ->  |  .  |                                                    V +1  L +1
Result<Applied> mm_vl(Complex& k, FaceId face);

/// A place on a face: where a coedge starts, or a loop that is a vertex.
struct Corner {
  CoedgeId coedge;
  LoopId vertex_loop;
};

/// An edge from a corner of a face into the face, to a new vertex.
///
///     |     |  ->  |--.  |                                                    V +1  E +1
Result<Applied> mm_ev(Complex& k, Corner at);

/// An edge across a face between two corners: of one loop (the face is divided: mefl; `moved` loops go to the new face,
/// which lies to the right of the edge) or of two loops, which become one (mekl).
///
///     |   |  ->  |---|                              E +1  F +1  L +1    or    E +1  L -1
Result<Applied> mm_e(Complex& k, Corner from, Corner to, std::span<const LoopId> moved = {});

// --- destructive

/// A vertex and all that needs it: a strut with its edge, a loop with the vertex, else every face and edge at it.
Result<Applied> k_v(Complex& k, VertexId v);

/// An edge. A wire goes alone; an edge used twice by one loop leaves two loops; one between two faces of agreeing
/// orientation leaves one face (`kept`, else the smaller id; never one of which the edge is all of a loop while it is
/// not of the other); otherwise its faces go too.
Result<Applied> k_e(Complex& k, EdgeId e, FaceId kept = {});

/// A face; its edges stay, those without another face as wires. Two regions at its sides become one: `kept`, or the
/// infinite one, or the one in front.
///
///     .--.      .--.
///     |##|  ->  |  |                                                          F -1  L -n  (S, R)
///     .--.      .--.
Result<Applied> k_f(Complex& k, FaceId f, RegionId kept = {});

/// The whole complex, which must hold nothing but infinite space. Errors: in_use, naming what is left.
Status k_m(const Complex& k);

// --- gluing

/// Two vertices that touch a common region become one.
///
///     . .  ->  .                                                              V -1  (S -1: gvksv)
Result<Applied> g_v(Complex& k, VertexId kept, VertexId gone);

struct EdgeGluing {
  CoedgeId kept_after, gone_after;  ///< the sectors, behind these, that are closed; invalid: the only ones possible
  bool opposite = false;            ///< gone runs against kept; told by the vertices when these are shared already
  Division division;                ///< if this encloses something: see EdgeMergeChange for the sides
};

/// Two edges become one, and their ends too. Errors: not_in_region, ambiguous_place, would_pinch.
///
///     .--.
///     .--.  ->  .--.                                                          E -1  (F, L, V, S)
Result<Applied> g_e(Complex& k, EdgeId kept, EdgeId gone, const EdgeGluing& gluing = {});

/// Two faces become one: `gone` is laid on `kept`, with the sides that look at each other (both in one region). For
/// each loop a pair of coedges that come to lie on each other; loops that are vertices are paired in order. When both
/// sides have the same number the faces' orientations are opposite and the loops run against each other. Errors:
/// senses_disagree, would_pinch when the gluing encloses anything else, cuts_wire when it cuts off what is outside.
Result<Applied> g_f(Complex& k, FaceUse kept, FaceUse gone, std::span<const std::pair<CoedgeId, CoedgeId>> pairs);

// --- composed

/// A vertex in the middle of an edge; the old edge keeps its start.
///
///     .-----.  ->  .--.--.                                                    V +1  E +1
Result<Applied> esplit(Complex& k, EdgeId e);

/// An edge shrinks to its vertex `kept` (invalid: its start). Errors: would_pinch when faces would no longer enclose
/// what they do; a closed edge must be a wire.
///
///     .--.--.  ->  .-----.                                                    V -1  E -1    or    E -1
Result<Applied> esqueeze(Complex& k, EdgeId e, VertexId kept = {});

}  // namespace aresta
