// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "planar/errors.h"  // cluster_too_wide

namespace aresta::errors {  // fragment: 550-599

inline constexpr ErrorCode no_operands{550, "fragment.no_operands"};
inline constexpr ErrorCode imprint_failed{551, "fragment.imprint_failed"};
inline constexpr ErrorCode label_conflict{552, "fragment.label_conflict"};
inline constexpr ErrorCode not_conserved{553, "fragment.not_conserved"};

}  // namespace aresta::errors
