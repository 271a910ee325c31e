// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "boolean/boolean.h"
#include "construct/planar.h"
#include "fragment/peers.h"
#include "model/measure.h"

namespace aresta::bench {

namespace {

using Operand = std::shared_ptr<const Model>;

template <class T>
T value(Result<T> result) {
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(*result);
}

Operand to_model(const PolygonMesh& mesh) {
  ModelBuilder builder;
  PlanarParts parts(builder, mesh.points);
  for (const auto& face : mesh.faces) {
    parts.add_face(IndexLoop(face.begin(), face.end()));
    builder.set_fill(Fill::empty, Fill::filled);
  }
  return std::make_shared<const Model>(value(builder.build(Context{})));
}

/// All solids of a step are operands of one set operation.
Operand apply(const Operand& first, const std::vector<Operand>& others, bool is_difference) {
  std::vector<Operand> operands{first};
  std::vector<GroupSpec> groups{whole_operand("first", 0, *first), {"others", {}}};
  for (const Operand& other : others) {
    const auto members = whole_operand("", static_cast<std::uint32_t>(operands.size()), *other).members;
    groups[1].members.insert(groups[1].members.end(), members.begin(), members.end());
    operands.push_back(other);
  }
  BooleanOptions options;
  options.kind = is_difference ? BooleanKind::subtract : BooleanKind::unite;
  options.regularise = true;
  return std::make_shared<const Model>(value(boolean(operands, groups, options, {})).model);
}

}  // namespace

Answer chain_with_aresta(const Chain& chain) {
  const Operand first = to_model(chain.first);
  std::vector<std::vector<Operand>> steps;
  for (const auto& step : chain.steps) {
    auto& operands = steps.emplace_back();
    for (const PolygonMesh& mesh : step) operands.push_back(to_model(mesh));
  }
  Answer answer;
  const Operand result = timed(answer.seconds, [&] {
    Operand model = first;
    for (const auto& step : steps) model = apply(model, step, chain.is_difference);
    return model;
  });
  answer.cells = result->regions().size();
  answer.volume = answer.solid_volume = value(total_volume(*result));
  return answer;
}

}  // namespace aresta::bench
