// SPDX-License-Identifier: Apache-2.0
// What the writer and the reader of MSH files share.
#pragma once

#include <string>

#include "mesh/mesh.h"

namespace aresta::mesh_formats {

/// Gmsh's number of an element type.
int msh_type(ElementType type);

/// The group of an entity that is in no named set: "face_3".
std::string made_up_name(EntityRef entity);

}  // namespace aresta::mesh_formats
