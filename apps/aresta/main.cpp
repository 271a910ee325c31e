// SPDX-License-Identifier: Apache-2.0
// The program `aresta`: reads the command line, runs one sub-command, turns errors into one line and an exit status.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <new>
#include <thread>

#include "interrupt.h"
#include "program.h"

namespace aresta::app {

namespace {

constexpr const char* description =
    "Aresta: solids, sheets and wires as boundary representations, manifold or not; booleans between groups of them,\n"
    "meshes and pictures.";

constexpr const char* epilogue =
    "Examples:\n"
    "  aresta run plate.ars                      run a script\n"
    "  aresta help                               the commands of scripts; 'aresta help block' for one of them\n"
    "\n"
    "'aresta COMMAND --help' explains a command. '-' stands for standard input or output.\n"
    "Exit status: 0 done, 1 the operation or the script failed, 2 wrong usage, 3 a file cannot be read or written,\n"
    "4 the checker found something, 130 interrupted.";

/// The words of one sub-command: what it is called, what its help says.
CLI::App* add_command(CLI::App& app, Common& common, const char* name, const char* text, const char* examples) {
  CLI::App* sub = app.add_subcommand(name, text);
  sub->footer(examples);
  const char* group = "Common options";
  sub->add_option("--tolerance", common.tolerance, "points closer than this are one (document units; default: the model's own)")
      ->group(group)
      ->check([](const std::string& text_given) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text_given, value) && std::isfinite(value) && value > 0;
        return good ? std::string() : "it must be a number greater than 0";
      });
  sub->add_option("--threads", common.threads, "how many threads to use (default: all)")->group(group)->check(CLI::Range(1, 1024));
  sub->add_flag("--json", common.json, "results as JSON")->group(group);
  sub->add_flag("--quiet,-q", common.quiet, "only results and errors")->group(group);
  sub->add_flag("--progress", common.progress, "show progress (default: when the output is a terminal)")->group(group);
  return sub;
}

int main_in_words(int argc, char** argv) {
  Program program;
  CLI::App app(description, "aresta");
  app.footer(epilogue);
  app.set_version_flag("--version", "aresta " ARESTA_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);

  RunOptions run;
  CLI::App* run_command = add_command(app, program.common, "run", "Run a script.",
                                      "Examples:\n"
                                      "  aresta run plate.ars\n"
                                      "  aresta run plate.ars -D holes=4 -D 'name=\"lid\"' --summary-file plate.json\n"
                                      "  echo 'print(volume(block(1, 2, 3)))' | aresta run -\n"
                                      "\n"
                                      "The language is a subset of Python; 'aresta help' lists its commands.");
  run_command->add_option("FILE", run.file, "the script; - for standard input")->required();
  run_command->add_option("-D,--define", run.definitions, "a variable that is set before the script starts, as name=value")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  run_command->add_option("--summary-file", run.summary_file, "a JSON file for times, printed lines and the last model's figures")
      ->type_name("OUT.json");

  HelpOptions help;
  CLI::App* help_command = add_command(app, program.common, "help", "Explain the commands of scripts.",
                                       "Examples:\n  aresta help\n  aresta help cylinder");
  help_command->add_option("NAME", help.command, "a command of the script language");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const CLI::App* shown = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
    return program.output.write(shown->help("", CLI::AppFormatMode::Normal)) && program.output.flush() ? status_done : status_file;
  } catch (const CLI::CallForVersion& version) {
    return program.output.write(std::string(version.what()) + "\n") && program.output.flush() ? status_done : status_file;
  } catch (const CLI::ParseError& error) {
    const bool sub = !app.get_subcommands().empty();
    std::string text = error.what();
    if (!sub && argc > 1 && argv[1][0] != '-') {
      text = std::string("unknown command '") + argv[1] + "'";
      std::vector<std::string> names;
      for (const CLI::App* s : app.get_subcommands({})) names.push_back(s->get_name());
      if (const std::string near = document::nearest_name(argv[1], names); !near.empty()) text += "; did you mean '" + near + "'?";
    }
    report("aresta: " + text + "; see: aresta " + (sub ? app.get_subcommands().front()->get_name() + " " : "") + "--help");
    return status_usage;
  }

  Common& common = program.common;
  if (common.threads == 0) common.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  program.context.threads = common.threads;
  program.context.cancel = &watch_interrupts();
  if (common.progress || (!common.quiet && ::isatty(STDERR_FILENO) == 1)) program.context.progress = show_progress;

  Result<int> status = run_command->parsed() ? run_script(program, run) : show_help(program, help);
  if (auto flushed = program.output.flush(); !flushed && status) status = std::move(flushed.error());
  clear_progress();
  if (status) return *status;
  report("aresta: " + status.error().to_line());
  return exit_status(status.error());
}

}  // namespace

int exit_status(const Error& error) {
  switch (error.code.failure) {
    case Failure::operation: return status_failed;
    case Failure::usage: return status_usage;
    case Failure::file: return status_file;
    case Failure::cancelled: return status_interrupted;
  }
  return status_failed;
}

}  // namespace aresta::app

int main(int argc, char** argv) {
  aresta::app::prepare_streams();
  try {
    return aresta::app::main_in_words(argc, argv);
  } catch (const std::bad_alloc&) {
    aresta::app::report("aresta: memory.exhausted: there is not enough memory for this");
  } catch (const std::exception& e) {
    aresta::app::report(std::string("aresta: internal: ") + e.what());
  }
  return aresta::app::status_failed;
}
