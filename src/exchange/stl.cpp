// SPDX-License-Identifier: Apache-2.0
// STL: triangles without topology, text or binary (80 bytes of anything, a count, 50 bytes per triangle,
// little-endian). Binary files may begin with "solid" too: the length decides.
#include <array>
#include <cstring>

#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/polygon_soup.h"
#include "exchange/skin.h"
#include "exchange/text.h"

namespace aresta {

namespace {

constexpr std::size_t head = 84, record = 50;

std::uint32_t read_u32(const char* at) {
  const auto* b = reinterpret_cast<const unsigned char*>(at);
  return b[0] | (std::uint32_t{b[1]} << 8) | (std::uint32_t{b[2]} << 16) | (std::uint32_t{b[3]} << 24);
}

float read_float(const char* at) {
  return std::bit_cast<float>(read_u32(at));
}

PolygonSoup read_binary(const std::string& data, std::uint32_t count) {
  PolygonSoup soup;
  soup.points.reserve(3 * std::size_t{count});
  soup.corners.reserve(3 * std::size_t{count});
  soup.begin.reserve(std::size_t{count} + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const char* at = data.data() + head + record * i + 12;
    for (int corner = 0; corner < 3; ++corner, at += 12) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back({read_float(at), read_float(at + 4), read_float(at + 8)});
    }
    soup.close_polygon();
  }
  return soup;
}

Result<PolygonSoup> read_text(const std::string& data) {
  PolygonSoup soup;
  TextReader reader(data);
  const auto bad = [&](const std::string& what) {
    return Error{errors::bad_content, "line " + std::to_string(reader.line()) + " of the STL text: " + what};
  };
  bool complete = false;
  std::size_t in_loop = 0;
  for (std::string_view word = reader.word(); !word.empty(); word = reader.word()) {
    if (word == "vertex") {
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        if (!to_number(reader.word(), p[i])) return bad("a vertex needs three numbers");
      }
      if (!is_finite(p)) return bad("a coordinate is not a finite number");
      soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back(p);
      ++in_loop;
    } else if (word == "endloop") {
      if (in_loop < 3) return bad("a facet has fewer than three vertices");
      soup.close_polygon();
      in_loop = 0;
    } else if (word == "endsolid") {
      complete = true;
    }
  }
  if (in_loop > 0 || !complete) return bad("the file is cut off: endsolid is missing");
  return soup;
}

void append_float(std::string& data, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (int shift = 0; shift < 32; shift += 8) data.push_back(static_cast<char>((bits >> shift) & 0xffu));
}

}  // namespace

Result<Model> read_stl(const ReadArguments& in) {
  const std::string& data = in.data;
  if (data.size() >= head) {
    const std::uint32_t count = read_u32(data.data() + 80);
    if (data.size() == head + record * std::size_t{count}) {
      return import_soup(read_binary(data, count), in.options, in.report, in.context);
    }
  }
  TextReader reader(data);
  if (reader.word() != "solid") {
    return Error{errors::bad_content,
                 "this is neither a binary STL file (its length does not fit its count of triangles) "
                 "nor a text one (it does not begin with \"solid\")"};
  }
  ARESTA_TRY(const PolygonSoup soup, read_text(data));
  return import_soup(soup, in.options, in.report, in.context);
}

Result<std::string> write_stl(const Model& model, const ExportOptions& options, const Context& context) {
  ARESTA_TRY(const Skin skin, make_skin(model, options, context));
  std::string data;
  if (!options.ascii) {
    data.assign(80, '\0');
    constexpr char title[] = "Aresta";
    std::memcpy(data.data(), title, sizeof title - 1);
    const auto count = static_cast<std::uint32_t>(skin.triangles.size());
    for (int shift = 0; shift < 32; shift += 8) data.push_back(static_cast<char>((count >> shift) & 0xffu));
  } else {
    data = "solid aresta\n";
  }
  for (const auto& t : skin.triangles) {
    const std::array<Vec3, 3> p{skin.points[t[0]], skin.points[t[1]], skin.points[t[2]]};
    const Vec3 n = normalized(cross(p[1] - p[0], p[2] - p[0]));
    if (!options.ascii) {
      for (const Vec3 v : {n, p[0], p[1], p[2]}) {
        for (int i = 0; i < 3; ++i) append_float(data, v[i]);
      }
      data.append(2, '\0');
      continue;
    }
    const auto line = [&](const char* text, Vec3 v) {
      data += text;
      for (int i = 0; i < 3; ++i) {
        data.push_back(' ');
        append_number(data, v[i]);
      }
      data.push_back('\n');
    };
    line("facet normal", n);
    data += "outer loop\n";
    for (const Vec3 v : p) line("vertex", v);
    data += "endloop\nendfacet\n";
  }
  if (options.ascii) data += "endsolid aresta\n";
  return data;
}

}  // namespace aresta
