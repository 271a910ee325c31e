// SPDX-License-Identifier: Apache-2.0
// Scripts of operators, right and wrong: those that once failed, and random ones. tests/full/fuzz_topology.sh tries
// more.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "fuzz/script_properties.h"
#include "fuzz/script_writer.h"
#include "support/paths.h"

namespace aresta {
namespace {

TEST(OperatorScripts, CorpusHolds) {
  std::size_t count = 0;
  for (const auto& file : std::filesystem::directory_iterator(test::source_folder() / "tests/corpus/topology/script")) {
    std::ostringstream text;
    text << std::ifstream(file.path()).rdbuf();
    EXPECT_EQ(test::check_script(text.str()).wrong, "") << file.path();
    ++count;
  }
  EXPECT_GT(count, 0u);
}

/// Most lines must be carried out, and many refused.
TEST(OperatorScripts, RandomOnesHold) {
  std::mt19937_64 random(20240229);
  std::size_t accepted = 0, refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string bytes(random() % 600, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    test::ScriptRun run;
    test::ScriptWriter writer(bytes);
    std::string text;
    while (!writer.at_end()) {
      text += writer.line(run.complex()) + "\n";
      run.run(text.substr(text.rfind('\n', text.size() - 2) + 1));
    }
    run.finish();
    ASSERT_EQ(run.wrong(), "") << text;
    accepted += run.accepted();
    refused += run.refused();
  }
  EXPECT_GT(accepted, refused);
  EXPECT_GT(refused, accepted / 10);
}

}  // namespace
}  // namespace aresta
