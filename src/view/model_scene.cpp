// SPDX-License-Identifier: Apache-2.0
#include "view/model_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "draw/color.h"
#include "model/measure.h"
#include "occt/tessellate.h"

namespace aresta {

namespace {

/// Soft colours that differ in hue and lightness, neighbours most.
constexpr draw::Color palette[] = {
    {142, 180, 222, 255}, {240, 190, 120, 255}, {150, 205, 150, 255}, {225, 145, 140, 255}, {185, 165, 220, 255},
    {205, 195, 140, 255}, {130, 205, 205, 255}, {235, 175, 205, 255}, {175, 185, 195, 255}, {195, 160, 135, 255}};
constexpr draw::Color sheet_color{200, 205, 190, 255};

/// The entity's own colour, if it has one.
Result<std::optional<draw::Color>> own_color(const Labels& labels, EntityRef entity) {
  const auto found = labels.attributes.find(entity);
  if (found == labels.attributes.end()) return std::optional<draw::Color>();
  const auto written = found->second.find("color");
  if (written == found->second.end()) return std::optional<draw::Color>();
  const auto* text = std::get_if<std::string>(&written->second);
  Result<draw::Color> color = draw::color_from_text(text == nullptr ? "" : *text);
  if (!color) {
    Error error = std::move(color.error());
    error.entities = {entity};
    return error;
  }
  return std::optional(*color);
}

/// White lines, as files made for dark screens have, would not be seen on paper.
bool is_pale(draw::Color c) {
  return std::min({c.r, c.g, c.b}) > 225;
}

class SceneMaker {
 public:
  SceneMaker(const Model& model, const SceneOptions& options, const Context& context)
      : model_(model), k_(model.topology()), options_(options), context_(context) {}

  Result<draw::Scene> run() {
    TessellationOptions fineness;
    fineness.deflection = options_.deflection;
    fineness.angle = options_.angle;
    ARESTA_TRY(triangles_, tessellate(model_, fineness, context_));
    scene_.title = options_.title;
    ARESTA_CHECK(add_regions());
    for (const FaceId f : k_.faces()) ARESTA_CHECK(add_face(f));
    for (const EdgeId e : k_.edges()) ARESTA_CHECK(add_edge(e));
    for (const VertexId v : k_.vertices()) {
      if (k_.isolated_in_shell(v).valid()) scene_.points.push_back({v, model_.point(v), {180, 30, 30, 255}});
    }
    return std::move(scene_);
  }

 private:
  Status add_regions() {
    std::size_t place = 0;
    for (const RegionId r : model_.regions()) {
      ARESTA_CHECK(context_.step(0.95, "measuring regions"));
      draw::RegionInfo info;
      info.region = r;
      info.name = model_.labels.name(r);
      ARESTA_TRY(const auto own, own_color(model_.labels, r));
      info.color = own ? *own : palette[place++ % std::size(palette)];
      if (options_.volumes) {
        ARESTA_TRY(const Moments moments, measure(model_, r, MeasureOptions{1e-8}));
        info.volume = moments.measure;
      }
      color_of_[r] = info.color;
      scene_.regions.push_back(std::move(info));
    }
    return {};
  }

  Status add_face(FaceId f) {
    draw::FacePatch patch;
    patch.face = f;
    for (int side = 0; side < 2; ++side) {
      const RegionId r = k_.region(FaceUse(f, side));
      if (model_.is_region(r)) patch.regions[static_cast<std::size_t>(side)] = r;
    }
    FaceTriangles& t = triangles_.faces[f.index()];
    patch.points = std::move(t.points);
    patch.normals = std::move(t.normals);
    patch.triangles = std::move(t.triangles);
    patch.name = model_.labels.name(f);
    patch.color = sheet_color;
    for (const RegionId r : {patch.regions[0], patch.regions[1]}) {  // the region behind has the last word
      if (r.valid()) patch.color = color_of_.at(r);
    }
    ARESTA_TRY(const auto own, own_color(model_.labels, f));
    if (own) {
      patch.color = *own;
      patch.own_color = true;
    }
    patch.kind = model_.surface(f).kind();
    scene_.faces.push_back(std::move(patch));
    return {};
  }

  Status add_edge(EdgeId e) {
    draw::EdgeLine line;
    line.edge = e;
    line.points = std::move(triangles_.edges[e.index()]);
    for (const CoedgeId c : k_.coedges(e)) {
      if (line.faces.empty() || line.faces.back() != k_.face(c)) line.faces.push_back(k_.face(c));
    }
    line.smooth = is_smooth(e);
    ARESTA_TRY(const auto own, own_color(model_.labels, e));
    if (own && !is_pale(*own)) line.color = *own;
    scene_.edges.push_back(std::move(line));
    return {};
  }

  bool is_smooth(EdgeId e) const {
    std::vector<CoedgeId> uses;
    for (const CoedgeId c : k_.coedges(e)) uses.push_back(c);
    if (uses.size() != 2) return false;
    // Used twice with one image it is an edge inside the face: drawn.
    const double middle = model_.range(e).middle();
    if (k_.face(uses[0]) == k_.face(uses[1]) &&
        (model_.surface(k_.face(uses[0])).is_plane() ||
         distance(model_.uv(uses[0], middle), model_.uv(uses[1], middle)) < 1e-6)) {
      return false;
    }
    const double least = std::cos(options_.smooth_angle * std::numbers::pi / 180);
    const double sign = k_.reversed(uses[0]) != k_.reversed(uses[1]) ? 1 : -1;
    for (const double share : {0.5, 0.2, 0.8}) {
      const double t = model_.range(e).at(share);
      const Vec3 a = model_.normal(k_.face(uses[0]), model_.uv(uses[0], t));
      const Vec3 b = model_.normal(k_.face(uses[1]), model_.uv(uses[1], t));
      if (sign * dot(a, b) < least) return false;
    }
    return true;
  }

  const Model& model_;
  const Complex& k_;
  const SceneOptions& options_;
  const Context& context_;
  Tessellation triangles_;
  std::map<RegionId, draw::Color> color_of_;
  draw::Scene scene_;
};

}  // namespace

Result<draw::Scene> make_scene(const Model& model, const SceneOptions& options, const Context& context) {
  return SceneMaker(model, options, context).run();
}

}  // namespace aresta
