// SPDX-License-Identifier: Apache-2.0
#include "streams.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace aresta::app {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;
bool progress_shown = false;
std::chrono::steady_clock::time_point progress_time{};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

void prepare_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    // Opened the wrong way round, so that using it still fails.
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
      static_cast<void>(::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY));
    }
  }
}

bool Output::is_terminal() const {
  return ::isatty(STDOUT_FILENO) == 1;
}

Status Output::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size || (is_terminal() && text.find('\n') != std::string_view::npos)) return flush();
  return {};
}

Status Output::flush() {
  if (buffer_.empty()) return {};
  clear_progress();
  const bool done = write_all(STDOUT_FILENO, buffer_);
  const int reason = errno;
  buffer_.clear();
  if (done) return {};
  return Error{errors::file_unwritable, std::string("cannot write to standard output: ") +
                                            (reason == EBADF ? "it is closed" : std::strerror(reason))};
}

Result<std::string> read_standard_input(const Context& context) {
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    // Waits in short steps, so that it can be interrupted whatever the signal does to read().
    pollfd waiting{STDIN_FILENO, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, 100);
    ARESTA_CHECK(context.step(0, "reading standard input"));
    if (ready == 0) continue;
    const ssize_t n = ::read(STDIN_FILENO, buffer, sizeof buffer);
    if (n == 0) return text;
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      return Error{errors::file_unreadable, std::string("cannot read standard input: ") +
                                                (errno == EBADF ? "it is closed" : std::strerror(errno))};
    }
    text.append(buffer, static_cast<std::size_t>(n));
    if (text.size() > (std::size_t{1} << 31))
      return Error{errors::file_unreadable, "standard input is larger than 2 GB"};
  }
}

void report(std::string_view line) {
  clear_progress();
  std::string text(line);
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  static_cast<void>(write_all(STDERR_FILENO, text + "\n"));
}

void show_progress(double fraction, std::string_view stage) {
  const auto now = std::chrono::steady_clock::now();
  if (now - progress_time < std::chrono::milliseconds(100)) return;
  progress_time = now;
  progress_shown = true;
  char text[160];
  std::snprintf(text, sizeof text, "\r\x1b[K%3.0f %% %.*s", 100 * fraction,
                static_cast<int>(std::min<std::size_t>(stage.size(), 70)), stage.data());
  static_cast<void>(write_all(STDERR_FILENO, text));
}

void clear_progress() {
  if (!progress_shown) return;
  progress_shown = false;
  static_cast<void>(write_all(STDERR_FILENO, "\r\x1b[K"));
}

}  // namespace aresta::app
