// SPDX-License-Identifier: Apache-2.0
// FaceTrim: is a point of the parameter plane in a face?
//
// The indicator of the face changes by one wherever a path crosses its boundary, and the boundary's direction says
// which way. So the signed crossings along a path that ends in one fixed place give the indicator up to a constant, on
// any surface: on a plane, cylinder, sphere the path goes up along u = const without end (or to the pole); where only v
// is periodic it goes along v = const; on a torus up to v = const and then along it to a fixed u. The constant is found
// once, beside an edge, where the loop's sense tells the inside. Faces with poles inside, with loops that wind around
// the surface, without seams, need nothing more.
//
// Boundary images are chords with a bound of their deviation. A point nearer to a chord than that bound makes the piece
// of the image be refined, down to the tolerance of the question; else the chord is crossed as the image would be.
#include <cmath>
#include <limits>

#include "model/image_detail.h"
#include "model/query.h"

namespace aresta {

using model_detail::FaceImage;
using model_detail::ImagePiece;

namespace {

constexpr std::uint32_t no_piece = 0xffffffffu;

struct Segment {
  Vec2 a, b;
  Vec2 error{};  ///< bound of the image's deviation from the chord, in u and in v
  double ta = 0, tb = 0;
  std::uint32_t piece = no_piece;
};

/// Lengths in space of small steps in the parameter plane.
struct Metric {
  double e = 1, f = 0, g = 1;
  double u = 1, v = 1;                ///< lengths of unit steps
  double across_u = 1, across_v = 1;  ///< distances between lines u = 0 and u = 1, v = 0 and v = 1
  explicit Metric(const SurfaceJet& j)
      : e(dot(j.du, j.du)), f(dot(j.du, j.dv)), g(dot(j.dv, j.dv)), u(std::sqrt(e)), v(std::sqrt(g)) {
    across_u = g > 0 ? std::sqrt(std::max(0.0, e - f * f / g)) : u;
    across_v = e > 0 ? std::sqrt(std::max(0.0, g - f * f / e)) : v;
  }
  Metric() = default;
  double dot2(Vec2 a, Vec2 b) const { return e * a.x * b.x + f * (a.x * b.y + a.y * b.x) + g * a.y * b.y; }
  double length(Vec2 d) const { return std::sqrt(std::max(0.0, dot2(d, d))); }
  double distance(Vec2 p, Vec2 a, Vec2 b) const {
    const Vec2 d = b - a, r = p - a;
    const double dd = dot2(d, d);
    const double t = dd > 0 ? std::clamp(dot2(r, d) / dd, 0.0, 1.0) : 0;
    return length(r - t * d);
  }
};

bool is_line_image(const Model& model, const ImagePiece& piece) {
  if (!piece.samples.empty()) return false;
  const Curve2* image = model.pcurve(piece.coedge);
  if (image != nullptr) return image->get_if<Line2>() != nullptr;
  return model.is_straight(model.topology().edge(piece.coedge));
}

}  // namespace

struct FaceTrim::Data {
  FaceImage image;
  const Surface* surface = nullptr;
  bool plane = false;
  double size = 0;
  double side = 1;  ///< -1 when loops run clockwise in the parameter plane
  double tolerance = 0;
  Vec2 scale{1, 1};  ///< lengths of unit steps in the middle of the face
  std::vector<Segment> segments;
  bool torus = false;
  Vec2 reference{};   ///< where paths end
  double base = 0;    ///< indicator = base + side * crossings
  bool whole = true;  ///< nothing but seams and internal edges bounds the face

  Data(const Model& model, FaceId face) : image(model_detail::image_of(model, face)), surface(&image.surface()) {
    plane = surface->is_plane();
    side = model.is_reversed(face) ? -1 : 1;
    torus = image.period.x > 0 && image.period.y > 0;
    tolerance = std::max(model.tolerance(face), model.tolerance());
    if (!image.empty()) reference = {image.box.u.middle(), image.box.v.middle()};
    const Metric metric = metric_at(reference);
    scale = {metric.u, metric.v};
    size = metric.length({image.box.u.length(), image.box.v.length()});
    segments.reserve(image.pieces.size());
    for (std::uint32_t i = 0; i < image.pieces.size(); ++i) {
      const ImagePiece& piece = image.pieces[i];
      if (!piece.internal) add_piece(piece, i);
      if (piece.gap_end != piece.end) segments.push_back({.a = piece.end, .b = piece.gap_end});
    }
    find_base();
  }

  Metric metric_at(Vec2 uv) const { return plane ? Metric() : Metric(surface->jet(uv)); }

  void add_piece(const ImagePiece& piece, std::uint32_t index) {
    const Model& model = *image.model;
    if (is_line_image(model, piece)) {
      segments.push_back({piece.start, piece.end, {}, piece.from, piece.to, index});
      return;
    }
    constexpr int parts = 8;
    Vec2 a = piece.start;
    for (int i = 0; i < parts; ++i) {
      const double ta = piece.from + (piece.to - piece.from) * i / parts,
                   tb = i + 1 == parts ? piece.to : piece.from + (piece.to - piece.from) * (i + 1) / parts;
      const Vec2 b = i + 1 == parts ? piece.end : image.uv(piece, tb);
      add_arc(piece, {a, b, {}, ta, tb, index}, 0);
      a = b;
    }
  }

  /// Twice the largest deviation of the image from the chord at three places, or `least` where that is more. `middle`
  /// gets the image's point half way.
  Vec2 deviation(const ImagePiece& piece, const Segment& s, Vec2 least, Vec2& middle) const {
    Vec2 error{};
    for (const double w : {0.25, 0.5, 0.75}) {
      const Vec2 q = image.uv(piece, s.ta + w * (s.tb - s.ta));
      if (w == 0.5) middle = q;
      const Vec2 d = q - (s.a + w * (s.b - s.a));
      error = {std::max(error.x, 2 * std::abs(d.x)), std::max(error.y, 2 * std::abs(d.y))};
    }
    return {std::max(error.x, least.x), std::max(error.y, least.y)};
  }

  void add_arc(const ImagePiece& piece, Segment s, int depth) {
    const double h = s.tb - s.ta;
    Vec2 middle;
    s.error = deviation(piece, s, {}, middle);
    const double relative = (scale.x * s.error.x + scale.y * s.error.y) / size;
    if (relative > 4e-3 && depth < 10) {
      add_arc(piece, {s.a, middle, {}, s.ta, s.ta + 0.5 * h, s.piece}, depth + 1);
      add_arc(piece, {middle, s.b, {}, s.ta + 0.5 * h, s.tb, s.piece}, depth + 1);
      return;
    }
    segments.push_back(s);
  }

  /// Crossings of one chord with the path from p to where paths end.
  double crossings(Vec2 a, Vec2 b, Vec2 p) const {
    double sum = 0;
    if (image.period.x == 0 && image.period.y > 0) {
      if (a.y == b.y) return 0;
      const double low = std::min(a.y, b.y), high = std::max(a.y, b.y), sign = b.y > a.y ? 1 : -1;
      const double period = image.period.y;
      for (double y = p.y + period * std::ceil((low - p.y) / period); y < high; y += period) {
        if (y >= low && a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) sum += sign;
      }
      return sum;
    }
    if (a.x != b.x) {
      const double low = std::min(a.x, b.x), high = std::max(a.x, b.x), sign = b.x < a.x ? 1 : -1;
      const double period = image.period.x;
      double x = period > 0 ? p.x + period * std::ceil((low - p.x) / period) : p.x;
      for (; x < high; x += period) {
        if (x >= low) {
          const double y = a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
          if (!torus) {
            if (y > p.y) sum += sign;
          } else {
            sum += sign * (std::floor((reference.y - y) / image.period.y) - std::floor((p.y - y) / image.period.y));
          }
        }
        if (period == 0) break;
      }
    }
    if (torus && a.y != b.y) {
      const double low = std::min(a.y, b.y), high = std::max(a.y, b.y), sign = b.y > a.y ? 1 : -1;
      const double period = image.period.y;
      for (double y = reference.y + period * std::ceil((low - reference.y) / period); y < high; y += period) {
        const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
        sum += sign * (std::floor((reference.x - x) / image.period.x) - std::floor((p.x - x) / image.period.x));
      }
    }
    return sum;
  }

  /// The translate of p nearest to the middle of a chord.
  Vec2 near(Vec2 p, Vec2 a, Vec2 b) const {
    const Vec2 middle = 0.5 * (a + b);
    if (image.period.x > 0) p.x += image.period.x * std::round((middle.x - p.x) / image.period.x);
    if (image.period.y > 0) p.y += image.period.y * std::round((middle.y - p.y) / image.period.y);
    return p;
  }

  double distance(const Metric& metric, Vec2 p, Vec2 a, Vec2 b) const {
    const Vec2 q = near(p, a, b);
    double d = metric.distance(q, a, b);
    for (int axis = 0; axis < 2; ++axis) {
      const double period = axis == 0 ? image.period.x : image.period.y;
      const double extent = axis == 0 ? std::abs(b.x - a.x) : std::abs(b.y - a.y);
      if (period == 0 || extent < 0.5 * period) continue;
      const Vec2 step = axis == 0 ? Vec2{period, 0} : Vec2{0, period};
      d = std::min({d, metric.distance(q + step, a, b), metric.distance(q - step, a, b)});
    }
    return d;
  }

  /// False when p is surely farther from the chord than `reach`.
  bool may_be_near(const Metric& metric, Vec2 p, const Segment& s, double reach) const {
    const auto gap = [](double x, double a, double b, double period) {
      const double centre = 0.5 * (a + b), half = 0.5 * std::abs(b - a);
      double d = x - centre;
      if (period > 0) d -= period * std::round(d / period);
      return std::abs(d) - half;
    };
    return gap(p.x, s.a.x, s.b.x, image.period.x) * metric.across_u <= reach &&
           gap(p.y, s.a.y, s.b.y, image.period.y) * metric.across_v <= reach;
  }

  /// Adds the crossings of the image behind `s`; false when p lies on it within tolerance.
  bool count(const Segment& s, const Metric& metric, Vec2 p, double near_by, double& sum, int depth) const {
    const double error = metric.u * s.error.x + metric.v * s.error.y;
    const double floor = std::max(0.25 * near_by, 1e-13 * size);
    // A gap is no boundary: at a pole it is one point of space, elsewhere shorter than the tolerance between edges.
    if (s.piece != no_piece && may_be_near(metric, p, s, near_by + error) &&
        distance(metric, p, s.a, s.b) <= near_by + error) {
      if (error <= floor || depth > 40) return false;
      // Images that are splines may swing more in a part than a quarter of what they do in the whole.
      const ImagePiece& piece = image.pieces[s.piece];
      const double t = 0.5 * (s.ta + s.tb);
      const Vec2 m = image.uv(piece, t), quarter = 0.25 * s.error;
      Segment first{s.a, m, {}, s.ta, t, s.piece}, second{m, s.b, {}, t, s.tb, s.piece};
      Vec2 unused;
      first.error = deviation(piece, first, quarter, unused);
      second.error = deviation(piece, second, quarter, unused);
      return count(first, metric, p, near_by, sum, depth + 1) && count(second, metric, p, near_by, sum, depth + 1);
    }
    sum += crossings(s.a, s.b, p);
    return true;
  }

  double crossings(Vec2 p) const {
    double sum = 0;
    for (const Segment& s : segments) sum += crossings(s.a, s.b, p);
    return sum;
  }

  void find_base() {
    // The longest chord of an edge that has the face on one side only.
    const Segment* best = nullptr;
    double longest = 0;
    Metric metric;
    for (const Segment& s : segments) {
      if (s.piece == no_piece || image.pieces[s.piece].paired) continue;
      const Metric here = metric_at(0.5 * (s.a + s.b));
      const double length = here.length(s.b - s.a);
      if (length > longest) {
        longest = length;
        best = &s;
        metric = here;
      }
    }
    if (best == nullptr) return;
    whole = false;
    const Vec2 middle = 0.5 * (best->a + best->b);
    double room = longest;
    for (const Segment& s : segments) {
      if (&s != best) room = std::min(room, distance(metric, middle, s.a, s.b));
    }
    // A step to the left of the chord, at right angles to it in the parameter plane, scaled to the room in space.
    const Vec2 d = best->b - best->a, left{-d.y, d.x};
    const double step = std::max(std::min(1e-4 * longest, 0.1 * room), 1e-12 * longest);
    const double unit = metric.length(left);
    const Vec2 p = unit > 0 ? middle + (side * step / unit) * left : middle;
    base = 1 - side * crossings(p);
  }

  Position locate(Vec2 uv, double near_by) const {
    const Metric metric = metric_at(uv);
    double sum = 0;
    for (const Segment& s : segments) {
      if (!count(s, metric, uv, near_by, sum, 0)) return Position::boundary;
    }
    if (whole) return Position::inside;
    return base + side * sum > 0.5 ? Position::inside : Position::outside;
  }

  double distance_to_boundary(Vec2 uv) const {
    const Metric metric = metric_at(uv);
    double d = std::numeric_limits<double>::infinity();
    for (const Segment& s : segments) {
      if (s.piece != no_piece) d = std::min(d, distance(metric, uv, s.a, s.b));
    }
    return d;
  }

  /// Where a line u = const (axis 0) or v = const (axis 1) meets the chords, as the other parameter, sorted; reduced to
  /// one period from `from` where that parameter is periodic.
  void scan(int axis, double at, double from, std::vector<double>& out) const {
    out.clear();
    const double period = axis == 0 ? image.period.x : image.period.y;
    const double other_period = axis == 0 ? image.period.y : image.period.x;
    for (const Segment& s : segments) {
      const double a = axis == 0 ? s.a.x : s.a.y, b = axis == 0 ? s.b.x : s.b.y;
      const double c = axis == 0 ? s.a.y : s.a.x, d = axis == 0 ? s.b.y : s.b.x;
      if (a == b) continue;
      const double low = std::min(a, b), high = std::max(a, b);
      for (double x = period > 0 ? at + period * std::ceil((low - at) / period) : at; x < high; x += period) {
        if (x >= low) {
          double y = c + (x - a) / (b - a) * (d - c);
          if (other_period > 0) y -= other_period * std::floor((y - from) / other_period);
          out.push_back(y);
        }
        if (period == 0) break;
      }
    }
    std::sort(out.begin(), out.end());
  }

  struct Best {
    Vec2 uv{};
    double distance = -1;
  };

  void consider(Vec2 uv, Best& best) const {
    const double d = distance_to_boundary(uv);
    if (d > best.distance && locate(uv, 0) == Position::inside) best = {uv, d};
  }

  void scan_lines(std::span<const double> fractions, Best& best) const {
    const Range2 domain = surface->domain();
    std::vector<double> hits;
    for (const double fraction : fractions) {
      for (int axis = 0; axis < 2; ++axis) {
        const Range across = axis == 0 ? image.box.u : image.box.v, along = axis == 0 ? image.box.v : image.box.u;
        const Range limits = axis == 0 ? domain.v : domain.u;
        const double other_period = axis == 0 ? image.period.y : image.period.x;
        const double at = across.at(fraction);
        scan(axis, at, along.low, hits);
        if (other_period > 0) {
          hits.push_back(hits.empty() ? along.low + other_period : hits.front() + other_period);
          if (hits.size() == 1) hits.insert(hits.begin(), along.low);
        } else {
          if (std::isfinite(limits.low) && (hits.empty() || limits.low < hits.front()))
            hits.insert(hits.begin(), limits.low);
          if (std::isfinite(limits.high) && (hits.empty() || limits.high > hits.back())) hits.push_back(limits.high);
          if (const auto* cone = surface->get_if<Cone>(); cone != nullptr && axis == 0) {
            hits.push_back(-cone->radius / std::sin(cone->half_angle));
            std::sort(hits.begin(), hits.end());
          }
        }
        for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
          const double middle = 0.5 * (hits[i] + hits[i + 1]);
          consider(axis == 0 ? Vec2{at, middle} : Vec2{middle, at}, best);
        }
      }
    }
  }

  Result<Vec2> interior_point() const {
    if (image.empty() || segments.empty()) {
      const Range2 d = surface->domain();
      return Vec2{std::isfinite(d.u.length()) ? d.u.at(0.41) : 0, std::isfinite(d.v.length()) ? d.v.at(0.53) : 0};
    }
    // Fractions that no drawing uses, so that lines keep off corners and symmetry axes.
    static constexpr double few[] = {0.4877, 0.2971, 0.7093};
    static constexpr double more[] = {0.0173, 0.0611, 0.1093, 0.1571, 0.2039, 0.2503, 0.3461, 0.3943, 0.4421,
                                      0.5381, 0.5849, 0.6329, 0.6817, 0.7561, 0.8039, 0.8521, 0.9011, 0.9823};
    Best best;
    scan_lines(few, best);
    if (!(best.distance > 0.05 * size)) scan_lines(more, best);
    if (best.distance > tolerance) return best.uv;
    Error error{errors::measure_failed,
                best.distance < 0 ? "no point was found inside a face"
                                  : "a face is thinner than its tolerance: no point is inside it",
                {image.face}};
    const Vec3 p = surface->point(reference);
    error.place = {p.x, p.y, p.z};
    return error;
  }
};

FaceTrim::FaceTrim(const Model& model, FaceId face) : data_(std::make_shared<const Data>(model, face)) {}

Position FaceTrim::locate(Vec2 uv, double tolerance) const {
  const FaceImage& image = data_->image;
  if (image.turned) uv = image.turned->project(image.model->surface(image.face).point(uv)).uv;
  return data_->locate(uv, tolerance);
}

Result<Vec2> FaceTrim::interior_point() const {
  const FaceImage& image = data_->image;
  ARESTA_TRY(const Vec2 uv, data_->interior_point());
  if (!image.turned) return uv;
  return image.model->surface(image.face).project(image.turned->point(uv)).uv;
}

Range2 FaceTrim::box() const {
  if (data_->image.turned) return data_->image.model->surface(data_->image.face).domain();
  return data_->image.empty() ? data_->surface->domain() : data_->image.box;
}

}  // namespace aresta
