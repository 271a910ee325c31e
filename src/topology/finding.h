// SPDX-License-Identifier: Apache-2.0
// What the structural checker finds: one invariant, one type, each with its evidence. Each comment says what is wrong.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <variant>

#include "topology/complex.h"
#include "topology/item.h"

namespace aresta {

/// The tables of a complex, in its order.
enum class RowKind : std::uint8_t { vertex, edge, wire, coedge, point_use, loop, face, shell, region };
const char* to_string(RowKind kind);

/// A row of a table, live or not. Index none: no row.
struct Row {
  RowKind kind = RowKind::vertex;
  std::uint32_t index = 0xffffffffu;
  constexpr auto operator<=>(const Row&) const = default;
};

/// The links of a row, named as in complex.h.
enum class Link : std::uint8_t {
  first_end,
  owner,
  vertex,
  next,
  prev,
  first_use,
  edge,
  shell,
  radial,
  loop,
  first,
  face,
  first_loop,
  next_in_shell,
  prev_in_shell,
  region,
  first_face_use,
  first_wire,
  first_shell
};
const char* to_string(Link link);

namespace structure {

// --- rows

/// The list of free rows comes to a row that is in use, does not exist or was passed before.
struct FreeListBroken {
  Row row;
  auto operator<=>(const FreeListBroken&) const = default;
};
/// A row that is not in use is missing in the list of free rows.
struct DeadRowNotFree {
  Row row;
  auto operator<=>(const DeadRowNotFree&) const = default;
};
/// The number of free rows is not what the complex believes.
struct FreeCountWrong {
  RowKind kind = RowKind::vertex;
  std::uint32_t stated = 0, counted = 0;
  auto operator<=>(const FreeCountWrong&) const = default;
};
/// A link leads to a row that is not in use or does not exist, or leads nowhere where it must not.
struct DanglingLink {
  Row from;
  Link link = Link::next;
  int slot = 0;  ///< end of the edge or side of the face, for the links of which there are two
  Row to;
  auto operator<=>(const DanglingLink&) const = default;
};

// --- lists. For each kind: links that do not answer each other or do not close; a member of the list that names
// another owner; a member that is not in the list of the owner it names.

struct EndCycleBroken {
  VertexId vertex;
  EdgeEnd end;
  auto operator<=>(const EndCycleBroken&) const = default;
};
struct EndInOtherCycle {
  VertexId vertex;  ///< whose cycle it is in
  EdgeEnd end;
  auto operator<=>(const EndInOtherCycle&) const = default;
};
struct EndNotInCycle {
  VertexId vertex;
  EdgeEnd end;
  auto operator<=>(const EndNotInCycle&) const = default;
};

struct LoopCycleBroken {
  LoopId loop;
  CoedgeId coedge;
  auto operator<=>(const LoopCycleBroken&) const = default;
};
struct CoedgeInOtherLoop {
  LoopId loop;  ///< whose cycle it is in
  CoedgeId coedge;
  auto operator<=>(const CoedgeInOtherLoop&) const = default;
};
struct CoedgeNotInLoop {
  LoopId loop;
  CoedgeId coedge;
  auto operator<=>(const CoedgeNotInLoop&) const = default;
};

struct RadialCycleBroken {
  EdgeId edge;
  CoedgeId coedge;
  auto operator<=>(const RadialCycleBroken&) const = default;
};
struct CoedgeInOtherRadialCycle {
  EdgeId edge;  ///< whose cycle it is in
  CoedgeId coedge;
  auto operator<=>(const CoedgeInOtherRadialCycle&) const = default;
};
struct CoedgeNotInRadialCycle {
  EdgeId edge;
  CoedgeId coedge;
  auto operator<=>(const CoedgeNotInRadialCycle&) const = default;
};

struct LoopChainBroken {
  FaceId face;
  LoopId loop;
  auto operator<=>(const LoopChainBroken&) const = default;
};
struct LoopInOtherFace {
  FaceId face;  ///< whose chain it is in
  LoopId loop;
  auto operator<=>(const LoopInOtherFace&) const = default;
};
struct LoopNotInFace {
  FaceId face;
  LoopId loop;
  auto operator<=>(const LoopNotInFace&) const = default;
};

struct SideChainBroken {
  ShellId shell;
  FaceUse side;
  auto operator<=>(const SideChainBroken&) const = default;
};
struct SideInOtherShell {
  ShellId shell;  ///< whose chain it is in
  FaceUse side;
  auto operator<=>(const SideInOtherShell&) const = default;
};
struct SideNotInShell {
  ShellId shell;
  FaceUse side;
  auto operator<=>(const SideNotInShell&) const = default;
};

struct WireChainBroken {
  ShellId shell;
  EdgeId edge;
  auto operator<=>(const WireChainBroken&) const = default;
};
struct WireInOtherShell {
  ShellId shell;  ///< whose chain it is in
  EdgeId edge;
  auto operator<=>(const WireInOtherShell&) const = default;
};
struct WireNotInShell {
  ShellId shell;
  EdgeId edge;
  auto operator<=>(const WireNotInShell&) const = default;
};

struct ShellChainBroken {
  RegionId region;
  ShellId shell;
  auto operator<=>(const ShellChainBroken&) const = default;
};
struct ShellInOtherRegion {
  RegionId region;  ///< whose chain it is in
  ShellId shell;
  auto operator<=>(const ShellInOtherRegion&) const = default;
};
struct ShellNotInRegion {
  RegionId region;
  ShellId shell;
  auto operator<=>(const ShellNotInRegion&) const = default;
};

/// An edge and its wire record do not name each other.
struct WireUseBroken {
  EdgeId edge;
  std::uint32_t wire = 0xffffffffu;
  auto operator<=>(const WireUseBroken&) const = default;
};
/// The list of the loops that are this vertex runs in a circle or comes to one loop twice.
struct PointUseChainBroken {
  VertexId vertex;
  LoopId loop;
  auto operator<=>(const PointUseChainBroken&) const = default;
};
/// The list of the loops that are this vertex has a loop that is not.
struct PointUseOfOtherLoop {
  VertexId vertex;
  LoopId loop;
  auto operator<=>(const PointUseOfOtherLoop&) const = default;
};
/// A loop that is a vertex is missing in the vertex's list.
struct VertexLoopNotListed {
  VertexId vertex;
  LoopId loop;
  auto operator<=>(const VertexLoopNotListed&) const = default;
};
/// A record that a loop is a vertex is in no vertex's list.
struct PointUseStray {
  std::uint32_t use = 0xffffffffu;
  LoopId loop;
  auto operator<=>(const PointUseStray&) const = default;
};
/// An isolated vertex and its shell do not name each other.
struct IsolationBroken {
  VertexId vertex;
  ShellId shell;
  auto operator<=>(const IsolationBroken&) const = default;
};

// --- cells

/// A loop has neither coedges nor a vertex.
struct LoopEmpty {
  LoopId loop;
  auto operator<=>(const LoopEmpty&) const = default;
};
struct FaceWithoutLoop {
  FaceId face;
  auto operator<=>(const FaceWithoutLoop&) const = default;
};
/// An edge is used by no face and is no wire.
struct EdgeUnused {
  EdgeId edge;
  auto operator<=>(const EdgeUnused&) const = default;
};
/// A vertex has no edge, is no loop and is not isolated in a region.
struct VertexUnused {
  VertexId vertex;
  auto operator<=>(const VertexUnused&) const = default;
};
/// A vertex is said to be isolated and has an edge.
struct IsolatedVertexUsed {
  VertexId vertex;
  EdgeId edge;
  auto operator<=>(const IsolatedVertexUsed&) const = default;
};
/// A coedge does not start where the one before it in its loop ends.
struct LoopOpen {
  LoopId loop;
  CoedgeId coedge, next;
  auto operator<=>(const LoopOpen&) const = default;
};
/// A vertex that is a loop of a face is in another loop of that face too.
struct VertexTwiceInFace {
  FaceId face;
  VertexId vertex;
  LoopId loop, other;
  auto operator<=>(const VertexTwiceInFace&) const = default;
};
struct ShellEmpty {
  ShellId shell;
  auto operator<=>(const ShellEmpty&) const = default;
};
/// The shell of an isolated vertex holds something else too.
struct ShellMixed {
  ShellId shell;
  VertexId vertex;
  auto operator<=>(const ShellMixed&) const = default;
};
struct InfiniteRegionMissing {
  auto operator<=>(const InfiniteRegionMissing&) const = default;
};
struct InfiniteRegionFilled {
  auto operator<=>(const InfiniteRegionFilled&) const = default;
};
/// A finite region is bounded by nothing.
struct RegionWithoutShell {
  RegionId region;
  auto operator<=>(const RegionWithoutShell&) const = default;
};
/// The two sides that enclose a sector about an edge lie in different regions.
struct SectorInTwoRegions {
  EdgeId edge;
  FaceUse side_a, side_b;
  auto operator<=>(const SectorInTwoRegions&) const = default;
};
/// A wire ends in a vertex of faces, none of which has a side in the wire's region there.
struct WireOutOfReach {
  EdgeId edge;
  VertexId vertex;
  RegionId region;
  auto operator<=>(const WireOutOfReach&) const = default;
};
/// Two wires meet in a vertex without faces and lie in different regions.
struct WiresInTwoRegions {
  VertexId vertex;
  EdgeId edge_a, edge_b;
  auto operator<=>(const WiresInTwoRegions&) const = default;
};

// --- space

/// Two items of one shell are not connected through vertices.
struct ShellDisconnected {
  ShellId shell;
  Item item_a, item_b;
  auto operator<=>(const ShellDisconnected&) const = default;
};
/// Two shells of one region meet in a vertex.
struct ShellsTouch {
  VertexId vertex;
  ShellId shell_a, shell_b;
  auto operator<=>(const ShellsTouch&) const = default;
};
/// The edges and faces at a vertex do not fit on a small sphere about it: about some edge they are in a wrong order.
struct FansNotPlanar {
  VertexId vertex;
  auto operator<=>(const FansNotPlanar&) const = default;
};
/// No way across faces leads to a region from the infinite one.
struct RegionUnreached {
  RegionId region;
  auto operator<=>(const RegionUnreached&) const = default;
};
/// Faces divide this side from the rest of its region.
struct RegionDivided {
  RegionId region;
  FaceUse side;
  auto operator<=>(const RegionDivided&) const = default;
};
/// A connected part of the complex has this shell in a region that it meets already in another place.
struct ShellApart {
  RegionId region;
  ShellId shell;
  auto operator<=>(const ShellApart&) const = default;
};

}  // namespace structure

/// Ordered by type, then evidence.
using StructuralFinding = std::variant<
    structure::FreeListBroken, structure::DeadRowNotFree, structure::FreeCountWrong, structure::DanglingLink,
    structure::EndCycleBroken, structure::EndInOtherCycle, structure::EndNotInCycle, structure::LoopCycleBroken,
    structure::CoedgeInOtherLoop, structure::CoedgeNotInLoop, structure::RadialCycleBroken,
    structure::CoedgeInOtherRadialCycle, structure::CoedgeNotInRadialCycle, structure::LoopChainBroken,
    structure::LoopInOtherFace, structure::LoopNotInFace, structure::SideChainBroken, structure::SideInOtherShell,
    structure::SideNotInShell, structure::WireChainBroken, structure::WireInOtherShell, structure::WireNotInShell,
    structure::ShellChainBroken, structure::ShellInOtherRegion, structure::ShellNotInRegion, structure::WireUseBroken,
    structure::PointUseChainBroken, structure::PointUseOfOtherLoop, structure::VertexLoopNotListed,
    structure::PointUseStray, structure::IsolationBroken, structure::LoopEmpty, structure::FaceWithoutLoop,
    structure::EdgeUnused, structure::VertexUnused, structure::IsolatedVertexUsed, structure::LoopOpen,
    structure::VertexTwiceInFace, structure::ShellEmpty, structure::ShellMixed, structure::InfiniteRegionMissing,
    structure::InfiniteRegionFilled, structure::RegionWithoutShell, structure::SectorInTwoRegions,
    structure::WireOutOfReach, structure::WiresInTwoRegions, structure::ShellDisconnected, structure::ShellsTouch,
    structure::FansNotPlanar, structure::RegionUnreached, structure::RegionDivided, structure::ShellApart>;

/// One sentence for a person.
std::string describe(const StructuralFinding& finding);

}  // namespace aresta
