// SPDX-License-Identifier: Apache-2.0
#include "document/shape.h"

#include <algorithm>
#include <set>

#include "construct/move.h"
#include "document/errors.h"
#include "model/extract.h"
#include "model/inherit.h"

namespace aresta::document {

namespace {

void sort_unique(std::vector<EntityRef>& entities) {
  std::sort(entities.begin(), entities.end());
  entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
}

std::string counted(std::size_t n, const char* kind) {
  return std::to_string(n) + " " + kind + (n == 1 ? "" : kind[0] == 'v' ? "" : "s");
}

/// Visits all that an entity brings along, each entity possibly several times.
class Gatherer {
 public:
  explicit Gatherer(const Model& model) : k_(model.topology()) {
    seen_[0].resize(k_.vertex_count());
    seen_[1].resize(k_.edge_count());
    seen_[2].resize(k_.face_count());
    seen_[3].resize(k_.region_count());
  }

  void add(EntityRef entity) {
    switch (entity.kind) {
      case EntityKind::vertex:
        mark(entity);
        break;
      case EntityKind::edge:
        add_edge(EdgeId(entity.index));
        break;
      case EntityKind::face:
        add_face(FaceId(entity.index));
        break;
      case EntityKind::region:
        add_region(RegionId(entity.index));
        break;
    }
  }

  std::array<std::vector<EntityRef>, 4> take() const {
    std::array<std::vector<EntityRef>, 4> out;
    for (std::uint8_t kind = 0; kind < 4; ++kind) {
      for (std::uint32_t i = 0; i < seen_[kind].size(); ++i) {
        if (seen_[kind][i]) out[kind].emplace_back(static_cast<EntityKind>(kind), i);
      }
    }
    return out;
  }

 private:
  bool mark(EntityRef e) {
    auto seen = seen_[static_cast<std::size_t>(e.kind)][e.index];
    if (seen) return false;
    seen_[static_cast<std::size_t>(e.kind)][e.index] = true;
    return true;
  }
  void add_edge(EdgeId e) {
    if (!mark(e)) return;
    mark(k_.start(e));
    mark(k_.end(e));
  }
  void add_face(FaceId f) {
    if (!mark(f)) return;
    for (const LoopId l : k_.loops(f)) {
      if (k_.is_vertex_loop(l)) {
        mark(k_.loop_vertex(l));
      } else {
        for (const CoedgeId c : k_.coedges(l)) add_edge(k_.edge(c));
      }
    }
  }
  void add_region(RegionId r) {
    if (!mark(r)) return;
    for (const ShellId s : k_.shells(r)) {
      for (const FaceUse u : k_.face_uses(s)) add_face(u.face());
      for (const EdgeId e : k_.wires(s)) add_edge(e);
      if (k_.shell_vertex(s).valid()) mark(k_.shell_vertex(s));
    }
  }

  const Complex& k_;
  std::array<std::vector<bool>, 4> seen_;
};

}  // namespace

ModelShape::ModelShape(std::vector<Part> parts, std::string name) : name_(std::move(name)) {
  for (Part& part : parts) {
    const auto same = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.model == part.model; });
    if (same == parts_.end()) {
      parts_.push_back(std::move(part));
    } else {
      same->entities.insert(same->entities.end(), part.entities.begin(), part.entities.end());
    }
  }
  for (Part& part : parts_) sort_unique(part.entities);
}

std::string ModelShape::describe() const {
  std::array<std::size_t, 4> counts{};
  for (const Part& part : parts_) {
    for (const EntityRef e : part.entities) ++counts[static_cast<std::size_t>(e.kind)];
  }
  std::string text;
  constexpr const char* kinds[] = {"vertice", "edge", "face", "region"};
  for (std::size_t kind = 4; kind-- > 0;) {
    if (counts[kind] == 0) continue;
    text += (text.empty() ? "" : ", ");
    text += kind == 0 && counts[0] == 1 ? "1 vertex"
            : kind == 0                 ? std::to_string(counts[0]) + " vertices"
                                        : counted(counts[kind], kinds[kind]);
  }
  if (text.empty()) text = "nothing";
  return (name_.empty() ? "shape of " : "group '" + name_ + "' of ") + text;
}

bool ModelShape::same_as(const Shape& other) const {
  const auto* shape = dynamic_cast<const ModelShape*>(&other);
  if (shape == nullptr || shape->parts_.size() != parts_.size()) return false;
  return std::all_of(parts_.begin(), parts_.end(), [&](const Part& p) {
    return std::any_of(shape->parts_.begin(), shape->parts_.end(),
                       [&](const Part& q) { return q.model == p.model && q.entities == p.entities; });
  });
}

bool ModelShape::is_whole() const {
  return parts_.size() == 1 && parts_[0].entities == parts_[0].model->listed();
}

bool HalfSpaceShape::same_as(const Shape& other) const {
  const auto* shape = dynamic_cast<const HalfSpaceShape*>(&other);
  return shape != nullptr && shape->point_ == point_ && shape->normal_ == normal_;
}

ShapePtr whole_shape(std::shared_ptr<Model> model) {
  std::vector<EntityRef> listed = model->listed();
  return shape_of(std::move(model), std::move(listed));
}

ShapePtr whole_shape(Model model) {
  return whole_shape(std::make_shared<Model>(std::move(model)));
}

ShapePtr shape_of(std::shared_ptr<Model> model, std::vector<EntityRef> entities) {
  return std::make_shared<const ModelShape>(std::vector<Part>{{std::move(model), std::move(entities)}});
}

Value shapes_of(const std::shared_ptr<Model>& model, const std::vector<EntityRef>& entities) {
  std::vector<Value> list;
  list.reserve(entities.size());
  for (const EntityRef e : entities) list.emplace_back(shape_of(model, {e}));
  return Value::list(std::move(list));
}

Result<ModelShapePtr> model_shape(const Call& call, const ShapePtr& shape, const std::string& parameter) {
  if (auto model = std::dynamic_pointer_cast<const ModelShape>(shape)) return model;
  return Error{errors::command_type,
               call.command().name + ": " + parameter + " must be a shape of a model, not <" + shape->describe() + ">"};
}

std::array<std::vector<EntityRef>, 4> closure(const Part& part) {
  Gatherer gatherer(*part.model);
  for (const EntityRef e : part.entities) gatherer.add(e);
  return gatherer.take();
}

std::vector<EntityRef> closure(const Part& part, EntityKind kind) {
  auto members = closure(part);
  return std::move(members[static_cast<std::size_t>(kind)]);
}

Result<std::shared_ptr<Model>> as_model(const ModelShape& shape, const Context& context) {
  if (shape.is_whole()) return shape.parts()[0].model;
  std::vector<std::shared_ptr<Model>> models;
  for (const Part& part : shape.parts()) {
    if (part.entities == part.model->listed()) {
      models.push_back(part.model);
      continue;
    }
    const auto members = closure(part);
    Selection selection = empty_selection(*part.model);
    for (const EntityRef e : members[0]) selection.vertices[e.index] = true;
    for (const EntityRef e : members[1]) selection.edges[e.index] = true;
    for (const EntityRef e : members[2]) selection.faces[e.index] = true;
    for (const EntityRef e : members[3]) selection.filled[e.index] = true;
    ARESTA_TRY(Extraction extraction, extract(*part.model, selection));
    auto provenance = std::make_shared<Provenance>();
    provenance->sources = {part.model};
    const auto parent = [&](EntityRef to, EntityRef from) { provenance->parents[to] = {{0, from}}; };
    for (std::size_t i = 0; i < extraction.from.vertices.size(); ++i) parent(VertexId(i), extraction.from.vertices[i]);
    for (std::size_t i = 0; i < extraction.from.edges.size(); ++i) parent(EdgeId(i), extraction.from.edges[i]);
    for (std::size_t i = 0; i < extraction.from.faces.size(); ++i) parent(FaceId(i), extraction.from.faces[i]);
    for (std::size_t i = 1; i < extraction.from.regions.size(); ++i) {
      if (!extraction.model.is_region(RegionId(i))) continue;
      for (const RegionId r : extraction.from.regions[i]) {
        if (part.model->is_region(r)) provenance->parents[RegionId(i)].push_back({0, r});
      }
    }
    extraction.model.provenance = std::move(provenance);
    inherit_labels(extraction.model);
    models.push_back(std::make_shared<Model>(std::move(extraction.model)));
  }
  if (models.size() == 1) return models[0];
  std::vector<const Model*> pointers;
  for (const auto& m : models) pointers.push_back(m.get());
  ARESTA_TRY(Model merged, merge_disjoint(pointers, context));
  return std::make_shared<Model>(std::move(merged));
}

std::vector<EntityRef> images_of(const Model& result, const Model& source, EntityRef entity) {
  std::vector<EntityRef> found;
  if (&result == &source) return {entity};
  if (!result.provenance) return found;
  const Provenance& provenance = *result.provenance;
  for (std::uint32_t s = 0; s < provenance.sources.size(); ++s) {
    for (const EntityRef inner : images_of(*provenance.sources[s], source, entity)) {
      const auto images = provenance.images({s, inner});
      found.insert(found.end(), images.begin(), images.end());
    }
  }
  sort_unique(found);
  return found;
}

}  // namespace aresta::document
