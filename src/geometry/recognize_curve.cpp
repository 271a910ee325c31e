// SPDX-License-Identifier: Apache-2.0
#include "geometry/analytic.h"
#include "geometry/fit.h"
#include "geometry/nurbs_bound.h"
#include "geometry/recognize.h"

namespace aresta {

namespace {

/// The piece as NURBS, and points along it.
struct Piece {
  NurbsCurveData data;
  std::optional<Curve> nurbs;
  std::vector<Vec3> points;
  double size = 0, noise = 0;
};

std::optional<Piece> prepared(const Curve& curve, Range range) {
  Piece p;
  p.data = curve.to_nurbs(range);
  if (p.data.degree == 0 || p.data.periodic) return std::nullopt;
  auto made = FreeCurve::from_nurbs(p.data);
  if (!made.ok()) return std::nullopt;
  p.nurbs = Curve(*made);
  Box3 box;
  for (const Vec3 q : p.data.poles) box.add(q);
  p.size = box.diagonal();
  p.noise = 16 * analytic::epsilon * (norm(box.low) + norm(box.high));
  const auto spans = nurbs_spans(p.data.degree, p.data.knots, p.data.multiplicities, p.data.poles.size());
  if (spans.empty()) return std::nullopt;
  const int each = std::max(4, static_cast<int>(48 / spans.size()));
  for (const NurbsSpan& s : spans) {
    for (int i = 0; i < each; ++i) p.points.push_back(p.nurbs->point(s.low + (s.high - s.low) * i / each));
  }
  p.points.push_back(p.nurbs->point(spans.back().high));
  return p;
}

std::optional<RecognizedCurve> as_line(const Piece& p, double tolerance) {
  const Vec3 a = p.points.front(), b = p.points.back();
  const double length = distance(a, b);
  if (!(length > 2 * tolerance)) return std::nullopt;
  const Vec3 direction = (b - a) / length;
  double deviation = p.noise;
  for (const Vec3 q : p.data.poles) deviation = std::max(deviation, norm(cross(q - a, direction)) + p.noise);
  if (!(deviation <= tolerance)) return std::nullopt;
  for (std::size_t i = 1; i < p.points.size(); ++i) {
    if (!(dot(p.points[i] - p.points[i - 1], direction) > 0)) return std::nullopt;
  }
  return RecognizedCurve{Line{a, direction}, {0, length}, deviation, false};
}

/// Angles of the points in the frame's plane, the first in [0, 2 pi), unwound; nothing when they do not grow all along
/// or go round more than once.
std::optional<Range> turn(const Frame& f, double a, double b, const std::vector<Vec3>& points, double slack) {
  double first = 0, last = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 d = points[i] - f.origin;
    const double angle = std::atan2(dot(d, f.y) / b, dot(d, f.x) / a);
    if (i == 0) {
      first = last = angle < 0 ? angle + analytic::two_pi : angle;
      continue;
    }
    const double next = analytic::angle_near(angle, last);
    if (!(next > last)) return std::nullopt;
    last = next;
  }
  if (last - first > analytic::two_pi + slack) return std::nullopt;
  // All the way round within the tolerance is all the way round.
  if (std::abs(last - first - analytic::two_pi) <= slack) last = first + analytic::two_pi;
  return Range{first, last};
}

/// Largest distance of the poles, hence of the curve, from the plane of x and y.
double height_bound(const Piece& p, const Frame& f) {
  double h = 0;
  for (const Vec3 q : p.data.poles) h = std::max(h, std::abs(dot(q - f.origin, f.z)));
  return h;
}

/// y turned so that the piece runs with growing angle.
Frame along_piece(Frame f, const Piece& p) {
  const Vec3 a = p.points[0] - f.origin, b = p.points[1] - f.origin;
  if (dot(cross(a, b), f.z) < 0) {
    f.y = -f.y;
    f.z = -f.z;
  }
  return f;
}

std::optional<RecognizedCurve> as_circle(const Piece& p, double tolerance) {
  const auto fitted = fit::circle(p.points);
  if (!fitted || !(fitted->radius > tolerance) || fitted->radius > 1e5 * p.size) return std::nullopt;
  const Frame& plane = fitted->frame;
  const double r = fitted->radius;
  const auto flat = [&](Vec3 q) { return q - plane.origin - dot(q - plane.origin, plane.z) * plane.z; };
  for (const Vec3 q : p.points) {
    if (!(std::abs(norm(flat(q)) - r) <= tolerance)) return std::nullopt;
  }
  // | |q| - r | = | |q|^2 - r^2 | / (|q| + r) <= F / r.
  const double radial = bound_over(
      p.data, 2, [&](double t) { return p.nurbs->point(t); },
      [&](Vec3 q) {
        const double n = norm(flat(q));
        return (n - r) * (n + r);
      });
  const double deviation = std::hypot(radial / r, height_bound(p, plane)) + p.noise;
  if (!(deviation <= tolerance)) return std::nullopt;
  Frame f = along_piece(plane, p);
  f.x = normalized(flat(p.points.front()));
  f.y = cross(f.z, f.x);
  const auto range = turn(f, 1, 1, p.points, 4 * tolerance / r);
  if (!range) return std::nullopt;
  return RecognizedCurve{Circle{f, r}, {0, range->length()}, deviation, false};
}

std::optional<RecognizedCurve> as_ellipse(const Piece& p, double tolerance) {
  const auto fitted = fit::ellipse(p.points);
  if (!fitted || !(fitted->minor > tolerance) || fitted->major > 1e5 * p.size) return std::nullopt;
  const Frame f = along_piece(fitted->frame, p);
  const double a = fitted->major, b = fitted->minor;
  const auto level = [&](Vec3 q) {
    const Vec3 d = q - f.origin;
    return std::hypot(dot(d, f.x) / a, dot(d, f.y) / b);
  };
  for (const Vec3 q : p.points) {
    if (!(std::abs(level(q) - 1) * b <= tolerance)) return std::nullopt;
  }
  // With s = level: the radial neighbour q / s is on the ellipse, at |q| |1 - 1/s| <= a |s^2 - 1| / (s + 1) <= a F.
  const double radial = a * bound_over(
                                p.data, 2, [&](double t) { return p.nurbs->point(t); },
                                [&](Vec3 q) {
                                  const double s = level(q);
                                  return (s - 1) * (s + 1);
                                });
  const double deviation = std::hypot(radial, height_bound(p, f)) + p.noise;
  if (!(deviation <= tolerance)) return std::nullopt;
  const auto range = turn(f, a, b, p.points, 4 * tolerance / b);
  if (!range) return std::nullopt;
  return RecognizedCurve{Ellipse{f, a, b}, *range, deviation, false};
}

}  // namespace

std::optional<RecognizedCurve> recognize_piece(const Curve& curve, Range range, double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(range.low) || !std::isfinite(range.high) || !(range.low < range.high)) {
    return std::nullopt;
  }
  if (curve.get_if<FreeCurve>() == nullptr) return RecognizedCurve{curve, range, 0, true};
  const auto piece = prepared(curve, range);
  if (!piece || !(piece->size > 2 * tolerance)) return std::nullopt;
  for (const Vec3 q : piece->points) {
    if (!is_finite(q)) return std::nullopt;
  }
  std::optional<RecognizedCurve> found = as_line(*piece, tolerance);
  if (!found) found = as_circle(*piece, tolerance);
  if (!found) found = as_ellipse(*piece, tolerance);
  if (!found) return std::nullopt;
  if (const auto* line = found->curve.get_if<Line>()) {
    // A piece that runs at unit speed keeps its parameters.
    const Line moved{line->origin - range.low * line->direction, line->direction};
    bool same = true;
    for (int i = 0; i <= 32 && same; ++i) {
      const double t = range.at(i / 32.0);
      same = distance(analytic::point(moved, t), curve.point(t)) <= tolerance;
    }
    if (same) return RecognizedCurve{moved, range, found->deviation, true};
  }
  return found;
}

std::optional<Curve> recognize(const Curve& curve, Range range, double tolerance) {
  auto found = recognize_piece(curve, range, tolerance);
  if (!found) return std::nullopt;
  return std::move(found->curve);
}

}  // namespace aresta
