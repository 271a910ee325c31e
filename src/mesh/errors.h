// SPDX-License-Identifier: Apache-2.0
// What can go wrong while meshing. Numbers 800 to 899.
#pragma once

#include "base/result.h"

namespace aresta::errors {

inline constexpr ErrorCode mesh_bad_options{800, "mesh.bad_options"};
inline constexpr ErrorCode mesh_bad_input{801, "mesh.bad_input"};      ///< loops that do not close, points off surfaces
inline constexpr ErrorCode mesh_edge_failed{802, "mesh.edge_failed"};  ///< a curve that cannot be subdivided
inline constexpr ErrorCode mesh_face_boundary{803,
                                              "mesh.face_boundary"};   ///< a face's subdivided boundary crosses itself
inline constexpr ErrorCode mesh_face_failed{804, "mesh.face_failed"};  ///< a face whose mesh fails a check
inline constexpr ErrorCode mesh_surfaces_cross{805, "mesh.surfaces_cross"};  ///< surface meshes of two faces intersect
inline constexpr ErrorCode mesh_volume_failed{806, "mesh.volume_failed"};    ///< the volume mesher gave up
inline constexpr ErrorCode mesh_check_failed{807, "mesh.check_failed"};      ///< a finished volume mesh fails a check
inline constexpr ErrorCode mesh_embedded_wire{808,
                                              "mesh.embedded_wire"};  ///< a wire or point inside a region cannot be met

}  // namespace aresta::errors
