// SPDX-License-Identifier: Apache-2.0
// A straight-sided mesh of a model between the steps that make it, with the parameters that curving it needs.
#pragma once

#include "mesh/face_mesh.h"
#include "mesh/volume_input.h"

namespace aresta::mesh {

struct LinearFace {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< nodes of the whole mesh
  std::vector<std::uint32_t> nodes;                     ///< sorted: those of the triangles
  std::vector<Vec2> uv;                                 ///< of `nodes`: one image of each
  std::vector<bool> inner;  ///< of `nodes`: inside the face, so that its image is the only one
};

struct LinearMesh {
  std::vector<Vec3> nodes;        ///< vertices', edges', faces', regions'
  std::vector<EdgeChain> chains;  ///< per edge
  std::vector<LinearFace> faces;  ///< per face; empty below dimension 2
  std::vector<Tetra> tetras;      ///< region: index of the model's region plus one
};

/// Two-node sides become three-node ones: adds mid-side nodes on curves and surfaces, and straightens those that would
/// turn a tetrahedron inside out. `mid` answers the middle node of a side.
class SecondOrder {
 public:
  SecondOrder(const Model& model, LinearMesh& mesh);
  std::uint32_t mid(std::uint32_t a, std::uint32_t b) const;
  /// Sides whose middle node had to leave its surface.
  std::size_t straightened() const { return straightened_; }

 private:
  std::uint32_t add(std::uint32_t a, std::uint32_t b, Vec3 p);
  bool known(std::uint32_t a, std::uint32_t b) const;
  void straighten();

  LinearMesh& mesh_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> mids_;  ///< per lower node: upper node, middle
  std::size_t straightened_ = 0;
};

}  // namespace aresta::mesh
