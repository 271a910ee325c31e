// SPDX-License-Identifier: Apache-2.0
#include "topology/fans.h"

#include "topology/item.h"

namespace aresta {

UnionFind side_surfaces(const Complex& k) {
  UnionFind sides(2 * k.face_bound());
  for_each_sector(k, [&](CoedgeId c, CoedgeId d) { sides.unite(k.side_after(c).index(), k.side_before(d).index()); });
  return sides;
}

UnionFind face_parts(const Complex& k) {
  UnionFind faces(k.face_bound());
  for_each_sector(k, [&](CoedgeId c, CoedgeId d) { faces.unite(k.face(c).index(), k.face(d).index()); });
  return faces;
}

UnionFind fans(const Complex& k) {
  UnionFind corners(2 * k.coedge_bound());
  for_each_sector(k, [&](CoedgeId c, CoedgeId d) {
    const auto after = static_cast<std::size_t>(k.side_after(c).side()),
               before = static_cast<std::size_t>(k.side_before(d).side());
    for (int end = 0; end < 2; ++end) {
      corners.unite(2 * corner_at(k, c, end).index() + after, 2 * corner_at(k, d, end).index() + before);
    }
  });
  return corners;
}

UnionFind components(const Complex& k) {
  UnionFind vertices(k.vertex_bound());
  for (const EdgeId e : k.edges()) vertices.unite(k.start(e).index(), k.end(e).index());
  for (const FaceId f : k.faces()) {
    VertexId first;
    for (const LoopId l : k.loops(f)) {
      const VertexId v = k.is_vertex_loop(l) ? k.loop_vertex(l) : k.start(k.first_coedge(l));
      if (first.valid()) vertices.unite(first.index(), v.index());
      first = v;
    }
  }
  return vertices;
}

}  // namespace aresta
