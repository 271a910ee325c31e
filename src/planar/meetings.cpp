// SPDX-License-Identifier: Apache-2.0
#include "planar/meetings.h"

#include <algorithm>
#include <cmath>

#include "math/box_tree.h"
#include "planar/face_places.h"
#include "planar/point_grid.h"

namespace aresta::planar {

namespace {

constexpr double nearly_parallel = 1e-3;  // sine of the angle between planes that are looked at twice
constexpr std::size_t few_segments = 8;   // in a face: compared two by two
constexpr int most_rounds = 32;           // of segments and their crossings; two are the rule

class Meeting {
 public:
  Meeting(const Entities& entities, const Context& context)
      : in_(entities),
        context_(context),
        tolerance_(entities.tolerance),
        places_(entities.faces()),
        points_(entities.points),
        grid_(tolerance_, 2 * points_.size()),
        precision_(tolerance_ / 1024),
        face_has_vertices_(entities.face_count(), false) {
    for (const Vec3 p : points_) grid_.add(p);
    std::vector<Box3> boxes(in_.boxes);
    for (Box3& b : boxes) b = b.grown(tolerance_);
    faces_ = BoxTree(std::move(boxes));
    find_wires();
    find_corners();
    for (const auto& [edge, vertex] : in_.vertex_on_edge) put_on_edge(vertex, edge);
    for (const auto& [face, vertex] : in_.vertex_in_face) put_in_face(vertex, face);
  }

  Result<Meetings> run() {
    ARESTA_CHECK(place_vertices());
    ARESTA_CHECK(cross_edges());
    for (int round = 0; round < most_rounds; ++round) {
      ARESTA_CHECK(context_.step(0.5, "crossing faces"));
      gather();
      make_pieces();
      cross_faces();
      const std::size_t known = on_edge_.size() + in_face_.size();
      ARESTA_CHECK(cross_segments());
      if (on_edge_.size() + in_face_.size() == known) return finish();
    }
    return Error{errors::planar_unresolved,
                 "segments where faces cross go on making new crossings",
                 {},
                 {},
                 "a larger --tolerance"};
  }

 private:
  // ---- what lies on what ----

  bool put_on_edge(Index vertex, Index edge) {
    if (in_.shape.edges[edge][0] == vertex || in_.shape.edges[edge][1] == vertex) return false;
    if (!on_edge_known_.insert(edge, vertex)) return false;
    on_edge_.emplace_back(edge, vertex);
    if (vertex >= split_edges_.size()) split_edges_.resize(points_.size());
    split_edges_[vertex].push_back(edge);
    return true;
  }

  bool put_in_face(Index vertex, Index face) {
    if (!in_face_known_.insert(face, vertex)) return false;
    in_face_.emplace_back(face, vertex);
    face_has_vertices_[face] = true;
    return true;
  }

  bool is_on_edge(Index vertex, Index edge) const {
    return in_.shape.edges[edge][0] == vertex || in_.shape.edges[edge][1] == vertex ||
           (is_split_vertex(vertex) && on_edge_known_.contains(edge, vertex));
  }

  bool is_split_vertex(Index vertex) const { return vertex < split_edges_.size() && !split_edges_[vertex].empty(); }

  bool is_on_boundary(Index vertex, Index face) const {
    if (vertex < corner_faces_.size()) {
      const auto faces = corner_faces_[vertex];
      if (std::binary_search(faces.begin(), faces.end(), face)) return true;
    }
    if (!is_split_vertex(vertex)) return false;
    return std::any_of(split_edges_[vertex].begin(), split_edges_[vertex].end(), [&](Index e) {
      const auto faces = in_.faces_of_edge[e];
      return std::binary_search(faces.begin(), faces.end(), face);
    });
  }

  bool is_on_face(Index vertex, Index face) const {
    return is_on_boundary(vertex, face) || (face_has_vertices_[face] && in_face_known_.contains(face, vertex));
  }

  /// The vertex goes where it lies relative to a face whose plane is near.
  void place_in_face(Index vertex, Index face) {
    const Located at = places_.locate(face, points_[vertex]);
    switch (at.place) {
      case Located::Place::outside:
      case Located::Place::vertex:  // then it is that vertex, by identity
        break;
      case Located::Place::inside:
        put_in_face(vertex, face);
        break;
      case Located::Place::edges:
        for (int i = 0; i < at.edge_count; ++i) put_on_edge(vertex, at.edge[static_cast<std::size_t>(i)]);
        break;
    }
  }

  void place_on_segment(Index vertex, Index edge) {
    const auto [a, b] = in_.shape.edges[edge];
    const Vec3 start = points_[a], along = points_[b] - start, to = points_[vertex] - start;
    const double t = dot(to, along) / norm2(along);
    if (t > 0 && t < 1 && norm(to - t * along) <= tolerance_) put_on_edge(vertex, edge);
  }

  /// All that a vertex lies on, whoever its operands are.
  void place_everywhere(Index vertex) {
    const Vec3 p = points_[vertex];
    const Box3 here = box_of(p);
    faces_.overlapping(here, [&](Index f) {
      if (std::abs(in_.planes[f].distance(p)) <= tolerance_ && !is_on_face(vertex, f)) place_in_face(vertex, f);
    });
    wires_.overlapping(here, [&](Index w) { place_on_segment(vertex, wire_edges_[w]); });
  }

  static Box3 box_of(Vec3 p) {
    Box3 box;
    box.add(p);
    return box;
  }

  /// The vertex at p: a known one within tolerance, the nearest, or a new one.
  Index vertex_at(Vec3 p, bool* fresh = nullptr) {
    Index found = none;
    double best = tolerance_ * tolerance_;
    grid_.near(p, [&](Index i) {
      const double d2 = norm2(points_[i] - p);
      if (d2 < best || (d2 == best && (found == none || i < found))) {
        best = d2;
        found = i;
      }
    });
    if (fresh != nullptr) *fresh = found == none;
    if (found != none) return found;
    points_.push_back(p);
    grid_.add(p);
    return static_cast<Index>(points_.size() - 1);
  }

  // ---- vertices of the operands in faces and on edges ----

  void find_wires() {
    std::vector<Box3> boxes;
    for (Index e = 0; e < in_.edge_count(); ++e) {
      if (!in_.faces_of_edge[e].empty()) continue;
      wire_edges_.push_back(e);
      boxes.push_back(edge_box(e));
    }
    wires_ = BoxTree(std::move(boxes));
  }

  void find_corners() {
    std::vector<IndexPair> pairs;
    pairs.reserve(in_.shape.coedges.size());
    for (Index f = 0; f < in_.face_count(); ++f) {
      for (const Index c : in_.coedges_of(f)) pairs.emplace_back(in_.shape.edges[c / 2][c % 2], f);
    }
    corner_faces_ = group(points_.size(), pairs);  // by rising face
  }

  Box3 edge_box(Index e) const {
    Box3 box;
    for (const Index v : in_.shape.edges[e]) box.add(points_[v]);
    return box.grown(tolerance_);
  }

  Status place_vertices() {
    const auto count = static_cast<Index>(points_.size());
    for (Index v = 0; v < count; ++v) {
      if (v % 1024 == 0) ARESTA_CHECK(context_.step(0.3 * v / count, "placing vertices"));
      const Vec3 p = points_[v];
      const Box3 here = box_of(p);
      const auto own = in_.vertex_operands[v];
      faces_.overlapping(here, [&](Index f) {
        if (std::abs(in_.planes[f].distance(p)) > tolerance_ || in_.share_operand(own, in_.face_operands[f]) ||
            is_on_face(v, f))
          return;
        place_in_face(v, f);
      });
      wires_.overlapping(here, [&](Index w) {
        const Index e = wire_edges_[w];
        if (!in_.share_operand(own, in_.edge_operands[e])) place_on_segment(v, e);
      });
    }
    return {};
  }

  // ---- edges across faces, edges across edges ----

  Status cross_edges() {
    for (Index e = 0; e < in_.edge_count(); ++e) {
      if (e % 1024 == 0) ARESTA_CHECK(context_.step(0.3 + 0.2 * e / in_.edge_count(), "crossing edges"));
      const auto own = in_.edge_operands[e];
      const Box3 box = edge_box(e);
      faces_.overlapping(box, [&](Index f) {
        if (in_.share_operand(own, in_.face_operands[f])) return;
        const auto faces = in_.faces_of_edge[e];
        if (std::binary_search(faces.begin(), faces.end(), f))
          cross_own_face(e, f);
        else
          cross_edge_and_face(e, f);
      });
      if (!in_.faces_of_edge[e].empty()) continue;
      wires_.overlapping(box, [&](Index w) {
        const Index other = wire_edges_[w];
        if (other > e && !in_.share_operand(own, in_.edge_operands[other])) cross_wires(e, other);
      });
    }
    return {};
  }

  void cross_edge_and_face(Index e, Index f) {
    const auto [a, b] = in_.shape.edges[e];
    const Plane& plane = in_.planes[f];
    const Vec3 start = points_[a], along = points_[b] - start;
    const double at_a = plane.distance(start), at_b = plane.distance(points_[b]);
    if (std::min(at_a, at_b) > tolerance_ || std::max(at_a, at_b) < -tolerance_) return;
    // Only what lies over the face counts: a long edge may leave its plane farther on.
    double low = 0, high = 1;
    if (!BoxTree::meets(in_.boxes[f].grown(2 * tolerance_), start, along, &low, &high) || low > 1) return;
    const double at_low = low == 0 ? at_a : plane.distance(start + low * along);
    const double at_high = high >= 1 ? at_b : plane.distance(start + high * along);
    if (std::abs(at_low) <= tolerance_ && std::abs(at_high) <= tolerance_) return cross_in_plane(e, f);
    if ((at_low > 0) == (at_high > 0)) return;
    if (is_on_face(a, f) || is_on_face(b, f)) {  // there it meets the plane, and nowhere else
      ++result_.stages.by_name;
      return;
    }
    const auto exact = in_.exact_plane(f);
    const auto met =
        line_plane_point(in_.lattice_point(a), in_.lattice_point(b), *exact, in_.lattice, precision_, result_.stages);
    if (!met) return;
    const Vec3 p = tidy(tidy(*met, e, e), f);
    const Located at = places_.locate(f, p);
    switch (at.place) {
      case Located::Place::outside:
        return;
      case Located::Place::vertex:
        put_on_edge(at.vertex, e);
        return;
      case Located::Place::inside: {
        const Index v = new_vertex(p);
        put_on_edge(v, e);
        if (!is_on_face(v, f)) put_in_face(v, f);
        return;
      }
      case Located::Place::edges: {
        const Index v = new_vertex(p);
        put_on_edge(v, e);
        for (int i = 0; i < at.edge_count; ++i) put_on_edge(v, at.edge[static_cast<std::size_t>(i)]);
        return;
      }
    }
  }

  /// An edge that lies in the plane of a face against the face's edges: what crosses between vertices.
  void cross_in_plane(Index e, Index f) {
    const auto [a, b] = in_.shape.edges[e];
    const Vec3 start = points_[a], along = points_[b] - start;
    const Vec3 across = normalized(cross(in_.planes[f].normal, along));
    places_.edges_near(f, edge_box(e), [&](Index h) {
      const auto [c, d] = in_.shape.edges[h];
      if (is_on_edge(c, e) || is_on_edge(d, e) || is_on_edge(a, h) || is_on_edge(b, h)) {
        ++result_.stages.by_name;
        return;
      }
      const double at_c = dot(across, points_[c] - start), at_d = dot(across, points_[d] - start);
      if ((at_c > 0) == (at_d > 0)) return;
      const auto p = crossing(e, h, in_.planes[f].axis);
      if (!p) return;
      const double t = dot(*p - start, along) / norm2(along);
      if (t > 0 && t < 1) cross_at(e, h, tidy(*p, e, h));
    });
  }

  /// An edge of a face that nobody vouches for against the others.
  void cross_own_face(Index e, Index f) {
    if (in_.coedges_of(f).size() <= 3) return;
    places_.edges_near(f, edge_box(e), [&](Index h) {
      for (const Index v : in_.shape.edges[h]) place_on_segment(v, e);
    });
    cross_in_plane(e, f);
  }

  /// Where edge h meets the plane through edge e along an axis; nothing where they are parallel.
  std::optional<Vec3> crossing(Index e, Index h, int axis) {
    const auto [a, b] = in_.shape.edges[e];
    const auto [c, d] = in_.shape.edges[h];
    LatticePoint off = in_.lattice_point(a);
    const auto i = static_cast<std::size_t>(axis);
    off[i] += off[i] > 0 ? -(std::int64_t{1} << 50) : std::int64_t{1} << 50;
    const auto plane = plane_through(in_.lattice_point(a), in_.lattice_point(b), off);
    if (!plane) return {};
    return line_plane_point(in_.lattice_point(c), in_.lattice_point(d), *plane, in_.lattice, precision_,
                            result_.stages);
  }

  // What is plain to see is kept to the last bit.

  /// Coordinates in which one of two crossing edges does not vary are that edge's.
  Vec3 tidy(Vec3 p, Index e, Index h) const {
    for (int i = 0; i < 3; ++i) {
      for (const Index k : {h, e}) {
        const auto [a, b] = in_.shape.edges[k];
        if (points_[a][i] == points_[b][i]) p[i] = points_[a][i];
      }
    }
    return p;
  }

  /// So are those of a plane at right angles to an axis.
  Vec3 tidy(Vec3 p, Index f) const {
    const Plane& plane = in_.planes[f];
    if (std::abs(plane.normal[plane.axis]) == 1) p[plane.axis] = plane.origin[plane.axis];
    return p;
  }

  void cross_at(Index e, Index h, Vec3 p) {
    const Index v = new_vertex(p);
    put_on_edge(v, e);
    put_on_edge(v, h);
  }

  void cross_wires(Index e, Index h) {
    const auto [a, b] = in_.shape.edges[e];
    const auto [c, d] = in_.shape.edges[h];
    if (is_on_edge(c, e) || is_on_edge(d, e) || is_on_edge(a, h) || is_on_edge(b, h)) return;
    const Vec3 u = points_[b] - points_[a], w = points_[d] - points_[c], n = cross(u, w), to = points_[c] - points_[a];
    const double n2 = norm2(n);
    if (n2 == 0 || std::abs(dot(to, n)) > tolerance_ * std::sqrt(n2)) return;
    const double s = dot(cross(to, w), n) / n2, t = dot(cross(to, u), n) / n2;
    if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return;
    cross_at(e, h, tidy(points_[a] + s * u, e, h));
  }

  /// A vertex at p with all that it lies on.
  Index new_vertex(Vec3 p) {
    bool fresh = false;
    const Index v = vertex_at(p, &fresh);
    if (fresh) place_everywhere(v);
    return v;
  }

  // ---- faces across faces ----

  /// The lists by owner, from what is known so far.
  void gather() {
    const Index edges = in_.edge_count();
    result_.vertices_of_edge = group(edges, on_edge_);
    Lists& on = result_.vertices_of_edge;
    Lists with_ends;
    with_ends.begin.reserve(edges + 1);
    with_ends.items.reserve(on.items.size() + 2 * edges);
    for (Index e = 0; e < edges; ++e) {
      const auto [a, b] = in_.shape.edges[e];
      const Vec3 start = points_[a], along = points_[b] - start;
      order_along(std::span(on.items).subspan(on.begin[e], on.begin[e + 1] - on.begin[e]), start, along);
      with_ends.items.push_back(a);
      for (const Index v : on[e]) with_ends.items.push_back(v);
      with_ends.items.push_back(b);
      with_ends.begin.push_back(static_cast<Index>(with_ends.items.size()));
    }
    on = std::move(with_ends);

    // What turned out to lie on the boundary is no longer inside.
    std::erase_if(in_face_, [&](const IndexPair& pair) { return is_on_boundary(pair.second, pair.first); });
    result_.vertices_in_face = group(in_.face_count(), in_face_);

    std::vector<IndexPair> pairs;
    pairs.reserve(on.items.size() * 2 + in_face_.size());
    for (Index f = 0; f < in_.face_count(); ++f) {
      for (const Index c : in_.coedges_of(f)) {
        const auto vertices = on[c / 2];
        const std::size_t first = c % 2 == 0 ? 0 : 1;  // the last one starts the next coedge
        for (std::size_t i = first; i < vertices.size() - 1 + first; ++i) pairs.emplace_back(vertices[i], f);
      }
      for (const Index v : result_.vertices_in_face[f]) pairs.emplace_back(v, f);
    }
    Lists all = group(points_.size(), pairs);  // by rising face
    Lists& faces = result_.faces_of_vertex;
    faces = {};
    faces.begin.reserve(points_.size() + 1);
    faces.items.reserve(all.items.size());
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const auto list = all[v];
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (i == 0 || list[i] != list[i - 1]) faces.items.push_back(list[i]);
      }
      faces.begin.push_back(static_cast<Index>(faces.items.size()));
    }
  }

  void order_along(std::span<Index> vertices, Vec3 start, Vec3 along) const {
    std::sort(vertices.begin(), vertices.end(), [&](Index u, Index v) {
      const double s = dot(points_[u] - start, along), t = dot(points_[v] - start, along);
      return s != t ? s < t : u < v;
    });
  }

  void make_pieces() {
    result_.pieces.clear();
    piece_of_ = PairMap(2 * in_.edge_count());
    piece_edges_.clear();
    for (Index e = 0; e < in_.edge_count(); ++e) {
      const auto vertices = result_.vertices_of_edge[e];
      for (std::size_t i = 1; i < vertices.size(); ++i)
        piece_edges_.emplace_back(add_piece(vertices[i - 1], vertices[i], none, none), e);
    }
  }

  Index add_piece(Index a, Index b, Index face, Index other_face) {
    const auto fresh = static_cast<Index>(result_.pieces.size());
    const Index one = piece_of_.add(std::min(a, b), std::max(a, b), fresh);
    if (one == fresh) result_.pieces.push_back({a, b, face, other_face});
    return one;
  }

  template <class Visit>
  void for_each_vertex_of(Index f, Visit&& visit) const {
    for (const Index c : in_.coedges_of(f)) {
      const auto vertices = result_.vertices_of_edge[c / 2];
      const std::size_t first = c % 2 == 0 ? 0 : 1;
      for (std::size_t i = first; i < vertices.size() - 1 + first; ++i) visit(vertices[i]);
    }
    for (const Index v : result_.vertices_in_face[f]) visit(v);
  }

  /// Pairs of faces with two vertices in common or more: the segments between those that lie inside both.
  void cross_faces() {
    std::vector<IndexPair> meets;  // (other face, common vertex)
    std::vector<Index> common;
    for (Index f = 0; f < in_.face_count(); ++f) {
      meets.clear();
      for_each_vertex_of(f, [&](Index v) {
        for (const Index g : result_.faces_of_vertex[v]) {
          if (g > f && !in_.share_operand(in_.face_operands[f], in_.face_operands[g])) meets.emplace_back(g, v);
        }
      });
      std::sort(meets.begin(), meets.end());
      for (std::size_t i = 0, j; i < meets.size(); i = j) {
        common.clear();
        for (j = i; j < meets.size() && meets[j].first == meets[i].first; ++j) {
          if (common.empty() || common.back() != meets[j].second) common.push_back(meets[j].second);
        }
        if (common.size() >= 2) cross_pair(f, meets[i].first, common);
      }
    }
  }

  void cross_pair(Index f, Index g, std::vector<Index>& common) {
    if (common.size() == 2 && piece_of_.contains(std::min(common[0], common[1]), std::max(common[0], common[1])))
      return;
    const Plane &p = in_.planes[f], &q = in_.planes[g];
    const Vec3 line = cross(p.normal, q.normal);
    const double sine = norm(line);
    if (sine == 0) return;
    const Vec3 along = line / sine;
    const Vec3 origin = points_[common[0]];
    if (sine < nearly_parallel && coincide(f, g)) return;
    order_along(common, origin, along);
    for (std::size_t i = 1; i < common.size(); ++i) {
      const Index a = common[i - 1], b = common[i];
      if (piece_of_.contains(std::min(a, b), std::max(a, b))) continue;
      if (runs_inside(a, b, f) && runs_inside(a, b, g)) add_piece(a, b, f, g);
    }
  }

  /// Are two nearly parallel planes one, within the tolerance, wherever the faces can be over each other? Then the
  /// edges of each on the other say all, and there is no segment between them.
  bool coincide(Index f, Index g) const {
    const Box3 &a = in_.boxes[f], &b = in_.boxes[g];
    const Plane &p = in_.planes[f], &q = in_.planes[g];
    for (int i = 0; i < 8; ++i) {
      Vec3 corner;
      for (int k = 0; k < 3; ++k)
        corner[k] = (i >> k & 1) != 0 ? std::min(a.high[k], b.high[k]) : std::max(a.low[k], b.low[k]);
      corner = corner - p.distance(corner) * p.normal;
      if (std::abs(q.distance(corner)) > 2 * tolerance_) return false;
    }
    return true;
  }

  /// Does the segment between two vertices of the face run inside it? It may run nearer than the tolerance to an edge,
  /// if it is not to be that edge: then it has an end elsewhere.
  bool runs_inside(Index a, Index b, Index f) const {
    const Located at = places_.locate(f, 0.5 * (points_[a] + points_[b]));
    if (at.place != Located::Place::edges) return at.place == Located::Place::inside;
    for (int i = 0; i < at.edge_count; ++i) {
      const Index e = at.edge[static_cast<std::size_t>(i)];
      if (is_on_edge(a, e) && is_on_edge(b, e)) return false;
    }
    return true;
  }

  // ---- segments across segments ----

  /// Segments inside a face against each other and against its vertices.
  Status cross_segments() {
    std::vector<IndexPair> pairs;
    for (Index i = 0; i < result_.pieces.size(); ++i) {
      const Piece& piece = result_.pieces[i];
      if (piece.face == none) continue;
      pairs.emplace_back(piece.face, i);
      pairs.emplace_back(piece.other_face, i);
    }
    const Lists segments = group(in_.face_count(), pairs);
    for (Index f = 0; f < in_.face_count(); ++f) {
      if (!segments[f].empty()) cross_in_face(f, segments[f]);
    }
    return {};
  }

  void cross_in_face(Index f, std::span<const Index> segments) {
    const std::size_t count = segments.size();
    if (count > few_segments) {
      std::vector<Box3> boxes(count);
      for (std::size_t i = 0; i < count; ++i) boxes[i] = piece_box(segments[i]);
      const BoxTree tree(boxes);
      for (std::size_t i = 0; i < count; ++i) {
        tree.overlapping(boxes[i], [&](Index j) {
          if (j > i) cross_two_segments(f, segments[i], segments[j]);
        });
      }
      for_each_vertex_of(
          f, [&](Index v) { tree.overlapping(box_of(points_[v]), [&](Index i) { put_on_segment(v, segments[i]); }); });
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) cross_two_segments(f, segments[i], segments[j]);
    }
    for_each_vertex_of(f, [&](Index v) {
      for (const Index s : segments) put_on_segment(v, s);
    });
  }

  Box3 piece_box(Index piece) const {
    Box3 box;
    box.add(points_[result_.pieces[piece].a]);
    box.add(points_[result_.pieces[piece].b]);
    return box.grown(tolerance_);
  }

  void put_on_segment(Index v, Index s) {
    const Piece piece = result_.pieces[s];
    if (v == piece.a || v == piece.b) return;
    const Vec3 start = points_[piece.a], along = points_[piece.b] - start, to = points_[v] - start;
    const double t = dot(to, along) / norm2(along);
    if (t <= 0 || t >= 1 || norm2(to - t * along) > tolerance_ * tolerance_) return;
    put_on_faces(v, piece);
  }

  void put_on_faces(Index v, const Piece& piece) {
    for (const Index f : {piece.face, piece.other_face}) {
      if (!is_on_face(v, f)) put_in_face(v, f);
    }
  }

  void cross_two_segments(Index f, Index s, Index t) {
    const Piece one = result_.pieces[s], two = result_.pieces[t];
    if (one.a == two.a || one.a == two.b || one.b == two.a || one.b == two.b) return;
    const Vec3 u = points_[one.b] - points_[one.a], w = points_[two.b] - points_[two.a];
    const Vec3 to = points_[two.a] - points_[one.a], normal = in_.planes[f].normal;
    const double whole = dot(cross(u, w), normal);
    if (whole == 0) return;
    const double x = dot(cross(to, w), normal) / whole, y = dot(cross(to, u), normal) / whole;
    if (x <= 0 || x >= 1 || y <= 0 || y >= 1) return;
    const Index g = one.face == f ? one.other_face : one.face, h = two.face == f ? two.other_face : two.face;
    Vec3 p = points_[one.a] + x * u;
    const auto met = three_plane_point(*in_.exact_plane(f), *in_.exact_plane(g), *in_.exact_plane(h), in_.lattice,
                                       precision_, result_.stages);
    // Planes that hardly cross may meet elsewhere than these pieces do, which lie within the tolerance of them.
    if (met && norm(*met - p) <= 8 * tolerance_) p = *met;
    p = tidy(tidy(tidy(p, f), g), h);
    const Index v = new_vertex(p);
    put_on_faces(v, one);
    put_on_faces(v, two);
  }

  // ---- the result ----

  Result<Meetings> finish() {
    std::vector<IndexPair> ends;
    for (Index i = 0; i < result_.pieces.size(); ++i) {
      ends.emplace_back(result_.pieces[i].a, i);
      ends.emplace_back(result_.pieces[i].b, i);
    }
    result_.pieces_of_vertex = group(points_.size(), ends);
    result_.edges_of_piece = group(result_.pieces.size(), piece_edges_);
    result_.points = std::move(points_);
    return std::move(result_);
  }

  /// A set of pairs.
  class PairSet {
   public:
    bool insert(Index a, Index b) {
      const std::size_t before = map_.size();
      map_.add(a, b, 0);
      return map_.size() != before;
    }
    bool contains(Index a, Index b) const { return map_.contains(a, b); }

   private:
    PairMap map_;
  };

  const Entities& in_;
  const Context& context_;
  double tolerance_;
  FacePlaces places_;
  std::vector<Vec3> points_;
  PointGrid grid_;
  double precision_;  // of new places
  std::vector<bool> face_has_vertices_;
  Lists corner_faces_;                           // per vertex of the entities, sorted
  std::vector<std::vector<Index>> split_edges_;  // per vertex: edges that it lies inside
  BoxTree faces_, wires_;
  std::vector<Index> wire_edges_;
  std::vector<IndexPair> on_edge_, in_face_;  // (edge, vertex), (face, vertex)
  PairSet on_edge_known_, in_face_known_;
  PairMap piece_of_;
  std::vector<IndexPair> piece_edges_;
  Meetings result_;
};

}  // namespace

Result<Meetings> find_meetings(const Entities& entities, const Context& context) {
  return Meeting(entities, context).run();
}

}  // namespace aresta::planar
