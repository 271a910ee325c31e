// SPDX-License-Identifier: Apache-2.0
// Meshes into files of solvers and viewers.
//
// Entity numbers in files: MSH tags are the entity's index plus one (tags are positive there); VTU arrays hold the
// index itself; INP names are REGION_i and FACE_i with the index. Coordinates read back exactly, except in INP files,
// whose readers take 20 characters per number: there they are rounded to what fits (at least 13 digits).
#pragma once

#include <string>

#include "base/result.h"
#include "mesh/mesh.h"

namespace aresta {

enum class MshVersion { v22, v41 };

struct VtuOptions {
  bool binary = true;  ///< appended base64, else text
};

struct InpOptions {
  /// Write faces that no volume element touches as shell elements (S3, S6) too.
  bool shells = false;
};

/// The file's contents. A named set becomes a physical group (MSH), a cell array "group NAME" of zeros and ones (VTU),
/// an element set, node set and surface (INP). In MSH files every entity of
/// no set gets a group of its own ("face_3"), because readers drop elements without group. MSH 2.2 repeats an element
/// for each of its groups, as the format wants. Error: exchange.bad_mesh (a node out of range; INP: no elements to
/// write).
Result<std::string> to_msh(const Mesh& mesh, MshVersion version);
Result<std::string> to_vtu(const Mesh& mesh, const VtuOptions& options = {});
Result<std::string> to_inp(const Mesh& mesh, const InpOptions& options = {});

/// Into a file, atomically. Errors: as above, file.unwritable.
Status write_msh(const Mesh& mesh, const std::string& path, MshVersion version = MshVersion::v41);
Status write_vtu(const Mesh& mesh, const std::string& path, const VtuOptions& options = {});
Status write_inp(const Mesh& mesh, const std::string& path, const InpOptions& options = {});

/// By the path's ending: .msh (4.1), .vtu, .inp. Error: exchange.bad_mesh for another ending.
Status write_mesh(const Mesh& mesh, const std::string& path);

/// A mesh from MSH 2.2 or 4.1 text: nodes in the file's order, blocks by entity, sets from physical groups. Regions
/// made up by the writer ("face_3") are not sets. Error: exchange.bad_mesh_file with the line.
Result<Mesh> from_msh(const std::string& text);
Result<Mesh> read_msh(const std::string& path);

}  // namespace aresta
