// SPDX-License-Identifier: Apache-2.0
#include "draw/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace aresta::draw {
namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

/// The length of the well-formed UTF-8 character at the front of `text`; 0 when there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t n = first >= 0xc2 && first < 0xe0   ? 2
                        : first >= 0xe0 && first < 0xf0 ? 3
                        : first >= 0xf0 && first < 0xf5 ? 4
                                                        : 0;
  if (n == 0 || text.size() < n) return 0;
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool outside = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return overlong || outside ? 0 : n;
}

/// put(character) for each character, what is not UTF-8 replaced.
template <class Put>
void for_each_character(std::string_view text, const Put& put) {
  while (!text.empty()) {
    const std::size_t n = character_length(text);
    put(n == 0 ? replacement : text.substr(0, n));
    text.remove_prefix(n == 0 ? 1 : n);
  }
}

}  // namespace

std::string number_text(double value, int decimals) {
  std::array<char, 400> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals).ptr;
  std::string text(buffer.data(), end);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  std::array<char, 40> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string escape_xml(std::string_view text) {
  std::string result;
  for_each_character(text, [&](std::string_view c) {
    const auto code = static_cast<unsigned char>(c[0]);
    if (c == "&")
      result += "&amp;";
    else if (c == "<")
      result += "&lt;";
    else if (c == ">")
      result += "&gt;";
    else if (c == "\"")
      result += "&quot;";
    else if (c == "'")
      result += "&#39;";
    else if (code < 0x20 && c != "\t" && c != "\n" && c != "\r")
      result += replacement;
    else
      result += c;
  });
  return result;
}

std::string json_string(std::string_view text) {
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for_each_character(text, [&](std::string_view c) {
    const auto code = static_cast<unsigned char>(c[0]);
    if (c == "\"" || c == "\\") {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7f || c == "<" || c == ">" || c == "&") {
      result += "\\u00";
      result += digits[code >> 4];
      result += digits[code & 15];
    } else if (c == "\xe2\x80\xa8" ||
               c == "\xe2\x80\xa9") {  // line separators, which old JavaScript takes for line ends
      result += c.back() == '\xa8' ? "\\u2028" : "\\u2029";
    } else {
      result += c;
    }
  });
  return result + '"';
}

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? std::uint32_t(static_cast<unsigned char>(bytes[k])) : 0u;
    };
    const std::uint32_t v = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    result += digits[v >> 18];
    result += digits[v >> 12 & 63];
    result += i + 1 < bytes.size() ? digits[v >> 6 & 63] : '=';
    result += i + 2 < bytes.size() ? digits[v & 63] : '=';
  }
  return result;
}

}  // namespace aresta::draw
