// SPDX-License-Identifier: Apache-2.0
// What a picture is made of: triangles and polylines with the entity they stand for. Knows nothing of models;
// tessellating a model into a scene happens above, so that every writer (PNG, SVG, HTML) is tested on hand-made scenes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/ids.h"
#include "math/box.h"
#include "math/vec.h"

namespace aresta::draw {

struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  constexpr bool operator==(const Color&) const = default;
};

/// The triangles of one face. Neighbouring faces share boundary points exactly, so that pictures have no cracks.
struct FacePatch {
  FaceId face;
  std::array<RegionId, 2> regions;  ///< on the front and back side of the face; an invalid id for outside space
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  ///< unit, one per point, along the face's normal; empty: use the triangles' own
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise seen from the face's front side
  Color color{170, 190, 215, 255};
  bool own_color = false;  ///< `color` is the face's own and wins over those of its regions
  std::string name;        ///< shown when picked; may be empty
  std::string kind;        ///< of its surface, as in "plane"; shown when picked; may be empty
};

/// One edge as a polyline; its inner points are points of the patches of the faces that it bounds.
struct EdgeLine {
  EdgeId edge;
  std::vector<Vec3> points;   ///< at least two; closed when the first equals the last
  std::vector<FaceId> faces;  ///< faces that it bounds; empty for a wire
  bool smooth = false;        ///< the two faces meet tangentially, or a seam: not drawn as a feature
  Color color{20, 20, 20, 255};
};

struct PointMark {
  VertexId vertex;
  Vec3 point;
  Color color{180, 30, 30, 255};
};

struct RegionInfo {
  RegionId region;
  std::string name;
  Color color{170, 190, 215, 255};
  double volume = 0;
};

struct Scene {
  std::string title;
  std::vector<FacePatch> faces;
  std::vector<EdgeLine> edges;
  std::vector<PointMark> points;  ///< isolated vertices only
  std::vector<RegionInfo> regions;

  Box3 bounds() const;
};

}  // namespace aresta::draw
