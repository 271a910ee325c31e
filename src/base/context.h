// SPDX-License-Identifier: Apache-2.0
// What every long function takes: progress out, cancellation in, and how many threads it may use.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

#include "base/result.h"

namespace aresta {

struct Context {
  /// Called with a fraction in [0, 1] of the running stage and its name; may be empty. Called from one thread at a
  /// time.
  std::function<void(double fraction, std::string_view stage)> progress = {};
  /// Set by another thread or a signal handler to ask the operation to stop; may be null.
  const std::atomic<bool>* cancel = nullptr;
  int threads = 1;

  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }

  /// Reports progress and answers errors::cancelled when asked to stop. Call it at least every few milliseconds.
  Status step(double fraction, std::string_view stage) const {
    if (cancelled()) return Error{errors::cancelled, "the operation was cancelled while in: " + std::string(stage)};
    if (progress) progress(fraction, stage);
    return {};
  }
};

}  // namespace aresta
