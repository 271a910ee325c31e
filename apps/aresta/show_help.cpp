// SPDX-License-Identifier: Apache-2.0
// `aresta help`: the registry as pages of text.
#include "document/commands.h"
#include "program.h"
#include "script/interpreter.h"

namespace aresta::app {

namespace {

std::string first_sentence(const std::string& text) {
  const std::size_t end = text.find(". ");
  return end == std::string::npos ? text : text.substr(0, end + 1);
}

/// Text in lines of at most 110 characters; all but the first begin with `indent` blanks, for which the first has room.
std::string folded(const std::string& text, std::size_t indent) {
  constexpr std::size_t width = 110;
  std::string result;
  std::size_t column = indent;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (column > indent && column + 1 + (end - at) > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result.append(text, at, end - at);
    column += end - at;
    at = end + 1;
  }
  return result;
}

std::string overview(const document::Registry& registry) {
  std::string text =
      "The script language is a subset of Python: variables, lists, loops, if, and the commands below.\n"
      "Lengths are in document units (default mm), angles in degrees; z is up. 'aresta help NAME' explains one.\n";
  std::size_t width = 0;
  for (const auto& [name, command] : registry.commands()) width = std::max(width, name.size());
  for (const std::string& group : registry.groups()) {
    text += "\n" + group + "\n";
    for (const auto& [name, command] : registry.commands()) {
      if (command.group == group)
        text += "  " + name + std::string(width - name.size() + 2, ' ') +
                folded(first_sentence(command.doc), width + 4) + "\n";
    }
  }
  return text;
}

}  // namespace

const document::Registry& all_commands() {
  static const document::Registry registry = [] {
    document::Registry r;
    document::register_modelling(r);
    script::register_language(r);
    return r;
  }();
  return registry;
}

Result<int> show_help(Program& program, const HelpOptions& options) {
  const document::Registry& registry = all_commands();
  if (options.command.empty()) {
    ARESTA_CHECK(program.output.write(overview(registry)));
    return static_cast<int>(status_done);
  }
  if (const document::Command* command = registry.find(options.command)) {
    ARESTA_CHECK(program.output.write(document::Registry::help(*command)));
    if (options.pages.contains(options.command)) {
      ARESTA_CHECK(program.output.write("\nThis is the command of scripts; of the program's there is 'aresta " +
                                        options.command + " --help'.\n"));
    }
    return static_cast<int>(status_done);
  }
  if (const document::Constant* constant = registry.find_constant(options.command)) {
    ARESTA_CHECK(
        program.output.write(constant->name + " = " + document::repr(constant->value) + "\n\n" + constant->doc + "\n"));
    return static_cast<int>(status_done);
  }
  if (const auto page = options.pages.find(options.command); page != options.pages.end()) {
    ARESTA_CHECK(program.output.write(page->second));
    return static_cast<int>(status_done);
  }
  std::vector<std::string> names;
  for (const auto& [name, command] : registry.commands()) names.push_back(name);
  for (const auto& [name, page] : options.pages) names.push_back(name);
  const std::string near = document::nearest_name(options.command, names);
  return Error{usage_error, "there is no command '" + options.command + "'" +
                                (near.empty() ? "; 'aresta help' lists all" : "; did you mean '" + near + "'?")};
}

}  // namespace aresta::app
