// SPDX-License-Identifier: Apache-2.0
// The sub-commands of the program, each a function of its options that gives the exit status.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/context.h"
#include "document/registry.h"
#include "streams.h"

namespace aresta::app {

enum ExitStatus : int {
  status_done = 0,
  status_failed = 1,
  status_usage = 2,
  status_file = 3,
  status_findings = 4,
  status_interrupted = 130
};

/// What every sub-command takes.
struct Common {
  double tolerance = 0;
  int threads = 0;  ///< 0: as many as the machine has
  bool json = false;
  bool quiet = false;
  bool progress = false;  ///< asked for; also shown when standard error is a terminal
};

/// The program's state, handed to each sub-command.
struct Program {
  Common common;
  Context context;
  Output output;
};

inline constexpr ErrorCode usage_error{800, "usage", Failure::usage};

int exit_status(const Error& error);

/// "1.5", without an exponent's or a fraction's needless digits: for people; 17 significant digits for JSON.
std::string figure(double value);

/// Every command there is: the language's and the modeller's.
const document::Registry& all_commands();

struct RunOptions {
  std::string file;
  std::vector<std::string> definitions;
  std::string summary_file;
};
Result<int> run_script(Program& program, const RunOptions& options);

struct HelpOptions {
  std::string command;
  std::map<std::string, std::string> pages;  ///< of the program's own commands, by name
};
/// `aresta help [command]`: the commands of the language by group, or the page of one, or of one of the program's.
Result<int> show_help(Program& program, const HelpOptions& options);

}  // namespace aresta::app
