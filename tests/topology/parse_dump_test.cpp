// SPDX-License-Identifier: Apache-2.0
#include "topology/parse_dump.h"

#include <gtest/gtest.h>

#include "topology/dump.h"
#include "topology/records.h"

namespace aresta {
namespace {

/// A digon and a wire with ids that have gaps.
const std::string gaps = R"(aresta complex 1
# regions 2, shells 3, faces 1, loops 2, edges 3, vertices 5
region r0: infinite
  shell +f4 -f4 e12
  shell v9
region r3: filled
  shell v7
face f4: front r0, back r0
  loop l2
    coedge c5: -e6, v3 to v1, radial c5
    coedge c8: +e10, v1 to v3, radial c8
  loop l7: v5
edge e6: v1 to v3, radial c5
edge e10: v1 to v3, radial c8
edge e12: v3 to v3, wire in r0
vertex v1: +e6 +e10
vertex v3: -e6 -e10 +e12 -e12
vertex v5: l7
vertex v7: in r3
vertex v9: in r0
)";

TEST(ParseDump, IsTheInverseOfDump) {
  const auto k = parse_dump(gaps);
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  EXPECT_EQ(dump(*k), gaps);
  EXPECT_EQ(k->vertex_bound(), 10u);
  EXPECT_FALSE(k->is_live(VertexId(8)));
  EXPECT_EQ(k->coedge_count(), 2u);
}

std::string changed(const std::string& old_text, const std::string& new_text) {
  std::string text = gaps;
  const auto at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return text.replace(at, old_text.size(), new_text);
}

TEST(ParseDump, TakesBlanksAndCommentsAsTheyCome) {
  const auto k = parse_dump("# text\n\n\r\n aresta\tcomplex 1 # one\nregion r0 :infinite");
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  EXPECT_EQ(dump(*k), dump(Complex()));
}

TEST(ParseDump, RefusesWithLineAndReason) {
  struct Case {
    const char *old_text, *new_text;
    ErrorCode code;
    const char* message;
  };
  using namespace errors;
  const Case cases[] = {
      {"aresta", "arista", bad_dump, "line 1: 'aresta' is expected, not 'arista'"},
      {"complex 1", "complex 2", dump_version, "line 1: version 1 is expected, not '2'"},
      {"infinite", "finite", bad_dump, "line 3: 'infinite', 'filled' or 'empty' is expected, not 'finite'"},
      {"l7: v5", "l7: v\x01", bad_dump, "line 12: a vertex, as in v5, is expected, not 'v\\x01'"},
      {"-e6, v3", "e6, v3", bad_dump, "line 10: an edge with its sense, as in +e7 or -e7, is expected, not 'e6'"},
      {"  shell v9", "  shell", bad_dump,
       "line 5: a side, a wire or a point, as in +f12, -f12, e7, v5, is expected, not the end of the line"},
      {"vertex v9: in r0\n", "vertex v9", bad_dump, "line 20: ':' is expected, not the end of the line"},
      {"loop l2\n", "loop l2\nedge", bad_dump, "line 10: 'coedge' is expected, not 'edge'"},
      {"region r3", "face r3", bad_dump, "line 6: a face, as in f12, is expected, not 'r3'"},

      {"vertex v9", "vertex v99999999999", record_ids,
       "line 20: v1073741823: for so few records ids must be below 1048816"},
      {"vertex v9", "vertex v7", record_ids, "line 20: v7 is there twice"},
      {"vertex v1:", "vertex v2:", record_ids, "line 13: e6 names v1, which is not there"},
      {"c8: +e10", "c8: +e11", record_ids, "line 11: c8 names e11, which is not there"},
      {"radial c8\nedge e12", "radial c9\nedge e12", record_ids, "line 14: e10 names c9, which is not there"},
      {"+f4 -f4", "+f4 -f5", record_ids, "line 4: a shell names f5, which is not there"},
      {"l7: v5", "l7: v6", record_ids, "line 12: l7 names v6, which is not there"},
      {"region r0: infinite\n  shell +f4 -f4 e12\n  shell v9\n", "", record_ids, "r0 is missing, the infinite region"},

      {"infinite", "filled", record_invariant, "line 3: r0 is the infinite region and cannot be filled"},
      {"c8: +e10", "c8: -e10", record_invariant, "line 10: l2 is open: c5 ends at v1, but c8 starts at v3"},
      {"radial c5\nedge e10", "radial c8\nedge e10", record_invariant,
       "line 13: c8 is listed at e6, but is a use of e10"},
      {"radial c5\nedge e10", "radial c5 c5\nedge e10", record_invariant, "line 13: c5 comes twice about e6"},
      {"radial c8\nedge e12", "wire in r0\nedge e12", record_invariant, "line 11: c8 is missing among the uses of e10"},
      {"e12\n", "e12 e6\n", record_invariant, "line 4: e6 is an edge of a face, no wire, and lies in no shell"},
      {"shell v9", "shell v5", record_invariant, "line 5: v5 is a vertex of an edge or a face and lies in no shell"},
      {"shell v7", "shell v9", record_invariant, "line 7: v9 is in shells twice"},
      {"-f4 e12", "-f4", record_invariant, "e12 lies in no shell"},
      {"+f4 -f4 e12", "+f4 e12", record_invariant, "-f4 lies in no shell"},
      {"  shell v7\n", "", record_invariant, "v7 lies in no shell"},
      {"e12\n  shell v9\n", "e12 v9\n", record_invariant,
       "line 4: +f4 and v9 are in one shell, but not connected in r0"},
      {"-f4 e12\n", "-f4\n  shell e12\n", record_invariant,
       "line 5: +f4 and e12 are connected in r0, but in two shells"},
      {"+f4 -f4 e12\n  shell v9\nregion r3: filled\n  shell v7\n",
       "+f4 e12\n  shell v9\nregion r3: filled\n  shell -f4\n  shell v7\n", record_invariant,
       "line 14: the sector from c5 to c5 about e6 is in two regions: -f4 in r3, +f4 in r0"},
      {"  shell v7\n", "region r5: filled\n  shell v7\n", record_invariant,
       "line 6: r3 has no shell, which only the infinite region may lack"},
      {"+f4 -f4 e12\n  shell v9\nregion r3: filled\n", "+f4 -f4\n  shell v9\nregion r3: filled\n  shell e12\n",
       record_invariant, "line 16: e12 is in r3, which no face has a side in at v3"},
      {"loop l7: v5", "loop l7: v3\n  loop l9: v5", record_invariant,
       "line 8: v3 is a loop of f4 and in another loop of it too"},

      {"r3: filled", "r3: infinite", dump_differs, "line 6: 'empty' is expected, not 'infinite'"},
      {"front r0", "front r3", dump_differs, "line 8: 'r0' is expected, not 'r3'"},
      {"v3 to v1, radial", "v1 to v1, radial", dump_differs, "line 10: 'v3' is expected, not 'v1'"},
      {"wire in r0", "wire in r3", dump_differs, "line 15: 'r0' is expected, not 'r3'"},
      {"-e6 -e10 +e12", "-e10 -e6 +e12", dump_differs, "line 17: '-e6' is expected, not '-e10'"},
      {"v9: in r0", "v9: in r3", dump_differs, "line 20: 'r0' is expected, not 'r3'"},
      {"vertex v9: in r0\n", "vertex v9:\n", dump_differs, "line 20: 'in' is expected, not the end of the line"},
      {"+f4 -f4 e12", "-f4 +f4 e12", dump_differs, "line 4: '+f4' is expected, not '-f4'"},
  };
  for (const Case& c : cases) {
    const auto k = parse_dump(changed(c.old_text, c.new_text));
    ASSERT_FALSE(k.ok()) << c.message;
    EXPECT_EQ(k.error().message, c.message);
    EXPECT_EQ(k.error().code, c.code) << c.message;
  }
}

TEST(ParseDump, RefusesWiresThatMeetInTwoRegions) {
  const auto k = parse_dump(R"(aresta complex 1
region r0: infinite
  shell e0
region r1: empty
  shell e1
edge e0: v0 to v1, wire in r0
edge e1: v1 to v2, wire in r1
vertex v0: +e0
vertex v1: -e0 +e1
vertex v2: -e1
)");
  ASSERT_FALSE(k.ok());
  EXPECT_EQ(k.error().message, "line 7: e1 is in r1, unlike another wire at v1");
  EXPECT_EQ(k.error().code, errors::record_invariant);
}

}  // namespace
}  // namespace aresta
