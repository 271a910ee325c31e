// SPDX-License-Identifier: Apache-2.0
#include "planar/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/union_find.h"
#include "math/directions.h"
#include "math/plane_triangulation.h"
#include "planar/active_triangles.h"
#include "planar/cells.h"
#include "planar/edge_sets.h"
#include "planar/imprint.h"
#include "topology/polygon_mesh.h"

namespace aresta::planar {

namespace {

using Triangle = std::array<Index, 3>;

enum class Side : std::uint8_t { unknown, outside, inside };

/// Six times the volume towards the origin of coordinates `o`.
double volume6(const TriangleMesh& mesh, Vec3 o) {
  double sum = 0;
  for (const auto& [i, j, k] : mesh.triangles)
    sum += dot(mesh.points[i] - o, cross(mesh.points[j] - o, mesh.points[k] - o));
  return sum;
}

/// A sum over directed edges that is zero when each runs as often one way as the other, and else next to never.
std::uint64_t boundary_hash(const TriangleMesh& mesh) {
  const auto edge = [](Index a, Index b) {
    const std::uint64_t h = edge_hash(std::uint64_t{std::max(a, b)} << 32 | std::min(a, b));
    return a < b ? h : 0 - h;
  };
  std::uint64_t sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) sum += edge(i, j) + edge(j, k) + edge(k, i);
  return sum;
}

Error mesh_is_open(const TriangleMesh& mesh, const char* which) {
  std::vector<IndexPair> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& [a, b] : edges) {
    const auto there = std::equal_range(edges.begin(), edges.end(), IndexPair{a, b});
    const auto back = std::equal_range(edges.begin(), edges.end(), IndexPair{b, a});
    if (there.second - there.first == back.second - back.first) continue;
    const Vec3 p = 0.5 * (mesh.points[a] + mesh.points[b]);
    return Error{errors::mesh_open,
                 std::string(which) + " mesh is not closed: a side from vertex " + std::to_string(a) + " to vertex " +
                     std::to_string(b) + " has no other beside it",
                 {VertexId(a), VertexId(b)},
                 {{p.x, p.y, p.z}},
                 "close its holes, or use it as a sheet"};
  }
  return Error{errors::mesh_open, std::string(which) + " mesh is not closed"};
}

class Combining {
 public:
  Combining(const TriangleMesh& a, const TriangleMesh& b, MeshOperation operation, const MeshOptions& options,
            const Context& context)
      : mesh_{&a, &b}, operation_(operation), context_(context) {
    for (const TriangleMesh* m : mesh_) {
      for (const Vec3 p : m->points) box_.add(p);
    }
    tolerance_ = options.tolerance > 0 ? options.tolerance : 1e-9 * box_.diagonal();
  }

  Result<CombinedMesh> run() {
    ARESTA_CHECK(check_input());
    ARESTA_CHECK(context_.step(0.1, "finding triangles that may touch"));
    active_ = active_triangles(*mesh_[0], *mesh_[1], tolerance_);
    make_soup();
    ARESTA_TRY(pieces_, imprint(soup_, tolerance_, context_));
    ARESTA_CHECK(order_radially(pieces_.faces(), pieces_.shape));
    ARESTA_CHECK(context_.step(0.8, "telling inside from outside"));
    read_owners();
    unite_parts();
    ARESTA_CHECK(label_at_crossings());
    ARESTA_CHECK(label_the_rest());
    ARESTA_CHECK(context_.step(0.9, "collecting triangles"));
    number_points();
    ARESTA_CHECK(collect());
    return finish();
  }

 private:
  static constexpr std::uint8_t in_a = 1, in_b = 2;

  Status check_input() {
    for (int m = 0; m < 2; ++m) {
      for (const Vec3 p : mesh_[m]->points) {
        if (!is_finite(p))
          return Error{errors::invalid_argument, "a vertex of a mesh has a coordinate that is not a finite number"};
      }
      const auto count = static_cast<Index>(mesh_[m]->points.size());
      for (const Triangle& t : mesh_[m]->triangles) {
        if (t[0] >= count || t[1] >= count || t[2] >= count)
          return Error{errors::invalid_argument, "a triangle has a vertex that its mesh does not have"};
      }
      if (boundary_hash(*mesh_[m]) != 0) return mesh_is_open(*mesh_[m], m == 0 ? "the first" : "the second");
    }
    return {};
  }

  /// The active triangles of both as a soup of two operands.
  void make_soup() {
    Incidence& shape = soup_.shape;
    for (Index m = 0; m < 2; ++m) {
      const auto first = static_cast<Index>(soup_.points.size());
      std::vector<Index> soup_vertex(mesh_[m]->points.size(), none), corners;
      for (const Index t : active_[m]) {
        for (const Index v : mesh_[m]->triangles[t]) {
          if (soup_vertex[v] == none) {
            soup_vertex[v] = static_cast<Index>(soup_.points.size()) - first;
            soup_.points.push_back(mesh_[m]->points[v]);
            mesh_vertex_.push_back(v);
          }
          corners.push_back(soup_vertex[v]);
        }
      }
      std::vector<Index> begin(active_[m].size() + 1);
      for (std::size_t i = 0; i < begin.size(); ++i) begin[i] = static_cast<Index>(3 * i);
      const Index first_edge = shape.edge_count();
      const auto edges = edges_of_polygons(static_cast<Index>(soup_.points.size()) - first, corners, begin);
      for (const auto& [a, b] : edges.edges) shape.edges.push_back({first + a, first + b});
      for (std::size_t c = 0; c < corners.size(); ++c) {
        shape.add_coedge(first_edge + edges.of_corner[c], edges.edges[edges.of_corner[c]][0] != corners[c]);
        if (c % 3 == 2) {
          shape.close_loop();
          shape.close_face();
        }
      }
      soup_.vertex_operand.resize(soup_.points.size(), m);
      soup_.edge_operand.resize(shape.edge_count(), m);
      soup_.face_operand.resize(shape.face_count(), m);
    }
    shape.vertex_count = static_cast<Index>(soup_.points.size());
    soup_.stitched = {true, true};
  }

  /// visit(t) for every triangle that touches nothing of the other mesh.
  template <class Visit>
  void for_each_plain(Index m, Visit&& visit) const {
    std::size_t next = 0;
    for (Index t = 0; t < mesh_[m]->triangles.size(); ++t) {
      if (next < active_[m].size() && active_[m][next] == t)
        ++next;
      else
        visit(t);
    }
  }

  // ---- whose a piece is ----

  /// The soup's face a piece came from, of one operand; none when it is not that operand's.
  Index soup_face(Index piece, Index operand) const {
    const Index before = static_cast<Index>(soup_.points.size()) + soup_.shape.edge_count();
    for (const Index name : pieces_.face_names[piece]) {
      if (soup_.face_operand[name - before] == operand) return name - before;
    }
    return none;
  }

  /// The triangle of mesh `operand` that a face of the soup is.
  Index triangle(Index soup_face, Index operand) const {
    return active_[operand][operand == 0 ? soup_face : soup_face - static_cast<Index>(active_[0].size())];
  }

  Vec3 normal_of(Index operand, Index t) const {
    const auto& [i, j, k] = mesh_[operand]->triangles[t];
    const auto& p = mesh_[operand]->points;
    return cross(p[j] - p[i], p[k] - p[i]);
  }

  void read_owners() {
    const Index count = pieces_.shape.face_count();
    owner_.assign(count, 0);
    opposite_.assign(count, {false, false});
    for (Index f = 0; f < count; ++f) {
      for (Index m = 0; m < 2; ++m) {
        const Index from = soup_face(f, m);
        if (from == none) continue;
        owner_[f] |= static_cast<std::uint8_t>(1u << m);
        opposite_[f][m] = dot(normal_of(m, triangle(from, m)), pieces_.planes[f].normal) < 0;
      }
    }
    vertex_owner_.assign(pieces_.points.size(), 0);
    const auto vertices = static_cast<Index>(soup_.points.size());
    for (Index v = 0; v < pieces_.points.size(); ++v) {
      for (const Index name : pieces_.vertex_names[v]) {
        const Index operand = name < vertices ? soup_.vertex_operand[name]
                              : name < vertices + soup_.shape.edge_count()
                                  ? soup_.edge_operand[name - vertices]
                                  : soup_.face_operand[name - vertices - soup_.shape.edge_count()];
        vertex_owner_[v] |= static_cast<std::uint8_t>(1u << operand);
      }
    }
  }

  // ---- what hangs together ----

  Index vertex_node(Index operand, Index mesh_vertex) const {
    return pieces_.shape.face_count() + (operand == 0 ? 0 : static_cast<Index>(mesh_[0]->points.size())) + mesh_vertex;
  }

  void unite_parts() {
    parts_ = UnionFind(pieces_.shape.face_count() + mesh_[0]->points.size() + mesh_[1]->points.size());
    for (Index m = 0; m < 2; ++m) {
      for_each_plain(m, [&](Index t) {
        const auto& [i, j, k] = mesh_[m]->triangles[t];
        parts_.unite(vertex_node(m, i), vertex_node(m, j));
        parts_.unite(vertex_node(m, i), vertex_node(m, k));
      });
    }
    const Incidence& shape = pieces_.shape;
    std::vector<IndexPair> uses;
    std::vector<std::uint8_t> edge_owner(shape.edge_count(), 0);
    face_of_.resize(shape.coedges.size());
    for (Index f = 0; f < shape.face_count(); ++f) {
      for (Index c = first_coedge(f); c < first_coedge(f + 1); ++c) {
        face_of_[c] = f;
        edge_owner[shape.coedges[c] / 2] |= owner_[f];
        uses.emplace_back(shape.coedges[c] / 2, c);
        // A vertex that the other surface does not touch holds together all that is around it.
        const Index v = shape.edges[shape.coedges[c] / 2][shape.coedges[c] % 2];
        const auto names = pieces_.vertex_names[v];
        const Index m = owner_[f] == in_a ? 0 : 1;
        if (owner_[f] != (in_a | in_b) && vertex_owner_[v] == owner_[f] && names.front() < soup_.points.size())
          parts_.unite(f, vertex_node(m, mesh_vertex_[names.front()]));
      }
    }
    uses_ = group(shape.edge_count(), uses);
    for (Index e = 0; e < shape.edge_count(); ++e) {
      if (edge_owner[e] != in_a && edge_owner[e] != in_b) continue;
      for (const Index c : uses_[e]) parts_.unite(face_of_[uses_[e].front()], face_of_[c]);
    }
    edge_owner_ = std::move(edge_owner);
  }

  Index first_coedge(Index f) const { return pieces_.shape.loop_begin[pieces_.shape.face_begin[f]]; }

  // ---- inside or outside ----

  Status set(Index node, Side side, Vec3 at) {
    Side& known = side_[parts_.find(node)];
    if (known == Side::unknown) known = side;
    if (known != side) {
      return Error{errors::mesh_inconsistent,
                   "a part of one mesh lies both inside and outside the other: one of them meets itself",
                   {},
                   {{at.x, at.y, at.z}},
                   "resolve the mesh's own intersections first"};
    }
    return {};
  }

  /// Around an edge of both surfaces: the next face of the other one, counterclockwise, tells the side.
  Status label_at_crossings() {
    side_.assign(parts_.size(), Side::unknown);
    const Incidence& shape = pieces_.shape;
    for (Index e = 0; e < shape.edge_count(); ++e) {
      if (edge_owner_[e] != (in_a | in_b)) continue;
      for (const Index c : uses_[e]) {
        const Index f = face_of_[c];
        if (owner_[f] == (in_a | in_b)) continue;
        const Index other = owner_[f] == in_a ? 1 : 0;
        Index d = shape.radial_next[c];
        while (d != c && (owner_[face_of_[d]] & (1u << other)) == 0) d = shape.radial_next[d];
        if (d == c) continue;  // the other surface has but an edge here, of faces that were too thin
        // Before a coedge that runs along the edge lies the back of its face.
        const bool back = shape.coedges[d] % 2 == 0, inside = back != opposite_[face_of_[d]][other];
        ARESTA_CHECK(set(f, inside ? Side::inside : Side::outside, pieces_.points[shape.edges[e][0]]));
      }
    }
    return {};
  }

  /// Parts that hang on no crossing: a ray from a point of each.
  Status label_the_rest() {
    for (Index f = 0; f < pieces_.shape.face_count(); ++f) {
      if (owner_[f] == (in_a | in_b)) continue;
      // The middle of an edge that the other surface does not have is not on it; a corner may be.
      for (Index c = first_coedge(f); c < first_coedge(f + 1); ++c) {
        const Index e = pieces_.shape.coedges[c] / 2;
        if (edge_owner_[e] != owner_[f]) continue;
        const auto [v, w] = pieces_.shape.edges[e];
        ARESTA_CHECK(label_by_ray(f, owner_[f] == in_a ? 0 : 1, 0.5 * (pieces_.points[v] + pieces_.points[w])));
        break;
      }
    }
    for (Index m = 0; m < 2; ++m) {
      Status status;
      for_each_plain(m, [&](Index t) {
        const Index v = mesh_[m]->triangles[t][0];
        if (status.ok() && side_[parts_.find(vertex_node(m, v))] == Side::unknown)
          status = label_by_ray(vertex_node(m, v), m, mesh_[m]->points[v]);
      });
      ARESTA_CHECK(status);
    }
    return {};
  }

  Status label_by_ray(Index node, Index operand, Vec3 p) {
    if (side_[parts_.find(node)] != Side::unknown) return {};
    const TriangleMesh& other = *mesh_[1 - operand];
    constexpr int most_rays = 16;
    for (int i = 0; i < most_rays; ++i) {
      const Vec3 direction = general_direction(i, most_rays);
      bool inside = false, doubtful = false;
      for (const auto& [a, b, c] : other.triangles) {
        const int hit = crosses(other.points[a] - p, other.points[b] - p, other.points[c] - p, direction);
        inside = inside != (hit == 1);
        doubtful = doubtful || hit < 0;
      }
      if (!doubtful) return set(node, inside ? Side::inside : Side::outside, p);
    }
    return Error{errors::nesting_undecided,
                 "no ray decides whether a part of one mesh lies inside the other",
                 {},
                 {{p.x, p.y, p.z}}};
  }

  /// 1 when the ray from the origin crosses the triangle, 0 when it does not, -1 when that is too close to call: when
  /// it passes an edge within the rounding of the products that tell. The origin is not on the triangle.
  int crosses(Vec3 a, Vec3 b, Vec3 c, Vec3 direction) const {
    const double size = box_.diagonal(), margin = 1e-13 * size * size;
    const double u = dot(direction, cross(a, b)), v = dot(direction, cross(b, c)), w = dot(direction, cross(c, a));
    const bool left = u > margin || v > margin || w > margin, right = u < -margin || v < -margin || w < -margin;
    if (left && right) return 0;
    const double ahead = std::max({dot(a, direction), dot(b, direction), dot(c, direction)});
    if (ahead < 0) return 0;
    if (std::min({std::abs(u), std::abs(v), std::abs(w)}) <= margin) return -1;
    const Vec3 normal = cross(b - a, c - a);
    return (dot(a, normal) > 0) == (dot(direction, normal) > 0) ? 1 : 0;
  }

  // ---- the result ----

  bool keeps(Index operand, Side side) const {
    switch (operation_) {
      case MeshOperation::unite:
        return side == Side::outside;
      case MeshOperation::intersect:
        return side == Side::inside;
      default:
        return (side == Side::outside) == (operand == 0);
    }
  }
  bool flips(Index operand) const { return operation_ == MeshOperation::subtract && operand == 1; }

  /// Points are numbered: those of a, those of b, then new ones; those that are one have one number.
  void number_points() {
    const auto a = static_cast<Index>(mesh_[0]->points.size()), b = static_cast<Index>(mesh_[1]->points.size());
    point_of_b_.resize(b);
    for (Index v = 0; v < b; ++v) point_of_b_[v] = a + v;
    point_of_vertex_.resize(pieces_.points.size());
    Index fresh = a + b;
    for (Index v = 0; v < pieces_.points.size(); ++v) {
      const auto names = pieces_.vertex_names[v];
      const Index first = names.front();
      if (first >= soup_.points.size()) {
        point_of_vertex_[v] = fresh++;
        new_points_.push_back(pieces_.points[v]);
        continue;
      }
      point_of_vertex_[v] = soup_.vertex_operand[first] == 0 ? mesh_vertex_[first] : a + mesh_vertex_[first];
      for (const Index name : names) {
        if (name < soup_.points.size() && soup_.vertex_operand[name] == 1)
          point_of_b_[mesh_vertex_[name]] = point_of_vertex_[v];
      }
    }
  }

  Vec3 point(Index number) const {
    const std::size_t a = mesh_[0]->points.size(), b = mesh_[1]->points.size();
    return number < a       ? mesh_[0]->points[number]
           : number < a + b ? mesh_[1]->points[number - a]
                            : new_points_[number - a - b];
  }

  void add(Triangle t, bool flipped, Index source) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;  // shrunk to an edge by identity
    if (flipped) std::swap(t[1], t[2]);
    result_.mesh.triangles.push_back(t);
    result_.source.push_back(source);
  }

  Status collect() {
    const auto a_count = static_cast<Index>(mesh_[0]->triangles.size());
    for (Index m = 0; m < 2; ++m) {
      for_each_plain(m, [&](Index t) {
        Triangle corners = mesh_[m]->triangles[t];
        if (!keeps(m, side_[parts_.find(vertex_node(m, corners[0]))])) return;
        if (m == 1) {
          for (Index& v : corners) v = point_of_b_[v];
        }
        add(corners, flips(m), m == 0 ? t : a_count + t);
      });
    }
    for (Index f = 0; f < pieces_.shape.face_count(); ++f) {
      if (owner_[f] == (in_a | in_b)) {
        const bool alike = opposite_[f][0] == opposite_[f][1];
        if (alike == (operation_ == MeshOperation::subtract)) continue;
        ARESTA_CHECK(add_piece(f, 0, opposite_[f][0]));
      } else {
        const Index m = owner_[f] == in_a ? 0 : 1;
        if (!keeps(m, side_[parts_.find(f)])) continue;
        ARESTA_CHECK(add_piece(f, m, opposite_[f][m] != flips(m)));
      }
    }
    return {};
  }

  Status add_piece(Index f, Index operand, bool flipped) {
    const Index t = triangle(soup_face(f, operand), operand);
    const Index source = operand == 0 ? t : static_cast<Index>(mesh_[0]->triangles.size()) + t;
    const Incidence& shape = pieces_.shape;
    const auto start = [&](Index c) { return shape.edges[shape.coedges[c] / 2][shape.coedges[c] % 2]; };
    const Index first = first_coedge(f), last = first_coedge(f + 1);
    if (last - first == 3 && shape.face_begin[f + 1] - shape.face_begin[f] == 1) {
      add({point_of_vertex_[start(first)], point_of_vertex_[start(first + 1)], point_of_vertex_[start(first + 2)]},
          flipped, source);
      return {};
    }
    const Plane& plane = pieces_.planes[f];
    PlaneInput input;
    std::vector<Index> vertices;
    const auto local = [&](Index v) {
      const auto at = std::find(vertices.begin(), vertices.end(), v);
      if (at != vertices.end()) return static_cast<Index>(at - vertices.begin());
      vertices.push_back(v);
      input.points.push_back(plane.flat(pieces_.points[v] - plane.origin));
      return static_cast<Index>(vertices.size() - 1);
    };
    for (Index c = first; c < last; ++c) {
      const Index v = local(start(c));
      input.segments.push_back({v, local(shape.edges[shape.coedges[c] / 2][1 - shape.coedges[c] % 2])});
    }
    for (Index l = shape.face_begin[f]; l < shape.face_begin[f + 1]; ++l) {
      if (shape.loop_vertex[l] != none) local(shape.loop_vertex[l]);
    }
    const PlaneOutput output = triangulate_plane(input);
    if (output.bad_point && is_sliver(f)) {  // any triangles will do: all are within the tolerance
      for (Index c = first + 1; c + 1 < last; ++c)
        add({point_of_vertex_[start(first)], point_of_vertex_[start(c)], point_of_vertex_[start(c + 1)]}, flipped,
            source);
      return {};
    }
    if (output.bad_point) {
      const Vec3 p = pieces_.points[vertices[*output.bad_point]];
      return Error{errors::mesh_inconsistent,
                   "a piece of a triangle is too thin to be cut into triangles",
                   {},
                   {{p.x, p.y, p.z}},
                   "a larger --tolerance"};
    }
    for (const auto& [i, j, k] : output.triangles)
      add({point_of_vertex_[vertices[i]], point_of_vertex_[vertices[j]], point_of_vertex_[vertices[k]]}, flipped,
          source);
    return {};
  }

  /// One loop about no more than a few tolerances times its length?
  bool is_sliver(Index f) const {
    const Incidence& shape = pieces_.shape;
    if (shape.face_begin[f + 1] - shape.face_begin[f] != 1) return false;
    const auto at = [&](Index c, Index end) {
      return pieces_.points[shape.edges[shape.coedges[c] / 2][(shape.coedges[c] + end) % 2]];
    };
    const Vec3 o = at(first_coedge(f), 0);
    Vec3 area;
    double perimeter = 0;
    for (Index c = first_coedge(f); c < first_coedge(f + 1); ++c) {
      area += cross(at(c, 0) - o, at(c, 1) - o);
      perimeter += distance(at(c, 0), at(c, 1));
    }
    return norm(area) <= 16 * tolerance_ * perimeter;
  }

  Result<CombinedMesh> finish() {
    std::vector<Index> final_point(mesh_[0]->points.size() + mesh_[1]->points.size() + new_points_.size(), none);
    for (const Triangle& t : result_.mesh.triangles) {
      for (const Index v : t) final_point[v] = 0;
    }
    for (Index v = 0; v < final_point.size(); ++v) {
      if (final_point[v] == none) continue;
      final_point[v] = static_cast<Index>(result_.mesh.points.size());
      result_.mesh.points.push_back(point(v));
    }
    for (Triangle& t : result_.mesh.triangles) {
      for (Index& v : t) v = final_point[v];
    }
    ARESTA_CHECK(check_result());
    result_.imprinted = active_[0].size() + active_[1].size();
    result_.stages = pieces_.stages;
    return std::move(result_);
  }

  Status check_result() {
    if (boundary_hash(result_.mesh) != 0)
      return Error{errors::mesh_inconsistent,
                   "the result is not closed: " + mesh_is_open(result_.mesh, "its").to_line()};
    const Vec3 o = box_.centre();
    const double one = volume6(*mesh_[0], o), two = volume6(*mesh_[1], o), got = volume6(result_.mesh, o);
    result_.volume = got / 6;
    // What is not kept of both makes the other half of the identity: V(a) + V(b) is the volume of all pieces.
    const double common = common_volume6(o);
    const double expected = operation_ == MeshOperation::unite       ? one + two - common
                            : operation_ == MeshOperation::intersect ? common
                                                                     : one - common;
    const double size = box_.diagonal(), allowed = 6 * size * size * (1e-12 * size + 16 * tolerance_);
    if (!(std::abs(got - expected) <= allowed)) {
      return Error{errors::mesh_inconsistent,
                   "the volume of the result, " + std::to_string(got / 6) +
                       ", is not what the parts inside the other mesh leave: " + std::to_string(expected / 6)};
    }
    return {};
  }

  /// Six times the volume of what lies in both, from the pieces themselves: not by way of the result.
  double common_volume6(Vec3 o) {
    double sum = 0;
    for (Index m = 0; m < 2; ++m) {
      const auto& p = mesh_[m]->points;
      for_each_plain(m, [&](Index t) {
        const auto& [i, j, k] = mesh_[m]->triangles[t];
        if (side_[parts_.find(vertex_node(m, i))] == Side::inside) sum += dot(p[i] - o, cross(p[j] - o, p[k] - o));
      });
    }
    for (Index f = 0; f < pieces_.shape.face_count(); ++f) {
      const bool both = owner_[f] == (in_a | in_b);
      const Index m = both || owner_[f] == in_a ? 0 : 1;
      if (both ? opposite_[f][0] != opposite_[f][1] : side_[parts_.find(f)] != Side::inside) continue;
      Vec3 area;
      const Index first = first_coedge(f);
      const auto at = [&](Index c, Index end) {
        const Index code = pieces_.shape.coedges[c];
        return pieces_.points[pieces_.shape.edges[code / 2][(code + end) % 2]] - o;
      };
      for (Index c = first; c < first_coedge(f + 1); ++c) area += cross(at(c, 0), at(c, 1));
      const double volume = dot(at(first, 0), area);
      sum += opposite_[f][m] ? -volume : volume;
    }
    return sum;
  }

  std::array<const TriangleMesh*, 2> mesh_;
  MeshOperation operation_;
  const Context& context_;
  Box3 box_;
  double tolerance_ = 0;
  ActiveTriangles active_;
  Soup soup_;
  std::vector<Index> mesh_vertex_;  // per soup vertex
  Imprinted pieces_;
  std::vector<std::uint8_t> owner_, vertex_owner_, edge_owner_;
  std::vector<std::array<bool, 2>> opposite_;  // per piece and operand: is its normal the other way?
  std::vector<Index> face_of_;                 // per coedge
  Lists uses_;                                 // per edge of the pieces
  UnionFind parts_{0};                         // pieces, then vertices of a, of b
  std::vector<Side> side_;
  std::vector<Index> point_of_b_, point_of_vertex_;
  std::vector<Vec3> new_points_;
  CombinedMesh result_;
};

}  // namespace

Result<CombinedMesh> combine(const TriangleMesh& a, const TriangleMesh& b, MeshOperation operation,
                             const MeshOptions& options, const Context& context) {
  return Combining(a, b, operation, options, context).run();
}

}  // namespace aresta::planar
