// SPDX-License-Identifier: Apache-2.0
// Every operand in the boolean test data can be made and has its closed-form volume.
#include <filesystem>
#include <fstream>
#include <set>

#include "audit.h"
#include "model/measure.h"
#include "script_calls.h"
#include "support/paths.h"

namespace aresta {
namespace {

TEST(BooleanData, EveryOperandIsBuiltWithItsVolume) {
  const auto folder = test::data_file("boolean");
  if (!folder) GTEST_SKIP() << "the test data are not here";
  std::set<std::string> calls;
  for (const auto& file : std::filesystem::directory_iterator(*folder)) {
    if (file.path().extension() != ".ars") continue;
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("l") && line.find(" = ") != std::string::npos)
        calls.insert(line.substr(line.find(" = ") + 3));
    }
  }
  EXPECT_GT(calls.size(), 100u);
  for (const std::string& text : calls) {
    const Built built = ScriptCalls(text).call();
    ASSERT_TRUE(built.model.ok()) << text << ": " << built.model.error().to_line();
    const auto volume = total_volume(*built.model);
    ASSERT_TRUE(volume.ok()) << text << ": " << volume.error().to_line();
    EXPECT_NEAR(*volume / built.measure, 1, 1e-10) << text;
    EXPECT_TRUE(looks_outward(*built.model)) << text;
    EXPECT_LT(largest_gap(*built.model), 1e-9) << text;
  }
}

}  // namespace
}  // namespace aresta
