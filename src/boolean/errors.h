// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/result.h"

namespace aresta::errors {  // boolean: 650-699

inline constexpr ErrorCode empty_group{650, "boolean.too_few_groups"};
inline constexpr ErrorCode regions_overlap{651, "boolean.regions_overlap"};
inline constexpr ErrorCode unknown_member{652, "boolean.unknown_member"};
inline constexpr ErrorCode inconsistent_result{653, "boolean.inconsistent_result"};

}  // namespace aresta::errors
