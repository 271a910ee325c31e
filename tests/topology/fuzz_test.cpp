// SPDX-License-Identifier: Apache-2.0
// Readers tried with the texts of the corpus and with mutations of them. tests/full/fuzz_topology.sh does so for
// longer.
#include <gtest/gtest.h>

#include "fuzz/mutations.h"

namespace aresta {
namespace {

TEST(Fuzz, CorpusHolds) {
  for (const test::Format& format : test::formats()) {
    for (const auto& text : test::corpus(format)) {
      EXPECT_EQ(format.check(text.text).wrong, "") << format.name << ", " << text.name;
    }
  }
}

void try_mutations(const test::Format& format, int cases) {
  const auto texts = test::corpus(format);
  test::Mutator mutator(20240229);
  int accepted = 0;
  for (int i = 0; i < cases; ++i) {
    const std::string text = mutator.mutate(texts);
    const test::Verdict verdict = format.check(text);
    accepted += verdict.accepted ? 1 : 0;
    ASSERT_EQ(verdict.wrong, "") << format.name << ", case " << i << ":\n" << text;
  }
  EXPECT_GT(accepted, cases / 100) << format.name;
  EXPECT_LT(accepted, cases / 2) << format.name;
}

TEST(Fuzz, MutatedDumps) {
  try_mutations(test::formats()[0], 20000);
}
TEST(Fuzz, MutatedJson) {
  try_mutations(test::formats()[1], 5000);
}
TEST(Fuzz, MutatedNotation) {
  try_mutations(test::formats()[2], 5000);
}

}  // namespace
}  // namespace aresta
