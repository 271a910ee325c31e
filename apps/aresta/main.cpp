// SPDX-License-Identifier: Apache-2.0
// The program `aresta`: reads the command line, runs one sub-command, turns errors into one line and an exit status.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <new>
#include <thread>

#include "interrupt.h"
#include "model_commands.h"
#include "program.h"

namespace aresta::app {

namespace {

constexpr const char* description =
    "Aresta: solids, sheets and wires as boundary representations, manifold or not; booleans between groups of them,\n"
    "meshes and pictures.";

constexpr const char* epilogue =
    "Examples:\n"
    "  aresta run plate.ars                        run a script\n"
    "  aresta help                                 the commands of scripts; 'aresta help block' for one of them\n"
    "  aresta info part.step                       what is in a file\n"
    "  aresta fragment a.step b.step -o all.step   imprint parts on one another, keep all regions\n"
    "  aresta mesh all.step -o all.inp --size 2    a mesh for a solver"
    "\n"
    "'aresta COMMAND --help' explains a command. '-' stands for standard input or output.\n"
    "Exit status: 0 done, 1 the operation or the script failed, 2 wrong usage, 3 a file cannot be read or written,\n"
    "4 the checker found something, 130 interrupted.";

/// The words of one sub-command: what it is called, what its help says.
CLI::App* add_command(CLI::App& app, Common& common, const char* name, const char* text, const char* examples) {
  CLI::App* sub = app.add_subcommand(name, text);
  sub->footer(examples);
  const char* group = "Common options";
  sub->add_option("--tolerance", common.tolerance,
                  "points closer than this are one (document units; default: the model's own)")
      ->group(group)
      ->type_name("T")
      ->check([](const std::string& text_given) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text_given, value) && std::isfinite(value) && value > 0;
        return good ? std::string() : "it must be a number greater than 0";
      });
  sub->add_option("--threads", common.threads, "how many threads to use (default: all)")
      ->group(group)
      ->type_name("N")
      ->check([](const std::string& given) {
        int value = 0;
        const bool good = CLI::detail::lexical_cast(given, value) && value >= 1 && value <= 1024;
        return good ? std::string() : "it must be a whole number from 1 to 1024";
      });
  sub->add_flag("--json", common.json, "results as JSON")->group(group);
  sub->add_flag("--quiet,-q", common.quiet, "only results and errors")->group(group);
  sub->add_flag("--progress", common.progress, "show progress (default: when the output is a terminal)")->group(group);
  return sub;
}

std::string must_be_number(const std::string& given) {
  double value = 0;
  return CLI::detail::lexical_cast(given, value) ? std::string() : "it must be a number, not '" + given + "'";
}

std::string must_be_whole(const std::string& given) {
  int value = 0;
  return CLI::detail::lexical_cast(given, value) ? std::string() : "it must be a whole number, not '" + given + "'";
}

/// What is wrong with a command line, in words; `command` is the one that it names, if there is such a one.
std::string usage_text(const CLI::App& app, const CLI::App* command, int argc, char** argv,
                       const CLI::ParseError* error) {
  if (command == nullptr) {
    if (argc == 1) return "say what to do, as in 'aresta info part.step'";
    const std::string first = argv[1];
    if (first.size() > 1 && first[0] == '-')
      return "the first word is a command, and there is no option '" + first + "'";
    std::vector<std::string> names;
    for (const CLI::App* s : app.get_subcommands({})) names.push_back(s->get_name());
    const std::string near = document::nearest_name(first, names);
    return "there is no command '" + first + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?");
  }
  std::string text = error->what();
  const std::string unexpected = "expected: ", missing = " missing";
  if (dynamic_cast<const CLI::ExtrasError*>(error) != nullptr && text.find(unexpected) != std::string::npos) {
    text = text.substr(text.find(unexpected) + unexpected.size());
    const std::size_t dash = (" " + text).find(" -");  // the option comes after its value
    if (dash == std::string::npos) return "nothing more is expected here: " + text;
    const std::string option = text.substr(dash, text.find_first_of(" =", dash) - dash);
    std::vector<std::string> names;
    for (const CLI::Option* o : command->get_options()) {
      for (const std::string& name : o->get_lnames()) names.push_back("--" + name);
    }
    const std::string near = document::nearest_name(option, names);
    return "there is no option '" + option + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?");
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(error) != nullptr && text.ends_with(missing)) {
    return text.substr(0, text.find(':')) + " needs a value";
  }
  return text;
}

int say(Output& output, const std::string& text) {
  Status status = output.write(text);
  if (status) status = output.flush();
  if (status) return status_done;
  report("aresta: " + status.error().to_line());
  return exit_status(status.error());
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
  run_command->add_option("FILE", run.file, "the script; - for standard input")->required()->type_name("");
  run_command
      ->add_option("-D,--define", run.definitions, "a variable that is set before the script starts, as name=value")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  run_command
      ->add_option("--summary-file", run.summary_file,
                   "a JSON file for times, printed lines and the last model's figures")
      ->type_name("OUT.json");

  HelpOptions help;
  CLI::App* help_command = add_command(app, program.common, "help", "Explain the commands of scripts.",
                                       "Examples:\n  aresta help\n  aresta help cylinder");
  help_command->add_option("NAME", help.command, "a command of the script language, or of the program")->type_name("");

  // Sub-commands on files of models.
  const auto formats = [](CLI::App* sub, Formats& into, bool has_output) {
    sub->add_option("--format", into.format,
                    has_output ? "format of the output, in place of what its ending says"
                               : "format of the file, in place of what its ending says")
        ->type_name("FORMAT");
    if (has_output)
      sub->add_option("--input-format", into.input_format, "format of the input, likewise")->type_name("FORMAT");
  };
  const auto output = [](CLI::App* sub, std::string& into) {
    sub->add_option("-o,--output", into, "the file to write; - for standard output")->required()->type_name("OUT");
  };

  FileOptions info;
  CLI::App* info_command =
      add_command(app, program.common, "info",
                  "Say what is in a file: counts, bounds, measures, unit, kinds of surfaces, tolerances.",
                  "Example:\n  aresta info part.step --json");
  info_command->add_option("FILE", info.file, "STEP, BREP, STL, OBJ, PLY or OFF; - for standard input")
      ->required()
      ->type_name("");
  formats(info_command, info, false);

  FileOptions checked;
  CLI::App* check_command =
      add_command(app, program.common, "check", "Run the full checker; list what it finds, with entities and places.",
                  "Example:\n  aresta check part.step\n\nExit status 4 when there are findings.");
  check_command->add_option("FILE", checked.file, "the file; - for standard input")->required()->type_name("");
  formats(check_command, checked, false);

  ConvertOptions convert;
  CLI::App* convert_command = add_command(
      app, program.common, "convert", "Read a model and write it in another format.",
      "Examples:\n  aresta convert part.step part.brep\n  aresta convert part.step - --format stl > part.stl");
  convert_command->add_option("IN", convert.in, "the file to read")->required()->type_name("");
  convert_command->add_option("OUT", convert.out, "the file to write: STEP, BREP, STL or OBJ")
      ->required()
      ->type_name("");
  formats(convert_command, convert, true);

  FragmentCommandOptions pieces;
  CLI::App* fragment_command =
      add_command(app, program.common, "fragment", "Imprint everything on everything, find all regions, keep them all.",
                  "Example:\n  aresta fragment core.step shell.step -o all.step\n\nWhat touches shares faces, edges "
                  "and vertices in the result.");
  fragment_command->add_option("IN", pieces.in, "the files to read; parts of one file are imprinted too")
      ->required()
      ->type_name("");
  output(fragment_command, pieces.out);
  formats(fragment_command, pieces, true);

  BooleanCommandOptions boolean;
  CLI::App* boolean_command =
      add_command(app, program.common, "boolean", "Union, intersection or difference of two files.",
                  "Example:\n  aresta boolean difference plate.step holes.step -o drilled.step --regularise");
  boolean_command->add_option("OPERATION", boolean.operation, "union, intersection, difference or symmetric_difference")
      ->required()
      ->type_name("")
      ->check([](const std::string& given) {
        for (const char* known : {"union", "intersection", "difference", "symmetric_difference"}) {
          if (given == known) return std::string();
        }
        return "there is no operation '" + given + "': it is union, intersection, difference or symmetric_difference";
      });
  boolean_command->add_option("A", boolean.a, "the first file")->required()->type_name("");
  boolean_command->add_option("B", boolean.b, "the second file")->required()->type_name("");
  output(boolean_command, boolean.out);
  boolean_command->add_flag("--regularise", boolean.regularise,
                            "keep solids only: no dangling faces, wires or inner walls");
  boolean_command->add_flag("--simplify", boolean.simplify, "merge neighbouring faces on one surface afterwards");
  formats(boolean_command, boolean, true);

  MeshCommandOptions meshing;
  CLI::App* mesh_command =
      add_command(app, program.common, "mesh", "Make a finite element mesh of all regions, sheets and wires.",
                  "Example:\n  aresta mesh all.step -o all.inp --size 2 --order 2\n\nRegions that touch share nodes. "
                  "Names and groups become sets.");
  mesh_command->add_option("IN", meshing.in, "the file to read")->required()->type_name("");
  mesh_command
      ->add_option("-o,--output", meshing.out,
                   "the file to write: .inp (Abaqus, CalculiX), .msh (4.1; --format msh2 for 2.2) or .vtu")
      ->required()
      ->type_name("OUT");
  mesh_command
      ->add_option("--size", meshing.size,
                   "wished length of the elements' sides (default: a twelfth of the model's size)")
      ->type_name("H")
      ->check(must_be_number);
  mesh_command
      ->add_option("--order", meshing.order,
                   "1: straight elements (default), 2: with nodes in the middle of their sides")
      ->type_name("1|2")
      ->check(must_be_whole);
  formats(mesh_command, meshing, true);

  RenderCommandOptions picture;
  CLI::App* render_command = add_command(
      app, program.common, "render", "Draw a model: PNG (shaded), SVG (lines) or HTML (a page that turns it).",
      "Examples:\n  aresta render part.step -o part.png\n  aresta render part.step -o part.svg --view front "
      "--hidden-lines\n  aresta render all.step -o all.html --explode 0.5");
  render_command->add_option("IN", picture.in, "the file to read")->required()->type_name("");
  render_command->add_option("-o,--output", picture.out, "the picture: .png, .svg or .html")
      ->required()
      ->type_name("OUT");
  render_command->add_option("--view", picture.view, "iso, front, back, left, right, top or bottom (default: iso)")
      ->type_name("VIEW");
  render_command->add_flag("--hidden-lines", picture.hidden_lines, "in SVG: remove the lines that cannot be seen");
  render_command->add_flag("--perspective", picture.perspective, "as the eye sees it");
  render_command
      ->add_option("--explode", picture.explode,
                   "how far regions move apart: 0 not at all (default), 1 to twice their distance, nested ones out of "
                   "each other")
      ->type_name("F")
      ->check(must_be_number);
  render_command->add_option("--opacity", picture.opacity, "in PNG: of faces, from 0 to 1 (default)")
      ->type_name("F")
      ->check(must_be_number);
  render_command->add_option("--width", picture.width, "pixels (default: 1600)")->type_name("N")->check(must_be_whole);
  render_command->add_option("--height", picture.height, "pixels (default: 1200)")
      ->type_name("N")
      ->check(must_be_whole);
  formats(render_command, picture, true);

  CutCommandOptions cutting;
  CLI::App* cut_command = add_command(
      app, program.common, "cut", "Cut a model in two by a plane.",
      "Example:\n  aresta cut part.step --plane 0,0,5,0,0,1 --above top.step --below bottom.step --section rim.step");
  cut_command->add_option("IN", cutting.in, "the file to read")->required()->type_name("");
  cut_command->add_option("--plane", cutting.plane, "a point of the plane and its normal, six numbers with commas")
      ->required()
      ->type_name("px,py,pz,nx,ny,nz");
  cut_command->add_option("--above", cutting.above, "a file for what the normal points to")->type_name("OUT");
  cut_command->add_option("--below", cutting.below, "a file for the other side")->type_name("OUT");
  cut_command->add_option("--section", cutting.section, "a file for the faces in the plane")->type_name("OUT");
  formats(cut_command, cutting, true);

  for (const CLI::App* s : app.get_subcommands({}))
    help.pages[s->get_name()] = s->help("aresta", CLI::AppFormatMode::Normal);

  const auto wrong_usage = [&](const CLI::ParseError* error) {
    const CLI::App* command = app.get_subcommands().empty() ? nullptr : app.get_subcommands().front();
    report("aresta: usage: " + usage_text(app, command, argc, argv, error) + "; try: aresta " +
           (command != nullptr ? command->get_name() + " " : "") + "--help");
    return static_cast<int>(status_usage);
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& error) {
    if (app.get_subcommands().empty() && argv[1][0] != '-') return wrong_usage(&error);
    const CLI::App* shown = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
    return say(program.output, shown->help(shown == &app ? "" : "aresta", CLI::AppFormatMode::Normal));
  } catch (const CLI::CallForVersion& version) {
    return say(program.output, std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    return wrong_usage(&error);
  }

  Common& common = program.common;
  if (common.threads == 0) common.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  program.context.threads = common.threads;
  program.context.cancel = &watch_interrupts();
  if (common.progress || (!common.quiet && ::isatty(STDERR_FILENO) == 1)) program.context.progress = show_progress;

  Result<int> status = run_command->parsed()        ? run_script(program, run)
                       : info_command->parsed()     ? show_info(program, info)
                       : check_command->parsed()    ? check_file(program, checked)
                       : convert_command->parsed()  ? convert_file(program, convert)
                       : fragment_command->parsed() ? fragment_files(program, pieces)
                       : boolean_command->parsed()  ? boolean_files(program, boolean)
                       : mesh_command->parsed()     ? mesh_file(program, meshing)
                       : render_command->parsed()   ? render_file(program, picture)
                       : cut_command->parsed()      ? cut_file(program, cutting)
                                                    : show_help(program, help);
  if (auto flushed = program.output.flush(); !flushed && status) status = std::move(flushed.error());
  clear_progress();
  if (status) return *status;
  report("aresta: " + status.error().to_line());
  return exit_status(status.error());
}

}  // namespace

int exit_status(const Error& error) {
  switch (error.code.failure) {
    case Failure::operation:
      return status_failed;
    case Failure::usage:
      return status_usage;
    case Failure::file:
      return status_file;
    case Failure::cancelled:
      return status_interrupted;
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
