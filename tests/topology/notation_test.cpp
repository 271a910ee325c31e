// SPDX-License-Identifier: Apache-2.0
#include "topology/notation.h"

#include <gtest/gtest.h>

#include "small_models.h"
#include "topology/dump.h"

namespace aresta {
namespace {

/// Counts of regions, shells, faces, loops, coedges, edges, vertices.
std::string counts(const Complex& k) {
  std::string text;
  for (const std::size_t n : {k.region_count(), k.shell_count(), k.face_count(), k.loop_count(), k.coedge_count(),
                              k.edge_count(), k.vertex_count()}) {
    text += (text.empty() ? "" : " ") + std::to_string(n);
  }
  return text;
}

TEST(Notation, OfSmallModels) {
  for (const SmallModel& model : small_models()) {
    const auto k = parse_notation(model.text);
    ASSERT_TRUE(k.ok()) << model.name << ": " << k.error().to_line();
    EXPECT_EQ(counts(*k), model.counts) << model.name;
  }
}

TEST(Notation, GivesIdsInOrder) {
  const auto k = parse_notation(two_tetrahedra);
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  EXPECT_EQ(k->start(EdgeId(0)), VertexId(0));
  EXPECT_EQ(k->end(EdgeId(0)), VertexId(1));
  EXPECT_EQ(k->region(FaceUse(FaceId(0), 0)), RegionId(1));
  EXPECT_EQ(k->region(FaceUse(FaceId(0), 1)), RegionId(2));
  EXPECT_EQ(k->region(FaceUse(FaceId(1), 1)), RegionId(1));
  EXPECT_EQ(k->region(FaceUse(FaceId(4), 0)), RegionId(0));
  EXPECT_TRUE(k->is_filled(RegionId(2)));
  EXPECT_EQ(k->region(k->isolated_in_shell(VertexId(5))), RegionId(1));
  EXPECT_EQ(k->wire_shell(EdgeId(9)), k->shell(FaceUse(FaceId(1), 0)));
}

TEST(Notation, NumbersVerticesByNameOrByMention) {
  const auto named = parse_notation("wire b a"), numbered = parse_notation("wire 1 0"),
             mixed = parse_notation("wire 1 a");
  EXPECT_EQ(named->start(EdgeId(0)), VertexId(0));
  EXPECT_EQ(numbered->start(EdgeId(0)), VertexId(1));
  EXPECT_EQ(mixed->start(EdgeId(0)), VertexId(0));
}

TEST(Notation, OrdersUsesAboutAnEdge) {
  const char* const pages = "p: a b c\nq: a b d\nr: b a e\n";
  const auto along = parse_notation(pages + std::string("about a b: p r q"));
  const auto against = parse_notation(pages + std::string("about b a: p q r"));
  ASSERT_TRUE(along.ok());
  ASSERT_TRUE(against.ok());
  EXPECT_EQ(dump(*along), dump(*against));
  EXPECT_EQ(along->radial(CoedgeId(0)), CoedgeId(6));

  // A dangling edge in a face, with a sheet on it; and a strip that uses one edge three times.
  const auto sheet = parse_notation("f: a b c d c\ng: c d e\nabout c d: +f g -f");
  ASSERT_TRUE(sheet.ok()) << sheet.error().to_line();
  EXPECT_EQ(sheet->radial(CoedgeId(2)), CoedgeId(5));
  const auto strip = parse_notation("f: a b.1 a b.2 a b.3\nabout a b: +f.0 +f.2 +f.1");
  ASSERT_TRUE(strip.ok()) << strip.error().to_line();
  EXPECT_EQ(strip->radial(CoedgeId(0)), CoedgeId(4));
  // Against the edge the same uses are named with the other sign.
  const auto turned = parse_notation("f: a b.1 a b.2 a b.3\nabout b a: -f.0 -f.1 -f.2");
  ASSERT_TRUE(turned.ok()) << turned.error().to_line();
  EXPECT_EQ(dump(*strip), dump(*turned));
}

TEST(Notation, RefusesWithLineAndReason) {
  using namespace errors;
  struct Case {
    const char* text;
    ErrorCode code;
    const char* message;
  };
  const Case cases[] = {
      {"f 0 1 2", bad_notation, "line 1: ':' is expected, not '0'"},
      {"f:", bad_notation, "line 1: a vertex, as in 5, a, a.1 or a.1-, is expected, not the end of the line"},
      {"f: a b |", bad_notation, "line 1: a vertex, as in 5, a, a.1 or a.1-, is expected, not the end of the line"},
      {"f: a b!", bad_notation, "line 1: a vertex, as in 5, a, a.1 or a.1-, is expected, not 'b!'"},
      {"f: a b.", bad_notation, "line 1: a vertex, as in 5, a, a.1 or a.1-, is expected, not 'b.'"},
      {"\n\xff", bad_notation, "line 2: a face's name, 'wire', 'point', 'about' or 'region' is expected, not '\\xff'"},
      {"wire a", bad_notation, "line 1: another vertex is expected, not the end of the line"},
      {"wire a b in", bad_notation, "line 1: the name of a region is expected, not the end of the line"},
      {"wire a b in x y", bad_notation, "line 1: the end of the line is expected, not 'y'"},
      {"point +", bad_notation, "line 1: the name of a vertex is expected, not '+'"},
      {"region r full: -f", bad_notation, "line 1: 'filled' or 'empty' is expected, not 'full'"},
      {"region r filled: f", bad_notation, "line 1: a side of a face, as in +f or -f, is expected, not 'f'"},
      {"region r filled: -f.1", bad_notation, "line 1: a side of a face, as in +f or -f, is expected, not '-f.1'"},
      {"region r filled:", bad_notation,
       "line 1: a side of a face, as in +f or -f, is expected, not the end of the line"},
      {"about a b: f.1", bad_notation, "line 1: a face, as in f, +f, -f or +f.1, is expected, not 'f.1'"},

      {"f: a b c\nf: a b d", notation_model, "line 2: there is a face 'f' already"},
      {"f: a b-", notation_model, "line 1: 'b-': only a closed edge is run backwards by '-'"},
      {"f: 0 1 2\nwire 0 1", notation_model,
       "line 2: the edge from '0' is there already and can be no wire: give it another suffix"},
      {"wire 0 1 0", notation_model,
       "line 1: the edge from '1' is there already and can be no wire: give it another suffix"},
      {"wire a b.1", notation_model, "line 1: 'b.1': no edge leaves from a last vertex"},
      {"f: 0 1 2\npoint 2", notation_model, "line 2: the vertex '2' is used already and is not isolated"},
      {"point a a", notation_model, "line 1: the vertex 'a' is used already and is not isolated"},
      {"point a in r", notation_model, "line 1: there is no region 'r'"},
      {"f: a b c\ng: a b d\nh: a b e", notation_model,
       "line 1: the edge a b has 3 uses: a line 'about' has to say their order"},
      {"f: a b c\nabout a d: f", notation_model, "line 2: there is no edge from 'a' to 'd'"},
      {"f: a b c\nabout a.1 b: f", notation_model, "line 2: there is no edge from 'a.1' to 'b'"},
      {"f: a b c\nabout a b.1: f", notation_model, "line 2: an edge is named by a step and a vertex, as in a.1 b"},
      {"f: a b c\nabout a b: g", notation_model, "line 2: there is no face 'g'"},
      {"f: a b c\nabout a b: f f", notation_model, "line 2: 'f' comes twice about a b"},
      {"f: a b c\nabout a b: -f", notation_model, "line 2: '-f' means no use of a b"},
      {"f: a b c\ng: b a d\nabout a b: f", notation_model, "line 3: about a b there are 2 uses, not 1"},
      {"f: a b c\nabout a b: f\nabout b a: f", notation_model, "line 3: the uses of a b are ordered already"},
      {"f: a b c d c\nabout c d: f f", notation_model, "line 2: 'f' means several uses of c d"},
      {"f: a b\nregion r filled: -f\nregion r filled: +f", notation_model, "line 3: there is a region 'r' already"},
      {"region r filled: -f", notation_model, "line 1: there is no face '-f'"},
      {"f: a b c\nregion r filled: -f\nregion s filled: +f", notation_model,
       "line 3: '+f' is joined to sides of region 'r'"},
      {"f: a b c | a", notation_model, "Vertex 0 is loop 1 of face 0 and is in loop 0 of it too."},
      {"f: a b c\nregion r filled: -f\ng: d\nregion s filled: -g\nwire a d in s", notation_model,
       "Edge 3 lies in region 2, which no face at its vertex 0 touches."},
  };
  for (const Case& c : cases) {
    const auto k = parse_notation(c.text);
    ASSERT_FALSE(k.ok()) << c.message;
    EXPECT_EQ(k.error().message, c.message);
    EXPECT_EQ(k.error().code, c.code) << c.message;
  }
}

}  // namespace
}  // namespace aresta
