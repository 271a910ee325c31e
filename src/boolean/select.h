// SPDX-License-Identifier: Apache-2.0
// Steps 2 and 3 of a boolean: classify every vertex, edge and face of the groups, and decide what is kept.
//
// Everything is imprinted, so one decision holds for a whole entity, and the cells' labels already tell which regions
// contain it: no geometric query at all. Linear in entities times groups.
#pragma once

#include "boolean/groups.h"
#include "boolean/table.h"
#include "model/extract.h"

namespace aresta {

/// Why an entity was kept or removed.
enum class Reason : std::uint8_t {
  not_in_groups,  ///< no group holds it
  table,          ///< a row of the table
  support,        ///< it bounds something kept
  leftover,       ///< the table kept it, but it would float inside the result
  regularised     ///< taken away by regularisation
};

struct Decision {
  bool in_groups = false;
  Class cls = Class::a_out_b;
  std::uint8_t sides = 0;  ///< faces: sides in the result's volume
  Rule rule = Rule::remove;
  Reason reason = Reason::not_in_groups;
  bool kept = false;
};

struct Decisions {
  std::vector<Decision> vertices, edges, faces;
  std::vector<bool> volume;      ///< per cell: part of the result
  std::vector<bool> constraint;  ///< per face: kept though it bounds no listed region
};

struct Regularisation {
  bool regularise = false;
  bool keep_partitions = false;  ///< keep the faces between adjoining regions of the result
};

/// Decides for all groups at once; subtract takes exactly two.
Decisions decide(const Surroundings& around, const std::vector<GroupCells>& groups, Operation operation,
                 const Regularisation& regularisation);

/// The kept entities as a group again, so that expressions are evaluated on one fragment. Regions: components of kept
/// cells.
GroupCells as_group(const Surroundings& around, const Decisions& decisions, std::string name);

Selection to_selection(const Decisions& decisions);

}  // namespace aresta
