// SPDX-License-Identifier: Apache-2.0
#include "topology/check.h"

#include <gtest/gtest.h>

#include <random>

#include "breaker.h"
#include "catalogue.h"
#include "topology/editor.h"

namespace aresta {
namespace {

using Break = ComplexBreaker;

std::string first_of(const std::vector<StructuralFinding>& findings) {
  return findings.empty() ? "no finding" : describe(findings.front());
}

TEST(CheckStructure, FindsNothingInTheCatalogue) {
  for (const CatalogueModel& model : catalogue()) {
    for (const auto& finding : check_structure(model.complex)) ADD_FAILURE() << model.name << ": " << describe(finding);
  }
}

/// Makes free rows of every kind, between those in use.
void make_gaps(Complex& k) {
  Editor edit(k);
  for (int i = 0; i < 3; ++i) {
    edit.free(edit.make_vertex(VertexId(k.vertex_bound() + 1)));
    const EdgeId e = edit.make_edge(EdgeId(k.edge_bound() + 1));
    const ShellId s = edit.make_shell(Complex::infinite_region());
    edit.put(Item(e), s);
    edit.take(Item(e));
    edit.free(s);
    edit.free(e);
    edit.free(edit.make_coedge(CoedgeId(k.coedge_bound() + 1)));
    const LoopId l = edit.make_loop(LoopId(k.loop_bound() + 1));
    const VertexId v = edit.make_vertex();
    edit.set_vertex_loop(l, v);
    edit.unset_vertex_loop(l);
    edit.free(v);
    edit.free(l);
    edit.free(edit.make_face(FaceId(k.face_bound() + 1)));
    edit.free(edit.make_region(true, RegionId(k.region_bound() + 1)));
  }
}

TEST(CheckStructure, FindsNothingWhereRowsAreFree) {
  for (CatalogueModel& model : catalogue()) {
    make_gaps(model.complex);
    ASSERT_FALSE(model.complex.is_compact());
    EXPECT_EQ(first_of(check_structure(model.complex)), "no finding") << model.name;
  }
}

/// Is the complex still right with this number in this place? Heads of cycles may be any member, a finite region may be
/// filled or not, and an edge from a vertex to itself may be taken either way where only one region is about it.
bool may_be(const Complex& k, const ComplexBreaker::Word& word, std::uint32_t before, std::uint32_t after) {
  const std::size_t i = word.row.index;
  if (word.row.kind == RowKind::vertex && word.name == "first_end") {
    const EdgeEnd end{EdgeId(after >> 1), static_cast<int>(after & 1u)};
    return k.is_live(end.edge) && k.vertex(end) == VertexId(i);
  }
  if (word.row.kind == RowKind::edge && word.name == "first_use") {
    return k.is_live(CoedgeId(after)) && k.edge(CoedgeId(after)) == EdgeId(i);
  }
  if (word.row.kind == RowKind::loop && word.name == "first") {
    return k.is_live(CoedgeId(after)) && k.loop(CoedgeId(after)) == LoopId(i);
  }
  if (word.row.kind == RowKind::region && word.name == "filled") {
    return i != 0 && before != Break::dead && after != Break::dead;
  }
  if (word.name == "edge_sense") return (before ^ after) == 1 && k.is_closed(EdgeId(before >> 1));
  return false;
}

/// Every number of every record of every model, changed to what it should not be.
TEST(CheckStructure, FindsEverySingleWrongNumber) {
  std::size_t changes = 0;
  for (const CatalogueModel& model : catalogue()) {
    for (const bool gaps : {false, true}) {
      Complex sound = model.complex;
      if (gaps) make_gaps(sound);
      Complex k = sound;
      const auto words = Break::words(k);
      for (const auto& word : words) {
        const std::uint32_t before = *word.value, flipped = before ^ 1u;
        for (const std::uint32_t after : {0u, 1u, 2u, 3u, flipped, before + 1, before - 1, before ^ Break::tag,
                                          1000000u, Break::tag, Break::tag + 1, Break::none, Break::dead}) {
          if (after == before) continue;
          *word.value = after;
          ++changes;
          const auto findings = check_structure(k);
          if (findings.empty() && !may_be(sound, word, before, after)) {
            ADD_FAILURE() << model.name << ": " << word.name << " of " << to_string(word.row.kind) << ' '
                          << word.row.index << " changed from " << before << " to " << after;
          }
          for (const auto& finding : findings) EXPECT_FALSE(describe(finding).empty());
          *word.value = before;
        }
      }
      EXPECT_EQ(first_of(check_structure(k)), "no finding") << model.name;
    }
  }
  EXPECT_GT(changes, 100000u);
}

TEST(CheckStructure, EndsWhateverTheRecordsHold) {
  std::mt19937 random(7);
  for (const CatalogueModel& model : catalogue()) {
    Complex sound = model.complex;
    make_gaps(sound);
    for (int round = 0; round < 50; ++round) {
      Complex k = sound;
      auto words = Break::words(k);
      const std::size_t spoilt = 1 + random() % words.size();
      for (std::size_t i = 0; i < spoilt; ++i) {
        // Mostly small numbers, which lead to some row.
        const std::uint32_t value = random();
        *words[random() % words.size()].value = value % 3 == 0 ? value : value % 20;
      }
      const auto findings = check_structure(k);
      EXPECT_TRUE(std::is_sorted(findings.begin(), findings.end())) << model.name;
      EXPECT_TRUE(findings == check_structure(k)) << model.name;
    }
  }
}

/// Shuffled links that all lead to rows in use: what the first stage lets pass and the others must survive.
TEST(CheckStructure, EndsWhereLinksOfOneKindAreShuffled) {
  std::mt19937 random(11);
  std::size_t rounds = 0;
  for (const CatalogueModel& model : catalogue()) {
    std::vector<std::pair<RowKind, std::string>> kinds;
    Complex sound = model.complex;
    for (const auto& word : Break::words(sound)) kinds.emplace_back(word.row.kind, word.name);
    std::sort(kinds.begin(), kinds.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    for (const auto& kind : kinds) {
      for (int round = 0; round < 5; ++round, ++rounds) {
        Complex k = model.complex;
        std::vector<std::uint32_t*> places;
        for (const auto& word : Break::words(k)) {
          if (std::pair(word.row.kind, word.name) == kind) places.push_back(word.value);
        }
        std::vector<std::uint32_t> values;
        for (const std::uint32_t* place : places) values.push_back(*place);
        std::shuffle(values.begin(), values.end(), random);
        for (std::size_t i = 0; i < places.size(); ++i) *places[i] = values[i];
        check_structure(k);
      }
    }
  }
  EXPECT_GT(rounds, 1000u);
}

}  // namespace
}  // namespace aresta
