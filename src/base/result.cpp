// SPDX-License-Identifier: Apache-2.0
#include "base/result.h"

#include <cstdio>

namespace aresta {

namespace {

constexpr std::size_t max_entities_shown = 8;

std::string place_text(const std::array<double, 3>& place) {
  char text[96];
  std::snprintf(text, sizeof text, "at %.9g %.9g %.9g", place[0], place[1], place[2]);
  return text;
}

}  // namespace

std::string Error::to_line() const {
  std::string line = location.empty() ? std::string() : location + ": ";
  line += std::string(code.name) + ": " + message;
  std::string where;
  for (std::size_t i = 0; i < entities.size() && i < max_entities_shown; ++i) {
    if (!where.empty()) where += ", ";
    where += std::string(to_string(entities[i].kind)) + " " + std::to_string(entities[i].index);
  }
  if (entities.size() > max_entities_shown) {
    where += " and " + std::to_string(entities.size() - max_entities_shown) + " more";
  }
  if (place) where += (where.empty() ? "" : "; ") + place_text(*place);
  if (!where.empty()) line += " (" + where + ")";
  if (!hint.empty()) line += "; try: " + hint;
  return line;
}

}  // namespace aresta
