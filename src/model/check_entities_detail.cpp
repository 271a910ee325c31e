// SPDX-License-Identifier: Apache-2.0
// Vertices and edges against their neighbours: finite numbers, ends on vertices, images on curves, tolerances.
#include <algorithm>
#include <cmath>

#include "model/check_detail.h"

namespace aresta::model_detail {

namespace {

/// Where curves are compared with their images: the ends, the quarters and some places in between that no knot likes.
constexpr double samples[] = {0, 0.13, 0.25, 0.37, 0.5, 0.63, 0.75, 0.87, 1};

/// Tolerances of imported entities were measured at samples, too: other samples may find a little more.
constexpr double sampling = 1.6;

class EntityCheck {
 public:
  EntityCheck(const Model& model, Findings& findings) : model_(model), k_(model.topology()), findings_(findings) {}

  Status run(const Context& context) {
    for (const VertexId v : k_.vertices()) vertex(v);
    const std::size_t edges = k_.edge_count();
    for (const EdgeId e : k_.edges()) {
      if (e.index() % 512 == 0) {
        ARESTA_CHECK(context.step(0.3 * static_cast<double>(e.index()) / static_cast<double>(edges), "checking edges"));
      }
      if (edge(e) && !model_.is_straight(e)) curved_edge(e);
    }
    for (const FaceId f : k_.faces()) face_is_finite(f);
    if (!findings_.empty() && std::any_of(findings_.begin(), findings_.end(),
                                          [](const Finding& f) { return f.kind == FindingKind::not_finite; })) {
      return {};
    }
    const std::size_t coedges = k_.coedge_count();
    for (const CoedgeId c : k_.coedges()) {
      if (c.index() % 512 == 0) {
        ARESTA_CHECK(context.step(0.3 + 0.3 * static_cast<double>(c.index()) / static_cast<double>(coedges),
                                  "checking edges on faces"));
      }
      coedge(c);
    }
    for (const LoopId l : k_.loops()) {
      if (k_.is_vertex_loop(l)) point_in_face(k_.loop_vertex(l), k_.face(l));
    }
    return {};
  }

 private:
  void add(FindingKind kind, std::vector<EntityRef> entities, Vec3 place, double value, double allowed,
           std::string message) {
    findings_.push_back({kind, std::move(entities), place, value, allowed, std::move(message)});
  }

  void vertex(VertexId v) {
    const Vec3 p = model_.point(v);
    if (!is_finite(p)) {
      add(FindingKind::not_finite, {v}, {}, 0, 0, name_of(v) + " has a coordinate that is not a finite number");
    }
    tolerance(v, model_.tolerance(v), p);
  }

  void tolerance(EntityRef entity, double value, Vec3 place) {
    if (value >= 0 && std::isfinite(value)) return;
    add(FindingKind::tolerances_not_nested, {entity}, place, value, 0,
        name_of(entity) + " has a tolerance that is no length: " + number(value));
  }

  /// False when nothing more can be asked of the edge.
  bool edge(EdgeId e) {
    const Range range = model_.range(e);
    const VertexId ends[2] = {k_.start(e), k_.end(e)};
    if (!std::isfinite(range.low) || !std::isfinite(range.high)) {
      add(FindingKind::not_finite, {e}, {}, 0, 0, name_of(e) + " has a parameter range that is not finite");
      return false;
    }
    const Vec3 at[2] = {model_.edge_point(e, range.low), model_.edge_point(e, range.high)};
    const Vec3 middle = model_.edge_point(e, range.middle());
    if (!is_finite(at[0]) || !is_finite(at[1]) || !is_finite(middle)) {
      add(FindingKind::not_finite, {e}, {}, 0, 0, name_of(e) + " has a point that is not finite");
      return false;
    }
    tolerance(e, model_.tolerance(e), middle);
    if (range.high <= range.low) {
      add(FindingKind::edge_degenerate, {e}, middle, range.length(), 0, name_of(e) + " has an empty parameter range");
      return false;
    }
    for (int end = 0; end < 2; ++end) {
      const VertexId v = ends[end];
      const double off = distance(at[end], model_.point(v));
      const double allowed =
          with_rounding(std::max({model_.tolerance(v), model_.tolerance(e), model_.tolerance()}), at[end]);
      if (!(off <= allowed)) {
        add(FindingKind::vertex_off_curve, {v, e}, model_.point(v), off, allowed,
            name_of(e) + (end == 0 ? " starts " : " ends ") + number(off) + " away from " + name_of(v) +
                ", where its tolerance allows " + number(allowed));
      }
      if (model_.tolerance(e) > std::max(model_.tolerance(v), model_.tolerance()) * (1 + 1e-9)) {
        add(FindingKind::tolerances_not_nested, {v, e}, model_.point(v), model_.tolerance(e), model_.tolerance(v),
            name_of(v) + " has a smaller tolerance (" + number(model_.tolerance(v)) + ") than " + name_of(e) +
                " that it ends (" + number(model_.tolerance(e)) + ")");
      }
    }
    if (model_.is_straight(e)) {
      const double length = distance(at[0], at[1]);
      if (length <= model_.tolerance()) degenerate(e, middle, length);
    }
    return true;
  }

  void degenerate(EdgeId e, Vec3 place, double extent) {
    add(FindingKind::edge_degenerate, {e}, place, extent, model_.tolerance(),
        name_of(e) + " is shorter than the model's tolerance: " + number(extent));
  }

  void curved_edge(EdgeId e) {
    const Range range = model_.range(e);
    const Vec3 start = model_.edge_point(e, range.low);
    double extent = 0;
    for (const double s : samples) {
      const Vec3 p = model_.edge_point(e, range.at(s));
      if (!is_finite(p)) {
        add(FindingKind::not_finite, {e}, {}, 0, 0, name_of(e) + " has a point that is not finite");
        return;
      }
      extent = std::max(extent, distance(start, p));
    }
    if (extent <= model_.tolerance()) degenerate(e, start, extent);
  }

  void face_is_finite(FaceId f) {
    tolerance(f, model_.tolerance(f), {});
    const Surface& surface = model_.surface(f);
    const Range2 domain = surface.domain();
    const auto inside = [](Range r) { return std::isfinite(r.low) && std::isfinite(r.high) ? r.middle() : 0.0; };
    const SurfaceJet jet = surface.jet({inside(domain.u), inside(domain.v)});
    if (is_finite(jet.point) && is_finite(jet.du) && is_finite(jet.dv)) return;
    add(FindingKind::not_finite, {f}, {}, 0, 0, "the surface of " + name_of(f) + " has a point that is not finite");
  }

  void coedge(CoedgeId c) {
    const EdgeId e = k_.edge(c);
    const FaceId f = k_.face(c);
    if (model_.tolerance(f) > std::max(model_.tolerance(e), model_.tolerance()) * (1 + 1e-9)) {
      add(FindingKind::tolerances_not_nested, {e, f}, model_.edge_point(e, model_.range(e).middle()),
          model_.tolerance(f), model_.tolerance(e),
          name_of(e) + " has a smaller tolerance (" + number(model_.tolerance(e)) + ") than " + name_of(f) +
              " that it bounds (" + number(model_.tolerance(f)) + ")");
    }
    const double tolerance = std::max({model_.tolerance(e), model_.tolerance(f), model_.tolerance()});
    const Surface& surface = model_.surface(f);
    const Curve2* image = model_.pcurve(c);
    const Range range = model_.range(e);
    const Plane* plane = surface.get_if<Plane>();
    if (plane != nullptr && model_.is_straight(e) && image == nullptr) {
      // A segment is as far from a plane as the farther of its ends.
      for (const VertexId v : {k_.start(c), k_.end(c)}) {
        const Vec3 p = model_.point(v);
        const double off = std::abs(dot(p - plane->frame.origin, plane->frame.z));
        const double allowed = with_rounding(std::max(tolerance, model_.tolerance(v)), p);
        if (off > allowed) {
          // Once per corner of the face.
          if (v == k_.start(c)) off_surface(v, f, p, off, allowed);
        }
      }
      return;
    }
    double worst_image = 0, worst_surface = 0;
    Vec3 at_image{}, at_surface{};
    for (const double s : samples) {
      const double t = range.at(s);
      const Vec3 p = model_.edge_point(e, t);
      Vec2 hint{};
      if (image != nullptr) {
        hint = image->point(t);
        const double off = distance(surface.point(hint), p);
        if (!(off <= worst_image)) worst_image = off, at_image = p;
        if (off <= tolerance) continue;  // so near is the surface
      }
      const double off =
          surface.project(p, image != nullptr && std::isfinite(hint.x + hint.y) ? &hint : nullptr).distance;
      if (!(off <= worst_surface)) worst_surface = off, at_surface = p;
    }
    double allowed = with_rounding(sampling * tolerance, at_surface);
    if (!(worst_surface <= allowed)) {
      add(FindingKind::edge_off_surface, {e, f}, at_surface, worst_surface, allowed,
          name_of(e) + " leaves the surface of " + name_of(f) + " by " + number(worst_surface) +
              ", where its tolerance allows " + number(allowed));
      return;  // its image cannot be right either
    }
    allowed = with_rounding(sampling * tolerance, at_image);
    if (!(worst_image <= allowed)) {
      add(FindingKind::pcurve_off, {e, f}, at_image, worst_image, allowed,
          "the image of " + name_of(e) + " in " + name_of(f) + " is " + number(worst_image) +
              " away from it, where its tolerance allows " + number(allowed));
    }
  }

  void off_surface(VertexId v, FaceId f, Vec3 p, double off, double allowed) {
    add(FindingKind::vertex_off_surface, {v, f}, p, off, allowed,
        name_of(v) + " is " + number(off) + " away from the surface of " + name_of(f) +
            ", where its tolerance allows " + number(allowed));
  }

  void point_in_face(VertexId v, FaceId f) {
    const Vec3 p = model_.point(v);
    const double off = model_.surface(f).project(p).distance;
    const double allowed = with_rounding(std::max({model_.tolerance(v), model_.tolerance(f), model_.tolerance()}), p);
    if (!(off <= allowed)) off_surface(v, f, p, off, allowed);
  }

  const Model& model_;
  const Complex& k_;
  Findings& findings_;
};

}  // namespace

Status check_entities(const Model& model, Findings& findings, const Context& context) {
  return EntityCheck(model, findings).run(context);
}

}  // namespace aresta::model_detail
