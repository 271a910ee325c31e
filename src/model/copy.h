// SPDX-License-Identifier: Apache-2.0
// A model taken apart into a builder again, entity by entity with the same ids, optionally with other geometry.
#pragma once

#include <map>

#include "model/builder.h"

namespace aresta {

/// Geometry to take in place of the model's own; the point sets must be the same within tolerance.
struct GeometryChanges {
  struct NewCurve {
    Curve curve;
    Range range;
    double deviation = 0;  ///< added to the edge's tolerance
  };
  struct NewSurface {
    Surface surface;
    bool turned = false;   ///< its natural normal is opposite to that of the old one; the face's own stays
    double deviation = 0;  ///< added to the tolerances of the face, its edges and their vertices
  };
  std::map<EdgeId, NewCurve> curves;
  std::map<FaceId, NewSurface> surfaces;
  /// For every use of a changed edge in a face that is not plane, and every use in a changed face.
  std::map<CoedgeId, Curve2> images;
};

/// Vertices, edges and faces, labels, unit and tolerance; no fills.
ModelBuilder to_builder(const Model& model, const GeometryChanges& changes = {});

/// Adds the model's vertices, edges and faces after those that a builder has; nothing else.
void append(ModelBuilder& to, const Model& model, const GeometryChanges& changes = {});

/// The model with changed geometry: its topology, cells and provenance stay.
Result<Model> with_geometry(const Model& model, const GeometryChanges& changes);

}  // namespace aresta
