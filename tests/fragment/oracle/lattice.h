// SPDX-License-Identifier: Apache-2.0
// A cube of lattice points and the pieces into which its planes cut space: points, and the open unit edges, squares and
// cells between them.
//
// A piece is one number; its raw coordinates are 2 p + 1 along an axis where it lies on the plane p, and 2 p + 2 where
// it spans the interval from p to p + 1. So a neighbour of one dimension more or less is a stride away, and around the
// lattice there is one layer of pieces that are outside of everything. One step of the lattice is half the side of a
// grid cell: what is aligned with the cells and what is off by half a cell are both on lattice points.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace aresta::grid {

using Steps = std::array<int, 3>;
using Piece = std::uint32_t;

/// A closed box with its corners in steps; flat along an axis where both agree.
struct Box {
  Steps low{}, high{};
  bool operator==(const Box&) const = default;

  int dimension() const {
    int result = 0;
    for (int a = 0; a < 3; ++a) result += high[a] > low[a] ? 1 : 0;
    return result;
  }
};

class Lattice {
 public:
  /// Points have coordinates from 0 to `steps`.
  explicit Lattice(int steps) : steps_(steps), row_(2 * steps + 3), strides_{1, row_, row_ * row_} {
    const Piece n = static_cast<Piece>(row_ * row_ * row_);
    spans_.reserve(n);
    for (Piece p = 0; p < n; ++p) {
      std::uint8_t spanned = 0;
      for (int a = 0; a < 3; ++a) spanned |= static_cast<std::uint8_t>(raw(p, a) % 2 == 0 ? 1 << a : 0);
      spans_.push_back(spanned);
    }
  }

  int steps() const { return steps_; }
  Piece size() const { return static_cast<Piece>(spans_.size()); }
  int stride(int axis) const { return strides_[static_cast<std::size_t>(axis)]; }

  Piece at(const Steps& raw) const { return static_cast<Piece>(raw[0] + row_ * (raw[1] + row_ * raw[2])); }
  int raw(Piece p, int axis) const { return static_cast<int>(p) / stride(axis) % row_; }
  Piece point(const Steps& p) const { return at({2 * p[0] + 1, 2 * p[1] + 1, 2 * p[2] + 1}); }
  /// The corner of least coordinates; of a piece that is a point the point itself.
  Steps low(Piece p) const { return {(raw(p, 0) - 1) / 2, (raw(p, 1) - 1) / 2, (raw(p, 2) - 1) / 2}; }

  bool spans(Piece p, int axis) const { return (spans_[p] >> axis & 1) != 0; }
  int dimension(Piece p) const { return (spans_[p] & 1) + (spans_[p] >> 1 & 1) + (spans_[p] >> 2); }
  /// The axis that a piece of dimension 1 spans, or that a piece of dimension 2 does not span.
  int axis(Piece p) const {
    const int wanted = dimension(p) == 1 ? spans_[p] : 7 - spans_[p];
    return wanted >> 1;
  }

  /// The piece next to it; the caller knows that it is there (outermost pieces span, so any that does not span has it).
  Piece next(Piece p, int axis, bool up) const {
    return static_cast<Piece>(static_cast<int>(p) + (up ? stride(axis) : -stride(axis)));
  }

  template <class Function>
  void for_each(const Box& box, Function&& visit) const {
    for (int z = 2 * box.low[2] + 1; z <= 2 * box.high[2] + 1; ++z) {
      for (int y = 2 * box.low[1] + 1; y <= 2 * box.high[1] + 1; ++y) {
        for (int x = 2 * box.low[0] + 1; x <= 2 * box.high[0] + 1; ++x) visit(at({x, y, z}));
      }
    }
  }

  /// "(1,2..3,0)" in steps.
  std::string text(Piece p) const {
    std::string result = "(";
    const Steps from = low(p);
    for (int a = 0; a < 3; ++a) {
      const int c = from[static_cast<std::size_t>(a)];
      if (a > 0) result += ',';
      result += std::to_string(c);
      if (spans(p, a)) result += ".." + std::to_string(c + 1);
    }
    return result + ")";
  }

 private:
  int steps_, row_;
  std::array<int, 3> strides_;
  std::vector<std::uint8_t> spans_;
};

}  // namespace aresta::grid
