// SPDX-License-Identifier: Apache-2.0
#include "base/result.h"

#include <gtest/gtest.h>

#include "base/context.h"
#include "base/module.h"
#include "base/pages.h"
#include "base/union_find.h"

namespace aresta {
namespace {

Result<int> half(int n) {
  if (n % 2 != 0) return Error{errors::invalid_argument, "odd number"};
  return n / 2;
}

Result<int> quarter(int n) {
  ARESTA_TRY(int h, half(n));
  return half(h);
}

TEST(Result, PropagatesValueAndError) {
  EXPECT_EQ(*quarter(12), 3);
  ASSERT_FALSE(quarter(6).ok());
  EXPECT_EQ(quarter(6).error().code, errors::invalid_argument);
}

TEST(Result, ErrorLineNamesEntitiesAndPlace) {
  const Error error{errors::invalid_argument, "bad", {FaceId(7), EdgeId(12)}, {{1, 2, 3}}, "less"};
  EXPECT_EQ(error.to_line(), "argument.invalid: bad (face 7, edge 12; at 1 2 3); try: less");
}

TEST(Context, StepAnswersCancellation) {
  std::atomic<bool> stop = false;
  Context context;
  context.cancel = &stop;
  EXPECT_TRUE(context.step(0.5, "work").ok());
  stop = true;
  ASSERT_FALSE(context.step(0.6, "work").ok());
  EXPECT_EQ(context.step(0.6, "work").error().code, errors::cancelled);
}

TEST(Pages, SnapshotSharesUntouchedPages) {
  Pages<int, 4> now;
  for (int i = 0; i < 100; ++i) now.push_back(i);
  const Pages<int, 4> before = now;
  EXPECT_EQ(now.pages_not_shared_with(before), 0u);
  now.edit(50) = -1;
  EXPECT_EQ(now.pages_not_shared_with(before), 1u);
  EXPECT_EQ(before[50], 50);
  EXPECT_EQ(now[50], -1);
  now.push_back(7);
  EXPECT_EQ(before.size(), 100u);
  EXPECT_EQ(now[100], 7);
}

TEST(Pages, TwoCopiesWriteApart) {
  Pages<int, 2> a;
  a.resize(9, 1);
  Pages<int, 2> b = a, c = a;
  b.edit(0) = 2;
  c.edit(0) = 3;
  EXPECT_EQ(a[0], 1);
  EXPECT_EQ(b[0], 2);
  EXPECT_EQ(c[0], 3);
}

TEST(UnionFind, RepresentativeIsSmallest) {
  UnionFind sets(5);
  EXPECT_TRUE(sets.unite(4, 2));
  EXPECT_TRUE(sets.unite(2, 3));
  EXPECT_FALSE(sets.unite(3, 4));
  EXPECT_EQ(sets.find(4), 2u);
}

TEST(Module, MissingOneIsAnError) {
  const auto function = module_function("nowhere", "nothing");
  ASSERT_FALSE(function.ok());
  EXPECT_EQ(function.error().code, errors::module_missing);
}

}  // namespace
}  // namespace aresta
