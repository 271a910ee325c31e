// SPDX-License-Identifier: Apache-2.0
#include "draw/color.h"

#include <charconv>

#include "draw/errors.h"

namespace aresta::draw {

std::string color_text(Color c) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t v : {c.r, c.g, c.b}) {
    text += digits[v >> 4];
    text += digits[v & 15];
  }
  return text;
}

Result<Color> color_from_text(std::string_view text) {
  std::uint32_t value = 0;
  if (text.size() == 7 && text[0] == '#') {
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + 1, end, value, 16);
    if (read.ec == std::errc() && read.ptr == end) {
      return Color{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
                   static_cast<std::uint8_t>(value), 255};
    }
  }
  return Error{.code = errors::draw_bad_color,
               .message = "'" + std::string(text) + "' is not a colour",
               .hint = "red, green and blue in two hexadecimal digits each, as in \"#ff8000\""};
}

}  // namespace aresta::draw
