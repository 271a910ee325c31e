// SPDX-License-Identifier: Apache-2.0
// Colours as text: "#rrggbb", as in the attribute "color" of an entity.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "draw/scene.h"

namespace aresta::draw {

std::string color_text(Color color);

/// Letters may be large. Error: draw_bad_color.
Result<Color> color_from_text(std::string_view text);

}  // namespace aresta::draw
