// SPDX-License-Identifier: Apache-2.0
// Attributes and groups of vertices, edges, faces and regions, which follow operators by rules declared once.
//
//   rule       value        on a split                              on a merge
//   split      copy         each piece gets the value
//              keep_old     only the old entity has it
//              share_out    a number is parted by weight
//   merge      keep_first                                           the kept one's; if it has none, the other's
//              sum, larger, smaller                                 of the two numbers; if only one has it, that one
//              must_agree                                           the kept one's, and a conflict when they differ
//   copying    copy | drop                                          onto the copies of entities
// A killed entity loses its attributes; taking the operator back restores them. Nothing is guessed: a made entity has
// no attributes.
//
// Groups: a split member is joined by its pieces; where one is merged, the kept one is a member if either was; a killed
// one leaves.
//
// Guarantees: a copy is O(1) and shares all that is not written afterwards (base/persistent_map.h), so that a snapshot
// before an operator costs nothing; take-back is exact because it goes back to that snapshot. Order in which attributes
// and groups were declared does not matter to what they hold. Shares are exact but for rounding: their sum is the value
// up to one rounding for each piece, and the last piece gets the rest.
//
// Not guaranteed: a vertex made in the middle of an edge, or an edge across a face, has nothing from what it lies on.
// Complexity: events times (attributes + groups), each O(log n).
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "base/persistent_map.h"
#include "topology/lineage.h"

namespace aresta {

/// A flag, a number or a text.
using AttributeValue = std::variant<bool, double, std::string>;
enum class AttributeKind { flag, number, text };

enum class OnSplit { copy, keep_old, share_out };
enum class OnMerge { keep_first, sum, larger, smaller, must_agree };
enum class OnCopy { copy, drop };

struct AttributeType {
  std::string name;
  AttributeKind kind = AttributeKind::text;
  OnSplit on_split = OnSplit::copy;
  OnMerge on_merge = OnMerge::keep_first;
  OnCopy on_copy = OnCopy::copy;
  /// The measure by which a value is shared out, as the operator left the entity; at least 0. Absent, or when all are
  /// 0: equal parts.
  std::function<double(EntityRef)> weight = {};
};

/// Two entities became one and disagreed.
struct AttributeConflict {
  std::string attribute;
  EntityRef kept, gone;
  AttributeValue kept_value, gone_value;
  bool operator==(const AttributeConflict&) const = default;
};

struct AttributesApplied;

class EntityAttributes {
 public:
  /// Errors: bad_rule, when a rule does not suit the kind (only numbers are shared out, summed or compared), or the
  /// name is taken by a type that differs.
  Status declare(const AttributeType& type);
  const AttributeType* type(const std::string& name) const;
  /// In order of their names.
  std::vector<std::string> attributes() const;

  /// Errors: unknown_attribute, wrong_value (of another kind than declared).
  Status set(EntityRef entity, const std::string& attribute, AttributeValue value);
  void unset(EntityRef entity, const std::string& attribute);
  /// Absent when the entity has none, or there is no such attribute.
  std::optional<AttributeValue> get(EntityRef entity, const std::string& attribute) const;
  /// All of an attribute, by entity.
  std::vector<std::pair<EntityRef, AttributeValue>> all(const std::string& attribute) const;

  void make_group(const std::string& group);
  void kill_group(const std::string& group);
  /// Makes the group if there is none.
  void add(const std::string& group, EntityRef entity);
  void remove(const std::string& group, EntityRef entity);
  bool contains(const std::string& group, EntityRef entity) const;
  std::vector<std::string> groups() const;
  std::vector<EntityRef> members(const std::string& group) const;  ///< growing

  /// Follows events in order, as lineage() gives them for one operator that has been applied.
  AttributesApplied apply(std::span<const LineageEvent> events);
  /// Back to what was before; what was set since then is lost too.
  void take_back(const AttributesApplied& applied);

  /// Each second entity is a copy of the first: gets its values as declared, and is a member of its groups.
  void copy(std::span<const std::pair<EntityRef, EntityRef>> copies);

  /// The same types by name, values and groups; weights are not compared.
  bool operator==(const EntityAttributes& other) const;

 private:
  struct Column {
    AttributeType type;
    PersistentMap<EntityRef, AttributeValue> values;
  };
  using Members = PersistentMap<EntityRef, bool>;
  struct Tables {
    std::map<std::string, std::shared_ptr<Column>> columns;
    std::map<std::string, Members> groups;
  };

  Tables& edit();
  Column& edit_column(std::shared_ptr<Column>& column);
  void split(Tables& tables, std::span<const LineageEvent> run, const std::function<bool(EntityRef)>& survives);

  std::shared_ptr<Tables> tables_ = std::make_shared<Tables>();
};

/// What following an operator gave: the disagreements, in order, and the way back.
struct AttributesApplied {
  std::vector<AttributeConflict> conflicts;
  EntityAttributes before;
};

}  // namespace aresta
