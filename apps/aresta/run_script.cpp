// SPDX-License-Identifier: Apache-2.0
// `aresta run`: a script, its variables, and the summary of what it did.
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>

#include "base/files.h"
#include "document/info.h"
#include "model/check.h"
#include "model_json.h"
#include "program.h"
#include "script/interpreter.h"

namespace aresta::app {

namespace {

constexpr std::size_t max_script_bytes = std::size_t{1} << 24;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::uint64_t peak_memory() {
  rusage usage{};
  return ::getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<std::uint64_t>(usage.ru_maxrss) * 1024 : 0;
}

/// Printed text by lines, as the summary lists it.
class Lines {
 public:
  void add(std::string_view text) {
    for (const char c : text) {
      if (c == '\n') {
        lines_.push_back(std::move(current_));
        current_.clear();
      } else {
        current_ += c;
      }
    }
  }
  std::vector<std::string> take() {
    if (!current_.empty()) lines_.push_back(std::move(current_));
    return std::move(lines_);
  }

 private:
  std::vector<std::string> lines_;
  std::string current_;
};

Status define(script::Interpreter& interpreter, const std::string& definition) {
  const std::size_t equals = definition.find('=');
  const std::string name = definition.substr(0, equals);
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  bool good = equals != std::string::npos && !name.empty() && letter(name[0]) && !script::is_keyword(name);
  for (const char c : name) good = good && (letter(c) || digit(c));
  if (!good)
    return Error{usage_error, "-D takes name=value, with a name of letters, digits and _, not '" + definition + "'"};
  interpreter.set(name, script::value_of_definition(definition.substr(equals + 1)));
  return {};
}

/// Figures of the last model that the script made, null when there is none or they cannot be had.
Json model_figures(const document::ShapePtr& shape) {
  const auto x = std::dynamic_pointer_cast<const document::ModelShape>(shape);
  if (!x) return nullptr;
  const auto model = document::as_model(*x, {});
  if (!model) return nullptr;
  const auto info = document::model_info(*model, {});
  if (!info) return nullptr;
  Json json{{"regions", info->regions},   {"shells", info->shells}, {"faces", info->faces}, {"edges", info->edges},
            {"vertices", info->vertices}, {"volume", info->volume}, {"area", info->area}};
  const auto findings = check(**model, CheckLevel::full);
  json["findings"] = findings ? Json(findings->size()) : Json(nullptr);
  return json;
}

/// Two names of one regular file.
bool same_file(const std::string& a, const std::string& b) {
  struct stat of_a {
  }, of_b{};
  return ::stat(a.c_str(), &of_a) == 0 && ::stat(b.c_str(), &of_b) == 0 && S_ISREG(of_a.st_mode) &&
         of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
}

}  // namespace

Result<int> run_script(Program& program, const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const bool standard_input = options.file == "-";
  if (same_file(options.file, options.summary_file))
    return Error{usage_error, "--summary-file '" + options.summary_file + "' is the script itself"};
  ARESTA_TRY(const std::string text, standard_input ? read_standard_input(program.context)
                                                    : read_file(options.file, max_script_bytes, program.context));
  if (!options.summary_file.empty() && options.summary_file != "-") ARESTA_CHECK(check_writable(options.summary_file));

  Lines printed;
  Json commands = Json::array();
  document::Session session;
  session.registry = &all_commands();
  session.context = program.context;
  session.digits = program.output.is_terminal() ? document::Digits::shortest : document::Digits::seventeen;
  session.tolerance = program.common.tolerance;
  const bool wants_summary = !options.summary_file.empty() || program.common.json;
  session.print = [&](const std::string& s) -> Status {
    if (wants_summary) printed.add(s);
    return program.common.json ? Status{} : program.output.write(s);
  };
  script::Interpreter interpreter(session);
  document::ShapePtr last_shape;
  session.finished = [&](const document::Command& command, double seconds, const document::Value* result) {
    if (wants_summary) {
      commands.push_back(
          {{"line", interpreter.line()}, {"command", command.name}, {"seconds", seconds}, {"ok", result != nullptr}});
    }
    if (result != nullptr && result->is(document::Value::Kind::shape)) last_shape = result->shape();
  };
  for (const std::string& definition : options.definitions) ARESTA_CHECK(define(interpreter, definition));

  Status status = interpreter.run(text, standard_input ? "<stdin>" : options.file);
  if (Status flushed = program.output.flush(); status && !flushed) status = std::move(flushed);

  if (wants_summary) {
    Json summary;
    summary["version"] = ARESTA_VERSION;
    summary["ok"] = status.ok();
    if (!status) summary["error"] = status.error().to_line();
    summary["seconds"] = seconds_since(start);
    summary["peak_rss_bytes"] = peak_memory();
    summary["threads"] = program.context.threads;
    summary["commands"] = std::move(commands);
    summary["printed"] = printed.take();
    summary["model"] = model_figures(last_shape);
    const std::string json = json_text(summary);
    if (!options.summary_file.empty()) {
      Status written =
          options.summary_file == "-" ? program.output.write(json) : write_file(options.summary_file, json);
      if (status && !written) status = std::move(written);
    }
    if (program.common.json) {
      Status written = program.output.write(json);
      if (status && !written) status = std::move(written);
    }
  }
  if (!status) return std::move(status.error());
  return static_cast<int>(status_done);
}

}  // namespace aresta::app
