// SPDX-License-Identifier: Apache-2.0
#include "exchange/recognize_forms.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/image.h"
#include "geometry/recognize.h"
#include "model/copy.h"
#include "model/query.h"

namespace aresta {

namespace {

constexpr double relative_tolerance = 1e-9;  // of the model's box

/// The face's piece of its surface, a little larger where the surface goes on.
Range2 piece_of(const Model& model, FaceId f) {
  const Range2 box = FaceTrim(model, f).box(), domain = model.surface(f).domain();
  const auto grown = [](Range r, Range limits) {
    const double by = 0.01 * r.length();
    // A face that goes over the limits of a periodic parameter may need all of it.
    if (r.low < limits.low - by || r.high > limits.high + by) return limits;
    return Range{std::max(limits.low, r.low - by), std::min(limits.high, r.high + by)};
  };
  return {grown(box.u, domain.u), grown(box.v, domain.v)};
}

class FormFinder {
 public:
  FormFinder(const Model& model, const Context& context) : model_(model), k_(model.topology()), context_(context) {
    tolerance_ = std::max(relative_tolerance * model.bounds().diagonal(), 1e-9);
  }

  Result<GeometryChanges> run() {
    ARESTA_CHECK(find_surfaces());
    find_curves();
    find_images();
    return std::move(changes_);
  }

 private:
  Status find_surfaces() {
    for (const FaceId f : k_.faces()) {
      if (model_.surface(f).get_if<FreeSurface>() == nullptr) continue;
      ARESTA_CHECK(context_.step(static_cast<double>(f.index()) / static_cast<double>(k_.face_count()),
                                 "looking for planes, cylinders, cones, spheres and tori"));
      const Range2 piece = piece_of(model_, f);
      const auto form = recognize_piece(model_.surface(f), piece, tolerance_);
      if (!form) continue;
      changes_.surfaces.emplace(f, GeometryChanges::NewSurface{form->surface, !form->same_normal, form->deviation});
      middle_.emplace(f, Vec2{piece.u.middle(), piece.v.middle()});
    }
    return {};
  }

  void find_curves() {
    for (const EdgeId e : k_.edges()) {
      if (!model_.geometry(e).curve.valid() || model_.curve(e).get_if<FreeCurve>() == nullptr) continue;
      const auto form = recognize_piece(model_.curve(e), model_.range(e), tolerance_);
      if (form) changes_.curves.emplace(e, GeometryChanges::NewCurve{form->curve, form->range, form->deviation});
    }
  }

  /// Where a use finds no image the edge stays as it was; where that does not help, so does the face; then its other
  /// edges need new images again.
  void find_images() {
    std::set<FaceId> open;
    for (const FaceId f : k_.faces()) open.insert(f);
    while (!open.empty()) {
      const FaceId f = *open.begin();
      open.erase(open.begin());
      bool all = true;
      for (const LoopId l : k_.loops(f)) {
        if (k_.is_vertex_loop(l)) continue;
        for (const CoedgeId c : k_.coedges(l)) {
          changes_.images.erase(c);
          all = all && set_image(c, open);
        }
      }
      if (all) continue;
      changes_.surfaces.erase(f);
      open.insert(f);
    }
  }

  bool set_image(CoedgeId c, std::set<FaceId>& open) {
    const EdgeId e = k_.edge(c);
    const FaceId f = k_.face(c);
    for (;;) {
      const bool new_surface = changes_.surfaces.contains(f), new_curve = changes_.curves.contains(e);
      if (!new_surface && !new_curve) return true;
      const Surface& surface = new_surface ? changes_.surfaces.at(f).surface : model_.surface(f);
      if (surface.is_plane()) return true;
      if (auto image = image_of(c, surface)) {
        changes_.images.emplace(c, std::move(*image));
        return true;
      }
      if (!new_curve) return false;
      changes_.curves.erase(e);
      for (const CoedgeId other : k_.coedges(e)) open.insert(k_.face(other));
    }
  }

  std::optional<Curve2> image_of(CoedgeId c, const Surface& surface) const {
    const EdgeId e = k_.edge(c);
    const FaceId f = k_.face(c);
    const auto changed = changes_.curves.find(e);
    const bool new_curve = changed != changes_.curves.end();
    const Curve old = model_.curve(e);
    const Curve curve = new_curve ? changed->second.curve : old;
    const Range old_range = model_.range(e), range = new_curve ? changed->second.range : old_range;
    const auto near = [&](double t) {
      double before = t;
      if (new_curve) {
        before = t <= range.low    ? old_range.low
                 : t >= range.high ? old_range.high
                                   : old.project(curve.point(t), old_range).parameter;
      }
      const Vec2 uv = model_.uv(c, before);
      return changes_.surfaces.contains(f) ? followed(f, surface, uv) : uv;
    };
    double moved = model_.tolerance(e) + (new_curve ? changed->second.deviation : 0);
    if (const auto face = changes_.surfaces.find(f); face != changes_.surfaces.end()) moved += face->second.deviation;
    const double allowed = 1.5 * std::max(model_.tolerance(), moved);
    const auto image = image_on(surface, curve, range, near, allowed);
    if (!image) return std::nullopt;
    return image->image;
  }

  /// The new parameters of a point of the old surface, continued from the middle of the face, so that all images of the
  /// face lie in one turn and the two sides of a seam on their sides.
  Vec2 followed(FaceId f, const Surface& surface, Vec2 uv) const {
    constexpr int steps = 24;
    const Surface& old = model_.surface(f);
    const Vec2 from = middle_.at(f), period = surface.period();
    Vec2 at = surface.project(old.point(from)).uv;
    for (int i = 1; i <= steps; ++i) {
      const Vec2 next = surface.project(old.point(from + (i / double{steps}) * (uv - from)), &at).uv;
      // At a pole the angle stays what it was.
      const SurfaceJet jet = surface.jet(next);
      const bool pole = period.x > 0 && norm(jet.du) * period.x <= tolerance_;
      at = {pole ? at.x : next.x, next.y};
    }
    return at;
  }

  const Model& model_;
  const Complex& k_;
  const Context& context_;
  double tolerance_ = 0;
  std::map<FaceId, Vec2> middle_;  // of a recognised face's piece, in old parameters
  GeometryChanges changes_;
};

}  // namespace

Result<Model> recognize_forms(Model model, ImportReport& report, const Context& context) {
  ARESTA_TRY(const GeometryChanges changes, FormFinder(model, context).run());
  if (changes.curves.empty() && changes.surfaces.empty()) return model;
  ARESTA_TRY(Model recognized, with_geometry(model, changes));
  const Status after = require_valid(recognized, CheckLevel::fast, context);
  if (!after.ok()) {
    if (after.error().code == errors::cancelled) return after.error();
    const Status before = require_valid(model, CheckLevel::fast, context);
    if (before.ok()) return model;
  }
  if (!changes.curves.empty()) {
    report.notes.push_back(std::to_string(changes.curves.size()) +
                           " edges that the file stores in free form are lines, circles or ellipses");
  }
  if (!changes.surfaces.empty()) {
    report.notes.push_back(std::to_string(changes.surfaces.size()) +
                           " faces that the file stores in free form are planes, cylinders, cones, spheres or tori");
  }
  return recognized;
}

}  // namespace aresta
