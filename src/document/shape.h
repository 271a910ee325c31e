// SPDX-License-Identifier: Apache-2.0
// What scripts call a shape: entities of one or more models. A whole model lists its regions, the faces that bound no
// region, its wire edges and its isolated vertices. Models are never changed by commands, their labels (names,
// attributes, groups) apart.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "document/registry.h"
#include "model/model.h"

namespace aresta::document {

/// Entities of one model.
struct Part {
  std::shared_ptr<Model> model;
  std::vector<EntityRef> entities;  ///< listed ones, sorted, no duplicates
};

/// A shape of the modeller.
class ModelShape final : public Shape {
 public:
  explicit ModelShape(std::vector<Part> parts, std::string name = {});

  std::string describe() const override;
  bool same_as(const Shape& other) const override;

  /// One per model, in the order in which they were given.
  const std::vector<Part>& parts() const { return parts_; }
  /// Of a group; may be empty.
  const std::string& name() const { return name_; }
  /// Does it list all of a single model?
  bool is_whole() const;

 private:
  std::vector<Part> parts_;
  std::string name_;
};
using ModelShapePtr = std::shared_ptr<const ModelShape>;

/// The side of a plane that its normal points away from, as an operand of booleans only.
class HalfSpaceShape final : public Shape {
 public:
  HalfSpaceShape(Vec3 point, Vec3 normal) : point_(point), normal_(normal) {}
  std::string describe() const override { return "half-space"; }
  bool same_as(const Shape& other) const override;
  Vec3 point() const { return point_; }
  Vec3 normal() const { return normal_; }

 private:
  Vec3 point_, normal_;
};

/// All of a model.
ShapePtr whole_shape(Model model);
ShapePtr whole_shape(std::shared_ptr<Model> model);
/// Some entities of a model.
ShapePtr shape_of(std::shared_ptr<Model> model, std::vector<EntityRef> entities);
/// One list of shapes, each of one entity.
Value shapes_of(const std::shared_ptr<Model>& model, const std::vector<EntityRef>& entities);

/// The shape as one of the modeller's; error command.type when it is something else (a mesh, a half-space).
Result<ModelShapePtr> model_shape(const Call& call, const ShapePtr& shape, const std::string& parameter);

/// Everything that belongs to listed entities: a region brings its bounding faces and what lies inside it, a face its
/// edges and what lies inside it, an edge its vertices. Each once, sorted. Index: EntityKind.
std::array<std::vector<EntityRef>, 4> closure(const Part& part);
/// Those of one kind.
std::vector<EntityRef> closure(const Part& part, EntityKind kind);

/// A model of exactly this shape: the model itself when the shape is all of it; else its closure extracted, labels
/// kept. Error for a shape of several models that meet.
Result<std::shared_ptr<Model>> as_model(const ModelShape& shape, const Context& context);

/// Entities of `result` that came from an entity of `source`, through any number of operations; sorted.
std::vector<EntityRef> images_of(const Model& result, const Model& source, EntityRef entity);

}  // namespace aresta::document
