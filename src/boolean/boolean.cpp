// SPDX-License-Identifier: Apache-2.0
#include "boolean/boolean.h"

#include <algorithm>
#include <chrono>

#include "boolean/errors.h"

namespace aresta {

namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Decisions decide_kind(const Surroundings& around, const std::vector<GroupCells>& groups,
                      const BooleanOptions& options) {
  const Regularisation regularisation{options.regularise, options.keep_partitions};
  switch (options.kind) {
    case BooleanKind::unite:
      return decide(around, groups, Operation::unite, regularisation);
    case BooleanKind::intersect:
      return decide(around, groups, Operation::intersect, regularisation);
    case BooleanKind::subtract:
      return decide(around, groups, Operation::subtract, regularisation);
    case BooleanKind::symmetric_difference:
      break;
  }
  std::vector<GroupCells> halves;
  halves.push_back(as_group(around, decide(around, groups, Operation::subtract, {}), "A - B"));
  halves.push_back(as_group(around, decide(around, {groups[1], groups[0]}, Operation::subtract, {}), "B - A"));
  return decide(around, halves, Operation::unite, regularisation);
}

Status check_group_count(const std::vector<GroupSpec>& groups, BooleanKind kind) {
  const bool many = kind == BooleanKind::unite || kind == BooleanKind::intersect;
  if (groups.size() >= 2 && (many || groups.size() == 2)) return {};
  return Error{errors::empty_group, "this operation takes " + std::string(many ? "two or more" : "exactly two") +
                                        " groups, given are " + std::to_string(groups.size())};
}

std::shared_ptr<const Provenance> provenance_of(const Fragment& fragment, const ExtractionMap& from) {
  const Provenance& all = *fragment.model->provenance;
  auto provenance = std::make_shared<Provenance>();
  provenance->sources = fragment.operands;
  const auto copy = [&](EntityRef entity, EntityRef source) {
    const auto parents = all.of(source);
    if (!parents.empty()) provenance->parents[entity].assign(parents.begin(), parents.end());
  };
  for (std::size_t i = 0; i < from.vertices.size(); ++i) copy(VertexId(i), from.vertices[i]);
  for (std::size_t i = 0; i < from.edges.size(); ++i) copy(EdgeId(i), from.edges[i]);
  for (std::size_t i = 0; i < from.faces.size(); ++i) copy(FaceId(i), from.faces[i]);
  return provenance;
}

/// A region of the result has as parents the listed regions that its cells lie in.
void add_region_parents(Provenance& provenance, const Fragment& fragment, const std::vector<GroupSpec>& groups,
                        const ExtractionMap& from, const Model& model) {
  std::vector<Parent> listed;
  for (const GroupSpec& g : groups) {
    for (const GroupMember& m : g.members) {
      if (m.entity.kind == EntityKind::region) listed.push_back({m.operand, m.entity});
    }
  }
  std::sort(listed.begin(), listed.end());
  for (std::size_t r = 1; r < from.regions.size(); ++r) {
    if (!model.is_region(RegionId(r))) continue;
    auto& parents = provenance.parents[RegionId(r)];
    for (const RegionId cell : from.regions[r]) {
      for (const Parent& p : fragment.parents(cell)) {
        if (std::binary_search(listed.begin(), listed.end(), p)) parents.push_back(p);
      }
    }
    std::sort(parents.begin(), parents.end());
    parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
  }
}

void count_classes(BooleanReport& report, const Decisions& decisions) {
  const std::vector<Decision>* all[] = {&decisions.vertices, &decisions.edges, &decisions.faces};
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    for (const Decision& d : *all[dimension]) {
      if (d.in_groups) ++report.class_counts[dimension][static_cast<std::size_t>(d.cls)];
    }
  }
}

}  // namespace

Result<BooleanResult> boolean(std::vector<std::shared_ptr<const Model>> operands, const std::vector<GroupSpec>& groups,
                              const BooleanOptions& options, const Context& context) {
  ARESTA_CHECK(check_group_count(groups, options.kind));
  Stopwatch watch;
  BooleanReport report;
  FragmentOptions fragment_options = options.fragment;
  fragment_options.detect_regions = false;
  ARESTA_TRY(Fragment pieces, fragment(std::move(operands), fragment_options, context));
  const auto shared = std::make_shared<const Fragment>(std::move(pieces));
  report.fragment_seconds = watch.lap();

  const Surroundings around(*shared->model);
  ARESTA_TRY(const auto cells, gather_groups(*shared, around, groups));
  Decisions decisions = decide_kind(around, cells, options);
  count_classes(report, decisions);
  report.select_seconds = watch.lap();

  auto extraction = extract(*shared->model, to_selection(decisions));
  if (!extraction.ok()) {
    Error error = extraction.error();
    error.code = errors::inconsistent_result;
    error.message = "the selected entities do not make a model: " + error.message;
    return error;
  }
  auto provenance = std::make_shared<Provenance>(*provenance_of(*shared, extraction->from));
  add_region_parents(*provenance, *shared, groups, extraction->from, extraction->model);
  extraction->model.provenance = provenance;
  report.conflicts = inherit_labels(extraction->model);
  report.extract_seconds = watch.lap();

  ARESTA_CHECK(require_valid(extraction->model, options.check, context));
  report.check_seconds = watch.lap();
  report.tolerance = extraction->model.tolerance();
  return BooleanResult{std::move(extraction->model), std::move(extraction->from), shared, std::move(decisions),
                       std::move(report)};
}

Result<Classification> classify(std::vector<std::shared_ptr<const Model>> operands,
                                const std::vector<GroupSpec>& groups, const FragmentOptions& options,
                                const Context& context) {
  ARESTA_CHECK(check_group_count(groups, BooleanKind::subtract));
  FragmentOptions fragment_options = options;
  fragment_options.detect_regions = false;
  ARESTA_TRY(Fragment pieces, fragment(std::move(operands), fragment_options, context));
  Classification result;
  result.fragment = std::make_shared<const Fragment>(std::move(pieces));
  const Surroundings around(*result.fragment->model);
  ARESTA_TRY(const auto cells, gather_groups(*result.fragment, around, groups));
  const Decisions decisions = decide(around, cells, Operation::unite, {});
  const auto add = [&](EntityRef entity, const Decision& d) {
    if (d.in_groups) result.classes.emplace_back(entity, d.cls);
  };
  for (std::size_t i = 0; i < decisions.vertices.size(); ++i) add(VertexId(i), decisions.vertices[i]);
  for (std::size_t i = 0; i < decisions.edges.size(); ++i) add(EdgeId(i), decisions.edges[i]);
  for (std::size_t i = 0; i < decisions.faces.size(); ++i) add(FaceId(i), decisions.faces[i]);
  return result;
}

}  // namespace aresta
