// SPDX-License-Identifier: Apache-2.0
// Reads what dump() writes (dump.h says its grammar).
#pragma once

#include <string_view>

#include "base/result.h"
#include "topology/complex.h"
#include "topology/errors.h"

namespace aresta {

/// The exact inverse of dump: what is read gives the same text again, blanks and comments apart, with the same ids and
/// gaps. Any bytes may come: whatever is not the dump of a valid complex is refused with its line, with what was
/// expected there or what breaks which invariant. Memory in proportion to the text (ids are limited, records.h).
/// Errors: bad_dump, dump_version, record_ids, record_invariant, dump_differs.
Result<Complex> parse_dump(std::string_view text);

}  // namespace aresta
