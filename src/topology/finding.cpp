// SPDX-License-Identifier: Apache-2.0
#include "topology/finding.h"

namespace aresta {

const char* to_string(RowKind kind) {
  constexpr const char* names[] = {"vertex", "edge", "wire", "coedge", "point use", "loop", "face", "shell", "region"};
  return names[static_cast<int>(kind)];
}

const char* to_string(Link link) {
  constexpr const char* names[] = {"first_end", "owner",          "vertex",     "next",          "prev",
                                   "first_use", "edge",           "shell",      "radial",        "loop",
                                   "first",     "face",           "first_loop", "next_in_shell", "prev_in_shell",
                                   "region",    "first_face_use", "first_wire", "first_shell"};
  return names[static_cast<int>(link)];
}

namespace {

using namespace structure;

std::string text(const char* words) {
  return words;
}
std::string text(Row row) {
  return text(to_string(row.kind)) + " " + std::to_string(row.index);
}
std::string text(VertexId v) {
  return text(Row{RowKind::vertex, v.value});
}
std::string text(EdgeId e) {
  return text(Row{RowKind::edge, e.value});
}
std::string text(CoedgeId c) {
  return text(Row{RowKind::coedge, c.value});
}
std::string text(LoopId l) {
  return text(Row{RowKind::loop, l.value});
}
std::string text(FaceId f) {
  return text(Row{RowKind::face, f.value});
}
std::string text(ShellId s) {
  return text(Row{RowKind::shell, s.value});
}
std::string text(RegionId r) {
  return text(Row{RowKind::region, r.value});
}
std::string text(EdgeEnd end) {
  return text(end.end == 0 ? "the start of " : "the end of ") + text(end.edge);
}
std::string text(FaceUse u) {
  return text(u.side() == 0 ? "the front of " : "the back of ") + text(u.face());
}
std::string text(Item item) {
  switch (item.kind) {
    case Item::Kind::side:
      return text(item.side());
    case Item::Kind::wire:
      return text(item.wire());
    case Item::Kind::point:
      return text(item.point());
  }
  return {};
}

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::string result = (text(parts) + ...);
  if (result.front() >= 'a' && result.front() <= 'z') result.front() = static_cast<char>(result.front() - 'a' + 'A');
  return result + ".";
}

struct Describe {
  std::string operator()(const FreeListBroken& x) const {
    return sentence("the list of free rows comes to ", x.row, ", which is in use, does not exist or was there before");
  }
  std::string operator()(const DeadRowNotFree& x) const {
    return sentence(x.row, " is not in use, and not in the list of free rows");
  }
  std::string operator()(const FreeCountWrong& x) const {
    return "Free rows of kind " + text(to_string(x.kind)) + ": " + std::to_string(x.stated) + " are stated, " +
           std::to_string(x.counted) + " are there.";
  }
  std::string operator()(const DanglingLink& x) const {
    const std::string slot = x.slot == 1 ? " (second)" : "";
    const std::string link = "link " + text(to_string(x.link)) + slot + " of " + text(x.from);
    if (x.to.index == Id<void>::none) return "The " + link + " leads nowhere.";
    return "The " + link + " leads to " + text(x.to) + ", which is not in use.";
  }

  std::string operator()(const EndCycleBroken& x) const {
    return sentence("the cycle of edge ends at ", x.vertex, " is broken at ", x.end);
  }
  std::string operator()(const EndInOtherCycle& x) const {
    return sentence("the cycle of edge ends at ", x.vertex, " holds ", x.end, ", which is at another vertex");
  }
  std::string operator()(const EndNotInCycle& x) const {
    return sentence(x.end, " is not in the cycle of edge ends at its ", x.vertex);
  }
  std::string operator()(const LoopCycleBroken& x) const {
    return sentence("the cycle of ", x.loop, " is broken at ", x.coedge);
  }
  std::string operator()(const CoedgeInOtherLoop& x) const {
    return sentence("the cycle of ", x.loop, " holds ", x.coedge, ", which names another loop");
  }
  std::string operator()(const CoedgeNotInLoop& x) const {
    return sentence(x.coedge, " is not in the cycle of its ", x.loop);
  }
  std::string operator()(const RadialCycleBroken& x) const {
    return sentence("the radial cycle of ", x.edge, " is broken at ", x.coedge);
  }
  std::string operator()(const CoedgeInOtherRadialCycle& x) const {
    return sentence("the radial cycle of ", x.edge, " holds ", x.coedge, ", which names another edge");
  }
  std::string operator()(const CoedgeNotInRadialCycle& x) const {
    return sentence(x.coedge, " is not in the radial cycle of its ", x.edge);
  }
  std::string operator()(const LoopChainBroken& x) const {
    return sentence("the list of loops of ", x.face, " is broken at ", x.loop);
  }
  std::string operator()(const LoopInOtherFace& x) const {
    return sentence("the list of loops of ", x.face, " holds ", x.loop, ", which names another face");
  }
  std::string operator()(const LoopNotInFace& x) const {
    return sentence(x.loop, " is not in the list of its ", x.face);
  }
  std::string operator()(const SideChainBroken& x) const {
    return sentence("the list of sides of ", x.shell, " is broken at ", x.side);
  }
  std::string operator()(const SideInOtherShell& x) const {
    return sentence("the list of sides of ", x.shell, " holds ", x.side, ", which names another shell");
  }
  std::string operator()(const SideNotInShell& x) const {
    return sentence(x.side, " is not in the list of its ", x.shell);
  }
  std::string operator()(const WireChainBroken& x) const {
    return sentence("the list of wires of ", x.shell, " is broken at ", x.edge);
  }
  std::string operator()(const WireInOtherShell& x) const {
    return sentence("the list of wires of ", x.shell, " holds ", x.edge, ", which names another shell");
  }
  std::string operator()(const WireNotInShell& x) const {
    return sentence(x.edge, " is not in the list of wires of its ", x.shell);
  }
  std::string operator()(const ShellChainBroken& x) const {
    return sentence("the list of shells of ", x.region, " is broken at ", x.shell);
  }
  std::string operator()(const ShellInOtherRegion& x) const {
    return sentence("the list of shells of ", x.region, " holds ", x.shell, ", which names another region");
  }
  std::string operator()(const ShellNotInRegion& x) const {
    return sentence(x.shell, " is not in the list of its ", x.region);
  }
  std::string operator()(const WireUseBroken& x) const {
    return sentence(x.edge, " and ", Row{RowKind::wire, x.wire}, " do not name each other");
  }
  std::string operator()(const PointUseChainBroken& x) const {
    return sentence("the list of loops that are ", x.vertex, " comes to ", x.loop, " twice");
  }
  std::string operator()(const PointUseOfOtherLoop& x) const {
    return sentence("the list of loops that are ", x.vertex, " holds ", x.loop, ", which is not");
  }
  std::string operator()(const VertexLoopNotListed& x) const {
    return sentence(x.loop, " is not in the list of loops that are its ", x.vertex);
  }
  std::string operator()(const PointUseStray& x) const {
    return sentence(Row{RowKind::point_use, x.use}, " of ", x.loop, " is in no vertex's list");
  }
  std::string operator()(const IsolationBroken& x) const {
    return sentence("isolated ", x.vertex, " and ", x.shell, " do not name each other");
  }

  std::string operator()(const LoopEmpty& x) const { return sentence(x.loop, " has neither coedges nor a vertex"); }
  std::string operator()(const FaceWithoutLoop& x) const { return sentence(x.face, " has no loop"); }
  std::string operator()(const EdgeUnused& x) const { return sentence(x.edge, " is used by no face and is no wire"); }
  std::string operator()(const VertexUnused& x) const {
    return sentence(x.vertex, " has no edge, is no loop and is not isolated in a region");
  }
  std::string operator()(const IsolatedVertexUsed& x) const {
    return sentence(x.vertex, " is said to be isolated, but has ", x.edge);
  }
  std::string operator()(const LoopOpen& x) const {
    return sentence(x.loop, " is open: ", x.next, " does not start where ", x.coedge, " ends");
  }
  std::string operator()(const VertexTwiceInFace& x) const {
    return sentence(x.vertex, " is ", x.loop, " of ", x.face, " and is in ", x.other, " of it too");
  }
  std::string operator()(const ShellEmpty& x) const { return sentence(x.shell, " holds nothing"); }
  std::string operator()(const ShellMixed& x) const {
    return sentence(x.shell, " of isolated ", x.vertex, " holds something else too");
  }
  std::string operator()(const InfiniteRegionMissing&) const { return sentence("there is no infinite region"); }
  std::string operator()(const InfiniteRegionFilled&) const { return sentence("the infinite region is filled"); }
  std::string operator()(const RegionWithoutShell& x) const { return sentence(x.region, " is bounded by nothing"); }
  std::string operator()(const SectorInTwoRegions& x) const {
    return sentence(x.side_a, " and ", x.side_b, " enclose a sector about ", x.edge, " but lie in different regions");
  }
  std::string operator()(const WireOutOfReach& x) const {
    return sentence(x.edge, " lies in ", x.region, ", which no face at its ", x.vertex, " touches");
  }
  std::string operator()(const WiresInTwoRegions& x) const {
    return sentence(x.edge_a, " and ", x.edge_b, " meet in ", x.vertex, " but lie in different regions");
  }

  std::string operator()(const ShellDisconnected& x) const {
    return sentence(x.item_a, " and ", x.item_b, " are in ", x.shell, " but are not connected in it");
  }
  std::string operator()(const ShellsTouch& x) const {
    return sentence(x.shell_a, " and ", x.shell_b, " of one region meet in ", x.vertex);
  }
  std::string operator()(const FansNotPlanar& x) const {
    return sentence("the edges and faces at ", x.vertex,
                    " do not fit on a sphere about it: some radial order is wrong");
  }
  std::string operator()(const RegionUnreached& x) const {
    return sentence("no way across faces leads from the infinite region to ", x.region);
  }
  std::string operator()(const RegionDivided& x) const {
    return sentence("faces divide ", x.side, " from the rest of its ", x.region);
  }
  std::string operator()(const ShellApart& x) const {
    return sentence(x.shell, " is of a connected part that lies in ", x.region, " in another way already");
  }
};

}  // namespace

std::string describe(const StructuralFinding& finding) {
  return std::visit(Describe{}, finding);
}

}  // namespace aresta
