// SPDX-License-Identifier: Apache-2.0
#include "draw/camera.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "draw/errors.h"

namespace aresta::draw {
namespace {

struct NamedView {
  StandardView view;
  const char* name;
  Vec3 from, up;
};

constexpr std::array<NamedView, 7> named_views{{
    {StandardView::iso, "iso", {1, -1, 1}, {0, 0, 1}},
    {StandardView::front, "front", {0, -1, 0}, {0, 0, 1}},
    {StandardView::back, "back", {0, 1, 0}, {0, 0, 1}},
    {StandardView::left, "left", {-1, 0, 0}, {0, 0, 1}},
    {StandardView::right, "right", {1, 0, 0}, {0, 0, 1}},
    {StandardView::top, "top", {0, 0, 1}, {0, 1, 0}},
    {StandardView::bottom, "bottom", {0, 0, -1}, {0, -1, 0}},
}};

double half_width_at_unit_depth(const Camera& camera) {
  return std::tan(camera.field_of_view * std::numbers::pi / 360);
}

}  // namespace

Result<StandardView> standard_view(std::string_view name) {
  std::string known;
  for (const NamedView& v : named_views) {
    if (name == v.name) return v.view;
    known += known.empty() ? v.name : std::string(", ") + v.name;
  }
  return Error{
      errors::draw_unknown_view, "there is no view named '" + std::string(name) + "'", {}, {}, "one of " + known};
}

const char* to_string(StandardView view) {
  return named_views[static_cast<std::size_t>(view)].name;
}

Camera standard_camera(StandardView view, Projection projection) {
  const NamedView& named = named_views[static_cast<std::size_t>(view)];
  Camera camera;
  camera.eye = named.from;
  camera.up = named.up;
  camera.projection = projection;
  return camera;
}

Camera fit(const Camera& camera, Viewport viewport, std::span<const Vec3> points, double margin) {
  if (points.empty()) return camera;
  const Projector direction(camera, viewport);
  const Vec3 r = direction.right(), u = direction.up(), f = direction.forward();
  Box3 box;  // in directions of the view
  for (const Vec3 p : points) box.add(Vec3{dot(p, r), dot(p, u), dot(p, f)});
  const Vec3 middle = box.centre();
  const double aspect = double(viewport.width) / viewport.height;
  const double usable = 1 - 2 * margin;

  Camera result = camera;
  result.target = middle.x * r + middle.y * u + middle.z * f;
  const double size = box.diagonal() > 0 ? box.diagonal() : 1;
  if (camera.projection == Projection::parallel) {
    const double width = std::max(box.high.x - box.low.x, aspect * (box.high.y - box.low.y));
    result.view_width = (width > 0 ? width : 1) / usable;
    result.eye = result.target - 2 * size * f;
    return result;
  }
  // The nearest eye from which all points lie inside the four planes of the picture's sides; then the target is moved
  // to where the middle of the picture of the points lies, and again, until it stands still.
  const double tx = half_width_at_unit_depth(camera) * usable, ty = tx / aspect;
  Vec3 centre = middle;
  double away = 0;
  for (int round = 0; round < 20; ++round) {
    away = 0.01 * size;
    for (const Vec3 p : points) {
      const double x = dot(p, r) - centre.x, y = dot(p, u) - centre.y, z = dot(p, f) - centre.z;
      away = std::max({away, std::abs(x) / tx - z, std::abs(y) / ty - z, 0.01 * size - z});
    }
    if (round == 19) break;
    double low_x = 1, high_x = -1, low_y = 1, high_y = -1;  // parts of the picture's half width and height
    for (const Vec3 p : points) {
      const double z = dot(p, f) - centre.z + away;
      const double x = (dot(p, r) - centre.x) / (z * tx), y = (dot(p, u) - centre.y) / (z * ty);
      low_x = std::min(low_x, x), high_x = std::max(high_x, x), low_y = std::min(low_y, y),
      high_y = std::max(high_y, y);
    }
    centre.x += 0.5 * (low_x + high_x) * away * tx;
    centre.y += 0.5 * (low_y + high_y) * away * ty;
  }
  result.target = centre.x * r + centre.y * u + centre.z * f;
  result.eye = result.target - away * f;
  return result;
}

Camera fit(const Camera& camera, Viewport viewport, const Box3& box, double margin) {
  if (box.empty()) return camera;
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    corners[i] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z};
  }
  return fit(camera, viewport, corners, margin);
}

Status check_view(const Camera& camera, Viewport viewport) {
  constexpr int largest = 32768;
  if (viewport.width < 1 || viewport.height < 1 || viewport.width > largest || viewport.height > largest) {
    return Error{errors::draw_bad_size, "a picture of " + std::to_string(viewport.width) + " x " +
                                            std::to_string(viewport.height) +
                                            " pixels cannot be drawn; each side has 1 to " + std::to_string(largest)};
  }
  const auto bad = [](const char* why) { return Error{errors::draw_bad_camera, std::string("the camera ") + why}; };
  if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up)) {
    return bad("has a coordinate that is not a finite number");
  }
  const Vec3 sight = camera.target - camera.eye;
  if (!(norm(sight) > 0)) return bad("has its eye at its target: no direction of sight");
  if (!(norm(cross(normalized(sight), normalized(camera.up))) > 1e-9)) {
    return bad("has its up direction along its direction of sight (or of length zero)");
  }
  if (camera.projection == Projection::parallel && !(camera.view_width > 0 && std::isfinite(camera.view_width))) {
    return bad("has a view width that is not a positive number");
  }
  if (camera.projection == Projection::perspective && !(camera.field_of_view > 0 && camera.field_of_view <= 170)) {
    return bad("has a field of view that is not between 0 and 170 degrees");
  }
  return {};
}

Projector::Projector(const Camera& camera, Viewport viewport)
    : viewport_(viewport), perspective_(camera.projection == Projection::perspective), eye_(camera.eye) {
  forward_ = normalized(camera.target - camera.eye);
  right_ = normalized(cross(forward_, camera.up));
  up_ = cross(right_, forward_);
  scale_ = perspective_ ? 0.5 * viewport.width / half_width_at_unit_depth(camera) : viewport.width / camera.view_width;
}

}  // namespace aresta::draw
