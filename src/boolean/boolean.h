// SPDX-License-Identifier: Apache-2.0
// Boolean operations between groups of entities of any dimension: the library's entry point.
//
//   imprint (fragment.h) -> gather (groups.h) -> classify and decide (select.h, table.h) -> extract -> check
//
// Contract. Operands are not changed. The result is a model of the same kind, its regions known from the cells' labels;
// what was kept though it bounds no listed region is a constraint of the result. A result that fails the checker is
// never returned. An empty result is a valid model of volume 0.
#pragma once

#include "boolean/select.h"
#include "model/check.h"
#include "model/inherit.h"

namespace aresta {

enum class BooleanKind : std::uint8_t { unite, intersect, subtract, symmetric_difference };

struct BooleanOptions {
  BooleanKind kind = BooleanKind::unite;
  bool regularise = false;
  bool keep_partitions = false;  ///< with regularise: keep the faces between adjoining regions of the result
  FragmentOptions fragment;
  CheckLevel check = CheckLevel::fast;
};

struct BooleanReport {
  std::array<std::array<std::size_t, 5>, 3> class_counts{};  ///< [dimension][class]
  double fragment_seconds = 0, select_seconds = 0, extract_seconds = 0, check_seconds = 0;
  double tolerance = 0;
  std::vector<LabelConflict> conflicts;
};

struct BooleanResult {
  Model model;         ///< provenance leads to the operands
  ExtractionMap from;  ///< entities of `model` to entities of `fragment->model`
  std::shared_ptr<const Fragment> fragment;
  Decisions decisions;  ///< for every entity of the fragment
  BooleanReport report;
};

/// Groups refer to entities of `operands`. Unite and intersect take two or more groups, the others exactly two.
/// Errors: those of fragment; empty_group; regions_overlap; unknown_member; inconsistent_result; model.invalid.
Result<BooleanResult> boolean(std::vector<std::shared_ptr<const Model>> operands, const std::vector<GroupSpec>& groups,
                              const BooleanOptions& options, const Context& context);

/// Step 2 alone, for two groups: the class of every vertex, edge and face of the fragment that a group holds.
struct Classification {
  std::shared_ptr<const Fragment> fragment;
  std::vector<std::pair<EntityRef, Class>> classes;  ///< sorted by entity of fragment->model
};
Result<Classification> classify(std::vector<std::shared_ptr<const Model>> operands,
                                const std::vector<GroupSpec>& groups, const FragmentOptions& options,
                                const Context& context);

}  // namespace aresta
