// SPDX-License-Identifier: Apache-2.0
// Copying entities of a model into a ModelBuilder, moved by a map.
#pragma once

#include <map>

#include "construct/drafts.h"
#include "math/transform.h"
#include "model/model.h"

namespace aresta {

/// Copies what is asked for, each entity once; entities of `vertices` and `edges` that are set beforehand are shared
/// instead of copied. Curves and surfaces that entities shared stay shared. Faces keep their loops' sense, so that
/// under a mirror they come out looking the other way: turn_over them to keep front front.
class ModelCopier {
 public:
  ModelCopier(const Model& source, ModelBuilder& target, const Transform& map = {});

  VertexId vertex(VertexId v);
  Result<EdgeId> edge(EdgeId e);
  /// The face's edges and vertices are added, the face itself is left to the caller. Its fill is unknown.
  Result<FaceDraft> face(FaceId f);

  std::vector<VertexId> vertices;  ///< per vertex of the source: its copy, or invalid
  std::vector<EdgeId> edges;

 private:
  struct MappedSurface {
    SurfaceId id;
    Vec2 uv_scale{1, 1};
  };
  Result<MappedSurface> surface(SurfaceId s);
  double edge_factor(EdgeId e) const;

  const Model& source_;
  ModelBuilder& target_;
  Transform map_;
  bool moves_;  // not the identity
  double scale_ = 1;
  std::vector<CurveId> curves_;
  std::vector<MappedSurface> surfaces_;
};

/// The labels of `source` carried over by the maps; entities that were not copied lose theirs.
void copy_labels(const Labels& source, const std::map<EntityRef, EntityRef>& image, Labels& target);

}  // namespace aresta
