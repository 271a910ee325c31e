// SPDX-License-Identifier: Apache-2.0
// Compaction renames and does nothing else; persistent ids stay through it and are never used again.
#include "topology/compaction.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "random_operators.h"
#include "topology/check.h"
#include "topology/dump.h"
#include "topology/persistent_ids.h"

namespace aresta {
namespace {

/// A dump with its ids replaced.
std::string renamed(const std::string& dump, const Compaction& to) {
  std::string result;
  for (std::size_t i = 0; i < dump.size();) {
    const bool begins = i == 0 || std::isalnum(static_cast<unsigned char>(dump[i - 1])) == 0;
    const bool is_id = begins && std::string("rflcev").find(dump[i]) != std::string::npos && i + 1 < dump.size() &&
                       std::isdigit(static_cast<unsigned char>(dump[i + 1])) != 0;
    if (!is_id) {
      result += dump[i++];
      continue;
    }
    const char kind = dump[i];
    std::size_t digits = 0;
    const std::size_t old = std::stoul(dump.substr(i + 1), &digits);
    i += 1 + digits;
    const std::uint32_t now = kind == 'r'   ? to.regions[old].value
                              : kind == 'f' ? to.faces[old].value
                              : kind == 'l' ? to.loops[old].value
                              : kind == 'c' ? to.coedges[old].value
                              : kind == 'e' ? to.edges[old].value
                                            : to.vertices[old].value;
    result += kind + std::to_string(now);
  }
  return result;
}

TEST(Compaction, RenamesAndNothingElse) {
  std::size_t with_gaps = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Complex k = m_mr();
    RandomOperators random(seed);
    for (int round = 0; round < 6; ++round) {
      for (int i = 0; i < 30; ++i) random.apply(k);
      const std::string before = dump(k);
      with_gaps += !k.is_compact();
      const Compaction to = compact(k);
      ASSERT_TRUE(k.is_compact());
      ASSERT_EQ(dump(k), renamed(before, to)) << "seed " << seed;
      const auto findings = check_structure(k, StructureLevel::shells);
      ASSERT_TRUE(findings.empty()) << "seed " << seed << ": " << describe(findings.front());
      const Complex once = k;
      compact(k);
      ASSERT_EQ(k.bytes_not_shared_with(once), 0u);
    }
  }
  EXPECT_GT(with_gaps, 100u);
}

/// Whatever lives, by persistent id; the test holds its own book of them.
using Book = std::map<PersistentId, EntityRef>;

Book book(const Complex& k, const PersistentIds& ids) {
  Book result;
  const auto add = [&](EntityRef e) {
    EXPECT_TRUE(ids.of(e).valid());
    EXPECT_EQ(ids.entity(ids.of(e)), e);
    EXPECT_TRUE(result.emplace(ids.of(e), e).second);
  };
  for (const VertexId v : k.vertices()) add(v);
  for (const EdgeId e : k.edges()) add(e);
  for (const FaceId f : k.faces()) add(f);
  for (const RegionId r : k.regions()) add(r);
  return result;
}

TEST(PersistentIds, AreTheIdsUntilSomethingIsKilled) {
  Complex k = m_mr();
  PersistentIds ids(k);
  ids.apply(lineage(*m_sv(k, RegionId(0))));
  auto edge = m_ev(k, VertexId(0));
  ids.apply(lineage(*edge));
  for (const EntityKind kind : {EntityKind::vertex, EntityKind::edge, EntityKind::face, EntityKind::region}) {
    EXPECT_TRUE(ids.is_identity(kind));
  }
  EXPECT_EQ(ids.of(EdgeId(0)).value, 0u);
  EXPECT_FALSE(ids.of(EdgeId(1)).valid());
  ids.apply(lineage(*k_e(k, EdgeId(0))));
  EXPECT_EQ(ids.entity({EntityKind::edge, 0}).index, EntityRef{}.index);
  ids.apply(lineage(*m_e(k, VertexId(0), VertexId(1))));
  EXPECT_EQ(ids.of(EdgeId(0)).value, 1u);
  EXPECT_TRUE(ids.is_identity(EntityKind::vertex));
}

TEST(PersistentIds, StayThroughOperatorsTakeBackAndCompaction) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Complex k = m_mr();
    RandomOperators random(seed);
    PersistentIds ids(k);
    Book now = book(k, ids);
    std::set<PersistentId> ever;
    for (const auto& [id, entity] : now) ever.insert(id);
    for (int i = 0; i < 150; ++i) {
      if (i % 25 == 24) {
        const Compaction to = compact(k);
        ids.apply(to);
        Book moved;
        for (const auto& [id, entity] : now) moved[id] = to(entity);
        now = std::move(moved);
        ASSERT_EQ(book(k, ids), now) << "seed " << seed;
        continue;
      }
      const PersistentIds before = ids;
      auto applied = random.apply(k);
      if (!applied) continue;
      const auto events = lineage(*applied);
      ids.apply(events);
      const Book then = book(k, ids);
      // Who was there and is not killed has the same id; who is new has one never seen.
      for (const auto& [id, entity] : then) {
        const auto was = now.find(id);
        if (was != now.end()) {
          ASSERT_EQ(was->second, entity);
        } else {
          ASSERT_TRUE(ever.insert(id).second) << "seed " << seed << ": " << random.tried();
        }
      }
      std::set<EntityRef> gone;
      for (const LineageEvent& e : events) {
        if (e.kind == LineageEvent::Kind::killed || e.kind == LineageEvent::Kind::merged) gone.insert(e.entity);
      }
      for (const auto& [id, entity] : now) ASSERT_EQ(then.contains(id), !gone.contains(entity));
      now = then;
      if (i % 3 == 0) {
        take_back(k, *applied);
        ids.go_to(before);
        ASSERT_TRUE(ids.names_the_same(before));
        now = book(k, ids);
      }
    }
  }
}

}  // namespace
}  // namespace aresta
