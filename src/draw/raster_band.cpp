// SPDX-License-Identifier: Apache-2.0
#include "draw/raster_band.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aresta::draw {
namespace {

/// Positive to the left of a -> b. Two triangles that share the edge get values that are exact opposites: no cracks.
struct EdgeFunction {
  double a, b, c;

  EdgeFunction(Vec3 p, Vec3 q) {
    const bool swapped = p.x > q.x || (p.x == q.x && p.y > q.y);
    if (swapped) std::swap(p, q);
    a = p.y - q.y;
    b = q.x - p.x;
    c = p.x * q.y - p.y * q.x;
    if (swapped) a = -a, b = -b, c = -c;
  }
  double at(double x, double y) const { return a * x + b * y + c; }
};

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

RasterBand::RasterBand(int width, int first, int rows, double tie, bool perspective)
    : width_(width), first_(first), rows_(rows), tie_(tie), perspective_(perspective) {
  const std::size_t n = std::size_t(width) * rows;
  depth_.assign(n, infinity);
  triangle_.assign(n, nothing);
  line_depth_.assign(n, std::numeric_limits<float>::infinity());
  line_.assign(n, nothing);
}

template <class Visit>
void RasterBand::scan(const ScreenTriangle& t, const Visit& visit) const {
  Vec3 p = t.p[0], q = t.p[1], r = t.p[2];
  double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  if (area < 0) {
    std::swap(q, r);
    area = -area;
  }
  if (!(area > 1e-12)) return;
  const double low_x = std::min({p.x, q.x, r.x}), high_x = std::max({p.x, q.x, r.x});
  const double low_y = std::min({p.y, q.y, r.y}), high_y = std::max({p.y, q.y, r.y});
  if (high_x < 0 || low_x > width_ || high_y < first_ || low_y > first_ + rows_) return;
  const int x0 = int(std::max(0.0, std::ceil(low_x - 0.5))), x1 = int(std::min(width_ - 1.0, std::floor(high_x - 0.5)));
  const int y0 = int(std::max<double>(first_, std::ceil(low_y - 0.5)));
  const int y1 = int(std::min<double>(first_ + rows_ - 1, std::floor(high_y - 0.5)));
  if (x0 > x1 || y0 > y1) return;

  const EdgeFunction e0(q, r), e1(r, p), e2(p, q);
  const double low = std::min({p.z, q.z, r.z}), high = std::max({p.z, q.z, r.z});
  const double zp = (perspective_ ? 1 / p.z : p.z) / area, zq = (perspective_ ? 1 / q.z : q.z) / area,
               zr = (perspective_ ? 1 / r.z : r.z) / area;
  for (int y = y0; y <= y1; ++y) {
    const double cy = y + 0.5;
    // The range of x in which all three functions can be positive, a sample wider against rounding.
    double from = x0, to = x1;
    bool empty = false;
    for (const EdgeFunction& e : {e0, e1, e2}) {
      const double rest = e.b * cy + e.c;
      if (e.a > 0) {
        from = std::max(from, -rest / e.a - 1.5);
      } else if (e.a < 0) {
        to = std::min(to, -rest / e.a + 0.5);
      } else if (rest < 0) {
        empty = true;
      }
    }
    if (empty || from > to) continue;
    for (int x = int(from), last = int(to); x <= last; ++x) {
      const double cx = x + 0.5;
      const double u = e0.at(cx, cy), v = e1.at(cx, cy), w = e2.at(cx, cy);
      if (u < 0 || v < 0 || w < 0) continue;
      const double z = u * zp + v * zq + w * zr;
      visit(at(x, y), std::clamp(perspective_ ? 1 / z : z, low, high));
    }
  }
}

void RasterBand::add_opaque(const ScreenTriangle& t, std::uint32_t index) {
  scan(t, [&](std::size_t sample, double z) {
    if (!(z < depth_[sample] - tie_)) return;
    depth_[sample] = z;
    triangle_[sample] = index;
  });
}

void RasterBand::add_transparent(const ScreenTriangle& t, std::uint32_t index) {
  scan(t, [&](std::size_t sample, double z) { unsorted_.push_back({std::uint32_t(sample), {float(z), index}}); });
}

void RasterBand::sort_layers() {
  layer_begin_.assign(depth_.size() + 1, 0);
  for (const auto& [sample, layer] : unsorted_) ++layer_begin_[sample + 1];
  for (std::size_t i = 1; i < layer_begin_.size(); ++i) layer_begin_[i] += layer_begin_[i - 1];
  layer_end_.assign(layer_begin_.begin(), layer_begin_.end() - 1);
  layers_.resize(unsorted_.size());
  for (const auto& [sample, layer] : unsorted_) layers_[layer_end_[sample]++] = layer;
  unsorted_ = {};
  const auto farther = [](const Layer& a, const Layer& b) {
    return a.depth != b.depth ? a.depth > b.depth : a.triangle > b.triangle;
  };
  // Two triangles of one face that share an edge may both cover a sample on it: one layer.
  const auto same = [&](const Layer& a, const Layer& b) { return std::abs(a.depth - b.depth) <= tie_; };
  for (std::size_t s = 0; s < layer_end_.size(); ++s) {
    const auto first = layers_.begin() + layer_begin_[s], last = layers_.begin() + layer_end_[s];
    if (last - first < 2) continue;
    std::sort(first, last, farther);
    layer_end_[s] = std::uint32_t(std::unique(first, last, same) - layers_.begin());
  }
}

bool RasterBand::line_is_seen(double x, double y, double depth, const Bias& bias) const {
  const int cx = int(std::floor(x)), cy = int(std::floor(y));
  for (int yy = std::max(cy - 1, first_); yy <= std::min(cy + 1, first_ + rows_ - 1); ++yy) {
    for (int xx = std::max(cx - 1, 0); xx <= std::min(cx + 1, width_ - 1); ++xx) {
      const std::size_t sample = at(xx, yy);
      if (depth - bias.other <= depth_[sample]) return true;
      if (depth - bias.own <= depth_[sample] && bias.is_own(triangle_[sample])) return true;
    }
  }
  return false;
}

double RasterBand::depth_along(const ScreenLine& line, double t) const {
  if (!perspective_) return line.a.z + t * (line.b.z - line.a.z);
  return 1 / ((1 - t) / line.a.z + t / line.b.z);
}

void RasterBand::add_line(const ScreenLine& line, std::uint32_t index, const Bias& bias) {
  const double dx = line.b.x - line.a.x, dy = line.b.y - line.a.y;
  const double length = std::hypot(dx, dy);
  const int steps = int(std::min(1e6, std::ceil(2 * length))) + 1;  // the same places whatever the band
  // Only the part that can touch this band.
  const double reach = line.radius + 2;
  double from = 0, to = 1;
  const auto restrict_to = [&](double start, double slope, double low, double high) {
    if (std::abs(slope) < 1e-12) {
      if (start < low || start > high) to = -1;
      return;
    }
    const double t0 = (low - start) / slope, t1 = (high - start) / slope;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  };
  restrict_to(line.a.y, dy, first_ - reach, first_ + rows_ + reach);
  restrict_to(line.a.x, dx, -reach, width_ + reach);
  if (from > to) return;
  const int last = int(std::ceil(to * steps));
  double run = -1;
  for (int i = int(std::floor(from * steps)); i <= last; ++i) {
    const double t = double(i) / steps;
    const bool seen = line_is_seen(line.a.x + t * dx, line.a.y + t * dy, depth_along(line, t), bias);
    if (seen && run < 0) run = t;
    if (run >= 0 && (!seen || i == last)) {
      stroke(line, index, run, seen ? t : double(i - 1) / steps, bias.other);
      run = -1;
    }
  }
}

void RasterBand::stroke(const ScreenLine& line, std::uint32_t index, double from, double to, double tie) {
  const Vec3 d = line.b - line.a;
  const double length = std::hypot(d.x, d.y);
  const int pieces = std::max(1, int(std::ceil((to - from) * length / 16)));
  const double r2 = line.radius * line.radius;
  for (int k = 0; k < pieces; ++k) {
    const double t0 = from + (to - from) * k / pieces, t1 = from + (to - from) * (k + 1) / pieces;
    const Vec2 p{line.a.x + t0 * d.x, line.a.y + t0 * d.y}, q{line.a.x + t1 * d.x, line.a.y + t1 * d.y};
    const Vec2 pq = q - p;
    const double pq2 = dot(pq, pq);
    const int x0 = std::max(0, int(std::floor(std::min(p.x, q.x) - line.radius)));
    const int x1 = std::min(width_ - 1, int(std::ceil(std::max(p.x, q.x) + line.radius)));
    const int y0 = std::max(first_, int(std::floor(std::min(p.y, q.y) - line.radius)));
    const int y1 = std::min(first_ + rows_ - 1, int(std::ceil(std::max(p.y, q.y) + line.radius)));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const Vec2 c{x + 0.5, y + 0.5};
        const double s = pq2 > 0 ? std::clamp(dot(c - p, pq) / pq2, 0.0, 1.0) : 0;
        const Vec2 away = c - (p + s * pq);
        if (dot(away, away) > r2) continue;
        const std::size_t sample = at(x, y);
        const float z = float(depth_along(line, t0 + s * (t1 - t0)));
        if (z < line_depth_[sample] - float(tie)) {
          line_depth_[sample] = z;
          line_[sample] = index;
        }
      }
    }
  }
}

}  // namespace aresta::draw
