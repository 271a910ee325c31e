// SPDX-License-Identifier: Apache-2.0
// Internal to draw: some rows of samples of a picture, and what is seen at each.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "draw/screen_scene.h"

namespace aresta::draw {

class RasterBand {
 public:
  static constexpr std::uint32_t nothing = 0xffffffffu;

  /// Sample rows [first, first + rows) of a picture `width` samples wide. `tie`: depths nearer than this are one.
  RasterBand(int width, int first, int rows, double tie, bool perspective);

  /// Fills what is nearest.
  void add_opaque(const ScreenTriangle& t, std::uint32_t index);
  /// Keeps every layer; call sort_layers() when all are in.
  void add_transparent(const ScreenTriangle& t, std::uint32_t index);
  void sort_layers();
  /// How far a line may lie behind what covers it and still be seen: rounding and the slope of the covering face
  /// between samples. Only a face that the line bounds may be steep there.
  struct Bias {
    double own = 0, other = 0;
    std::function<bool(std::uint32_t triangle)> is_own;
  };
  /// A stroke where its middle line is seen; after all opaque triangles. Of strokes nearer to each other than
  /// `bias.other` the first stays.
  void add_line(const ScreenLine& line, std::uint32_t index, const Bias& bias);

  struct Layer {
    float depth;
    std::uint32_t triangle;
  };

  int width() const { return width_; }
  int first() const { return first_; }
  std::size_t at(int x, int y) const { return std::size_t(y - first_) * width_ + x; }
  double depth(std::size_t sample) const { return depth_[sample]; }
  std::uint32_t triangle(std::size_t sample) const { return triangle_[sample]; }
  std::uint32_t line(std::size_t sample) const { return line_[sample]; }
  double line_depth(std::size_t sample) const { return line_depth_[sample]; }
  bool has_layers() const { return !layers_.empty(); }
  /// The layers of a sample, farthest first; after sort_layers().
  std::span<const Layer> layers(std::size_t sample) const {
    return {layers_.data() + layer_begin_[sample], layers_.data() + layer_end_[sample]};
  }

 private:
  template <class Visit>
  void scan(const ScreenTriangle& t, const Visit& visit) const;
  bool line_is_seen(double x, double y, double depth, const Bias& bias) const;
  void stroke(const ScreenLine& line, std::uint32_t index, double from, double to, double tie);
  double depth_along(const ScreenLine& line, double t) const;

  int width_, first_, rows_;
  double tie_;
  bool perspective_;
  std::vector<double> depth_;
  std::vector<std::uint32_t> triangle_;
  std::vector<float> line_depth_;
  std::vector<std::uint32_t> line_;
  std::vector<std::pair<std::uint32_t, Layer>> unsorted_;  ///< sample, layer
  std::vector<Layer> layers_;
  std::vector<std::uint32_t> layer_begin_, layer_end_;  ///< by sample
};

}  // namespace aresta::draw
