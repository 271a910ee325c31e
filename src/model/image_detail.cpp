// SPDX-License-Identifier: Apache-2.0
#include "model/image_detail.h"

#include <cmath>

namespace aresta::model_detail {

namespace {

constexpr int sample_count = 32;

Vec2 nearest_shift(Vec2 from, Vec2 to, Vec2 period) {
  return {period.x > 0 ? period.x * std::round((to.x - from.x) / period.x) : 0,
          period.y > 0 ? period.y * std::round((to.y - from.y) / period.y) : 0};
}

void widen(Range& r, double value) {
  r = r.low > r.high ? Range{value, value} : Range{std::min(r.low, value), std::max(r.high, value)};
}

/// Is the whole line v = const (u = const) through uv one point of the surface, so that u (v) means nothing there?
struct Pole {
  bool u = false, v = false;
};

Pole pole_at(const Surface& surface, Vec2 uv, Vec2 period, double size) {
  const SurfaceJet jet = surface.jet(uv);
  return {period.x > 0 && norm(jet.du) * period.x <= 1e-7 * size,
          period.y > 0 && norm(jet.dv) * period.y <= 1e-7 * size};
}

void sample(const Model& model, const Surface& surface, ImagePiece& piece) {
  const EdgeId e = model.topology().edge(piece.coedge);
  piece.samples.reserve(sample_count + 1);
  const Range range = model.range(e);
  // Start in the middle, where a pole is unlikely, and walk to both ends.
  std::vector<Vec2>& s = piece.samples;
  s.resize(sample_count + 1);
  constexpr int middle = sample_count / 2;
  const auto point = [&](int i) { return model.edge_point(e, range.at(static_cast<double>(i) / sample_count)); };
  s[middle] = surface.project(point(middle)).uv;
  for (int i = middle + 1; i <= sample_count; ++i) s[i] = surface.project(point(i), &s[i - 1]).uv;
  for (int i = middle - 1; i >= 0; --i) s[i] = surface.project(point(i), &s[i + 1]).uv;
}

/// The sphere with poles as far from the face's edges as a few fixed directions allow; the stored poles when good
/// enough.
Sphere turned_sphere(const Model& model, FaceId face, const Sphere& sphere) {
  const Complex& topology = model.topology();
  const Frame& f = sphere.frame;
  std::vector<Vec3> points;
  for (const LoopId l : topology.loops(face)) {
    for (const CoedgeId c : topology.coedges(l)) {
      const EdgeId e = topology.edge(c);
      for (int i = 0; i < 16; ++i) {
        points.push_back(normalized(model.edge_point(e, model.range(e).at(i / 16.0)) - f.origin));
      }
    }
  }
  static constexpr double directions[][3] = {{0, 0, 1},  {1, 0, 0},  {0, 1, 0},  {1, 1, 1},  {-1, 1, 1},
                                             {1, -1, 1}, {1, 1, -1}, {1, 1, 0},  {1, -1, 0}, {1, 0, 1},
                                             {1, 0, -1}, {0, 1, 1},  {0, 1, -1}, {1, 2, 3},  {-2, 3, 1}};
  Vec3 best = f.z;
  double best_score = -1;
  for (const auto& d : directions) {
    const Vec3 axis = normalized(d[0] * f.x + d[1] * f.y + d[2] * f.z);
    double score = 1;
    for (const Vec3 p : points) score = std::min(score, norm(cross(p, axis)));
    if (score > best_score + 1e-3) {
      best = axis;
      best_score = score;
    }
    if (best_score > 0.5) break;
  }
  if (best == f.z) return sphere;
  const Vec3 x = any_perpendicular(best);
  return {{f.origin, x, f.right_handed() ? cross(best, x) : cross(x, best), best}, sphere.radius};
}

}  // namespace

Vec2 invert(const Surface& surface, Vec3 p, Vec2 hint) {
  if (surface.get_if<FreeSurface>() == nullptr) return surface.project(p, &hint).uv;
  Vec2 uv = hint;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 12; ++i) {
    const SurfaceJet j = surface.jet(uv);
    const Vec3 r = p - j.point;
    const double a = dot(j.du, j.du) - dot(r, j.duu), b = dot(j.du, j.dv) - dot(r, j.duv),
                 c = dot(j.dv, j.dv) - dot(r, j.dvv), determinant = a * c - b * b;
    const double ru = dot(r, j.du), rv = dot(r, j.dv);
    if (!(determinant > 1e-14 * norm2(j.du) * norm2(j.dv))) break;
    const Vec2 step{(c * ru - b * rv) / determinant, (a * rv - b * ru) / determinant};
    const double size = norm(step.x * j.du + step.y * j.dv);
    if (!(size < 0.5 * last) && i > 1) return uv;  // as good as rounding allows
    uv += step;
    last = size;
    if (size <= 1e-15 * norm(p)) return uv;
  }
  if (last < 1e-9 * (1 + norm(p))) return uv;
  return surface.project(p, &hint).uv;
}

Vec2 uv_tangent(const SurfaceJet& j, Vec3 d1, Vec3 off) {
  // Derivative of du.(p - S) = 0 and dv.(p - S) = 0 along the curve.
  const double e = dot(j.du, j.du) - dot(off, j.duu), f = dot(j.du, j.dv) - dot(off, j.duv),
               g = dot(j.dv, j.dv) - dot(off, j.dvv), determinant = e * g - f * f;
  if (!(determinant > 1e-24 * e * g) || determinant == 0) return {};
  const double a = dot(j.du, d1), b = dot(j.dv, d1);
  return {(g * a - f * b) / determinant, (e * b - f * a) / determinant};
}

Vec2 FaceImage::uv(const ImagePiece& piece, double t) const {
  if (piece.samples.empty()) return model->uv(piece.coedge, t) + piece.shift;
  const EdgeId e = model->topology().edge(piece.coedge);
  const Range range = model->range(e);
  const double x = range.length() != 0 ? (t - range.low) / range.length() * sample_count : 0;
  const int i = std::clamp(static_cast<int>(x), 0, sample_count - 1);
  const Vec2 hint = piece.samples[i] + (x - i) * (piece.samples[i + 1] - piece.samples[i]);
  return surface().project(model->edge_point(e, t), &hint).uv + piece.shift;
}

double FaceImage::gap_length(const ImagePiece& piece) const {
  if (piece.gap_end == piece.end) return 0;
  constexpr int steps = 8;
  double length = 0;
  Vec3 last = surface().point(piece.end);
  for (int i = 1; i <= steps; ++i) {
    const Vec3 p = surface().point(piece.end + (i / double{steps}) * (piece.gap_end - piece.end));
    length += distance(last, p);
    last = p;
  }
  return length;
}

FaceImage image_of(const Model& model, FaceId face) {
  const Complex& topology = model.topology();
  FaceImage image;
  image.model = &model;
  image.face = face;
  if (const auto* sphere = model.surface(face).get_if<Sphere>()) image.turned = turned_sphere(model, face, *sphere);
  const Surface& surface = image.surface();
  image.period = surface.period();
  const bool is_plane = surface.is_plane();
  const bool periodic = image.period.x > 0 || image.period.y > 0;

  for (const LoopId l : topology.loops(face)) {
    if (topology.is_vertex_loop(l)) continue;
    LoopImage loop;
    loop.first = image.pieces.size();
    for (const CoedgeId c : topology.coedges(l)) {
      ImagePiece piece;
      piece.coedge = c;
      const Range range = model.range(topology.edge(c));
      piece.from = topology.reversed(c) ? range.high : range.low;
      piece.to = topology.reversed(c) ? range.low : range.high;
      if (image.turned || (!is_plane && model.pcurve(c) == nullptr)) {
        sample(model, surface, piece);
        piece.start = piece.samples[topology.reversed(c) ? sample_count : 0];
        piece.end = piece.samples[topology.reversed(c) ? 0 : sample_count];
      } else {
        piece.start = model.uv(c, piece.from);
        piece.end = model.uv(c, piece.to);
      }
      image.pieces.push_back(std::move(piece));
    }
    loop.count = image.pieces.size() - loop.first;

    // Lift: each piece follows the one before it.
    ImagePiece* pieces = image.pieces.data() + loop.first;
    double size = 0;
    for (std::size_t i = 0; i < loop.count; ++i) {
      ImagePiece& piece = pieces[i];
      if (i > 0 && periodic) {
        const ImagePiece& before = pieces[i - 1];
        Vec2 shift = nearest_shift(piece.start, before.end, image.period);
        if (shift.x != before.shift.x || shift.y != before.shift.y) {
          if (size == 0) size = model.bounds(topology.edge(piece.coedge)).diagonal();
          const Pole pole = pole_at(surface, piece.start, image.period, size);
          if (pole.u) shift.x = before.shift.x;
          if (pole.v) shift.y = before.shift.y;
        }
        piece.shift = shift;
        piece.start += shift;
        piece.end += shift;
      }
      if (i > 0) pieces[i - 1].gap_end = piece.start;
    }
    ImagePiece& last = pieces[loop.count - 1];
    Vec2 turn = periodic ? nearest_shift(pieces[0].start, last.end, image.period) : Vec2{};
    if (turn.x != 0 || turn.y != 0) {
      const Pole pole = pole_at(surface, last.end, image.period, model.bounds(topology.edge(last.coedge)).diagonal());
      if (pole.u) turn.x = 0;
      if (pole.v) turn.y = 0;
    }
    last.gap_end = pieces[0].start + turn;
    loop.winding = {image.period.x > 0 ? turn.x / image.period.x : 0, image.period.y > 0 ? turn.y / image.period.y : 0};
    image.loops.push_back(loop);
  }

  // Pairs of one edge, run through both ways: internal when the stored images agree, else a seam.
  for (ImagePiece& piece : image.pieces) {
    const EdgeId e = topology.edge(piece.coedge);
    if (topology.radial(piece.coedge) != piece.coedge) {
      for (const CoedgeId other : topology.coedges(e)) {
        if (other == piece.coedge || topology.face(other) != face ||
            topology.reversed(other) == topology.reversed(piece.coedge)) {
          continue;
        }
        piece.paired = true;
        if (is_plane) {
          piece.internal = true;
          continue;
        }
        const double middle = model.range(e).middle();
        const Vec2 uv = model.uv(piece.coedge, middle), difference = model.uv(other, middle) - uv;
        const SurfaceJet jet = model.surface(face).jet(uv);
        const double far = norm(difference.x * jet.du) + norm(difference.y * jet.dv);
        const double near = 10 * std::max({model.tolerance(e), model.tolerance(), 1e-9 * norm(jet.point)});
        piece.internal = far <= near;
      }
    }
    if (!piece.paired) image.has_boundary = true;
    widen(image.box.u, piece.start.x);
    widen(image.box.u, piece.end.x);
    widen(image.box.v, piece.start.y);
    widen(image.box.v, piece.end.y);
    const bool line_image =
        (is_plane && model.is_straight(e)) || (piece.samples.empty() && model.pcurve(piece.coedge) != nullptr &&
                                               model.pcurve(piece.coedge)->get_if<Line2>() != nullptr);
    if (!line_image) {
      for (int i = 1; i < 8; ++i) {
        const Vec2 uv = image.uv(piece, model.range(e).at(i / 8.0));
        widen(image.box.u, uv.x);
        widen(image.box.v, uv.y);
      }
    }
  }
  return image;
}

}  // namespace aresta::model_detail
