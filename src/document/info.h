// SPDX-License-Identifier: Apache-2.0
// What there is to say about a model in figures: for `info`, summaries and front ends.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "document/shape.h"
#include "math/box.h"

namespace aresta::document {

struct ModelInfo {
  std::size_t regions = 0, shells = 0, faces = 0, edges = 0, vertices = 0;
  std::size_t wire_edges = 0, isolated_vertices = 0, constraint_faces = 0, components = 0;
  Box3 bounds;
  double volume = 0, area = 0, length = 0;
  double length_unit = 1e-3;                            ///< metres per document unit
  double tolerance = 0, largest_tolerance = 0;          ///< the model's, and the largest of its entities
  std::map<std::string, std::size_t> surfaces, curves;  ///< kinds: "plane" -> 6
  std::vector<std::pair<EntityRef, std::string>> names;
  std::vector<std::pair<std::string, std::size_t>> groups;  ///< with their sizes
  std::vector<std::pair<EntityRef, double>> region_volumes;
};

Result<ModelInfo> model_info(const std::shared_ptr<Model>& model, const Context& context);

/// "mm", "m", "inch", ..., or the number of metres.
std::string unit_name(double metres);

}  // namespace aresta::document
