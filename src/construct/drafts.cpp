// SPDX-License-Identifier: Apache-2.0
#include "construct/drafts.h"

#include <algorithm>

namespace aresta {

void turn_over(FaceDraft& face) {
  face.reversed = !face.reversed;
  std::swap(face.front, face.back);
  for (LoopDraft& loop : face.loops) {
    std::reverse(loop.coedges.begin(), loop.coedges.end());
    for (CoedgeDraft& c : loop.coedges) c.reversed = !c.reversed;
  }
}

FaceId add_face(ModelBuilder& builder, const FaceDraft& face) {
  const FaceId id = builder.begin_face(face.surface, face.reversed, face.tolerance);
  for (const LoopDraft& loop : face.loops) {
    if (loop.vertex.valid()) {
      builder.add_point_loop(loop.vertex);
      continue;
    }
    for (const CoedgeDraft& c : loop.coedges) {
      if (c.pcurve) {
        builder.add_coedge(c.edge, c.reversed, *c.pcurve);
      } else {
        builder.add_coedge(c.edge, c.reversed);
      }
    }
    builder.close_loop();
  }
  builder.end_face();
  builder.set_fill(face.front, face.back);
  builder.set_constraint(face.constraint);
  return id;
}

Cells one_solid(std::size_t faces, std::size_t edges, std::size_t vertices) {
  Cells cells;
  cells.count = 2;
  cells.of_face_use.resize(2 * faces);
  for (std::size_t u = 0; u < cells.of_face_use.size(); ++u) cells.of_face_use[u] = u % 2;
  cells.of_edge.assign(edges, Incidence::none);
  cells.of_vertex.assign(vertices, Incidence::none);
  return cells;
}

Cells no_solid(std::size_t faces, const std::vector<bool>& wire, const std::vector<bool>& isolated) {
  Cells cells;
  cells.of_face_use.assign(2 * faces, 0);
  for (const bool w : wire) cells.of_edge.push_back(w ? 0 : Incidence::none);
  for (const bool v : isolated) cells.of_vertex.push_back(v ? 0 : Incidence::none);
  return cells;
}

}  // namespace aresta
