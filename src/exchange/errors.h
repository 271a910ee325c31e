// SPDX-License-Identifier: Apache-2.0
// What can go wrong between files and models. Numbers 700 to 799; mesh formats use 750 to 799.
#pragma once

#include "base/result.h"

namespace aresta::errors {

inline constexpr ErrorCode unknown_format{700, "exchange.unknown_format", Failure::file};
inline constexpr ErrorCode bad_content{701, "exchange.content", Failure::file};
inline constexpr ErrorCode nothing_to_import{702, "exchange.nothing", Failure::file};
inline constexpr ErrorCode invalid_import{703, "exchange.invalid"};
inline constexpr ErrorCode export_failed{704, "exchange.export"};
inline constexpr ErrorCode unsupported_content{705, "exchange.unsupported", Failure::file};
inline constexpr ErrorCode exchange_bad_mesh{750, "exchange.bad_mesh"};  ///< a mesh that the format cannot hold
inline constexpr ErrorCode exchange_bad_mesh_file{751, "exchange.bad_mesh_file", Failure::file};

}  // namespace aresta::errors
