// SPDX-License-Identifier: Apache-2.0
// The sub-commands that work on model files. Each calls commands of the registry, as a script would.
#pragma once

#include <string>
#include <vector>

#include "program.h"

namespace aresta::app {

/// Formats in place of what files' endings say. `format` speaks of the output; of the input where there is no output,
/// or where only the input has no ending.
struct Formats {
  std::string format, input_format;
};

struct FileOptions : Formats {
  std::string file;
};
Result<int> show_info(Program& program, const FileOptions& options);
Result<int> check_file(Program& program, const FileOptions& options);

struct ConvertOptions : Formats {
  std::string in, out;
};
Result<int> convert_file(Program& program, const ConvertOptions& options);

struct FragmentCommandOptions : Formats {
  std::vector<std::string> in;
  std::string out;
};
Result<int> fragment_files(Program& program, const FragmentCommandOptions& options);

struct BooleanCommandOptions : Formats {
  std::string operation, a, b, out;
  bool regularise = false, simplify = false;
};
Result<int> boolean_files(Program& program, const BooleanCommandOptions& options);

struct MeshCommandOptions : Formats {
  std::string in, out;
  double size = 0;
  int order = 1;
};
Result<int> mesh_file(Program& program, const MeshCommandOptions& options);

struct RenderCommandOptions : Formats {
  std::string in, out, view = "iso";
  bool hidden_lines = false, perspective = false;
  double explode = 0, opacity = 1;
  int width = 1600, height = 1200;
};
Result<int> render_file(Program& program, const RenderCommandOptions& options);

struct CutCommandOptions : Formats {
  std::string in, above, below, section, plane;
};
Result<int> cut_file(Program& program, const CutCommandOptions& options);

}  // namespace aresta::app
