// SPDX-License-Identifier: Apache-2.0
// From models to shapes of the kernel library.
//
// Guarantees: one library vertex, edge and face per entity, shared by all that use it; parameters of curves and images
// are kept. Seams become edges with two images, pole and apex gaps get the library's edges without extent, dangling
// edges and points inside faces become INTERNAL members of the face. Tolerances are at least 1e-7 (the library's own
// least) and grow from face to edge to vertex.
// The whole is a compound: a solid per region (its voids as further shells), then every face that bounds no region,
// every wire edge, every isolated vertex, each by itself. Linear in the model's size.
#pragma once

#include <memory>
#include <vector>

#include "base/context.h"
#include "model/model.h"
#include "occt/shape.h"

namespace aresta {

struct ToShapeOptions {
  bool solids = true;                     ///< false: the whole holds all faces, wires and points, but no solids
  bool internal_faces_in_solids = false;  ///< true: faces within one region go into its solid, INTERNAL
};

class ModelShape {
 public:
  struct Data;  // occt/model_shape.h
  explicit ModelShape(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

  OcctShape whole() const;
  /// The shape of one entity; null for a region that is none (the infinite one, empty cells).
  OcctShape of(EntityRef entity) const;

 private:
  std::shared_ptr<const Data> data_;
};

/// Errors: to_shape_failed names the face or edge that the library cannot hold (an image missing, a loop with a gap
/// that is no pole, a side without a seam), or cancelled.
Result<ModelShape> to_shape(const Model& model, const ToShapeOptions& options = {}, const Context& context = {});

}  // namespace aresta
