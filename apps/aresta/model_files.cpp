// SPDX-License-Identifier: Apache-2.0
#include "model_files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "base/files.h"
#include "interrupt.h"

namespace aresta::app {

using document::Value;

Commands::Commands(Program& program) : program_(program) {
  session_.registry = &all_commands();
  session_.context = program.context;
  session_.tolerance = program.common.tolerance;
}

Result<Value> Commands::call(const std::string& name, std::vector<Value> positional,
                             std::vector<std::pair<std::string, Value>> keywords) {
  const document::Command* command = session_.registry->find(name);
  if (command == nullptr) return Error{errors::internal, "there is no command " + name};
  return document::invoke(*command, {.positional = std::move(positional), .keywords = std::move(keywords)}, session_);
}

Result<Value> Commands::import(const std::string& file, const std::string& format, bool check) {
  if (file != "-") return call("import_file", {Value(file)}, {{"format", Value(format)}, {"check", Value(check)}});
  if (format.empty()) return Error{usage_error, "standard input needs --format, as in --format step"};
  ARESTA_TRY(const std::string data, read_standard_input(program_.context));
  ARESTA_TRY(const TemporaryFile temporary, TemporaryFile::make(format));
  ARESTA_CHECK(write_file(temporary.path(), data));
  auto shape = call("import_file", {Value(temporary.path())}, {{"format", Value(format)}, {"check", Value(check)}});
  if (!shape) {
    // The user knows nothing of the temporary file.
    std::string& message = shape.error().message;
    if (const auto at = message.find(temporary.path()); at != std::string::npos)
      message.replace(at, temporary.path().size(), "standard input");
  }
  return shape;
}

Status Commands::write(const std::string& command, const Value& shape, const std::string& file,
                       const std::string& format, std::vector<std::pair<std::string, Value>> keywords) {
  keywords.emplace_back("format", Value(format));
  if (file != "-") {
    ARESTA_CHECK(call(command, {shape, Value(file)}, std::move(keywords)));
    return {};
  }
  if (format.empty()) return Error{usage_error, "standard output needs --format, as in --format step"};
  ARESTA_TRY(const TemporaryFile temporary, TemporaryFile::make(format));
  ARESTA_CHECK(call(command, {shape, Value(temporary.path())}, std::move(keywords)));
  ARESTA_TRY(const std::string data, read_file(temporary.path()));
  ARESTA_CHECK(program_.output.write(data));
  return program_.output.flush();
}

std::shared_ptr<Model> Commands::model_of(const Value& shape) {
  return std::dynamic_pointer_cast<const document::ModelShape>(shape.shape())->parts().at(0).model;
}

Result<TemporaryFile> TemporaryFile::make(const std::string& extension) {
  const char* place = std::getenv("TMPDIR");
  std::string folder = std::string(place != nullptr && *place != '\0' ? place : "/tmp") + "/aresta.XXXXXX";
  if (::mkdtemp(folder.data()) == nullptr) {
    return Error{errors::file_unwritable, "cannot make a temporary folder " + folder + ": " + std::strerror(errno)};
  }
  TemporaryFile file;
  file.folder_ = folder;
  file.path_ = folder + "/model." + extension;
  remember_temporary(file.path_, file.folder_);
  return file;
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : folder_(std::move(other.folder_)), path_(std::move(other.path_)) {
  other.folder_.clear();
}

TemporaryFile::~TemporaryFile() {
  if (folder_.empty()) return;
  ::unlink(path_.c_str());
  ::rmdir(folder_.c_str());
  forget_temporary();
}

}  // namespace aresta::app
