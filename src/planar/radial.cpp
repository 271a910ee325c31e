// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "planar/cells.h"

namespace aresta::planar {

namespace {

/// Below this angle, in radians, two faces point the same way: a millionth of the least that a tolerance leaves apart.
constexpr double same_direction = 1e-15;

struct Spoke {
  Index coedge = none;
  Index face = none;
  Vec3 into;  // into the face, at right angles to the edge
  bool first_half = true;
};

}  // namespace

Status order_radially(const PlaneFaces& faces, Incidence& shape) {
  const auto coedge_count = static_cast<Index>(shape.coedges.size());
  shape.radial_next.assign(coedge_count, none);
  std::vector<Index> face_of(coedge_count);
  std::vector<IndexPair> pairs;
  pairs.reserve(coedge_count);
  for (Index f = 0; f < shape.face_count(); ++f) {
    const Index first = shape.loop_begin[shape.face_begin[f]], last = shape.loop_begin[shape.face_begin[f + 1]];
    for (Index c = first; c < last; ++c) {
      face_of[c] = f;
      pairs.emplace_back(shape.coedges[c] / 2, c);
    }
  }
  const Lists uses = group(shape.edge_count(), pairs);
  std::vector<Spoke> spokes;
  for (Index e = 0; e < shape.edge_count(); ++e) {
    const auto list = uses[e];
    if (list.size() <= 2) {  // there is but one order
      for (std::size_t i = 0; i < list.size(); ++i) shape.radial_next[list[i]] = list[(i + 1) % list.size()];
      continue;
    }
    const Vec3 along = normalized(faces.points[shape.edges[e][1]] - faces.points[shape.edges[e][0]]);
    spokes.clear();
    for (const Index c : list) {
      const Vec3 n = faces.planes[face_of[c]].normal, into = cross(n, along);
      spokes.push_back({c, face_of[c], shape.coedges[c] % 2 == 0 ? into : -into, true});
    }
    // Angles are counted from the first.
    const Vec3 zero = spokes[0].into;
    const auto turn = [&](Vec3 a, Vec3 b) { return dot(cross(a, b), along); };
    for (Spoke& s : spokes) {
      const double sine = turn(zero, s.into);
      s.first_half = std::abs(sine) <= same_direction ? dot(zero, s.into) > 0 || sine > 0 : sine > 0;
    }
    std::sort(spokes.begin() + 1, spokes.end(), [&](const Spoke& a, const Spoke& b) {
      if (a.first_half != b.first_half) return a.first_half;
      const double t = turn(a.into, b.into);
      return t != 0 ? t > 0 : a.coedge < b.coedge;
    });
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      const Spoke &a = spokes[i], &b = spokes[(i + 1) % spokes.size()];
      if (std::abs(turn(a.into, b.into)) <= same_direction && dot(a.into, b.into) > 0) {
        const Vec3 p = faces.points[shape.edges[e][0]];
        return Error{errors::faces_coincide,
                     "two faces leave an edge in the same direction",
                     {EdgeId(e), FaceId(a.face), FaceId(b.face)},
                     {{p.x, p.y, p.z}},
                     "a larger --tolerance, so that they become one"};
      }
      shape.radial_next[a.coedge] = b.coedge;
    }
  }
  return {};
}

}  // namespace aresta::planar
