// SPDX-License-Identifier: Apache-2.0
// Errors of the script language: 930-999.
#pragma once

#include "base/result.h"

namespace aresta::errors {

inline constexpr ErrorCode script_syntax{930, "script.syntax"};
inline constexpr ErrorCode script_unsupported{931, "script.unsupported"};  ///< Python, but not in the subset
inline constexpr ErrorCode script_not_text{932, "script.not_text"};
inline constexpr ErrorCode script_too_deep{933, "script.too_deep"};
inline constexpr ErrorCode script_too_large{934, "script.too_large"};
inline constexpr ErrorCode script_name{935, "script.name"};
inline constexpr ErrorCode script_type{936, "script.type"};
inline constexpr ErrorCode script_value{937, "script.value"};
inline constexpr ErrorCode script_index{938, "script.index"};
inline constexpr ErrorCode script_zero_division{939, "script.zero_division"};
inline constexpr ErrorCode script_overflow{940, "script.overflow"};
inline constexpr ErrorCode script_unpack{941, "script.unpack"};
inline constexpr ErrorCode script_assertion{942, "script.assertion"};
inline constexpr ErrorCode script_expectation{943, "script.expectation"};

}  // namespace aresta::errors
