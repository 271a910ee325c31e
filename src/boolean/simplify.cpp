// SPDX-License-Identifier: Apache-2.0
#include "boolean/simplify.h"

#include <algorithm>

#include "base/union_find.h"
#include "model/inherit.h"
#include "topology/assemble.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;
constexpr double parallel_tolerance = 1e-9;  // rad
constexpr double image_tolerance = 1e-7;     // in parameters: one image continues the other

class Simplifier {
 public:
  explicit Simplifier(const Model& model) : model_(model), k_(model.topology()) {}

  Result<Extraction> run() {
    keep_ = {std::vector<bool>(k_.vertex_count(), true), std::vector<bool>(k_.edge_count(), true),
             std::vector<bool>(k_.face_count(), true), std::vector<bool>(k_.region_count(), false),
             std::vector<bool>(k_.face_count(), false)};
    for (const RegionId r : k_.regions()) keep_.filled[r.index()] = model_.is_region(r);
    for (const FaceId f : k_.faces()) keep_.constraint[f.index()] = model_.is_constraint(f);
    gather_grouped();
    merge_faces();
    merge_edges();
    return extract(model_, keep_, &merging_);
  }

 private:
  void gather_grouped() {
    for (std::size_t g = 0; g < model_.labels.groups.size(); ++g) {
      for (const EntityRef e : model_.labels.groups[g].entities) groups_of_[e].push_back(g);
    }
  }

  bool is_labelled(EntityRef e) const {
    const auto found = model_.labels.attributes.find(e);
    return (found != model_.labels.attributes.end() && !found->second.empty()) || groups_of_.contains(e);
  }

  bool same_labels(EntityRef a, EntityRef b) const {
    const auto attributes = [&](EntityRef e) {
      const auto found = model_.labels.attributes.find(e);
      return found == model_.labels.attributes.end() ? std::map<std::string, AttributeValue>() : found->second;
    };
    const auto groups = [&](EntityRef e) {
      const auto found = groups_of_.find(e);
      return found == groups_of_.end() ? std::vector<std::size_t>() : found->second;
    };
    return attributes(a) == attributes(b) && groups(a) == groups(b);
  }

  // Faces.

  bool same_surface(FaceId a, FaceId b) const {
    if (model_.is_reversed(a) == model_.is_reversed(b) && model_.geometry(a).surface == model_.geometry(b).surface)
      return true;
    const Surface &sa = model_.surface(a), &sb = model_.surface(b);
    if (const Plane* plane = sa.get_if<Plane>(); plane != nullptr && sb.is_plane()) {
      if (norm(cross(model_.normal(a, {}), model_.normal(b, {}))) > parallel_tolerance ||
          dot(model_.normal(a, {}), model_.normal(b, {})) < 0)
        return false;
      const double tolerance = std::max({model_.tolerance(), model_.tolerance(a), model_.tolerance(b)});
      for (const LoopId l : k_.loops(b)) {
        for (const CoedgeId c : k_.coedges(l)) {
          if (std::abs(dot(model_.point(k_.start(c)) - plane->frame.origin, plane->frame.z)) > tolerance) return false;
        }
      }
      return true;
    }
    return model_.is_reversed(a) == model_.is_reversed(b) && equal_forms(sa, sb);
  }

  static bool equal_forms(const Surface& a, const Surface& b) {
    if (a.form().index() != b.form().index()) return false;
    if (const auto* f = a.get_if<FreeSurface>()) return f->same_object(*b.get_if<FreeSurface>());
    if (const auto* x = a.get_if<Cylinder>())
      return x->frame == b.get_if<Cylinder>()->frame && x->radius == b.get_if<Cylinder>()->radius;
    if (const auto* x = a.get_if<Sphere>())
      return x->frame == b.get_if<Sphere>()->frame && x->radius == b.get_if<Sphere>()->radius;
    if (const auto* x = a.get_if<Cone>()) {
      const auto* y = b.get_if<Cone>();
      return x->frame == y->frame && x->radius == y->radius && x->half_angle == y->half_angle;
    }
    if (const auto* x = a.get_if<Torus>()) {
      const auto* y = b.get_if<Torus>();
      return x->frame == y->frame && x->major == y->major && x->minor == y->minor;
    }
    return false;
  }

  bool may_merge(FaceId a, FaceId b) const {
    return model_.is_constraint(a) == model_.is_constraint(b) && k_.region(FaceUse(a, 0)) == k_.region(FaceUse(b, 0)) &&
           k_.region(FaceUse(a, 1)) == k_.region(FaceUse(b, 1)) && same_labels(a, b) && same_surface(a, b);
  }

  /// Gap between the images of an edge in its two faces: what the second face must be shifted by.
  Vec2 image_gap(CoedgeId a, CoedgeId b) const {
    if (model_.surface(k_.face(a)).is_plane()) return {};
    const double t = model_.range(k_.edge(a)).middle();
    return model_.uv(a, t) - model_.uv(b, t);
  }

  void merge_faces() {
    merging_.face_class.resize(k_.face_count());
    merging_.shift.assign(k_.face_count(), {});
    std::vector<std::vector<FaceId>> members(k_.face_count());
    for (const FaceId f : k_.faces()) {
      merging_.face_class[f.index()] = f;
      members[f.index()] = {f};
    }
    for (const EdgeId e : k_.edges()) {
      if (k_.use_kind(e) != EdgeUseKind::manifold || is_labelled(e)) continue;
      const CoedgeId a = k_.first_coedge(e), b = k_.radial(a);
      const FaceId fa = k_.face(a), fb = k_.face(b);
      if (fa == fb || k_.reversed(a) == k_.reversed(b) || !may_merge(fa, fb)) continue;
      const FaceId ca = merging_.face_class[fa.index()], cb = merging_.face_class[fb.index()];
      const Vec2 gap = image_gap(a, b) + merging_.shift[fa.index()] - merging_.shift[fb.index()];
      if (ca == cb) {
        if (norm(gap) <= image_tolerance) keep_.edges[e.index()] = false;
        continue;
      }
      if (!is_whole_periods(gap, model_.surface(fa).period())) continue;
      keep_.edges[e.index()] = false;
      const FaceId low = std::min(ca, cb), high = std::max(ca, cb);
      const Vec2 move = high == cb ? gap : -gap;
      for (const FaceId f : members[high.index()]) {
        merging_.face_class[f.index()] = low;
        merging_.shift[f.index()] += move;
        members[low.index()].push_back(f);
      }
      members[high.index()].clear();
    }
  }

  static bool is_whole_periods(Vec2 gap, Vec2 period) {
    const auto whole = [](double g, double p) {
      return std::abs(p > 0 ? g - p * std::round(g / p) : g) <= image_tolerance;
    };
    return whole(gap.x, period.x) && whole(gap.y, period.y);
  }

  // Edges.

  void merge_edges() {
    merging_.chain_of.assign(k_.edge_count(), none);
    std::vector<bool> joint(k_.vertex_count(), false);
    for (const VertexId v : k_.vertices()) {
      std::vector<EdgeEnd> ends;
      bool had_edges = false;
      for (const EdgeEnd end : k_.edge_ends(v)) {
        had_edges = true;
        if (keep_.edges[end.edge.index()]) ends.push_back(end);
      }
      if (!had_edges || is_labelled(v) || !k_.vertex_loops(v).empty()) continue;
      if (ends.empty()) {
        keep_.vertices[v.index()] = false;
      } else if (ends.size() == 2 && ends[0].edge != ends[1].edge && continues(v, ends[0], ends[1])) {
        joint[v.index()] = true;
      }
    }
    std::vector<bool> used(k_.edge_count(), false);
    for (const EdgeId e : k_.edges()) {
      if (keep_.edges[e.index()] && !used[e.index()]) follow_chain(e, joint, used);
    }
  }

  void follow_chain(EdgeId first, const std::vector<bool>& joint, std::vector<bool>& used) {
    // Back to the chain's beginning (or around, when it closes), then forward.
    Merging::Link link{first, false};
    while (joint[start(link).index()]) {
      const Merging::Link before = step(link, false);
      if (before.edge == first) break;
      link = before;
    }
    std::vector<Merging::Link> chain{link};
    used[link.edge.index()] = true;
    while (joint[end(link).index()]) {
      link = step(link, true);
      if (used[link.edge.index()]) break;
      used[link.edge.index()] = true;
      chain.push_back(link);
    }
    if (chain.size() < 2) return;
    const bool straight = model_.is_straight(chain.front().edge);
    if (!straight && chain.front().reversed) {
      std::reverse(chain.begin(), chain.end());
      for (Merging::Link& l : chain) l.reversed = !l.reversed;
    }
    for (std::size_t i = 1; i < chain.size(); ++i) keep_.vertices[start(chain[i]).index()] = false;
    for (const Merging::Link& l : chain)
      merging_.chain_of[l.edge.index()] = static_cast<std::uint32_t>(merging_.chains.size());
    merging_.chains.push_back(std::move(chain));
  }

  VertexId start(const Merging::Link& l) const { return l.reversed ? k_.end(l.edge) : k_.start(l.edge); }
  VertexId end(const Merging::Link& l) const { return l.reversed ? k_.start(l.edge) : k_.end(l.edge); }

  Merging::Link step(const Merging::Link& from, bool forward) const {
    const VertexId v = forward ? end(from) : start(from);
    for (const EdgeEnd e : k_.edge_ends(v)) {
      if (keep_.edges[e.edge.index()] && e.edge != from.edge) return {e.edge, forward ? e.end == 1 : e.end == 0};
    }
    return from;
  }

  /// Do the edges at these ends lie on one curve, one going on where the other stops, with equal faces around?
  bool continues(VertexId v, EdgeEnd a, EdgeEnd b) const {
    if (!same_labels(a.edge, b.edge) || k_.is_wire(a.edge) != k_.is_wire(b.edge)) return false;
    if (model_.is_straight(a.edge) && model_.is_straight(b.edge)) {
      if (!only_planes(a.edge) || !only_planes(b.edge)) return false;
      const Vec3 p = model_.point(v), qa = model_.point(k_.vertex({a.edge, 1 - a.end})),
                 qb = model_.point(k_.vertex({b.edge, 1 - b.end}));
      const Vec3 da = normalized(qa - p), db = normalized(qb - p);
      return dot(da, db) < 0 && norm(cross(da, db)) <= parallel_tolerance;
    }
    const EdgeGeometry &ga = model_.geometry(a.edge), &gb = model_.geometry(b.edge);
    if (!ga.curve.valid() || ga.curve != gb.curve || a.end == b.end) return false;
    const bool a_first = a.end == 1;
    const EdgeId first = a_first ? a.edge : b.edge, second = a_first ? b.edge : a.edge;
    const double gap = model_.range(first).high - model_.range(second).low, period = model_.curve(ga.curve).period();
    const double left = period > 0 ? gap - period * std::round(gap / period) : gap;
    return std::abs(left) <= 1e-12 * (1 + std::abs(gap)) && same_images(first, second, gap);
  }

  bool only_planes(EdgeId e) const {
    for (const CoedgeId c : k_.coedges(e)) {
      if (!model_.surface(k_.face(c)).is_plane()) return false;
    }
    return true;
  }

  /// On curved faces the images must be one line in the parameter plane, so that the first one serves the whole chain.
  /// `gap` is what the curve's parameter of b lacks (whole periods) to go on from a's.
  bool same_images(EdgeId a, EdgeId b, double gap) const {
    for (const CoedgeId c : k_.coedges(a)) {
      const Curve2* image = model_.pcurve(c);
      if (image == nullptr) continue;
      const Line2* line = image->get_if<Line2>();
      bool found = false;
      for (const CoedgeId d : k_.coedges(b)) {
        const Curve2* other = model_.pcurve(d);
        if (line == nullptr || other == nullptr ||
            merging_.face_class[k_.face(c).index()] != merging_.face_class[k_.face(d).index()])
          continue;
        const Line2* second = other->get_if<Line2>();
        const Vec2 move = merging_.shift[k_.face(d).index()] - merging_.shift[k_.face(c).index()];
        found = found || (second != nullptr && norm(second->direction - line->direction) <= 1e-12 &&
                          norm(second->origin + move - gap * line->direction - line->origin) <= image_tolerance);
      }
      if (!found) return false;
    }
    return true;
  }

  const Model& model_;
  const Complex& k_;
  Selection keep_;
  Merging merging_;
  std::map<EntityRef, std::vector<std::size_t>> groups_of_;
};

}  // namespace

Result<Extraction> simplify(const Model& model) {
  ARESTA_TRY(Extraction result, Simplifier(model).run());
  copy_labels(model, result.from, result.model);
  return result;
}

}  // namespace aresta
