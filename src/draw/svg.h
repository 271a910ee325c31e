// SPDX-License-Identifier: Apache-2.0
// Line drawings as SVG: all edges, or with hidden lines really removed (see hidden_lines.h).
//
// One <path> per line and visibility, in groups of class "hidden" and "visible"; data-entity="edge 12" (or "face 3" for
// the silhouette of a face) tells what it stands for. Pieces that follow each other are one polyline; places on a
// straight part are left out. Everything is clipped to the picture. Coordinates are pixels to six decimals. The same
// bytes for the same scene.
#pragma once

#include <string>

#include "base/context.h"
#include "base/result.h"
#include "draw/view.h"

namespace aresta::draw {

struct SvgOptions {
  ViewOptions view = {};
  bool hidden_lines = false;  ///< remove hidden lines; else a wireframe
  bool dashed = false;        ///< with hidden_lines: draw the hidden ones thin and dashed
  bool silhouettes = true;
  bool merge_coincident = true;          ///< with hidden_lines: lines that coincide in the picture are drawn once
  double line_width = 0;                 ///< pixels; 0: a 750th of the picture's longer side, at least 1
  Color background{255, 255, 255, 255};  ///< no background when its alpha is 0
};

/// The text of an SVG file. Errors: those of prepare_view() and hidden_lines(); invalid_argument for a bad width.
Result<std::string> svg_text(const Scene& scene, const SvgOptions& options, const Context& context);

/// Written atomically. Errors: those of svg_text(); file_unwritable.
Status write_svg(const Scene& scene, const SvgOptions& options, const std::string& path, const Context& context);

}  // namespace aresta::draw
