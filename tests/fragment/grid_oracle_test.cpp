// SPDX-License-Identifier: Apache-2.0
// The enumeration of the grid itself, on models whose counts one can see; and fragments against it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "fragment/oracle/contacts.h"
#include "fragment/oracle/operand_model.h"
#include "fragment/oracle/random_recipe.h"
#include "fragment/oracle/trial.h"
#include "model/check.h"
#include "support/paths.h"

namespace aresta::grid {
namespace {

Recipe recipe_of(const std::string& text) {
  auto recipe = parse_recipe(text);
  if (!recipe.ok()) throw std::runtime_error(recipe.error().to_line());
  return std::move(*recipe);
}

/// "a; b | c": operands of shapes.
Recipe operands(const std::string& line) {
  std::string text = "operand\n";
  for (const char c : line)
    text += c == ';' ? std::string("\n") : c == '|' ? std::string("\noperand\n") : std::string(1, c);
  return recipe_of(text);
}

/// vertices/edges/faces/cells, the outside among them/shells
std::string counts(const Enumeration& e) {
  std::size_t shells = 0;
  for (const auto& list : e.shells()) shells += list.size();
  std::string result;
  for (int d = 0; d < 4; ++d) result += std::to_string(e.whole.count(static_cast<EntityKind>(d))) + "/";
  return result + std::to_string(shells);
}

std::string text(const Verdict& verdict) {
  std::string result = verdict.refusal ? verdict.refusal->to_line() + "\n" : "";
  for (const std::string& line : verdict.differences) result += line + "\n";
  return result;
}

TEST(GridOracle, CountsThatOneCanSee) {
  struct Case {
    const char* what;
    const char* operands;
    const char* counts;
  };
  const Case cases[] = {
      {"two equal cubes", "solid 0 0 0  2 2 2 | solid 0 0 0  2 2 2", "8/12/6/2/2"},
      {"two cubes that share a face", "solid 0 0 0  2 2 2 | solid 2 0 0  4 2 2", "12/20/11/3/3"},
      {"half a face", "solid 0 0 0  2 2 2 | solid 2 1 0  4 3 2", "16/26/13/3/3"},
      {"an edge", "solid 0 0 0  2 2 2 | solid 2 2 0  4 4 2", "14/23/12/3/3"},
      {"a vertex", "solid 0 0 0  2 2 2 | solid 2 2 2  4 4 4", "15/24/12/3/3"},
      {"nothing", "solid 0 0 0  2 2 2 | solid 3 3 3  5 5 5", "16/24/12/3/4"},
      {"two that overlap in a corner", "solid 0 0 0  2 2 2 | solid 1 1 1  3 3 3", "22/36/18/4/4"},
      {"one in the other", "solid 0 0 0  6 6 6 | solid 2 2 2  4 4 4", "16/24/12/3/4"},
      {"edges that cross", "wire 0 1 1  2 1 1 | wire 1 0 1  1 2 1", "5/4/0/1/1"},
      {"edges that overlap", "wire 0 1 1  2 1 1 | wire 1 1 1  3 1 1", "4/3/0/1/1"},
      {"an edge through a cube", "solid 0 0 0  2 2 3 | wire 1 1 1  1 1 4", "11/14/6/2/2"},
      {"an edge in a face", "sheet 0 0 0  3 3 0 | wire 1 1 0  2 1 0", "6/5/1/1/1"},
      {"an edge across a face", "sheet 0 0 0  2 2 0 | wire 1 0 0  1 2 0", "6/7/2/1/1"},
      {"a point in an edge", "wire 0 0 0  2 0 0 | point 1 0 0", "3/2/0/1/1"},
      {"a point in a face", "sheet 0 0 0  2 2 0 | point 1 1 0", "5/4/1/1/1"},
      {"a point in a cube", "solid 0 0 0  2 2 2 | point 1 1 1", "9/12/6/2/3"},
      {"a sheet through a cube", "solid 1 1 1  3 3 3 | sheet 0 0 2  4 4 2", "16/24/12/3/3"},
      {"sheets that overlap in a corner", "sheet 0 0 0  2 2 0 | sheet 1 1 0  3 3 0", "10/12/3/1/1"},
      {"a sheet in a sheet", "sheet 0 0 0  6 6 0 | sheet 2 2 0  4 4 0", "8/8/2/1/1"},
      {"sheets that cross", "sheet 0 0 1  2 2 1 | sheet 0 1 0  2 1 2", "10/13/4/1/1"},
      {"three that cross", "sheet 1 0 0  1 2 2 | sheet 0 1 0  2 1 2 | sheet 0 0 1  2 2 1", "19/30/12/1/1"},
      {"sheets that close a volume", "shell 0 0 0  2 2 2 | point 4 4 4", "9/12/6/2/3"},
  };
  for (const Case& c : cases) {
    const Recipe recipe = operands(c.operands);
    const Enumeration e = enumerate(recipe);
    EXPECT_EQ(counts(e), c.counts) << c.what;
    EXPECT_EQ(text(try_recipe(recipe, {})), "") << c.what;
  }
}

TEST(GridOracle, ShapesOfOneOperand) {
  const std::pair<const char*, const char*> cases[] = {
      {"solid 0 0 0  2 2 2; solid 2 0 0  4 2 2", "12/20/11/3/3"},  // a wall between
      {"solid 0 0 0  2 2 2; joined 2 0 0  4 2 2", "8/12/6/2/2"},   // one box
      {"solid 0 0 0  2 2 2; joined 2 0 0  4 4 2", "12/18/8/2/2"},  // an L
      {"solid 0 0 0  6 6 6; hole 2 2 2  4 4 4", "16/24/12/3/4"},   // the void is a cell
      {"solid 0 0 0  6 6 6; hole 2 2 0  4 4 6", "16/24/10/2/2"},   // a tunnel: a face with a hole at each end
      {"sheet 0 0 0  2 2 0; sheet 2 0 0  4 2 0", "6/7/2/1/1"},     // two faces
      {"solid 0 0 0  2 2 2; sheet 0 0 2  1 1 2", "11/16/7/2/2"},   // a side in two
      {"wire 0 0 0  4 0 0; point 1 0 0", "3/2/0/1/1"},
  };
  for (const auto& [line, wanted] : cases) EXPECT_EQ(counts(enumerate(operands(line))), wanted) << line;
}

TEST(GridOracle, ParentsAndFills) {
  const Enumeration e = enumerate(operands("solid 0 0 0  2 2 2 | solid 1 0 0  3 2 2 | wire 1 1 1  3 1 1"));
  const auto parents = [&](const Steps& raw) { return e.parents(e.whole.carrier(e.whole.lattice().at(raw))); };
  const auto kinds = [&](const Steps& raw) {
    std::string result;
    for (const Parent& p : parents(raw)) result += std::to_string(p.source) + to_string(p.entity.kind)[0] + " ";
    return result;
  };
  EXPECT_EQ(kinds({2, 2, 2}), "0r ");
  EXPECT_EQ(kinds({4, 2, 2}), "0r 1r ");
  EXPECT_EQ(kinds({6, 2, 2}), "1r ");
  EXPECT_EQ(kinds({3, 2, 2}), "1f ");     // the side of the second in the first
  EXPECT_EQ(kinds({4, 2, 1}), "0f 1f ");  // where both lie on the ground
  EXPECT_EQ(kinds({3, 1, 1}), "0e 1v ");  // a corner of the second on an edge of the first
  EXPECT_EQ(kinds({3, 2, 1}), "0f 1e ");
  EXPECT_EQ(kinds({3, 3, 3}), "1f 2v ");
  EXPECT_EQ(kinds({4, 3, 3}), "2e ");
  EXPECT_EQ(kinds({5, 3, 3}), "0f 2e ");  // where the wire leaves the first

  const auto filled = [](const char* line) {
    std::string result;
    for (const bool f : enumerate(operands(line)).filled) result += f ? '1' : '0';
    return result;
  };
  EXPECT_EQ(filled("shell 0 0 0  2 2 2 | point 4 4 4"), "01");
  EXPECT_EQ(filled("solid 0 0 0  6 6 6; hole 1 1 1  5 5 5 | point 2 2 2"), "010");
  EXPECT_EQ(filled("solid 0 0 0  6 6 6; hole 1 1 1  5 5 5 | sheet 2 2 2  4 4 2"), "010");
  EXPECT_EQ(filled("solid 0 0 0  6 6 6; hole 1 1 1  5 5 5 | sheet 1 1 2  5 5 2"), "0111");
  EXPECT_EQ(filled("solid 0 0 0  6 6 6; hole 1 1 1  5 5 5 | solid 1 1 1  5 5 5"), "011");
}

TEST(GridOracle, Contacts) {
  const auto kinds = [](const char* line) {
    const Recipe recipe = operands(line);
    std::map<std::string, std::size_t> counts;
    count_contacts(recipe, enumerate(recipe), counts);
    for (const auto& [kind, count] : counts)
      EXPECT_NE(std::find(contact_kinds().begin(), contact_kinds().end(), kind), contact_kinds().end()) << kind;
    return counts;
  };
  auto found = kinds("solid 0 0 0  2 2 2 | solid 2 1 0  4 3 2");
  EXPECT_EQ(found["face/face in part"], 1u);
  EXPECT_EQ(found["edge/edge in part"], 2u);
  EXPECT_EQ(found["edge in face"], 2u);
  EXPECT_EQ(found["vertex in edge"], 4u);
  EXPECT_EQ(found["walls back to back"], 1u);
  found = kinds("solid 0 0 0  6 6 6 | solid 2 2 2  4 4 4");
  EXPECT_EQ(found["region/region part of the other"], 1u);
  EXPECT_EQ(found["cell with a nested void"], 1u);
  EXPECT_EQ(kinds("wire 0 1 1  2 1 1 | wire 1 0 1  1 2 1")["edge/edge crossing"], 1u);
  EXPECT_EQ(kinds("sheet 0 0 1  2 2 1 | wire 1 1 0  1 1 2")["edge pierces face"], 1u);
}

TEST(GridOracle, OperandsAreValid) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Recipe recipe = RandomRecipes(seed).next(seed % 2 == 0);
    for (const GridOperand& operand : enumerate(recipe).operands) {
      const auto model = to_model(operand, recipe.turn);
      ASSERT_TRUE(model.ok()) << model.error().to_line() << "\n" << recipe.text();
      const Status valid = require_valid(*model, CheckLevel::full);
      EXPECT_TRUE(valid.ok()) << valid.error().to_line() << "\n" << recipe.text();
    }
  }
}

TEST(GridOracle, RecipesAreReadBack) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Recipe recipe = RandomRecipes(seed).next(seed % 2 == 0);
    EXPECT_GE(recipe.shape_count(), 8u);
    EXPECT_EQ(recipe_of(recipe.text()).text(), recipe.text());
  }
  for (const char* bad : {"solid 0 0 0  1 1 1", "operand\n solid 0 0 0  1 1 0", "operand\n wire 0 0 0  0 0 9",
                          "operand\n wire 0 0 0  0 0", "operand\n cube 0 0 0  1 1 1", "turn 0 0 0 0", "steps 0",
                          "operand\n point 0 0 0  1"}) {
    EXPECT_FALSE(parse_recipe(bad).ok()) << bad;
  }
}

TEST(GridOracle, PlantedFaultsAreCaught) {
  const Recipe recipe = operands("solid 0 0 0  2 2 2 | solid 1 0 0  3 2 2 | sheet 0 0 1  4 2 1");
  ASSERT_EQ(text(try_recipe(recipe, {})), "");
  for (const Fault fault : {Fault::label, Fault::parent, Fault::sense, Fault::fill, Fault::piece}) {
    const Verdict verdict = try_recipe(recipe, {}, fault);
    EXPECT_TRUE(verdict.planted) << static_cast<int>(fault);
    EXPECT_EQ(verdict.differences.size(), 1u) << static_cast<int>(fault) << "\n" << text(verdict);
  }
}

TEST(GridOracle, AnotherModelIsNotTheSame) {
  const auto line = [](const std::string& last) { return "solid 0 0 0  2 2 2 | solid 1 0 0  3 2 2 | " + last; };
  const Enumeration wanted = enumerate(operands(line("wire 1 1 1  2 1 1")));
  for (const char* other : {"wire 1 1 1  3 1 1", "wire 1 1 1  1 1 2", "sheet 1 1 1  2 2 1", "point 1 1 1"}) {
    std::vector<std::shared_ptr<const Model>> models;
    for (const GridOperand& operand : enumerate(operands(line(other))).operands)
      models.push_back(std::make_shared<const Model>(*to_model(operand, {})));
    const auto found = fragment(models, {}, {});
    ASSERT_TRUE(found.ok()) << other;
    EXPECT_FALSE(compare(wanted, *found).empty()) << other;
  }
}

std::vector<std::filesystem::path> corpus(const std::string& folder) {
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / "tests/corpus" / folder)) {
    if (entry.path().extension() == ".txt") result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

Verdict try_file(const std::filesystem::path& path) {
  std::ostringstream recipe;
  recipe << std::ifstream(path).rdbuf();
  return try_recipe(recipe_of(recipe.str()), {});
}

TEST(GridOracle, WhatOnceFailed) {
  ASSERT_FALSE(corpus("fragment").empty());
  for (const auto& path : corpus("fragment")) EXPECT_EQ(text(try_file(path)), "") << path;
}

TEST(GridOracle, WhatTheGeneralFuseCannotDoIsNotTakenForDone) {
  ASSERT_FALSE(corpus("fragment/general_fuse").empty());
  for (const auto& path : corpus("fragment/general_fuse")) {
    const Verdict verdict = try_file(path);
    EXPECT_TRUE(verdict.agrees() || verdict.refusal || verdict.finding) << path << "\n" << text(verdict);
  }
}

}  // namespace
}  // namespace aresta::grid
