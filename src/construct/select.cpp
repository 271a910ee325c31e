// SPDX-License-Identifier: Apache-2.0
#include "construct/select.h"

#include <algorithm>

#include "construct/copy.h"
#include "model/extract.h"

namespace aresta {

namespace {

std::size_t count_of(const Model& model, EntityKind kind) {
  const Complex& k = model.topology();
  const std::size_t counts[] = {k.vertex_count(), k.edge_count(), k.face_count(), k.region_count()};
  return counts[static_cast<int>(kind)];
}

Error unknown(EntityRef entity) {
  return Error{errors::unknown_entity, "the model has no such entity", {entity}};
}

/// Labels and provenance of what was extracted.
void follow(const std::shared_ptr<const Model>& source, const ExtractionMap& from, Model& model) {
  auto provenance = std::make_shared<Provenance>();
  provenance->sources.push_back(source);
  std::map<EntityRef, EntityRef> image;
  const auto record = [&](EntityRef result, EntityRef parent) {
    provenance->parents[result].push_back({0, parent});
    image[parent] = result;
  };
  for (std::size_t i = 0; i < from.vertices.size(); ++i) record(VertexId(i), from.vertices[i]);
  for (std::size_t i = 0; i < from.edges.size(); ++i) record(EdgeId(i), from.edges[i]);
  for (std::size_t i = 0; i < from.faces.size(); ++i) record(FaceId(i), from.faces[i]);
  for (std::size_t i = 1; i < from.regions.size(); ++i) {
    if (!model.is_region(RegionId(i))) continue;
    for (const RegionId r : from.regions[i]) {
      if (source->is_region(r)) record(RegionId(i), r);
    }
  }
  copy_labels(source->labels, image, model.labels);
  std::erase_if(model.labels.groups, [](const Group& g) { return g.entities.empty(); });
  model.provenance = provenance;
}

Result<Model> extracted(const std::shared_ptr<const Model>& source, const Selection& selection) {
  ARESTA_TRY(Extraction extraction, extract(*source, selection));
  follow(source, extraction.from, extraction.model);
  return std::move(extraction.model);
}

}  // namespace

Result<Model> extract_entities(const std::shared_ptr<const Model>& source, std::span<const EntityRef> entities) {
  const Complex& k = source->topology();
  Selection keep = empty_selection(*source);
  for (const EntityRef entity : entities) {
    if (entity.index >= count_of(*source, entity.kind)) return unknown(entity);
    switch (entity.kind) {
      case EntityKind::vertex:
        keep.vertices[entity.index] = true;
        break;
      case EntityKind::edge:
        keep.edges[entity.index] = true;
        break;
      case EntityKind::face:
        keep.faces[entity.index] = true;
        keep.constraint[entity.index] = source->is_constraint(FaceId(entity.index));
        break;
      case EntityKind::region: {
        const RegionId r(entity.index);
        if (!source->is_region(r)) return unknown(entity);
        keep.filled[r.index()] = true;
        for (const ShellId s : k.shells(r)) {
          for (const FaceUse u : k.face_uses(s)) keep.faces[u.face().index()] = true;
          for (const EdgeId e : k.wires(s)) keep.edges[e.index()] = true;
          if (k.shell_vertex(s).valid()) keep.vertices[k.shell_vertex(s).index()] = true;
        }
        break;
      }
    }
  }
  close_downwards(*source, keep, true);
  return extracted(source, keep);
}

Result<Model> detect_regions(const std::shared_ptr<const Model>& source) {
  const Complex& k = source->topology();
  Selection keep = empty_selection(*source);
  keep.vertices.assign(keep.vertices.size(), true);
  keep.edges.assign(keep.edges.size(), true);
  keep.faces.assign(keep.faces.size(), true);
  keep.filled.assign(keep.filled.size(), true);
  keep.filled[Complex::infinite_region().index()] = false;
  for (const FaceId f : k.faces()) {
    keep.constraint[f.index()] = source->is_constraint(f) && k.has_same_region_on_both_sides(f);
  }
  return extracted(source, keep);
}

Result<Model> detect_regions(const std::shared_ptr<const Model>& source, std::span<const FaceId> faces) {
  std::vector<EntityRef> entities(faces.begin(), faces.end());
  ARESTA_TRY(Model model, extract_entities(source, entities));
  const auto provenance = model.provenance;
  const auto alone = std::make_shared<const Model>(std::move(model));
  ARESTA_TRY(Model detected, detect_regions(alone));
  // The extraction kept no regions and its faces keep their ids here, so its provenance holds as it is.
  detected.provenance = provenance;
  return detected;
}

}  // namespace aresta
