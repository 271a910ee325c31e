// SPDX-License-Identifier: Apache-2.0
// Every model of the catalogue is torn down to nothing and built up again by the same operators in reverse, to the same
// dumps byte for byte. As each model has a place in space and killing cannot take it away, the full check stays silent.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "catalogue.h"
#include "topology/check.h"
#include "topology/dump.h"
#include "topology/operators.h"

namespace aresta {
namespace {

template <class IdType, class Range>
std::vector<EntityRef> refs(const Range& range) {
  std::vector<EntityRef> all;
  for (const IdType id : range) all.push_back(id);
  return all;
}

Result<Applied> kill(Complex& k, EntityRef entity) {
  switch (entity.kind) {
    case EntityKind::vertex:
      return k_v(k, VertexId(entity.index));
    case EntityKind::edge:
      return k_e(k, EdgeId(entity.index));
    default:
      return k_f(k, FaceId(entity.index));
  }
}

/// Kills what `choose` names until nothing is left, and takes it all back.
template <class Choose>
void tear_down_and_build(const CatalogueModel& model, Choose&& choose) {
  Complex k = model.complex;
  std::vector<Applied> history;
  std::vector<std::string> dumps{dump(k)};
  while (!k_m(k).ok()) {
    const EntityRef entity = choose(k);
    auto applied = kill(k, entity);
    ASSERT_TRUE(applied.ok()) << model.name << ": " << applied.error().to_line();
    const auto findings = check_structure(k, StructureLevel::full);
    ASSERT_TRUE(findings.empty()) << model.name << ": " << applied->name << " of " << to_string(entity.kind) << " "
                                  << entity.index << " -> " << applied->sub_case << ": " << describe(findings.front())
                                  << "\nbefore\n"
                                  << dumps.back() << "after\n"
                                  << dump(k);
    history.push_back(std::move(*applied));
    dumps.push_back(dump(k));
    ASSERT_LT(dumps.size(), 10000u) << model.name;
  }
  EXPECT_EQ(dump(k), dump(m_mr())) << model.name;
  std::vector<Applied> taken_back;
  while (!history.empty()) {
    take_back(k, history.back());
    dumps.pop_back();
    ASSERT_EQ(dump(k), dumps.back()) << model.name << ", step " << history.size();
    taken_back.push_back(std::move(history.back()));
    history.pop_back();
  }
  EXPECT_EQ(dump(k), dump(model.complex)) << model.name;
  while (!taken_back.empty()) {
    make_again(k, taken_back.back());
    taken_back.pop_back();
  }
  EXPECT_EQ(dump(k), dump(m_mr())) << model.name;
}

TEST(OperatorsTeardown, FacesThenEdgesThenVertices) {
  const auto models = catalogue();
  ASSERT_GE(models.size(), 40u);
  for (const CatalogueModel& model : models) {
    tear_down_and_build(model, [](const Complex& k) -> EntityRef {
      for (const FaceId f : k.faces()) return f;
      for (const EdgeId e : k.edges()) return e;
      return *k.vertices().begin();
    });
    if (HasFatalFailure()) return;
  }
}

TEST(OperatorsTeardown, EdgesBeforeFaces) {
  for (const CatalogueModel& model : catalogue()) {
    tear_down_and_build(model, [](const Complex& k) -> EntityRef {
      for (const EdgeId e : k.edges()) return e;
      for (const FaceId f : k.faces()) return f;
      return *k.vertices().begin();
    });
    if (HasFatalFailure()) return;
  }
}

TEST(OperatorsTeardown, InRandomOrders) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    for (const CatalogueModel& model : catalogue()) {
      tear_down_and_build(model, [&](const Complex& k) -> EntityRef {
        std::vector<std::vector<EntityRef>> kinds;
        for (auto all : {refs<FaceId>(k.faces()), refs<EdgeId>(k.edges()), refs<VertexId>(k.vertices())}) {
          if (!all.empty()) kinds.push_back(std::move(all));
        }
        // Vertices take much with them: rarely.
        const auto& kind =
            random() % 10 == 0 ? kinds.back() : kinds[random() % std::max<std::size_t>(1, kinds.size() - 1)];
        return kind[random() % kind.size()];
      });
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace aresta
