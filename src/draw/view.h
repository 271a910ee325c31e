// SPDX-License-Identifier: Apache-2.0
// What every writer does to a scene before it draws: check it, move regions apart, choose the camera.
#pragma once

#include <optional>

#include "base/result.h"
#include "draw/camera.h"
#include "draw/scene.h"

namespace aresta::draw {

struct ViewOptions {
  StandardView view = StandardView::iso;
  Projection projection = Projection::parallel;
  std::optional<Camera> camera = {};  ///< used as it is; without one, `view` fitted to the scene
  int width = 1600, height = 1200;    ///< pixels
  double margin = 0.05;               ///< free on each side, part of the picture's size
  double explode = 0;  ///< how far regions move apart: 0 not, 1 all of their way (ways_apart in explode.h)
};

enum class Coloring {
  regions,  ///< a face has the colour of the region behind the side that is seen (or of the one before it), if it has
            ///< no own
  faces,    ///< FacePatch::color
};

/// Nothing in it is out of range or not finite, and there is something to draw.
/// Errors: draw_empty; draw_not_finite; draw_malformed; each names the entity.
Status check_scene(const Scene& scene);

/// A scene ready to be drawn and where it is seen from.
struct View {
  Scene scene;
  Camera camera;
  Viewport viewport;
};

/// Errors: those of check_scene() and check_view(); invalid_argument for a negative or not finite explode factor or
/// margin.
Result<View> prepare_view(const Scene& scene, const ViewOptions& options);

/// The colour of a patch seen from its front (side 0) or back (side 1).
class FaceColors {
 public:
  FaceColors(const Scene& scene, Coloring coloring);
  Color of(const FacePatch& patch, int side) const;

 private:
  const RegionInfo* find(RegionId region) const;

  Coloring coloring_;
  std::vector<RegionInfo> regions_;  ///< by id
};

/// A palette for regions: calm colours that tell neighbours apart; repeats after 12.
Color palette(std::size_t index);

}  // namespace aresta::draw
