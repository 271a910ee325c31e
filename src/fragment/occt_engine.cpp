// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fragment/errors.h"
#include "fragment/identity.h"
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

Result<FuseInput> to_input(const Imprint& imprint, std::size_t operands) {
  FuseInput input;
  input.operands = operands;
  const auto translate = [](const std::vector<std::vector<Parent>>& all) {
    std::vector<std::vector<FuseParent>> result(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const Parent& p : all[i]) result[i].push_back({p.source, p.entity});
    }
    return result;
  };
  input.vertices = translate(imprint.vertex_parents);
  input.edges = translate(imprint.edge_parents);
  input.faces = translate(imprint.face_parents);
  ModelBuilder builder = imprint.builder;
  ARESTA_TRY(Model model, builder.provisional());
  input.model = std::make_shared<const Model>(std::move(model));
  return input;
}

Result<Imprint> fuse(const FuseInput& input, double tolerance, const Context& context) {
  ARESTA_TRY(FuseResult fused, general_fuse(input, tolerance, context));
  return Imprint{
      std::move(fused.builder), to_parents(fused.vertices), to_parents(fused.edges), to_parents(fused.faces), {}};
}

class OcctEngine final : public FragmentEngine {
 public:
  const char* name() const override { return "occt"; }

  Result<Imprint> imprint(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                          const Context& context) const override {
    ARESTA_TRY(const Identity identity, unite_coincident(operands, tolerance, context));
    ARESTA_TRY(FuseInput input, to_input(identity.imprint, operands.size()));
    for (std::size_t f = 0; f < input.faces.size(); ++f) {
      for (std::size_t i = 0; i < input.faces[f].size(); ++i) input.faces[f][i].opposite = identity.opposite[f][i];
    }
    return fuse(input, tolerance, context);
  }

  /// An edge in the planes of faces of two other operands at once is missed in one of them now and then. Once it is
  /// there as an edge of the other's pieces, it is found.
  bool has_second_try() const override { return true; }
  Result<Imprint> again(const Imprint& imprint, std::size_t operands, double tolerance,
                        const Context& context) const override {
    ARESTA_TRY(const FuseInput input, to_input(imprint, operands));
    return fuse(input, tolerance, context);
  }
};

}  // namespace

Result<Imprint> FragmentEngine::again(const Imprint&, std::size_t, double, const Context&) const {
  return Error{errors::imprint_failed, std::string("the engine ") + name() + " has one round only"};
}

const FragmentEngine& occt_engine() {
  static const OcctEngine engine;
  return engine;
}

}  // namespace aresta
