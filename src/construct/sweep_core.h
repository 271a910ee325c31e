// SPDX-License-Identifier: Apache-2.0
// The topology that extrusion and revolution share: what differs is in a SweepMotion.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/context.h"
#include "construct/options.h"
#include "geometry/curve2.h"
#include "math/transform.h"
#include "model/model.h"

namespace aresta {

/// What an edge sweeps: a surface, with the images of the edge's two copies and of the ways of its two ends. Planes
/// have no images.
struct SweptSurface {
  Surface surface;
  std::optional<Curve2> base = {}, top = {}, start = {}, end = {};
};

/// The way of a point; straight when it has no curve.
struct SweptPath {
  std::optional<Curve> curve = {};
  Range range = {};
};

class SweepMotion {
 public:
  virtual ~SweepMotion() = default;
  virtual std::string name() const = 0;
  /// Direction and speed of a point at the start; its length is comparable between points.
  virtual Vec3 velocity(Vec3 p) const = 0;
  virtual bool is_fixed(Vec3 p) const = 0;
  virtual SweptPath path(Vec3 p) const = 0;
  /// Error bad_profile when the edge sweeps no proper surface. Not asked of edges that are_fixed.
  virtual Result<SweptSurface> surface(const Model& profile, EdgeId edge) const = 0;
  /// Does the face leave itself everywhere and to one side? Its plane is given by a point and a normal.
  virtual Status check_face(const Model& profile, FaceId face, Vec3 normal) const = 0;
  virtual Transform end() const = 0;
  /// Does the end come back to the start?
  virtual bool is_closed() const = 0;
};

/// The swept model; `tolerance` is the result's, at least.
Result<Model> sweep(const std::shared_ptr<const Model>& profile, const SweepMotion& motion, double tolerance,
                    bool names, const Context& context);

/// Points along an edge, for looking at a curve: `count` + 1 of them, ends included.
std::vector<Vec3> sample_edge(const Model& model, EdgeId edge, int count);

}  // namespace aresta
