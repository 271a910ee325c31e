// SPDX-License-Identifier: Apache-2.0
#include "model/extract.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/union_find.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;

class Extractor {
 public:
  Extractor(const Model& source, const Selection& selection, const Merging* merging)
      : source_(source), k_(source.topology()), keep_(selection), merging_(merging) {}

  Result<Extraction> run() {
    ARESTA_CHECK(merge_cells());
    copy_vertices();
    ARESTA_CHECK(copy_edges());
    std::vector<std::vector<FaceId>> parts(k_.face_count());
    for (const FaceId f : k_.faces()) {
      if (keep_.faces[f.index()]) parts[class_of(f).index()].push_back(f);
    }
    for (const auto& faces : parts) {
      if (!faces.empty()) ARESTA_CHECK(copy_face(faces));
    }
    restrict_radial_order();
    builder_.length_unit = source_.length_unit;
    builder_.tolerance = source_.tolerance();
    ARESTA_TRY(Model model, builder_.build(result_cells(), filled_));
    return Extraction{std::move(model), std::move(from_)};
  }

 private:
  Status merge_cells() {
    UnionFind sets(k_.region_count());
    for (const FaceId f : k_.faces()) {
      if (keep_.faces[f.index()]) continue;
      const RegionId front = k_.region(FaceUse(f, 0)), back = k_.region(FaceUse(f, 1));
      if (keep_.filled[front.index()] != keep_.filled[back.index()]) {
        return Error{
            errors::ambiguous_fill, "a face that separates the result's volume from empty space is not kept", {f}};
      }
      sets.unite(front.index(), back.index());
    }
    cell_.assign(k_.region_count(), none);
    for (std::size_t r = 0; r < k_.region_count(); ++r) {
      const std::uint32_t root = sets.find(r);
      if (cell_[root] == none) {
        cell_[root] = static_cast<std::uint32_t>(filled_.size());
        filled_.push_back(keep_.filled[root]);
        from_.regions.emplace_back();
      }
      cell_[r] = cell_[root];
      from_.regions[cell_[r]].push_back(RegionId(r));
    }
    return {};
  }

  void copy_vertices() {
    new_vertex_.assign(k_.vertex_count(), VertexId());
    for (const VertexId v : k_.vertices()) {
      if (!keep_.vertices[v.index()]) continue;
      new_vertex_[v.index()] = builder_.add_vertex(source_.point(v), source_.tolerance(v));
      from_.vertices.push_back(v);
    }
  }

  Status copy_edges() {
    new_edge_.assign(k_.edge_count(), EdgeId());
    new_curve_.assign(source_.curve_count(), CurveId());
    for (const EdgeId e : k_.edges()) {
      if (!keep_.edges[e.index()] || new_edge_[e.index()].valid()) continue;
      VertexId first = k_.start(e), last = k_.end(e);
      EdgeGeometry g = source_.geometry(e);
      if (const auto* chain = chain_of(e)) {
        first = chain->front().reversed ? k_.end(chain->front().edge) : k_.start(chain->front().edge);
        last = chain->back().reversed ? k_.start(chain->back().edge) : k_.end(chain->back().edge);
        g = geometry_of(*chain, first, last);
      }
      const VertexId a = new_vertex_[first.index()], b = new_vertex_[last.index()];
      if (!a.valid() || !b.valid()) return Error{errors::bad_incidence, "an edge is kept without its vertices", {e}};
      CurveId curve;
      if (g.curve.valid()) {
        CurveId& mapped = new_curve_[g.curve.index()];
        if (!mapped.valid()) mapped = builder_.add_curve(source_.curve(g.curve));
        curve = mapped;
      }
      const EdgeId made = builder_.add_edge(a, b, curve, g.range, g.tolerance);
      from_.edges.push_back(e);
      new_edge_[e.index()] = made;
      if (const auto* chain = chain_of(e)) {
        for (const Merging::Link& link : *chain) new_edge_[link.edge.index()] = made;
      }
    }
    return {};
  }

  FaceId class_of(FaceId f) const { return merging_ == nullptr ? f : merging_->face_class[f.index()]; }

  const std::vector<Merging::Link>* chain_of(EdgeId e) const {
    if (merging_ == nullptr || merging_->chain_of[e.index()] == none) return nullptr;
    return &merging_->chains[merging_->chain_of[e.index()]];
  }

  EdgeGeometry geometry_of(const std::vector<Merging::Link>& chain, VertexId first, VertexId last) const {
    EdgeGeometry g = source_.geometry(chain.front().edge);
    for (const Merging::Link& link : chain) g.tolerance = std::max(g.tolerance, source_.tolerance(link.edge));
    if (source_.is_straight(chain.front().edge)) {
      g.curve = CurveId();
      g.range = {0, distance(source_.point(first), source_.point(last))};
    } else {
      double length = 0;  // a chain may run over the end of a period
      for (const Merging::Link& link : chain) length += source_.range(link.edge).length();
      g.range = {g.range.low, g.range.low + length};
    }
    return g;
  }

  /// The face of a class of faces (of one face, when nothing is merged).
  Status copy_face(const std::vector<FaceId>& faces) {
    if (new_surface_.empty()) new_surface_.assign(source_.surface_count(), SurfaceId());
    const FaceId f = faces.front();
    const FaceGeometry& g = source_.geometry(f);
    SurfaceId& surface = new_surface_[g.surface.index()];
    if (!surface.valid()) surface = builder_.add_surface(source_.surface(g.surface));
    double tolerance = 0;
    for (const FaceId part : faces) tolerance = std::max(tolerance, source_.tolerance(part));
    builder_.begin_face(surface, g.reversed, tolerance);
    builder_.set_constraint(keep_.constraint[f.index()]);
    from_.faces.push_back(f);

    std::vector<VertexId> alone;  // vertices of dropped edges, and points
    std::vector<CoedgeId> uses;
    bool all_kept = true;
    for (const FaceId part : faces) {
      for (const LoopId l : k_.loops(part)) {
        if (k_.is_vertex_loop(l)) alone.push_back(k_.loop_vertex(l));
        for (const CoedgeId c : k_.coedges(l)) {
          uses.push_back(c);
          if (keep_.edges[k_.edge(c).index()]) continue;
          all_kept = false;
          const bool bounds = merging_ == nullptr ? !is_inner_edge(source_, k_.edge(c), f) : other_use(c) == c;
          if (bounds)
            return Error{errors::bad_incidence, "a face is kept without an edge that bounds it", {f, k_.edge(c)}};
          alone.push_back(k_.start(c));
        }
      }
    }
    std::vector<VertexId> in_loops;
    if (all_kept) {
      for (const LoopId l : k_.loops(f)) {
        for (const CoedgeId c : k_.coedges(l)) copy_coedge(c);
        if (!k_.is_vertex_loop(l)) builder_.close_loop();
      }
    } else {
      trace_loops(uses, in_loops);
    }
    std::sort(alone.begin(), alone.end());
    alone.erase(std::unique(alone.begin(), alone.end()), alone.end());
    for (const VertexId v : alone) {
      if (!keep_.vertices[v.index()] || std::binary_search(in_loops.begin(), in_loops.end(), v)) continue;
      builder_.add_point_loop(new_vertex_[v.index()]);
      point_in_face_.push_back(v);
    }
    builder_.end_face();
    return {};
  }

  /// The loops of kept coedges: where a dropped edge leaves the loop, its other use leads on along the boundary.
  void trace_loops(const std::vector<CoedgeId>& uses, std::vector<VertexId>& in_loops) {
    for (const CoedgeId first : uses) {
      if (traced_[first.index()] || !keep_.edges[k_.edge(first).index()]) continue;
      for (CoedgeId c = first; !traced_[c.index()]; c = next_kept(c)) {
        traced_[c.index()] = true;
        in_loops.push_back(k_.start(c));
        copy_coedge(c);
      }
      builder_.close_loop();
    }
    std::sort(in_loops.begin(), in_loops.end());
  }

  CoedgeId next_kept(CoedgeId c) const {
    CoedgeId n = k_.next(c);
    while (!keep_.edges[k_.edge(n).index()]) n = k_.next(other_use(n));
    return n;
  }

  /// The use of c's edge on its other side in the same face or class of faces; c itself when there is none.
  CoedgeId other_use(CoedgeId c) const {
    const FaceId f = class_of(k_.face(c));
    for (CoedgeId d = k_.radial(c); d != c; d = k_.radial(d)) {
      if (class_of(k_.face(d)) == f && k_.reversed(d) != k_.reversed(c)) return d;
    }
    return c;
  }

  void copy_coedge(CoedgeId c) {
    bool reversed = k_.reversed(c);
    if (const auto* chain = chain_of(k_.edge(c))) {
      const auto link =
          std::find_if(chain->begin(), chain->end(), [&](const Merging::Link& l) { return l.edge == k_.edge(c); });
      reversed = reversed != link->reversed;
      const EdgeId first = reversed ? chain->back().edge : chain->front().edge;
      if (k_.edge(c) != first) return;  // the chain was copied with its first link
    }
    const EdgeId e = new_edge_[k_.edge(c).index()];
    if (const Curve2* image = source_.pcurve(c)) {
      builder_.add_coedge(e, reversed,
                          merging_ == nullptr ? *image : image->translated(merging_->shift[k_.face(c).index()]));
    } else {
      builder_.add_coedge(e, reversed);
    }
    coedges_.push_back(c);
  }

  void restrict_radial_order() {
    // The first use of a chain differs from face to face; every link of a chain has the same faces around it in the
    // same order, so each coedge stands for the chain's use by its face and side.
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> index;  // edge of the result, class of faces, against it?
    const auto key = [&](CoedgeId c) {
      bool reversed = k_.reversed(c);
      if (const auto* chain = chain_of(k_.edge(c))) {
        reversed = reversed != std::find_if(chain->begin(), chain->end(), [&](const Merging::Link& l) {
                                 return l.edge == k_.edge(c);
                               })->reversed;
      }
      return std::array<std::uint32_t, 3>{new_edge_[k_.edge(c).index()].value, class_of(k_.face(c)).value,
                                          reversed ? 1u : 0u};
    };
    std::vector<std::uint32_t> new_index(k_.coedge_count(), none);
    for (std::uint32_t i = 0; i < coedges_.size(); ++i) {
      new_index[coedges_[i].index()] = i;
      if (chain_of(k_.edge(coedges_[i])) != nullptr) index[key(coedges_[i])] = i;
    }
    const auto position = [&](CoedgeId c) {
      if (chain_of(k_.edge(c)) == nullptr) return new_index[c.index()];
      const auto found = index.find(key(c));
      return found == index.end() ? none : found->second;
    };
    std::vector<std::uint32_t> radial(coedges_.size());
    for (std::uint32_t i = 0; i < coedges_.size(); ++i) {
      CoedgeId c = k_.radial(coedges_[i]);
      while (position(c) == none) c = k_.radial(c);
      radial[i] = position(c);
    }
    builder_.set_radial_order(std::move(radial));
  }

  Cells result_cells() {
    Cells cells;
    cells.count = static_cast<std::uint32_t>(filled_.size());
    for (const FaceId f : from_.faces) {
      for (int side = 0; side < 2; ++side) cells.of_face_use.push_back(cell_[k_.region(FaceUse(f, side)).index()]);
    }
    std::vector<bool> on_face(from_.edges.size(), false), used(k_.vertex_count(), false);
    for (const CoedgeId c : coedges_) on_face[new_edge_[k_.edge(c).index()].index()] = true;
    for (const EdgeId e : k_.edges()) {
      if (keep_.edges[e.index()]) used[k_.start(e).index()] = used[k_.end(e).index()] = true;
    }
    for (const EdgeId e : from_.edges) {
      cells.of_edge.push_back(on_face[new_edge_[e.index()].index()] ? none : cell_[region_at(e).index()]);
    }
    for (const VertexId v : point_in_face_) used[v.index()] = true;
    for (const VertexId v : from_.vertices)
      cells.of_vertex.push_back(used[v.index()] ? none : cell_[region_at(v).index()]);
    return cells;
  }

  RegionId region_at(EdgeId e) const {
    return k_.is_wire(e) ? k_.region(k_.wire_shell(e)) : k_.region(k_.side_after(k_.first_coedge(e)));
  }

  RegionId region_at(VertexId v) const {
    if (const ShellId s = k_.isolated_in_shell(v); s.valid()) return k_.region(s);
    if (const auto loops = k_.vertex_loops(v); !loops.empty()) return k_.region(FaceUse(k_.face(loops.front()), 0));
    return region_at((*k_.edge_ends(v).begin()).edge);
  }

  const Model& source_;
  const Complex& k_;
  const Selection& keep_;
  const Merging* merging_;
  std::vector<bool> traced_ = std::vector<bool>(k_.coedge_count(), false);
  ModelBuilder builder_;
  ExtractionMap from_;
  std::vector<std::uint32_t> cell_;  // per region of the source
  std::vector<bool> filled_;         // per cell of the result
  std::vector<VertexId> new_vertex_;
  std::vector<EdgeId> new_edge_;
  std::vector<CurveId> new_curve_;
  std::vector<SurfaceId> new_surface_;
  std::vector<CoedgeId> coedges_;  // of the source, in the result's order
  std::vector<VertexId> point_in_face_;
};

}  // namespace

Selection empty_selection(const Model& model) {
  const Complex& k = model.topology();
  return {std::vector<bool>(k.vertex_count(), false), std::vector<bool>(k.edge_count(), false),
          std::vector<bool>(k.face_count(), false), std::vector<bool>(k.region_count(), false),
          std::vector<bool>(k.face_count(), false)};
}

void close_downwards(const Model& model, Selection& keep, bool inner) {
  const Complex& k = model.topology();
  for (const FaceId f : k.faces()) {
    if (!keep.faces[f.index()]) continue;
    for (const LoopId l : k.loops(f)) {
      if (inner && k.is_vertex_loop(l)) keep.vertices[k.loop_vertex(l).index()] = true;
      for (const CoedgeId c : k.coedges(l)) {
        if (inner || !is_inner_edge(model, k.edge(c), f)) keep.edges[k.edge(c).index()] = true;
      }
    }
  }
  for (const EdgeId e : k.edges()) {
    if (keep.edges[e.index()]) keep.vertices[k.start(e).index()] = keep.vertices[k.end(e).index()] = true;
  }
}

bool is_inner_edge(const Model& model, EdgeId edge, FaceId face) {
  const Complex& k = model.topology();
  CoedgeId uses[2];
  int count = 0;
  for (const CoedgeId c : k.coedges(edge)) {
    if (k.face(c) == face && count < 2) uses[count++] = c;
  }
  if (count < 2) return false;
  const Curve2 *a = model.pcurve(uses[0]), *b = model.pcurve(uses[1]);
  if (a == nullptr || b == nullptr) return true;
  // A seam's two images lie a period apart; an inner edge's are one.
  const double t = model.range(edge).at(0.5);
  const Vec2 period = model.surface(face).period(), gap = a->point(t) - b->point(t);
  return std::abs(gap.x) <= 0.25 * period.x + 1e-9 && std::abs(gap.y) <= 0.25 * period.y + 1e-9;
}

Result<Extraction> extract(const Model& source, const Selection& selection, const Merging* merging) {
  return Extractor(source, selection, merging).run();
}

}  // namespace aresta
