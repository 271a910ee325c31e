// SPDX-License-Identifier: Apache-2.0
// Small complexes of every kind, for tests that must hold for all of them.
#pragma once

#include <vector>

#include "topology/complex.h"

namespace aresta {

struct CatalogueModel {
  const char* name;
  Complex complex;
};

/// All of them, always in the same order.
std::vector<CatalogueModel> catalogue();

/// One of them, which must be there.
Complex catalogue_model(const char* name);

}  // namespace aresta
