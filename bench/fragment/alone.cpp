// SPDX-License-Identifier: Apache-2.0
#include "fragment/alone.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>

namespace aresta::bench {

namespace {

struct Message {
  bool answered = false;
  Answer answer;
  char reason[400] = {};
};

[[noreturn]] void work_and_tell(const std::function<Answer()>& work, double most_seconds, int pipe_end) {
  const auto whole = static_cast<rlim_t>(std::ceil(most_seconds));
  const rlimit limit{whole, whole + 5};
  setrlimit(RLIMIT_CPU, &limit);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  Message message;
  try {
    message.answer = work();
    message.answered = true;
  } catch (const std::exception& e) {
    std::snprintf(message.reason, sizeof message.reason, "refused: %s", e.what());
  } catch (...) {
    std::snprintf(message.reason, sizeof message.reason, "refused with an exception of its own");
  }
  const bool told = write(pipe_end, &message, sizeof message) == sizeof message;
  _exit(told ? 0 : 1);
}

}  // namespace

Outcome run_alone(const std::function<Answer()>& work, double most_seconds) {
  Outcome outcome;
  std::fflush(nullptr);
  int ends[2];
  if (pipe(ends) != 0) {
    outcome.reason = "no pipe to its process";
    return outcome;
  }
  const pid_t child = fork();
  if (child == 0) work_and_tell(work, most_seconds, ends[1]);
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    outcome.reason = "no process for it";
    return outcome;
  }
  Message message;
  const bool heard = read(ends[0], &message, sizeof message) == sizeof message;
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  outcome.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  if (heard && message.answered) {
    outcome.answer = message.answer;
  } else if (heard) {
    outcome.reason = message.reason;
  } else if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    outcome.reason = "no answer in " + std::to_string(static_cast<long>(most_seconds)) + " s";
  } else {
    outcome.reason = WIFSIGNALED(status) ? std::string("ended by ") + strsignal(WTERMSIG(status)) : "ended early";
  }
  return outcome;
}

}  // namespace aresta::bench
