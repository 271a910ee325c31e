// SPDX-License-Identifier: Apache-2.0
// What the writer and the reader of MSH files share.
#pragma once

#include <string>

#include "mesh/mesh.h"

namespace aresta::mesh_formats {

/// Gmsh's number of an element type.
int msh_type(ElementType type);

/// The group of a region without a name.
std::string made_up_region_name(std::uint32_t index);

}  // namespace aresta::mesh_formats
