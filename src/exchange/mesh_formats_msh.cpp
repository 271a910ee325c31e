// SPDX-License-Identifier: Apache-2.0
// Gmsh's MSH format as text, versions 2.2 and 4.1. Source: the format's chapter in Gmsh's reference manual.
#include "exchange/mesh_formats_msh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/files.h"
#include "exchange/errors.h"
#include "exchange/mesh_formats.h"
#include "exchange/mesh_formats_text.h"
#include "math/box.h"

namespace aresta {

namespace {

using namespace mesh_formats;

using Side = std::array<std::uint32_t, 2>;

class MshWriter {
 public:
  explicit MshWriter(const Mesh& mesh) : mesh_(mesh) {
    for (std::size_t s = 0; s < mesh.sets.size(); ++s) {
      for (const EntityRef entity : mesh.sets[s].entities)
        add_group(mesh.sets[s].name, static_cast<int>(s) + 1, entity);
    }
    int next = static_cast<int>(mesh.sets.size());
    for (const auto& block : mesh.blocks) {
      if (!groups_.contains(block.entity)) add_group(made_up_name(block.entity), ++next, block.entity);
    }
  }

  std::string write41() {
    text_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    names();
    entities();
    nodes41();
    elements41();
    return text_.take();
  }

  std::string write22() {
    text_ << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    names();
    text_ << "$Nodes\n" << mesh_.nodes.size() << "\n";
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
      const Vec3 p = mesh_.nodes[i];
      text_ << i + 1 << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    text_ << "$EndNodes\n";
    elements22();
    return text_.take();
  }

 private:
  static std::uint32_t tag(EntityRef entity) { return entity.index + 1; }

  void add_group(const std::string& name, int number, EntityRef entity) {
    auto& list = groups_[entity];
    if (!list.empty() && list.back() == number) return;
    list.push_back(number);
    names_[{static_cast<int>(entity.kind), number}] = name;
  }

  void names() {
    if (names_.empty()) return;
    text_ << "$PhysicalNames\n" << names_.size() << "\n";
    for (const auto& [key, name] : names_) {
      text_ << key.first << ' ' << key.second << " \"";
      // The format has no escapes.
      for (const char c : name) text_ << (c == '"' ? '\'' : static_cast<unsigned char>(c) < 32 ? ' ' : c);
      text_ << "\"\n";
    }
    text_ << "$EndPhysicalNames\n";
  }

  /// The entities that have blocks, each once, with their boxes.
  struct Present {
    EntityRef entity;
    Box3 box;
  };

  std::vector<Present> present() const {
    std::vector<Present> list;
    for (const auto& block : mesh_.blocks) {
      if (list.empty() || list.back().entity != block.entity) list.push_back({block.entity, {}});
      for (const std::uint32_t n : block.nodes) list.back().box.add(mesh_.nodes[n]);
    }
    return list;
  }

  void physical(EntityRef entity) {
    const auto found = groups_.find(entity);
    if (found == groups_.end()) {
      text_ << " 0";
      return;
    }
    text_ << ' ' << found->second.size();
    for (const int number : found->second) text_ << ' ' << number;
  }

  /// Which entities bound which, told from the mesh: a vertex bounds the edge whose line ends there, an edge the face
  /// that has its lines on one side only, a face the region that has its triangles on one side only.
  std::map<EntityRef, std::vector<std::int64_t>> boundaries() const {
    std::map<EntityRef, std::vector<std::int64_t>> bounds;
    std::map<std::uint32_t, EntityRef> vertex_at;
    std::map<Side, EntityRef> edge_at;
    for (const auto& block : mesh_.blocks) {
      if (block.type == ElementType::point1) vertex_at[block.nodes[0]] = block.entity;
      if (dimension(block.type) != 1) continue;
      const auto step = static_cast<std::size_t>(node_count(block.type));
      std::map<std::uint32_t, int> ends;
      for (std::size_t i = 0; i < block.nodes.size(); i += step) {
        --ends[block.nodes[i]];
        ++ends[block.nodes[i + 1]];
        edge_at[{std::min(block.nodes[i], block.nodes[i + 1]), std::max(block.nodes[i], block.nodes[i + 1])}] =
            block.entity;
      }
      for (const auto& [node, balance] : ends) {
        const auto vertex = vertex_at.find(node);
        if (balance != 0 && vertex != vertex_at.end())
          bounds[block.entity].push_back(balance * std::int64_t{tag(vertex->second)});
      }
    }
    for (const auto& block : mesh_.blocks) {
      if (dimension(block.type) != 2) continue;
      const auto step = static_cast<std::size_t>(node_count(block.type)),
                 corners = static_cast<std::size_t>(corner_count(block.type));
      std::map<Side, int> uses;
      for (std::size_t i = 0; i < block.nodes.size(); i += step) {
        for (std::size_t k = 0; k < corners; ++k) {
          const std::uint32_t a = block.nodes[i + k], b = block.nodes[i + (k + 1) % corners];
          ++uses[{std::min(a, b), std::max(a, b)}];
        }
      }
      std::vector<std::int64_t>& list = bounds[block.entity];
      for (const auto& [side, count] : uses) {
        const auto edge = edge_at.find(side);
        if (count == 1 && edge != edge_at.end()) list.push_back(tag(edge->second));
      }
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    const auto sides = volume_sides(mesh_);
    for (const auto& block : mesh_.blocks) {
      if (dimension(block.type) != 2 || block.nodes.empty()) continue;
      const auto key = side_key(block.nodes.data(), corner_count(block.type));
      auto found = std::lower_bound(sides.begin(), sides.end(), key,
                                    [](const ElementSide& s, const auto& k) { return s.key < k; });
      std::vector<EntityRef> regions;
      for (; found != sides.end() && found->key == key; ++found) regions.push_back(mesh_.blocks[found->block].entity);
      // A sheet inside a region has the same one on both sides and bounds nothing.
      if (regions.size() == 2 && regions[0] == regions[1]) continue;
      for (const EntityRef region : regions) bounds[region].push_back(tag(block.entity));
    }
    return bounds;
  }

  void entities() {
    const auto list = present();
    const auto bounds = boundaries();
    std::size_t counts[4] = {0, 0, 0, 0};
    for (const auto& p : list) ++counts[static_cast<int>(p.entity.kind)];
    text_ << "$Entities\n" << counts[0] << ' ' << counts[1] << ' ' << counts[2] << ' ' << counts[3] << "\n";
    for (const auto& [entity, box] : list) {
      text_ << tag(entity);
      const auto corner = [&](Vec3 p) { text_ << ' ' << p.x << ' ' << p.y << ' ' << p.z; };
      corner(box.low);
      if (entity.kind != EntityKind::vertex) corner(box.high);
      physical(entity);
      if (entity.kind != EntityKind::vertex) {
        const auto found = bounds.find(entity);
        text_ << ' ' << (found == bounds.end() ? 0 : found->second.size());
        if (found != bounds.end()) {
          for (const std::int64_t bounding : found->second) text_ << ' ' << bounding;
        }
      }
      text_ << '\n';
    }
    text_ << "$EndEntities\n";
  }

  /// Nodes by the first entity (of least dimension) that has them; numbers are the nodes' indices plus one.
  void nodes41() {
    std::vector<std::size_t> owner(mesh_.nodes.size(), mesh_.blocks.size());
    std::vector<std::vector<std::uint32_t>> owned(mesh_.blocks.size());
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      for (const std::uint32_t n : mesh_.blocks[b].nodes) {
        if (owner[n] != mesh_.blocks.size()) continue;
        owner[n] = b;
        owned[b].push_back(n);
      }
      std::sort(owned[b].begin(), owned[b].end());
    }
    std::size_t groups = 0, count = 0;
    for (const auto& nodes : owned) groups += nodes.empty() ? 0 : 1, count += nodes.size();
    text_ << "$Nodes\n" << groups << ' ' << count << " 1 " << mesh_.nodes.size() << "\n";
    for (std::size_t b = 0; b < owned.size(); ++b) {
      if (owned[b].empty()) continue;
      const EntityRef entity = mesh_.blocks[b].entity;
      text_ << static_cast<int>(entity.kind) << ' ' << tag(entity) << " 0 " << owned[b].size() << "\n";
      for (const std::uint32_t n : owned[b]) text_ << n + 1 << '\n';
      for (const std::uint32_t n : owned[b])
        text_ << mesh_.nodes[n].x << ' ' << mesh_.nodes[n].y << ' ' << mesh_.nodes[n].z << '\n';
    }
    text_ << "$EndNodes\n";
  }

  void element_nodes(const ElementBlock& block, std::size_t element) {
    const auto step = static_cast<std::size_t>(node_count(block.type));
    const auto order = msh_order(block.type);
    for (std::size_t i = 0; i < step; ++i) {
      const std::size_t at = order.empty() ? i : static_cast<std::size_t>(order[i]);
      text_ << ' ' << block.nodes[element * step + at] + 1;
    }
    text_ << '\n';
  }

  void elements41() {
    std::size_t groups = 0, count = 0, number = 0;
    for (const auto& block : mesh_.blocks) groups += block.size() > 0 ? 1 : 0, count += block.size();
    text_ << "$Elements\n" << groups << ' ' << count << " 1 " << count << "\n";
    for (const auto& block : mesh_.blocks) {
      if (block.size() == 0) continue;
      text_ << static_cast<int>(block.entity.kind) << ' ' << tag(block.entity) << ' ' << msh_type(block.type) << ' '
            << block.size() << "\n";
      for (std::size_t e = 0; e < block.size(); ++e) {
        text_ << ++number;
        element_nodes(block, e);
      }
    }
    text_ << "$EndElements\n";
  }

  void elements22() {
    static const std::vector<int> no_group{0};
    std::size_t count = 0, number = 0;
    const auto groups_of = [&](const ElementBlock& block) -> const std::vector<int>& {
      const auto found = groups_.find(block.entity);
      return found == groups_.end() ? no_group : found->second;
    };
    for (const auto& block : mesh_.blocks) count += block.size() * groups_of(block).size();
    text_ << "$Elements\n" << count << "\n";
    for (const auto& block : mesh_.blocks) {
      for (const int group : groups_of(block)) {
        for (std::size_t e = 0; e < block.size(); ++e) {
          text_ << ++number << ' ' << msh_type(block.type) << " 2 " << group << ' ' << tag(block.entity);
          element_nodes(block, e);
        }
      }
    }
    text_ << "$EndElements\n";
  }

  const Mesh& mesh_;
  std::map<EntityRef, std::vector<int>> groups_;      // physical groups of an entity
  std::map<std::pair<int, int>, std::string> names_;  // by dimension and number
  Text text_;
};

}  // namespace

namespace mesh_formats {

int msh_type(ElementType type) {
  static constexpr int types[] = {15, 1, 8, 2, 9, 3, 16, 4, 11, 6, 18, 5, 17};
  return types[static_cast<int>(type)];
}

std::string made_up_name(EntityRef entity) {
  return std::string(to_string(entity.kind)) + "_" + std::to_string(entity.index);
}

}  // namespace mesh_formats

Result<std::string> to_msh(const Mesh& mesh, MshVersion version) {
  ARESTA_CHECK(check_mesh(mesh));
  MshWriter writer(mesh);
  return version == MshVersion::v41 ? writer.write41() : writer.write22();
}

Status write_msh(const Mesh& mesh, const std::string& path, MshVersion version) {
  ARESTA_TRY(const std::string text, to_msh(mesh, version));
  return write_file(path, text);
}

}  // namespace aresta
