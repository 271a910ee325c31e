// SPDX-License-Identifier: Apache-2.0
#include "exchange/recognize_forms.h"

#include <algorithm>

#include "geometry/recognize.h"
#include "model/copy.h"

namespace aresta {

namespace {

constexpr double relative_tolerance = 1e-9;  // of the model's box
constexpr int samples = 8;

/// The straight image with the curve's own parameters, when the curve has one on the surface.
std::optional<Curve2> straight_image(const Model& model, CoedgeId c, const RecognizedCurve& form, double tolerance) {
  const EdgeId e = model.topology().edge(c);
  const Curve2* old_image = model.pcurve(c);
  if (old_image == nullptr) return std::nullopt;
  const Surface& surface = model.surface(model.topology().face(c));
  const Curve old_curve = model.curve(e);
  const auto image_at = [&](double fraction) {
    const Vec3 p = form.curve.point(form.range.at(fraction));
    const Vec2 hint = old_image->point(old_curve.project(p, model.range(e)).parameter);
    return surface.project(p, &hint).uv;
  };
  // Ends may be where the surface has no unique parameters: the direction is taken well inside.
  const Vec2 a = image_at(0.25), b = image_at(0.75);
  const double length = 0.5 * form.range.length();
  const Vec2 direction = (b - a) / length;
  if (std::abs(norm(direction) - 1) > 1e-6) return std::nullopt;
  const Vec2 unit = direction / norm(direction);
  const Line2 line{a - form.range.at(0.25) * unit, unit};
  for (int i = 0; i <= samples; ++i) {
    const double t = form.range.at(static_cast<double>(i) / samples);
    if (distance(surface.point(Curve2(line).point(t)), form.curve.point(t)) > tolerance) return std::nullopt;
  }
  return Curve2(line);
}

}  // namespace

Result<Model> recognize_forms(Model model, ImportReport& report) {
  const Complex& k = model.topology();
  const double tolerance = std::max(relative_tolerance * model.bounds().diagonal(), 1e-9);
  GeometryChanges changes;
  for (const EdgeId e : k.edges()) {
    if (!model.geometry(e).curve.valid() || model.curve(e).get_if<FreeCurve>() == nullptr) continue;
    const auto form = recognize_piece(model.curve(e), model.range(e), tolerance);
    if (!form) continue;
    std::map<CoedgeId, Curve2> images;
    bool all = true;
    for (const CoedgeId c : k.coedges(e)) {
      if (model.surface(k.face(c)).is_plane()) continue;
      const auto image = straight_image(model, c, *form, 10 * tolerance + model.tolerance(e));
      all = all && image.has_value();
      if (image) images.emplace(c, *image);
    }
    if (!all) continue;
    changes.curves.emplace(e, GeometryChanges::NewCurve{form->curve, form->range, form->deviation});
    changes.images.merge(images);
  }
  if (changes.curves.empty()) return model;
  report.notes.push_back(std::to_string(changes.curves.size()) +
                         " edges that the file stores as B-splines are lines, circles or ellipses");
  return with_geometry(model, changes);
}

}  // namespace aresta
