// SPDX-License-Identifier: Apache-2.0
// A model whose parts meet without knowing it, taken apart so that they can be imprinted on each other.
//
// Each region is a part of its own with its faces (voids and sheets inside included); faces of no region, wires and
// isolated points are one more part. What two parts share already is in both of them and becomes one again by identity.
#pragma once

#include <memory>
#include <vector>

#include "base/context.h"
#include "model/extract.h"

namespace aresta {

struct ModelPart {
  std::shared_ptr<const Model> model;
  ExtractionMap from;
};

Result<std::vector<ModelPart>> split_into_parts(const Model& model);

/// Does the full checker find entities that meet without being shared, or regions that lie in each other?
Result<bool> meets_unshared(const Model& model, const Context& context);

}  // namespace aresta
