// SPDX-License-Identifier: Apache-2.0
#include "model/inherit.h"

#include <algorithm>

namespace aresta {

namespace {

using Attributes = std::map<std::string, AttributeValue>;

const Attributes* attributes_of(const Provenance& provenance, const Parent& parent) {
  const auto& all = provenance.sources[parent.source]->labels.attributes;
  const auto found = all.find(parent.entity);
  return found == all.end() ? nullptr : &found->second;
}

std::optional<double> priority_of(const Attributes& attributes) {
  const auto found = attributes.find("priority");
  if (found == attributes.end()) return std::nullopt;
  const double* value = std::get_if<double>(&found->second);
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

/// The parents whose word counts: all, or the ones of the greatest priority when every one has a priority.
std::vector<const Attributes*> deciding(const std::vector<const Attributes*>& all) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (const Attributes* a : all) {
    const auto priority = priority_of(*a);
    if (!priority) return all;
    greatest = std::max(greatest, *priority);
  }
  std::vector<const Attributes*> result;
  for (const Attributes* a : all) {
    if (*priority_of(*a) == greatest) result.push_back(a);
  }
  return result;
}

}  // namespace

std::vector<LabelConflict> inherit_labels(Model& model) {
  std::vector<LabelConflict> conflicts;
  if (!model.provenance) return conflicts;
  model.labels = {};
  const Provenance& provenance = *model.provenance;
  std::map<std::string, std::vector<EntityRef>> groups;
  std::map<Parent, std::vector<std::string>> groups_of;
  for (std::uint32_t s = 0; s < provenance.sources.size(); ++s) {
    for (const Group& g : provenance.sources[s]->labels.groups) {
      groups[g.name];
      for (const EntityRef e : g.entities) groups_of[{s, e}].push_back(g.name);
    }
  }
  for (const auto& [entity, parents] : provenance.parents) {
    std::vector<const Attributes*> all;
    for (const Parent& p : parents) {
      if (p.entity.kind != entity.kind) continue;
      if (const Attributes* a = attributes_of(provenance, p)) all.push_back(a);
      if (const auto found = groups_of.find(p); found != groups_of.end()) {
        for (const std::string& name : found->second) groups[name].push_back(entity);
      }
    }
    for (const Attributes* from : deciding(all)) {
      for (const auto& [key, value] : *from) {
        const auto [slot, is_new] = model.labels.attributes[entity].try_emplace(key, value);
        if (is_new || slot->second == value) continue;
        if (std::none_of(conflicts.begin(), conflicts.end(),
                         [&](const LabelConflict& c) { return c.entity == entity && c.attribute == key; })) {
          conflicts.push_back({entity, key, parents});
        }
      }
    }
  }
  for (const LabelConflict& c : conflicts) model.labels.attributes[c.entity].erase(c.attribute);
  for (auto& [name, entities] : groups) {
    std::sort(entities.begin(), entities.end());
    entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
    model.labels.groups.push_back({name, std::move(entities)});
  }
  return conflicts;
}

void copy_labels(const Model& source, const ExtractionMap& from, Model& result) {
  const auto copy = [&](EntityRef old, EntityRef now) {
    const auto found = source.labels.attributes.find(old);
    if (found != source.labels.attributes.end()) result.labels.attributes[now] = found->second;
    for (std::size_t g = 0; g < source.labels.groups.size(); ++g) {
      const auto& members = source.labels.groups[g].entities;
      if (std::binary_search(members.begin(), members.end(), old)) result.labels.groups[g].entities.push_back(now);
    }
  };
  result.labels = {};
  for (const Group& g : source.labels.groups) result.labels.groups.push_back({g.name, {}});
  for (std::size_t v = 0; v < from.vertices.size(); ++v) copy(from.vertices[v], VertexId(v));
  for (std::size_t e = 0; e < from.edges.size(); ++e) copy(from.edges[e], EdgeId(e));
  for (std::size_t f = 0; f < from.faces.size(); ++f) copy(from.faces[f], FaceId(f));
  for (std::size_t r = 0; r < from.regions.size(); ++r) {
    for (const RegionId cell : from.regions[r]) {
      if (!source.is_region(cell)) continue;
      copy(cell, RegionId(r));
      break;
    }
  }
}

}  // namespace aresta
