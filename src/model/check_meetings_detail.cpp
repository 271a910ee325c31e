// SPDX-License-Identifier: Apache-2.0
// Entities that are not neighbours must not meet: the full level.
//
// Contract. Found: vertices within tolerance of each other; edges that cross, touch or overlap; edges that pierce, end
// in or run along faces that do not know of them; plane faces that cross or overlap (exact, up to tolerance); curved
// faces that cross where an edge of one of them pierces the other, or where their distance changes sign on a grid of
// interior points; faces on one surface that overlap. Not found: curved faces that cross in a closed curve smaller than
// the grid, and contacts in single points without crossing, which are no defect. Candidates by trees of boxes: n log n
// plus what overlaps. Findings name pairs in growing order.
#include <algorithm>
#include <cmath>
#include <optional>

#include "math/box_tree.h"
#include "model/check_detail.h"
#include "model/query.h"

namespace aresta::model_detail {

namespace {

class MeetingCheck {
 public:
  MeetingCheck(const Model& model, Findings& findings) : model_(model), k_(model.topology()), findings_(findings) {}

  Status run(const Context& context) {
    ARESTA_CHECK(context.step(0, "checking vertices"));
    vertices();
    edge_boxes_.resize(k_.edge_count());
    for (const EdgeId e : k_.edges()) {
      edge_boxes_[e.index()] = model_.bounds(e).grown(std::max(model_.tolerance(e), model_.tolerance()));
    }
    edge_tree_ = BoxTree(edge_boxes_);
    ARESTA_CHECK(edges(context));
    face_boxes_.resize(k_.face_count());
    for (const FaceId f : k_.faces()) {
      face_boxes_[f.index()] = model_.bounds(f).grown(std::max(model_.tolerance(f), model_.tolerance()));
    }
    face_tree_ = BoxTree(face_boxes_);
    trims_.resize(k_.face_count());
    grids_.resize(k_.face_count());
    of_face_vertex_.assign(k_.vertex_count(), no_face);
    of_face_edge_.assign(k_.edge_count(), no_face);
    return faces(context);
  }

 private:
  static constexpr std::uint32_t no_face = 0xffffffffu;

  void add(FindingKind kind, std::vector<EntityRef> entities, Vec3 place, double value, double allowed,
           std::string message) {
    findings_.push_back({kind, std::move(entities), place, value, allowed, std::move(message)});
  }

  template <class Visit>
  void partners(const BoxTree& tree, const Box3& box, Visit visit) {
    partners_.clear();
    tree.overlapping(box, [&](std::uint32_t i) { partners_.push_back(i); });
    std::sort(partners_.begin(), partners_.end());
    for (const std::uint32_t i : partners_) visit(i);
  }

  // --- Vertices ------------------------------------------------------------------------------------------------------

  void vertices() {
    std::vector<Box3> boxes(k_.vertex_count());
    const auto radius = [&](VertexId v) { return std::max(model_.tolerance(v), model_.tolerance()); };
    for (const VertexId v : k_.vertices()) boxes[v.index()].add(model_.point(v));
    const BoxTree tree(boxes);
    for (const VertexId v : k_.vertices()) {
      partners(tree, boxes[v.index()].grown(radius(v)), [&](std::uint32_t i) {
        const VertexId w(i);
        if (w <= v) return;
        const double off = distance(model_.point(v), model_.point(w));
        const double allowed = std::max(model_.tolerance(), std::min(model_.tolerance(v), model_.tolerance(w)));
        if (off > allowed) return;
        add(FindingKind::vertices_coincide, {v, w}, model_.point(v), off, allowed,
            name_of(v) + " and " + name_of(w) + " are the same point: " + number(off) + " apart");
      });
    }
  }

  // --- Edges ---------------------------------------------------------------------------------------------------------

  bool in_one_face(EdgeId a, EdgeId b) const {
    for (const CoedgeId c : k_.coedges(a)) {
      for (const CoedgeId d : k_.coedges(b)) {
        if (k_.face(c) == k_.face(d)) return true;
      }
    }
    return false;
  }

  Status edges(const Context& context) {
    for (const EdgeId a : k_.edges()) {
      if (a.index() % 256 == 0) {
        ARESTA_CHECK(context.step(static_cast<double>(a.index()) / static_cast<double>(k_.edge_count()),
                                  "checking edges against edges"));
      }
      partners(edge_tree_, edge_boxes_[a.index()], [&](std::uint32_t i) {
        const EdgeId b(i);
        if (b <= a) return;
        const double tolerance = std::max({model_.tolerance(), model_.tolerance(a), model_.tolerance(b)});
        const auto met = find_meeting(model_, a, b, tolerance);
        // Edges of one face have been looked at with it; the same two edges between the same vertices are duplicates.
        if (!met || in_one_face(a, b) || reported_duplicate(a, b)) return;
        add(FindingKind::edges_coincide, {a, b}, met->place, met->distance, tolerance,
            name_of(a) + " and " + name_of(b) + " meet where they share no vertex");
      });
    }
    return {};
  }

  bool reported_duplicate(EdgeId a, EdgeId b) const {
    return std::any_of(findings_.begin(), findings_.end(), [&](const Finding& f) {
      return f.kind == FindingKind::duplicate_edge && f.entities == std::vector<EntityRef>{a, b};
    });
  }

  // --- Faces ---------------------------------------------------------------------------------------------------------

  const FaceTrim& trim(FaceId f) {
    auto& t = trims_[f.index()];
    if (!t) t.emplace(model_, f);
    return *t;
  }

  double tolerance(FaceId f) const {
    double t = std::max(model_.tolerance(f), model_.tolerance());
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) t = std::max(t, model_.tolerance(k_.edge(c)));
    }
    return t;
  }

  Status faces(const Context& context) {
    for (const FaceId f : k_.faces()) {
      if (f.index() % 64 == 0) {
        ARESTA_CHECK(context.step(static_cast<double>(f.index()) / static_cast<double>(k_.face_count()),
                                  "checking faces against edges and faces"));
      }
      for (const LoopId l : k_.loops(f)) {
        if (k_.is_vertex_loop(l)) of_face_vertex_[k_.loop_vertex(l).index()] = f.value;
        for (const CoedgeId c : k_.coedges(l)) {
          of_face_edge_[k_.edge(c).index()] = f.value;
          of_face_vertex_[k_.start(c).index()] = of_face_vertex_[k_.end(c).index()] = f.value;
        }
      }
      const double face_tolerance = tolerance(f);
      partners(edge_tree_, face_boxes_[f.index()], [&](std::uint32_t i) {
        if (of_face_edge_[i] != f.value) edge_and_face(EdgeId(i), f, face_tolerance);
      });
      partners(face_tree_, face_boxes_[f.index()], [&](std::uint32_t i) {
        if (FaceId(i) > f) face_and_face(f, FaceId(i), face_tolerance);
      });
    }
    return {};
  }

  /// In how many directions do two boxes have more than a few tolerances in common? What overlaps along a line needs
  /// one, what overlaps in an area two.
  static int common_extents(const Box3& a, const Box3& b, double tol) {
    int n = 0;
    for (int i = 0; i < 3; ++i) n += std::min(a.high[i], b.high[i]) - std::max(a.low[i], b.low[i]) > 4 * tol;
    return n;
  }

  bool vertex_of(FaceId f, VertexId v) const { return of_face_vertex_[v.index()] == f.value; }

  void crossing(EdgeId e, FaceId f, Vec3 place, double allowed, const char* how) {
    add(FindingKind::edge_crosses_face, {e, f}, place, 0, allowed, name_of(e) + how + name_of(f));
  }

  void edge_and_face(EdgeId e, FaceId f, double face_tolerance) {
    const double tol = std::max(face_tolerance, model_.tolerance(e));
    const Plane* plane = model_.surface(f).get_if<Plane>();
    if (plane != nullptr && model_.is_straight(e)) {
      segment_and_plane(e, f, *plane, tol);
    } else {
      curve_and_surface(e, f, tol);
    }
  }

  bool inside(FaceId f, Vec2 uv, double tol) { return trim(f).locate(uv, tol) == Position::inside; }
  static Vec2 local(const Plane& plane, Vec3 p) {
    const Vec3 q = plane.frame.to_local(p);
    return {q.x, q.y};
  }

  void segment_and_plane(EdgeId e, FaceId f, const Plane& plane, double tol) {
    const VertexId v[2] = {k_.start(e), k_.end(e)};
    const Vec3 a = model_.point(v[0]), b = model_.point(v[1]);
    const double da = dot(a - plane.frame.origin, plane.frame.z), db = dot(b - plane.frame.origin, plane.frame.z);
    const bool on_a = std::abs(da) <= tol, on_b = std::abs(db) <= tol;
    if (!on_a && !on_b) {
      if ((da > 0) == (db > 0)) return;
      const Vec3 p = lerp(a, b, da / (da - db));
      if (inside(f, local(plane, p), tol)) crossing(e, f, p, tol, " passes through ");
      return;
    }
    for (int i = 0; i < 2; ++i) {
      if (!(i == 0 ? on_a : on_b) || vertex_of(f, v[i])) continue;
      const Vec3 p = i == 0 ? a : b;
      if (inside(f, local(plane, p), tol)) return crossing(e, f, p, tol, " ends inside ");
    }
    if (!on_a || !on_b || common_extents(edge_boxes_[e.index()], face_boxes_[f.index()], tol) == 0) return;
    for (const double s : {0.5, 0.21, 0.83, 0.04, 0.96}) {
      const Vec3 p = lerp(a, b, s);
      if (inside(f, local(plane, p), tol)) return crossing(e, f, p, tol, " runs along the inside of ");
    }
  }

  struct Foot {
    Vec3 place, foot;
    Vec2 uv{};
    double height = 0;  ///< signed distance from the surface
    bool near = false;
  };

  Foot foot_of(Vec3 p, const Surface& surface, const Vec2* hint) const {
    const SurfaceProjection q = surface.project(p, hint);
    const Vec3 n = surface.normal(q.uv);
    Foot r{p, q.point, q.uv, dot(p - q.point, n), true};
    // At an edge of a free-form surface the foot is no foot: the distance is not along the normal.
    if (q.distance > std::abs(r.height) * 1.01 + 1e-12 * (1 + norm(p))) r.near = false;
    return r;
  }

  void curve_and_surface(EdgeId e, FaceId f, double tol) {
    const Surface& surface = model_.surface(f);
    const Box3& box = face_boxes_[f.index()];
    const Range range = model_.range(e);
    constexpr int count = 32;
    // Near vertices that the face knows of edges may leave it as slowly as curvature lets them.
    const double size = model_.bounds(e).diagonal();
    const double radius = std::max(10 * tol, std::sqrt(16 * tol * size));
    const auto known = [&](Vec3 p) {
      for (const VertexId v : {k_.start(e), k_.end(e)}) {
        if (vertex_of(f, v) && distance(p, model_.point(v)) <= radius) return true;
      }
      return false;
    };
    const auto at = [&](double t, const Vec2* hint) { return foot_of(model_.edge_point(e, t), surface, hint); };
    Foot last;
    bool has_last = false;
    double last_t = 0;
    int run = 0;
    for (int i = 0; i <= count; ++i) {
      const double t = range.at(static_cast<double>(i) / count);
      const Vec3 p = model_.edge_point(e, t);
      // A step or two around the box are looked at too.
      if (!box.grown(8 * size / count).contains(p)) {
        has_last = false;
        run = 0;
        continue;
      }
      const Foot here = at(t, nullptr);
      if (!here.near) {
        has_last = false;
        run = 0;
        continue;
      }
      if (std::abs(here.height) <= tol) {
        ++run;
        const bool end = i == 0 || i == count;
        const bool strange_end = end && !vertex_of(f, i == 0 ? k_.start(e) : k_.end(e));
        if ((run >= 3 || strange_end) && !known(p) && inside(f, here.uv, tol)) {
          return crossing(e, f, p, tol, strange_end && run < 3 ? " ends inside " : " runs along the inside of ");
        }
        continue;  // a crossing shows by the samples on either side
      }
      run = 0;
      if (has_last && (last.height > 0) != (here.height > 0) &&
          distance(last.foot, here.foot) <= 4 * distance(last.place, here.place)) {
        double low = last_t, high = t;
        Foot middle = here;
        for (int k = 0; k < 60 && std::abs(middle.height) > 0.01 * tol; ++k) {
          const double m = 0.5 * (low + high);
          middle = at(m, &here.uv);
          ((middle.height > 0) == (last.height > 0) ? low : high) = m;
        }
        if (std::abs(middle.height) <= tol && !known(middle.place) && inside(f, middle.uv, tol)) {
          return crossing(e, f, middle.place, tol, " passes through ");
        }
      }
      last = here;
      has_last = true;
      last_t = t;
    }
  }

  /// Both sides of a crossing are away from the surface; else the edge touches it or runs along it.
  static bool crosses(const Foot& a, const Foot& b, double tol) {
    return std::min(std::abs(a.height), std::abs(b.height)) > tol;
  }

  void face_and_face(FaceId f, FaceId g, double face_tolerance) {
    const double tol = std::max(face_tolerance, tolerance(g));
    const Plane* p = model_.surface(f).get_if<Plane>();
    const Plane* q = model_.surface(g).get_if<Plane>();
    if (p != nullptr && q != nullptr) {
      planes(f, *p, g, *q, tol);
      return;
    }
    curved(f, g, tol);
  }

  void intersecting(FaceId f, FaceId g, Vec3 place, double allowed, const char* how) {
    add(FindingKind::faces_intersect, {f, g}, place, 0, allowed, name_of(f) + " and " + name_of(g) + how);
  }

  /// Distances of a plane face's edges from a plane: do they reach both sides, and is all within tolerance of it?
  void sides(FaceId f, const Plane& plane, double tol, bool& above, bool& below) const {
    above = below = false;
    const auto look = [&](Vec3 p) {
      const double d = dot(p - plane.frame.origin, plane.frame.z);
      above = above || d > tol;
      below = below || d < -tol;
    };
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) {
        look(model_.point(k_.start(c)));
        if (model_.is_straight(k_.edge(c))) continue;
        const Range range = model_.range(k_.edge(c));
        for (int i = 1; i < 16; ++i) look(model_.edge_point(k_.edge(c), range.at(i / 16.0)));
      }
    }
  }

  void planes(FaceId f, const Plane& p, FaceId g, const Plane& q, double tol) {
    bool above = false, below = false;
    sides(g, p, tol, above, below);
    if (!above && !below) return overlap(f, g, tol);
    if (!above || !below || common_extents(face_boxes_[f.index()], face_boxes_[g.index()], tol) == 0) return;
    sides(f, q, tol, above, below);
    if (!above || !below) return;
    // The common line, cut where edges of either face meet the other's plane.
    const Vec3 n = cross(p.frame.z, q.frame.z);
    const double nn = norm2(n);
    if (!(nn > 1e-20)) return;
    const Vec3 d = n / std::sqrt(nn);
    const double hp = dot(p.frame.origin - q.frame.origin, p.frame.z);
    // A point of both planes, near q's origin: on q, at height hp of p.
    const Vec3 in_q = cross(q.frame.z, d);
    const double slope = dot(in_q, p.frame.z);
    if (slope == 0) return;
    const Vec3 o = q.frame.origin + (hp / slope) * in_q;
    cuts_.clear();
    cut(f, q, o, d, tol);
    cut(g, p, o, d, tol);
    std::sort(cuts_.begin(), cuts_.end());
    for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
      if (cuts_[i + 1] - cuts_[i] <= 2 * tol) continue;
      const Vec3 m = o + 0.5 * (cuts_[i] + cuts_[i + 1]) * d;
      if (inside(f, local(p, m), tol) && inside(g, local(q, m), tol)) {
        return intersecting(f, g, m, tol, " pass through each other");
      }
    }
  }

  /// Where the loops of a face cross a plane, as parameters along the line o + t d.
  void cut(FaceId f, const Plane& plane, Vec3 o, Vec3 d, double tol) {
    const auto height = [&](Vec3 p) { return dot(p - plane.frame.origin, plane.frame.z); };
    for (const LoopId l : k_.loops(f)) {
      for (const CoedgeId c : k_.coedges(l)) {
        const EdgeId e = k_.edge(c);
        const Range range = model_.range(e);
        const int count = model_.is_straight(e) ? 1 : 32;
        double t0 = range.low;
        Vec3 a = model_.edge_point(e, t0);
        for (int i = 1; i <= count; ++i) {
          double t1 = range.at(static_cast<double>(i) / count);
          Vec3 b = model_.edge_point(e, t1);
          const Vec3 next = b;
          const double next_t = t1, ha = height(a), hb = height(b);
          if (std::abs(ha) <= tol) cuts_.push_back(dot(a - o, d));
          if (std::abs(hb) <= tol) cuts_.push_back(dot(b - o, d));
          if ((ha > 0) != (hb > 0)) {
            if (count > 1) {
              for (int k = 0; k < 50; ++k) {
                const double m = 0.5 * (t0 + t1);
                const Vec3 p = model_.edge_point(e, m);
                if ((height(p) > 0) == (ha > 0)) {
                  t0 = m, a = p;
                } else {
                  t1 = m, b = p;
                }
              }
              cuts_.push_back(dot(a - o, d));
            } else {
              cuts_.push_back(dot(lerp(a, b, ha / (ha - hb)) - o, d));
            }
          }
          a = next;
          t0 = next_t;
        }
      }
    }
  }

  /// Faces on one surface: is a point of one, inside it or on its boundary, inside the other?
  void overlap(FaceId f, FaceId g, double tol) {
    if (common_extents(face_boxes_[f.index()], face_boxes_[g.index()], tol) < 2) return;
    for (int turn = 0; turn < 2; ++turn) {
      const FaceId a = turn == 0 ? f : g, b = turn == 0 ? g : f;
      const Surface& other = model_.surface(b);
      const auto in_b = [&](Vec3 p) {
        const SurfaceProjection q = other.project(p);
        return q.distance <= tol && inside(b, q.uv, tol);
      };
      const auto uv = trim(a).interior_point();
      if (uv.ok()) {
        const Vec3 p = model_.surface(a).point(*uv);
        if (in_b(p)) return intersecting(f, g, p, tol, " overlap");
      }
      for (const LoopId l : k_.loops(a)) {
        for (const CoedgeId c : k_.coedges(l)) {
          if (is_edge_of(k_.edge(c), b)) continue;
          const Vec3 p = model_.edge_point(k_.edge(c), model_.range(k_.edge(c)).at(0.47));
          if (in_b(p)) return intersecting(f, g, p, tol, " overlap");
        }
      }
    }
  }

  bool is_edge_of(EdgeId e, FaceId f) const {
    for (const CoedgeId c : k_.coedges(e)) {
      if (k_.face(c) == f) return true;
    }
    return false;
  }

  struct GridPoint {
    Vec2 uv{};
    Vec3 place{};
    bool inside = false;
  };
  static constexpr std::size_t grid_count = 8;

  const std::vector<GridPoint>& grid(FaceId f) {
    auto& points = grids_[f.index()];
    if (!points.empty()) return points;
    Range2 box = trim(f).box();
    const auto bounded = [](Range r) {
      if (!std::isfinite(r.low)) r.low = std::isfinite(r.high) ? r.high - 1 : -1;
      if (!std::isfinite(r.high)) r.high = r.low + 1;
      return r;
    };
    box = {bounded(box.u), bounded(box.v)};
    const Surface& surface = model_.surface(f);
    const double tol = std::max(model_.tolerance(f), model_.tolerance());
    points.resize(grid_count * grid_count);
    for (std::size_t i = 0; i < grid_count; ++i) {
      for (std::size_t j = 0; j < grid_count; ++j) {
        GridPoint& g = points[i * grid_count + j];
        g.uv = {box.u.at((static_cast<double>(i) + 0.5137) / grid_count),
                box.v.at((static_cast<double>(j) + 0.4721) / grid_count)};
        g.place = surface.point(g.uv);
        g.inside = trim(f).locate(g.uv, tol) == Position::inside;
      }
    }
    return points;
  }

  void curved(FaceId f, FaceId g, double tol) {
    if (same_surface(f, g, tol)) return overlap(f, g, tol);
    if (!grid_crosses(f, g, tol)) grid_crosses(g, f, tol, true);
  }

  bool same_surface(FaceId f, FaceId g, double tol) {
    if (model_.geometry(f).surface == model_.geometry(g).surface) return true;
    if (std::string_view(model_.surface(f).kind()) != model_.surface(g).kind()) return false;
    const auto& points = grid(f);
    const Surface& other = model_.surface(g);
    for (std::size_t i : {std::size_t{9}, std::size_t{20}, std::size_t{35}, std::size_t{54}}) {
      if (other.project(points[i].place).distance > tol) return false;
    }
    return true;
  }

  bool grid_crosses(FaceId f, FaceId g, double tol, bool swapped = false) {
    const auto& points = grid(f);
    const Surface& surface = model_.surface(f);
    const Surface& other = model_.surface(g);
    const Box3 box = face_boxes_[g.index()].grown(0.25 * face_boxes_[f.index()].diagonal());
    feet_.assign(points.size(), {});
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].inside && box.contains(points[i].place)) feet_[i] = foot_of(points[i].place, other, nullptr);
    }
    for (std::size_t i = 0; i < grid_count; ++i) {
      for (std::size_t j = 0; j < grid_count; ++j) {
        const std::size_t a = i * grid_count + j;
        for (int way = 0; way < 2; ++way) {
          if ((way == 0 ? i : j) + 1 >= grid_count) continue;
          const std::size_t b = way == 0 ? a + grid_count : a + 1;
          if (!feet_[a].near || !feet_[b].near || (feet_[a].height > 0) == (feet_[b].height > 0)) continue;
          if (!crosses(feet_[a], feet_[b], 10 * tol)) continue;
          if (distance(feet_[a].foot, feet_[b].foot) > 4 * distance(points[a].place, points[b].place)) continue;
          Vec2 low = points[a].uv, high = points[b].uv;
          Foot middle;
          for (int k = 0; k < 60; ++k) {
            const Vec2 m = 0.5 * (low + high);
            middle = foot_of(surface.point(m), other, &feet_[a].uv);
            if (std::abs(middle.height) <= 0.01 * tol) break;
            ((middle.height > 0) == (feet_[a].height > 0) ? low : high) = m;
          }
          if (!middle.near || std::abs(middle.height) > tol) continue;
          const Vec2 m = 0.5 * (low + high);
          if (inside(f, m, 4 * tol) && inside(g, middle.uv, 4 * tol)) {
            swapped ? intersecting(g, f, middle.place, tol, " pass through each other")
                    : intersecting(f, g, middle.place, tol, " pass through each other");
            return true;
          }
        }
      }
    }
    return false;
  }

  const Model& model_;
  const Complex& k_;
  Findings& findings_;
  std::vector<Box3> edge_boxes_, face_boxes_;
  BoxTree edge_tree_, face_tree_;
  std::vector<std::optional<FaceTrim>> trims_;
  std::vector<std::vector<GridPoint>> grids_;
  std::vector<std::uint32_t> of_face_vertex_, of_face_edge_;  // stamped with the face being looked at
  std::vector<std::uint32_t> partners_;
  std::vector<double> cuts_;
  std::vector<Foot> feet_;
};

}  // namespace

Status check_meetings(const Model& model, Findings& findings, const Context& context) {
  return MeetingCheck(model, findings).run(context);
}

}  // namespace aresta::model_detail
