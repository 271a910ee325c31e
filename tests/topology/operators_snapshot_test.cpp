// SPDX-License-Identifier: Apache-2.0
// Operators on a complex of which a copy is kept, so that pages are shared: the same result, and the copy stays.
#include <gtest/gtest.h>

#include "topology/check.h"
#include "topology/dump.h"
#include "topology/notation.h"
#include "topology/operators.h"

namespace aresta {
namespace {

TEST(OperatorsSnapshot, ShellsAreJoinedBesideACopy) {
  auto read = parse_notation("f: 0 1 2\ng: 3 4 5\nwire 3 6 7");
  ASSERT_TRUE(read.ok()) << read.error().to_line();
  for (const auto& [kept, gone] : {std::pair{VertexId(0), VertexId(3)}, {VertexId(3), VertexId(0)}}) {
    Complex k = *read;
    const std::string before = dump(k);
    const Complex copy = k;
    auto applied = g_v(k, kept, gone);
    ASSERT_TRUE(applied.ok()) << applied.error().to_line();
    EXPECT_EQ(applied->sub_case, "gvksv");
    EXPECT_TRUE(check_structure(k).empty());
    EXPECT_EQ(dump(copy), before);
    const std::string after = dump(k);
    const Complex copy_after = k;
    take_back(k, *applied);
    EXPECT_EQ(dump(k), before);
    EXPECT_EQ(dump(copy_after), after);
  }
}

}  // namespace
}  // namespace aresta
