// SPDX-License-Identifier: Apache-2.0
#include "draw/coincident.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace aresta::draw {
namespace {

/// A piece as seen: on which line of the picture, and between which places of it.
struct Trace {
  double angle = 0, offset = 0;  ///< of the line, angle in [0, pi)
  double from = 0, to = 0;       ///< along the line, from < to
  double depth_from = 0, depth_to = 0;
  bool reversed = false;  ///< the piece runs against the line
  std::uint32_t piece = 0;
};

/// Disjoint intervals of a line.
class Cover {
 public:
  /// The parts of [from, to] not yet covered, longer than `least`; then all of it is covered.
  std::vector<std::pair<double, double>> add(double from, double to, double least) {
    std::vector<std::pair<double, double>> free;
    double at = from;
    auto it = parts_.upper_bound(from);
    if (it != parts_.begin() && std::prev(it)->second >= from) --it;
    double low = from, high = to;
    while (it != parts_.end() && it->first <= to) {
      if (it->first - at > least) free.emplace_back(at, it->first);
      at = std::max(at, it->second);
      low = std::min(low, it->first);
      high = std::max(high, it->second);
      it = parts_.erase(it);
    }
    if (to - at > least) free.emplace_back(at, to);
    parts_[low] = high;
    return free;
  }

 private:
  std::map<double, double> parts_;
};

}  // namespace

void keep_coincident_once(HiddenLines& result, const Projector& projector) {
  const bool perspective = projector.perspective();
  std::vector<Trace> traces;
  Box3 seen;
  for (std::uint32_t i = 0; i < result.pieces.size(); ++i) {
    const LinePiece& piece = result.pieces[i];
    Vec3 a = projector.to_view(piece.a), b = projector.to_view(piece.b);
    if (perspective) a = {a.x / a.z, a.y / a.z, a.z}, b = {b.x / b.z, b.y / b.z, b.z};
    seen.add(a);
    seen.add(b);
    Trace t;
    t.piece = i;
    t.angle = std::atan2(b.y - a.y, b.x - a.x);
    if (t.angle < -1e-9) {
      t.angle += std::numbers::pi;
      t.reversed = true;
    } else if (t.angle > std::numbers::pi - 1e-9) {
      t.angle -= std::numbers::pi;
      t.reversed = true;
    }
    if (t.reversed) std::swap(a, b);
    t.from = a.x, t.offset = a.y, t.depth_from = a.z;  // raw places until the line is known
    t.to = b.x, t.depth_to = b.z;
    traces.push_back(t);
  }
  if (traces.empty()) return;
  const double size = std::max(seen.high.x - seen.low.x, seen.high.y - seen.low.y);
  const Vec2 centre{0.5 * (seen.low.x + seen.high.x), 0.5 * (seen.low.y + seen.high.y)};
  const double close = 4e-9 * size;
  std::sort(traces.begin(), traces.end(),
            [](const Trace& a, const Trace& b) { return std::tie(a.angle, a.piece) < std::tie(b.angle, b.piece); });

  std::vector<LinePiece> kept;
  const auto before = [&](const Trace& a, const Trace& b) {
    const LinePiece &p = result.pieces[a.piece], &q = result.pieces[b.piece];
    const auto key = [&](const Trace& t, const LinePiece& l) {
      return std::tuple(!l.visible, result.lines[l.line].kind == LineKind::silhouette, t.depth_from + t.depth_to,
                        t.piece);
    };
    return key(a, p) < key(b, q);
  };
  for (std::size_t i = 0, end; i < traces.size(); i = end) {
    end = i + 1;
    while (end < traces.size() && traces[end].angle - traces[end - 1].angle < 1e-9) ++end;
    // One direction for all, so that offsets compare.
    const double angle = traces[i + (end - i) / 2].angle;
    const Vec2 along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
    for (std::size_t k = i; k < end; ++k) {
      Trace& t = traces[k];
      const LinePiece& piece = result.pieces[t.piece];
      const auto flat = [&](Vec3 p) {
        const Vec3 v = projector.to_view(p);
        return (perspective ? Vec2{v.x / v.z, v.y / v.z} : Vec2{v.x, v.y}) - centre;
      };
      Vec2 a = flat(piece.a), b = flat(piece.b);
      if (t.reversed) std::swap(a, b);
      t.from = dot(a, along), t.to = dot(b, along);
      t.offset = 0.5 * dot(a + b, across);
    }
    std::sort(traces.begin() + i, traces.begin() + end,
              [](const Trace& a, const Trace& b) { return std::tie(a.offset, a.piece) < std::tie(b.offset, b.piece); });
    for (std::size_t j = i, stop; j < end; j = stop) {
      stop = j + 1;
      while (stop < end && traces[stop].offset - traces[stop - 1].offset < close) ++stop;
      std::sort(traces.begin() + j, traces.begin() + stop, before);
      Cover cover;
      for (std::size_t k = j; k < stop; ++k) {
        const Trace& t = traces[k];
        const LinePiece& piece = result.pieces[t.piece];
        for (const auto& [from, to] : cover.add(t.from, t.to, close)) {
          if (from == t.from && to == t.to) {
            kept.push_back(piece);
            continue;
          }
          const auto parameter = [&](double at) {  // of the piece, in space
            double s = (at - t.from) / (t.to - t.from);
            if (perspective) s = s * t.depth_from / ((1 - s) * t.depth_to + s * t.depth_from);
            return std::clamp(t.reversed ? 1 - s : s, 0.0, 1.0);
          };
          double u = from == t.from ? (t.reversed ? 1 : 0) : parameter(from),
                 v = to == t.to ? (t.reversed ? 0 : 1) : parameter(to);
          if (u > v) std::swap(u, v);
          LinePiece part = piece;
          part.from = u == 0 ? piece.from : piece.from + u * (piece.to - piece.from);
          part.to = v == 1 ? piece.to : piece.from + v * (piece.to - piece.from);
          part.a = u == 0 ? piece.a : lerp(piece.a, piece.b, u);
          part.b = v == 1 ? piece.b : lerp(piece.a, piece.b, v);
          kept.push_back(part);
        }
      }
    }
  }
  std::sort(kept.begin(), kept.end(), [](const LinePiece& a, const LinePiece& b) {
    return std::tie(a.line, a.segment, a.from) < std::tie(b.line, b.segment, b.from);
  });
  result.pieces = std::move(kept);
}

}  // namespace aresta::draw
