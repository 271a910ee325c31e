// SPDX-License-Identifier: Apache-2.0
#include "exchange/join_parts.h"

#include "fragment/fragment.h"
#include "fragment/parts.h"

namespace aresta {

Result<Model> join_touching_parts(Model model, ImportReport& report, const Context& context) {
  ARESTA_TRY(const bool meets, meets_unshared(model, context));
  if (!meets) return model;
  const double length_unit = model.length_unit;
  FragmentOptions options;
  options.detect_regions = false;
  ARESTA_TRY(const Fragment joined, fragment({std::make_shared<const Model>(std::move(model))}, options, context));
  Model result = *joined.model;
  result.provenance = nullptr;
  result.length_unit = length_unit;
  report.notes.push_back("parts that touch were joined, so that they share what they have in common");
  return result;
}

}  // namespace aresta
