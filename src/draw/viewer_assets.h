// SPDX-License-Identifier: Apache-2.0
// Internal to draw: viewer.html and viewer.js as they are in the source, put into the library by the build
// (embed.cmake).
#pragma once

#include <string_view>

namespace aresta::draw {

extern const std::string_view viewer_html;
extern const std::string_view viewer_js;

}  // namespace aresta::draw
