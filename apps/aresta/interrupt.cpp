// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

namespace aresta::app {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// Plain memory: a signal handler may use nothing else. Filled before the flag is set.
char temporary_file[4096];
char temporary_folder[4096];
std::atomic<bool> has_temporary{false};

std::atomic<std::int64_t> first_time{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t milliseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{1000} * now.tv_sec + now.tv_nsec / 1000000;
}

extern "C" void on_interrupt(int) {
  if (!interrupted.exchange(true)) {
    first_time = milliseconds();
    return;
  }
  // One signal may come twice, as timeout(1) sends it to the program and to its process group.
  if (milliseconds() - first_time < 250) return;
  if (has_temporary) {
    ::unlink(temporary_file);
    ::rmdir(temporary_folder);
  }
  ::_exit(130);
}

}  // namespace

void remember_temporary(const std::string& file, const std::string& folder) {
  if (file.size() >= sizeof temporary_file || folder.size() >= sizeof temporary_folder) return;
  std::memcpy(temporary_file, file.c_str(), file.size() + 1);
  std::memcpy(temporary_folder, folder.c_str(), folder.size() + 1);
  has_temporary = true;
}

void forget_temporary() {
  has_temporary = false;
}

const std::atomic<bool>& watch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // nohup switches this one off, and it stays off.
    struct sigaction old {};
    if (signal == SIGHUP && ::sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) continue;
    ::sigaction(signal, &action, nullptr);
  }
  return interrupted;
}

}  // namespace aresta::app
