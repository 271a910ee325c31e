// SPDX-License-Identifier: Apache-2.0
#include "construct/sweep_core.h"

#include <algorithm>

#include "construct/arguments.h"
#include "construct/copy.h"
#include "model/check.h"
#include "model/extract.h"
#include "model/query.h"

namespace aresta {

namespace {

class Sweeper {
 public:
  Sweeper(const std::shared_ptr<const Model>& profile, const SweepMotion& motion)
      : profile_(profile),
        source_(*profile),
        k_(source_.topology()),
        motion_(motion),
        base_(source_, builder_),
        top_(source_, builder_, motion.end()),
        path_(k_.vertex_count()),
        face_sign_(k_.face_count()) {}

  Result<Model> run(double tolerance, bool names, const Context& context) {
    names_ = names;
    builder_.length_unit = source_.length_unit;
    builder_.tolerance = tolerance;
    ARESTA_CHECK(check_profile());
    for (const VertexId v : k_.vertices()) {
      if (k_.has_no_edge(v)) add_path(v);
    }
    for (const EdgeId e : k_.edges()) ARESTA_CHECK(add_side(e));
    for (const FaceId f : k_.faces()) {
      if (!motion_.is_closed()) ARESTA_CHECK(add_caps(f));
    }
    if (empty_) {
      return Error{errors::bad_profile, motion_.name() + ": the profile does not move: it lies on the axis"};
    }
    ARESTA_TRY(Model model, build(context));
    ARESTA_CHECK(check_overlaps(model, context));
    add_provenance(model);
    return model;
  }

 private:
  Status check_profile() {
    if (!source_.regions().empty()) {
      return Error{errors::bad_profile,
                   motion_.name() + ": the profile has a region; only faces, wires and points can be swept",
                   {source_.regions().front()},
                   {},
                   "sweep some of its faces"};
    }
    if (k_.vertex_count() == 0) return Error{errors::bad_profile, motion_.name() + ": the profile is empty"};
    for (const FaceId f : k_.faces()) {
      if (source_.surface(f).is_plane()) ARESTA_CHECK(motion_.check_face(source_, f, source_.normal(f, {0, 0})));
      ARESTA_TRY(face_sign_[f.index()], sign_of_face(f));
    }
    return {};
  }

  /// Does the face move along its normal (1) or against it (-1)? Asked all over its boundary, and for curved faces
  /// inside as well: they must keep to one answer.
  Result<int> sign_of_face(FaceId f) const {
    const bool is_plane = source_.surface(f).is_plane();
    double low = 0, high = 0;  // sine of the angle between face and velocity
    Vec3 place{};
    Range2 reach{{1, -1}, {1, -1}};
    const auto widen = [](Range& r, double x) {
      r = r.low > r.high ? Range{x, x} : Range{std::min(r.low, x), std::max(r.high, x)};
    };
    const auto look = [&](Vec2 uv, Vec3 p) {
      const Vec3 velocity = motion_.velocity(p);
      if (motion_.is_fixed(p)) return;
      const double sine = dot(source_.normal(f, uv), velocity) / norm(velocity);
      if (sine < low || sine > high) place = p;
      low = std::min(low, sine);
      high = std::max(high, sine);
    };
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) {
        const Range r = source_.range(k_.edge(c));
        for (int i = 0; i <= samples; ++i) {
          const double t = r.at(static_cast<double>(i) / samples);
          const Vec2 uv = source_.uv(c, t);
          look(uv, source_.edge_point(k_.edge(c), t));
          widen(reach.u, uv.x);
          widen(reach.v, uv.y);
        }
      }
    }
    if (!is_plane) {
      const FaceTrim trim(source_, f);
      for (int i = 1; i < samples; ++i) {
        for (int j = 1; j < samples; ++j) {
          const Vec2 uv{reach.u.at(static_cast<double>(i) / samples), reach.v.at(static_cast<double>(j) / samples)};
          if (trim.locate(uv, source_.tolerance()) == Position::inside) look(uv, source_.surface(f).point(uv));
        }
      }
    }
    const double least = is_plane ? 0 : 1e-9;
    if (high > least && low >= -least) return 1;
    if (low < -least && high <= least) return -1;
    return Error{errors::bad_profile,
                 motion_.name() +
                     ": a curved face of the profile turns away from the motion: part of it moves forward, "
                     "part backward",
                 {f},
                 std::array{place.x, place.y, place.z},
                 "split the face along its outline as seen in the direction of motion"};
  }

  /// A seam joins a curved face to itself: what it sweeps is inside the region.
  bool is_seam(EdgeId e) const {
    const CoedgeId c = k_.first_coedge(e);
    if (!c.valid() || k_.radial(c) == c || k_.radial(k_.radial(c)) != c) return false;
    const FaceId f = k_.face(c);
    return k_.face(k_.radial(c)) == f && !is_inner_edge(source_, e, f);
  }

  bool is_fixed(VertexId v) const { return motion_.is_fixed(source_.point(v)); }
  bool is_fixed(EdgeId e) const {
    const std::vector<Vec3> points = sample_edge(source_, e, 8);
    return std::all_of(points.begin(), points.end(), [&](Vec3 p) { return motion_.is_fixed(p); });
  }

  VertexId top_vertex(VertexId v) {
    if (motion_.is_closed() || is_fixed(v)) top_.vertices[v.index()] = base_.vertex(v);
    return top_.vertex(v);
  }

  Result<EdgeId> top_edge(EdgeId e) {
    if (motion_.is_closed() || is_fixed(e)) {
      ARESTA_TRY(top_.edges[e.index()], base_.edge(e));
    }
    top_vertex(k_.start(e));
    top_vertex(k_.end(e));
    return top_.edge(e);
  }

  /// The edge that a vertex sweeps; invalid when it does not move.
  EdgeId add_path(VertexId v) {
    EdgeId& edge = path_[v.index()];
    if (edge.valid() || is_fixed(v)) return edge;
    const SweptPath path = motion_.path(source_.point(v));
    const VertexId start = base_.vertex(v), end = top_vertex(v);
    const double tolerance = source_.tolerance(v);
    edge = path.curve ? builder_.add_edge(start, end, builder_.add_curve(*path.curve), path.range, tolerance)
                      : builder_.add_edge(start, end, tolerance);
    empty_ = false;
    return edge;
  }

  Status add_side(EdgeId e) {
    if (is_fixed(e) || is_seam(e)) return {};
    ARESTA_TRY(const SweptSurface swept, motion_.surface(source_, e));
    ARESTA_CHECK(check_speed(e));
    FaceDraft face{.surface = builder_.add_surface(swept.surface), .tolerance = source_.tolerance(e), .loops = {}};
    const EdgeId start = add_path(k_.start(e)), end = add_path(k_.end(e));
    if (motion_.is_closed() && swept.surface.is_plane()) {
      // A disc or ring needs no seam: the ways of the ends bound it, the outer one first.
      if (end.valid()) face.loops.push_back({{{end, false}}});
      if (start.valid()) face.loops.push_back({{{start, true}}});
      if (end.valid() && start.valid() && speed(k_.start(e)) > speed(k_.end(e)))
        std::swap(face.loops[0], face.loops[1]);
    } else {
      ARESTA_TRY(const EdgeId base, base_.edge(e));
      ARESTA_TRY(const EdgeId top, top_edge(e));
      auto& loop = face.loops.emplace_back().coedges;
      loop.push_back({base, false, swept.base});
      if (end.valid()) loop.push_back({end, false, swept.end});
      loop.push_back({top, true, swept.top});
      if (start.valid()) loop.push_back({start, true, swept.start});
    }
    // The loop has the face to its left: seen from edge direction x velocity.
    const double t = source_.range(e).middle();
    const CurveJet jet = source_.edge_jet(e, t);
    const Vec3 normal = cross(jet.d1, motion_.velocity(jet.point));
    face.reversed = dot(normal, swept.surface.normal(swept.base ? swept.base->point(t) : Vec2{})) < 0;
    set_fill(e, face);
    if (face.front == Fill::filled && face.back == Fill::empty) turn_over(face);
    side_.push_back({add(face, "side"), e});
    return {};
  }

  double speed(VertexId v) const { return norm(motion_.velocity(source_.point(v))); }

  /// A face of the profile lies to the left of its coedges; whether it moves along its normal says on which side of
  /// the wall its region comes to lie.
  void set_fill(EdgeId e, FaceDraft& face) const {
    if (k_.is_wire(e)) return;
    face.front = face.back = Fill::empty;
    for (const CoedgeId c : k_.coedges(e)) {
      const bool behind = (face_sign_[k_.face(c).index()] > 0) != k_.reversed(c);
      (behind ? face.back : face.front) = Fill::filled;
    }
  }

  /// Along the edge its direction and velocity span a plane that never folds back.
  Status check_speed(EdgeId e) const {
    Vec3 last{};
    for (int i = 0; i < samples; ++i) {
      const CurveJet jet = source_.edge_jet(e, source_.range(e).at((i + 0.5) / samples));
      const Vec3 velocity = motion_.velocity(jet.point);
      const Vec3 normal = cross(jet.d1, velocity);
      const bool folds = norm(normal) <= 1e-9 * norm(jet.d1) * norm(velocity) || (i > 0 && dot(normal, last) <= 0);
      if (folds) {
        return Error{errors::bad_profile,
                     motion_.name() + ": an edge of the profile moves along itself, so that it sweeps no proper face",
                     {e},
                     std::array{jet.point.x, jet.point.y, jet.point.z}};
      }
      last = normal;
    }
    return {};
  }

  Status add_caps(FaceId f) {
    for (const LoopId l : k_.loops(f)) {
      if (k_.is_vertex_loop(l)) top_vertex(k_.loop_vertex(l));
      for (const CoedgeId c : k_.coedges(l)) ARESTA_CHECK(top_edge(k_.edge(c)));
    }
    const bool rises = face_sign_[f.index()] > 0;
    ARESTA_TRY(FaceDraft start, base_.face(f));
    start.front = rises ? Fill::filled : Fill::empty;
    start.back = rises ? Fill::empty : Fill::filled;
    if (rises) turn_over(start);
    caps_.push_back({add(start, "start"), f});
    ARESTA_TRY(FaceDraft end, top_.face(f));
    end.front = rises ? Fill::empty : Fill::filled;
    end.back = rises ? Fill::filled : Fill::empty;
    if (!rises) turn_over(end);
    caps_.push_back({add(end, "end"), f});
    return {};
  }

  FaceId add(const FaceDraft& face, const char* name) {
    const FaceId id = add_face(builder_, face);
    if (names_) builder_.labels.set_name(id, name);
    empty_ = false;
    return id;
  }

  Result<Model> build(const Context& context) {
    Result<Model> model = builder_.build(context);
    if (model.ok()) return model;
    const ErrorCode code = model.error().code;
    if (code == errors::open_solid || code == errors::ambiguous_fill || code == errors::ambiguous_radial_order) {
      return Error{errors::sweep_overlaps, motion_.name() + ": the sweep runs into itself: " + model.error().message};
    }
    return model;
  }

  static constexpr int samples = 24;  // along each edge, and each way across a curved face

  /// One plane face or one straight edge cannot run into itself, once check_face and surface have agreed.
  Status check_overlaps(const Model& model, const Context& context) const {
    const bool one_face = k_.face_count() == 1 && source_.surface(FaceId(0)).is_plane() &&
                          std::none_of(k_.edges().begin(), k_.edges().end(), [&](EdgeId e) { return k_.is_wire(e); });
    const bool one_line = k_.face_count() == 0 && k_.edge_count() == 1 && source_.is_straight(EdgeId(0));
    const bool points_only = k_.edge_count() == 0 && k_.vertex_count() == 1;
    if (one_face || one_line || points_only) return {};
    Status valid = require_valid(model, CheckLevel::full, context);
    if (valid.ok() || valid.error().code.failure == Failure::cancelled) return valid;
    return Error{errors::sweep_overlaps,
                 motion_.name() + ": the sweep runs into itself: " + valid.error().message,
                 {},
                 valid.error().place};
  }

  void add_provenance(Model& model) const {
    auto provenance = std::make_shared<Provenance>();
    provenance->sources.push_back(profile_);
    const auto record = [&](EntityRef result, EntityRef from) { provenance->parents[result].push_back({0, from}); };
    for (const VertexId v : k_.vertices()) {
      for (const ModelCopier* copier : {&base_, &top_}) {
        const VertexId copy = copier->vertices[v.index()];
        if (copy.valid() && (copier == &base_ || copy != base_.vertices[v.index()])) record(copy, v);
      }
      if (path_[v.index()].valid()) record(path_[v.index()], v);
    }
    for (const EdgeId e : k_.edges()) {
      for (const ModelCopier* copier : {&base_, &top_}) {
        const EdgeId copy = copier->edges[e.index()];
        if (copy.valid() && (copier == &base_ || copy != base_.edges[e.index()])) record(copy, e);
      }
    }
    for (const auto& [face, edge] : side_) record(face, edge);
    for (const auto& [face, from] : caps_) record(face, from);
    const Complex& made = model.topology();
    std::map<EntityRef, std::vector<Parent>> regions;
    const auto record_region = [&](FaceUse use, FaceId from) {
      const RegionId r = made.region(use);
      if (model.is_region(r)) regions[r].push_back({0, from});
    };
    for (const auto& [face, from] : caps_) record_region(FaceUse(face, 1), from);
    for (const auto& [face, edge] : side_) {
      for (const CoedgeId c : k_.coedges(edge)) {
        if (k_.is_wire(edge)) break;
        const bool lone = k_.radial(c) == c;
        if (lone) record_region(FaceUse(face, 1), k_.face(c));
      }
    }
    for (auto& [region, parents] : regions) provenance->parents[region] = std::move(parents);
    for (auto& [entity, parents] : provenance->parents) {
      std::sort(parents.begin(), parents.end());
      parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
    }
    model.provenance = provenance;
  }

  std::shared_ptr<const Model> profile_;
  const Model& source_;
  const Complex& k_;
  const SweepMotion& motion_;
  ModelBuilder builder_;
  ModelCopier base_, top_;
  std::vector<EdgeId> path_;    // per vertex of the profile
  std::vector<int> face_sign_;  // per face of the profile
  std::vector<std::pair<FaceId, EdgeId>> side_;
  std::vector<std::pair<FaceId, FaceId>> caps_;
  bool names_ = false, empty_ = true;
};

}  // namespace

Result<Model> sweep(const std::shared_ptr<const Model>& profile, const SweepMotion& motion, double tolerance,
                    bool names, const Context& context) {
  return Sweeper(profile, motion).run(tolerance, names, context);
}

std::vector<Vec3> sample_edge(const Model& model, EdgeId edge, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i <= count; ++i) points.push_back(model.edge_point(edge, model.range(edge).at(double(i) / count)));
  return points;
}

}  // namespace aresta
