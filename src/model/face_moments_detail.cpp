// SPDX-License-Identifier: Apache-2.0
#include "model/face_moments_detail.h"

#include <cmath>
#include <map>
#include <numbers>

#include "math/quadrature.h"
#include "model/image_detail.h"
#include "model/patch_detail.h"

namespace aresta::model_detail {

namespace {

constexpr double epsilon = 2.220446049250313e-16;

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

Error not_finite(const Model& model, FaceId face) {
  Error error{errors::measure_failed, "the area of a face is not finite", {face}};
  const Box3 box = model.bounds(face);
  if (!box.empty() && is_finite(box.centre())) error.place = as_array(box.centre());
  return error;
}

// --- Plane faces -----------------------------------------------------------------------------------------------------

struct FanSum {
  std::array<double, 10> m{};
  double absolute = 0;

  /// A triangle (weight: signed area) or tetrahedron from the reference (weight: signed volume) with these corners.
  void add(double weight, double denominator, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 s = a + b + c;
    const double first = weight / (denominator - 1), second = weight / (denominator * (denominator - 1));
    m[0] += weight;
    m[1] += first * s.x;
    m[2] += first * s.y;
    m[3] += first * s.z;
    m[4] += second * (a.x * a.x + b.x * b.x + c.x * c.x + s.x * s.x);
    m[5] += second * (a.y * a.y + b.y * b.y + c.y * c.y + s.y * s.y);
    m[6] += second * (a.z * a.z + b.z * b.z + c.z * c.z + s.z * s.z);
    m[7] += second * (a.x * a.y + b.x * b.y + c.x * c.y + s.x * s.y);
    m[8] += second * (a.y * a.z + b.y * b.z + c.y * c.z + s.y * s.z);
    m[9] += second * (a.z * a.x + b.z * b.x + c.z * c.x + s.z * s.x);
    absolute += std::abs(weight);
  }
};

// Triangle: integral of q q^T is area / 12 (sum v v^T + s s^T), of q area / 3 s. Tetrahedron with a corner in the
// reference: volume / 20 and volume / 4. So denominators 4 and 5 with n (n - 1).
constexpr double triangle = 4, tetrahedron = 5;

Result<Moments> plane_moments(const Model& model, FaceId face, const Plane& plane, const Vec3* reference,
                              const MeasureOptions& options) {
  const Complex& topology = model.topology();
  const Vec3 natural = cross(plane.frame.x, plane.frame.y);
  const Vec3 normal = model.is_reversed(face) ? -natural : natural;
  FanSum sum;
  Vec3 origin = reference != nullptr ? *reference : Vec3{};
  bool have_origin = reference != nullptr;
  double error = 0, largest = 0, scale = 0;

  for (const LoopId l : topology.loops(face)) {
    if (topology.is_vertex_loop(l)) continue;
    const CoedgeId first = topology.first_coedge(l);
    const Vec3 root_point = model.point(topology.start(first));
    if (!have_origin) {
      origin = root_point;
      have_origin = true;
    }
    const Vec3 root = root_point - origin;
    largest = std::max(largest, norm(root));
    for (const CoedgeId c : topology.coedges(l)) {
      const EdgeId e = topology.edge(c);
      const Vec3 a = model.point(topology.start(c)) - origin, b = model.point(topology.end(c)) - origin;
      scale = std::max({scale, distance(a, root), distance(b, root)});
      if (model.is_straight(e)) {
        const Vec3 twice = cross(a - root, b - root);
        if (reference != nullptr) {
          sum.add(dot(root, twice) / 6, tetrahedron, root, a, b);
        } else {
          sum.add(0.5 * dot(normal, twice), triangle, root, a, b);
        }
        continue;
      }
      const Range range = model.range(e);
      const bool reversed = topology.reversed(c);
      const double edge_size = model.bounds(e).diagonal(), unit = edge_size + norm(root);
      scale = std::max(scale, edge_size);
      const auto density = [&](double t) {
        const CurveJet jet = model.edge_jet(e, t);
        const Vec3 p = (jet.point - origin) / unit, r = root / unit, d = jet.d1 / unit;
        FanSum fan;
        const Vec3 twice = cross(p - r, d);
        if (reference != nullptr) {
          fan.add(dot(r, twice) / 6, tetrahedron, r, p, p);
        } else {
          fan.add(0.5 * dot(normal, twice), triangle, r, p, p);
        }
        return fan.m;
      };
      const double small = edge_size / unit;
      const auto part =
          integrate(density, reversed ? range.high : range.low, reversed ? range.low : range.high,
                    QuadratureOptions{
                        .absolute = 1e-14 * small * small, .relative = 0.1 * options.relative, .max_intervals = 400});
      double power = reference != nullptr ? unit * unit * unit : unit * unit;
      error += part.error * power;
      sum.absolute += std::abs(part.value[0]) * power;
      for (std::size_t i = 0; i < 10; ++i) {
        if (i == 1 || i == 4) power *= unit;
        sum.m[i] += part.value[i] * power;
      }
    }
  }
  Moments m;
  m.reference = origin;
  m.measure = sum.m[0];
  m.first = {sum.m[1], sum.m[2], sum.m[3]};
  for (std::size_t i = 0; i < 6; ++i) m.second[i] = sum.m[4 + i];
  // Rounding of the sums, and of coordinates that are large against the face.
  const double coordinate = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)}) + largest + scale;
  m.error = error + 4 * epsilon * sum.absolute +
            epsilon * coordinate * scale * (reference != nullptr ? (scale + largest) : 1);
  if (!std::isfinite(m.measure) || !std::isfinite(m.error)) return not_finite(model, face);
  return m;
}

// --- Curved faces ----------------------------------------------------------------------------------------------------

struct GreenSum {
  PatchMoments m{};
  double error = 0;
  double content = 0;  // of the largest part, for rounding

  void add(const Integral<PatchMoments>& part) {
    for (std::size_t i = 0; i < m.size(); ++i) {
      m[i] += part.value[i];
      content = std::max(content, std::abs(part.value[i]));
    }
    error += part.error;
  }
  void add(const GreenSum& part, double factor) {
    for (std::size_t i = 0; i < m.size(); ++i) m[i] += factor * part.m[i];
    content = std::max(content, part.content);
    error += std::abs(factor) * part.error;
  }
};

PatchMoments scaled(PatchMoments m, double k) {
  for (double& x : m) x *= k;
  return m;
}

class Green {
 public:
  Green(const Model& model, FaceId face, const Vec3* reference, const MeasureOptions& options)
      : model_(model), face_(face), image_(image_of(model, face)), surface_(image_.surface()) {
    const Box3 box = model.bounds(face);
    diagonal_ = box.diagonal();
    options_.flux = reference != nullptr;
    options_.reference = reference != nullptr ? *reference : box.centre();
    options_.size = diagonal_;
    if (reference != nullptr) options_.size = std::max(diagonal_, distance(*reference, box.centre()));
    options_.relative = 0.1 * options.relative;
    const bool free = surface_.get_if<FreeSurface>() != nullptr;
    const double part = diagonal_ / options_.size;
    quadrature_ = {.absolute = (free ? 1e-13 : 1e-14) * part * part,
                   .relative = 0.1 * options.relative,
                   .max_intervals = free ? 60 : 400};
    swapped_ = image_.period.y > 0 && image_.period.x == 0;
  }

  Result<Moments> run() {
    if (!std::isfinite(diagonal_)) return not_finite(model_, face_);
    if (diagonal_ == 0) return Moments{.reference = options_.reference};
    const Patch patch(surface_, image_.box, swapped_, options_);
    patch_ = &patch;
    ARESTA_CHECK(measure_gaps());
    along_u(image_.pieces);
    ARESTA_CHECK(close_windings());
    GreenSum sum = sum_;
    // Green's theorem: minus G du, or plus H dv.
    double orientation = swapped_ ? 1 : -1;
    for (double& x : sum.m) x *= orientation;
    const double side = model_.is_reversed(face_) ? -1 : 1;
    if (patch.closed) add_whole_surfaces(sum, side);
    // Loops of a reversed face run clockwise in the parameter plane; its normal is turned as well, which the flux keeps
    // as it is and the area does not.
    const double sign = options_.flux ? 1 : side;
    return finish(sum, sign);
  }

 private:
  /// Component of uv that the outer integral runs along.
  double across(Vec2 uv) const { return swapped_ ? uv.y : uv.x; }
  double inner(Vec2 uv) const { return swapped_ ? uv.x : uv.y; }

  /// What lies between images that should meet is an error; much of it means that a loop is not closed in the surface.
  Status measure_gaps() {
    for (const ImagePiece& piece : image_.pieces) {
      const double gap = image_.gap_length(piece);
      const Complex& topology = model_.topology();
      const EdgeId e = topology.edge(piece.coedge);
      const VertexId v = topology.end(piece.coedge);
      const double allowed = std::max({model_.tolerance(), 4 * model_.tolerance(e), 4 * model_.tolerance(v)});
      if (gap <= allowed) continue;
      if (gap > std::max(100 * allowed, 1e-3 * diagonal_)) {
        return Error{errors::measure_failed,
                     "a loop of a face is not closed in its surface's parameters",
                     {face_},
                     as_array(model_.point(v)),
                     "image curves for both uses of a seam"};
      }
      gaps_ += gap;
    }
    return {};
  }

  void along_u(const std::vector<ImagePiece>& pieces) {
    for (const ImagePiece& piece : pieces) {
      if (!piece.internal) along_edge(piece);
      if (piece.gap_end != piece.end) along_segment(piece.end, piece.gap_end);
    }
  }

  void along_edge(const ImagePiece& piece) {
    const EdgeId e = model_.topology().edge(piece.coedge);
    const auto density = [&](double t) {
      const CurveJet jet = model_.edge_jet(e, t);
      const Vec2 uv = invert(surface_, jet.point, image_.uv(piece, t));
      const SurfaceJet foot = surface_.jet(uv);
      const double rate = across(uv_tangent(foot, jet.d1, jet.point - foot.point));
      if (rate == 0) return PatchMoments{};
      return scaled(patch_->strip(across(uv), inner(uv)), rate);
    };
    sum_.add(integrate(density, piece.from, piece.to, quadrature_));
  }

  void along_segment(Vec2 a, Vec2 b) {
    const double way = across(b) - across(a), period = period_across();
    if (way == 0) return;
    if (inner(a) == inner(b) && std::abs(std::abs(way) - period) <= 1e-12 * period) {  // a pole's, once around
      sum_.add(turn(inner(a)), way < 0 ? -1 : 1);
      return;
    }
    std::vector<double> ends{0};
    for (const double u : patch_->breaks(across(a), across(b))) ends.push_back((u - across(a)) / way);
    ends.push_back(1);
    const auto density = [&](double t) {
      const Vec2 uv = a + t * (b - a);
      return scaled(patch_->strip(across(uv), inner(uv)), way);
    };
    for (std::size_t i = 1; i < ends.size(); ++i) sum_.add(integrate(density, ends[i - 1], ends[i], quadrature_));
  }

  double period_across() const { return swapped_ ? image_.period.y : image_.period.x; }

  /// The line of constant inner parameter, once around.
  const GreenSum& turn(double v) {
    const auto known = turns_.find(v);
    if (known != turns_.end()) return known->second;
    const double period = period_across();
    std::vector<double> ends{0};
    for (const double u : patch_->breaks(0, period)) ends.push_back(u);
    ends.push_back(period);
    GreenSum& sum = turns_[v];
    for (std::size_t i = 1; i < ends.size(); ++i) {
      sum.add(integrate([&](double u) { return patch_->strip(u, v); }, ends[i - 1], ends[i], quadrature_));
    }
    return sum;
  }

  Status close_windings() {
    double w = 0, t = 0;
    bool some_along = false;
    for (const LoopImage& loop : image_.loops) {
      w += across(loop.winding);
      t += inner(loop.winding);
      some_along = some_along || inner(loop.winding) != 0;
    }
    if (w != 0) {
      const std::optional<double> end = patch_->high_end ? patch_->high_end : patch_->low_end;
      if (!end || is_torus()) return open_boundary();
      sum_.add(turn(*end), -w);
    }
    if (t != 0) return open_boundary();
    if (some_along) bridge();
    return {};
  }

  bool is_torus() const { return image_.period.x > 0 && image_.period.y > 0; }

  /// Joins the loops that wind in v, one after the other, by straight segments in the covering plane.
  void bridge() {
    std::vector<const LoopImage*> winding;
    for (const LoopImage& loop : image_.loops) {
      if (inner(loop.winding) != 0) winding.push_back(&loop);
    }
    for (std::size_t i = 0; i < winding.size(); ++i) {
      const LoopImage& next = *winding[(i + 1) % winding.size()];
      const ImagePiece& last = image_.pieces[winding[i]->first + winding[i]->count - 1];
      along_segment(last.gap_end, image_.pieces[next.first].start);
    }
  }

  Error open_boundary() const {
    Error error{errors::measure_failed,
                "the loops of a face go around its surface and leave it open: the face has no bounded area",
                {face_}};
    error.place = as_array(model_.bounds(face_).centre());
    return error;
  }

  void add_whole_surfaces(GreenSum& sum, double side) {
    GreenSum whole;
    whole.add(turn(*patch_->high_end), 1);
    whole.add(turn(*patch_->low_end), -1);
    const double total = whole.m[0];  // positive: the area between the ends
    double area = side * sum.m[0];
    double turns = 0;
    const double noise = std::max(1e-13 * total, 4 * sum.error);
    if (!image_.has_boundary) {
      turns = 1 - std::round(area / total);
    } else if (area < -noise || area > total + noise) {
      turns = -std::floor(area / total);
    }
    if (turns == 0) return;
    for (std::size_t i = 0; i < sum.m.size(); ++i) sum.m[i] += side * turns * whole.m[i];
    sum.error += std::abs(turns) * whole.error;
  }

  Result<Moments> finish(const GreenSum& sum, double sign) const {
    const double size = options_.size;
    double power = options_.flux ? size * size * size : size * size;
    Moments m;
    m.reference = options_.reference;
    m.measure = sign * power * sum.m[1];
    const double way = 2 * (swapped_ ? image_.box.v : image_.box.u).length();  // of the loops, there and back
    m.error = power * (sum.error + 16 * epsilon * sum.content + patch_->worst_error() * std::max(0.0, way));
    m.error += gaps_ * diagonal_ * (options_.flux ? size : 1);
    // Coordinates that are large against the face are rounded.
    const Vec3 o = options_.reference;
    const double coordinate = std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) + size;
    m.error += 4 * epsilon * coordinate * (options_.flux ? std::abs(sum.m[0]) * size * size : diagonal_);
    power *= sign * size;
    m.first = power * Vec3{sum.m[2], sum.m[3], sum.m[4]};
    power *= size;
    for (std::size_t i = 0; i < 6; ++i) m.second[i] = power * sum.m[5 + i];
    if (!std::isfinite(m.measure) || !std::isfinite(m.error)) return not_finite(model_, face_);
    return m;
  }

  const Model& model_;
  FaceId face_;
  FaceImage image_;
  const Surface& surface_;
  PatchOptions options_;
  QuadratureOptions quadrature_;
  double diagonal_ = 0, gaps_ = 0;
  bool swapped_ = false;
  const Patch* patch_ = nullptr;
  GreenSum sum_;
  std::map<double, GreenSum> turns_;  // by the inner parameter; often asked for twice
};

}  // namespace

Result<Moments> face_moments(const Model& model, FaceId face, const Vec3* reference, const MeasureOptions& options) {
  if (const auto* plane = model.surface(face).get_if<Plane>()) {
    return plane_moments(model, face, *plane, reference, options);
  }
  return Green(model, face, reference, options).run();
}

}  // namespace aresta::model_detail
