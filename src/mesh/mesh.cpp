// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.h"

#include <array>

namespace aresta {

namespace {

struct TypeFacts {
  int nodes, corners, dimension;
};

constexpr std::array<TypeFacts, 13> type_facts{{{1, 1, 0},
                                                {2, 2, 1},
                                                {3, 2, 1},
                                                {3, 3, 2},
                                                {6, 3, 2},
                                                {4, 4, 2},
                                                {8, 4, 2},
                                                {4, 4, 3},
                                                {10, 4, 3},
                                                {6, 6, 3},
                                                {15, 6, 3},
                                                {8, 8, 3},
                                                {20, 8, 3}}};

const TypeFacts& facts(ElementType type) {
  return type_facts[static_cast<std::size_t>(type)];
}

double tetra_volume(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return dot(cross(b - a, c - a), d - a) / 6;
}

/// Volume enclosed by the corner faces of an element, each face fanned from its own centre: quadrilaterals need not be
/// flat.
double corner_volume(const Mesh& mesh, ElementType type, const std::uint32_t* n) {
  const auto p = [&](int i) { return mesh.nodes[n[i]]; };
  if (corner_count(type) == 4) return tetra_volume(p(0), p(1), p(2), p(3));
  // Faces of the wedge and of the hexahedron, counterclockwise from outside; -1 pads triangles.
  static constexpr int wedge[5][4] = {{0, 1, 2, -1}, {3, 5, 4, -1}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
  static constexpr int hexa[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                     {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const bool is_wedge = corner_count(type) == 6;
  const Vec3 apex = p(0);
  double volume = 0;
  for (int f = 0; f < (is_wedge ? 5 : 6); ++f) {
    const int* face = is_wedge ? wedge[f] : hexa[f];
    const int corners = face[3] < 0 ? 3 : 4;
    Vec3 centre{};
    for (int i = 0; i < corners; ++i) centre += p(face[i]) / corners;
    for (int i = 0; i < corners; ++i) volume += tetra_volume(apex, p(face[i]), p(face[(i + 1) % corners]), centre);
  }
  // In VTK the first triangle of the linear wedge has its normal outside; that of the quadratic wedge has it inside.
  return type == ElementType::wedge15 ? -volume : volume;
}

}  // namespace

int node_count(ElementType type) {
  return facts(type).nodes;
}
int corner_count(ElementType type) {
  return facts(type).corners;
}
int dimension(ElementType type) {
  return facts(type).dimension;
}

std::size_t Mesh::element_count(int dim) const {
  std::size_t count = 0;
  for (const auto& block : blocks) {
    if (dimension(block.type) == dim) count += block.size();
  }
  return count;
}

double linear_volume(const Mesh& mesh) {
  double volume = 0;
  for (const auto& block : mesh.blocks) {
    if (dimension(block.type) != 3) continue;
    const auto step = static_cast<std::size_t>(node_count(block.type));
    for (std::size_t e = 0; e < block.nodes.size(); e += step)
      volume += corner_volume(mesh, block.type, &block.nodes[e]);
  }
  return volume;
}

}  // namespace aresta
