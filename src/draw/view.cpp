// SPDX-License-Identifier: Apache-2.0
#include "draw/view.h"

#include <algorithm>
#include <array>

#include "draw/errors.h"
#include "draw/explode.h"

namespace aresta::draw {
namespace {

Error not_finite(const std::string& what, EntityRef entity) {
  return Error{errors::draw_not_finite, what + " has a coordinate that is not a finite number", {entity}};
}

Error malformed(std::string message, EntityRef entity) {
  return Error{errors::draw_malformed, std::move(message), {entity}};
}

}  // namespace

Box3 Scene::bounds() const {
  Box3 box;
  for (const FacePatch& f : faces) {
    for (const Vec3 p : f.points) box.add(p);
  }
  for (const EdgeLine& e : edges) {
    for (const Vec3 p : e.points) box.add(p);
  }
  for (const PointMark& m : points) box.add(m.point);
  return box;
}

Status check_scene(const Scene& scene) {
  const auto finite = [](const std::vector<Vec3>& v) { return std::all_of(v.begin(), v.end(), is_finite); };
  bool anything = !scene.points.empty();
  for (const FacePatch& f : scene.faces) {
    if (!finite(f.points) || !finite(f.normals)) return not_finite("a face of the picture", f.face);
    if (!f.normals.empty() && f.normals.size() != f.points.size()) {
      return malformed("a face of the picture has " + std::to_string(f.points.size()) + " points and " +
                           std::to_string(f.normals.size()) + " normals",
                       f.face);
    }
    for (const auto& t : f.triangles) {
      if (std::max({t[0], t[1], t[2]}) >= f.points.size()) {
        return malformed("a triangle of a face of the picture uses a point that is not there", f.face);
      }
    }
    anything = anything || !f.triangles.empty();
  }
  for (const EdgeLine& e : scene.edges) {
    if (!finite(e.points)) return not_finite("an edge of the picture", e.edge);
    if (e.points.size() < 2) return malformed("an edge of the picture has fewer than two points", e.edge);
    anything = true;
  }
  for (const PointMark& m : scene.points) {
    if (!is_finite(m.point)) return not_finite("a point of the picture", m.vertex);
  }
  if (!anything)
    return Error{errors::draw_empty, "there is nothing to draw: no face, edge or point", {}, {}, "draw something else"};
  return {};
}

Result<View> prepare_view(const Scene& scene, const ViewOptions& options) {
  if (!(options.explode >= 0 && options.explode <= 1e6)) {
    return Error{errors::invalid_argument, "the explode factor must be a number from 0 to 1e6"};
  }
  if (!(options.margin >= 0 && options.margin < 0.5)) {
    return Error{errors::invalid_argument, "the margin of a picture must be at least 0 and less than 0.5"};
  }
  const Viewport viewport{options.width, options.height};
  ARESTA_CHECK(check_view(options.camera.value_or(standard_camera(options.view)), viewport));
  ARESTA_CHECK(check_scene(scene));
  View view{exploded(scene, options.explode), {}, viewport};
  if (options.camera) {
    view.camera = *options.camera;
    return view;
  }
  std::vector<Vec3> points;
  for (const FacePatch& f : view.scene.faces) points.insert(points.end(), f.points.begin(), f.points.end());
  for (const EdgeLine& e : view.scene.edges) points.insert(points.end(), e.points.begin(), e.points.end());
  for (const PointMark& m : view.scene.points) points.push_back(m.point);
  view.camera = fit(standard_camera(options.view, options.projection), viewport, points, options.margin);
  ARESTA_CHECK(check_view(view.camera, viewport));
  return view;
}

FaceColors::FaceColors(const Scene& scene, Coloring coloring) : coloring_(coloring), regions_(scene.regions) {
  std::stable_sort(regions_.begin(), regions_.end(),
                   [](const RegionInfo& a, const RegionInfo& b) { return a.region < b.region; });
}

const RegionInfo* FaceColors::find(RegionId region) const {
  if (!region.valid()) return nullptr;
  const auto found = std::lower_bound(regions_.begin(), regions_.end(), region,
                                      [](const RegionInfo& a, RegionId r) { return a.region < r; });
  return found != regions_.end() && found->region == region ? &*found : nullptr;
}

Color FaceColors::of(const FacePatch& patch, int side) const {
  if (coloring_ == Coloring::faces || patch.own_color) return patch.color;
  if (const RegionInfo* behind = find(patch.regions[1 - side])) return behind->color;
  if (const RegionInfo* before = find(patch.regions[side])) return before->color;
  return patch.color;
}

Color palette(std::size_t index) {
  static constexpr std::array<Color, 12> colors{{{118, 160, 208, 255},
                                                 {238, 176, 96, 255},
                                                 {134, 186, 132, 255},
                                                 {214, 128, 122, 255},
                                                 {164, 144, 200, 255},
                                                 {224, 206, 118, 255},
                                                 {112, 188, 190, 255},
                                                 {222, 158, 190, 255},
                                                 {172, 180, 190, 255},
                                                 {176, 200, 100, 255},
                                                 {190, 152, 120, 255},
                                                 {96, 132, 170, 255}}};
  return colors[index % colors.size()];
}

}  // namespace aresta::draw
