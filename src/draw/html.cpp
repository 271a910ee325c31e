// SPDX-License-Identifier: Apache-2.0
#include "draw/html.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "base/files.h"
#include "draw/explode.h"
#include "draw/text.h"
#include "draw/viewer_assets.h"

namespace aresta::draw {
namespace {

/// Numbers as little-endian bytes, which is what typed arrays hold on every machine that runs a browser.
template <class T>
void append_number(std::string& bytes, T value) {
  static_assert(std::endian::native == std::endian::little);
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof raw);
}

void append_place(std::string& bytes, Vec3 p) {
  for (int i = 0; i < 3; ++i) append_number(bytes, float(p[i]));
}

std::string color_json(Color c) {
  return "[" + std::to_string(c.r) + "," + std::to_string(c.g) + "," + std::to_string(c.b) + "," + std::to_string(c.a) +
         "]";
}

std::string place_json(Vec3 p) {
  return "[" + json_number(p.x) + "," + json_number(p.y) + "," + json_number(p.z) + "]";
}

std::string range_json(std::size_t first, std::size_t count) {
  return "[" + std::to_string(first) + "," + std::to_string(count) + "]";
}

/// Adds `entry` to a JSON list.
void append_entry(std::string& list, const std::string& entry) {
  if (!list.empty()) list += ",\n";
  list += entry;
}

Result<std::string> scene_json(const Scene& scene, const HtmlOptions& options, const Context& context) {
  const Box3 box = scene.bounds();
  const Vec3 centre = box.centre();
  std::map<RegionId, std::size_t> region_at;
  std::string regions;
  const std::map<RegionId, Vec3> ways = ways_apart(scene);
  for (const RegionInfo& r : scene.regions) {
    region_at.emplace(r.region, region_at.size());
    const auto way = ways.find(r.region);
    append_entry(regions, "{\"id\":" + std::to_string(r.region.value) + ",\"name\":" + json_string(r.name) +
                              ",\"color\":" + color_json(r.color) + ",\"volume\":" + json_number(r.volume) +
                              ",\"way\":" + place_json(way == ways.end() ? Vec3{} : way->second) + "}");
  }
  const auto region_json = [&](RegionId r) {
    const auto found = region_at.find(r);
    return found == region_at.end() ? std::string("-1") : std::to_string(found->second);
  };

  std::string points, normals, triangles, faces;
  std::map<FaceId, std::size_t> face_at;
  std::size_t point_count = 0, triangle_count = 0;
  for (std::size_t i = 0; i < scene.faces.size(); ++i) {
    if (i % 256 == 0) ARESTA_CHECK(context.step(0.8 * double(i) / double(scene.faces.size()), "writing faces"));
    const FacePatch& f = scene.faces[i];
    face_at.emplace(f.face, i);
    for (std::size_t k = 0; k < f.points.size(); ++k) {
      append_place(points, f.points[k] - centre);
      const Vec3 n = f.normals.empty() ? Vec3{} : normalized(f.normals[k]);
      for (int c = 0; c < 3; ++c) append_number(normals, std::int16_t(std::lround(32767 * n[c])));
    }
    for (const auto& t : f.triangles) {
      for (const std::uint32_t v : t) append_number(triangles, std::uint32_t(v + point_count));
    }
    append_entry(faces, "{\"id\":" + std::to_string(f.face.value) + ",\"name\":" + json_string(f.name) +
                            ",\"kind\":" + json_string(f.kind) + (f.own_color ? ",\"own\":true" : "") +
                            ",\"regions\":[" + region_json(f.regions[0]) + "," + region_json(f.regions[1]) +
                            "],\"color\":" + color_json(f.color) +
                            ",\"points\":" + range_json(point_count, f.points.size()) +
                            ",\"triangles\":" + range_json(triangle_count, f.triangles.size()) + "}");
    point_count += f.points.size();
    triangle_count += f.triangles.size();
  }

  std::string places, edges;
  std::size_t place_count = 0;
  for (std::size_t i = 0; i < scene.edges.size(); ++i) {
    if (i % 256 == 0) ARESTA_CHECK(context.step(0.8 + 0.2 * double(i) / double(scene.edges.size()), "writing edges"));
    const EdgeLine& e = scene.edges[i];
    if (e.smooth) continue;
    std::string around;
    for (const FaceId f : e.faces) {
      const auto found = face_at.find(f);
      if (found != face_at.end()) around += (around.empty() ? "" : ",") + std::to_string(found->second);
    }
    for (const Vec3 p : e.points) append_place(places, p - centre);
    append_entry(edges, "{\"id\":" + std::to_string(e.edge.value) + ",\"color\":" + color_json(e.color) +
                            ",\"places\":" + range_json(place_count, e.points.size()) + ",\"faces\":[" + around + "]}");
    place_count += e.points.size();
  }

  std::string marks;
  for (const PointMark& m : scene.points) {
    const Vec3 p = m.point - centre;
    append_entry(marks, "{\"id\":" + std::to_string(m.vertex.value) + ",\"color\":" + color_json(m.color) +
                            ",\"place\":" + place_json(p) + "}");
  }
  const double size = box.diagonal() > 0 ? box.diagonal() : 1;
  return "{\"size\":" + json_number(size) + ",\"view\":" + json_string(to_string(options.view)) +
         ",\"perspective\":" + (options.projection == Projection::perspective ? "true" : "false") +
         ",\"explode\":" + json_number(options.explode) +
         ",\"coloring\":" + (options.coloring == Coloring::faces ? "\"faces\"" : "\"regions\"") + ",\n\"regions\":[" +
         regions + "],\n\"faces\":[" + faces + "],\n\"edges\":[" + edges + "],\n\"marks\":[" + marks +
         "],\n\"points\":\"" + base64(points) + "\",\n\"normals\":\"" + base64(normals) + "\",\n\"triangles\":\"" +
         base64(triangles) + "\",\n\"places\":\"" + base64(places) + "\"}";
}

/// The text with each @NAME@ replaced once; what is put in is not looked at again.
std::string filled(std::string_view text, const std::map<std::string, std::string>& values) {
  std::string result;
  while (!text.empty()) {
    const std::size_t at = text.find('@');
    result += text.substr(0, at);
    if (at == std::string_view::npos) break;
    text.remove_prefix(at);
    const std::size_t end = text.find('@', 1);
    const auto value = end == std::string_view::npos ? values.end() : values.find(std::string(text.substr(1, end - 1)));
    if (value == values.end()) {
      result += '@';
      text.remove_prefix(1);
    } else {
      result += value->second;
      text.remove_prefix(end + 1);
    }
  }
  return result;
}

}  // namespace

Result<std::string> html_text(const Scene& scene, const HtmlOptions& options, const Context& context) {
  if (!(options.explode >= 0 && options.explode <= 1e6)) {
    return Error{errors::invalid_argument, "the explode factor must be a number from 0 to 1e6"};
  }
  ARESTA_CHECK(check_scene(scene));
  ARESTA_TRY(std::string json, scene_json(scene, options, context));
  return filled(viewer_html, {{"TITLE", escape_xml(scene.title.empty() ? "Model" : scene.title)},
                              {"SCENE", std::move(json)},
                              {"SCRIPT", std::string(viewer_js)}});
}

Status write_html(const Scene& scene, const HtmlOptions& options, const std::string& path, const Context& context) {
  ARESTA_TRY(const std::string text, html_text(scene, options, context));
  return write_file(path, text);
}

}  // namespace aresta::draw
