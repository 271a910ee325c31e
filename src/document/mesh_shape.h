// SPDX-License-Identifier: Apache-2.0
// A finite element mesh as scripts hold it.
#pragma once

#include "document/registry.h"
#include "mesh/mesh.h"

namespace aresta::document {

class MeshShape final : public Shape {
 public:
  explicit MeshShape(Mesh mesh) : mesh_(std::move(mesh)) {}
  std::string describe() const override;
  bool same_as(const Shape& other) const override { return this == &other; }
  const Mesh& mesh() const { return mesh_; }
  /// Elements of the highest dimension that there is.
  std::size_t element_count() const;

 private:
  Mesh mesh_;
};

}  // namespace aresta::document
