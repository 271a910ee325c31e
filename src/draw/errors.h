// SPDX-License-Identifier: Apache-2.0
// Errors of drawing: 1000-1099.
#pragma once

#include "base/result.h"

namespace aresta::errors {

inline constexpr ErrorCode draw_empty{1000, "draw.empty"};            ///< nothing to draw
inline constexpr ErrorCode draw_not_finite{1001, "draw.not_finite"};  ///< a coordinate is not a number or infinite
inline constexpr ErrorCode draw_malformed{1002, "draw.malformed"};  ///< an index or an array of the scene does not fit
inline constexpr ErrorCode draw_bad_size{1003, "draw.bad_size"};    ///< a picture of no or of absurd size
inline constexpr ErrorCode draw_bad_camera{1004, "draw.bad_camera"};
inline constexpr ErrorCode draw_unknown_view{1005, "draw.unknown_view", Failure::usage};
inline constexpr ErrorCode draw_bad_png{1006, "draw.bad_png", Failure::file};
inline constexpr ErrorCode draw_bad_color{1007, "draw.bad_color"};  ///< a colour that is not written as "#rrggbb"

}  // namespace aresta::errors
