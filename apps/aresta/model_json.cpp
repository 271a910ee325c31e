// SPDX-License-Identifier: Apache-2.0
#include "model_json.h"

namespace aresta::app {

Json to_json(const document::ModelInfo& info) {
  Json json;
  json["regions"] = info.regions;
  json["shells"] = info.shells;
  json["faces"] = info.faces;
  json["edges"] = info.edges;
  json["vertices"] = info.vertices;
  json["components"] = info.components;
  json["wire_edges"] = info.wire_edges;
  json["isolated_vertices"] = info.isolated_vertices;
  json["constraint_faces"] = info.constraint_faces;
  json["volume"] = info.volume;
  json["area"] = info.area;
  json["length"] = info.length;
  if (info.bounds.empty()) {
    json["bounds"] = nullptr;
  } else {
    json["bounds"] = {{info.bounds.low.x, info.bounds.low.y, info.bounds.low.z},
                      {info.bounds.high.x, info.bounds.high.y, info.bounds.high.z}};
  }
  json["unit"] = document::unit_name(info.length_unit);
  json["metres_per_unit"] = info.length_unit;
  json["tolerance"] = info.tolerance;
  json["largest_tolerance"] = info.largest_tolerance;
  json["surfaces"] = info.surfaces;
  json["curves"] = info.curves;
  Json names = Json::array();
  for (const auto& [entity, name] : info.names)
    names.push_back(
        {{"entity", std::string(to_string(entity.kind)) + " " + std::to_string(entity.index)}, {"name", name}});
  json["names"] = std::move(names);
  Json groups = Json::array();
  for (const auto& [name, size] : info.groups) groups.push_back({{"name", name}, {"entities", size}});
  json["groups"] = std::move(groups);
  Json regions = Json::array();
  for (const auto& [region, volume] : info.region_volumes)
    regions.push_back({{"region", region.index}, {"volume", volume}});
  json["region_volumes"] = std::move(regions);
  return json;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aresta::app
