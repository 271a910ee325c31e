// SPDX-License-Identifier: Apache-2.0
// Independent pieces of work over the threads that a context allows. Results go to slots of their own, so that nothing
// depends on who came first.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "base/context.h"

namespace aresta::draw {

/// work(i) for i in [0, n); progress is reported by the calling thread only. Error: cancelled.
template <class Work>
Status parallel_for(const Context& context, std::size_t n, std::string_view stage, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  const auto help = [&] {
    for (std::size_t i; !stop && !context.cancelled() && (i = next++) < n;) work(i);
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < context.threads && std::size_t(t) < n; ++t) helpers.emplace_back(help);
  Status status;
  for (std::size_t i; (i = next++) < n;) {
    status = context.step(double(i) / double(n), stage);
    if (!status.ok()) break;
    work(i);
  }
  stop = !status.ok();
  for (std::thread& t : helpers) t.join();
  if (status.ok() && context.cancelled()) status = context.step(1, stage);
  return status;
}

}  // namespace aresta::draw
