// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace aresta {
namespace {

Error file_error(ErrorCode code, const char* what, const std::string& path, int reason) {
  if (path.empty()) return Error{code, std::string(what) + " '': the name of the file is empty"};
  return Error{code, std::string(what) + " " + path + ": " + std::strerror(reason)};
}

/// 0, or the system's error number.
int write_all(int file, std::string_view data) {
  while (!data.empty()) {
    const ssize_t n = ::write(file, data.data(), data.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    data.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

/// The file that a chain of links ends in, so that the link survives the exchange of names.
std::string resolved(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string result = real;
  std::free(real);
  return result;
}

/// False for what is there by a link of the system's alone, as /dev/stdin may be.
bool is_named(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  std::free(real);
  return real != nullptr;
}

}  // namespace

Status write_file(const std::string& path, std::string_view data) {
  const auto failed = [&](int reason) { return file_error(errors::file_unwritable, "cannot write", path, reason); };
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return failed(EISDIR);

  if (exists && !S_ISREG(old.st_mode)) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) return failed(errno);
    int reason = write_all(file, data);
    if (::close(file) != 0 && reason == 0) reason = errno;
    if (reason != 0) return failed(reason);
    return {};
  }
  if (exists && ::access(path.c_str(), W_OK) != 0) return failed(errno);

  const std::string target = exists ? resolved(path) : path;
  std::string temporary = target + ".XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) return failed(errno);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  int reason = write_all(file, data);
  if (reason == 0 && ::fchmod(file, exists ? old.st_mode & 07777 : 0666 & ~mask) != 0) reason = errno;
  if (reason == 0 && ::fsync(file) != 0) reason = errno;
  if (::close(file) != 0 && reason == 0) reason = errno;
  if (reason == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) reason = errno;
  if (reason != 0) {
    ::unlink(temporary.c_str());
    return failed(reason);
  }
  return {};
}

Result<std::string> read_file(const std::string& path, std::size_t limit, const Context& context) {
  const auto failed = [&](int reason) { return file_error(errors::file_unreadable, "cannot read", path, reason); };
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return failed(errno);
  if (S_ISDIR(info.st_mode)) return failed(EISDIR);
  // A pipe is opened without waiting for its other end, and waited for in short steps: one with a name until something
  // comes, as nobody may have opened its other end yet.
  const bool waits = !S_ISREG(info.st_mode);
  const bool has_name = S_ISFIFO(info.st_mode) && is_named(path);
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | (waits ? O_NONBLOCK : 0));
  if (file < 0) return failed(errno);
  if (waits) limit = std::min(limit, std::size_t{1} << 30);
  std::string data;
  char buffer[1 << 16];
  int reason = 0;
  Status status;
  for (;;) {
    if (status = context.step(0, "reading a file"); !status.ok()) break;
    if (waits) {
      pollfd waiting{file, POLLIN, 0};
      if (::poll(&waiting, 1, 100) == 0) continue;
    }
    const ssize_t n = ::read(file, buffer, sizeof buffer);
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (n < 0) reason = errno;
    if (n == 0 && has_name && data.empty()) {
      ::poll(nullptr, 0, 20);
      continue;
    }
    if (n <= 0) break;
    data.append(buffer, static_cast<std::size_t>(n));
    if (data.size() > limit) reason = EFBIG;
    if (reason != 0) break;
  }
  ::close(file);
  ARESTA_CHECK(status);
  if (reason != 0) return failed(reason);
  return data;
}

}  // namespace aresta
