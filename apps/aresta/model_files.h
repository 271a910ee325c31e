// SPDX-License-Identifier: Apache-2.0
// Models from files and into them, with "-" for standard input and output, by commands of the registry.
#pragma once

#include <string>
#include <vector>

#include "document/shape.h"
#include "program.h"

namespace aresta::app {

/// A shape and the file that it goes to.
struct ShapeOutput {
  document::Value shape;
  std::string file, format;
};

/// Calls commands of the registry one by one.
class Commands {
 public:
  explicit Commands(Program& program);

  Result<document::Value> call(const std::string& name, std::vector<document::Value> positional,
                               std::vector<std::pair<std::string, document::Value>> keywords = {});

  /// The shape in a file. `format` is needed for standard input.
  Result<document::Value> import(const std::string& file, const std::string& format, bool check = true);

  /// Calls `command` (export or render) for a file. Standard output gets the bytes once they are all there.
  Status write(const std::string& command, const document::Value& shape, const std::string& file,
               const std::string& format, std::vector<std::pair<std::string, document::Value>> keywords = {});

  /// Exports shapes that belong together: all of the files are there afterwards, or none.
  Status export_all(const std::vector<ShapeOutput>& outputs);

  /// The single model behind a shape.
  static std::shared_ptr<Model> model_of(const document::Value& shape);

 private:
  /// What `command` writes to `file`, which may be "-".
  Result<std::string> bytes(const std::string& command, const document::Value& shape, const std::string& file,
                            const std::string& format, std::vector<std::pair<std::string, document::Value>> keywords);

  Program& program_;
  document::Session session_;
};

/// Standard input can be read only once. Error: usage_error.
Status check_inputs(const std::vector<std::string>& inputs);

/// What a sub-command writes.
enum class Product { model, mesh, picture };

/// Whether the name and the format of an output go with what is written there, and a file can be put there: asked
/// before the work begins, so that nobody waits for a refusal. `in` is the input's name, for the advice. Errors:
/// usage_error, file_unwritable.
Status check_output(Product product, const std::string& in, const std::string& out, const std::string& format);

/// A file of its own in the folder for temporary files, gone when this is: also when a second Ctrl-C ends the program.
class TemporaryFile {
 public:
  /// Error: file_unwritable.
  static Result<TemporaryFile> make(const std::string& extension);
  ~TemporaryFile();
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  TemporaryFile() = default;
  std::string folder_, path_;
};

}  // namespace aresta::app
