// SPDX-License-Identifier: Apache-2.0
// Images of a face's loops in its surface's parameter plane, lifted to the plane that covers a periodic surface.
//
// A loop's coedge images are moved by whole periods until each starts where the one before it ended. What then still
// lies between them (at a pole or an apex, or a difference within tolerance) is a gap, closed by a straight segment.
// After the last gap the loop is back at its start up to whole periods: its winding.
#pragma once

#include <vector>

#include "model/model.h"

namespace aresta::model_detail {

/// The image of one coedge, run through in the loop's direction from `from` to `to` (edge parameters).
struct ImagePiece {
  CoedgeId coedge;
  double from = 0, to = 0;
  Vec2 shift{};           ///< whole periods added to the stored image
  bool internal = false;  ///< the face lies on both sides and the images agree: a dangling or bridging edge
  bool paired = false;    ///< internal, or one of the two uses of a seam
  Vec2 start, end;        ///< lifted ends
  Vec2 gap_end;           ///< where the next piece starts, `end` when there is no gap
  /// For coedges without a stored image on a surface that is not plane: lifted samples at equal steps of the parameter.
  std::vector<Vec2> samples;
};

struct LoopImage {
  std::size_t first = 0, count = 0;  ///< its pieces
  Vec2 winding{};                    ///< end - start in periods: whole numbers
};

/// Images of all loops of a face that have coedges.
///
/// On a sphere the stored images are not used: the sphere is turned so that its poles lie away from the face's edges,
/// and points are put on it by projection. So an edge may pass through a pole, and where a seam lies does not matter.
struct FaceImage {
  const Model* model = nullptr;
  FaceId face;
  Vec2 period{};
  std::vector<ImagePiece> pieces;
  std::vector<LoopImage> loops;
  Range2 box{{1, -1}, {1, -1}};   ///< of ends and some samples; low > high when there is no edge
  std::optional<Surface> turned;  ///< the sphere with other poles, with the same natural normal
  bool has_boundary = false;      ///< is some piece not paired with its reverse (as internal edges and seams are)?

  /// The surface that the images lie in.
  const Surface& surface() const { return turned ? *turned : model->surface(face); }
  bool empty() const { return pieces.empty(); }
  /// How far in space the gap after a piece goes: zero, to rounding, at a pole.
  double gap_length(const ImagePiece& piece) const;
  /// The lifted image of the piece at an edge parameter, as stored.
  Vec2 uv(const ImagePiece& piece, double t) const;
};

FaceImage image_of(const Model& model, FaceId face);

/// uv of the point of the surface nearest to p, near `hint`. Newton on the foot-point equations for free-form surfaces.
Vec2 invert(const Surface& surface, Vec3 p, Vec2 hint);

/// Derivative of the foot point's uv for a space curve with tangent d1 at jet.point + off, where `off` is at right
/// angles to the surface (zero for a point on it); zero where the surface is singular.
Vec2 uv_tangent(const SurfaceJet& jet, Vec3 d1, Vec3 off);

}  // namespace aresta::model_detail
