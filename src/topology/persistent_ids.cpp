// SPDX-License-Identifier: Apache-2.0
#include "topology/persistent_ids.h"

#include <algorithm>

namespace aresta {

PersistentIds::PersistentIds(const Complex& k) {
  const std::size_t bounds[] = {k.vertex_bound(), k.edge_bound(), k.face_bound(), k.region_bound()};
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    tables_[i].given = tables_[i].rows = bounds[i];
    for (std::uint32_t row = 0; row < bounds[i]; ++row) {
      if (!k.is_live(EntityRef(static_cast<EntityKind>(i), row))) end(tables_[i], row);
    }
  }
}

PersistentId PersistentIds::of(EntityRef entity) const {
  const Table& t = table(entity.kind);
  if (!t.is_stored) return {entity.kind, entity.index < t.rows ? entity.index : PersistentId::none};
  return {entity.kind, entity.index < t.id_of_row.size() ? t.id_of_row[entity.index] : PersistentId::none};
}

EntityRef PersistentIds::entity(PersistentId id) const {
  const Table& t = table(id.kind);
  if (!t.is_stored) return {id.kind, id.value < t.rows ? static_cast<std::uint32_t>(id.value) : no_row};
  return {id.kind, id.value < t.row_of_id.size() ? t.row_of_id[id.value] : no_row};
}

void PersistentIds::apply(std::span<const LineageEvent> events) {
  for (const LineageEvent& e : events) {
    const EntityRef subject = e.kind == LineageEvent::Kind::split ? e.other : e.entity;
    Table& t = tables_[static_cast<std::size_t>(subject.kind)];
    if (e.kind == LineageEvent::Kind::made || e.kind == LineageEvent::Kind::split) {
      begin(t, subject.index);
    } else {
      end(t, subject.index);
    }
  }
}

void PersistentIds::apply(const Compaction& compaction) {
  renumber(tables_[0], compaction.vertices);
  renumber(tables_[1], compaction.edges);
  renumber(tables_[2], compaction.faces);
  renumber(tables_[3], compaction.regions);
}

void PersistentIds::go_to(const PersistentIds& state) {
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const std::uint64_t given = std::max(tables_[i].given, state.tables_[i].given);
    tables_[i] = state.tables_[i];
    tables_[i].given = given;
  }
}

std::size_t PersistentIds::allocated_bytes() const {
  std::size_t bytes = 0;
  for (const Table& t : tables_) bytes += t.id_of_row.allocated_bytes() + t.row_of_id.allocated_bytes();
  return bytes;
}

std::size_t PersistentIds::bytes_not_shared_with(const PersistentIds& earlier) const {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    bytes += tables_[i].id_of_row.bytes_not_shared_with(earlier.tables_[i].id_of_row) +
             tables_[i].row_of_id.bytes_not_shared_with(earlier.tables_[i].row_of_id);
  }
  return bytes;
}

bool PersistentIds::names_the_same(const PersistentIds& other) const {
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const auto kind = static_cast<EntityKind>(i);
    const auto bound = [](const Table& t) { return t.is_stored ? t.id_of_row.size() : t.rows; };
    const std::size_t rows = std::max(bound(tables_[i]), bound(other.tables_[i]));
    for (std::uint32_t row = 0; row < rows; ++row) {
      if (of({kind, row}) != other.of({kind, row})) return false;
    }
  }
  return true;
}

void PersistentIds::store(Table& t) {
  if (t.is_stored) return;
  t.is_stored = true;
  t.id_of_row.resize(t.rows, PersistentId::none);
  t.row_of_id.resize(t.rows, no_row);
  for (std::uint32_t row = 0; row < t.rows; ++row) {
    t.id_of_row.edit(row) = row;
    t.row_of_id.edit(row) = row;
  }
}

void PersistentIds::begin(Table& t, std::uint32_t row) {
  const std::uint64_t id = t.given++;
  if (!t.is_stored && row == t.rows && id == t.rows) {
    ++t.rows;
    return;
  }
  store(t);
  if (t.id_of_row.size() <= row) t.id_of_row.resize(row + std::size_t{1}, PersistentId::none);
  if (t.row_of_id.size() <= id) t.row_of_id.resize(id + 1, no_row);
  t.id_of_row.edit(row) = id;
  t.row_of_id.edit(id) = row;
}

void PersistentIds::end(Table& t, std::uint32_t row) {
  store(t);
  const std::uint64_t id = t.id_of_row[row];
  t.id_of_row.edit(row) = PersistentId::none;
  t.row_of_id.edit(id) = no_row;
}

template <class IdType>
void PersistentIds::renumber(Table& t, const std::vector<IdType>& to) {
  bool moves = false;
  for (std::size_t i = 0; i < to.size() && !moves; ++i) moves = to[i].value != i;
  if (!moves) return;
  store(t);
  Pages<std::uint64_t> fresh;
  for (std::size_t row = 0; row < t.id_of_row.size(); ++row) {
    const std::uint64_t id = t.id_of_row[row];
    if (id == PersistentId::none) continue;
    // Order is kept, so that rows come one after the other.
    t.row_of_id.edit(id) = to[row].value;
    fresh.push_back(id);
  }
  t.id_of_row = std::move(fresh);
}

}  // namespace aresta
