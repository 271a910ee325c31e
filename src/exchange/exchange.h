// SPDX-License-Identifier: Apache-2.0
// Models in and out of files.
//
//   format  extensions       in   out  keeps
//   step    .step .stp .p21  yes  yes  exact geometry, units, names, colours, shared faces, sheets, wires, points
//   brep    .brep .brp       yes  yes  exact geometry, shared faces, sheets, wires, points; no unit (document units)
//   stl     .stl             yes  yes  triangles
//   obj     .obj             yes  yes  polygons
//   ply     .ply             yes  -    polygons
//   off     .off             yes  -    polygons
// (Meshes for solvers are written from meshes, not from models.)
//
// Nothing is imported unseen: a model that comes back has passed the checker. Files are written whole or not at all.
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "model/check.h"
#include "model/model.h"

namespace aresta {

/// What is worth knowing about an import besides the model.
struct ImportReport {
  std::string format;
  std::string file_unit;           ///< as the file names it; empty where files have none
  std::vector<std::string> notes;  ///< what was repaired, merged or left out: sentences
};

struct ImportOptions {
  std::string format;         ///< empty: by the file's extension
  double length_unit = 1e-3;  ///< metres per document unit of the model; files with a unit are converted
  bool repair = true;         ///< try to mend a shape that cannot be taken as it is; what was done is in the notes
  bool join = false;          ///< imprint parts on each other that touch without sharing; see join_parts.h
  bool check = true;          ///< false: take what can be built, unseen
  CheckLevel level = CheckLevel::fast;
  ImportReport* report = nullptr;
};

struct ExportOptions {
  std::string format;     ///< empty: by the file's extension
  bool ascii = false;     ///< STL: text in place of binary
  double deflection = 0;  ///< triangles: greatest distance from the true shape; 0: 1e-3 of the box's diagonal
  double angle = 15;      ///< triangles: degrees between neighbouring pieces, at most
};

/// Errors: unknown_format, file_unreadable, bad_content (the file is not what it claims to be, or is cut off),
/// nothing_to_import, unsupported_content (as in: only tessellated geometry), invalid_import (with the first findings),
/// those of to_model and ModelBuilder::build, cancelled.
Result<Model> import_file(const std::string& path, const ImportOptions& options = {}, const Context& context = {});

/// Errors: unknown_format, file_unwritable, export_failed, those of to_shape and tessellate, cancelled.
Status export_file(const Model& model, const std::string& path, const ExportOptions& options = {},
                   const Context& context = {});

/// "step", "brep", ...; error unknown_format names what is known.
Result<std::string> format_of(const std::string& path, const std::string& given);

}  // namespace aresta
