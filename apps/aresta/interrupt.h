// SPDX-License-Identifier: Apache-2.0
// Ctrl-C: the first asks the running operation to stop, the second ends the program at once.
#pragma once

#include <atomic>

namespace aresta::app {

/// Becomes true at the first interrupt (SIGINT, SIGTERM or SIGHUP). A second one exits with status 130.
const std::atomic<bool>& watch_interrupts();

}  // namespace aresta::app
