// SPDX-License-Identifier: Apache-2.0
// How the operands of a case meet: what the random cases have covered.
//
// Two entities of different operands meet in the lattice pieces that lie in the relative interior of both. The kind of
// contact is their dimensions, that of what they share, and whether that is all of one of them. Regions are filled
// ones. Beside pairs: situations of the result that single pairs do not show.
#pragma once

#include <map>

#include "fragment/oracle/enumeration.h"

namespace aresta::grid {

/// All kinds that are counted, in the order in which they are printed.
const std::vector<std::string>& contact_kinds();

/// Adds to each kind's count how often it occurs.
void count_contacts(const Recipe& recipe, const Enumeration& e, std::map<std::string, std::size_t>& counts);

}  // namespace aresta::grid
