// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fragment/engine.h"
#include "occt/general_fuse.h"

namespace aresta {

namespace {

std::vector<std::vector<Parent>> to_parents(const std::vector<std::vector<FuseParent>>& all) {
  std::vector<std::vector<Parent>> result;
  result.reserve(all.size());
  for (const auto& list : all) {
    auto& parents = result.emplace_back();
    for (const FuseParent& p : list) parents.push_back({p.operand, p.entity});
    std::sort(parents.begin(), parents.end());
    parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
  }
  return result;
}

class OcctEngine final : public FragmentEngine {
 public:
  const char* name() const override { return "occt"; }

  Result<Imprint> imprint(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                          const Context& context) const override {
    ARESTA_TRY(const FuseInput input, side_by_side(operands));
    ARESTA_TRY(FuseResult fused, general_fuse(input, tolerance, context));
    return Imprint{std::move(fused.builder), to_parents(fused.vertices), to_parents(fused.edges),
                   to_parents(fused.faces)};
  }
};

}  // namespace

const FragmentEngine& occt_engine() {
  static const OcctEngine engine;
  return engine;
}

}  // namespace aresta
