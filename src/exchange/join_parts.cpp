// SPDX-License-Identifier: Apache-2.0
#include "exchange/join_parts.h"

#include <algorithm>

#include "fragment/fragment.h"
#include "model/extract.h"
#include "model/inherit.h"

namespace aresta {

namespace {

bool is_unshared_contact(const Finding& finding) {
  switch (finding.kind) {
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

Result<std::shared_ptr<const Model>> part_of(const Model& model, Selection& keep) {
  close_downwards(model, keep, true);
  ARESTA_TRY(Extraction part, extract(model, keep));
  copy_labels(model, part.from, part.model);
  return std::shared_ptr<const Model>(std::make_shared<const Model>(std::move(part.model)));
}

/// One part per region, with its faces and what lies inside it; the rest is the last part.
Result<std::vector<std::shared_ptr<const Model>>> split(const Model& model) {
  const Complex& k = model.topology();
  std::vector<std::shared_ptr<const Model>> parts;
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
      for (const EdgeId e : k.wires(s)) {
        keep.edges[e.index()] = true;
        rest.edges[e.index()] = false;
      }
      if (const VertexId v = k.shell_vertex(s); v.valid()) {
        keep.vertices[v.index()] = true;
        rest.vertices[v.index()] = false;
      }
    }
    ARESTA_TRY(auto part, part_of(model, keep));
    parts.push_back(std::move(part));
  }
  const auto any = [](const std::vector<bool>& kept) {
    return std::find(kept.begin(), kept.end(), true) != kept.end();
  };
  if (any(rest.faces) || any(rest.edges) || any(rest.vertices)) {
    ARESTA_TRY(auto part, part_of(model, rest));
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

Result<Model> join_touching_parts(Model model, ImportReport& report, const Context& context) {
  if (model.regions().size() < 2) return model;
  ARESTA_TRY(const auto findings, check(model, CheckLevel::full, context));
  if (std::none_of(findings.begin(), findings.end(), is_unshared_contact)) return model;
  ARESTA_TRY(auto parts, split(model));
  FragmentOptions options;
  options.detect_regions = false;
  ARESTA_TRY(const Fragment joined, fragment(std::move(parts), options, context));
  Model result = *joined.model;
  result.provenance = nullptr;
  result.length_unit = model.length_unit;
  report.notes.push_back("parts that touch were joined, so that they share what they have in common");
  return result;
}

}  // namespace aresta
