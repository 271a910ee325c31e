// SPDX-License-Identifier: Apache-2.0
// Faces by themselves: loops closed and not crossing, areas positive; edges with several faces: radial order; regions:
// volumes positive.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/box_tree.h"
#include "model/check_detail.h"
#include "model/image_detail.h"
#include "model/measure.h"

namespace aresta::model_detail {

namespace {

class FaceCheck {
 public:
  FaceCheck(const Model& model, Findings& findings) : model_(model), k_(model.topology()), findings_(findings) {}

  Status run(const Context& context) {
    const std::size_t count = k_.face_count();
    for (const FaceId f : k_.faces()) {
      if (f.index() % 64 == 0) {
        ARESTA_CHECK(
            context.step(0.6 + 0.2 * static_cast<double>(f.index()) / static_cast<double>(count), "checking faces"));
      }
      const bool closed = model_.surface(f).is_plane() || loops_closed(f);
      if (closed) area(f);
      loops_apart(f);
    }
    for (const EdgeId e : k_.edges()) {
      if (k_.is_wire(e)) continue;
      const CoedgeId first = k_.first_coedge(e), second = k_.radial(first);
      if (second != first && k_.radial(second) != first) radial_order(e);
    }
    return {};
  }

 private:
  void add(FindingKind kind, std::vector<EntityRef> entities, Vec3 place, double value, double allowed,
           std::string message) {
    findings_.push_back({kind, std::move(entities), place, value, allowed, std::move(message)});
  }

  Vec3 place_of(FaceId f) const {
    for (const LoopId l : k_.loops(f)) {
      return model_.point(k_.is_vertex_loop(l) ? k_.loop_vertex(l) : k_.start(k_.first_coedge(l)));
    }
    return {};
  }

  /// The images of consecutive edges meet, but for gaps at poles.
  bool loops_closed(FaceId f) {
    const FaceImage image = image_of(model_, f);
    bool closed = true;
    for (const ImagePiece& piece : image.pieces) {
      if (piece.gap_end == piece.end) continue;
      const VertexId v = k_.end(piece.coedge);
      const CoedgeId next = k_.next(piece.coedge);
      const double tolerance = std::max({model_.tolerance(), model_.tolerance(f), model_.tolerance(v),
                                         model_.tolerance(k_.edge(piece.coedge)) + model_.tolerance(k_.edge(next))});
      const double gap = image.gap_length(piece);
      // Both images may miss the vertex by the tolerance.
      const double allowed = with_rounding(2 * tolerance, model_.point(v));
      if (gap <= allowed) continue;
      closed = false;
      add(FindingKind::loop_not_closed_in_surface, {v, f}, model_.point(v), gap, allowed,
          "a loop of " + name_of(f) + " has a gap of " + number(gap) + " at " + name_of(v) +
              " in the parameters of its surface, where tolerances allow " + number(allowed));
    }
    return closed;
  }

  void area(FaceId f) {
    double perimeter = 0;
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) perimeter += extent(k_.edge(c));
    }
    const auto m = measure(model_, f, {.relative = 1e-6});
    if (!m.ok()) {
      add(FindingKind::loop_not_closed_in_surface, {f}, place_of(f), 0, 0, m.error().message + ": " + name_of(f));
      return;
    }
    const double allowed = std::max(0.25 * model_.tolerance() * perimeter, 0.0);
    if (std::abs(m->measure) <= allowed) {
      add(FindingKind::face_degenerate, {f}, place_of(f), m->measure, allowed,
          name_of(f) + " is thinner than the model's tolerance: its area is " + number(m->measure));
    } else if (m->measure < 0) {
      add(FindingKind::face_inverted, {f}, place_of(f), m->measure, 0,
          "the loops of " + name_of(f) + " run against its normal: its area is " + number(m->measure));
    }
  }

  double extent(EdgeId e) const {
    const Range r = model_.range(e);
    const Vec3 a = model_.edge_point(e, r.low), b = model_.edge_point(e, r.high);
    if (model_.is_straight(e)) return distance(a, b);
    double sum = 0;
    Vec3 last = a;
    for (int i = 1; i <= 8; ++i) {
      const Vec3 p = model_.edge_point(e, r.at(i / 8.0));
      sum += distance(last, p);
      last = p;
    }
    return sum;
  }

  void loops_apart(FaceId f) {
    edges_.clear();
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) edges_.push_back(k_.edge(c));
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    if (edges_.size() < 2 || triangle()) return;
    constexpr std::size_t few = 12;
    if (edges_.size() <= few) {
      for (std::size_t i = 0; i < edges_.size(); ++i) {
        for (std::size_t j = i + 1; j < edges_.size(); ++j) pair(f, edges_[i], edges_[j]);
      }
      return;
    }
    std::vector<Box3> boxes(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      boxes[i] = model_.bounds(edges_[i]).grown(std::max(model_.tolerance(edges_[i]), model_.tolerance()));
    }
    const BoxTree tree(boxes);
    std::vector<std::uint32_t> partners;
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      partners.clear();
      tree.overlapping(boxes[i], [&](std::uint32_t j) {
        if (j > i) partners.push_back(j);
      });
      std::sort(partners.begin(), partners.end());
      for (const std::uint32_t j : partners) pair(f, edges_[i], edges_[j]);
    }
  }

  /// Three straight edges between three vertices cannot cross.
  bool triangle() const {
    return edges_.size() == 3 && std::all_of(edges_.begin(), edges_.end(), [&](EdgeId e) {
             return model_.is_straight(e) && k_.start(e) != k_.end(e);
           });
  }

  void pair(FaceId f, EdgeId a, EdgeId b) {
    const double tolerance = std::max({model_.tolerance(), model_.tolerance(a), model_.tolerance(b)});
    const auto met = find_meeting(model_, a, b, tolerance);
    if (!met) return;
    add(FindingKind::loops_intersect, {a, b, f}, met->place, met->distance, tolerance,
        name_of(a) + " and " + name_of(b) + " meet in " + name_of(f) + " where they share no vertex");
  }

  /// The angles of the faces about the edge, measured on the surfaces a step away, must grow along the cycle. A step
  /// decides only when all angles differ by more than what the tolerances can do; else a longer one is taken; an edge
  /// that no step decides is left to whoever made its order.
  void radial_order(EdgeId e) {
    std::vector<CoedgeId> cycle;
    double tolerance = std::max(model_.tolerance(e), 1e-13 * model_.bounds(e).diagonal());
    for (const CoedgeId c : k_.coedges(e)) {
      cycle.push_back(c);
      tolerance = std::max(tolerance, model_.tolerance(k_.face(c)));
    }
    const Range range = model_.range(e);
    const double size = extent(e);
    for (const double fraction : {0.5, 0.29, 0.83}) {
      const double t = range.at(fraction);
      const CurveJet jet = model_.edge_jet(e, t);
      const Vec3 along = normalized(jet.d1);
      if (norm2(along) == 0) continue;
      for (const double part : {1e-4, 1e-3, 1e-2, 5e-2}) {
        const double step = part * size;
        const double noise = std::max(1e-9, 8 * tolerance / step);
        if (noise > 0.2) continue;
        const int verdict = compare(cycle, t, jet.point, along, step, noise);
        if (verdict == 0) continue;  // not told apart
        if (verdict < 0) {
          std::vector<EntityRef> entities{e};
          for (const CoedgeId c : cycle) entities.push_back(k_.face(c));
          add(FindingKind::radial_order_wrong, std::move(entities), jet.point, 0, 0,
              "the faces around " + name_of(e) + " are not in the order of their angles");
        }
        return;
      }
    }
  }

  /// +1 in order, -1 not, 0 undecided.
  int compare(const std::vector<CoedgeId>& cycle, double t, Vec3 origin, Vec3 along, double step, double noise) const {
    const Vec3 x = any_perpendicular(along), y = cross(along, x);
    std::vector<double> angles;
    for (const CoedgeId c : cycle) {
      const FaceId f = k_.face(c);
      const Vec2 uv = model_.uv(c, t);
      const Vec3 into = normalized(cross(model_.normal(f, uv), k_.reversed(c) ? -along : along));
      if (norm2(into) == 0) return 0;
      const Surface& surface = model_.surface(f);
      Vec3 d = into;
      if (!surface.is_plane()) {
        d = surface.project(origin + step * into, &uv).point - origin;
        d = d - dot(d, along) * along;
      }
      if (dot(d, into) <= 0) return 0;
      angles.push_back(std::atan2(dot(d, y), dot(d, x)));
    }
    double total = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      double gap = angles[(i + 1) % angles.size()] - angles[i];
      while (gap <= 0) gap += 2 * std::numbers::pi;
      total += gap;
    }
    std::vector<double> sorted = angles;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const double gap =
          i + 1 < sorted.size() ? sorted[i + 1] - sorted[i] : sorted[0] + 2 * std::numbers::pi - sorted[i];
      if (gap < noise) return 0;
    }
    return total < 3 * std::numbers::pi ? 1 : -1;
  }

  const Model& model_;
  const Complex& k_;
  Findings& findings_;
  std::vector<EdgeId> edges_;
};

}  // namespace

Status check_faces(const Model& model, Findings& findings, const Context& context) {
  return FaceCheck(model, findings).run(context);
}

Status check_regions(const Model& model, Findings& findings, const Context& context) {
  const Complex& k = model.topology();
  std::size_t done = 0;
  for (const RegionId r : k.regions()) {
    if (r == Complex::infinite_region()) continue;
    if (done++ % 16 == 0) {
      ARESTA_CHECK(context.step(0.8 + 0.2 * static_cast<double>(r.index()) / static_cast<double>(k.region_count()),
                                "checking regions"));
    }
    const auto m = measure(model, r, {.relative = 1e-6});
    if (!m.ok()) continue;  // a face of it has been reported
    if (m->measure > m->error) continue;
    Vec3 place = m->reference;
    findings.push_back(
        {FindingKind::region_inverted,
         {r},
         place,
         m->measure,
         m->error,
         name_of(r) +
             (m->measure < -m->error ? " is turned inside out: its volume is " : " encloses no measurable volume: ") +
             number(m->measure)});
  }
  return {};
}

}  // namespace aresta::model_detail
