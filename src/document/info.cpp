// SPDX-License-Identifier: Apache-2.0
#include "document/info.h"

#include <cmath>

#include "document/counting.h"
#include "model/measure.h"

namespace aresta::document {

std::string unit_name(double metres) {
  const struct {
    double metres;
    const char* name;
  } units[] = {{1e-6, "micrometre"}, {1e-3, "mm"},     {1e-2, "cm"},    {1, "m"},
               {1e3, "km"},          {0.0254, "inch"}, {0.3048, "foot"}};
  for (const auto& unit : units) {
    if (std::abs(metres - unit.metres) <= 1e-9 * unit.metres) return unit.name;
  }
  return number_text(metres) + " m";
}

Result<ModelInfo> model_info(const std::shared_ptr<Model>& shared, const Context& context) {
  const Model& model = *shared;
  const Complex& k = model.topology();
  const Part whole{shared, model.listed()};
  ModelInfo info;
  info.regions = model.regions().size();
  info.shells = shell_count(whole);
  info.faces = k.face_count();
  info.edges = k.edge_count();
  info.vertices = k.vertex_count();
  info.components = component_count(whole);
  info.bounds = model.bounds();
  info.length_unit = model.length_unit;
  info.tolerance = model.tolerance();
  for (const VertexId v : k.vertices()) {
    info.isolated_vertices += k.isolated_in_shell(v).valid();
    info.largest_tolerance = std::max(info.largest_tolerance, model.tolerance(v));
  }
  for (const EdgeId e : k.edges()) {
    info.wire_edges += k.is_wire(e);
    info.largest_tolerance = std::max(info.largest_tolerance, model.tolerance(e));
    ++info.curves[model.is_straight(e) ? "line" : model.curve(e).kind()];
  }
  for (const FaceId f : k.faces()) {
    info.constraint_faces += model.is_constraint(f);
    info.largest_tolerance = std::max(info.largest_tolerance, model.tolerance(f));
    ++info.surfaces[model.surface(f).kind()];
  }
  ARESTA_TRY(info.area, total_area(model, context));
  ARESTA_TRY(info.length, total_length(model, context));
  for (const RegionId r : model.regions()) {
    ARESTA_CHECK(context.step(0, "measuring"));
    ARESTA_TRY(const Moments m, measure(model, r));
    info.volume += m.measure;
    info.region_volumes.emplace_back(r, m.measure);
  }
  for (const auto& [entity, attributes] : model.labels.attributes) {
    if (const std::string name = model.labels.name(entity); !name.empty()) info.names.emplace_back(entity, name);
  }
  for (const Group& group : model.labels.groups) info.groups.emplace_back(group.name, group.entities.size());
  return info;
}

}  // namespace aresta::document
