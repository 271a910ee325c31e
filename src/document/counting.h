// SPDX-License-Identifier: Apache-2.0
// Counts and genus of shapes.
#pragma once

#include <cstdint>

#include "document/shape.h"

namespace aresta::document {

/// Sets of entities connected by their boundaries.
std::size_t component_count(const Part& part);
/// The listed entities by component, in the order of each one's first.
std::vector<std::vector<EntityRef>> components(const Part& part);

/// Shells of the part's finite regions.
std::size_t shell_count(const Part& part);

/// The sum of the genera of the closed surfaces that bound the part's regions; where it has no region, of those that
/// its faces make around empty space. Surfaces that touch in an edge or vertex are taken as the two that they are when
/// one goes around on one side; a dangling sheet is part of the surface that goes around it.
std::int64_t genus(const Part& part);

}  // namespace aresta::document
