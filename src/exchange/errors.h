// SPDX-License-Identifier: Apache-2.0
// What can go wrong between files and models. Numbers 700 to 799; mesh formats use 750 to 799.
#pragma once

#include "base/result.h"

namespace aresta::errors {

inline constexpr ErrorCode exchange_bad_mesh{750, "exchange.bad_mesh"};  ///< a mesh that the format cannot hold
inline constexpr ErrorCode exchange_bad_mesh_file{751, "exchange.bad_mesh_file", Failure::file};

}  // namespace aresta::errors
