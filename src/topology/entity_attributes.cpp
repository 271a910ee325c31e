// SPDX-License-Identifier: Apache-2.0
#include "topology/entity_attributes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace aresta {

namespace {

using Kind = LineageEvent::Kind;

bool is_of(AttributeKind kind, const AttributeValue& value) {
  return value.index() == static_cast<std::size_t>(kind);
}

bool needs_number(const AttributeType& t) {
  return t.on_split == OnSplit::share_out || t.on_merge == OnMerge::sum || t.on_merge == OnMerge::larger ||
         t.on_merge == OnMerge::smaller;
}

bool same_rules(const AttributeType& a, const AttributeType& b) {
  return a.name == b.name && a.kind == b.kind && a.on_split == b.on_split && a.on_merge == b.on_merge &&
         a.on_copy == b.on_copy;
}

AttributeValue merge(OnMerge rule, const AttributeValue& kept, const AttributeValue& gone) {
  if (rule == OnMerge::keep_first || rule == OnMerge::must_agree) return kept;
  const double a = std::get<double>(kept), b = std::get<double>(gone);
  if (rule == OnMerge::sum) return a + b;
  return rule == OnMerge::larger ? std::max(a, b) : std::min(a, b);
}

}  // namespace

EntityAttributes::Tables& EntityAttributes::edit() {
  if (tables_.use_count() > 1) tables_ = std::make_shared<Tables>(*tables_);
  return *tables_;
}

EntityAttributes::Column& EntityAttributes::edit_column(std::shared_ptr<Column>& column) {
  if (column.use_count() > 1) column = std::make_shared<Column>(*column);
  return *column;
}

Status EntityAttributes::declare(const AttributeType& t) {
  if (t.kind != AttributeKind::number && needs_number(t)) {
    return Error{errors::bad_rule, "attribute \"" + t.name + "\": only numbers are shared out, summed or compared"};
  }
  if (const AttributeType* known = type(t.name); known != nullptr && !same_rules(*known, t)) {
    return Error{errors::bad_rule, "attribute \"" + t.name + "\" is declared already, with other rules"};
  }
  auto& column = edit().columns[t.name];
  if (!column) column = std::make_shared<Column>();
  edit_column(column).type = t;
  return {};
}

const AttributeType* EntityAttributes::type(const std::string& name) const {
  const auto found = tables_->columns.find(name);
  return found == tables_->columns.end() ? nullptr : &found->second->type;
}

std::vector<std::string> EntityAttributes::attributes() const {
  std::vector<std::string> names;
  for (const auto& [name, column] : tables_->columns) names.push_back(name);
  return names;
}

Status EntityAttributes::set(EntityRef entity, const std::string& attribute, AttributeValue value) {
  const AttributeType* t = type(attribute);
  if (t == nullptr) return Error{errors::unknown_attribute, "attribute \"" + attribute + "\" is not declared"};
  if (!is_of(t->kind, value)) {
    constexpr const char* kinds[] = {"a flag", "a number", "a text"};
    return Error{
        errors::wrong_value,
        "attribute \"" + attribute + "\" is " + kinds[static_cast<int>(t->kind)] + ", not " + kinds[value.index()],
        {entity}};
  }
  edit_column(edit().columns[attribute]).values.set(entity, std::move(value));
  return {};
}

void EntityAttributes::unset(EntityRef entity, const std::string& attribute) {
  if (get(entity, attribute)) edit_column(edit().columns[attribute]).values.erase(entity);
}

std::optional<AttributeValue> EntityAttributes::get(EntityRef entity, const std::string& attribute) const {
  const auto found = tables_->columns.find(attribute);
  if (found == tables_->columns.end()) return std::nullopt;
  const AttributeValue* value = found->second->values.find(entity);
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

std::vector<std::pair<EntityRef, AttributeValue>> EntityAttributes::all(const std::string& attribute) const {
  std::vector<std::pair<EntityRef, AttributeValue>> result;
  const auto found = tables_->columns.find(attribute);
  if (found == tables_->columns.end()) return result;
  found->second->values.for_each([&](EntityRef e, const AttributeValue& value) { result.emplace_back(e, value); });
  return result;
}

void EntityAttributes::make_group(const std::string& group) {
  edit().groups[group];
}

void EntityAttributes::kill_group(const std::string& group) {
  edit().groups.erase(group);
}

void EntityAttributes::add(const std::string& group, EntityRef entity) {
  edit().groups[group].set(entity, true);
}

void EntityAttributes::remove(const std::string& group, EntityRef entity) {
  if (contains(group, entity)) edit().groups[group].erase(entity);
}

bool EntityAttributes::contains(const std::string& group, EntityRef entity) const {
  const auto found = tables_->groups.find(group);
  return found != tables_->groups.end() && found->second.contains(entity);
}

std::vector<std::string> EntityAttributes::groups() const {
  std::vector<std::string> names;
  for (const auto& [name, members] : tables_->groups) names.push_back(name);
  return names;
}

std::vector<EntityRef> EntityAttributes::members(const std::string& group) const {
  std::vector<EntityRef> result;
  const auto found = tables_->groups.find(group);
  if (found == tables_->groups.end()) return result;
  found->second.for_each([&](EntityRef e, bool) { result.push_back(e); });
  return result;
}

/// A run of splits that all come from one entity: its value is shared among all pieces at once.
void EntityAttributes::split(Tables& tables, std::span<const LineageEvent> run,
                             const std::function<bool(EntityRef)>& survives) {
  for (auto& [name, members] : tables.groups) {
    if (!members.contains(run.front().entity)) continue;
    for (const LineageEvent& e : run) members.set(e.other, true);
  }
  for (auto& [name, column] : tables.columns) {
    const AttributeValue* found = column->values.find(run.front().entity);
    if (found == nullptr || column->type.on_split == OnSplit::keep_old) continue;
    const AttributeValue value = *found;
    auto& values = edit_column(column).values;
    if (column->type.on_split == OnSplit::copy) {
      for (const LineageEvent& e : run) values.set(e.other, value);
      continue;
    }
    std::vector<EntityRef> pieces{run.front().entity};
    for (const LineageEvent& e : run) pieces.push_back(e.other);
    // What is gone when the operator is done has no measure and gets nothing, unless all are.
    if (std::any_of(pieces.begin(), pieces.end(), survives)) {
      std::vector<EntityRef> left;
      for (const EntityRef e : pieces) {
        if (survives(e)) {
          left.push_back(e);
        } else {
          values.erase(e);
        }
      }
      pieces = std::move(left);
    }
    std::vector<double> weights(pieces.size(), 1.0);
    double total = 0.0;
    if (column->type.weight) {
      for (std::size_t i = 0; i < pieces.size(); ++i) total += weights[i] = column->type.weight(pieces[i]);
    }
    if (!(total > 0.0) || !std::isfinite(total)) {
      std::fill(weights.begin(), weights.end(), 1.0);
      total = static_cast<double>(pieces.size());
    }
    double rest = std::get<double>(value);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double share = i + 1 == pieces.size() ? rest : std::get<double>(value) * (weights[i] / total);
      values.set(pieces[i], share);
      rest -= share;
    }
  }
}

AttributesApplied EntityAttributes::apply(std::span<const LineageEvent> events) {
  AttributesApplied result{{}, *this};
  if (events.empty() || (tables_->columns.empty() && tables_->groups.empty())) return result;
  Tables& tables = edit();
  std::set<EntityRef> gone;
  for (const LineageEvent& e : events) {
    if (e.kind == Kind::killed || e.kind == Kind::merged) gone.insert(e.entity);
    if (e.kind == Kind::made) gone.erase(e.entity);
    if (e.kind == Kind::split) gone.erase(e.other);
  }
  const auto survives = [&](EntityRef e) { return !gone.contains(e); };
  for (std::size_t i = 0; i < events.size();) {
    const LineageEvent& e = events[i];
    if (e.kind == Kind::split) {
      std::set<EntityRef> pieces{e.entity};
      std::size_t last = i;
      for (; last < events.size() && events[last].kind == Kind::split && pieces.contains(events[last].entity); ++last) {
        pieces.insert(events[last].other);
      }
      split(tables, events.subspan(i, last - i), survives);
      i = last;
      continue;
    }
    ++i;
    if (e.kind == Kind::made) continue;
    for (auto& [name, members] : tables.groups) {
      if (!members.erase(e.entity)) continue;
      if (e.kind == Kind::merged) members.set(e.other, true);
    }
    for (auto& [name, column] : tables.columns) {
      const AttributeValue* found = column->values.find(e.entity);
      if (found == nullptr) continue;
      const AttributeValue value = *found;
      auto& values = edit_column(column).values;
      values.erase(e.entity);
      if (e.kind == Kind::killed) continue;
      const AttributeValue* kept = values.find(e.other);
      if (kept == nullptr) {
        values.set(e.other, value);
        continue;
      }
      if (column->type.on_merge == OnMerge::must_agree && *kept != value) {
        result.conflicts.push_back({name, e.other, e.entity, *kept, value});
      }
      values.set(e.other, merge(column->type.on_merge, *kept, value));
    }
  }
  return result;
}

void EntityAttributes::take_back(const AttributesApplied& applied) {
  *this = applied.before;
}

void EntityAttributes::copy(std::span<const std::pair<EntityRef, EntityRef>> copies) {
  if (copies.empty()) return;
  Tables& tables = edit();
  for (auto& [name, members] : tables.groups) {
    for (const auto& [from, to] : copies) {
      if (members.contains(from)) members.set(to, true);
    }
  }
  for (auto& [name, column] : tables.columns) {
    if (column->type.on_copy == OnCopy::drop) continue;
    for (const auto& [from, to] : copies) {
      if (const AttributeValue* value = column->values.find(from)) {
        edit_column(column).values.set(to, AttributeValue(*value));
      }
    }
  }
}

bool EntityAttributes::operator==(const EntityAttributes& other) const {
  if (tables_ == other.tables_) return true;
  if (!(tables_->groups == other.tables_->groups) || tables_->columns.size() != other.tables_->columns.size()) {
    return false;
  }
  return std::equal(tables_->columns.begin(), tables_->columns.end(), other.tables_->columns.begin(),
                    [](const auto& a, const auto& b) {
                      return a.second == b.second ||
                             (same_rules(a.second->type, b.second->type) && a.second->values == b.second->values);
                    });
}

}  // namespace aresta
