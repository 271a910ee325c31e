// SPDX-License-Identifier: Apache-2.0
#include "exchange/mesh_formats_text.h"

#include <algorithm>
#include <cmath>

#include "exchange/errors.h"

namespace aresta::mesh_formats {

Status check_mesh(const Mesh& mesh) {
  for (const Vec3& p : mesh.nodes) {
    if (!is_finite(p))
      return Error{errors::exchange_bad_mesh, "a node of the mesh has a coordinate that is not a finite number"};
  }
  for (const auto& block : mesh.blocks) {
    if (block.nodes.size() % static_cast<std::size_t>(node_count(block.type)) != 0) {
      return Error{errors::exchange_bad_mesh, "a block of the mesh holds part of an element", {block.entity}};
    }
    for (const std::uint32_t n : block.nodes) {
      if (n >= mesh.nodes.size())
        return Error{
            errors::exchange_bad_mesh, "an element of the mesh names a node that does not exist", {block.entity}};
    }
  }
  return {};
}

// In VTK the linear wedge has its first triangle's normal outside; MSH and INP have it inside.
static constexpr int turned_wedge[] = {0, 2, 1, 3, 5, 4};

std::span<const int> msh_order(ElementType type) {
  static constexpr int tetra10[] = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  static constexpr int wedge15[] = {0, 1, 2, 3, 4, 5, 6, 8, 12, 7, 13, 14, 9, 11, 10};
  static constexpr int hexa20[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14};
  switch (type) {
    case ElementType::tetra10:
      return tetra10;
    case ElementType::wedge6:
      return turned_wedge;
    case ElementType::wedge15:
      return wedge15;
    case ElementType::hexa20:
      return hexa20;
    default:
      return {};
  }
}

std::span<const int> inp_order(ElementType type) {
  if (type == ElementType::wedge6) return turned_wedge;
  return {};
}

std::span<const std::array<int, 4>> corner_sides(ElementType type) {
  // Abaqus' order of sides, corners counterclockwise from outside; -1 pads triangles.
  static constexpr std::array<int, 4> tetra[] = {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}};
  static constexpr std::array<int, 4> wedge[] = {
      {0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  static constexpr std::array<int, 4> wedge_vtk[] = {
      {0, 1, 2, -1}, {3, 5, 4, -1}, {0, 3, 5, 2}, {2, 5, 4, 1}, {1, 4, 3, 0}};
  static constexpr std::array<int, 4> hexa[] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  switch (type) {
    case ElementType::tetra4:
    case ElementType::tetra10:
      return tetra;
    case ElementType::wedge6:
      return wedge_vtk;
    case ElementType::wedge15:
      return wedge;
    case ElementType::hexa8:
    case ElementType::hexa20:
      return hexa;
    default:
      return {};
  }
}

std::array<std::uint32_t, 4> side_key(const std::uint32_t* nodes, int corners) {
  std::array<std::uint32_t, 4> key{0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu};
  for (int i = 0; i < corners; ++i) key[static_cast<std::size_t>(i)] = nodes[i];
  std::sort(key.begin(), key.end());
  return key;
}

std::vector<ElementSide> volume_sides(const Mesh& mesh) {
  std::vector<ElementSide> sides;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const auto& block = mesh.blocks[b];
    const auto step = static_cast<std::size_t>(node_count(block.type));
    const auto list = corner_sides(block.type);
    for (std::size_t e = 0; e * step < block.nodes.size() && !list.empty(); ++e) {
      for (std::size_t s = 0; s < list.size(); ++s) {
        std::uint32_t corners[4];
        int count = 0;
        for (const int c : list[s]) {
          if (c >= 0) corners[count++] = block.nodes[e * step + static_cast<std::size_t>(c)];
        }
        sides.push_back({side_key(corners, count), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(e),
                         static_cast<int>(s)});
      }
    }
  }
  std::sort(sides.begin(), sides.end(), [](const ElementSide& a, const ElementSide& b) {
    return std::tie(a.key, a.block, a.element) < std::tie(b.key, b.block, b.element);
  });
  return sides;
}

}  // namespace aresta::mesh_formats
