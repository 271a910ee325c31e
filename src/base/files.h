// SPDX-License-Identifier: Apache-2.0
// Whole files in and out. A file that is written is either complete under its name or not there at all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/context.h"
#include "base/result.h"

namespace aresta {

/// Puts `data` into the file `path`, through a temporary file beside it that takes its name in one step once all bytes
/// are on the disk: after a failure (unknown folder, no permission, full disk) the old file is as it was and no
/// temporary one is left. A link is followed; an existing file keeps its permissions; a device or pipe is written to
/// directly. Error: file_unwritable, with the path and the system's reason.
Status write_file(const std::string& path, std::string_view data);

struct FileData {
  std::string path;
  std::string_view data;
};

/// write_file for files that belong together: none takes its name before the bytes of all are on the disk. What went to
/// devices and pipes cannot be taken back.
Status write_files(const std::vector<FileData>& files);

/// The error that write_file would end in, as far as it can be known beforehand.
Status check_writable(const std::string& path);

/// All bytes of a file; of a device or pipe at most 1 GB. Waiting for a pipe can be cancelled. Errors: file_unreadable,
/// with the path and the system's reason (a folder is not a file; more than `limit` bytes, as an endless device gives);
/// cancelled.
Result<std::string> read_file(const std::string& path, std::size_t limit = std::size_t{1} << 33,
                              const Context& context = {});

}  // namespace aresta
