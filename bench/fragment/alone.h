// SPDX-License-Identifier: Apache-2.0
// One measurement in a process of its own: its peak of memory is known, and what aborts or never ends harms no other.
#pragma once

#include <functional>
#include <string>

#include "fragment/answer.h"

namespace aresta::bench {

struct Outcome {
  std::optional<Answer> answer;
  std::string reason;          ///< why there is no answer
  std::size_t peak_bytes = 0;  ///< resident memory of the process, operands and code included
};

/// `work` says by an exception that it was refused. It is ended after `most_seconds` of processor time.
Outcome run_alone(const std::function<Answer()>& work, double most_seconds);

}  // namespace aresta::bench
