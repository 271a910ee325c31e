// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: v, f, g and o lines; everything else (normals, textures, materials, smoothing) says nothing about
// shape.
#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/polygon_soup.h"
#include "exchange/skin.h"
#include "exchange/text.h"

namespace aresta {

Result<Model> read_obj(const ReadArguments& in) {
  PolygonSoup soup;
  TextReader reader(in.data);
  std::string_view line;
  std::size_t number = 0;
  std::string joined;
  const auto bad = [&](const std::string& what) {
    return Error{errors::bad_content, "line " + std::to_string(number) + " of the OBJ text: " + what};
  };
  while (reader.next_line(line)) {
    ++number;
    if (!line.empty() && line.back() == '\\') {  // goes on in the next line
      joined.append(line.substr(0, line.size() - 1));
      continue;
    }
    if (!joined.empty()) line = joined.append(line);
    std::string_view rest = line;
    const std::string_view key = take_word(rest);
    if (key == "v") {
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        if (!to_number(take_word(rest), p[i])) return bad("a vertex needs three numbers");
      }
      if (!is_finite(p)) return bad("a coordinate is not a finite number");
      soup.points.push_back(p);
    } else if (key == "f") {
      std::size_t corners = 0;
      for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
        std::int64_t index = 0;
        if (!to_number(word.substr(0, word.find('/')), index)) return bad("a face names its points by numbers");
        const auto count = static_cast<std::int64_t>(soup.points.size());
        if (index < 0) index += count + 1;
        if (index < 1 || index > count) return bad("a face names a point that does not exist (yet)");
        soup.corners.push_back(static_cast<std::uint32_t>(index - 1));
        ++corners;
      }
      if (corners < 3) return bad("a face has fewer than three points");
      soup.close_polygon();
    } else if (key == "g" || key == "o") {
      const std::string_view name = take_word(rest);
      soup.groups.emplace_back(static_cast<std::uint32_t>(soup.size()), std::string(name));
    }
    joined.clear();
  }
  if (soup.size() == 0) return Error{errors::bad_content, "the OBJ text holds no faces"};
  return import_soup(soup, in.options, in.report, in.context);
}

Result<std::string> write_obj(const Model& model, const ExportOptions& options, const Context& context) {
  ARESTA_TRY(const Skin skin, make_skin(model, options, context));
  std::string data = "# Aresta\n";
  for (const Vec3 p : skin.points) {
    data += "v";
    for (int i = 0; i < 3; ++i) {
      data.push_back(' ');
      append_number(data, p[i]);
    }
    data.push_back('\n');
  }
  std::size_t face = 0;
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    for (; face < skin.faces.size() && skin.faces[face].first <= t; ++face) {
      if (face + 1 < skin.faces.size() && skin.faces[face + 1].first <= t) continue;
      std::string name = model.labels.name(skin.faces[face].second);
      if (name.empty()) name = "face_" + std::to_string(skin.faces[face].second.index());
      for (char& c : name) c = TextReader::is_space(c) ? '_' : c;
      data += "g " + name + "\n";
    }
    data += "f";
    for (const std::uint32_t i : skin.triangles[t]) data += " " + std::to_string(i + 1);
    data.push_back('\n');
  }
  return data;
}

}  // namespace aresta
