// SPDX-License-Identifier: Apache-2.0
// Random operators: each leaves a valid complex or, when it refuses, the one it was given; taking all of them back
// gives the dumps seen on the way, byte for byte.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "random_operators.h"
#include "topology/check.h"
#include "topology/dump.h"

namespace aresta {
namespace {

TEST(OperatorsProperty, EachIsValidAndIsTakenBackToTheSameBytes) {
  const std::size_t wanted =
      std::getenv("ARESTA_OPERATORS") ? std::strtoull(std::getenv("ARESTA_OPERATORS"), nullptr, 10) : 4000;
  std::size_t applied_count = 0, refused = 0, no_space = 0;
  std::map<std::string, std::size_t> cases;
  std::map<std::string, std::size_t> refusals;
  for (std::uint64_t seed = 1; applied_count < wanted; ++seed) {
    Complex k = m_mr();
    RandomOperators random(seed);
    std::vector<Applied> history;
    std::vector<std::string> dumps{dump(k)};
    for (int i = 0; i < 200; ++i) {
      auto applied = random.apply(k);
      if (std::getenv("ARESTA_TRACE"))
        std::fprintf(stderr, "%s -> %s\n", random.tried().c_str(), applied ? applied->sub_case.c_str() : "refused");
      const std::string now = dump(k);
      if (!applied) {
        ++refused;
        ++refusals[random.tried().substr(0, random.tried().find(' ')) + " " + random.refusal()->code.name];
        ASSERT_EQ(now, dumps.back()) << "seed " << seed << ": " << random.tried();
        continue;
      }
      const auto findings = check_structure(k, StructureLevel::shells);
      ASSERT_TRUE(findings.empty()) << "seed " << seed << ": " << random.tried() << " -> " << applied->sub_case << ": "
                                    << describe(findings.front()) << "\nbefore\n"
                                    << dumps.back() << "after\n"
                                    << now;
      ++applied_count;
      if (const auto space = check_structure(k, StructureLevel::full); !space.empty()) {
        ++no_space;
        ++refusals["space " + applied->name + " " + applied->sub_case + " " + describe(space.front()).substr(0, 30)];
        if (std::getenv("ARESTA_TRACE")) {
          std::fprintf(stderr, "seed %zu: %s -> %s: %s\nbefore\n%safter\n%s", (size_t)seed, random.tried().c_str(),
                       applied->sub_case.c_str(), describe(space.front()).c_str(), dumps.back().c_str(), now.c_str());
        }
        i = 200;
      }
      ++cases[applied->name + " " + applied->sub_case];
      history.push_back(std::move(*applied));
      dumps.push_back(now);
      // At once there and back.
      take_back(k, history.back());
      ASSERT_EQ(dump(k), dumps[dumps.size() - 2]) << "seed " << seed << ": " << random.tried();
      make_again(k, history.back());
      ASSERT_EQ(dump(k), now) << "seed " << seed << ": " << random.tried();
    }
    while (!history.empty()) {
      take_back(k, history.back());
      history.pop_back();
      dumps.pop_back();
      ASSERT_EQ(dump(k), dumps.back()) << "seed " << seed;
    }
  }
  for (const auto& [name, count] : cases) std::printf("%-24s %zu\n", name.c_str(), count);
  for (const auto& [name, count] : refusals) std::printf("refused %-40s %zu\n", name.c_str(), count);
  std::printf("applied %zu, refused %zu, no space %zu\n", applied_count, refused, no_space);
}

}  // namespace
}  // namespace aresta
