// SPDX-License-Identifier: Apache-2.0
// Internal to draw: numbers and names as text for SVG, HTML and JSON, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace aresta::draw {

/// Fixed notation with `decimals` digits at most; no trailing zeros, no -0.
std::string number_text(double value, int decimals);
/// The shortest text that reads back as the same number; null when not finite.
std::string json_number(double value);
/// For text and attribute values of XML and HTML; what XML does not allow becomes U+FFFD.
std::string escape_xml(std::string_view text);
/// A quoted JSON string that may stand inside an HTML <script>: <, > and & are escaped, broken UTF-8 becomes U+FFFD.
std::string json_string(std::string_view text);
std::string base64(std::string_view bytes);

}  // namespace aresta::draw
