// SPDX-License-Identifier: Apache-2.0
// The first few checks: finite coordinates, edges' ends on their vertices, vertices on their faces' surfaces.
// check.cpp takes this file's place as soon as it holds all kinds of finding.
#include "model/check.h"

namespace aresta {

const char* to_string(FindingKind kind) {
  return kind == FindingKind::not_finite ? "not finite" : kind == FindingKind::vertex_off_curve ? "vertex off curve" : "vertex off surface";
}

Result<std::vector<Finding>> check(const Model& model, CheckLevel, const Context& context) {
  const Complex& k = model.topology();
  std::vector<Finding> findings;
  ARESTA_CHECK(context.step(0, "checking"));
  for (const EdgeId e : k.edges()) {
    for (int end = 0; end < 2; ++end) {
      const VertexId v = k.vertex({e, end});
      const Vec3 p = model.edge_point(e, end == 0 ? model.range(e).low : model.range(e).high);
      const double gap = distance(p, model.point(v)), allowed = 2 * std::max({model.tolerance(v), model.tolerance(e), model.tolerance(), 1e-7});
      if (!is_finite(p)) findings.push_back({FindingKind::not_finite, {e}, p, 0, 0, "an edge's end is not finite"});
      else if (gap > allowed) findings.push_back({FindingKind::vertex_off_curve, {v, e}, p, gap, allowed, "an edge does not end in its vertex"});
    }
  }
  for (const CoedgeId c : k.coedges()) {
    const FaceId f = k.face(c);
    const Vec3 p = model.point(k.start(c));
    const double gap = model.surface(f).project(p).distance;
    const double allowed = 2 * std::max({model.tolerance(k.start(c)), model.tolerance(f), model.tolerance(), 1e-7});
    if (gap > allowed) findings.push_back({FindingKind::vertex_off_surface, {k.start(c), f}, p, gap, allowed, "a vertex does not lie on its face"});
  }
  return findings;
}

Status require_valid(const Model& model, CheckLevel level, const Context& context) {
  ARESTA_TRY(const auto findings, check(model, level, context));
  if (findings.empty()) return {};
  const Finding& first = findings.front();
  return Error{errors::invalid_model, std::to_string(findings.size()) + " findings, first: " + first.message, first.entities,
               {{first.place.x, first.place.y, first.place.z}}};
}

}  // namespace aresta
