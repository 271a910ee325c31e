// SPDX-License-Identifier: Apache-2.0
#include "model/radial.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace aresta {

namespace {

constexpr double tangent_angle = 1e-4;  // rad: below it two directions count as tangent and curvature is asked
constexpr double small_step = 1e-3;     // of the local size
constexpr double finite_step = 5e-2;    // of the local size
constexpr double height_noise = 1e-11;  // of the local size

struct Spoke {
  std::uint32_t coedge = 0;
  double angle = 0;
  Vec3 into;        // unit, into the face, at right angles to the edge
  Vec3 ccw;         // unit, counterclockwise about the edge
  double bend = 0;  // curvature of the face along `into`, towards `ccw`
  FaceId face;
  Vec2 uv;
};

/// Curvature of the surface in tangent direction `into`, measured along the unit vector `up`.
double normal_curvature(const SurfaceJet& jet, Vec3 into, Vec3 up) {
  const double e = dot(jet.du, jet.du), f = dot(jet.du, jet.dv), g = dot(jet.dv, jet.dv);
  const double determinant = e * g - f * f;
  if (!(determinant > 0)) return 0;
  const double pu = dot(jet.du, into), pv = dot(jet.dv, into);
  const double a = (g * pu - f * pv) / determinant, b = (e * pv - f * pu) / determinant;
  return dot(a * a * jet.duu + 2 * a * b * jet.duv + b * b * jet.dvv, up);
}

class EdgeOrder {
 public:
  EdgeOrder(const Model& model, EdgeId edge, std::vector<std::uint32_t> coedges)
      : model_(model), edge_(edge), coedges_(std::move(coedges)) {}

  /// Sorted coedges, or nothing when two cannot be told apart at this parameter.
  bool sort_at(double t, std::vector<std::uint32_t>& sorted) {
    const CurveJet jet = model_.edge_jet(edge_, t);
    along_ = normalized(jet.d1);
    origin_ = jet.point;
    if (norm2(along_) == 0) return false;
    spokes_.clear();
    double greatest_bend = 0;
    for (const std::uint32_t c : coedges_) {
      if (!add_spoke(CoedgeId(c), t)) return false;
      greatest_bend = std::max(greatest_bend, std::abs(spokes_.back().bend));
    }
    size_ = std::max(distance(model_.edge_point(edge_, model_.range(edge_).low), origin_),
                     distance(model_.edge_point(edge_, model_.range(edge_).high), origin_));
    if (greatest_bend > 0) size_ = std::min(size_, 1 / greatest_bend);
    if (!(size_ > 0)) return false;

    const Vec3 x = spokes_.front().into, y = cross(along_, x);
    for (Spoke& s : spokes_) {
      s.angle = std::atan2(dot(s.into, y), dot(s.into, x));
      if (s.angle < 0) s.angle += 2 * std::numbers::pi;
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
      return a.angle != b.angle ? a.angle < b.angle : a.coedge < b.coedge;
    });
    rotate_to_widest_gap();
    if (!settle_tangent_runs()) return false;
    sorted.clear();
    for (const Spoke& s : spokes_) sorted.push_back(s.coedge);
    return true;
  }

 private:
  bool add_spoke(CoedgeId c, double t) {
    Spoke s;
    s.coedge = c.value;
    s.face = model_.topology().face(c);
    s.uv = model_.uv(c, t);
    const Vec3 n = model_.normal(s.face, s.uv);
    const Vec3 direction = model_.topology().reversed(c) ? -along_ : along_;
    s.into = normalized(cross(n, direction));
    if (norm2(s.into) == 0) return false;
    s.ccw = cross(along_, s.into);
    if (!model_.surface(s.face).is_plane()) s.bend = normal_curvature(model_.surface(s.face).jet(s.uv), s.into, s.ccw);
    spokes_.push_back(s);
    return true;
  }

  // So that no run of tangent faces straddles the end of the list.
  void rotate_to_widest_gap() {
    std::size_t best = 0;
    double widest = -1;
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
      const double before = i == 0 ? spokes_.back().angle - 2 * std::numbers::pi : spokes_[i - 1].angle;
      if (spokes_[i].angle - before > widest + 1e-9) {
        widest = spokes_[i].angle - before;
        best = i;
      }
    }
    std::rotate(spokes_.begin(), spokes_.begin() + static_cast<std::ptrdiff_t>(best), spokes_.end());
    for (std::size_t i = 1; i < spokes_.size(); ++i) {
      while (spokes_[i].angle < spokes_[i - 1].angle) spokes_[i].angle += 2 * std::numbers::pi;
    }
  }

  bool settle_tangent_runs() {
    for (std::size_t begin = 0; begin < spokes_.size();) {
      std::size_t end = begin + 1;
      while (end < spokes_.size() && spokes_[end].angle - spokes_[end - 1].angle < tangent_angle) ++end;
      if (end - begin > 1 && !settle_run(begin, end)) return false;
      begin = end;
    }
    return true;
  }

  bool settle_run(std::size_t begin, std::size_t end) {
    const double base = spokes_[begin].angle;
    const double step = small_step * size_;
    const auto near_height = [&](const Spoke& s) { return (s.angle - base) * step + 0.5 * s.bend * step * step; };
    if (sort_run(begin, end, near_height)) return true;
    const Spoke reference = spokes_[begin];
    const double far_step = finite_step * size_;
    return sort_run(begin, end, [&](const Spoke& s) {
      const Vec3 guess = origin_ + far_step * s.into + 0.5 * s.bend * far_step * far_step * s.ccw;
      const Vec3 p = model_.surface(s.face).project(guess, &s.uv).point;
      return dot(p - origin_, reference.ccw);
    });
  }

  template <class Height>
  bool sort_run(std::size_t begin, std::size_t end, Height height) {
    std::vector<std::pair<double, Spoke>> run;
    for (std::size_t i = begin; i < end; ++i) run.emplace_back(height(spokes_[i]), spokes_[i]);
    std::sort(run.begin(), run.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second.coedge < b.second.coedge;
    });
    for (std::size_t i = 1; i < run.size(); ++i) {
      if (run[i].first - run[i - 1].first <= height_noise * size_) return false;
    }
    for (std::size_t i = begin; i < end; ++i) spokes_[i] = run[i - begin].second;
    return true;
  }

  const Model& model_;
  EdgeId edge_;
  std::vector<std::uint32_t> coedges_;
  std::vector<Spoke> spokes_;
  Vec3 along_, origin_;
  double size_ = 0;
};

}  // namespace

Status order_radially(const Model& model, Incidence& in) {
  std::vector<std::uint32_t> begin(in.edge_count() + 1, 0), uses(in.coedges.size());
  for (const std::uint32_t code : in.coedges) ++begin[(code >> 1) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  {
    std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
    for (std::uint32_t c = 0; c < in.coedges.size(); ++c) uses[fill[in.coedges[c] >> 1]++] = c;
  }
  in.radial_next.assign(in.coedges.size(), Incidence::none);
  std::vector<std::uint32_t> sorted;
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    sorted.assign(uses.begin() + begin[e], uses.begin() + begin[e + 1]);
    if (sorted.size() > 2) {
      EdgeOrder order(model, EdgeId(e), sorted);
      bool done = false;
      for (const double fraction : {0.5, 0.382, 0.618, 0.25, 0.75, 0.1, 0.9}) {
        done = order.sort_at(model.range(EdgeId(e)).at(fraction), sorted);
        if (done) break;
      }
      if (!done) {
        std::vector<EntityRef> named{EdgeId(e)};
        for (std::uint32_t i = begin[e]; i < begin[e + 1]; ++i)
          named.push_back(model.topology().face(CoedgeId(uses[i])));
        const Vec3 p = model.edge_point(EdgeId(e), model.range(EdgeId(e)).middle());
        return Error{errors::ambiguous_radial_order,
                     "the faces around an edge cannot be put in order: two of them coincide or touch too closely",
                     std::move(named),
                     {{p.x, p.y, p.z}},
                     "a larger --tolerance, so that the coincident faces are merged"};
      }
    }
    for (std::size_t i = 0; i < sorted.size(); ++i) in.radial_next[sorted[i]] = sorted[(i + 1) % sorted.size()];
  }
  return {};
}

}  // namespace aresta
