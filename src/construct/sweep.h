// SPDX-License-Identifier: Apache-2.0
// Sweeping models of faces, wires and points along a straight way or about an axis: each entity gives one of the next
// dimension.
//
// Contract. The profile holds faces (with holes, with edges and points inside), wires and isolated points, but no
// regions. A curved face must move to one side of itself everywhere. Entities that share a boundary sweep to entities
// that share theirs, so that neighbouring faces become regions with one common wall. Side faces are exact: a line gives
// a plane, cylinder or cone, an arc a cylinder, sphere or torus where it can, anything else a free-form surface of
// extrusion or revolution that keeps the curve. Sweeps that run into themselves are refused: by the profile's position,
// and for profiles of several entities by the full checker. Provenance leads from each result entity to the profile's
// entity that made it. Names on request: "start" and "end" for the two copies of a face, "side" for what edges sweep.
//
// Errors: bad_size (arguments), bad_profile (what cannot be swept, named), sweep_overlaps.
#pragma once

#include <memory>

#include "base/context.h"
#include "construct/options.h"
#include "model/model.h"

namespace aresta {

/// Along `vector`, which leaves the planes of the profile's faces.
Result<Model> extrude(const std::shared_ptr<const Model>& profile, Vec3 vector, const ConstructOptions& options = {},
                      const Context& context = {});

/// By `angle` degrees (right-handed; up to 360 either way) about the line through `about` along `axis`. The profile may
/// touch the axis in vertices and edges, but not cross it.
Result<Model> revolve(const std::shared_ptr<const Model>& profile, double angle = 360, Vec3 about = {},
                      Vec3 axis = {0, 0, 1}, const ConstructOptions& options = {}, const Context& context = {});

}  // namespace aresta
