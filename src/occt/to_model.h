// SPDX-License-Identifier: Apache-2.0
// From shapes of the kernel library to models.
//
// Takes any mix of compounds, solids, shells, faces, wires, edges and vertices. One entity per distinct subshape (same
// object, same location); locations are applied. Parameters of curves and images are kept; images of edges in planes
// are dropped, so are edges without extent. INTERNAL edges and vertices of faces become dangling or loose edges and
// point loops. A solid fills the space behind its faces; what is filled on no side is empty; faces of no solid say
// nothing. Missing curves are built, parameters of curves and images are brought into line, and a closed surface
// without any wire gets its seams: in the shape itself, whose geometry stays as it was. Tolerances are measured: how
// far the images and ends really lie off the curves.
#pragma once

#include <memory>

#include "base/context.h"
#include "model/builder.h"
#include "occt/shape.h"

namespace aresta {

struct ToModelOptions {
  double length_unit = 1e-3;  ///< metres per unit of the shape's lengths
  double tolerance = 0;       ///< see ModelBuilder::tolerance
};

class ModelOfShape {
 public:
  struct Data;  // occt/shape_reader.h
  ModelOfShape(Model built, std::shared_ptr<const Data> data) : model(std::move(built)), data_(std::move(data)) {}

  Model model;

  /// The entity that a vertex, edge, face or solid of the shape became; invalid index when it became none.
  EntityRef entity_of(const OcctShape& subshape) const;
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// Solids that touch without sharing faces are allowed: each is a region of its own. Errors: to_model_failed (what the
/// shape lacks, and where), solids_overlap (one solid lies inside the material of another), those of
/// ModelBuilder::build, cancelled.
Result<ModelOfShape> to_model(const OcctShape& shape, const ToModelOptions& options = {}, const Context& context = {});

}  // namespace aresta
