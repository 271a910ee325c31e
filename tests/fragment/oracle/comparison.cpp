// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fragment/oracle/operand_model.h"
#include "model/measure.h"

namespace aresta::grid {

namespace {

constexpr std::size_t most_lines = 40;
constexpr double relative = 1e-9;

class Comparison {
 public:
  Comparison(const Enumeration& expected, const Fragment& found)
      : expected_(expected),
        grid_(expected.whole),
        lattice_(grid_.lattice()),
        found_(found),
        model_(*found.model),
        k_(model_.topology()),
        placement_(expected.turn) {}

  std::vector<std::string> run() {
    compare_counts();
    if (!say_.empty() || !match_vertices() || !match_edges() || !match_faces()) return std::move(say_);
    compare_radial_order();
    if (!match_regions()) return std::move(say_);
    compare_fills_and_labels();
    compare_parents_and_pieces();
    compare_senses();
    compare_measures();
    return std::move(say_);
  }

 private:
  void say(const std::string& line) {
    if (say_.size() < most_lines) say_.push_back(line);
  }

  void compare_count(const char* what, std::size_t wanted, std::size_t found) {
    if (wanted != found)
      say(std::string(what) + ": " + std::to_string(found) + " where the grid has " + std::to_string(wanted));
  }

  void compare_counts() {
    std::size_t shells = 0, loops = 0;
    expected_shells_ = expected_.shells();
    for (const auto& list : expected_shells_) shells += list.size();
    for (std::size_t f = 0; f < grid_.count(EntityKind::face); ++f) loops += grid_.loops(FaceId(f)).size();
    compare_count("vertices", grid_.count(EntityKind::vertex), k_.vertex_count());
    compare_count("edges", grid_.count(EntityKind::edge), k_.edge_count());
    compare_count("faces", grid_.count(EntityKind::face), k_.face_count());
    compare_count("loops", loops, k_.loop_count());
    compare_count("cells", grid_.count(EntityKind::region), k_.region_count());
    compare_count("shells", shells, k_.shell_count());
    if (!say_.empty()) say_places();
  }

  /// Where counts differ: what is missing or too much, as far as it can be told apart.
  void say_places() {
    std::vector<bool> seen(grid_.count(EntityKind::vertex), false);
    for (const VertexId v : k_.vertices()) {
      const EntityRef entity = at_vertex(v);
      if (entity.kind == EntityKind::vertex && entity.index < seen.size() && !seen[entity.index]) {
        seen[entity.index] = true;
        continue;
      }
      const Vec3 p = model_.point(v);
      say("  a vertex too much at " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z));
    }
    for (std::size_t v = 0; v < seen.size(); ++v) {
      if (!seen[v]) say("  no vertex at " + text(VertexId(v)));
    }
  }

  /// What the grid has where a vertex of the model is; an entity without index when that is not on the lattice.
  EntityRef at_vertex(VertexId v) const {
    const auto at = placement_.steps(model_.point(v));
    if (!at || !std::all_of(at->begin(), at->end(), [&](int c) { return c >= 0 && c <= lattice_.steps(); })) return {};
    return grid_.carrier(lattice_.point(*at));
  }

  std::string text(EntityRef entity) const {
    const auto& pieces = grid_.pieces(entity);
    if (entity.kind == EntityKind::region && entity.index == 0) return "outside";
    std::string result = lattice_.text(pieces.front());
    if (pieces.size() > 1) result += "+" + std::to_string(pieces.size() - 1);
    return std::string(to_string(entity.kind)) + " " + result;
  }

  bool match_vertices() {
    std::vector<bool> seen(grid_.count(EntityKind::vertex), false);
    for (const VertexId v : k_.vertices()) {
      const EntityRef entity = at_vertex(v);
      if (entity.kind != EntityKind::vertex || entity.index >= seen.size() || seen[entity.index]) {
        say_places();
        return false;
      }
      seen[entity.index] = true;
      vertex_.push_back(entity.index);
    }
    return true;
  }

  bool match_edges() {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> wanted;
    for (std::size_t e = 0; e < grid_.count(EntityKind::edge); ++e)
      wanted[grid_.ends(EdgeId(e))] = static_cast<std::uint32_t>(e);
    for (const EdgeId e : k_.edges()) {
      const std::uint32_t a = vertex_[k_.start(e).index()], b = vertex_[k_.end(e).index()];
      auto it = wanted.find({a, b});
      const bool up = it != wanted.end();
      if (!up) it = wanted.find({b, a});
      if (it == wanted.end()) {
        say("no such edge, or twice: from " + text(VertexId(a)) + " to " + text(VertexId(b)));
        continue;
      }
      if (!model_.is_straight(e)) say("not straight: " + text(EdgeId(it->second)));
      edge_.push_back(it->second);
      edge_up_.push_back(up);
      wanted.erase(it);
    }
    return say_.empty();
  }

  // A face is known by its loops, as sets of lattice edges with directions, seen against its axis.
  using LoopKey = std::vector<Pass>;
  using FaceKey = std::pair<int, std::vector<LoopKey>>;

  static FaceKey key_of(int axis, std::vector<LoopKey> loops) {
    for (LoopKey& loop : loops) std::sort(loop.begin(), loop.end());
    std::sort(loops.begin(), loops.end());
    return {axis, std::move(loops)};
  }

  bool match_faces() {
    std::map<FaceKey, std::uint32_t> wanted;
    for (std::size_t f = 0; f < grid_.count(EntityKind::face); ++f) {
      std::vector<LoopKey> loops;
      for (const GridLoop& loop : grid_.loops(FaceId(f)))
        loops.push_back(loop.passes.empty() ? LoopKey{{loop.point, true}} : loop.passes);
      wanted[key_of(grid_.axis(FaceId(f)), std::move(loops))] = static_cast<std::uint32_t>(f);
    }
    for (const FaceId f : k_.faces()) {
      int axis = 0;
      if (!model_.surface(f).is_plane()) {
        say("a face is not plane");
        continue;
      }
      const Vec3 normal = model_.normal(f, {});
      for (int a = 1; a < 3; ++a) {
        if (std::abs(dot(normal, placement_.direction(a))) > std::abs(dot(normal, placement_.direction(axis))))
          axis = a;
      }
      const double along = dot(normal, placement_.direction(axis));
      if (std::abs(along) < 1 - relative) say("a face is askew");
      const bool face_up = along > 0;
      std::vector<LoopKey> loops;
      for (const LoopId l : k_.loops(f)) {
        LoopKey& key = loops.emplace_back();
        if (k_.is_vertex_loop(l)) {
          key.push_back({grid_.pieces(VertexId(vertex_[k_.loop_vertex(l).index()])).front(), true});
          continue;
        }
        for (const CoedgeId c : k_.coedges(l)) {
          const std::size_t e = k_.edge(c).index();
          const bool up = (edge_up_[e] != k_.reversed(c)) == face_up;
          for (const Piece p : grid_.pieces(EdgeId(edge_[e]))) key.push_back({p, up});
        }
      }
      const auto it = wanted.find(key_of(axis, std::move(loops)));
      if (it == wanted.end()) {
        say("no such face, or twice; across axis " + std::to_string(axis) + ", " + corners(f));
        continue;
      }
      face_.push_back(it->second);
      face_up_.push_back(face_up);
      wanted.erase(it);
    }
    if (say_.empty()) return true;
    for (const auto& [key, f] : wanted) say("  no face like " + text(FaceId(f)));
    return false;
  }

  std::string corners(FaceId f) const {
    std::string result;
    for (const LoopId l : k_.loops(f)) {
      result += result.empty() ? "loops" : ";";
      if (k_.is_vertex_loop(l)) result += " point";
      for (const CoedgeId c : k_.coedges(l))
        result += " " + lattice_.text(grid_.pieces(VertexId(vertex_[k_.start(c).index()])).front());
    }
    return result;
  }

  void compare_radial_order() {
    for (const EdgeId e : k_.edges()) {
      const auto wanted = radial_uses(grid_, EdgeId(edge_[e.index()]));
      std::vector<RadialUse> uses;
      for (const CoedgeId c : k_.coedges(e)) {
        const FaceId f = k_.face(c);
        const bool up = (edge_up_[e.index()] != k_.reversed(c)) == face_up_[f.index()];
        uses.push_back({FaceId(face_[f.index()]), up});
      }
      if (!edge_up_[e.index()]) std::reverse(uses.begin(), uses.end());
      bool same = uses.size() == wanted.size();
      if (same && !uses.empty()) {
        const auto first = std::find(uses.begin(), uses.end(), wanted.front());
        std::rotate(uses.begin(), first, uses.end());
        same = uses == wanted;
      }
      if (!same) say("radial order about " + text(EdgeId(edge_[e.index()])));
    }
  }

  bool match_regions() {
    std::vector<bool> seen(grid_.count(EntityKind::region), false);
    for (const RegionId r : k_.regions()) {
      std::vector<Enumeration::Shell> shells;
      for (const ShellId s : k_.shells(r)) {
        auto& shell = shells.emplace_back();
        for (const FaceUse use : k_.face_uses(s)) {
          const std::size_t f = use.face().index();
          shell.push_back({FaceId(face_[f]), face_up_[f] == (use.side() == 0)});
        }
        for (const EdgeId e : k_.wires(s)) shell.push_back({EdgeId(edge_[e.index()]), false});
        if (const VertexId v = k_.shell_vertex(s); v.valid()) shell.push_back({VertexId(vertex_[v.index()]), false});
        std::sort(shell.begin(), shell.end());
      }
      std::sort(shells.begin(), shells.end());
      const auto it = std::find(expected_shells_.begin(), expected_shells_.end(), shells);
      const std::size_t cell = static_cast<std::size_t>(it - expected_shells_.begin());
      if (it == expected_shells_.end() || seen[cell] || (cell == 0) != (r == Complex::infinite_region())) {
        std::string of = "no such cell, or twice: " + std::to_string(shells.size()) + " shells";
        if (!shells.empty() && !shells[0].empty()) of += ", at " + text(shells[0][0].entity);
        say(of);
        continue;
      }
      seen[cell] = true;
      region_.push_back(static_cast<std::uint32_t>(cell));
    }
    return say_.empty();
  }

  void compare_fills_and_labels() {
    for (const RegionId r : k_.regions()) {
      const RegionId cell(region_[r.index()]);
      if (k_.is_filled(r) != expected_.filled[cell.index()])
        say(text(cell) + (k_.is_filled(r) ? " is filled" : " is not filled"));
      for (std::size_t o = 0; o < expected_.operands.size(); ++o) {
        const RegionId around = found_.labels.region_of(static_cast<std::uint32_t>(o), r),
                       wanted = expected_.region_of(o, cell);
        if (around != wanted) {
          say(text(cell) + " is in region " + std::to_string(around.value) + " of operand " + std::to_string(o) +
              ", by the grid in " + std::to_string(wanted.value));
        }
      }
    }
  }

  static std::string text(std::span<const Parent> parents) {
    std::string result;
    for (const Parent& p : parents)
      result += " " + std::to_string(p.source) + ":" + to_string(p.entity.kind) + std::to_string(p.entity.index);
    return result.empty() ? " none" : result;
  }

  void compare_parents_and_pieces() {
    std::map<Parent, std::vector<std::uint32_t>> pieces;
    const auto visit = [&](EntityRef entity, EntityRef in_grid) {
      const auto wanted = expected_.parents(in_grid);
      const auto parents = found_.parents(entity);
      if (!std::equal(parents.begin(), parents.end(), wanted.begin(), wanted.end()))
        say("parents of " + text(in_grid) + ":" + text(parents) + ", by the grid" + text(wanted));
      for (const Parent& p : wanted) {
        if (p.entity.kind == entity.kind && entity.kind != EntityKind::region) pieces[p].push_back(entity.index);
      }
    };
    for (const VertexId v : k_.vertices()) visit(v, VertexId(vertex_[v.index()]));
    for (const EdgeId e : k_.edges()) visit(e, EdgeId(edge_[e.index()]));
    for (const FaceId f : k_.faces()) visit(f, FaceId(face_[f.index()]));
    for (const RegionId r : k_.regions()) visit(r, RegionId(region_[r.index()]));
    for (std::uint32_t o = 0; o < expected_.operands.size(); ++o) {
      for (const EntityKind kind : {EntityKind::vertex, EntityKind::edge, EntityKind::face}) {
        for (std::uint32_t i = 0; i < expected_.operands[o].complex.count(kind); ++i) {
          const EntityRef entity(kind, i);
          const auto& wanted = pieces[{o, entity}];
          const auto listed = found_.pieces(o, entity);
          if (!std::equal(listed.begin(), listed.end(), wanted.begin(), wanted.end()))
            say("pieces of " + std::string(to_string(kind)) + " " + std::to_string(i) + " of operand " +
                std::to_string(o));
        }
      }
    }
  }

  void compare_senses() {
    for (const FaceId f : k_.faces()) {
      std::vector<bool> wanted;
      for (const Parent& p : expected_.parents(FaceId(face_[f.index()])))
        wanted.push_back(face_up_[f.index()] != runs_down(p.entity));
      if (found_.same_sense[f.index()] != wanted) say("senses of " + text(FaceId(face_[f.index()])));
    }
  }

  void compare_measure(const Result<Moments>& found, double wanted, EntityRef in_grid) {
    if (!found.ok()) return say("no measure of " + text(in_grid) + ": " + found.error().to_line());
    if (std::abs(found->measure - wanted) > relative * wanted)
      say("measure of " + text(in_grid) + ": " + std::to_string(found->measure) + " for " + std::to_string(wanted));
  }

  void compare_measures() {
    const double scale = placement_.scale();
    const auto wanted = [&](EntityRef in_grid) { return static_cast<double>(grid_.pieces(in_grid).size()); };
    for (const EdgeId e : k_.edges()) {
      const EdgeId in_grid(edge_[e.index()]);
      compare_measure(measure(model_, e), wanted(in_grid) * scale, in_grid);
    }
    for (const FaceId f : k_.faces()) {
      const FaceId in_grid(face_[f.index()]);
      compare_measure(measure(model_, f), wanted(in_grid) * scale * scale, in_grid);
    }
    for (const RegionId r : k_.regions()) {
      if (r == Complex::infinite_region()) continue;
      const RegionId in_grid(region_[r.index()]);
      compare_measure(measure(model_, r), wanted(in_grid) * scale * scale * scale, in_grid);
    }
  }

  const Enumeration& expected_;
  const GridComplex& grid_;
  const Lattice& lattice_;
  const Fragment& found_;
  const Model& model_;
  const Complex& k_;
  Placement placement_;
  std::vector<std::vector<Enumeration::Shell>> expected_shells_;
  // What each entity of the model is in the grid, and whether it runs in the positive direction of its axis.
  std::vector<std::uint32_t> vertex_, edge_, face_, region_;
  std::vector<bool> edge_up_, face_up_;
  std::vector<std::string> say_;
};

}  // namespace

std::vector<std::string> compare(const Enumeration& expected, const Fragment& found) {
  return Comparison(expected, found).run();
}

}  // namespace aresta::grid
