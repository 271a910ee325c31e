// SPDX-License-Identifier: Apache-2.0
// The modeller's commands, by group.
#pragma once

#include "document/registry.h"

namespace aresta::document {

void register_solids(Registry& registry);
void register_sheets(Registry& registry);
void register_moves(Registry& registry);
void register_booleans(Registry& registry);
void register_access(Registry& registry);
void register_measures(Registry& registry);
void register_files(Registry& registry);
void register_topology(Registry& registry);

/// All of them.
void register_modelling(Registry& registry);

}  // namespace aresta::document
