// SPDX-License-Identifier: Apache-2.0
#include "planar/entities.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/union_find.h"
#include "planar/edge_sets.h"
#include "planar/point_grid.h"

namespace aresta::planar {

namespace {

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

class Uniting {
 public:
  Uniting(const Soup& soup, double tolerance) : soup_(soup) { result_.tolerance = tolerance; }

  Result<Entities> run() {
    result_.stitched = soup_.stitched;
    Box3 box;
    for (const Vec3 p : soup_.points) box.add(p);
    result_.lattice = Lattice::holding(box);
    ARESTA_CHECK(unite_vertices());
    unite_edges();
    ARESTA_CHECK(unite_faces());
    find_faces_of_edges();
    return std::move(result_);
  }

 private:
  Status unite_vertices() {
    const auto count = static_cast<Index>(soup_.points.size());
    PointGrid grid(result_.tolerance, count);
    UnionFind clusters(count);
    const double limit = result_.tolerance * result_.tolerance;
    for (Index v = 0; v < count; ++v) {
      const Vec3 p = soup_.points[v];
      grid.near(p, [&](Index u) {
        if (norm2(soup_.points[u] - p) <= limit) clusters.unite(u, v);
      });
      grid.add(p);
    }
    vertex_of_.assign(count, none);
    std::vector<IndexPair> members, operands;
    for (Index v = 0; v < count; ++v) {
      const Index root = clusters.find(v);
      if (root == v) {
        vertex_of_[v] = static_cast<Index>(result_.points.size());
        result_.points.push_back(soup_.points[v]);
      } else {
        vertex_of_[v] = vertex_of_[root];
      }
      members.emplace_back(vertex_of_[v], v);
      operands.emplace_back(vertex_of_[v], soup_.vertex_operand[v]);
    }
    result_.shape.vertex_count = static_cast<Index>(result_.points.size());
    result_.vertex_members = group(result_.points.size(), members);
    result_.vertex_operands = distinct(result_.points.size(), operands);
    for (std::size_t v = 0; v < result_.points.size(); ++v) ARESTA_CHECK(check_width(result_.vertex_members[v]));
    return {};
  }

  /// Every two of a cluster must be within the tolerance: else which of them are the same cannot be told.
  Status check_width(std::span<const Index> members) const {
    if (members.size() < 3) return {};
    std::vector<Vec3> apart{soup_.points[members[0]]};  // the different places
    for (const Index m : members) {
      const Vec3 p = soup_.points[m];
      if (std::find(apart.begin(), apart.end(), p) != apart.end()) continue;
      for (const Vec3 q : apart) {
        if (norm2(p - q) > result_.tolerance * result_.tolerance) return too_wide(members);
      }
      apart.push_back(p);
    }
    return {};
  }

  Error too_wide(std::span<const Index> members) const {
    Error error{errors::cluster_too_wide,
                "vertices that coincide one by one are farther apart in all than the tolerance",
                {},
                as_array(soup_.points[members[0]]),
                "a larger --tolerance, so that they become one, or a smaller one"};
    constexpr std::size_t named = 6;
    for (std::size_t i = 0; i < std::min(named, members.size()); ++i) error.entities.push_back(VertexId(members[i]));
    return error;
  }

  void unite_edges() {
    const auto& edges = soup_.shape.edges;
    PairMap known(edges.size());
    coedge_of_.assign(edges.size(), none);
    std::vector<IndexPair> members, operands;
    for (Index e = 0; e < edges.size(); ++e) {
      const Index a = vertex_of_[edges[e][0]], b = vertex_of_[edges[e][1]];
      if (a == b) continue;
      const auto fresh = static_cast<Index>(result_.shape.edges.size());
      const Index one = known.add(std::min(a, b), std::max(a, b), fresh);
      if (one == fresh) result_.shape.edges.push_back({a, b});
      coedge_of_[e] = 2 * one + (result_.shape.edges[one][0] == a ? 0u : 1u);
      members.emplace_back(one, e);
      operands.emplace_back(one, soup_.edge_operand[e]);
    }
    result_.edge_members = group(result_.shape.edges.size(), members);
    result_.edge_operands = distinct(result_.shape.edges.size(), operands);
  }

  Status unite_faces() {
    const Incidence& in = soup_.shape;
    Incidence& out = result_.shape;
    EdgeSets known(in.face_count());
    std::vector<IndexPair> members, operands;
    for (Index f = 0; f < in.face_count(); ++f) {
      const auto first_coedge = static_cast<Index>(out.coedges.size());
      const Index first_loop = out.loop_count(), fresh = out.face_count();
      for (Index l = in.face_begin[f]; l < in.face_begin[f + 1]; ++l) add_loop(l);
      const auto coedges = std::span(std::as_const(out.coedges)).subspan(first_coedge);
      const bool thin = is_thin(coedges);
      Index one = none;
      if (thin) {
        put_on_edges(coedges);
      } else {
        one = known.add(coedges, [&](Index face) { return result_.coedges_of(face); });
        const bool is_new = one == none;
        if (is_new) one = fresh;
        members.emplace_back(one, f);
        operands.emplace_back(one, soup_.face_operand[f]);
        for (Index l = first_loop; l < out.loop_count(); ++l) {
          if (out.loop_vertex[l] != none) result_.vertex_in_face.emplace_back(one, out.loop_vertex[l]);
        }
        if (is_new) {
          out.close_face();
          ARESTA_CHECK(add_plane(fresh, f));
          continue;
        }
      }
      out.coedges.resize(first_coedge);
      out.loop_vertex.resize(first_loop);
      out.loop_begin.resize(first_loop + 1);
    }
    result_.face_members = group(out.face_count(), members);
    result_.face_operands = distinct(out.face_count(), operands);
    return {};
  }

  /// The loop without what has shrunk to a point.
  void add_loop(Index l) {
    const Incidence& in = soup_.shape;
    Incidence& out = result_.shape;
    for (Index c = in.loop_begin[l]; c < in.loop_begin[l + 1]; ++c) {
      const Index code = coedge_of_[in.coedges[c] / 2];
      if (code != none) out.coedges.push_back(code ^ (in.coedges[c] & 1u));
    }
    if (out.coedges.size() > out.loop_begin.back())
      out.close_loop();
    else if (in.loop_begin[l] < in.loop_begin[l + 1])
      out.add_vertex_loop(vertex_of_[in.edges[in.coedges[in.loop_begin[l]] / 2][0]]);
    else
      out.add_vertex_loop(vertex_of_[in.loop_vertex[l]]);
  }

  /// No wider than the tolerance?
  bool is_thin(std::span<const Index> coedges) const {
    if (coedges.empty()) return true;
    const Vec3 origin = start_of(coedges[0]);
    Vec3 area;
    double perimeter = 0;
    for (const Index c : coedges) {
      area += cross(start_of(c) - origin, start_of(c ^ 1u) - origin);
      perimeter += distance(start_of(c), start_of(c ^ 1u));
    }
    return 2 * norm(area) <= result_.tolerance * perimeter;
  }

  Vec3 start_of(Index coedge) const { return result_.points[result_.shape.edges[coedge / 2][coedge % 2]]; }

  /// The vertices of a face that vanishes lie on its edges.
  void put_on_edges(std::span<const Index> coedges) {
    for (const Index c : coedges) {
      const auto [a, b] = result_.shape.edges[c / 2];
      const Vec3 p = result_.points[a], along = result_.points[b] - p;
      for (const Index d : coedges) {
        const Index v = result_.shape.edges[d / 2][d % 2];
        if (v == a || v == b) continue;
        const Vec3 to = result_.points[v] - p;
        const double t = dot(to, along) / norm2(along);
        if (t > 0 && t < 1 && norm(to - t * along) <= 2 * result_.tolerance)
          result_.vertex_on_edge.emplace_back(c / 2, v);
      }
    }
  }

  Status add_plane(Index face, Index soup_face) {
    const Incidence& shape = result_.shape;
    const Vec3 origin = result_.points[shape.edges[result_.coedges_of(face)[0] / 2][0]];
    const std::optional<ExactPlane> exact = result_.exact_plane(face);
    if (!exact) {
      return Error{errors::face_not_planar,
                   "the outer loop of a face has no area: its normal cannot be told",
                   {FaceId(soup_face)},
                   as_array(origin)};
    }
    Plane plane{unit_normal(*exact), origin, 0};
    for (int i = 1; i < 3; ++i) {
      if (std::abs(plane.normal[i]) > std::abs(plane.normal[plane.axis])) plane.axis = i;
    }
    Box3 box;
    double low = 0, high = 0;
    for (const Index c : result_.coedges_of(face)) {
      const Vec3 p = result_.points[shape.edges[c / 2][c % 2]];
      box.add(p);
      low = std::min(low, plane.distance(p));
      high = std::max(high, plane.distance(p));
    }
    if (high - low > 4 * result_.tolerance) {
      return Error{errors::face_not_planar,
                   "the vertices of a face are not in one plane: they are " + std::to_string(high - low) + " apart",
                   {FaceId(soup_face)},
                   as_array(origin),
                   "a larger --tolerance, or triangles"};
    }
    plane.origin += (0.5 * (low + high)) * plane.normal;
    result_.planes.push_back(plane);
    result_.boxes.push_back(box);
    return {};
  }

  void find_faces_of_edges() {
    std::vector<IndexPair> pairs;
    pairs.reserve(result_.shape.coedges.size());
    for (Index f = 0; f < result_.face_count(); ++f) {
      for (const Index c : result_.coedges_of(f)) pairs.emplace_back(c / 2, f);
    }
    result_.faces_of_edge = distinct(result_.edge_count(), pairs);
  }

  /// As group(), sorted and without repetitions.
  static Lists distinct(std::size_t count, std::span<const IndexPair> pairs) {
    Lists all = group(count, pairs), result;
    result.begin.reserve(count + 1);
    result.items.reserve(all.items.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto first = all.items.begin() + all.begin[i], last = all.items.begin() + all.begin[i + 1];
      std::sort(first, last);
      result.items.insert(result.items.end(), first, std::unique(first, last));
      result.begin.push_back(static_cast<Index>(result.items.size()));
    }
    return result;
  }

  const Soup& soup_;
  Entities result_;
  std::vector<Index> vertex_of_, coedge_of_;
};

}  // namespace

std::optional<ExactPlane> Entities::exact_plane(Index face) const {
  constexpr std::size_t most = std::size_t{1} << 16;  // that the exact sum takes
  const Index first = shape.loop_begin[shape.face_begin[face]], last = shape.loop_begin[shape.face_begin[face] + 1];
  const auto vertex = [&](Index c) { return shape.edges[shape.coedges[c] / 2][shape.coedges[c] % 2]; };
  if (last - first == 3)
    return plane_through(lattice_point(vertex(first)), lattice_point(vertex(first + 1)),
                         lattice_point(vertex(first + 2)));
  if (last - first <= most) {
    std::array<LatticePoint, 16> few;
    std::vector<LatticePoint> many;
    std::span<LatticePoint> outer(few.data(), std::min<std::size_t>(few.size(), last - first));
    if (last - first > few.size()) {
      many.resize(last - first);
      outer = many;
    }
    for (Index c = first; c < last; ++c) outer[c - first] = lattice_point(vertex(c));
    return plane_of_polygon(outer);
  }
  // Too many to sum: three that are far apart, turned as the sum in doubles is.
  const Vec3 origin = points[vertex(first)];
  Vec3 area;
  Index far = first, off = first;
  for (Index c = first; c < last; ++c) {
    const auto [a, b] = shape.edges[shape.coedges[c] / 2];
    const Vec3 s = cross(points[a] - origin, points[b] - origin);
    area += shape.coedges[c] % 2 == 0 ? s : -s;
    if (norm2(points[vertex(c)] - origin) > norm2(points[vertex(far)] - origin)) far = c;
  }
  const Vec3 along = points[vertex(far)] - origin;
  for (Index c = first; c < last; ++c) {
    if (norm2(cross(points[vertex(c)] - origin, along)) > norm2(cross(points[vertex(off)] - origin, along))) off = c;
  }
  auto plane = plane_through(lattice_point(vertex(first)), lattice_point(vertex(far)), lattice_point(vertex(off)));
  if (plane && dot(plane->rounded_normal(), area) < 0) return flipped(*plane);
  return plane;
}

bool Entities::share_operand(std::span<const Index> a, std::span<const Index> b) const {
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] == b[j]) {
      if (stitched[a[i]]) return true;
      ++i, ++j;
    } else {
      a[i] < b[j] ? ++i : ++j;
    }
  }
  return false;
}

Result<Entities> unite(const Soup& soup, double tolerance) {
  return Uniting(soup, tolerance).run();
}

}  // namespace aresta::planar
