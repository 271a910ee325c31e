// SPDX-License-Identifier: Apache-2.0
// The parts of the checker, in the order in which they run. Each adds its findings.
#pragma once

#include <string>
#include <vector>

#include "model/check.h"

namespace aresta::model_detail {

using Findings = std::vector<Finding>;

/// Links of the complex. Reads no coordinate and trusts no link: safe on any complex.
void check_structure(const Model& model, Findings& findings);

// The rest needs a right structure.
Status check_entities(const Model& model, Findings& findings, const Context& context);
Status check_faces(const Model& model, Findings& findings, const Context& context);
Status check_regions(const Model& model, Findings& findings, const Context& context);
/// Entities that are not neighbours; also pairs of edges of one face when `loops_only`.
Status check_meetings(const Model& model, Findings& findings, const Context& context);

/// "face 7"
std::string name_of(EntityRef entity);
/// Three significant digits, as in 1.2e-05.
std::string number(double value);

/// A tolerance with what rounding adds at these coordinates.
double with_rounding(double tolerance, Vec3 p);

/// Where two edges come nearer than `tolerance`, away from the vertices that they share; the deviation there.
struct EdgeMeeting {
  Vec3 place{};
  double distance = 0;
};
std::optional<EdgeMeeting> find_meeting(const Model& model, EdgeId a, EdgeId b, double tolerance);

}  // namespace aresta::model_detail
