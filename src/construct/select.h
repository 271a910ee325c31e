// SPDX-License-Identifier: Apache-2.0
// Models of some entities of a model, and of the spaces that faces enclose.
#pragma once

#include <memory>
#include <span>

#include "model/model.h"

namespace aresta {

/// A model of the given entities and all that bounds them; regions stay regions, and space that other faces enclose is
/// empty. Labels follow; provenance leads to the source. Error: unknown_entity.
Result<Model> extract_entities(const std::shared_ptr<const Model>& source, std::span<const EntityRef> entities);

/// The same faces with every finite space that they enclose made a region. Ids and labels of vertices, edges and faces
/// stay. (Faces of separate models are fragmented first, so that they share their edges.)
Result<Model> detect_regions(const std::shared_ptr<const Model>& source);
/// Of these faces alone.
Result<Model> detect_regions(const std::shared_ptr<const Model>& source, std::span<const FaceId> faces);

}  // namespace aresta
