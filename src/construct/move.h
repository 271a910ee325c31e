// SPDX-License-Identifier: Apache-2.0
// Moving, turning, scaling and mirroring models, arrays of copies, and joining models that do not touch.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/context.h"
#include "construct/options.h"
#include "math/transform.h"
#include "model/model.h"

namespace aresta {

/// The model under an affine map. Entity ids, labels, groups and provenance stay as they are; a front stays a front
/// under a mirror. Similarities (moves, turns, mirrors, uniform scalings) take every model and are exact; other maps
/// take what has only plane faces and straight edges, and free-form geometry. Errors: bad_size (numbers that are not
/// finite, a singular map), not_similar.
Result<Model> transform(const Model& model, const Transform& map);

Result<Model> translate(const Model& model, Vec3 offset);
/// Right-handed turn in degrees.
Result<Model> rotate(const Model& model, double angle, Vec3 axis = {0, 0, 1}, Vec3 about = {});
/// `factor` is positive.
Result<Model> scale(const Model& model, double factor, Vec3 about = {});
/// Reflection in the plane through `point` with this normal.
Result<Model> mirror(const Model& model, Vec3 point, Vec3 normal);

/// Copies at (i step.x, j step.y, k step.z), i fastest: separate models, since neighbours may touch (fragment or join
/// them). At most a million copies.
Result<std::vector<Model>> grid(const Model& model, std::array<int, 3> count, Vec3 step);

/// One model of several whose boxes do not touch; entities in the order of the models. Groups of one name become one;
/// provenance is kept. Errors: not_disjoint names the first two whose boxes meet: use union or fragment for these;
/// mixed_units.
Result<Model> merge_disjoint(std::span<const Model* const> models, const Context& context = {});

}  // namespace aresta
