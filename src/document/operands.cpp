// SPDX-License-Identifier: Apache-2.0
#include "document/operands.h"

#include <algorithm>

#include "construct/primitives.h"
#include "document/construction.h"

namespace aresta::document {

Result<Operands> gather_operands(const Call& call, const std::vector<ShapePtr>& shapes) {
  Box3 box;
  for (const ShapePtr& s : shapes) {
    if (const auto* x = dynamic_cast<const ModelShape*>(s.get())) {
      for (const Part& part : x->parts()) box.add(part.model->bounds());
    }
  }
  Operands out;
  const auto operand = [&](const std::shared_ptr<Model>& model) {
    const auto found = std::find(out.owners.begin(), out.owners.end(), model);
    if (found != out.owners.end()) return static_cast<std::uint32_t>(found - out.owners.begin());
    out.models.push_back(model);
    out.owners.push_back(model);
    return static_cast<std::uint32_t>(out.owners.size() - 1);
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string name = i < 26 ? std::string(1, static_cast<char>('A' + i)) : "operand " + std::to_string(i);
    if (const auto* half = dynamic_cast<const HalfSpaceShape*>(shapes[i].get())) {
      if (box.empty()) box.add(half->point());
      ARESTA_TRY(Model block, half_space_block({half->point(), half->normal()}, box, construct_options(call)));
      const auto model = std::make_shared<Model>(std::move(block));
      const std::uint32_t o = operand(model);
      out.groups.push_back(whole_operand(name, o, *model));
      continue;
    }
    ARESTA_TRY(const ModelShapePtr x, model_shape(call, shapes[i], "operand " + std::to_string(i + 1)));
    GroupSpec group;
    group.name = x->name().empty() ? name : x->name();
    for (const Part& part : x->parts()) {
      const std::uint32_t o = operand(part.model);
      for (const EntityRef e : part.entities) group.members.push_back({o, e});
    }
    out.groups.push_back(std::move(group));
  }
  return out;
}

}  // namespace aresta::document
