// SPDX-License-Identifier: Apache-2.0
#include "topology/dump_json.h"

#include <gtest/gtest.h>

#include "small_models.h"
#include "topology/dump.h"
#include "topology/notation.h"
#include "topology/records.h"

namespace aresta {
namespace {

const std::string triangle = R"({"format": "aresta complex", "version": 1,
"regions": [
{"id":0,"kind":"infinite","shells":[{"front":[0],"back":[0],"wires":[3]},{"vertex":5}]}],
"faces": [
{"id":0,"front":0,"back":0,"loops":[{"id":0,"coedges":[{"id":0,"edge":0,"reversed":false,"start":0,"end":1,"radial":0},{"id":1,"edge":1,"reversed":false,"start":1,"end":2,"radial":1},{"id":2,"edge":2,"reversed":false,"start":2,"end":0,"radial":2}]},{"id":1,"vertex":3}]}],
"edges": [
{"id":0,"start":0,"end":1,"coedges":[0]},
{"id":1,"start":1,"end":2,"coedges":[1]},
{"id":2,"start":2,"end":0,"coedges":[2]},
{"id":3,"start":0,"end":4,"wire_in":0}],
"vertices": [
{"id":0,"starting":[0,3],"ending":[2],"loops":[]},
{"id":1,"starting":[1],"ending":[0],"loops":[]},
{"id":2,"starting":[2],"ending":[1],"loops":[]},
{"id":3,"starting":[],"ending":[],"loops":[1]},
{"id":4,"starting":[],"ending":[3],"loops":[]},
{"id":5,"isolated_in":0}]}
)";

TEST(DumpJson, SaysAll) {
  const auto k = parse_notation("f: 0 1 2 | 3\nwire 0 4\npoint 5");
  ASSERT_TRUE(k.ok());
  EXPECT_EQ(dump_json(*k), triangle);
}

TEST(DumpJson, IsReadBackExactly) {
  for (const SmallModel& model : small_models()) {
    const auto k = parse_notation(model.text);
    ASSERT_TRUE(k.ok()) << model.name;
    const auto again = parse_json(dump_json(*k));
    ASSERT_TRUE(again.ok()) << model.name << ": " << again.error().to_line();
    EXPECT_EQ(dump(*again), dump(*k)) << model.name;
    EXPECT_EQ(dump_json(*again), dump_json(*k)) << model.name;
  }
}

TEST(DumpJson, TakesMembersInAnyOrder) {
  const auto k = parse_json(R"({"vertices": [{"isolated_in": 0, "id": 7}], "version": 1, "faces": [], "edges": [],
      "format": "aresta complex", "regions": [{"shells": [{"vertex": 7}], "kind": "infinite", "id": 0}]})");
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  EXPECT_EQ(k->vertex_bound(), 8u);
}

TEST(DumpJson, RefusesWithPlaceAndReason) {
  using namespace errors;
  struct Case {
    const char *old_text, *new_text;
    ErrorCode code;
    const char* message;
  };
  const Case cases[] = {
      {"\"isolated_in\":0}]}", "\"isolated_in\":0}]", bad_dump, "line 18: this is no JSON"},
      {"\"shells\":[{", "\"shells\":[,{", bad_dump, "line 3: this is no JSON"},
      {"\"version\": 1", "\"version\": 1e999", bad_dump, "a number is too large"},
      {"\"version\": 1", "\"version\": 1, \"x\": [[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]", bad_dump,
       "brackets are nested too deep"},
      {"aresta complex", "other", bad_dump, "/format: \"aresta complex\" is expected"},
      {"\"version\": 1", "\"version\": 2", dump_version, "/version: 1 is expected"},
      {"\"version\": 1,", "", bad_dump, "/: an object with \"version\" is expected"},
      {"infinite", "finite", bad_dump, "/regions/0/kind: \"infinite\", \"filled\" or \"empty\" is expected"},
      {"\"front\":[0],", "", bad_dump, "/regions/0/shells/0: an object with \"front\" is expected"},
      {"\"front\":[0]", "\"front\":0", bad_dump, "/regions/0/shells/0/front: a list is expected"},
      {"\"wires\":[3]", "\"wires\":[-3]", bad_dump, "/regions/0/shells/0/wires/0: an id is expected"},
      {"\"loops\":[{\"id\":0", "\"loops\":[{\"id\":0.5", bad_dump, "/faces/0/loops/0/id: an id is expected"},
      {"false", "0", bad_dump, "/faces/0/loops/0/coedges/0/reversed: true or false is expected"},
      {"\"coedges\":[0]", "\"coedges\":[0,false]", bad_dump, "/edges/0/coedges/1: an id is expected"},
      {"{\"id\":1,\"s", "{\"id\":2,\"s", record_ids, "e2 is there twice"},
      {"\"id\":5", "\"id\":99999999999999", record_ids, "v1073741823: for so few records ids must be below 1048848"},
      {"false", "true", record_invariant, "l0 is open: c0 ends at v0, but c1 starts at v1"},
      {"\"front\":0", "\"front\":1", dump_differs, "/faces/0/front: not as the rest asks for"},
      {"\"radial\":0", "\"radial\":1", dump_differs, "/faces/0/loops/0/coedges/0/radial: not as the rest asks for"},
      {"[0,3]", "[3,0]", dump_differs, "/vertices/0/starting/0: not as the rest asks for"},
      {"[0,3]", "[0]", dump_differs, "/vertices/0/starting/1: not as the rest asks for"},
      {"\"isolated_in\":0", "\"isolated_in\":0.0", dump_differs, "/vertices/5/isolated_in: not as the rest asks for"},
      {"\"version\": 1", "\"version\": 1, \"x\": 1", dump_differs, "/x: not as the rest asks for"},
      {"\"isolated_in\":0", "\"isolated_in\":0,\"x\":[]", dump_differs, "/vertices/5/x: not as the rest asks for"},
  };
  for (const Case& c : cases) {
    std::string text = triangle;
    const auto at = text.find(c.old_text);
    ASSERT_NE(at, std::string::npos) << c.old_text;
    const auto k = parse_json(text.replace(at, std::string(c.old_text).size(), c.new_text));
    ASSERT_FALSE(k.ok()) << c.message;
    EXPECT_EQ(k.error().message, c.message);
    EXPECT_EQ(k.error().code, c.code) << c.message;
  }
}

}  // namespace
}  // namespace aresta
