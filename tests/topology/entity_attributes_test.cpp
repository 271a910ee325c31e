// SPDX-License-Identifier: Apache-2.0
// Attributes and groups by their rules, as tables, and taken back with random operators.
#include "topology/entity_attributes.h"

#include <gtest/gtest.h>

#include "random_operators.h"

namespace aresta {
namespace {

using Kind = LineageEvent::Kind;

EntityRef f(std::uint32_t i) {
  return FaceId(i);
}

LineageEvent split(std::uint32_t old, std::uint32_t piece) {
  return {Kind::split, f(old), f(piece)};
}
LineageEvent merged(std::uint32_t gone, std::uint32_t kept) {
  return {Kind::merged, f(gone), f(kept)};
}
LineageEvent killed(std::uint32_t gone) {
  return {Kind::killed, f(gone), {}};
}

EntityAttributes with(const AttributeType& type, const std::map<std::uint32_t, AttributeValue>& values) {
  EntityAttributes a;
  EXPECT_TRUE(a.declare(type).ok());
  for (const auto& [i, value] : values) EXPECT_TRUE(a.set(f(i), type.name, value).ok());
  return a;
}

TEST(EntityAttributes, ValuesFollowTheirRules) {
  using Values = std::map<std::uint32_t, AttributeValue>;
  struct Case {
    const char* name;
    OnSplit on_split;
    OnMerge on_merge;
    std::vector<LineageEvent> events;
    Values before, after;
  };
  const auto copy = OnSplit::copy, keep_old = OnSplit::keep_old, share_out = OnSplit::share_out;
  const auto first = OnMerge::keep_first, sum = OnMerge::sum, larger = OnMerge::larger, smaller = OnMerge::smaller;
  const Case cases[] = {
      {"copied", copy, first, {split(0, 1), split(0, 2)}, {{0, 6.0}}, {{0, 6.0}, {1, 6.0}, {2, 6.0}}},
      {"kept", keep_old, first, {split(0, 1)}, {{0, 6.0}}, {{0, 6.0}}},
      {"shared", share_out, first, {split(0, 1)}, {{0, 6.0}}, {{0, 3.0}, {1, 3.0}}},
      {"shared by all pieces at once",
       share_out,
       first,
       {split(0, 1), split(1, 2)},
       {{0, 6.0}},
       {{0, 2.0}, {1, 2.0}, {2, 2.0}}},
      {"nothing for what dies",
       share_out,
       first,
       {split(0, 1), split(0, 2), killed(0)},
       {{0, 6.0}},
       {{1, 3.0}, {2, 3.0}}},
      {"first", copy, first, {merged(1, 0)}, {{0, 2.0}, {1, 5.0}}, {{0, 2.0}}},
      {"first that has one", copy, first, {merged(1, 0)}, {{1, 5.0}}, {{0, 5.0}}},
      {"sum", copy, sum, {merged(1, 0), merged(2, 0)}, {{0, 2.0}, {1, 5.0}, {2, 1.0}}, {{0, 8.0}}},
      {"larger", copy, larger, {merged(1, 0)}, {{0, 2.0}, {1, 5.0}}, {{0, 5.0}}},
      {"smaller", copy, smaller, {merged(1, 0)}, {{0, 2.0}, {1, 5.0}}, {{0, 2.0}}},
      {"dropped", copy, first, {killed(1)}, {{0, 2.0}, {1, 5.0}}, {{0, 2.0}}},
      {"made with none", copy, first, {{Kind::made, f(1), {}}}, {{0, 2.0}}, {{0, 2.0}}},
  };
  for (const Case& c : cases) {
    const AttributeType type{"x", AttributeKind::number, c.on_split, c.on_merge};
    EntityAttributes a = with(type, c.before);
    const AttributesApplied applied = a.apply(c.events);
    EXPECT_TRUE(applied.conflicts.empty()) << c.name;
    EXPECT_EQ(a, with(type, c.after)) << c.name;
    a.take_back(applied);
    EXPECT_EQ(a, with(type, c.before)) << c.name;
  }
}

TEST(EntityAttributes, SharesGoByWeight) {
  const auto weight = [](EntityRef e) { return e.index == 0 ? 3.0 : 1.0; };
  EntityAttributes a =
      with({"mass", AttributeKind::number, OnSplit::share_out, OnMerge::sum, OnCopy::copy, weight}, {{0, 8.0}});
  a.apply(std::vector{split(0, 1)});
  EXPECT_EQ(a.get(f(0), "mass"), AttributeValue(6.0));
  EXPECT_EQ(a.get(f(1), "mass"), AttributeValue(2.0));
}

TEST(EntityAttributes, DisagreementIsReportedAndTheKeptValueStays) {
  const AttributeType type{"material", AttributeKind::text, OnSplit::copy, OnMerge::must_agree};
  EntityAttributes a = with(type, {{0, std::string("steel")}, {1, std::string("glass")}, {2, std::string("steel")}});
  const auto applied = a.apply(std::vector{merged(1, 0), merged(2, 0)});
  ASSERT_EQ(applied.conflicts.size(), 1u);
  EXPECT_EQ(applied.conflicts[0],
            (AttributeConflict{"material", f(0), f(1), std::string("steel"), std::string("glass")}));
  EXPECT_EQ(a, with(type, {{0, std::string("steel")}}));
}

TEST(EntityAttributes, GroupsFollow) {
  EntityAttributes a;
  a.add("skin", f(0));
  a.add("skin", f(1));
  const auto applied = a.apply(std::vector{split(0, 4), merged(1, 3), killed(0)});
  EXPECT_EQ(a.members("skin"), (std::vector<EntityRef>{f(3), f(4)}));
  a.take_back(applied);
  EXPECT_EQ(a.members("skin"), (std::vector<EntityRef>{f(0), f(1)}));
}

TEST(EntityAttributes, CopiesGetWhatIsDeclaredSo) {
  EntityAttributes a = with({"color"}, {{0, std::string("red")}});
  ASSERT_TRUE(a.declare({"serial", AttributeKind::number, OnSplit::keep_old, OnMerge::keep_first, OnCopy::drop}).ok());
  ASSERT_TRUE(a.set(f(0), "serial", 7.0).ok());
  a.add("skin", f(0));
  a.copy(std::vector{std::pair{f(0), f(5)}});
  EXPECT_EQ(a.get(f(5), "color"), AttributeValue(std::string("red")));
  EXPECT_FALSE(a.get(f(5), "serial"));
  EXPECT_TRUE(a.contains("skin", f(5)));
}

TEST(EntityAttributes, RefusesWhatDoesNotSuit) {
  EntityAttributes a;
  EXPECT_EQ(a.declare({"x", AttributeKind::text, OnSplit::copy, OnMerge::sum}).error().code, errors::bad_rule);
  ASSERT_TRUE(a.declare({"x", AttributeKind::flag}).ok());
  EXPECT_TRUE(a.declare({"x", AttributeKind::flag}).ok());
  EXPECT_EQ(a.declare({"x", AttributeKind::number}).error().code, errors::bad_rule);
  EXPECT_EQ(a.set(f(0), "x", 1.0).error().code, errors::wrong_value);
  EXPECT_EQ(a.set(f(0), "y", true).error().code, errors::unknown_attribute);
  EXPECT_TRUE(a.set(f(0), "x", true).ok());
}

/// All that it says, entry by entry.
std::string text(const EntityAttributes& a) {
  std::string all;
  for (const std::string& name : a.attributes()) {
    for (const auto& [e, value] : a.all(name)) {
      const double* number = std::get_if<double>(&value);
      all += name + ' ' + to_string(e.kind) + std::to_string(e.index) + ' ' +
             (number != nullptr ? std::to_string(*number) : std::get<std::string>(value)) + '\n';
    }
  }
  for (const std::string& group : a.groups()) {
    all += group;
    for (const EntityRef e : a.members(group)) all += std::string(" ") + to_string(e.kind) + std::to_string(e.index);
    all += '\n';
  }
  return all;
}

TEST(EntityAttributes, RandomOperatorsAreTakenBackExactly) {
  std::size_t conflicts = 0, applied_count = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Complex k = m_mr();
    RandomOperators random(seed);
    std::mt19937_64 values(seed);
    EntityAttributes a;
    ASSERT_TRUE(a.declare({"mass", AttributeKind::number, OnSplit::share_out, OnMerge::sum}).ok());
    ASSERT_TRUE(a.declare({"size", AttributeKind::number, OnSplit::copy, OnMerge::smaller}).ok());
    ASSERT_TRUE(a.declare({"material", AttributeKind::text, OnSplit::copy, OnMerge::must_agree}).ok());
    struct Step {
      Applied applied;
      AttributesApplied attributes;
      std::string before;
    };
    std::vector<Step> history;
    for (int i = 0; i < 120; ++i) {
      auto applied = random.apply(k);
      if (!applied) continue;
      ++applied_count;
      const auto events = lineage(*applied);
      const std::string before = text(a);
      AttributesApplied attributes = a.apply(events);
      conflicts += attributes.conflicts.size();
      for (const std::string& name : a.attributes()) {
        for (const auto& [entity, value] : a.all(name)) ASSERT_TRUE(k.is_live(entity)) << name << ' ' << applied->name;
      }
      for (const std::string& group : a.groups()) {
        for (const EntityRef e : a.members(group)) ASSERT_TRUE(k.is_live(e)) << group << ' ' << applied->name;
      }
      history.push_back({std::move(*applied), std::move(attributes), before});
      // New entities get values, between operators.
      for (const LineageEvent& e : events) {
        if (e.kind != Kind::made) continue;
        ASSERT_TRUE(a.set(e.entity, "mass", static_cast<double>(values() % 100)).ok());
        ASSERT_TRUE(a.set(e.entity, "size", static_cast<double>(values() % 100)).ok());
        ASSERT_TRUE(a.set(e.entity, "material", std::string(values() % 2 == 0 ? "steel" : "glass")).ok());
        a.add(values() % 2 == 0 ? "left" : "right", e.entity);
      }
    }
    for (; !history.empty(); history.pop_back()) {
      take_back(k, history.back().applied);
      a.take_back(history.back().attributes);
      ASSERT_EQ(text(a), history.back().before) << "seed " << seed << ": " << history.back().applied.name;
    }
    EXPECT_TRUE(a.all("mass").empty());
    EXPECT_TRUE(a.members("left").empty());
  }
  std::printf("operators %zu, conflicts %zu\n", applied_count, conflicts);
  EXPECT_GT(conflicts, 0u);
}

}  // namespace
}  // namespace aresta
