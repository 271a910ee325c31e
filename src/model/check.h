// SPDX-License-Identifier: Apache-2.0
// The checker: findings by type, each with its evidence. An empty list is the only good answer.
#pragma once

#include "base/context.h"
#include "model/model.h"

namespace aresta {

enum class FindingKind : std::uint8_t {
  // structure
  loop_open,
  radial_cycle_broken,
  sector_in_two_regions,
  shell_disconnected,
  region_unbounded,
  duplicate_edge,
  isolated_use,
  // geometry
  not_finite,
  vertex_off_curve,
  vertex_off_surface,
  edge_off_surface,
  edge_degenerate,
  pcurve_off,
  loop_not_closed_in_surface,
  face_inverted,
  face_degenerate,
  loops_intersect,
  region_inverted,
  radial_order_wrong,
  tolerances_not_nested,
  vertices_coincide,
  edges_coincide,
  faces_intersect,
  edge_crosses_face
};

const char* to_string(FindingKind kind);

struct Finding {
  FindingKind kind;
  std::vector<EntityRef> entities;
  Vec3 place{};
  double value = 0;  ///< the measured deviation, where there is one
  double allowed = 0;
  std::string message;  ///< one sentence
};

enum class CheckLevel {
  fast,  ///< structure, and each entity against its neighbours; linear
  full   ///< also that entities which are not neighbours do not meet; n log n plus what overlaps
};

/// All findings, sorted by kind and entity. Fails only when cancelled.
Result<std::vector<Finding>> check(const Model& model, CheckLevel level, const Context& context = {});

/// An error that names the first findings, or success.
Status require_valid(const Model& model, CheckLevel level, const Context& context = {});

}  // namespace aresta
