// SPDX-License-Identifier: Apache-2.0
// Persistent ids: names of vertices, edges, faces and regions that outlast renumbering and are never used again.
//
// Guarantees: an entity keeps its persistent id as long as it lives, through operators and compaction; one that was
// killed and is taken back has the id it had; the id of one that is gone for good names nothing for ever. A split
// entity keeps its id and its pieces get new ones; where two merge, the kept one's stays.
//
// While nothing was killed or renumbered, persistent ids are the ids of the complex and nothing is stored; then 8 bytes
// for each row and 4 for each id ever given, per kind, in pages copied on write: a snapshot goes with that of the
// complex and costs nothing. Look-up both ways in constant time.
#pragma once

#include <array>
#include <span>

#include "base/pages.h"
#include "topology/compaction.h"
#include "topology/lineage.h"

namespace aresta {

/// Of one kind of entity; ordered by when it was given.
struct PersistentId {
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  EntityKind kind = EntityKind::vertex;
  std::uint64_t value = none;
  bool valid() const { return value != none; }
  auto operator<=>(const PersistentId&) const = default;
};

class PersistentIds {
 public:
  /// Names all that lives in the complex by its ids.
  explicit PersistentIds(const Complex& k);

  /// Invalid when the entity is not known to live.
  PersistentId of(EntityRef entity) const;
  /// Index EntityRef{}.index when it lives no longer, or the id was never given.
  EntityRef entity(PersistentId id) const;

  /// Follows an operator: lineage() of it, in order. Entities that come get new ids.
  void apply(std::span<const LineageEvent> events);
  void apply(const Compaction& compaction);

  /// The ids of another state of the same complex, before or after this one, for take-back and restoring. Ids given
  /// since then are not given again.
  void go_to(const PersistentIds& state);

  /// Are all ids of the kind those of the complex, so that nothing is stored?
  bool is_identity(EntityKind kind) const { return !table(kind).is_stored; }
  std::size_t allocated_bytes() const;
  std::size_t bytes_not_shared_with(const PersistentIds& earlier) const;

  /// Do the two name all the same? (What they would name next may differ.)
  bool names_the_same(const PersistentIds& other) const;

 private:
  static constexpr std::uint32_t no_row = 0xffffffffu;
  struct Table {
    std::uint64_t given = 0;  ///< ids below this were given
    std::uint64_t rows = 0;   ///< without tables: how many rows, each its own id
    bool is_stored = false;
    Pages<std::uint64_t> id_of_row;
    Pages<std::uint32_t> row_of_id;
  };

  const Table& table(EntityKind kind) const { return tables_[static_cast<std::size_t>(kind)]; }
  static void store(Table& table);
  static void begin(Table& table, std::uint32_t row);
  static void end(Table& table, std::uint32_t row);
  template <class IdType>
  static void renumber(Table& table, const std::vector<IdType>& to);

  std::array<Table, 4> tables_;
};

}  // namespace aresta
