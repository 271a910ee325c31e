// SPDX-License-Identifier: Apache-2.0
// Standard input and output with their failures met: a closed output, a reader that went away, a full disk.
#pragma once

#include <string>
#include <string_view>

#include "base/context.h"

namespace aresta::app {

/// To be called first: a standard descriptor that the caller left closed is opened on nothing, so that no file takes
/// its number; writing to a pipe without reader becomes an error instead of ending the program.
void prepare_streams();

/// Buffered standard output.
class Output {
 public:
  /// Error: file_unwritable.
  Status write(std::string_view text);
  Status flush();
  bool is_terminal() const;

 private:
  std::string buffer_;
};

/// The whole of standard input. Errors: file_unreadable, cancelled.
Result<std::string> read_standard_input(const Context& context);

/// One line to standard error, that of a running progress display overwritten. Line ends inside become spaces.
void report(std::string_view line);

/// Shows progress on standard error while it is a terminal: `stage` and how far it is.
void show_progress(double fraction, std::string_view stage);
void clear_progress();

}  // namespace aresta::app
