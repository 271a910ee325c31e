// SPDX-License-Identifier: Apache-2.0
// VTK's XML format for unstructured grids.
#include <algorithm>
#include <cstring>

#include "base/files.h"
#include "exchange/errors.h"
#include "exchange/mesh_formats.h"
#include "exchange/mesh_formats_text.h"

namespace aresta {

namespace {

using namespace mesh_formats;

int vtk_type(ElementType type) {
  switch (type) {
    case ElementType::point1:
      return 1;
    case ElementType::line2:
      return 3;
    case ElementType::line3:
      return 21;
    case ElementType::triangle3:
      return 5;
    case ElementType::triangle6:
      return 22;
    case ElementType::quad4:
      return 9;
    case ElementType::quad8:
      return 23;
    case ElementType::tetra4:
      return 10;
    case ElementType::tetra10:
      return 24;
    case ElementType::wedge6:
      return 13;
    case ElementType::wedge15:
      return 26;
    case ElementType::hexa8:
      return 12;
    case ElementType::hexa20:
      return 25;
  }
  return 0;
}

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
  }
  return text;
}

/// Text for an attribute: control characters are not allowed in XML and become spaces.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    }
  }
  return text;
}

class VtuWriter {
 public:
  VtuWriter(const Mesh& mesh, const VtuOptions& options) : mesh_(mesh), options_(options) {}

  std::string run() {
    std::size_t cells = 0;
    for (const auto& block : mesh_.blocks) cells += block.size();
    text_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\">\n"
          << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << mesh_.nodes.size() << "\" NumberOfCells=\"" << cells
          << "\">\n<Points>\n";
    std::vector<double> points;
    points.reserve(3 * mesh_.nodes.size());
    for (const Vec3& p : mesh_.nodes) points.insert(points.end(), {p.x, p.y, p.z});
    array("Float64", "points", points, 3);
    text_ << "</Points>\n<Cells>\n";
    cells_arrays();
    text_ << "</Cells>\n<CellData>\n";
    entity_arrays();
    text_ << "</CellData>\n</Piece>\n</UnstructuredGrid>\n";
    if (options_.binary) text_ << "<AppendedData encoding=\"base64\">\n_" << appended_ << "\n</AppendedData>\n";
    text_ << "</VTKFile>\n";
    return text_.take();
  }

 private:
  template <class T>
  void array(const char* type, const std::string& name, const std::vector<T>& values, int components = 1) {
    text_ << "<DataArray type=\"" << type << "\" Name=\"" << escaped(name) << "\"";
    if (components != 1) text_ << " NumberOfComponents=\"" << components << "\"";
    if (options_.binary) {
      // The size and the data are encoded as one run of bytes.
      const std::uint64_t size = values.size() * sizeof(T);
      std::string bytes(sizeof size + size, '\0');
      std::memcpy(bytes.data(), &size, sizeof size);
      if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
      text_ << " format=\"appended\" offset=\"" << appended_.size() << "\"/>\n";
      appended_ += base64(bytes);
      return;
    }
    text_ << " format=\"ascii\">\n";
    for (std::size_t i = 0; i < values.size(); ++i) {
      if constexpr (sizeof(T) == 1) {
        text_ << static_cast<int>(values[i]);
      } else {
        text_ << values[i];
      }
      text_ << ((i + 1) % 12 == 0 || i + 1 == values.size() ? '\n' : ' ');
    }
    text_ << "</DataArray>\n";
  }

  void cells_arrays() {
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    for (const auto& block : mesh_.blocks) {
      connectivity.insert(connectivity.end(), block.nodes.begin(), block.nodes.end());
      for (std::size_t e = 0; e < block.size(); ++e) {
        offsets.push_back((offsets.empty() ? 0 : offsets.back()) + node_count(block.type));
        types.push_back(static_cast<std::uint8_t>(vtk_type(block.type)));
      }
    }
    array("Int64", "connectivity", connectivity);
    array("Int64", "offsets", offsets);
    array("UInt8", "types", types);
  }

  template <class T, class Value>
  std::vector<T> per_cell(Value value) const {
    std::vector<T> values;
    for (const auto& block : mesh_.blocks) values.insert(values.end(), block.size(), static_cast<T>(value(block)));
    return values;
  }

  void entity_arrays() {
    array("UInt8", "dimension", per_cell<std::uint8_t>([](const ElementBlock& b) { return dimension(b.type); }));
    array("Int32", "entity", per_cell<std::int32_t>([](const ElementBlock& b) { return b.entity.index; }));
    const auto index_of = [](EntityKind kind) {
      return [kind](const ElementBlock& b) {
        return b.entity.kind == kind ? static_cast<std::int32_t>(b.entity.index) : -1;
      };
    };
    array("Int32", "region", per_cell<std::int32_t>(index_of(EntityKind::region)));
    array("Int32", "face", per_cell<std::int32_t>(index_of(EntityKind::face)));
    for (const auto& set : mesh_.sets) {
      array("UInt8", "group " + set.name, per_cell<std::uint8_t>([&](const ElementBlock& b) {
              return std::find(set.entities.begin(), set.entities.end(), b.entity) != set.entities.end() ? 1 : 0;
            }));
    }
  }

  const Mesh& mesh_;
  const VtuOptions& options_;
  Text text_;
  std::string appended_;
};

}  // namespace

Result<std::string> to_vtu(const Mesh& mesh, const VtuOptions& options) {
  ARESTA_CHECK(check_mesh(mesh));
  return VtuWriter(mesh, options).run();
}

Status write_vtu(const Mesh& mesh, const std::string& path, const VtuOptions& options) {
  ARESTA_TRY(const std::string text, to_vtu(mesh, options));
  return write_file(path, text);
}

Status write_mesh(const Mesh& mesh, const std::string& path) {
  const auto ends = [&](const char* ending) {
    return path.size() > 4 && path.compare(path.size() - 4, 4, ending) == 0;
  };
  if (ends(".msh")) return write_msh(mesh, path);
  if (ends(".vtu")) return write_vtu(mesh, path);
  if (ends(".inp")) return write_inp(mesh, path);
  return Error{
      errors::exchange_bad_mesh, "no mesh format goes with the ending of " + path, {}, {}, "one of .msh, .vtu, .inp"};
}

}  // namespace aresta
