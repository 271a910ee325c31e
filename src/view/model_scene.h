// SPDX-License-Identifier: Apache-2.0
// The scene of a model: its faces as triangles, its edges as polylines, with colours and names.
#pragma once

#include <string>

#include "base/context.h"
#include "draw/scene.h"
#include "model/model.h"

namespace aresta {

struct SceneOptions {
  std::string title;
  double deflection = 0;      ///< greatest distance from the true shape; 0: 1e-3 of the box's diagonal
  double angle = 15;          ///< degrees between neighbouring pieces, at most
  double smooth_angle = 0.5;  ///< degrees: faces that meet at less than this go on smoothly
  bool volumes = true;        ///< measure the regions
};

/// Colours: attribute "color" ("#rrggbb") of a face, else of the region behind it, else of that before it, else of a
/// palette by the region's place among the model's; of an edge its own, unless it is too pale for a white ground.
/// Names: attribute "name". An edge is smooth when it is a seam or the two faces that it joins have one tangent plane
/// along it. Errors: those of tessellate and measure; draw_bad_color, with the entity; cancelled.
Result<draw::Scene> make_scene(const Model& model, const SceneOptions& options = {}, const Context& context = {});

}  // namespace aresta
