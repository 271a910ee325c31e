// SPDX-License-Identifier: Apache-2.0
// Where a picture is seen from: eye, target and up in a right-handed world with z up; parallel or perspective.
//
// View coordinates: x to the right, y upwards, depth away from the eye along the direction of sight, in model units.
// Screen coordinates: pixels, x to the right, y DOWN from the upper left corner; the middle of the first pixel is (0.5,
// 0.5).
#pragma once

#include <span>
#include <string_view>

#include "base/result.h"
#include "math/box.h"
#include "math/vec.h"

namespace aresta::draw {

enum class Projection { parallel, perspective };

struct Camera {
  Vec3 eye{1, -1, 1}, target{0, 0, 0}, up{0, 0, 1};  ///< up: any direction but the direction of sight
  Projection projection = Projection::parallel;
  double view_width = 1;      ///< parallel: model units across the width of the picture
  double field_of_view = 30;  ///< perspective: angle across the width of the picture, degrees, in (0, 170]
};

/// Size of the picture in pixels.
struct Viewport {
  int width = 1600, height = 1200;
};

/// Named standard views. front looks along +y, back along -y, left along +x, right along -x, top along -z (y up in the
/// picture), bottom along +z (x to the right); iso shows front, right and top.
enum class StandardView { iso, front, back, left, right, top, bottom };

/// Error: draw_unknown_view, listing the names.
Result<StandardView> standard_view(std::string_view name);
const char* to_string(StandardView view);

/// The camera of a standard view; look at something with fit().
Camera standard_camera(StandardView view, Projection projection = Projection::parallel);

/// The camera moved and widened, its direction kept, so that all points (or the box) lie in the picture with `margin`
/// (part of the picture's size) left free on each side. A single point gets a view of width 1; no points: unchanged.
Camera fit(const Camera& camera, Viewport viewport, std::span<const Vec3> points, double margin = 0.05);
Camera fit(const Camera& camera, Viewport viewport, const Box3& box, double margin = 0.05);

/// Errors: draw_bad_camera (not finite, eye at target, up along the sight, no width), draw_bad_size (1 to 32768 pixels
/// a side).
Status check_view(const Camera& camera, Viewport viewport);

/// Maps the world to the screen. Needs a view that check_view() accepts.
class Projector {
 public:
  Projector(const Camera& camera, Viewport viewport);

  bool perspective() const { return perspective_; }
  Viewport viewport() const { return viewport_; }
  Vec3 eye() const { return eye_; }
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 forward() const { return forward_; }

  /// {right, up, depth} from the eye.
  Vec3 to_view(Vec3 p) const {
    const Vec3 d = p - eye_;
    return {dot(d, right_), dot(d, up_), dot(d, forward_)};
  }
  Vec3 to_world(Vec3 view) const { return eye_ + view.x * right_ + view.y * up_ + view.z * forward_; }
  /// {pixel x, pixel y, depth} of view coordinates; in perspective depth must be positive.
  Vec3 view_to_screen(Vec3 v) const {
    const double s = perspective_ ? scale_ / v.z : scale_;
    return {0.5 * viewport_.width + s * v.x, 0.5 * viewport_.height - s * v.y, v.z};
  }
  Vec3 to_screen(Vec3 p) const { return view_to_screen(to_view(p)); }
  /// View coordinates of what is seen at a pixel position and depth.
  Vec3 screen_to_view(Vec2 pixel, double depth) const {
    const double s = perspective_ ? depth / scale_ : 1 / scale_;
    return {(pixel.x - 0.5 * viewport_.width) * s, (0.5 * viewport_.height - pixel.y) * s, depth};
  }
  /// Model units across one pixel at a depth.
  double pixel_size(double depth) const { return perspective_ ? depth / scale_ : 1 / scale_; }
  /// Unit direction from the eye towards p.
  Vec3 sight(Vec3 p) const { return perspective_ ? normalized(p - eye_) : forward_; }

 private:
  Viewport viewport_;
  bool perspective_;
  Vec3 eye_, right_, up_, forward_;
  double scale_;  ///< pixels per model unit (perspective: at depth 1)
};

}  // namespace aresta::draw
