// SPDX-License-Identifier: Apache-2.0
#include "draw/svg.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/files.h"
#include "draw/color.h"
#include "draw/hidden_lines.h"
#include "draw/screen_scene.h"
#include "draw/text.h"

namespace aresta::draw {
namespace {

using Polyline = std::vector<Vec2>;

/// The part of a -> b inside the picture.
std::optional<std::pair<Vec2, Vec2>> clipped(Vec2 a, Vec2 b, Viewport viewport) {
  double from = 0, to = 1;
  const auto against = [&](double start, double slope, double high) {
    if (slope == 0) return start >= 0 && start <= high;
    const double t0 = -start / slope, t1 = (high - start) / slope;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
    return from <= to;
  };
  if (!against(a.x, b.x - a.x, viewport.width) || !against(a.y, b.y - a.y, viewport.height)) return std::nullopt;
  const Vec2 d = b - a;
  return std::pair{from == 0 ? a : a + from * d, to == 1 ? b : a + to * d};
}

/// Adds a segment to the polylines of a line; drops the last place when the path goes straight on there.
void append(std::vector<Polyline>& polylines, Vec2 a, Vec2 b) {
  constexpr double close = 1e-6;  // pixels
  if (distance(a, b) == 0) return;
  if (polylines.empty() || distance(polylines.back().back(), a) > close) {
    polylines.push_back({a, b});
    return;
  }
  Polyline& last = polylines.back();
  if (last.size() >= 2) {
    const Vec2 d = b - last[last.size() - 2], e = last.back() - last[last.size() - 2];
    if (std::abs(cross(d, e)) <= close * norm(d) && dot(b - last.back(), e) > 0) last.pop_back();
  }
  last.push_back(b);
}

/// Joins the end of a closed line with its beginning where both are drawn.
void close_up(std::vector<Polyline>& polylines) {
  if (polylines.size() < 2 || distance(polylines.front().front(), polylines.back().back()) > 1e-6) return;
  Polyline joined = std::move(polylines.back());
  polylines.pop_back();
  std::vector<Polyline> both{joined};
  for (std::size_t i = 1; i < polylines.front().size(); ++i)
    append(both, polylines.front()[i - 1], polylines.front()[i]);
  polylines.front() = std::move(both.front());
}

std::string path_data(const std::vector<Polyline>& polylines) {
  const auto at = [](Vec2 p) { return number_text(p.x, 6) + ' ' + number_text(p.y, 6); };
  std::string text;
  for (const Polyline& line : polylines) {
    const bool closed = line.size() > 3 && distance(line.front(), line.back()) <= 1e-6;
    text += (text.empty() ? "M" : " M") + at(line[0]);
    for (std::size_t i = 1; i + (closed ? 1 : 0) < line.size(); ++i) text += " L" + at(line[i]);
    if (closed) text += " Z";
  }
  return text;
}

std::string entity_text(const DrawnLine& line) {
  if (line.edge.valid()) return "edge " + std::to_string(line.edge.value);
  if (line.face.valid()) return "face " + std::to_string(line.face.value);
  return "line";
}

class SvgWriter {
 public:
  SvgWriter(const View& view, const SvgOptions& options)
      : view_(view), options_(options), projector_(view.camera, view.viewport), near_(near_depth(view)) {}

  Result<std::string> run(const Context& context) {
    HiddenLines lines;
    if (options_.hidden_lines) {
      HiddenLineOptions how;
      how.silhouettes = options_.silhouettes;
      how.keep_hidden = options_.dashed;
      how.merge_coincident = options_.merge_coincident;
      ARESTA_TRY(lines, hidden_lines(view_.scene, view_.camera, how, context));
    } else {
      ARESTA_TRY(lines.lines, drawn_lines(view_.scene, view_.camera, options_.silhouettes, context));
      lines.pieces = whole_pieces(lines.lines);
      lines.point_visible.assign(view_.scene.points.size(), true);
    }
    ARESTA_CHECK(context.step(0.9, "writing lines"));
    return text(lines);
  }

 private:
  static std::vector<LinePiece> whole_pieces(const std::vector<DrawnLine>& lines) {
    std::vector<LinePiece> pieces;
    for (std::uint32_t l = 0; l < lines.size(); ++l) {
      for (std::uint32_t s = 0; s + 1 < lines[l].points.size(); ++s) {
        pieces.push_back({l, s, 0, 1, true, lines[l].points[s], lines[l].points[s + 1]});
      }
    }
    return pieces;
  }

  /// The segment on the screen, cut at the near plane and the border.
  std::optional<std::pair<Vec2, Vec2>> on_screen(Vec3 from, Vec3 to) const {
    Vec3 a = projector_.to_view(from), b = projector_.to_view(to);
    if (projector_.perspective()) {
      // What hidden-line removal cut at the near plane may lie behind it by rounding.
      const double least = near_ * (1 - 1e-9);
      if (a.z < least && b.z < least) return std::nullopt;
      if (a.z < least)
        a = lerp(a, b, (near_ - a.z) / (b.z - a.z));
      else if (b.z < least)
        b = lerp(b, a, (near_ - b.z) / (a.z - b.z));
    }
    const Vec3 p = projector_.view_to_screen(a), q = projector_.view_to_screen(b);
    return clipped({p.x, p.y}, {q.x, q.y}, view_.viewport);
  }

  std::string paths(const HiddenLines& lines, bool visible) const {
    std::string text;
    for (std::size_t i = 0; i < lines.pieces.size();) {
      const std::uint32_t index = lines.pieces[i].line;
      const DrawnLine& line = lines.lines[index];
      std::vector<Polyline> polylines;
      for (; i < lines.pieces.size() && lines.pieces[i].line == index; ++i) {
        const LinePiece& piece = lines.pieces[i];
        if (piece.visible != visible) continue;
        if (const auto segment = on_screen(piece.a, piece.b)) append(polylines, segment->first, segment->second);
      }
      if (polylines.empty()) continue;
      if (line.points.front() == line.points.back()) close_up(polylines);
      text += "<path data-entity=\"" + entity_text(line) + '"';
      if (line.kind == LineKind::silhouette) text += " class=\"silhouette\"";
      if (visible && !(line.color == default_color)) text += " stroke=\"" + color_text(line.color) + '"';
      text += " d=\"" + path_data(polylines) + "\"/>\n";
    }
    return text;
  }

  std::string text(const HiddenLines& lines) const {
    const auto [width, height] = view_.viewport;
    const double stroke =
        options_.line_width > 0 ? options_.line_width : std::max(1.0, std::max(width, height) / 750.0);
    const std::string w = std::to_string(width), h = std::to_string(height);
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w +
        "\" height=\"" + h + "\" viewBox=\"0 0 " + w + ' ' + h + "\">\n";
    if (!view_.scene.title.empty()) text += "<title>" + escape_xml(view_.scene.title) + "</title>\n";
    if (options_.background.a > 0) {
      text += "<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"" + color_text(options_.background) + '"';
      if (options_.background.a < 255) text += " fill-opacity=\"" + number_text(options_.background.a / 255.0, 4) + '"';
      text += "/>\n";
    }
    const std::string round = " fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    if (options_.hidden_lines && options_.dashed) {
      text += "<g class=\"hidden\"" + round + " stroke=\"#8a94a3\" stroke-width=\"" + number_text(0.6 * stroke, 4) +
              "\" stroke-dasharray=\"" + number_text(4 * stroke, 4) + ' ' + number_text(3 * stroke, 4) + "\">\n" +
              paths(lines, false) + "</g>\n";
    }
    text += "<g class=\"visible\"" + round + " stroke=\"" + color_text(default_color) + "\" stroke-width=\"" +
            number_text(stroke, 4) + "\">\n" + paths(lines, true) + "</g>\n";
    text += points(lines, 2.5 * stroke);
    return text + "</svg>\n";
  }

  std::string points(const HiddenLines& lines, double radius) const {
    std::string text;
    for (std::size_t i = 0; i < view_.scene.points.size(); ++i) {
      const PointMark& mark = view_.scene.points[i];
      const Vec3 v = projector_.to_view(mark.point);
      if (!lines.point_visible[i] || (projector_.perspective() && v.z < near_)) continue;
      const Vec3 s = projector_.view_to_screen(v);
      if (s.x < 0 || s.y < 0 || s.x > view_.viewport.width || s.y > view_.viewport.height) continue;
      text += "<circle data-entity=\"vertex " + std::to_string(mark.vertex.value) + "\" cx=\"" + number_text(s.x, 6) +
              "\" cy=\"" + number_text(s.y, 6) + "\" r=\"" + number_text(radius, 4) + "\" fill=\"" +
              color_text(mark.color) + "\"/>\n";
    }
    return text;
  }

  static constexpr Color default_color{20, 20, 20, 255};  // that of EdgeLine

  const View& view_;
  const SvgOptions& options_;
  Projector projector_;
  double near_;
};

}  // namespace

Result<std::string> svg_text(const Scene& scene, const SvgOptions& options, const Context& context) {
  if (!(options.line_width >= 0 && options.line_width <= 100)) {
    return Error{errors::invalid_argument, "the width of lines must be between 0 and 100 pixels"};
  }
  ARESTA_TRY(const View view, prepare_view(scene, options.view));
  return SvgWriter(view, options).run(context);
}

Status write_svg(const Scene& scene, const SvgOptions& options, const std::string& path, const Context& context) {
  ARESTA_TRY(const std::string text, svg_text(scene, options, context));
  return write_file(path, text);
}

}  // namespace aresta::draw
