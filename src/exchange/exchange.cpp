// SPDX-License-Identifier: Apache-2.0
#include "exchange/exchange.h"

#include <filesystem>

#include "base/files.h"
#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/join_parts.h"
#include "exchange/recognize_forms.h"

namespace aresta {

namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 33;

struct Format {
  const char* name;
  const char* extensions;  // each with a space before and after
  Result<Model> (*read)(const ReadArguments&);
  Result<std::string> (*write)(const Model&, const ExportOptions&, const Context&);
};

constexpr Format formats[] = {
    {"step", " step stp p21 ", read_step, write_step},
    {"brep", " brep brp ", read_brep, write_brep},
    {"stl", " stl ", read_stl, write_stl},
    {"obj", " obj ", read_obj, write_obj},
    {"ply", " ply ", read_ply, nullptr},
    {"off", " off ", read_off, nullptr},
};

const Format* find(const std::string& word) {
  for (const Format& format : formats) {
    if (std::string(format.extensions).find(" " + word + " ") != std::string::npos) return &format;
  }
  return nullptr;
}

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

Result<const Format*> choose(const std::string& path, const std::string& given) {
  if (path.empty()) return Error{errors::unknown_format, "the name of the file is empty"};
  std::string word = lower(given.empty() ? std::filesystem::path(path).extension().string() : given);
  if (!word.empty() && word.front() == '.') word.erase(0, 1);
  if (const Format* format = find(word)) return format;
  const std::string what = word.empty() ? "has no extension that tells its format"
                                        : "has the format \"" + word + "\", which is not known for models";
  return Error{errors::unknown_format,
               "the file " + path + " " + what,
               {},
               {},
               "step, brep, stl, obj; and to read also ply and off"};
}

}  // namespace

Result<std::string> format_of(const std::string& path, const std::string& given) {
  ARESTA_TRY(const Format* format, choose(path, given));
  return std::string(format->name);
}

Result<Model> import_file(const std::string& path, const ImportOptions& options, const Context& context) {
  ARESTA_TRY(const Format* format, choose(path, options.format));
  ARESTA_TRY(const std::string data, read_file(path, max_bytes, context));
  ImportReport report;
  report.format = format->name;
  if (data.empty()) return Error{errors::bad_content, "the file " + path + " is empty"};
  Result<Model> read = format->read({data, options, report, context});
  if (!read.ok()) {
    Error error = std::move(read).error();
    if (error.code.failure == Failure::file) error.message = path + ": " + error.message;
    return error;
  }
  ARESTA_TRY(*read, recognize_forms(std::move(*read), report, context));
  if (options.join) {
    ARESTA_TRY(*read, join_touching_parts(std::move(*read), report, context));
  }
  if (options.check) {
    Status valid = require_valid(*read, options.level, context);
    if (!valid.ok()) {
      if (valid.error().code == errors::cancelled) return valid.error();
      Error error = valid.error();
      error.code = errors::invalid_import;
      error.message = path + ": " + error.message;
      return error;
    }
  }
  if (options.report != nullptr) *options.report = std::move(report);
  return read;
}

Status export_file(const Model& model, const std::string& path, const ExportOptions& options, const Context& context) {
  ARESTA_TRY(const Format* format, choose(path, options.format));
  if (format->write == nullptr) {
    return Error{errors::unknown_format,
                 "the format " + std::string(format->name) + " can be read but not written",
                 {},
                 {},
                 "step, brep, stl, obj"};
  }
  ARESTA_TRY(const std::string data, format->write(model, options, context));
  return write_file(path, data);
}

}  // namespace aresta
