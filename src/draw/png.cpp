// SPDX-License-Identifier: Apache-2.0
#include "draw/png.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/files.h"
#include "draw/parallel.h"
#include "draw/raster_band.h"
#include "draw/shade.h"

namespace aresta::draw {
namespace {

/// Pixels of depth that a line may lie behind the faces that it bounds, and behind others, and still be seen.
constexpr double own_bias = 2, other_bias = 0.25;

/// Which triangles and lines touch each band of rows.
struct Bins {
  std::vector<std::vector<std::uint32_t>> triangles, lines;
};

/// A picture in the making: faces apart from all else until obscurance is known.
struct Canvas {
  std::vector<Rgb> faces, rest;  ///< sums over the samples of a pixel, divided by their number
  std::vector<float> alpha;
  DepthMap map;
};

Status check_options(const RenderOptions& o) {
  const auto bad = [](const char* what) { return Error{errors::invalid_argument, what}; };
  if (!(o.opacity >= 0 && o.opacity <= 1)) return bad("the opacity of a picture's faces must be between 0 and 1");
  if (!(o.edge_width >= 0 && o.edge_width <= 100)) return bad("the width of edges must be between 0 and 100 pixels");
  if (!(o.point_size >= 0 && o.point_size <= 500)) return bad("the size of points must be between 0 and 500 pixels");
  if (o.supersampling < 1 || o.supersampling > 8) return bad("supersampling must be between 1 and 8");
  return {};
}

class Renderer {
 public:
  Renderer(const View& view, const RenderOptions& options, const std::vector<DrawnLine>& lines)
      : view_(view),
        options_(options),
        lines_(lines),
        projector_(view.camera, view.viewport),
        shader_(view, projector_, options.shading, options.coloring),
        width_(view.viewport.width),
        height_(view.viewport.height),
        samples_(options.supersampling) {
    const double edge = options.edge_width > 0 ? options.edge_width : std::max(1.2, std::max(width_, height_) / 750.0);
    const double point = options.point_size > 0 ? options.point_size : 5 * edge;
    screen_ = project(view, projector_, samples_, options.faces && options.opacity > 0, lines, 0.5 * edge * samples_,
                      0.5 * point * samples_);
    diagonal_ = view.scene.bounds().diagonal();
    // Alpha of colours or of the whole makes a face let light through.
    const FaceColors colors(view.scene, options.coloring);
    for (const FacePatch& patch : view.scene.faces) {
      opaque_.push_back(options.opacity == 1 && colors.of(patch, 0).a == 255 && colors.of(patch, 1).a == 255);
    }
    all_opaque_ = std::all_of(opaque_.begin(), opaque_.end(), [](bool b) { return b; });
    if (!all_opaque_) band_height_ = 8;
  }

  Result<Image> run(const Context& context) {
    const std::size_t pixels = std::size_t(width_) * height_;
    canvas_.faces.resize(pixels);
    canvas_.rest.resize(pixels);
    canvas_.alpha.resize(pixels);
    canvas_.map = {width_, height_, std::vector<float>(pixels, std::numeric_limits<float>::infinity()),
                   std::vector<std::array<float, 3>>(pixels)};
    const std::size_t bands = (height_ + band_height_ - 1) / band_height_;
    const Bins bins = sort_into_bands(bands);
    ARESTA_CHECK(parallel_for(context, bands, "drawing", [&](std::size_t band) { draw_band(int(band), bins); }));
    std::vector<float> light;
    if (options_.obscurance && all_opaque_) {
      std::vector<float> raw(pixels, 1);
      light.assign(pixels, 1);
      const double radius = 0.055 * width_ * projector_.pixel_size(distance(view_.camera.eye, view_.camera.target));
      const auto rows = [&](std::size_t band) { return std::min<int>(height_, int(band) * band_height_); };
      ARESTA_CHECK(parallel_for(context, bands, "shading corners", [&](std::size_t b) {
        obscure_rows(canvas_.map, projector_, radius, rows(b), rows(b + 1), raw);
      }));
      ARESTA_CHECK(parallel_for(context, bands, "shading corners", [&](std::size_t b) {
        smooth_rows(canvas_.map, projector_, raw, rows(b), rows(b + 1), light);
      }));
    }
    return developed(light);
  }

 private:
  Bins sort_into_bands(std::size_t bands) const {
    Bins bins{std::vector<std::vector<std::uint32_t>>(bands), std::vector<std::vector<std::uint32_t>>(bands)};
    const double rows = double(band_height_) * samples_;
    const auto put = [&](std::vector<std::vector<std::uint32_t>>& into, double low, double high, std::uint32_t index) {
      const double last = double(bands) - 1;
      if (high < 0 || low > rows * double(bands)) return;
      const int from = int(std::clamp(std::floor(low / rows), 0.0, last)),
                to = int(std::clamp(std::floor(high / rows), 0.0, last));
      for (int b = from; b <= to; ++b) into[b].push_back(index);
    };
    for (std::uint32_t i = 0; i < screen_.triangles.size(); ++i) {
      const auto& p = screen_.triangles[i].p;
      put(bins.triangles, std::min({p[0].y, p[1].y, p[2].y}) - margin(), std::max({p[0].y, p[1].y, p[2].y}) + margin(),
          i);
    }
    for (std::uint32_t i = 0; i < screen_.lines.size(); ++i) {
      const ScreenLine& l = screen_.lines[i];
      const double reach = l.radius + 2;
      put(bins.lines, std::min(l.a.y, l.b.y) - reach, std::max(l.a.y, l.b.y) + reach, i);
    }
    return bins;
  }

  /// Rows of samples around a band in which middles of strokes that reach into it may lie.
  int margin() const {
    double radius = 0;
    for (const ScreenLine& l : screen_.lines) radius = std::max(radius, l.radius);
    return int(std::ceil(std::min(radius, 250.0 * samples_))) + 4;
  }

  double bias(const ScreenLine& line, double pixels) const {
    return pixels * projector_.pixel_size(std::min(line.a.z, line.b.z)) + 1e-6 * diagonal_;
  }
  RasterBand::Bias biases(const ScreenLine& line) const {
    const auto is_own = [this, source = line.source](std::uint32_t triangle) {
      if (source == ScreenLine::no_source) return false;
      const std::vector<FaceId>& own = lines_[source].faces;
      return std::find(own.begin(), own.end(), view_.scene.faces[screen_.triangles[triangle].patch].face) != own.end();
    };
    return {bias(line, own_bias), bias(line, other_bias), is_own};
  }

  void draw_band(int band, const Bins& bins) {
    const int first_pixel = band * band_height_, last_pixel = std::min(height_, first_pixel + band_height_);
    const int around = margin();
    RasterBand raster(width_ * samples_, first_pixel * samples_ - around,
                      (last_pixel - first_pixel) * samples_ + 2 * around, 1e-7 * diagonal_, projector_.perspective());
    for (const std::uint32_t i : bins.triangles[band]) {
      const ScreenTriangle& t = screen_.triangles[i];
      if (opaque_[t.patch]) raster.add_opaque(t, i);
    }
    for (const std::uint32_t i : bins.lines[band]) raster.add_line(screen_.lines[i], i, biases(screen_.lines[i]));
    if (!all_opaque_) {
      for (const std::uint32_t i : bins.triangles[band]) {
        const ScreenTriangle& t = screen_.triangles[i];
        if (!opaque_[t.patch]) raster.add_transparent(t, i);
      }
      raster.sort_layers();
    }
    for (int y = first_pixel; y < last_pixel; ++y) {
      for (int x = 0; x < width_; ++x) resolve(raster, x, y);
    }
  }

  Shade shade(std::uint32_t triangle, Vec2 sample, double depth) const {
    const ScreenTriangle& t = screen_.triangles[triangle];
    return shader_.at(t.patch, t.triangle, sample / samples_, depth);
  }

  /// Shades of the triangles of one pixel: each is computed once, where it is met first.
  struct ShadeCache {
    std::array<std::pair<std::uint32_t, Shade>, 32> entries;
    int count = 0;
  };
  Shade cached_shade(ShadeCache& cache, std::uint32_t triangle, Vec2 sample, double depth) const {
    for (int i = 0; i < cache.count; ++i) {
      if (cache.entries[i].first == triangle) return cache.entries[i].second;
    }
    const Shade s = shade(triangle, sample, depth);
    if (cache.count < int(cache.entries.size())) cache.entries[cache.count++] = {triangle, s};
    return s;
  }

  /// The colour of pixel x, y from its samples. Samples of one triangle are shaded once, at their mean.
  void resolve(const RasterBand& raster, int x, int y) {
    const std::size_t pixel = std::size_t(y) * width_ + x;
    const float part = 1.0f / float(samples_ * samples_);
    Rgb faces, rest;
    float alpha = 0;
    struct Group {
      std::uint32_t triangle;
      double x, y, depth;
      int count;
    };
    std::array<Group, 64> groups;
    ShadeCache shades;
    int n = 0;
    for (int sy = y * samples_; sy < (y + 1) * samples_; ++sy) {
      for (int sx = x * samples_; sx < (x + 1) * samples_; ++sx) {
        const std::size_t s = raster.at(sx, sy);
        const std::uint32_t triangle = raster.triangle(s), line = raster.line(s);
        if (raster.has_layers()) {
          Rgb color = to_rgb(options_.background);
          float a = options_.background.a / 255.0f;
          double depth = std::numeric_limits<double>::infinity();
          if (line != RasterBand::nothing) {
            color = to_rgb(screen_.lines[line].color), a = 1,
            depth = raster.line_depth(s) - bias(screen_.lines[line], own_bias);
          } else if (triangle != RasterBand::nothing) {
            color = cached_shade(shades, triangle, {sx + 0.5, sy + 0.5}, raster.depth(s)).color, a = 1,
            depth = raster.depth(s);
          }
          blend_layers(raster, s, sx, sy, depth, color, a, shades);
          rest = rest + part * color;
          alpha += part * a;
        } else if (line != RasterBand::nothing) {
          rest = rest + part * to_rgb(screen_.lines[line].color);
          alpha += part;
        } else if (triangle == RasterBand::nothing) {
          rest = rest + part * to_rgb(options_.background);
          alpha += part * options_.background.a / 255.0f;
        }
        if (triangle == RasterBand::nothing) continue;
        // Depth counts under lines as well; colour does not.
        const double z = raster.depth(s);
        canvas_.map.depth[pixel] = std::min(canvas_.map.depth[pixel], float(z));
        if (line != RasterBand::nothing || raster.has_layers()) continue;
        int g = 0;
        while (g < n && groups[g].triangle != triangle) ++g;
        if (g == n) groups[n++] = {triangle, 0, 0, 0, 0};
        groups[g].x += sx + 0.5, groups[g].y += sy + 0.5, groups[g].depth += z, ++groups[g].count;
      }
    }
    int most = 0;
    for (int g = 0; g < n; ++g) {
      const double c = groups[g].count;
      const Shade s = shade(groups[g].triangle, {groups[g].x / c, groups[g].y / c}, groups[g].depth / c);
      faces = faces + float(c) * part * s.color;
      alpha += float(c) * part;
      if (groups[g].count > most) {
        most = groups[g].count;
        canvas_.map.depth[pixel] = float(groups[g].depth / c);
        canvas_.map.normal[pixel] = {float(s.normal.x), float(s.normal.y), float(s.normal.z)};
      }
    }
    if (n == 0) canvas_.map.depth[pixel] = std::numeric_limits<float>::infinity();
    canvas_.faces[pixel] = faces;
    canvas_.rest[pixel] = rest;
    canvas_.alpha[pixel] = alpha;
  }

  /// Lays the transparent layers of a sample that are nearer than `depth` over the colour, the farthest first.
  void blend_layers(const RasterBand& raster, std::size_t sample, int sx, int sy, double depth, Rgb& color,
                    float& alpha, ShadeCache& shades) const {
    for (const RasterBand::Layer& layer : raster.layers(sample)) {
      if (layer.depth > depth) continue;
      const Shade s = cached_shade(shades, layer.triangle, {sx + 0.5, sy + 0.5}, layer.depth);
      const float a = s.alpha * float(options_.opacity);
      color = (1 - a) * color + a * s.color;
      alpha = alpha + a * (1 - alpha);
    }
  }

  Image developed(const std::vector<float>& light) const {
    Image image = Image::filled(width_, height_, options_.background);
    const auto byte = [](float v) { return std::uint8_t(std::clamp(v + 0.5f, 0.0f, 255.0f)); };
    for (std::size_t i = 0; i < canvas_.faces.size(); ++i) {
      const Rgb c = canvas_.rest[i] + (light.empty() ? 1.0f : light[i]) * canvas_.faces[i];
      std::uint8_t* p = &image.rgba[4 * i];
      p[0] = byte(c.r), p[1] = byte(c.g), p[2] = byte(c.b), p[3] = byte(255 * canvas_.alpha[i]);
    }
    return image;
  }

  const View& view_;
  const RenderOptions& options_;
  const std::vector<DrawnLine>& lines_;
  Projector projector_;
  Shader shader_;
  int width_, height_, samples_;
  double diagonal_ = 0;
  ScreenScene screen_;
  std::vector<bool> opaque_;
  bool all_opaque_ = true;
  int band_height_ = 32;  ///< pixels; fewer where every layer is kept
  Canvas canvas_;
};

}  // namespace

Result<Image> render_image(const Scene& scene, const RenderOptions& options, const Context& context) {
  ARESTA_CHECK(check_options(options));
  ARESTA_TRY(const View view, prepare_view(scene, options.view));
  std::vector<DrawnLine> lines;
  if (options.edges) {
    const bool silhouettes = options.silhouettes && options.faces;
    ARESTA_TRY(lines, drawn_lines(view.scene, view.camera, silhouettes, context));
    if (options.opacity < 1) {  // what lies behind is seen as well
      for (DrawnLine& line : lines) line.behind.clear();
    }
  }
  return Renderer(view, options, lines).run(context);
}

Status render_png(const Scene& scene, const RenderOptions& options, const std::string& path, const Context& context) {
  ARESTA_TRY(const Image image, render_image(scene, options, context));
  return write_png(image, path);
}

}  // namespace aresta::draw
