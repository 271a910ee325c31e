// SPDX-License-Identifier: Apache-2.0
// Plane-faced models written down by hand, already stitched: vertices and edges with equal coordinates are shared.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "model/builder.h"

namespace aresta::test {

class Stitched {
 public:
  ModelBuilder builder;

  VertexId vertex(Vec3 p) {
    const auto [slot, is_new] = vertices_.try_emplace({p.x, p.y, p.z});
    if (is_new) slot->second = builder.add_vertex(p);
    return slot->second;
  }

  EdgeId edge(Vec3 p, Vec3 q, bool* reversed = nullptr) {
    const VertexId a = vertex(p), b = vertex(q);
    const auto [slot, is_new] = edges_.try_emplace(std::minmax(a, b));
    if (is_new) slot->second = {builder.add_edge(a, b), a};
    if (reversed != nullptr) *reversed = slot->second.second != a;
    return slot->second.first;
  }

  /// Loops: the outer one counterclockwise seen from the normal, then holes, loose edges ({p, q}) and points ({p}).
  FaceId face(const std::vector<std::vector<Vec3>>& loops) {
    const auto& outer = loops.front();
    Vec3 normal{};
    for (std::size_t i = 0; i < outer.size(); ++i)
      normal += cross(outer[i] - outer[0], outer[(i + 1) % outer.size()] - outer[0]);
    const FaceId f = builder.begin_face(builder.add_surface(Plane{Frame::along(outer[0], normal)}), false);
    for (const auto& loop : loops) {
      if (loop.size() == 1) {
        builder.add_point_loop(vertex(loop[0]));
        continue;
      }
      for (std::size_t i = 0; i < loop.size(); ++i) {
        bool reversed = false;
        const EdgeId e = edge(loop[i], loop[(i + 1) % loop.size()], &reversed);
        builder.add_coedge(e, reversed);
      }
      builder.close_loop();
    }
    builder.end_face();
    return f;
  }

  /// The six faces of a box, outward: bottom, top, front (y low), back, left (x low), right.
  std::array<FaceId, 6> box(Vec3 a, Vec3 b) {
    const auto p = [&](int i) {
      return Vec3{(i & 1) != 0 ? b.x : a.x, (i & 2) != 0 ? b.y : a.y, (i & 4) != 0 ? b.z : a.z};
    };
    const auto quad = [&](int i, int j, int k, int l) { return face({{p(i), p(j), p(k), p(l)}}); };
    return {quad(0, 2, 3, 1), quad(4, 5, 7, 6), quad(0, 1, 5, 4), quad(2, 6, 7, 3), quad(0, 4, 6, 2), quad(1, 3, 7, 5)};
  }

  /// Every enclosed cell becomes a region.
  std::shared_ptr<const Model> build_all_filled() {
    const auto cells = builder.find_cells({});
    if (!cells.ok()) {
      ADD_FAILURE() << cells.error().to_line();
      return nullptr;
    }
    std::vector<bool> filled(cells->count, true);
    filled[0] = false;
    auto model = builder.build(*cells, filled);
    if (!model.ok()) {
      ADD_FAILURE() << model.error().to_line();
      return nullptr;
    }
    return std::make_shared<const Model>(std::move(*model));
  }

 private:
  std::map<std::array<double, 3>, VertexId> vertices_;
  std::map<std::pair<VertexId, VertexId>, std::pair<EdgeId, VertexId>> edges_;
};

}  // namespace aresta::test
