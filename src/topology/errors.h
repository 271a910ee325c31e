// SPDX-License-Identifier: Apache-2.0
// topology: 300-349
#pragma once

#include "base/result.h"

namespace aresta::errors {

inline constexpr ErrorCode bad_incidence{300, "topology.incidence"};
inline constexpr ErrorCode unknown_part{301, "topology.unknown_entity"};  ///< names something that does not exist
inline constexpr ErrorCode not_in_region{302, "topology.not_in_region"};  ///< does not touch the region
inline constexpr ErrorCode ambiguous_place{303, "topology.ambiguous"};    ///< several places are possible: name one
inline constexpr ErrorCode open_circuit{304, "topology.open_circuit"};    ///< edges that do not close
inline constexpr ErrorCode wrong_place{305, "topology.wrong_place"};      ///< not in this loop, face or cycle
inline constexpr ErrorCode in_use{306, "topology.in_use"};                ///< something still hangs on it
inline constexpr ErrorCode would_pinch{307, "topology.would_pinch"};      ///< the result would not enclose what it did
inline constexpr ErrorCode senses_disagree{308, "topology.senses_disagree"};  ///< orientations do not fit
inline constexpr ErrorCode cuts_wire{309, "topology.cuts_wire"};              ///< a wire would pass through a face

// Reading and writing.
inline constexpr ErrorCode bad_dump{310, "topology.dump"};                      ///< not of the grammar
inline constexpr ErrorCode dump_version{311, "topology.dump_version"};          ///< of a version that is not known
inline constexpr ErrorCode record_ids{312, "topology.record_ids"};              ///< too large, used twice or unknown
inline constexpr ErrorCode record_invariant{313, "topology.record_invariant"};  ///< what no complex can be
inline constexpr ErrorCode dump_differs{314, "topology.dump_not_canonical"};    ///< sound, but not as dump() writes it
inline constexpr ErrorCode bad_notation{315, "topology.notation"};              ///< not of the grammar
inline constexpr ErrorCode notation_model{316, "topology.notation_model"};  ///< unknown names, no order given, no model

inline constexpr ErrorCode no_space{320, "topology.no_space"};  ///< cannot be laid out in space

// Attributes.
inline constexpr ErrorCode unknown_attribute{330, "topology.unknown_attribute"};  ///< no attribute of this name
inline constexpr ErrorCode wrong_value{331, "topology.wrong_value"};              ///< of another kind than declared
inline constexpr ErrorCode bad_rule{332, "topology.bad_rule"};                    ///< does not suit the attribute

}  // namespace aresta::errors
