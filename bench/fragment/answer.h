// SPDX-License-Identifier: Apache-2.0
// What a library answers to a problem, and how its time is taken.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <optional>
#include <vector>

namespace aresta::bench {

struct Answer {
  double seconds = 0;       ///< processor time, from operands to a result in the library's own terms
  std::uint64_t cells = 0;  ///< bounded cells of space, in operands or not; for booleans: solids of the result
  double volume = 0;        ///< of all these
  double solid_volume = 0;  ///< of the cells that lie in some operand; 0 where the library does not tell them apart
};

inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The median of up to five rounds, of as many as fit into two seconds but at least one; the last result. Short work is
/// done many times in a round, and what is made is kept until the clock has stopped.
template <class Run>
auto timed(double& seconds, Run&& run) {
  std::vector<decltype(run())> results;
  std::vector<double> rounds;
  double sum = 0;
  std::size_t repetitions = 1;
  do {
    results.clear();
    results.reserve(repetitions);
    const double before = processor_seconds();
    for (std::size_t i = 0; i < repetitions; ++i) results.push_back(run());
    const double round = processor_seconds() - before;
    sum += round;
    rounds.push_back(round / static_cast<double>(repetitions));
    if (round < 0.02 && repetitions < 100) {
      repetitions = std::min<std::size_t>(100, 1 + static_cast<std::size_t>(0.04 / std::max(rounds.back(), 1e-6)));
      rounds.clear();
    }
  } while (rounds.size() < 5 && sum < 2);
  std::sort(rounds.begin(), rounds.end());
  seconds = rounds[rounds.size() / 2];
  return std::move(results.back());
}

}  // namespace aresta::bench
