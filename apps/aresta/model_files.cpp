// SPDX-License-Identifier: Apache-2.0
#include "model_files.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <initializer_list>

#include "base/files.h"
#include "interrupt.h"

namespace aresta::app {

using document::Value;

namespace {

/// "step" of "a/b.step".
std::string ending(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  return extension.empty() ? extension : extension.substr(1);
}

/// The user knows nothing of temporary files: what an error says of one is said of `name`.
void name_as(Error& error, const std::string& temporary, const std::string& name) {
  for (const std::string& words : {"the file " + temporary, temporary}) {
    if (const auto at = error.message.find(words); at != std::string::npos)
      error.message.replace(at, words.size(), name);
  }
}

}  // namespace

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
  if (!shape) name_as(shape.error(), temporary.path(), "standard input");
  return shape;
}

Result<std::string> Commands::bytes(const std::string& command, const Value& shape, const std::string& file,
                                    const std::string& format, std::vector<std::pair<std::string, Value>> keywords) {
  const bool standard = file == "-";
  if (standard && format.empty()) return Error{usage_error, "standard output needs --format, as in --format step"};
  ARESTA_TRY(const TemporaryFile temporary, TemporaryFile::make(format.empty() ? ending(file) : format));
  keywords.emplace_back("format", Value(format));
  if (auto done = call(command, {shape, Value(temporary.path())}, std::move(keywords)); !done) {
    name_as(done.error(), temporary.path(), standard ? "standard output" : file);
    return std::move(done.error());
  }
  return read_file(temporary.path());
}

Status Commands::write(const std::string& command, const Value& shape, const std::string& file,
                       const std::string& format, std::vector<std::pair<std::string, Value>> keywords) {
  if (file != "-") {
    keywords.emplace_back("format", Value(format));
    ARESTA_CHECK(call(command, {shape, Value(file)}, std::move(keywords)));
    return {};
  }
  ARESTA_TRY(const std::string data, bytes(command, shape, file, format, std::move(keywords)));
  ARESTA_CHECK(program_.output.write(data));
  return program_.output.flush();
}

Status Commands::export_all(const std::vector<ShapeOutput>& outputs) {
  std::vector<std::string> data;
  for (const ShapeOutput& o : outputs) {
    ARESTA_TRY(std::string one, bytes("export", o.shape, o.file, o.format, {}));
    data.push_back(std::move(one));
  }
  std::vector<FileData> files;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].file == "-") {
      ARESTA_CHECK(program_.output.write(data[i]));
    } else {
      files.push_back({outputs[i].file, data[i]});
    }
  }
  // First what can fail without a trace.
  ARESTA_CHECK(program_.output.flush());
  return write_files(files);
}

Status check_inputs(const std::vector<std::string>& inputs) {
  if (std::count(inputs.begin(), inputs.end(), "-") < 2) return {};
  return Error{usage_error, "'-' is given twice, but standard input can be read only once"};
}

Status check_output(Product product, const std::string& in, const std::string& out, const std::string& format) {
  if (out.empty()) return Error{usage_error, "the name of the output is empty"};
  if (out == "-" && format.empty()) return Error{usage_error, "standard output needs --format, as in --format step"};
  std::string word = format.empty() ? ending(out) : format;
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto is_one_of = [&](std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
  };
  const bool picture = is_one_of({"png", "svg", "html"}), mesh = is_one_of({"inp", "msh", "msh2", "vtu"});
  const bool good = product == Product::picture ? picture : product == Product::mesh ? mesh : !picture && !mesh;
  if (good) return out == "-" ? Status{} : check_writable(out);
  const std::string from = in.empty() ? "IN" : in, to = " -o " + out + (format.empty() ? "" : " --format " + format);
  std::string message = product == Product::picture ? "a picture is written as png, svg or html"
                        : product == Product::mesh  ? "a mesh is written as inp, msh, msh2 or vtu"
                                                    : "a model is written as step, brep, stl or obj";
  message += word.empty() ? ", and '" + out + "' has no ending that tells" : ", not as '" + word + "'";
  const char* verb = picture ? "aresta render " : mesh ? "aresta mesh " : nullptr;
  return Error{.code = usage_error, .message = std::move(message), .hint = verb == nullptr ? "" : verb + from + to};
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
