// SPDX-License-Identifier: Apache-2.0
// Dumps depend on what a complex is, not on how it came about.
#include "topology/canonical.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "catalogue.h"
#include "small_models.h"
#include "topology/change.h"
#include "topology/check.h"
#include "topology/dump.h"
#include "topology/dump_json.h"
#include "topology/editor.h"
#include "topology/notation.h"
#include "topology/parse_dump.h"
#include "topology/records.h"

namespace aresta {
namespace {

/// The small models and the catalogue.
std::vector<CatalogueModel> models() {
  std::vector<CatalogueModel> result = catalogue();
  for (const SmallModel& model : small_models()) result.push_back({model.name, *parse_notation(model.text)});
  return result;
}

template <class List>
void shuffle(List& list, std::mt19937& random) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random() % i]);
}
template <class List>
void rotate(List& list, std::mt19937& random) {
  if (!list.empty()) {
    std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(random() % list.size()), list.end());
  }
}
template <class Range>
auto shuffled(const Range& range, std::mt19937& random) {
  std::vector<std::decay_t<decltype(*range.begin())>> list;
  for (const auto item : range) list.push_back(item);
  shuffle(list, random);
  return list;
}

/// The records of a complex, in any order that says the same.
ComplexRecords records_of(const Complex& k, std::mt19937& random) {
  ComplexRecords records;
  for (const RegionId r : shuffled(k.regions(), random)) {
    records.regions.push_back({r, k.is_filled(r)});
    auto shells = canonical_shells(k, r);
    shuffle(shells, random);
    for (auto& items : shells) {
      shuffle(items, random);
      for (const Item item : items) records.items.push_back({item, static_cast<std::uint32_t>(records.shells.size())});
      records.shells.push_back({r});
    }
  }
  for (const FaceId f : shuffled(k.faces(), random)) {
    for (const LoopId l : shuffled(canonical_loops(k, f), random)) {
      auto coedges = canonical_coedges(k, l);
      rotate(coedges, random);
      for (const CoedgeId c : coedges) {
        records.coedges.push_back({c, k.edge(c), k.reversed(c), static_cast<std::uint32_t>(records.loops.size())});
      }
      records.loops.push_back({l, k.loop_vertex(l), static_cast<std::uint32_t>(records.faces.size())});
    }
    records.faces.push_back({f});
  }
  for (const EdgeId e : shuffled(k.edges(), random)) {
    auto coedges = canonical_coedges(k, e);
    rotate(coedges, random);
    for (const CoedgeId c : coedges) records.uses.push_back({c, static_cast<std::uint32_t>(records.edges.size())});
    records.edges.push_back({e, k.start(e), k.end(e)});
  }
  for (const VertexId v : shuffled(k.vertices(), random)) records.vertices.push_back({v});
  return records;
}

/// Attaches all edge ends anew, in any order.
void reattach(Complex& k, std::mt19937& random) {
  Editor editor(k);
  for (const VertexId v : k.vertices()) {
    auto ends = canonical_edge_ends(k, v);
    shuffle(ends, random);
    for (const EdgeEnd end : ends) editor.detach(end);
    shuffle(ends, random);
    for (const EdgeEnd end : ends) editor.attach(end, v);
  }
}

TEST(Canonical, OrderAndStartOfListsDoNotShow) {
  std::mt19937 random(7);
  for (const CatalogueModel& model : models()) {
    const Complex& k = model.complex;
    const std::string text = dump(k), json = dump_json(k);
    for (int i = 0; i < 20; ++i) {
      auto other = rebuild(records_of(k, random));
      ASSERT_TRUE(other.ok()) << model.name << ": " << other.error().to_line();
      reattach(*other, random);
      EXPECT_EQ(dump(*other), text) << model.name;
      EXPECT_EQ(dump_json(*other), json) << model.name;
    }
  }
}

TEST(Canonical, DumpsAreReadBackExactly) {
  for (const CatalogueModel& model : models()) {
    const std::string text = dump(model.complex);
    const auto again = parse_dump(text);
    ASSERT_TRUE(again.ok()) << model.name << ": " << again.error().to_line();
    EXPECT_EQ(dump(*again), text) << model.name;
    const auto findings = check_structure(*again);
    EXPECT_TRUE(findings.empty()) << model.name << ": " << describe(findings.front());
  }
}

/// Makes changes and takes some back, so that ids are left out.
TEST(Canonical, GapsStayWhereChangesWereTakenBack) {
  for (const CatalogueModel& model : models()) {
    Complex k = model.complex;
    const std::string before = dump(k);
    const std::size_t edge_bound = k.edge_bound();
    std::vector<Change> points, wires;
    for (int i = 0; i < 5; ++i) make(k, points.emplace_back(Change{PointChange{VertexId(), RegionId(0)}}));
    const auto vertex = [&](std::size_t i) { return std::get<PointChange>(points[i].what).vertex; };
    for (std::size_t i = 0; i < 3; ++i) {
      make(k, wires.emplace_back(Change{WireChange{EdgeId(), vertex(i), vertex(i + 1), RegionId(0)}}));
    }
    take_back(k, wires[1]);
    take_back(k, points[4]);
    EXPECT_FALSE(k.is_compact());
    EXPECT_FALSE(k.is_live(EdgeId(edge_bound + 1)));

    const std::string text = dump(k);
    const auto again = parse_dump(text), from_json = parse_json(dump_json(k));
    ASSERT_TRUE(again.ok()) << model.name << ": " << again.error().to_line();
    ASSERT_TRUE(from_json.ok()) << model.name << ": " << from_json.error().to_line();
    EXPECT_EQ(dump(*again), text) << model.name;
    EXPECT_EQ(dump(*from_json), text) << model.name;
    EXPECT_FALSE(again->is_live(EdgeId(edge_bound + 1)));
    EXPECT_TRUE(again->is_live(EdgeId(edge_bound + 2)));

    take_back(k, wires[2]);
    take_back(k, wires[0]);
    for (std::size_t i = 4; i-- > 0;) take_back(k, points[i]);
    EXPECT_EQ(dump(k), before) << model.name;
  }
}

/// What is read can be changed further: rows that were left out are used again.
TEST(Canonical, GapsAreFilledAfterReading) {
  auto k = parse_dump(
      "aresta complex 1\nregion r0: infinite\n  shell e3\nedge e3: v1 to v5, wire in r0\nvertex v1: +e3\nvertex v5: "
      "-e3\n");
  ASSERT_TRUE(k.ok()) << k.error().to_line();
  std::vector<Change> changes;
  for (int i = 0; i < 6; ++i) make(*k, changes.emplace_back(Change{PointChange{VertexId(), RegionId(0)}}));
  EXPECT_EQ(k->vertex_bound(), 8u);
  EXPECT_EQ(k->vertex_count(), 8u);
  Change wanted{WireChange{EdgeId(1), VertexId(0), VertexId(7), RegionId(0)}};
  make(*k, wanted);
  EXPECT_TRUE(k->is_live(EdgeId(1)));
  EXPECT_EQ(k->edge_count(), 2u);
  EXPECT_TRUE(parse_dump(dump(*k)).ok());
}

TEST(Canonical, RecordsThatAreNoComplexAreRefused) {
  // What no text can say, since its grammar does not: these come from programs.
  ComplexRecords records;
  records.regions = {{RegionId(0)}};
  records.faces = {{FaceId(0)}};
  EXPECT_EQ(rebuild(records).error().message, "f0 has no loop");
  records.loops = {{LoopId(0), VertexId(), 0}};
  EXPECT_EQ(rebuild(records).error().message, "l0 must have coedges or be a vertex, and not both");
  records.loops[0].vertex = VertexId(3);
  EXPECT_EQ(rebuild(records).error().message, "l0 names v3, which is not there");
  records.vertices = {{VertexId(3)}};
  EXPECT_EQ(rebuild(records).error().message, "+f0 lies in no shell");
  records.shells = {{RegionId(0)}, {RegionId(0)}};
  records.items = {{FaceUse(FaceId(0), 0), 0}, {FaceUse(FaceId(0), 1), 0}};
  EXPECT_EQ(rebuild(records).error().message, "a shell has nothing in it");
  records.shells = {{RegionId(0)}};
  EXPECT_TRUE(rebuild(records).ok());
  records.shells = {{RegionId(2)}};
  EXPECT_EQ(rebuild(records).error().message, "a shell names r2, which is not there");
  records.loops[0].face = 1;
  EXPECT_EQ(rebuild(records).error().message, "the lists of records do not follow one another");
  records.loops[0].face = 0;
  records.vertices.push_back({});
  EXPECT_EQ(rebuild(records).error().code, errors::record_ids);
}

}  // namespace
}  // namespace aresta
