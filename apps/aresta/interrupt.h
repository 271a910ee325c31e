// SPDX-License-Identifier: Apache-2.0
// Ctrl-C: the first asks the running operation to stop, the second ends the program at once.
#pragma once

#include <atomic>
#include <string>

namespace aresta::app {

/// Becomes true at the first interrupt (SIGINT, SIGTERM or SIGHUP). A second one, a quarter of a second or
/// more later, exits with status 130.
const std::atomic<bool>& watch_interrupts();

/// A file in a folder of its own that a second interrupt removes before it ends the program; one at a time.
void remember_temporary(const std::string& file, const std::string& folder);
void forget_temporary();

}  // namespace aresta::app
