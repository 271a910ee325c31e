// SPDX-License-Identifier: Apache-2.0
// Runs the program as a user does, through a shell, and looks at what it says and leaves.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/paths.h"

namespace aresta::app {

struct Outcome {
  int status = -1;
  std::string out, err;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline void put(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// A folder for one test, and commands run in it: "aresta" in a command is the program.
class Shell {
 public:
  explicit Shell(const std::string& name) : folder_(test::output_folder(name)) {}

  const std::filesystem::path& folder() const { return folder_; }

  Outcome operator()(const std::string& command) const {
    const std::string program = test::program().string();
    const std::string line = "cd '" + folder_.string() + "' && aresta() { '" + program + "' \"$@\"; } && ( " + command +
                             " ) > .out 2> .err < /dev/null";
    const int status = std::system(line.c_str());
    Outcome outcome;
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = text_of(folder_ / ".out");
    outcome.err = text_of(folder_ / ".err");
    return outcome;
  }

  /// The files that are there, apart from what the tests themselves put, sorted, one a line.
  std::string files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string name = entry.path().filename();
      if (name[0] != '.') names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    std::string text;
    for (const std::string& n : names) text += n + "\n";
    return text;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace aresta::app
