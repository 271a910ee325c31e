// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/result.h"

namespace aresta::errors {  // occt: 500-549

inline constexpr ErrorCode to_shape_failed{500, "occt.to_shape"};
inline constexpr ErrorCode to_model_failed{501, "occt.to_model"};
inline constexpr ErrorCode solids_overlap{502, "occt.solids_overlap"};
inline constexpr ErrorCode general_fuse_failed{503, "occt.general_fuse"};
inline constexpr ErrorCode tessellation_failed{504, "occt.tessellate"};

}  // namespace aresta::errors
