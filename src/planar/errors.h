// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/result.h"

namespace aresta::errors {  // planar: 350-399

inline constexpr ErrorCode cluster_too_wide{350, "planar.cluster_too_wide"};
inline constexpr ErrorCode face_not_planar{351, "planar.face_not_planar"};
inline constexpr ErrorCode planar_unresolved{352, "planar.unresolved"};
inline constexpr ErrorCode faces_coincide{353, "planar.faces_coincide"};
inline constexpr ErrorCode nesting_undecided{354, "planar.nesting_undecided"};
inline constexpr ErrorCode mesh_open{355, "planar.mesh_open"};
inline constexpr ErrorCode mesh_inconsistent{356, "planar.mesh_inconsistent"};

}  // namespace aresta::errors
