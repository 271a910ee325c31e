// SPDX-License-Identifier: Apache-2.0
// A finite element mesh as plain arrays: what meshers make, solvers read and viewers draw. Knows nothing of models.
//
// Nodes are shared by everything that touches there: one interface has one set of nodes, whatever the number of
// regions. Indices are zero-based here; the writers of file formats add one where their format wants it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/ids.h"
#include "math/vec.h"

namespace aresta {

/// Node order of every type is that of VTK (quadratic: corners first, then mid-edge nodes).
enum class ElementType : std::uint8_t {
  point1,
  line2,
  line3,
  triangle3,
  triangle6,
  quad4,
  quad8,
  tetra4,
  tetra10,
  wedge6,
  wedge15,
  hexa8,
  hexa20
};

int node_count(ElementType type);
int corner_count(ElementType type);
/// 0 point, 1 line, 2 surface, 3 volume.
int dimension(ElementType type);

/// All elements of one type that lie on one entity of the model.
struct ElementBlock {
  ElementType type = ElementType::tetra4;
  EntityRef entity;                  ///< the model's entity these elements discretise
  std::vector<std::uint32_t> nodes;  ///< node_count(type) per element; triangles are oriented as their face
  std::size_t size() const { return nodes.size() / static_cast<std::size_t>(node_count(type)); }
};

/// A named set of model entities (a region's name, a group): written as element, surface and node sets.
struct MeshSet {
  std::string name;
  std::vector<EntityRef> entities;  ///< sorted, each with at least one block
};

struct Mesh {
  std::vector<Vec3> nodes;
  std::vector<ElementBlock> blocks;  ///< sorted by entity, then type
  std::vector<MeshSet> sets;         ///< in the order of the model's names and groups

  std::size_t element_count(int dim) const;
};

/// Signed volume of all volume elements by their corner (linear) geometry.
double linear_volume(const Mesh& mesh);

}  // namespace aresta
