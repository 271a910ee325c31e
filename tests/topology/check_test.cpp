// SPDX-License-Identifier: Apache-2.0
#include "topology/check.h"

#include <gtest/gtest.h>

#include "catalogue.h"

namespace aresta {
namespace {

TEST(CheckStructure, FindsNothingInTheCatalogue) {
  for (const CatalogueModel& model : catalogue()) {
    for (const auto& finding : check_structure(model.complex)) ADD_FAILURE() << model.name << ": " << describe(finding);
  }
}

}  // namespace
}  // namespace aresta
