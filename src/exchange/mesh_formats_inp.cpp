// SPDX-License-Identifier: Apache-2.0
// Abaqus and CalculiX input: nodes, elements, sets and surfaces; no materials, loads or steps.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "base/files.h"
#include "exchange/errors.h"
#include "exchange/mesh_formats.h"
#include "exchange/mesh_formats_text.h"

namespace aresta {

namespace {

using namespace mesh_formats;

/// CalculiX reads 20 characters of a number and drops the rest; as many digits as fit into them.
std::string number20(double value) {
  char buffer[40];
  char* end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  for (int digits = 17; end - buffer > 20; --digits) {
    end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  }
  return {buffer, end};
}

const char* element_name(ElementType type) {
  switch (type) {
    case ElementType::triangle3:
      return "S3";
    case ElementType::triangle6:
      return "S6";
    case ElementType::quad4:
      return "S4";
    case ElementType::quad8:
      return "S8";
    case ElementType::tetra4:
      return "C3D4";
    case ElementType::tetra10:
      return "C3D10";
    case ElementType::wedge6:
      return "C3D6";
    case ElementType::wedge15:
      return "C3D15";
    case ElementType::hexa8:
      return "C3D8";
    case ElementType::hexa20:
      return "C3D20";
    default:
      return nullptr;
  }
}

/// Names that solvers take: letters, digits and underscores, a letter first, unique whatever the case, 70 at most.
class Names {
 public:
  std::string make(const std::string& wanted) {
    std::string name;
    for (const char c : wanted) {
      const auto u = static_cast<unsigned char>(c);
      if (u < 128 && std::isalnum(u)) {
        name += static_cast<char>(std::toupper(u));
      } else if (name.empty() || name.back() != '_') {
        name += '_';
      }
    }
    if (name.empty() || !(name[0] >= 'A' && name[0] <= 'Z')) name = "SET_" + name;
    if (name.size() > 70) name.resize(70);
    std::string unique = name;
    for (int i = 2; !used_.insert(unique).second; ++i) unique = name + "_" + std::to_string(i);
    return unique;
  }

 private:
  std::set<std::string> used_;
};

/// One line of a comment: line breaks and the like would end it.
std::string comment(const std::string& name) {
  std::string line;
  for (const char c : name) line += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  return line;
}

class InpWriter {
 public:
  InpWriter(const Mesh& mesh, const InpOptions& options) : mesh_(mesh), options_(options), sides_(volume_sides(mesh)) {}

  Result<std::string> run() {
    for (const auto& block : mesh_.blocks) {
      if (dimension(block.type) >= 2)
        entity_names_[block.entity] =
            names_.make(std::string(to_string(block.entity.kind)) + "_" + std::to_string(block.entity.index));
    }
    for (const auto& set : mesh_.sets) set_names_.push_back(names_.make(set.name));
    number_elements();
    if (element_total_ == 0) {
      return Error{errors::exchange_bad_mesh,
                   "the mesh has no volume elements to write",
                   {},
                   {},
                   "ask for shells to write surface elements"};
    }
    head();
    nodes();
    elements();
    for (const auto& [entity, name] : entity_names_) {
      if (entity.kind == EntityKind::face) node_set(name, {entity}), surface(name, {entity});
    }
    for (std::size_t i = 0; i < mesh_.sets.size(); ++i) {
      element_set(set_names_[i], mesh_.sets[i].entities);
      node_set(set_names_[i], mesh_.sets[i].entities);
      surface(set_names_[i], mesh_.sets[i].entities);
    }
    return text_.take();
  }

 private:
  bool written(std::size_t block) const { return first_element_[block] != 0; }

  const ElementSide* find_side(const std::array<std::uint32_t, 4>& key) const {
    const auto found = std::lower_bound(sides_.begin(), sides_.end(), key,
                                        [](const ElementSide& s, const auto& k) { return s.key < k; });
    return found != sides_.end() && found->key == key ? &*found : nullptr;
  }

  void number_elements() {
    first_element_.assign(mesh_.blocks.size(), 0);
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const auto& block = mesh_.blocks[b];
      const int dim = dimension(block.type);
      if (block.size() == 0 || dim < 2) continue;
      if (dim == 2 &&
          (!options_.shells || find_side(side_key(block.nodes.data(), corner_count(block.type))) != nullptr))
        continue;
      first_element_[b] = element_total_ + 1;
      element_total_ += block.size();
    }
  }

  void head() {
    text_ << "*HEADING\nMesh written by Aresta\n";
    text_ << "** " << mesh_.nodes.size() << " nodes, " << element_total_ << " elements\n";
    if (!mesh_.sets.empty()) text_ << "** Names here, and as they were:\n";
    for (std::size_t i = 0; i < mesh_.sets.size(); ++i)
      text_ << "**   " << set_names_[i] << " = " << comment(mesh_.sets[i].name) << "\n";
  }

  void nodes() {
    text_ << "*NODE, NSET=NALL\n";
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
      const Vec3 p = mesh_.nodes[i];
      text_ << i + 1 << ", " << number20(p.x) << ", " << number20(p.y) << ", " << number20(p.z) << "\n";
    }
  }

  void elements() {
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      if (!written(b)) continue;
      const auto& block = mesh_.blocks[b];
      text_ << "*ELEMENT, TYPE=" << element_name(block.type) << ", ELSET=" << entity_names_[block.entity] << "\n";
      const auto step = static_cast<std::size_t>(node_count(block.type));
      const auto order = inp_order(block.type);
      for (std::size_t e = 0; e < block.size(); ++e) {
        text_ << first_element_[b] + e;
        for (std::size_t i = 0; i < step; ++i) {
          const std::size_t at = order.empty() ? i : static_cast<std::size_t>(order[i]);
          // Sixteen entries at most on a line.
          text_ << (i == 15 ? ",\n" : ", ") << block.nodes[e * step + at] + 1;
        }
        text_ << "\n";
      }
    }
  }

  static bool holds(const std::vector<EntityRef>& entities, EntityRef entity) {
    return std::find(entities.begin(), entities.end(), entity) != entities.end();
  }

  void element_set(const std::string& name, const std::vector<EntityRef>& entities) {
    std::vector<std::string> parts;
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      if (!written(b) || !holds(entities, mesh_.blocks[b].entity)) continue;
      const std::string& part = entity_names_[mesh_.blocks[b].entity];
      if (parts.empty() || parts.back() != part) parts.push_back(part);
    }
    if (parts.empty()) return;
    text_ << "*ELSET, ELSET=" << name << "\n";
    for (const auto& part : parts) text_ << part << "\n";
  }

  void node_set(const std::string& name, const std::vector<EntityRef>& entities) {
    std::vector<std::uint32_t> nodes;
    for (const auto& block : mesh_.blocks) {
      if (holds(entities, block.entity)) nodes.insert(nodes.end(), block.nodes.begin(), block.nodes.end());
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (nodes.empty()) return;
    text_ << "*NSET, NSET=" << name;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      text_ << (i % 12 == 0 ? "\n" : ", ") << nodes[i] + 1 << (i % 12 == 11 ? "," : "");
    text_ << "\n";
  }

  /// Sides of volume elements on the faces. Between two regions: the side of the region behind the face (the face's
  /// normal looks out of it), so that pressure on it acts against the normal.
  void surface(const std::string& name, const std::vector<EntityRef>& entities) {
    Text lines;
    for (const auto& block : mesh_.blocks) {
      if (dimension(block.type) != 2 || !holds(entities, block.entity)) continue;
      const auto step = static_cast<std::size_t>(node_count(block.type));
      for (std::size_t at = 0; at < block.nodes.size(); at += step) {
        const auto key = side_key(&block.nodes[at], corner_count(block.type));
        const ElementSide* best = find_side(key);
        if (best == nullptr) continue;
        const ElementSide* other = best + 1;
        const bool has_other = other != sides_.data() + sides_.size() && other->key == key;
        if (has_other && !looks_out(*best, &block.nodes[at]) && looks_out(*other, &block.nodes[at])) best = other;
        lines << first_element_[best->block] + best->element << ", S" << best->side + 1 << "\n";
      }
    }
    if (!lines.str().empty()) text_ << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n" << lines.str();
  }

  /// Does the surface element (its first three corners) run around the element's side as seen from outside?
  bool looks_out(const ElementSide& side, const std::uint32_t* nodes) const {
    const auto& block = mesh_.blocks[side.block];
    const auto& corners = corner_sides(block.type)[static_cast<std::size_t>(side.side)];
    const auto step = static_cast<std::size_t>(node_count(block.type));
    const int count = corners[3] < 0 ? 3 : 4;
    for (int i = 0; i < count; ++i) {
      const auto node = [&](int k) {
        return block
            .nodes[side.element * step + static_cast<std::size_t>(corners[static_cast<std::size_t>(k % count)])];
      };
      if (node(i) == nodes[0]) return node(i + 1) == nodes[1];
    }
    return false;
  }

  const Mesh& mesh_;
  const InpOptions& options_;
  std::vector<ElementSide> sides_;
  Names names_;
  std::map<EntityRef, std::string> entity_names_;
  std::vector<std::string> set_names_;
  std::vector<std::size_t> first_element_;  ///< per block its first element's number; 0: not written
  std::size_t element_total_ = 0;
  Text text_;
};

}  // namespace

Result<std::string> to_inp(const Mesh& mesh, const InpOptions& options) {
  ARESTA_CHECK(check_mesh(mesh));
  return InpWriter(mesh, options).run();
}

Status write_inp(const Mesh& mesh, const std::string& path, const InpOptions& options) {
  ARESTA_TRY(const std::string text, to_inp(mesh, options));
  return write_file(path, text);
}

}  // namespace aresta
