// SPDX-License-Identifier: Apache-2.0
// docs/operators.md says what operator_cases.h says, and each of its rows has a test. (That the test reaches its
// sub-case is asserted by the test itself.)
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "operator_cases.h"
#include "support/paths.h"

namespace aresta {
namespace {

TEST(OperatorsPage, EachRowHasATestAndEachTestARow) {
  std::set<std::string> tests, rows;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    if (std::string(suite.name()) != "Operators") continue;
    for (int j = 0; j < suite.total_test_count(); ++j) tests.insert(suite.GetTestInfo(j)->name());
  }
  for (const OperatorCase& row : operator_cases()) EXPECT_TRUE(rows.insert(row.test()).second) << row.test();
  EXPECT_EQ(tests, rows);
}

TEST(OperatorsPage, EachOperatorHasItsTextAndRows) {
  std::set<std::string> texts, rows;
  for (const OperatorText& text : operator_texts()) EXPECT_TRUE(texts.insert(text.name).second) << text.name;
  for (const OperatorCase& row : operator_cases()) rows.insert(row.name);
  EXPECT_EQ(texts, rows);
}

TEST(OperatorsPage, InversesAreRows) {
  std::set<std::string> rows{"take_back"};
  for (const OperatorCase& row : operator_cases()) rows.insert(std::string(row.name) + " " + row.sub_case);
  for (const OperatorCase& row : operator_cases()) EXPECT_TRUE(rows.contains(row.inverse)) << row.inverse;
}

/// Every letter that a sub-case names is a count that changed, in the direction that the name says. (In the names of
/// M_MR and K_M "m" is the model.)
TEST(OperatorsPage, SubCasesSayTheChanges) {
  for (const OperatorCase& row : operator_cases()) {
    const CountChange& d = row.change;
    const std::pair<char, int> counts[] = {{'v', d.vertices}, {'e', d.edges},  {'f', d.faces},
                                           {'l', d.loops},    {'s', d.shells}, {'r', d.regions}};
    std::string name = row.sub_case;
    if (name == "mmr" || name == "kmr") name.erase(1, 1);
    if (name[0] == 'g') name = name.substr(2);
    for (const auto& [letter, change] : counts) {
      int direction = 0, said = 0;
      for (const char c : name) {
        if (c == 'm') direction = 1;
        if (c == 'k') direction = -1;
        if (c == letter) said = direction;
      }
      EXPECT_EQ(said, (change > 0) - (change < 0)) << row.test() << ": " << letter;
    }
  }
}

TEST(OperatorsPage, IsUpToDate) {
  const std::filesystem::path path = test::source_folder() / "docs/operators.md";
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text == operators_page()) return;
  const std::filesystem::path made = test::output_folder("operators_page") / "operators.md";
  std::ofstream(made) << operators_page();
  ADD_FAILURE() << "to renew the page: cp " << made.string() << " " << path.string();
}

}  // namespace
}  // namespace aresta
