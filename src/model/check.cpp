// SPDX-License-Identifier: Apache-2.0
#include "model/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/check_detail.h"

namespace aresta {

const char* to_string(FindingKind kind) {
  switch (kind) {
    case FindingKind::loop_open:
      return "loop open";
    case FindingKind::radial_cycle_broken:
      return "radial cycle broken";
    case FindingKind::sector_in_two_regions:
      return "sector in two regions";
    case FindingKind::shell_disconnected:
      return "shell disconnected";
    case FindingKind::region_unbounded:
      return "region unbounded";
    case FindingKind::duplicate_edge:
      return "duplicate edge";
    case FindingKind::isolated_use:
      return "isolated use";
    case FindingKind::not_finite:
      return "not finite";
    case FindingKind::vertex_off_curve:
      return "vertex off curve";
    case FindingKind::vertex_off_surface:
      return "vertex off surface";
    case FindingKind::edge_off_surface:
      return "edge off surface";
    case FindingKind::edge_degenerate:
      return "edge degenerate";
    case FindingKind::pcurve_off:
      return "parameter curve off";
    case FindingKind::loop_not_closed_in_surface:
      return "loop not closed in surface";
    case FindingKind::face_inverted:
      return "face inverted";
    case FindingKind::face_degenerate:
      return "face degenerate";
    case FindingKind::loops_intersect:
      return "loops intersect";
    case FindingKind::region_inverted:
      return "region inverted";
    case FindingKind::radial_order_wrong:
      return "radial order wrong";
    case FindingKind::tolerances_not_nested:
      return "tolerances not nested";
    case FindingKind::vertices_coincide:
      return "vertices coincide";
    case FindingKind::edges_coincide:
      return "edges coincide";
    case FindingKind::faces_intersect:
      return "faces intersect";
    case FindingKind::edge_crosses_face:
      return "edge crosses face";
  }
  return "unknown";
}

namespace model_detail {

std::string name_of(EntityRef entity) {
  return std::string(to_string(entity.kind)) + " " + std::to_string(entity.index);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  for (char& c : text) {
    if (c == ',') c = '.';  // whatever the locale
  }
  return text;
}

double with_rounding(double tolerance, Vec3 p) {
  return tolerance * (1 + 1e-9) + 1e-14 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
}

}  // namespace model_detail

Result<std::vector<Finding>> check(const Model& model, CheckLevel level, const Context& context) {
  model_detail::Findings findings;
  ARESTA_CHECK(context.step(0, "checking structure"));
  model_detail::check_structure(model, findings);
  // Where links are wrong, geometry cannot be followed along them.
  const bool sound = findings.empty();
  if (sound) {
    ARESTA_CHECK(model_detail::check_entities(model, findings, context));
    const bool finite = std::none_of(findings.begin(), findings.end(),
                                     [](const Finding& f) { return f.kind == FindingKind::not_finite; });
    if (finite) {
      ARESTA_CHECK(model_detail::check_faces(model, findings, context));
      ARESTA_CHECK(model_detail::check_regions(model, findings, context));
      if (level == CheckLevel::full) ARESTA_CHECK(model_detail::check_meetings(model, findings, context));
    }
  }
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.entities < b.entities;
  });
  return findings;
}

Status require_valid(const Model& model, CheckLevel level, const Context& context) {
  ARESTA_TRY(const auto findings, check(model, level, context));
  if (findings.empty()) return {};
  constexpr std::size_t named = 3;
  Error error{errors::invalid_model,
              findings.size() == 1 ? "the model has a defect: "
                                   : "the model has " + std::to_string(findings.size()) + " defects, among them: "};
  for (std::size_t i = 0; i < std::min(named, findings.size()); ++i) {
    if (i > 0) error.message += "; ";
    error.message += findings[i].message;
    for (const EntityRef e : findings[i].entities) {
      if (std::find(error.entities.begin(), error.entities.end(), e) == error.entities.end())
        error.entities.push_back(e);
    }
  }
  const Vec3 p = findings.front().place;
  if (is_finite(p)) error.place = {p.x, p.y, p.z};
  return error;
}

}  // namespace aresta
