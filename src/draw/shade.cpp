// SPDX-License-Identifier: Apache-2.0
#include "draw/shade.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aresta::draw {
namespace {

/// Two lamps that move with the viewer: the key over the left shoulder, a weaker fill from the right. Both wrap around
/// bodies (half the cosine plus a half, squared), which leaves no hard border between light and shade.
const Vec3 key_light = normalized({-0.55, 0.60, 0.58});
const Vec3 fill_light = normalized({0.72, 0.05, 0.69});
const Vec3 key_half = normalized(key_light + Vec3{0, 0, 1});

double wrapped(double cosine) {
  const double h = std::max(0.0, 0.5 + 0.5 * cosine);
  return h * h;
}

double light(Vec3 n) {
  return 0.46 + 0.52 * wrapped(dot(n, key_light)) + 0.20 * wrapped(dot(n, fill_light));
}

/// A broad, weak gloss; an even power, by squaring.
double gloss(Vec3 n) {
  double g = std::max(0.0, dot(n, key_half));
  for (int i = 0; i < 5; ++i) g *= g;
  return 26 * g;
}

constexpr int taps = 20;
constexpr int patterns = 16;  // 4 x 4 pixels with a turn of their own

/// Places around a pixel on a spiral, for each pattern; in the unit disk.
const std::array<std::array<Vec2, taps>, patterns>& tap_table() {
  static const auto table = [] {
    std::array<std::array<Vec2, taps>, patterns> t;
    constexpr int order[patterns] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    for (int p = 0; p < patterns; ++p) {
      for (int i = 0; i < taps; ++i) {
        const double radius = (i + 0.5) / taps;
        const double angle = 2.399963229728653 * i + 6.283185307179586 * order[p] / patterns;
        t[p][i] = {radius * std::cos(angle), radius * std::sin(angle)};
      }
    }
    return t;
  }();
  return table;
}

}  // namespace

Shader::Shader(const View& view, const Projector& projector, Shading shading, Coloring coloring)
    : scene_(view.scene), projector_(projector), shading_(shading) {
  const FaceColors colors(view.scene, coloring);
  for (const FacePatch& patch : view.scene.faces) colors_.push_back({colors.of(patch, 0), colors.of(patch, 1)});
}

Shade Shader::at(std::uint32_t patch_index, std::uint32_t triangle, Vec2 pixel, double depth) const {
  const FacePatch& patch = scene_.faces[patch_index];
  const auto& [i, j, k] = patch.triangles[triangle];
  const Vec3 a = patch.points[i], b = patch.points[j], c = patch.points[k];
  const Vec3 n = cross(b - a, c - a);
  const Vec3 place = projector_.to_world(projector_.screen_to_view(pixel, depth));
  const bool front = dot(n, projector_.sight(place)) <= 0;
  Vec3 normal = normalized(n);
  const double n2 = norm2(n);
  if (shading_ == Shading::smooth && !patch.normals.empty() && n2 > 0) {
    const double u = std::clamp(dot(cross(c - b, place - b), n) / n2, 0.0, 1.0);
    const double v = std::clamp(dot(cross(a - c, place - c), n) / n2, 0.0, 1.0);
    const Vec3 mean = u * patch.normals[i] + v * patch.normals[j] + std::max(0.0, 1 - u - v) * patch.normals[k];
    if (norm2(mean) > 0) normal = normalized(mean);
  }
  if (!front) normal = -normal;
  const Vec3 m{dot(normal, projector_.right()), dot(normal, projector_.up()), -dot(normal, projector_.forward())};
  const Color color = colors_[patch_index][front ? 0 : 1];
  const double l = light(m), g = gloss(m);
  const auto channel = [&](std::uint8_t value) { return float(std::min(255.0, value * l + g)); };
  return {{channel(color.r), channel(color.g), channel(color.b)}, color.a / 255.0f, m};
}

void obscure_rows(const DepthMap& map, const Projector& projector, double radius, int first, int last,
                  std::vector<float>& light) {
  const auto& table = tap_table();
  const double near_enough = 0.02 * radius;
  for (int y = first; y < last; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const std::size_t at = std::size_t(y) * map.width + x;
      light[at] = 1;
      const double depth = map.depth[at];
      if (!std::isfinite(depth)) continue;
      const auto& nf = map.normal[at];
      const Vec3 n{nf[0], nf[1], -nf[2]};  // depth grows away from the eye
      const Vec3 p = projector.screen_to_view({x + 0.5, y + 0.5}, depth);
      const double reach = std::min(radius / projector.pixel_size(depth), 0.25 * std::max(map.width, map.height));
      double sum = 0;
      for (const Vec2 tap : table[(y & 3) * 4 + (x & 3)]) {
        const int tx = int(std::floor(x + 0.5 + reach * tap.x)), ty = int(std::floor(y + 0.5 + reach * tap.y));
        if (tx < 0 || ty < 0 || tx >= map.width || ty >= map.height) continue;
        const double d = map.depth[std::size_t(ty) * map.width + tx];
        if (!std::isfinite(d)) continue;
        const Vec3 v = projector.screen_to_view({tx + 0.5, ty + 0.5}, d) - p;
        const double far = norm2(v) / (radius * radius);
        if (far >= 1.7) continue;  // what stands far in front is not near
        sum += std::max(0.0, dot(v, n) - near_enough) / (norm2(v) + 0.01 * radius * radius) * (1 - far / 1.7);
      }
      light[at] = float(std::clamp(1 - 1.25 * radius * sum / taps, 0.35, 1.0));
    }
  }
}

void smooth_rows(const DepthMap& map, const Projector& projector, const std::vector<float>& light, int first, int last,
                 std::vector<float>& result) {
  for (int y = first; y < last; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const std::size_t at = std::size_t(y) * map.width + x;
      const float depth = map.depth[at];
      result[at] = 1;
      if (!std::isfinite(depth)) continue;
      const auto& n = map.normal[at];
      double sum = 0, weight = 0;
      // Over 8 x 8 pixels: each of the 4 x 4 patterns four times.
      for (int dy = -4; dy < 4; ++dy) {
        for (int dx = -4; dx < 4; ++dx) {
          const int tx = x + dx, ty = y + dy;
          if (tx < 0 || ty < 0 || tx >= map.width || ty >= map.height) continue;
          const std::size_t other = std::size_t(ty) * map.width + tx;
          if (!std::isfinite(map.depth[other])) continue;
          const auto& m = map.normal[other];
          const float cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
          const double slope = 1 / std::max(0.1f, n[2]);
          if (cosine < 0.85f || std::abs(map.depth[other] - depth) > 8 * slope * projector.pixel_size(depth)) continue;
          sum += light[other];
          weight += 1;
        }
      }
      result[at] = weight > 0 ? float(sum / weight) : light[at];
    }
  }
}

}  // namespace aresta::draw
