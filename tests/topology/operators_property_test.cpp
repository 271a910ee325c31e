// SPDX-License-Identifier: Apache-2.0
// Random operators from nothing: each leaves a valid complex or, when it refuses, the one it was given; taking all of
// them back gives the dumps seen on the way, byte for byte. From all models and in number: operators_acceptance.cpp.
#include <gtest/gtest.h>

#include "operators_run.h"
#include "topology/operators.h"

namespace aresta {
namespace {

TEST(OperatorsProperty, EachIsValidAndIsTakenBackToTheSameBytes) {
  OperatorsTally tally;
  for (std::uint64_t seed = 1; tally.applied < 2000 && tally.wrong.empty(); ++seed) {
    run_random_operators(m_mr(), "nothing", seed, 100, tally);
  }
  EXPECT_TRUE(tally.wrong.empty()) << tally.wrong.front();
}

}  // namespace
}  // namespace aresta
