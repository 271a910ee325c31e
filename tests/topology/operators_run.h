// SPDX-License-Identifier: Apache-2.0
// Random operators on a complex, each checked, all taken back: what the property test and the acceptance program run.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "topology/complex.h"

namespace aresta {

struct OperatorsTally {
  std::size_t applied = 0;
  std::size_t refused = 0;
  /// Operators that left what has no place in space (a closed surface in which a disc outside and a disc inside share
  /// one boundary): operators see to the order about each vertex, not to the whole. Runs end there. That there is no
  /// place is shown by homology each time: the faces enclose more voids than there are finite regions.
  std::size_t no_space = 0;
  std::map<std::string, std::size_t> sub_cases;  ///< "M_EV mev"
  std::map<std::string, std::size_t> refusals;   ///< "M_EV topology.not_in_region"
  std::map<std::string, std::size_t> displaced;  ///< "M_F mflrs": the first in a run that left no place in space
  std::map<std::string, std::size_t> ended;      ///< "M_F mfl", of no_space
  std::vector<std::string> wrong;                ///< messages

  /// All, one to a line.
  std::string histogram() const;
};

/// Tries random operators until `applications` of them were applied (or many more were tried), and takes them back. For
/// each asserts: one that refuses leaves the dump as it was; one that is applied leaves a structure without findings
/// (but for regions divided by killing, see above), counts that changed as it says and an Euler characteristic that
/// follows; it is taken back and made again to the same dumps. In the end each step back gives the dump seen on the
/// way. Stops at the first that is wrong.
void run_random_operators(Complex start, const std::string& name, std::uint64_t seed, std::size_t applications,
                          OperatorsTally& tally);

}  // namespace aresta
