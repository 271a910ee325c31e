// SPDX-License-Identifier: Apache-2.0
// From shapes to the operands and groups of a fragment: every model among the arguments is one operand.
#pragma once

#include <memory>
#include <vector>

#include "boolean/groups.h"
#include "document/shape.h"

namespace aresta::document {

struct Operands {
  std::vector<std::shared_ptr<const Model>> models;
  std::vector<std::shared_ptr<Model>> owners;  ///< the same, for shapes to refer to
  std::vector<GroupSpec> groups;               ///< one per shape
};

/// Half-spaces become blocks that cover the other operands. Errors: command.type for meshes, and for half-spaces where
/// `bounded` says that the result would reach to infinity.
Result<Operands> gather_operands(const Call& call, const std::vector<ShapePtr>& shapes);

}  // namespace aresta::document
