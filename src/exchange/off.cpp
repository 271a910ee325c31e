// SPDX-License-Identifier: Apache-2.0
// OFF: the word OFF, counts, points, polygons; # begins a comment. Colours after a polygon are passed over.
#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/polygon_soup.h"
#include "exchange/text.h"

namespace aresta {

namespace {

/// The words of the next line that has any; false at the end.
bool next_words(TextReader& reader, std::string_view& words) {
  while (reader.next_line(words)) {
    words = words.substr(0, words.find('#'));
    std::string_view probe = words;
    if (!take_word(probe).empty()) return true;
  }
  return false;
}

}  // namespace

Result<Model> read_off(const ReadArguments& in) {
  PolygonSoup soup;
  TextReader reader(in.data);
  std::string_view words;
  const auto bad = [&](const std::string& what) {
    return Error{errors::bad_content, "line " + std::to_string(reader.line() - 1) + " of the OFF text: " + what};
  };
  if (!next_words(reader, words) || take_word(words) != "OFF") {
    return Error{errors::bad_content, "this is not an OFF file: it does not begin with OFF"};
  }
  std::string_view probe = words;
  if (take_word(probe).empty() && !next_words(reader, words)) return bad("the counts are missing");
  std::int64_t points = 0, polygons = 0;
  if (!to_number(take_word(words), points) || !to_number(take_word(words), polygons) || points < 0 || polygons < 0) {
    return bad("the counts of points and polygons are missing");
  }
  for (std::int64_t i = 0; i < points; ++i) {
    if (!next_words(reader, words)) return bad("the file is cut off among its points");
    Vec3 p;
    for (int c = 0; c < 3; ++c) {
      if (!to_number(take_word(words), p[c])) return bad("a point needs three numbers");
    }
    if (!is_finite(p)) return bad("a coordinate is not a finite number");
    soup.points.push_back(p);
  }
  for (std::int64_t i = 0; i < polygons; ++i) {
    if (!next_words(reader, words)) return bad("the file is cut off among its polygons");
    std::int64_t corners = 0;
    if (!to_number(take_word(words), corners) || corners < 1) return bad("a polygon begins with its count of corners");
    for (std::int64_t c = 0; c < corners; ++c) {
      std::int64_t index = 0;
      if (!to_number(take_word(words), index)) return bad("a polygon names its points by numbers");
      if (index < 0 || index >= points) return bad("a polygon names a point that does not exist");
      soup.corners.push_back(static_cast<std::uint32_t>(index));
    }
    soup.close_polygon();
  }
  return import_soup(soup, in.options, in.report, in.context);
}

}  // namespace aresta
