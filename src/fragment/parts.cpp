// SPDX-License-Identifier: Apache-2.0
#include "fragment/parts.h"

#include <algorithm>

#include "model/check.h"
#include "model/inherit.h"

namespace aresta {

namespace {

bool is_unshared_contact(const Finding& finding) {
  switch (finding.kind) {
    case FindingKind::duplicate_edge:
    case FindingKind::vertices_coincide:
    case FindingKind::edges_coincide:
    case FindingKind::faces_intersect:
    case FindingKind::edge_crosses_face:
    case FindingKind::region_inverted:
      return true;
    default:
      return false;
  }
}

}  // namespace

Result<std::vector<ModelPart>> split_into_parts(const Model& model) {
  const Complex& k = model.topology();
  std::vector<ModelPart> parts;
  const auto add = [&](Selection& keep) -> Status {
    close_downwards(model, keep, true);
    ARESTA_TRY(Extraction part, extract(model, keep));
    copy_labels(model, part.from, part.model);
    parts.push_back({std::make_shared<const Model>(std::move(part.model)), std::move(part.from)});
    return {};
  };
  Selection rest = empty_selection(model);
  rest.faces.assign(k.face_count(), true);
  for (const EdgeId e : k.edges()) rest.edges[e.index()] = k.is_wire(e);
  for (const VertexId v : k.vertices()) rest.vertices[v.index()] = k.isolated_in_shell(v).valid();
  for (const RegionId r : model.regions()) {
    Selection keep = empty_selection(model);
    keep.filled[r.index()] = true;
    for (const ShellId s : k.shells(r)) {
      for (const FaceUse u : k.face_uses(s)) {
        keep.faces[u.face().index()] = true;
        rest.faces[u.face().index()] = false;
      }
    }
    ARESTA_CHECK(add(keep));
  }
  const auto any = [](const std::vector<bool>& kept) {
    return std::find(kept.begin(), kept.end(), true) != kept.end();
  };
  if (any(rest.faces) || any(rest.edges) || any(rest.vertices)) ARESTA_CHECK(add(rest));
  return parts;
}

Result<bool> meets_unshared(const Model& model, const Context& context) {
  ARESTA_TRY(const auto findings, check(model, CheckLevel::full, context));
  return std::any_of(findings.begin(), findings.end(), is_unshared_contact);
}

}  // namespace aresta
