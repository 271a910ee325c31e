// SPDX-License-Identifier: Apache-2.0
// One self-contained page that turns, explodes and picks: data, styles and viewer (viewer.js) in one file, nothing from
// any network.
//
// The page draws with WebGL 2 and, where a browser has none, with a depth buffer of its own on a 2D canvas. Coordinates
// are stored as floats relative to the middle of the scene: good for looking, not for measuring; volumes are those of
// RegionInfo. A face between two regions is stored once and drawn for each. The part of the address after # sets the
// first picture, as in page.html#view=front&explode=0.5&glass=1&edges=0&perspective=1&hide=2,3&pick=400,300&canvas=1
// (canvas=1: without WebGL). Names are data, never markup, whatever characters they hold. The same bytes for the same
// scene.
#pragma once

#include <string>

#include "base/context.h"
#include "base/result.h"
#include "draw/view.h"

namespace aresta::draw {

struct HtmlOptions {
  StandardView view = StandardView::iso;  ///< at first
  Projection projection = Projection::parallel;
  double explode = 0;  ///< at first
  Coloring coloring = Coloring::regions;
};

/// The text of the page. Errors: those of check_scene(); invalid_argument for the explode factor; cancelled.
Result<std::string> html_text(const Scene& scene, const HtmlOptions& options, const Context& context);

/// Written atomically. Errors: those of html_text(); file_unwritable.
Status write_html(const Scene& scene, const HtmlOptions& options, const std::string& path, const Context& context);

}  // namespace aresta::draw
