// SPDX-License-Identifier: Apache-2.0
#include "geometry/image.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace aresta {

namespace {

constexpr std::size_t most_spans = 1024;
constexpr double unit_speed = 1e-6;

class ImageFinder {
 public:
  ImageFinder(const Surface& surface, const Curve& curve, Range range, const std::function<Vec2(double)>& near,
              double tolerance)
      : surface_(surface), curve_(curve), range_(range), near_(near), tolerance_(tolerance) {}

  std::optional<CurveImage> run() {
    if (!(range_.low < range_.high) || !std::isfinite(range_.length())) return std::nullopt;
    if (auto straight = line()) return straight;
    std::vector<double> places = divided(range_);
    while (places.size() <= most_spans) {
      const auto image = hermite(places);
      if (!image) return std::nullopt;
      std::vector<double> finer{places.front()};
      double most = 0;
      for (std::size_t i = 1; i < places.size(); ++i) {
        const Range span{places[i - 1], places[i]};
        const auto off = deviation(*image, span);
        if (!off) finer.push_back(span.middle());
        finer.push_back(places[i]);
        most = std::max(most, off.value_or(0));
      }
      if (finer.size() == places.size()) return CurveImage{*image, most};
      places = std::move(finer);
    }
    return std::nullopt;
  }

 private:
  static std::vector<double> divided(Range range) {
    return {range.low, range.at(0.25), range.middle(), range.at(0.75), range.high};
  }

  Vec2 foot(double t) const {
    const Vec3 p = curve_.point(t);
    const Vec2 hint = near_(t);
    SurfaceProjection q = surface_.project(p, &hint);
    if (q.distance <= tolerance_) return q.uv;
    // A free-form search from a poor hint may have stopped early.
    q = surface_.project(p);
    const Vec2 period = surface_.period();
    if (period.x > 0) q.uv.x += period.x * std::round((hint.x - q.uv.x) / period.x);
    if (period.y > 0) q.uv.y += period.y * std::round((hint.y - q.uv.y) / period.y);
    return q.uv;
  }

  std::optional<CurveImage> line() const {
    // Ends may be where the surface has no unique parameters: the direction is taken well inside.
    const double s = range_.at(0.25), t = range_.at(0.75);
    const Vec2 a = foot(s), d = (foot(t) - a) / (t - s);
    if (!(std::abs(norm(d) - 1) <= unit_speed)) return std::nullopt;
    const Vec2 unit = d / norm(d);
    const Curve2 image(Line2{a - s * unit, unit});
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto off = deviation(image, {divided(range_)[i], divided(range_)[i + 1]});
      if (!off) return std::nullopt;
      most = std::max(most, *off);
    }
    return CurveImage{image, most};
  }

  struct Knot {
    Vec2 uv, d;
  };

  /// The exact image's point and derivative; nothing where the surface is singular and nothing is near.
  std::optional<Knot> knot(double t) const {
    const CurveJet c = curve_.jet(t);
    const Vec2 uv = foot(t);
    const SurfaceJet s = surface_.jet(uv);
    const double uu = dot(s.du, s.du), cross_term = dot(s.du, s.dv), vv = dot(s.dv, s.dv);
    const double determinant = uu * vv - cross_term * cross_term;
    const double larger = std::max(uu, vv);
    if (!(determinant > 1e-14 * larger * larger)) return std::nullopt;
    const double ru = dot(c.d1, s.du), rv = dot(c.d1, s.dv);
    return Knot{uv, {(vv * ru - cross_term * rv) / determinant, (uu * rv - cross_term * ru) / determinant}};
  }

  std::optional<Curve2> hermite(const std::vector<double>& places) const {
    const std::size_t spans = places.size() - 1;
    std::vector<std::optional<Knot>> knots;
    NurbsCurve2Data data;
    data.degree = 3;
    for (std::size_t i = 0; i <= spans; ++i) {
      const double t = places[i];
      data.knots.push_back(t);
      data.multiplicities.push_back(i == 0 || i == spans ? 4 : 2);
      knots.push_back(knot(t));
      if (!knots.back() && i != 0 && i != spans) return std::nullopt;
    }
    // At a pole the image ends where it is said to; it comes in straight.
    for (const std::size_t end : {std::size_t{0}, spans}) {
      if (knots[end]) continue;
      const std::size_t next = end == 0 ? 1 : end - 1;
      if (!knots[next]) return std::nullopt;
      const double t = data.knots[end];
      knots[end] = Knot{near_(t), knots[next]->d};
    }
    for (std::size_t i = 0; i < knots.size(); ++i) {
      const Knot& k = *knots[i];
      if (i > 0) data.poles.push_back(k.uv - (data.knots[i] - data.knots[i - 1]) / 3 * k.d);
      if (i == 0 || i + 1 == knots.size()) {
        data.poles.insert(i == 0 ? data.poles.begin() : data.poles.end(), k.uv);
      }
      if (i + 1 < knots.size()) data.poles.push_back(k.uv + (data.knots[i + 1] - data.knots[i]) / 3 * k.d);
    }
    auto made = FreeCurve2::from_nurbs(data);
    if (!made.ok()) return std::nullopt;
    return Curve2(*made);
  }

  std::optional<double> deviation(const Curve2& image, Range span) const {
    double most = 0;
    for (const double t : divided(span)) {
      const double off = distance(surface_.point(image.point(t)), curve_.point(t));
      if (!(off <= tolerance_)) return std::nullopt;
      most = std::max(most, off);
    }
    return most;
  }

  const Surface& surface_;
  const Curve& curve_;
  Range range_;
  const std::function<Vec2(double)>& near_;
  double tolerance_;
};

}  // namespace

std::optional<CurveImage> image_on(const Surface& surface, const Curve& curve, Range range,
                                   const std::function<Vec2(double)>& near, double tolerance) {
  return ImageFinder(surface, curve, range, near, tolerance).run();
}

}  // namespace aresta
