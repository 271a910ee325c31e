// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/trial.h"

#include <algorithm>

#include "fragment/oracle/operand_model.h"
#include "model/check.h"
#include "model/copy.h"

namespace aresta::grid {

namespace {

bool plant_label(Fragment& fragment) {
  std::vector<std::vector<Parent>> labels;
  bool planted = false;
  for (const RegionId c : fragment.model->topology().regions()) {
    const auto of_cell = fragment.labels.of(c);
    labels.emplace_back(of_cell.begin(), of_cell.end());
    if (planted || of_cell.empty()) continue;
    labels.back().pop_back();
    planted = true;
  }
  fragment.labels = CellLabels(std::move(labels));
  return planted;
}

bool plant_parent(Fragment& fragment) {
  if (fragment.model->topology().face_count() == 0) return false;
  Model model = *fragment.model;
  Provenance less = *model.provenance;
  const auto last = static_cast<std::uint32_t>(model.topology().face_count() - 1);
  less.parents[FaceId(last)].pop_back();
  model.provenance = std::make_shared<const Provenance>(std::move(less));
  fragment.model = std::make_shared<const Model>(std::move(model));
  return true;
}

bool plant_sense(Fragment& fragment) {
  if (fragment.same_sense.empty()) return false;
  fragment.same_sense.back().back().flip();
  return true;
}

bool plant_fill(Fragment& fragment) {
  const Model& model = *fragment.model;
  const Complex& k = model.topology();
  if (k.region_count() < 2) return false;
  ModelBuilder builder = to_builder(model);
  std::vector<std::uint32_t> radial;
  for (const CoedgeId c : k.coedges()) radial.push_back(k.radial(c).value);
  builder.set_radial_order(std::move(radial));
  builder.provenance = model.provenance;
  Cells cells;
  cells.count = static_cast<std::uint32_t>(k.region_count());
  for (const FaceId f : k.faces()) {
    for (int side = 0; side < 2; ++side) cells.of_face_use.push_back(k.region(FaceUse(f, side)).value);
  }
  const auto region_or_none = [&](ShellId s) { return s.valid() ? k.region(s).value : Incidence::none; };
  for (const EdgeId e : k.edges()) cells.of_edge.push_back(region_or_none(k.wire_shell(e)));
  for (const VertexId v : k.vertices()) cells.of_vertex.push_back(region_or_none(k.isolated_in_shell(v)));
  std::vector<bool> filled;
  for (const RegionId r : k.regions()) filled.push_back(k.is_filled(r));
  filled.back().flip();
  auto built = builder.build(cells, filled);
  if (!built.ok()) return false;
  fragment.model = std::make_shared<const Model>(std::move(*built));
  return true;
}

bool plant_piece(Fragment& fragment) {
  std::array<std::vector<std::vector<Parent>>, 3> parents;
  const Complex& k = fragment.model->topology();
  const auto copy = [&](EntityRef entity, std::vector<std::vector<Parent>>& to) {
    const auto of = fragment.parents(entity);
    to.emplace_back(of.begin(), of.end());
  };
  for (const VertexId v : k.vertices()) copy(v, parents[0]);
  for (const EdgeId e : k.edges()) copy(e, parents[1]);
  for (const FaceId f : k.faces()) copy(f, parents[2]);
  if (parents[2].empty()) return false;
  parents[2].front().pop_back();
  fragment.piece_table = PieceTable(fragment.operands, {&parents[0], &parents[1], &parents[2]});
  return true;
}

bool plant(Fault fault, Fragment& fragment) {
  switch (fault) {
    case Fault::label:
      return plant_label(fragment);
    case Fault::parent:
      return plant_parent(fragment);
    case Fault::sense:
      return plant_sense(fragment);
    case Fault::fill:
      return plant_fill(fragment);
    case Fault::piece:
      return plant_piece(fragment);
    case Fault::none:
      break;
  }
  return false;
}

}  // namespace

std::optional<Fault> fault_named(const std::string& name) {
  constexpr const char* names[] = {"none", "label", "parent", "sense", "fill", "piece"};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    if (name == names[i]) return static_cast<Fault>(i);
  }
  return std::nullopt;
}

Verdict try_recipe(const Recipe& recipe, const Enumeration& expected, const FragmentOptions& options, Fault fault) {
  Verdict verdict;
  std::vector<std::shared_ptr<const Model>> operands;
  for (const GridOperand& operand : expected.operands) {
    auto model = to_model(operand, recipe.turn);
    if (!model.ok()) {
      verdict.refusal = model.error();
      verdict.refusal->message = "an operand cannot be built: " + verdict.refusal->message;
      return verdict;
    }
    operands.push_back(std::make_shared<const Model>(std::move(*model)));
  }
  auto found = fragment(std::move(operands), options, {});
  if (!found.ok()) {
    verdict.refusal = found.error();
    return verdict;
  }
  verdict.planted = plant(fault, *found);
  verdict.differences = compare(expected, *found);
  if (verdict.differences.empty()) return verdict;
  const Status valid = require_valid(*found->model, CheckLevel::full);
  if (!valid.ok()) verdict.finding = valid.error();
  return verdict;
}

Verdict try_recipe(const Recipe& recipe, const FragmentOptions& options, Fault fault) {
  return try_recipe(recipe, enumerate(recipe), options, fault);
}

}  // namespace aresta::grid
