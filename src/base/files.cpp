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
#include <utility>

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

Error unwritable(const std::string& path, int reason) {
  return file_error(errors::file_unwritable, "cannot write", path, reason);
}

/// What stands under the name of a file to be written.
struct Place {
  bool exists = false;
  mode_t mode = 0;
  bool is_direct() const { return exists && !S_ISREG(mode); }  ///< a device or pipe
};

Result<Place> place_of(const std::string& path) {
  if (path.empty()) return unwritable(path, ENOENT);
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return Place{};
  if (S_ISDIR(info.st_mode)) return unwritable(path, EISDIR);
  if (::access(path.c_str(), W_OK) != 0) return unwritable(path, errno);
  return Place{true, info.st_mode};
}

Status write_directly(const FileData& file) {
  const int descriptor = ::open(file.path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return unwritable(file.path, errno);
  int reason = write_all(descriptor, file.data);
  if (::close(descriptor) != 0 && reason == 0) reason = errno;
  if (reason != 0) return unwritable(file.path, reason);
  return {};
}

/// All bytes of a file on the disk under a temporary name, which is gone with this unless it took the file's name.
class Staged {
 public:
  static Result<Staged> make(const std::string& path, std::string_view data, const Place& place) {
    Staged staged;
    staged.path_ = path;
    staged.target_ = place.exists ? resolved(path) : path;
    std::string name = staged.target_ + ".XXXXXX";
    const int file = ::mkstemp(name.data());
    if (file < 0) return unwritable(path, errno);
    staged.temporary_ = std::move(name);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    int reason = write_all(file, data);
    if (reason == 0 && ::fchmod(file, place.exists ? place.mode & 07777 : 0666 & ~mask) != 0) reason = errno;
    if (reason == 0 && ::fsync(file) != 0) reason = errno;
    if (::close(file) != 0 && reason == 0) reason = errno;
    if (reason != 0) return unwritable(path, reason);
    return staged;
  }
  Staged(Staged&& other) noexcept
      : path_(std::move(other.path_)),
        target_(std::move(other.target_)),
        temporary_(std::exchange(other.temporary_, {})) {}
  Staged(const Staged&) = delete;
  ~Staged() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }
  Status take_name() {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) return unwritable(path_, errno);
    temporary_.clear();
    return {};
  }

 private:
  Staged() = default;
  std::string path_, target_, temporary_;
};

}  // namespace

Status check_writable(const std::string& path) {
  ARESTA_TRY(const Place place, place_of(path));
  if (place.exists) return {};
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return unwritable(path, errno);
  return {};
}

Status write_files(const std::vector<FileData>& files) {
  std::vector<Staged> staged;
  std::vector<const FileData*> direct;
  for (const FileData& file : files) {
    ARESTA_TRY(const Place place, place_of(file.path));
    if (place.is_direct()) {
      direct.push_back(&file);
    } else {
      ARESTA_TRY(Staged one, Staged::make(file.path, file.data, place));
      staged.push_back(std::move(one));
    }
  }
  for (const FileData* file : direct) ARESTA_CHECK(write_directly(*file));
  for (Staged& one : staged) ARESTA_CHECK(one.take_name());
  return {};
}

Status write_file(const std::string& path, std::string_view data) {
  return write_files({{path, data}});
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
