// SPDX-License-Identifier: Apache-2.0
#include "planar/imprint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planar/arrangement.h"
#include "planar/edge_sets.h"
#include "planar/face_places.h"
#include "planar/meetings.h"

namespace aresta::planar {

namespace {

class Imprinting {
 public:
  Imprinting(const Soup& soup, const Entities& entities, const Meetings& meetings, const Context& context)
      : soup_(soup), in_(entities), at_(meetings), context_(context), places_(entities.faces()) {}

  Result<Imprinted> run() {
    out_.tolerance = in_.tolerance;
    out_.stages = at_.stages;
    out_.points = at_.points;
    out_.shape.vertex_count = static_cast<Index>(at_.points.size());
    for (const Piece& p : at_.pieces) out_.shape.edges.push_back({p.a, p.b});
    pieces_in_face_.resize(at_.pieces.size());
    stamp_vertex_.assign(at_.points.size(), none);
    stamp_piece_.assign(at_.pieces.size(), none);
    local_.assign(at_.points.size(), none);
    for (Index f = 0; f < in_.face_count(); ++f) {
      if (f % 512 == 0) ARESTA_CHECK(context_.step(0.6 + 0.3 * f / in_.face_count(), "dividing faces"));
      ARESTA_CHECK(divide(f));
    }
    ARESTA_CHECK(name());
    return std::move(out_);
  }

 private:
  Status divide(Index f) {
    boundary_.clear();
    for (Index l = in_.shape.face_begin[f]; l < in_.shape.face_begin[f + 1]; ++l) {
      for (Index c = in_.shape.loop_begin[l]; c < in_.shape.loop_begin[l + 1]; ++c) add_boundary(in_.shape.coedges[c]);
      loop_end_.push_back(static_cast<Index>(boundary_.size()));
    }
    const bool plain = stamp(f);
    find_inner(f);
    if (plain && inner_.empty() && at_.vertices_in_face[f].empty()) {
      take_whole(f);
    } else {
      ARESTA_CHECK(take_cells(f));
    }
    loop_end_.clear();
    return {};
  }

  /// The pieces of a coedge, in its direction, as 2 * piece + reversed.
  void add_boundary(Index coedge) {
    const auto pieces = pieces_of_edge(coedge / 2);
    const bool reversed = coedge % 2 == 1;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Index code = reversed ? pieces[pieces.size() - 1 - i] ^ 1u : pieces[i];
      boundary_.push_back(code);
    }
  }

  /// Pieces of an edge from its start to its end, as 2 * piece + reversed.
  std::span<const Index> pieces_of_edge(Index e) {
    if (pieces_of_edge_.size() == 0) {
      std::vector<IndexPair> pairs;
      for (Index p = 0; p < at_.pieces.size(); ++p) {
        for (const Index edge : at_.edges_of_piece[p]) pairs.emplace_back(edge, p);
      }
      pieces_of_edge_ = group(in_.edge_count(), pairs);
      for (Index edge = 0; edge < in_.edge_count(); ++edge) order_pieces(edge);
    }
    return pieces_of_edge_[e];
  }

  void order_pieces(Index e) {
    const auto vertices = at_.vertices_of_edge[e];
    const auto pieces = std::span(pieces_of_edge_.items).subspan(pieces_of_edge_.begin[e], pieces_of_edge_[e].size());
    // Few pieces an edge: each is found by its ends.
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      for (std::size_t j = i; j < pieces.size(); ++j) {
        const Piece& p = at_.pieces[pieces[j]];
        if ((p.a == vertices[i] && p.b == vertices[i + 1]) || (p.b == vertices[i] && p.a == vertices[i + 1])) {
          std::swap(pieces[i], pieces[j]);
          break;
        }
      }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i)
      pieces[i] = 2 * pieces[i] + (at_.pieces[pieces[i]].a == vertices[i] ? 0u : 1u);
  }

  /// Marks what is on the face's boundary; does it pass each vertex once?
  bool stamp(Index f) {
    bool plain = true;
    for (const Index code : boundary_) {
      if (stamp_vertex_[start(code)] == f) plain = false;
      stamp_vertex_[start(code)] = f;
      stamp_piece_[code / 2] = f;
    }
    for (const Index v : at_.vertices_in_face[f]) stamp_vertex_[v] = f;
    return plain;
  }

  /// Pieces inside the face: both ends on it, the middle inside.
  void find_inner(Index f) {
    inner_.clear();
    const auto from = [&](Index v) {
      for (const Index i : at_.pieces_of_vertex[v]) {
        const Piece& p = at_.pieces[i];
        if (stamp_piece_[i] == f || stamp_vertex_[p.a] != f || stamp_vertex_[p.b] != f) continue;
        stamp_piece_[i] = f;
        if (is_inner(f, i)) inner_.push_back(i);
      }
    };
    for (const Index code : boundary_) from(start(code));
    for (const Index v : at_.vertices_in_face[f]) from(v);
  }

  Index start(Index code) const { return code % 2 == 0 ? at_.pieces[code / 2].a : at_.pieces[code / 2].b; }

  bool is_inner(Index f, Index i) const {
    const Piece& p = at_.pieces[i];
    if (p.face == f || p.other_face == f) return true;
    if (p.face == none) {
      const auto edges = at_.edges_of_piece[i];
      const bool own = std::any_of(edges.begin(), edges.end(), [&](Index e) {
        return in_.share_operand(in_.edge_operands[e], in_.face_operands[f]);
      });
      if (own) return false;
    }
    const Vec3 middle = 0.5 * (at_.points[p.a] + at_.points[p.b]);
    return std::abs(in_.planes[f].distance(middle)) <= 4 * in_.tolerance &&
           places_.locate(f, middle).place == Located::Place::inside;
  }

  void take_whole(Index f) {
    Index begin = 0;
    for (std::size_t l = 0; l < loop_end_.size(); ++l) {
      for (Index i = begin; i < loop_end_[l]; ++i) out_.shape.coedges.push_back(boundary_[i]);
      begin = loop_end_[l];
      out_.shape.close_loop();
    }
    out_.shape.close_face();
    face_of_.push_back(f);
  }

  Status take_cells(Index f) {
    drawing_.points.clear();
    drawing_.lines.clear();
    const Plane& plane = in_.planes[f];
    std::vector<Index> vertices;
    const auto local = [&](Index v) {
      if (local_[v] == none) {
        local_[v] = static_cast<Index>(vertices.size());
        vertices.push_back(v);
        drawing_.points.push_back(plane.flat(at_.points[v] - plane.origin));
      }
      return local_[v];
    };
    std::vector<std::pair<Index, int>> runs;
    for (const Index code : boundary_) runs.emplace_back(code / 2, code % 2 == 0 ? 1 : -1);
    for (const Index i : inner_) runs.emplace_back(i, 0);
    std::sort(runs.begin(), runs.end());
    for (std::size_t i = 0, j; i < runs.size(); i = j) {
      int winding = 0;
      for (j = i; j < runs.size() && runs[j].first == runs[i].first; ++j) winding += runs[j].second;
      const Piece& p = at_.pieces[runs[i].first];
      drawing_.lines.push_back({runs[i].first, local(p.a), local(p.b), winding});
    }
    for (const Index v : at_.vertices_in_face[f]) local(v);
    auto cells = arrange(drawing_);
    for (const Index v : vertices) local_[v] = none;
    if (!cells.ok()) {
      Error error = std::move(cells).error();
      for (const Index member : in_.face_members[f]) error.entities.push_back(FaceId(member));
      error.place = {plane.origin.x, plane.origin.y, plane.origin.z};
      return error;
    }
    for (const FaceCell& cell : *cells) {
      for (const auto& loop : cell.loops) {
        for (const Index code : loop) out_.shape.coedges.push_back(code);
        out_.shape.close_loop();
      }
      for (const Index v : cell.points) out_.shape.add_vertex_loop(vertices[v]);
      out_.shape.close_face();
      face_of_.push_back(f);
    }
    for (const Index i : inner_) pieces_in_face_[i].push_back(f);
    return {};
  }

  // ---- each face once, and the names ----

  /// Faces with the same outer pieces are one: all of them are divided by all that lies in them.
  Status name() {
    const Incidence all = std::exchange(out_.shape, {});
    Incidence& shape = out_.shape;
    shape.vertex_count = all.vertex_count;
    shape.edges = all.edges;
    const auto outer = [&](Index f) {
      const Index l = all.face_begin[f];
      return std::span(all.coedges).subspan(all.loop_begin[l], all.loop_begin[l + 1] - all.loop_begin[l]);
    };
    const auto coedge_count = [&](Index f) {
      return all.loop_begin[all.face_begin[f + 1]] - all.loop_begin[all.face_begin[f]];
    };
    EdgeSets known(all.face_count());
    std::vector<Index> kept;  // of `all`
    std::vector<IndexPair> names;
    const auto edges = static_cast<Index>(soup_.shape.edge_count()), vertices = static_cast<Index>(soup_.points.size());
    for (Index f = 0; f < all.face_count(); ++f) {
      Index one = known.add(outer(f), [&](Index i) { return outer(kept[i]); });
      if (one == none) {
        one = static_cast<Index>(kept.size());
        kept.push_back(f);
        copy_face(all, f);
        out_.planes.push_back(in_.planes[face_of_[f]]);
      } else if (coedge_count(f) != coedge_count(kept[one])) {
        return divided_differently(face_of_[f], face_of_[kept[one]]);
      }
      for (const Index member : in_.face_members[face_of_[f]]) names.emplace_back(one, vertices + edges + member);
    }
    out_.face_names = group(kept.size(), names);
    name_edges(vertices, edges);
    name_vertices(vertices, edges);
    return {};
  }

  Error divided_differently(Index f, Index g) const {
    const Vec3 p = in_.planes[f].origin;
    return Error{errors::planar_unresolved,
                 "pieces of two faces have one outline but not the same in it",
                 {FaceId(in_.face_members[f].front()), FaceId(in_.face_members[g].front())},
                 {{p.x, p.y, p.z}}};
  }

  void copy_face(const Incidence& all, Index f) {
    Incidence& shape = out_.shape;
    for (Index l = all.face_begin[f]; l < all.face_begin[f + 1]; ++l) {
      for (Index c = all.loop_begin[l]; c < all.loop_begin[l + 1]; ++c) shape.coedges.push_back(all.coedges[c]);
      if (all.loop_vertex[l] == none)
        shape.close_loop();
      else
        shape.add_vertex_loop(all.loop_vertex[l]);
    }
    shape.close_face();
  }

  void name_edges(Index vertices, Index edges) {
    std::vector<IndexPair> names;
    for (Index p = 0; p < at_.pieces.size(); ++p) {
      for (const Index e : at_.edges_of_piece[p]) {
        for (const Index member : in_.edge_members[e]) names.emplace_back(p, vertices + member);
      }
      for (const Index f : pieces_in_face_[p]) {
        for (const Index member : in_.face_members[f]) names.emplace_back(p, vertices + edges + member);
      }
    }
    out_.edge_names = group(at_.pieces.size(), names);
  }

  void name_vertices(Index vertices, Index edges) {
    std::vector<IndexPair> names;
    for (Index v = 0; v < in_.points.size(); ++v) {
      for (const Index member : in_.vertex_members[v]) names.emplace_back(v, member);
    }
    for (Index e = 0; e < in_.edge_count(); ++e) {
      const auto on = at_.vertices_of_edge[e];
      for (std::size_t i = 1; i + 1 < on.size(); ++i) {
        for (const Index member : in_.edge_members[e]) names.emplace_back(on[i], vertices + member);
      }
    }
    for (Index f = 0; f < in_.face_count(); ++f) {
      for (const Index v : at_.vertices_in_face[f]) {
        for (const Index member : in_.face_members[f]) names.emplace_back(v, vertices + edges + member);
      }
    }
    out_.vertex_names = group(at_.points.size(), names);
  }

  const Soup& soup_;
  const Entities& in_;
  const Meetings& at_;
  const Context& context_;
  FacePlaces places_;
  Imprinted out_;
  Lists pieces_of_edge_;
  std::vector<std::vector<Index>> pieces_in_face_;  // per piece: the faces that it lies inside
  std::vector<Index> stamp_vertex_, stamp_piece_, local_;
  std::vector<Index> boundary_, loop_end_, inner_, face_of_;
  FaceDrawing drawing_;
};

}  // namespace

Result<Imprinted> imprint(const Soup& soup, double tolerance, const Context& context) {
  ARESTA_TRY(const Entities entities, unite(soup, tolerance));
  ARESTA_TRY(const Meetings meetings, find_meetings(entities, context));
  return Imprinting(soup, entities, meetings, context).run();
}

}  // namespace aresta::planar
