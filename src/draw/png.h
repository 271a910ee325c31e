// SPDX-License-Identifier: Apache-2.0
// Shaded pictures by a software rasterizer: no OpenGL, no display, the same bytes for the same scene.
//
// Contract. Triangles are sampled on a regular grid of supersampling^2 points a pixel into a depth buffer; the nearest
// wins, and of several within 1e-7 of the scene's diagonal the one that comes first in the scene, so that faces that
// coincide do not flicker. Faces are two-sided. Edges are round-ended strokes; whether a place of an edge is seen is
// decided once, at its middle line, against the depth buffer, so that strokes have an even width. What lies behind a
// face by less than a quarter of a pixel is taken as seen, and by less than two behind a face that it bounds. Light
// comes from over the viewer's left shoulder; corners are darkened by what stands around them (obscurance in screen
// space). Transparent faces are blended back to front at every sample, exactly. The picture is made in bands of rows,
// which bounds memory whatever its size. Complexity: linear in triangles and in samples covered.
//
// Papers: J. Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; L. Carpenter, The A-buffer,
// SIGGRAPH 1984; M. McGuire, B. Osman, M. Bukowski, P. Hennessy, The Alchemy Screen-Space Ambient Obscurance Algorithm,
// HPG 2011.
#pragma once

#include <string>

#include "base/context.h"
#include "base/result.h"
#include "draw/image.h"
#include "draw/view.h"

namespace aresta::draw {

enum class Shading { smooth, flat };

struct RenderOptions {
  ViewOptions view = {};
  Shading shading = Shading::smooth;  ///< smooth uses the patches' normals where there are any
  Coloring coloring = Coloring::regions;
  Color background{255, 255, 255, 255};
  bool faces = true;
  bool edges = true;
  bool silhouettes = true;  ///< outlines of curved faces; with edges only
  bool obscurance = true;   ///< soft darkening of corners; opaque pictures only
  double opacity = 1;       ///< of faces, 0 to 1; multiplies the colours' own alpha
  double edge_width = 0;    ///< pixels; 0: a 750th of the picture's longer side, at least 1.2
  double point_size = 0;    ///< pixels across; 0: five times the edges' width
  int supersampling = 4;    ///< samples a pixel along each axis, 1 to 8
};

/// Errors: those of prepare_view(); invalid_argument (opacity, widths, supersampling); cancelled.
Result<Image> render_image(const Scene& scene, const RenderOptions& options, const Context& context);

/// A PNG file, written atomically. Errors: those of render_image(); file_unwritable.
Status render_png(const Scene& scene, const RenderOptions& options, const std::string& path, const Context& context);

}  // namespace aresta::draw
