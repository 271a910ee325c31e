// SPDX-License-Identifier: Apache-2.0
#include "base/pages.h"

#include <gtest/gtest.h>

namespace aresta {
namespace {

using Numbers = Pages<int, 2>;  // four to a page

std::vector<int> items(const Numbers& pages) {
  std::vector<int> result;
  for (std::size_t i = 0; i < pages.size(); ++i) result.push_back(pages[i]);
  return result;
}

/// Every way to a size is the same as for a vector.
TEST(Pages, ResizesAndPushesAsAVectorDoes) {
  for (std::size_t from = 0; from < 14; ++from) {
    for (std::size_t to = 0; to < 14; ++to) {
      Numbers pages;
      std::vector<int> expected;
      const auto push = [&](int item) {
        pages.push_back(item);
        expected.push_back(item);
      };
      pages.resize(from, 7);
      expected.resize(from, 7);
      push(1);
      const Numbers snapshot = pages;
      const auto expected_of_snapshot = expected;
      pages.resize(to, 8);
      expected.resize(to, 8);
      push(2);
      EXPECT_EQ(items(pages), expected) << from << " to " << to;
      EXPECT_EQ(items(snapshot), expected_of_snapshot) << from << " to " << to;
    }
  }
}

TEST(Pages, GeneratesItemsInOrder) {
  for (int n = 0; n < 14; ++n) {
    Numbers pages;
    pages.push_back(99);
    std::vector<int> expected;
    for (int i = 0; i < n; ++i) expected.push_back(i * i);
    pages.generate(expected.size(), [](std::size_t i) { return static_cast<int>(i * i); });
    EXPECT_EQ(items(pages), expected);
    pages.push_back(5);
    expected.push_back(5);
    EXPECT_EQ(items(pages), expected);
  }
}

/// Several large blocks and a rest, of which single pages are copied, kept and given up in any order.
TEST(Pages, PagesInLargeBlocksAreCopiedOnWriteAsAnyOther) {
  constexpr std::size_t n = 300001;
  Numbers pages;
  pages.generate(n, [](std::size_t i) { return static_cast<int>(i); });
  EXPECT_GE(pages.allocated_bytes(), n * sizeof(int));
  auto snapshot = std::make_unique<Numbers>(pages);
  for (std::size_t i = 0; i < n; i += 1000) pages.edit(i) = -1;
  EXPECT_EQ(pages.pages_not_shared_with(*snapshot), 301u);
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_EQ((*snapshot)[i], static_cast<int>(i));
    ASSERT_EQ(pages[i], i % 1000 == 0 ? -1 : static_cast<int>(i));
  }
  snapshot.reset();
  pages.resize(5);
  pages.push_back(6);
  EXPECT_EQ(items(pages), (std::vector<int>{-1, 1, 2, 3, 4, 6}));
}

TEST(Pages, WritingAllLeavesASnapshotAlone) {
  Numbers pages;
  pages.resize(10, 3);
  const Numbers snapshot = pages;
  EXPECT_EQ(pages.bytes_not_shared_with(snapshot), 0u);
  const auto writer = pages.write_all();
  for (std::size_t i = 0; i < pages.size(); ++i) writer[i] = static_cast<int>(i);
  EXPECT_EQ(items(snapshot), std::vector<int>(10, 3));
  EXPECT_EQ(pages[9], 9);
  EXPECT_EQ(pages.pages_not_shared_with(snapshot), 3u);
}

TEST(Pages, AChangeCostsItsPageAndTheTable) {
  Numbers pages;
  pages.resize(12);
  const Numbers snapshot = pages;
  pages.edit(5) = 1;
  EXPECT_EQ(pages.pages_not_shared_with(snapshot), 1u);
  EXPECT_EQ(pages.bytes_not_shared_with(snapshot), 4 * sizeof(int) + 3 * sizeof(std::shared_ptr<int[]>));
}

}  // namespace
}  // namespace aresta
