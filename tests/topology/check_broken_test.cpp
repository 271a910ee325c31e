// SPDX-License-Identifier: Apache-2.0
// For each type of finding the smallest models that break just that invariant.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>

#include "breaker.h"
#include "catalogue.h"
#include "sketch.h"
#include "topology/check.h"
#include "topology/editor.h"

namespace aresta {
namespace {

using namespace structure;
using Break = ComplexBreaker;
using Findings = std::vector<StructuralFinding>;

constexpr std::uint32_t none = Break::none, tag = Break::tag;

FaceUse side(std::size_t face, int which) {
  return FaceUse(FaceId(face), which);
}
EdgeEnd start_of(std::size_t edge) {
  return {EdgeId(edge), 0};
}
EdgeEnd end_of(std::size_t edge) {
  return {EdgeId(edge), 1};
}

struct BrokenModel {
  const char* what;
  const char* model;  ///< of the catalogue
  void (*spoil)(Complex&);
  Findings expected;
};

/// An edge of no use between two new vertices.
EdgeId add_bare_edge(Complex& k) {
  Editor edit(k);
  const EdgeId e = edit.make_edge();
  edit.attach({e, 0}, edit.make_vertex());
  edit.attach({e, 1}, edit.make_vertex());
  return e;
}

const BrokenModel rows[] = {
    {"the list of free rows begins at a row in use",
     "segment",
     [](Complex& k) { Break::free_rows(k, RowKind::edge).first = 0; },
     {FreeListBroken{{RowKind::edge, 0}}}},
    {"the list of free rows leads to no row",
     "segment",
     [](Complex& k) { Break::free_rows(k, RowKind::region).first = 9; },
     {FreeListBroken{{RowKind::region, 9}}}},
    {"the list of free rows runs in a circle",
     "nothing",
     [](Complex& k) {
       Editor edit(k);
       edit.free(edit.make_vertex());
       Break::vertex(k, 0).owner = 0;
     },
     {FreeListBroken{{RowKind::vertex, 0}}}},
    {"a free row is not listed",
     "nothing",
     [](Complex& k) {
       Editor edit(k);
       edit.free(edit.make_face(FaceId(1)));  // rows 1 and then 0 in the list
       Break::face(k, 1).shell[0] = none;
     },
     {DeadRowNotFree{{RowKind::face, 0}}}},
    {"free rows are counted wrong",
     "nothing",
     [](Complex& k) { Break::free_rows(k, RowKind::coedge).count = 3; },
     {FreeCountWrong{RowKind::coedge, 3, 0}}},
    {"an edge ends in no vertex",
     "segment",
     [](Complex& k) { Break::edge(k, 0).vertex[1] = 7; },
     {DanglingLink{{RowKind::edge, 0}, Link::vertex, 1, {RowKind::vertex, 7}}}},
    {"a side is in no shell",
     "triangle",
     [](Complex& k) { Break::face(k, 0).shell[1] = none; },
     {DanglingLink{{RowKind::face, 0}, Link::shell, 1, {RowKind::shell, none}}}},
    {"a coedge is of an edge that is not in use",
     "triangle",
     [](Complex& k) {
       Editor edit(k);
       const EdgeId gone = edit.make_edge();
       edit.free(gone);
       Break::coedge(k, 2).edge_sense = 2 * gone.value + 1;
     },
     {DanglingLink{{RowKind::coedge, 2}, Link::edge, 0, {RowKind::edge, 3}}}},
    {"a loop is no vertex",
     "square with point",
     [](Complex& k) { Break::loop(k, 1).first = tag | 5; },
     {DanglingLink{{RowKind::loop, 1}, Link::first, 0, {RowKind::vertex, 5}}}},
};

const BrokenModel lists[] = {
    {"two edge ends do not link back",
     "theta",
     [](Complex& k) { Break::edge(k, 1).prev[0] = 4; },
     {EndCycleBroken{VertexId(0), start_of(0)}}},
    {"an edge end says that it is at another vertex",
     "segment",
     [](Complex& k) { Break::edge(k, 0).vertex[1] = 0; },
     {EndInOtherCycle{VertexId(1), end_of(0)}}},
    {"a vertex has lost its edge ends",
     "theta",
     [](Complex& k) { Break::vertex(k, 1).first_end = none; },
     {EndNotInCycle{VertexId(1), end_of(0)}, EndNotInCycle{VertexId(1), end_of(1)},
      EndNotInCycle{VertexId(1), end_of(2)}}},
    {"two cycles at one vertex",
     "parallel edges",
     [](Complex& k) {
       for (std::size_t e = 0; e < 2; ++e) {
         const auto end = static_cast<std::uint32_t>(2 * e);
         Break::edge(k, e).next[0] = Break::edge(k, e).prev[0] = end;
       }
     },
     {EndNotInCycle{VertexId(0), start_of(1)}}},

    {"a coedge is not linked back",
     "triangle",
     [](Complex& k) { Break::coedge(k, 1).prev = 1; },
     {LoopCycleBroken{LoopId(0), CoedgeId(0)}}},
    {"a coedge names another loop",
     "square with hole",
     [](Complex& k) { Break::coedge(k, 1).loop = 1; },
     {CoedgeInOtherLoop{LoopId(0), CoedgeId(1)}}},
    {"a loop begins in another one",
     "square with loose strut",
     [](Complex& k) { Break::loop(k, 1).first = 0; },
     {CoedgeInOtherLoop{LoopId(1), CoedgeId(0)}}},
    {"a loop has become a vertex",
     "square with point",
     [](Complex& k) {
       Editor edit(k);
       edit.set_vertex_loop(LoopId(0), VertexId(4));
     },
     {CoedgeNotInLoop{LoopId(0), CoedgeId(0)}, CoedgeNotInLoop{LoopId(0), CoedgeId(1)},
      CoedgeNotInLoop{LoopId(0), CoedgeId(2)}, CoedgeNotInLoop{LoopId(0), CoedgeId(3)}}},

    {"a radial cycle does not come back",
     "book of three",
     [](Complex& k) { Break::coedge(k, k.radial(CoedgeId(0)).index()).radial = k.radial(CoedgeId(0)).value; },
     {RadialCycleBroken{EdgeId(0), CoedgeId(4)}}},
    {"a coedge names another edge",
     "two triangles facing",
     [](Complex& k) { Break::coedge(k, 3).edge_sense = 2 * 2; },
     {CoedgeInOtherRadialCycle{EdgeId(1), CoedgeId(3)}}},
    {"an edge has lost its first use",
     "triangle",
     [](Complex& k) { Break::edge(k, 1).first_use = none; },
     {CoedgeNotInRadialCycle{EdgeId(1), CoedgeId(1)}}},
    {"a coedge is about its edge alone",
     "two triangles",
     [](Complex& k) {
       Break::coedge(k, 1).radial = 1;
       Break::coedge(k, 3).radial = 3;
     },
     {CoedgeNotInRadialCycle{EdgeId(1), CoedgeId(3)}}},
    {"an edge of a face is a wire too",
     "triangle",
     [](Complex& k) { Editor(k).put(Item(EdgeId(0)), k.shell(side(0, 0))); },
     {CoedgeNotInRadialCycle{EdgeId(0), CoedgeId(0)}}},

    {"a loop is not linked back",
     "square with two holes",
     [](Complex& k) { Break::loop(k, 1).prev = 2; },
     {LoopChainBroken{FaceId(0), LoopId(0)}}},
    {"the first loop does not know the last one",
     "square with hole",
     [](Complex& k) { Break::loop(k, 0).prev = 0; },
     {LoopChainBroken{FaceId(0), LoopId(0)}}},
    {"a loop names another face",
     "two triangles",
     [](Complex& k) { Break::loop(k, 1).face = 0; },
     {LoopInOtherFace{FaceId(1), LoopId(1)}}},
    {"a face has lost its loops",
     "triangle",
     [](Complex& k) { Break::face(k, 0).first_loop = none; },
     {LoopNotInFace{FaceId(0), LoopId(0)}}},
    {"a loop is in no chain",
     "square with hole",
     [](Complex& k) {
       Break::loop(k, 0).next = none;
       Break::loop(k, 0).prev = 0;
       Break::loop(k, 1).prev = 1;
     },
     {LoopNotInFace{FaceId(0), LoopId(1)}}},

    {"a side is not linked back",
     "triangle",
     [](Complex& k) { Break::face(k, 0).prev_in_shell[1] = 1; },
     {SideChainBroken{ShellId(0), side(0, 0)}}},
    {"sides run in a circle",
     "triangle",
     [](Complex& k) { Break::face(k, 0).next_in_shell[1] = 0; },
     {SideChainBroken{ShellId(0), side(0, 0)}}},
    {"a side names another shell",
     "cube",
     [](Complex& k) { Break::face(k, 3).shell[0] = 1; },
     {SideInOtherShell{ShellId(0), side(3, 0)}}},
    {"a shell begins in another one",
     "sphere on vertex",
     [](Complex& k) { Break::shell(k, 1).first_face_use = 0; },
     {SideInOtherShell{ShellId(1), side(0, 0)}}},
    {"a shell has lost its sides",
     "sphere on vertex",
     [](Complex& k) { Break::shell(k, 1).first_face_use = none; },
     {SideNotInShell{ShellId(1), side(0, 1)}}},

    {"a wire is not linked back",
     "tree",
     [](Complex& k) { Break::wire(k, 3).prev = 3; },
     {WireChainBroken{ShellId(0), EdgeId(2)}}},
    {"a wire names another shell",
     "two segments",
     [](Complex& k) { Break::wire(k, 1).shell = 0; },
     {WireInOtherShell{ShellId(1), EdgeId(1)}}},
    {"a shell has lost its wires",
     "parallel edges",
     [](Complex& k) { Break::shell(k, 0).first_wire = none; },
     {WireNotInShell{ShellId(0), EdgeId(0)}, WireNotInShell{ShellId(0), EdgeId(1)}}},

    {"a shell is not linked back",
     "three points",
     [](Complex& k) { Break::shell(k, 2).prev = 0; },
     {ShellChainBroken{RegionId(0), ShellId(1)}}},
    {"a shell names another region",
     "cube",
     [](Complex& k) { Break::shell(k, 1).region = 0; },
     {ShellInOtherRegion{RegionId(1), ShellId(1)}}},
    {"a region has lost its shells",
     "cube",
     [](Complex& k) { Break::region(k, 1).first_shell = none; },
     {ShellNotInRegion{RegionId(1), ShellId(1)}}},

    {"two wires share a record",
     "two segments",
     [](Complex& k) { Break::edge(k, 1).first_use = tag | 0; },
     {WireUseBroken{EdgeId(1), 0}, WireUseBroken{EdgeId(1), 1}}},
    {"a record of a wire names an edge of a face",
     "square with wire",
     [](Complex& k) { Break::wire(k, 0).edge = 0; },
     {WireUseBroken{EdgeId(0), 0}, WireUseBroken{EdgeId(4), 0}}},

    {"the loops of a vertex run in a circle",
     "square with point",
     [](Complex& k) { Break::point_use(k, 0).next = 0; },
     {PointUseChainBroken{VertexId(4), LoopId(1)}}},
    {"a vertex lists a loop twice",
     "square with point",
     [](Complex& k) { Break::vertex(k, 4).owner = Break::add_point_use(k, 1, 0); },
     {PointUseChainBroken{VertexId(4), LoopId(1)}}},
    {"a vertex lists a loop that has coedges",
     "square with point",
     [](Complex& k) { Break::vertex(k, 0).owner = Break::add_point_use(k, 0, none); },
     {PointUseOfOtherLoop{VertexId(0), LoopId(0)}}},
    {"a vertex does not list its loop",
     "square with point",
     [](Complex& k) { Break::vertex(k, 4).owner = none; },
     {VertexLoopNotListed{VertexId(4), LoopId(1)}}},
    {"a record of a vertex loop is not listed",
     "square with point",
     [](Complex& k) { Break::add_point_use(k, 1, none); },
     {PointUseStray{1, LoopId(1)}}},
    {"a vertex is isolated in a shell of a face",
     "square with wire",
     [](Complex& k) { Break::vertex(k, 1).owner = tag | 0; },
     {IsolationBroken{VertexId(1), ShellId(0)}}},
    {"a shell claims a vertex",
     "square with wire",
     [](Complex& k) { Break::shell(k, 0).vertex = 1; },
     {IsolationBroken{VertexId(1), ShellId(0)}}},
};

const BrokenModel cells[] = {
    {"a loop is empty",
     "square with point",
     [](Complex& k) { Editor(k).unset_vertex_loop(LoopId(1)); },
     {LoopEmpty{LoopId(1)}, VertexUnused{VertexId(4)}}},
    {"a loop is added without coedges",
     "triangle",
     [](Complex& k) {
       Editor edit(k);
       edit.append_loop(FaceId(0), edit.make_loop());
     },
     {LoopEmpty{LoopId(1)}}},
    {"a face has no loop",
     "triangle",
     [](Complex& k) {
       Editor edit(k);
       const FaceId f = edit.make_face();
       for (int i = 0; i < 2; ++i) edit.put(FaceUse(f, i), ShellId(0));
     },
     {FaceWithoutLoop{FaceId(1)}}},
    {"an edge is of no use", "triangle", [](Complex& k) { add_bare_edge(k); }, {EdgeUnused{EdgeId(3)}}},
    {"a vertex is of no use", "triangle", [](Complex& k) { Editor(k).make_vertex(); }, {VertexUnused{VertexId(3)}}},
    {"an isolated vertex has an edge",
     "segment",
     [](Complex& k) {
       Editor edit(k);
       edit.put(Item(VertexId(1)), edit.make_shell(RegionId(0)));
     },
     {IsolatedVertexUsed{VertexId(1), EdgeId(0)}}},
    {"a coedge runs the wrong way",
     "triangle",
     [](Complex& k) { Break::coedge(k, 1).edge_sense ^= 1; },
     {LoopOpen{LoopId(0), CoedgeId(0), CoedgeId(1)}, LoopOpen{LoopId(0), CoedgeId(1), CoedgeId(2)}}},
    {"a vertex is two loops of a face",
     "square with two points",
     [](Complex& k) {
       Editor edit(k);
       edit.unset_vertex_loop(LoopId(2));
       edit.set_vertex_loop(LoopId(2), VertexId(4));
       edit.free(VertexId(5));
     },
     {VertexTwiceInFace{FaceId(0), VertexId(4), LoopId(1), LoopId(2)}}},
    {"a vertex on the boundary is a loop too",
     "square with point",
     [](Complex& k) {
       Editor edit(k);
       edit.unset_vertex_loop(LoopId(1));
       edit.set_vertex_loop(LoopId(1), VertexId(2));
       edit.free(VertexId(4));
     },
     {VertexTwiceInFace{FaceId(0), VertexId(2), LoopId(1), LoopId(0)}}},
    {"a shell holds nothing", "cube", [](Complex& k) { Editor(k).make_shell(RegionId(1)); }, {ShellEmpty{ShellId(2)}}},
    {"a shell holds a vertex and a wire",
     "segment",
     [](Complex& k) {
       Editor edit(k);
       edit.put(Item(edit.make_vertex()), ShellId(0));
     },
     {ShellMixed{ShellId(0), VertexId(2)}}},
    {"there is no infinite region",
     "nothing",
     [](Complex& k) { Editor(k).free(RegionId(0)); },
     {InfiniteRegionMissing{}}},
    {"the infinite region is filled",
     "cube",
     [](Complex& k) { Editor(k).set_filled(RegionId(0), true); },
     {InfiniteRegionFilled{}}},
    {"a region has no boundary",
     "cube",
     [](Complex& k) { Editor(k).make_region(true); },
     {RegionWithoutShell{RegionId(2)}}},
    {"a sector lies in two regions",
     "hemispheres",
     [](Complex& k) {  // both sides of one hemisphere outside
       Editor edit(k);
       edit.take(side(1, 1));
       edit.put(side(1, 1), k.shell(side(1, 0)));
     },
     {SectorInTwoRegions{EdgeId(0), side(1, 1), side(0, 1)}}},
    {"a wire inside is said to be in a far region",
     "cube with two voids",
     [](Complex& k) {
       Editor edit(k);
       const EdgeId e = edit.make_edge();
       edit.attach({e, 0}, VertexId(0));
       edit.attach({e, 1}, edit.make_vertex());
       edit.put(Item(e), edit.make_shell(RegionId(2)));
     },
     {WireOutOfReach{EdgeId(30), VertexId(0), RegionId(2)}}},
    {"two wires meet in different regions",
     "cube with points",
     [](Complex& k) {
       Editor edit(k);
       const VertexId v = edit.make_vertex();
       for (std::size_t r = 0; r < 2; ++r) {
         const EdgeId e = edit.make_edge();
         edit.attach({e, 0}, v);
         edit.attach({e, 1}, edit.make_vertex());
         edit.put(Item(e), edit.make_shell(RegionId(r)));
       }
     },
     {WiresInTwoRegions{VertexId(10), EdgeId(12), EdgeId(13)}}},
};

const BrokenModel shells[] = {
    {"two segments are one shell",
     "two segments",
     [](Complex& k) {
       Editor edit(k);
       edit.take(Item(EdgeId(1)));
       edit.free(ShellId(1));
       edit.put(Item(EdgeId(1)), ShellId(0));
     },
     {ShellDisconnected{ShellId(0), EdgeId(0), EdgeId(1)}}},
    {"two cubes are one shell",
     "two separate cubes",
     [](Complex& k) {
       Editor edit(k);
       const ShellId first = k.shell(side(0, 0)), second = k.shell(side(6, 0));
       for (std::size_t f = 6; f < 12; ++f) {
         edit.take(side(f, 0));
         edit.put(side(f, 0), first);
       }
       edit.free(second);
     },
     {ShellDisconnected{ShellId(0), side(0, 0), side(6, 0)}}},
    {"two parallel wires are two shells",
     "parallel edges",
     [](Complex& k) {
       Editor edit(k);
       edit.take(Item(EdgeId(1)));
       edit.put(Item(EdgeId(1)), edit.make_shell(RegionId(0)));
     },
     {ShellsTouch{VertexId(0), ShellId(0), ShellId(1)}, ShellsTouch{VertexId(1), ShellId(0), ShellId(1)}}},
};

std::string to_text(const Findings& findings) {
  std::string text;
  for (const auto& finding : findings) text += "  " + describe(finding) + "\n";
  return text.empty() ? "  nothing\n" : text;
}

void expect_findings(std::span<const BrokenModel> models) {
  for (const BrokenModel& broken : models) {
    Complex k = catalogue_model(broken.model);
    broken.spoil(k);
    Findings expected = broken.expected;
    std::sort(expected.begin(), expected.end());
    const Findings found = check_structure(k);
    EXPECT_TRUE(found == expected) << broken.what << " (" << broken.model << ")\nexpected:\n"
                                   << to_text(expected) << "found:\n"
                                   << to_text(found);
  }
}

struct BrokenSketch {
  const char* what;
  void (*sketch)(Sketch&);
  Findings expected;
};

const BrokenSketch sketches[] = {
    {"pages about an edge in an order in which others would have to cross",
     [](Sketch& s) {
       for (std::uint32_t i = 2; i < 6; ++i) s.add_polygon({0, 1, i}, {0, 0});
       s.add_polygon({0, 2, 4}, {0, 0});
       s.add_polygon({0, 3, 5}, {0, 0});
       s.order_about(s.edge(0, 1), {0, 1, 2, 3});
     },
     {FansNotPlanar{VertexId(0)}}},
    {"a region is nowhere", [](Sketch& s) { s.add_point(0, s.add_region()); }, {RegionUnreached{RegionId(1)}}},
    {"the sides of a closed shell lie in one region",
     [](Sketch& s) {
       add_polyhedron(s, tetrahedron(), {0, 0});
     },
     {RegionDivided{RegionId(0), side(0, 1)}}},
    {"two cubes have one inside",
     [](Sketch& s) {
       const auto inside = s.add_region();
       add_polyhedron(s, cube(), {0, inside});
       add_polyhedron(s, cube(), {0, inside}, 8);
     },
     {RegionDivided{RegionId(1), side(6, 1)}}},
    {"two tetrahedra touch, and one of them lies in a third one",
     [](Sketch& s) {
       const auto first = s.add_region(), around = s.add_region(), second = s.add_region();
       add_polyhedron(s, tetrahedron(), {0, first});
       add_polyhedron(s, tetrahedron(), {around, second}, 3);
       add_polyhedron(s, tetrahedron(), {0, around}, 7);
     },
     {ShellApart{RegionId(2), ShellId(5)}}},
};

TEST(CheckStructure, FindsBrokenRows) {
  expect_findings(rows);
}

TEST(CheckStructure, FindsBrokenLists) {
  expect_findings(lists);
}

TEST(CheckStructure, FindsBrokenCells) {
  expect_findings(cells);
}

TEST(CheckStructure, FindsBrokenShells) {
  expect_findings(shells);
}

TEST(CheckStructure, FindsWhatFitsInNoSpace) {
  for (const BrokenSketch& broken : sketches) {
    Sketch sketch;
    broken.sketch(sketch);
    const Findings found = check_structure(sketch.complex());
    EXPECT_TRUE(found == broken.expected) << broken.what << "\nfound:\n" << to_text(found);
  }
}

TEST(CheckStructure, HasABrokenModelForEachTypeOfFinding) {
  std::set<std::size_t> types;
  const auto add = [&](const auto& table) {
    for (const auto& broken : table) {
      for (const auto& finding : broken.expected) types.insert(finding.index());
    }
  };
  add(rows);
  add(lists);
  add(cells);
  add(shells);
  add(sketches);
  EXPECT_EQ(types.size(), std::variant_size_v<StructuralFinding>);
}

TEST(CheckStructure, FastLevelSeesNoShellsAndNoFans) {
  Sketch sketch;
  add_polyhedron(sketch, tetrahedron(), {0, 0});
  EXPECT_TRUE(check_structure(sketch.complex(), StructureLevel::fast).empty());
  EXPECT_FALSE(check_structure(sketch.complex(), StructureLevel::full).empty());
}

TEST(CheckStructure, SaysWhatIsWrongInASentence) {
  EXPECT_EQ(describe(RadialCycleBroken{EdgeId(3), CoedgeId(7)}), "The radial cycle of edge 3 is broken at coedge 7.");
  EXPECT_EQ(describe(EndInOtherCycle{VertexId(2), {EdgeId(4), 1}}),
            "The cycle of edge ends at vertex 2 holds the end of edge 4, which is at another vertex.");
  EXPECT_EQ(describe(SectorInTwoRegions{EdgeId(0), side(1, 0), side(2, 1)}),
            "The front of face 1 and the back of face 2 enclose a sector about edge 0 but lie in different regions.");
  EXPECT_EQ(describe(DanglingLink{{RowKind::face, 2}, Link::shell, 1, {RowKind::shell, none}}),
            "The link shell (second) of face 2 leads nowhere.");
}

}  // namespace
}  // namespace aresta
