// SPDX-License-Identifier: Apache-2.0
// Independent measures of meshes for tests.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "mesh/mesh_model.h"

namespace aresta::test {

inline Mesh made(const Model& model, const MeshOptions& options) {
  auto result = mesh_model(model, options);
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(result).value();
}

/// Volume of a region's tetrahedra; of ten-node ones with their curved sides: the determinant is cubic, which Keast's
/// five points integrate exactly.
inline double region_volume(const Mesh& mesh, RegionId region) {
  double volume = 0;
  for (const auto& block : mesh.blocks) {
    if (block.entity != EntityRef(region)) continue;
    const auto step = static_cast<std::size_t>(node_count(block.type));
    for (std::size_t i = 0; i < block.nodes.size(); i += step) {
      const auto p = [&](std::size_t k) { return mesh.nodes[block.nodes[i + k]]; };
      if (block.type == ElementType::tetra4) {
        volume += dot(cross(p(1) - p(0), p(2) - p(0)), p(3) - p(0)) / 6;
        continue;
      }
      const auto det = [&](double a, double b, double c) {
        const double d = 1 - a - b - c;  // barycentric coordinates d, a, b, c of corners 0..3
        Vec3 column[3];
        const double l[4] = {d, a, b, c};
        const int mids[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
        for (int j = 1; j < 4; ++j) {
          Vec3 sum = (4 * l[j] - 1) * p(static_cast<std::size_t>(j)) - (4 * l[0] - 1) * p(0);
          for (std::size_t m = 0; m < 6; ++m) {
            const int x = mids[m][0], y = mids[m][1];
            const double derivative = (x == j ? l[y] : y == j ? l[x] : 0) - (x == 0 ? l[y] : y == 0 ? l[x] : 0);
            sum += 4 * derivative * p(4 + m);
          }
          column[j - 1] = sum;
        }
        return dot(cross(column[0], column[1]), column[2]);
      };
      const double s = 1.0 / 6;
      volume +=
          (-0.8 * det(0.25, 0.25, 0.25) + 0.45 * (det(s, s, s) + det(0.5, s, s) + det(s, 0.5, s) + det(s, s, 0.5))) / 6;
    }
  }
  return volume;
}

/// Vertices minus edges plus triangles of the surface blocks of the faces given (all when empty).
inline int surface_euler(const Mesh& mesh, const std::set<EntityRef>& faces = {}) {
  std::set<std::array<std::uint32_t, 2>> sides;
  std::set<std::uint32_t> nodes;
  int triangles = 0;
  for (const auto& block : mesh.blocks) {
    if (dimension(block.type) != 2 || (!faces.empty() && !faces.contains(block.entity))) continue;
    const auto step = static_cast<std::size_t>(node_count(block.type));
    for (std::size_t i = 0; i < block.nodes.size(); i += step) {
      ++triangles;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = block.nodes[i + k], b = block.nodes[i + (k + 1) % 3];
        nodes.insert(a);
        sides.insert({std::min(a, b), std::max(a, b)});
      }
    }
  }
  return static_cast<int>(nodes.size()) - static_cast<int>(sides.size()) + triangles;
}

using Triple = std::array<std::uint32_t, 3>;

/// How many tetrahedra have each triangle as a side, by region.
inline std::map<Triple, std::vector<EntityRef>> tetra_sides(const Mesh& mesh) {
  std::map<Triple, std::vector<EntityRef>> sides;
  for (const auto& block : mesh.blocks) {
    if (dimension(block.type) != 3) continue;
    const auto step = static_cast<std::size_t>(node_count(block.type));
    for (std::size_t i = 0; i < block.nodes.size(); i += step) {
      for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        Triple t{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          if (k != left_out) t[count++] = block.nodes[i + k];
        }
        std::sort(t.begin(), t.end());
        sides[t].push_back(block.entity);
      }
    }
  }
  return sides;
}

/// The regions on the two sides of a face, told by the tetrahedra that have its triangles: the same for every triangle.
inline std::vector<EntityRef> regions_at(const Mesh& mesh, FaceId face) {
  const auto sides = tetra_sides(mesh);
  std::set<std::vector<EntityRef>> answers;
  for (const auto& block : mesh.blocks) {
    if (block.entity != EntityRef(face)) continue;
    const auto step = static_cast<std::size_t>(node_count(block.type));
    for (std::size_t i = 0; i < block.nodes.size(); i += step) {
      Triple t{block.nodes[i], block.nodes[i + 1], block.nodes[i + 2]};
      std::sort(t.begin(), t.end());
      const auto found = sides.find(t);
      auto regions = found == sides.end() ? std::vector<EntityRef>{} : found->second;
      std::sort(regions.begin(), regions.end());
      answers.insert(regions);
    }
  }
  if (answers.size() != 1) throw std::runtime_error("the triangles of a face have different neighbours");
  return *answers.begin();
}

/// Every side of every tetrahedron is shared by two, or is a triangle of a face.
inline bool is_conforming(const Mesh& mesh) {
  std::set<Triple> surface;
  for (const auto& block : mesh.blocks) {
    if (dimension(block.type) != 2) continue;
    const auto step = static_cast<std::size_t>(node_count(block.type));
    for (std::size_t i = 0; i < block.nodes.size(); i += step) {
      Triple t{block.nodes[i], block.nodes[i + 1], block.nodes[i + 2]};
      std::sort(t.begin(), t.end());
      surface.insert(t);
    }
  }
  for (const auto& [side, regions] : tetra_sides(mesh)) {
    if (regions.size() > 2) return false;
    if (regions.size() == 1 && !surface.contains(side)) return false;
    if (regions.size() == 2 && regions[0] != regions[1] && !surface.contains(side)) return false;
  }
  return true;
}

/// The nodes of an entity's elements.
inline std::set<std::uint32_t> nodes_of(const Mesh& mesh, EntityRef entity) {
  std::set<std::uint32_t> nodes;
  for (const auto& block : mesh.blocks) {
    if (block.entity == entity) nodes.insert(block.nodes.begin(), block.nodes.end());
  }
  return nodes;
}

inline double face_area(const Mesh& mesh, EntityRef face) {
  double area = 0;
  for (const auto& block : mesh.blocks) {
    if (block.entity != face) continue;
    const auto step = static_cast<std::size_t>(node_count(block.type));
    for (std::size_t i = 0; i < block.nodes.size(); i += step) {
      const Vec3 a = mesh.nodes[block.nodes[i]], b = mesh.nodes[block.nodes[i + 1]], c = mesh.nodes[block.nodes[i + 2]];
      area += 0.5 * norm(cross(b - a, c - a));
    }
  }
  return area;
}

}  // namespace aresta::test
