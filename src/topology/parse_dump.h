// SPDX-License-Identifier: Apache-2.0
// Reads what dump() writes (dump.h says its grammar).
#pragma once

#include <string_view>

#include "base/result.h"
#include "topology/complex.h"

namespace aresta {

namespace errors {
inline constexpr ErrorCode bad_dump{310, "topology.dump"};                    ///< not of the grammar
inline constexpr ErrorCode dump_version{311, "topology.dump_version"};        ///< of a version that is not known
inline constexpr ErrorCode dump_differs{314, "topology.dump_not_canonical"};  ///< sound, but not as dump() writes it
}  // namespace errors

/// The exact inverse of dump: what is read gives the same text again, blanks and comments apart, with the same ids and
/// gaps. Any bytes may come: whatever is not the dump of a valid complex is refused with its line, with what was
/// expected there or what breaks which invariant. Memory in proportion to the text (ids are limited, records.h).
/// Errors: bad_dump, dump_version, record_ids, record_invariant, dump_differs.
Result<Complex> parse_dump(std::string_view text);

}  // namespace aresta
