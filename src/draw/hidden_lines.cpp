// SPDX-License-Identifier: Apache-2.0
#include "draw/hidden_lines.h"

#include <algorithm>
#include <cmath>

#include "draw/coincident.h"
#include "draw/outline.h"
#include "draw/parallel.h"
#include "draw/shadow.h"
#include "draw/view.h"

namespace aresta::draw {
namespace {

std::vector<DrawnLine> lines_of(const Scene& scene, const TriangleSoup& soup, const Projector& projector,
                                bool with_silhouettes) {
  std::vector<DrawnLine> lines;
  for (const EdgeLine& edge : scene.edges) {
    if (edge.smooth) continue;
    lines.push_back({edge.faces.empty() ? LineKind::wire : LineKind::feature,
                     edge.edge,
                     FaceId{},
                     edge.color,
                     edge.points,
                     edge.faces,
                     {}});
  }
  if (with_silhouettes) {
    for (DrawnLine& line : silhouettes(scene, soup, projector)) lines.push_back(std::move(line));
  }
  return lines;
}

/// The union of hidden parts of one segment.
class HiddenParts {
 public:
  explicit HiddenParts(double gap) : gap_(gap) {}

  /// False once everything is hidden.
  bool add(Interval i) {
    if (i.from <= gap_) i.from = 0;
    if (i.to >= 1 - gap_) i.to = 1;
    auto first = std::lower_bound(parts_.begin(), parts_.end(), i.from - gap_,
                                  [](const Interval& a, double from) { return a.to < from; });
    auto last = first;
    while (last != parts_.end() && last->from <= i.to + gap_) {
      i.from = std::min(i.from, last->from);
      i.to = std::max(i.to, last->to);
      ++last;
    }
    parts_.insert(parts_.erase(first, last), i);
    return !(parts_[0].from == 0 && parts_[0].to == 1);
  }
  const std::vector<Interval>& parts() const { return parts_; }

 private:
  double gap_;
  std::vector<Interval> parts_;  ///< disjoint, in order
};

class Remover {
 public:
  Remover(const Scene& scene, const Camera& camera, const HiddenLineOptions& options)
      : scene_(scene), projector_(camera, {}), soup_(triangle_soup(scene)), tree_({}) {
    const Box3 box = scene.bounds();
    double largest = 0;
    for (const Vec3 p : {box.low, box.high}) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    eps_ = options.tolerance > 0 ? options.tolerance : std::max(1e-9 * box.diagonal(), 1e-14 * largest);
    near_ = 1e-4 * distance(camera.eye, camera.target);
  }

  Result<HiddenLines> run(const HiddenLineOptions& options, const Context& context) {
    ARESTA_CHECK(context.step(0, "finding silhouettes"));
    HiddenLines result;
    result.tolerance = eps_;
    result.lines = lines_of(scene_, soup_, projector_, options.silhouettes);
    ARESTA_CHECK(context.step(0, "sorting triangles"));
    std::vector<Footprint> footprints;
    for (std::uint32_t t = 0; t < soup_.corners.size(); ++t) {
      if (const auto f = footprint(t)) {
        footprints.push_back(*f);
        triangle_of_.push_back(t);
      }
    }
    tree_ = FootprintTree(std::move(footprints));

    constexpr std::size_t chunk = 256;  // segments
    struct Job {
      std::uint32_t line, segment;
    };
    std::vector<Job> jobs;
    for (std::uint32_t l = 0; l < result.lines.size(); ++l) {
      for (std::uint32_t s = 0; s + 1 < result.lines[l].points.size(); ++s) jobs.push_back({l, s});
    }
    const std::size_t chunks = (jobs.size() + chunk - 1) / chunk;
    std::vector<std::vector<LinePiece>> pieces(chunks);
    std::vector<char> end_on(jobs.size(), 0);
    ARESTA_CHECK(parallel_for(context, chunks, "removing hidden lines", [&](std::size_t c) {
      for (std::size_t i = c * chunk; i < std::min(jobs.size(), (c + 1) * chunk); ++i) {
        end_on[i] = !cut(result.lines[jobs[i].line], jobs[i].line, jobs[i].segment, options.keep_hidden, pieces[c]);
      }
    }));
    for (const auto& part : pieces) result.pieces.insert(result.pieces.end(), part.begin(), part.end());
    for (std::size_t i = 0; i < jobs.size();) {
      const std::uint32_t line = jobs[i].line;
      bool all = true;
      for (; i < jobs.size() && jobs[i].line == line; ++i) all = all && end_on[i];
      if (all && result.lines[line].kind != LineKind::silhouette) result.end_on.push_back(result.lines[line].edge);
    }
    for (const PointMark& mark : scene_.points) result.point_visible.push_back(sees(mark.point));
    if (options.merge_coincident) keep_coincident_once(result, projector_);
    return result;
  }

 private:
  std::array<Vec3, 3> corners(std::uint32_t t) const {
    const auto& c = soup_.corners[t];
    return {soup_.numbers.place(c[0]), soup_.numbers.place(c[1]), soup_.numbers.place(c[2])};
  }

  /// Nothing for a triangle wholly behind the eye.
  std::optional<Footprint> footprint(std::uint32_t t) const {
    std::array<Vec3, 3> v;
    const auto world = corners(t);
    for (int i = 0; i < 3; ++i) v[i] = projector_.to_view(world[i]);
    std::array<Vec3, 4> polygon;
    int n = 0;
    double border = eps_;
    if (projector_.perspective()) {
      for (int i = 0; i < 3; ++i) {
        const Vec3 p = v[i], q = v[(i + 1) % 3];
        const auto flat = [](Vec3 a) { return Vec3{a.x / a.z, a.y / a.z, a.z}; };
        if (p.z >= near_) polygon[n++] = flat(p);
        if ((p.z >= near_) != (q.z >= near_)) {
          Vec3 cut = lerp(p, q, (near_ - p.z) / (q.z - p.z));
          cut.z = near_;
          polygon[n++] = flat(cut);
        }
      }
      if (n == 0) return std::nullopt;
      border = eps_ / near_;
      for (int i = 0; i < n; ++i) border = i == 0 ? eps_ / polygon[i].z : std::max(border, eps_ / polygon[i].z);
    } else {
      n = 3;
      std::copy(v.begin(), v.end(), polygon.begin());
    }
    Box3 box;
    for (int i = 0; i < n; ++i) box.add(polygon[i]);
    return Footprint{box.low.x - border, box.low.y - border, box.high.x + border, box.high.y + border, box.low.z};
  }

  /// The pieces of a segment; false when it is seen end-on.
  bool cut(const DrawnLine& line, std::uint32_t line_index, std::uint32_t segment, bool keep_hidden,
           std::vector<LinePiece>& pieces) const {
    const Vec3 start = line.points[segment], end = line.points[segment + 1];
    Vec3 a = projector_.to_view(start), b = projector_.to_view(end);
    double t0 = 0, t1 = 1;  // what lies before the eye
    if (projector_.perspective()) {
      if (a.z < near_ && b.z < near_) return true;
      const double t = (near_ - a.z) / (b.z - a.z);
      if (a.z < near_)
        t0 = t, a = {lerp(a, b, t).x, lerp(a, b, t).y, near_};
      else if (b.z < near_)
        t1 = t, b = {lerp(a, b, t).x, lerp(a, b, t).y, near_};
    }
    const double far = std::max(a.z, b.z) + eps_;
    Vec2 p{a.x, a.y}, q{b.x, b.y};
    double seen = distance(p, q);
    if (projector_.perspective()) {
      p = p / a.z, q = q / b.z;
      seen = distance(p, q) * std::min(a.z, b.z);
    }
    if (seen <= eps_) return false;
    const Vec3 from = t0 == 0 ? start : lerp(start, end, t0), to = t1 == 1 ? end : lerp(start, end, t1);
    const std::uint32_t va = soup_.numbers.find(start), vb = soup_.numbers.find(end);
    const bool on_faces = va != PointNumbers::unknown && vb != PointNumbers::unknown;
    const double least = std::min(0.25, 2 * eps_ / distance(from, to));
    HiddenParts hidden(least);
    const bool behind = !line.behind.empty() && line.behind[segment];
    if (behind) hidden.add({0, 1});
    if (!behind)
      tree_.along(p, q, far, [&](std::uint32_t item) {
        const std::uint32_t t = triangle_of_[item];
        const auto& c = soup_.corners[t];
        const auto has = [&](std::uint32_t v) { return c[0] == v || c[1] == v || c[2] == v; };
        if (on_faces && has(va) && has(vb)) return true;
        const Shadow shadow(corners(t), projector_, eps_);
        if (shadow.thin()) return true;
        const Interval i = shadow.hidden(from, to);
        return i.empty() || hidden.add(i);
      });

    const auto parameter = [&](double s) { return s == 0 ? t0 : s == 1 ? t1 : t0 + s * (t1 - t0); };
    const auto place = [&](double t) { return t == 0 ? start : t == 1 ? end : lerp(start, end, t); };
    const auto put = [&](double s0, double s1, bool visible) {
      if (s1 <= s0 || (!visible && !keep_hidden)) return;
      const double u = parameter(s0), v = parameter(s1);
      pieces.push_back({line_index, segment, u, v, visible, place(u), place(v)});
    };
    double at = 0;
    for (const Interval& i : hidden.parts()) {
      if (i.to - i.from <= least) continue;
      put(at, i.from, true);
      put(i.from, i.to, false);
      at = i.to;
    }
    put(at, 1, true);
    return true;
  }

  bool sees(Vec3 p) const {
    const Vec3 v = projector_.to_view(p);
    if (projector_.perspective() && v.z < near_) return false;
    const Vec2 at = projector_.perspective() ? Vec2{v.x / v.z, v.y / v.z} : Vec2{v.x, v.y};
    bool seen = true;
    tree_.along(at, at, v.z + eps_, [&](std::uint32_t item) {
      const Shadow shadow(corners(triangle_of_[item]), projector_, eps_);
      if (!shadow.thin() && shadow.hides(p)) seen = false;
      return seen;
    });
    return seen;
  }

  const Scene& scene_;
  Projector projector_;
  TriangleSoup soup_;
  FootprintTree tree_;
  std::vector<std::uint32_t> triangle_of_;
  double eps_ = 0, near_ = 0;
};

}  // namespace

Result<HiddenLines> hidden_lines(const Scene& scene, const Camera& camera, const HiddenLineOptions& options,
                                 const Context& context) {
  ARESTA_CHECK(check_view(camera, {}));
  ARESTA_CHECK(check_scene(scene));
  if (!(options.tolerance >= 0 && std::isfinite(options.tolerance))) {
    return Error{errors::invalid_argument, "the tolerance of hidden lines must be a number that is not negative"};
  }
  return Remover(scene, camera, options).run(options, context);
}

Result<std::vector<DrawnLine>> drawn_lines(const Scene& scene, const Camera& camera, bool with_silhouettes,
                                           const Context& context) {
  ARESTA_CHECK(check_view(camera, {}));
  ARESTA_CHECK(check_scene(scene));
  ARESTA_CHECK(context.step(0, "finding silhouettes"));
  const Projector projector(camera, {});
  return lines_of(scene, with_silhouettes ? triangle_soup(scene) : TriangleSoup{}, projector, with_silhouettes);
}

}  // namespace aresta::draw
