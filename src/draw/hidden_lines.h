// SPDX-License-Identifier: Apache-2.0
// Hidden-line removal: which parts of a scene's edges are seen, computed in object space, not by a depth buffer.
//
// Contract. The lines of a scene are its edges that are not smooth, its wires, and the silhouettes of its curved
// patches: edges of triangles where one neighbour faces the eye and the other does not, inside a patch or across a
// smooth edge. Each segment of a line is cut by the shadow volume of every triangle that can cover it: the part of
// space behind the triangle's plane and inside the planes through its sides and the eye (or along the direction of
// sight). All of these are linear along the segment, so the ends of hidden parts are roots of linear functions: exact
// for the given triangles but for rounding (about 1e-15 of the scene). The union of the hidden parts is taken; what is
// left is visible. Parallel and perspective views alike; triangles that reach behind the eye need no clipping. Parts of
// lines behind the eye are left out. Segments of silhouettes beyond a cusp, which only the triangles show, are hidden.
//
// Tolerance: eps = max(1e-9 times the diagonal of the scene's box, 1e-14 times its largest coordinate), a length in
// model units.
//  - A segment hides behind a triangle only where it lies farther than eps behind its plane, so a face does not hide
//  what lies
//    in it; triangles that have the segment as a side are left out by name (shared points are equal exactly).
//  - A triangle covers its own border: what runs exactly behind the border of a face (closer than eps) is hidden by it.
//  So the
//    back of a box seen from the front is drawn once. A segment that only touches a shadow from outside is not hidden.
//  - A triangle thinner than eps as seen (edge-on) hides nothing.
//  - Visible gaps and hidden parts shorter than 2 eps are taken into what surrounds them.
//
// Degeneracies: a segment seen end-on is a point of the picture and gives no piece (its edge is listed in `end_on` when
// that holds for all its segments); a segment that pierces a face is cut there; of lines that coincide in the picture
// with no face between them (two wires in line, edges of two touching bodies) all are given, or with `merge_coincident`
// each place once, to the visible before the hidden, then to the nearest. Not guaranteed: silhouettes are those of the
// triangles, not of the surface they stand for; a tessellation that does not use an edge's points (see scene.h) may
// hide the edge by its own face's sag.
//
// Complexity: n triangles, k segments: O(n log n) for a bounding volume hierarchy of the triangles as seen, ordered by
// depth, then O(k log n + pairs that overlap and are not behind); a segment already hidden wholly looks no further.
// Threads share the segments; the result does not depend on their number.
//
// Papers: A. Appel, The Notion of Quantitative Invisibility and the Machine Rendering of Solids, ACM National
// Conference 1967; L. G. Roberts, Machine Perception of Three-Dimensional Solids, MIT 1963 (volumes of invisibility,
// solved along the line); P. P. Loutrel, A Solution to the Hidden-Line Problem for Computer-Drawn Polyhedra, IEEE
// Trans. Computers C-19, 1970; A. Hertzmann, Introduction to 3D Non-Photorealistic Rendering: Silhouettes and Outlines,
// SIGGRAPH course 1999.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "draw/camera.h"
#include "draw/scene.h"

namespace aresta::draw {

enum class LineKind { feature, wire, silhouette };

/// A polyline that a picture shows.
struct DrawnLine {
  LineKind kind = LineKind::feature;
  EdgeId edge;  ///< invalid for a silhouette inside a patch
  FaceId face;  ///< of a silhouette: the face it outlines; else invalid
  Color color{20, 20, 20, 255};
  std::vector<Vec3> points;
  std::vector<FaceId> faces;  ///< that it bounds or outlines
  std::vector<bool> behind;   ///< of a silhouette, for each segment: it lies behind its own curved surface (outline.h)
};

/// A part of one segment of a line, wholly visible or wholly hidden.
struct LinePiece {
  std::uint32_t line = 0;     ///< in HiddenLines::lines
  std::uint32_t segment = 0;  ///< from points[segment] to points[segment + 1]
  double from = 0, to = 1;    ///< parameters on the segment, in space (not in the picture), 0 <= from < to <= 1
  bool visible = true;
  Vec3 a, b;  ///< places of from and to
};

struct HiddenLines {
  std::vector<DrawnLine> lines;     ///< edges in the order of the scene, then silhouettes
  std::vector<LinePiece> pieces;    ///< by line, segment, parameter
  std::vector<bool> point_visible;  ///< for each Scene::points
  std::vector<EdgeId> end_on;       ///< edges seen as a point
  double tolerance = 0;             ///< eps
};

struct HiddenLineOptions {
  bool silhouettes = true;
  bool keep_hidden = true;  ///< give the hidden pieces too
  bool merge_coincident = false;
  double tolerance = 0;  ///< eps in model units; 0: as above
};

/// Errors: those of check_scene() and check_view(); cancelled.
Result<HiddenLines> hidden_lines(const Scene& scene, const Camera& camera, const HiddenLineOptions& options,
                                 const Context& context);

/// The lines alone, nothing cut.
Result<std::vector<DrawnLine>> drawn_lines(const Scene& scene, const Camera& camera, bool silhouettes,
                                           const Context& context);

}  // namespace aresta::draw
