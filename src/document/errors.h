// SPDX-License-Identifier: Apache-2.0
// Errors of the command registry: 900-929.
#pragma once

#include "base/result.h"

namespace aresta::errors {

inline constexpr ErrorCode command_unknown{900, "command.unknown"};
inline constexpr ErrorCode command_too_many{901, "command.too_many_arguments"};
inline constexpr ErrorCode command_missing{902, "command.missing_argument"};
inline constexpr ErrorCode command_unknown_parameter{903, "command.unknown_parameter"};
inline constexpr ErrorCode command_repeated{904, "command.repeated_argument"};
inline constexpr ErrorCode command_type{905, "command.type"};
inline constexpr ErrorCode command_range{906, "command.range"};
inline constexpr ErrorCode command_not_finite{907, "command.not_finite"};

}  // namespace aresta::errors
