// SPDX-License-Identifier: Apache-2.0
#include "topology/assemble.h"

#include <algorithm>
#include <utility>

#include "base/large_pages.h"
#include "base/union_find.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;

Error bad(const std::string& message, std::vector<EntityRef> entities) {
  return Error{errors::bad_incidence, message, std::move(entities)};
}

std::uint32_t coedge_start(const Incidence& in, std::uint32_t c) {
  return in.edges[in.coedges[c] >> 1][in.coedges[c] & 1u];
}
std::uint32_t coedge_end(const Incidence& in, std::uint32_t c) {
  return in.edges[in.coedges[c] >> 1][~in.coedges[c] & 1u];
}

/// An entry of an array that may be empty.
std::uint32_t at(const std::vector<std::uint32_t>& array, std::uint32_t i) {
  return array.empty() ? none : array[i];
}
bool fits(const std::vector<std::uint32_t>& array, std::uint32_t count) {
  return array.empty() || array.size() == count;
}

Status check_loops(const Incidence& in) {
  if (!fits(in.loop_vertex, in.loop_count()) || in.loop_begin.back() != in.coedges.size() ||
      in.face_begin.back() != in.loop_count()) {
    return bad("the arrays of loops and faces do not fit together", {});
  }
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (in.edges[e][0] >= in.vertex_count || in.edges[e][1] >= in.vertex_count) {
      return bad("an edge names a vertex that does not exist", {EdgeId(e)});
    }
  }
  for (const std::uint32_t code : in.coedges) {
    if ((code >> 1) >= in.edge_count()) return bad("a loop names an edge that does not exist", {});
  }
  for (std::uint32_t f = 0; f < in.face_count(); ++f) {
    if (in.face_begin[f] >= in.face_begin[f + 1]) return bad("a face has no loop", {FaceId(f)});
    for (std::uint32_t l = in.face_begin[f]; l < in.face_begin[f + 1]; ++l) {
      const std::uint32_t begin = in.loop_begin[l], end = in.loop_begin[l + 1];
      if ((begin == end) != (at(in.loop_vertex, l) != none))
        return bad("a loop is neither coedges nor a vertex", {FaceId(f)});
      if (begin == end && at(in.loop_vertex, l) >= in.vertex_count)
        return bad("a loop names a vertex that does not exist", {FaceId(f)});
      for (std::uint32_t c = begin; c < end; ++c) {
        const std::uint32_t next = c + 1 < end ? c + 1 : begin;
        if (coedge_end(in, c) != coedge_start(in, next)) {
          return bad("a loop is open: an edge does not start where the one before it ends",
                     {FaceId(f), EdgeId(in.coedges[c] >> 1), EdgeId(in.coedges[next] >> 1)});
        }
      }
    }
  }
  return {};
}

Status check_radial(const Incidence& in, const std::vector<std::uint32_t>& first_use) {
  std::size_t covered = 0;
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    const std::uint32_t first = first_use[e];
    if (first == none) continue;
    std::uint32_t c = first;
    do {
      // A cycle that comes back to another coedge than its first goes on until more are covered than there are.
      if (c >= in.coedges.size() || (in.coedges[c] >> 1) != e || covered >= in.coedges.size()) {
        return bad("the radial cycle of an edge does not go once through its coedges", {EdgeId(e)});
      }
      ++covered;
      c = in.radial_next[c];
    } while (c != first);
  }
  if (covered == in.coedges.size()) return {};
  std::vector<bool> is_covered(in.coedges.size(), false);
  for (const std::uint32_t first : first_use) {
    for (std::uint32_t c = first; c != none && !is_covered[c]; c = in.radial_next[c]) is_covered[c] = true;
  }
  const auto left_out =
      static_cast<std::size_t>(std::find(is_covered.begin(), is_covered.end(), false) - is_covered.begin());
  return bad("the radial cycle of an edge leaves coedges out", {EdgeId(in.coedges[left_out] >> 1)});
}

std::uint32_t side_after(const Incidence& in, std::uint32_t face, std::uint32_t c) {
  return 2 * face + (in.coedges[c] & 1u);
}
std::uint32_t side_before(const Incidence& in, std::uint32_t face, std::uint32_t c) {
  return 2 * face + (~in.coedges[c] & 1u);
}

Status check_regions(const Incidence& in, const std::vector<std::uint32_t>& first_use) {
  if (in.face_use_region.size() != 2 * std::size_t{in.face_count()} || !fits(in.edge_region, in.edge_count()) ||
      !fits(in.vertex_region, in.vertex_count) || in.region_filled.size() != in.region_count || in.region_count == 0) {
    return bad("the regions do not cover all faces, edges and vertices", {});
  }
  for (std::uint32_t u = 0; u < in.face_use_region.size(); ++u) {
    if (in.face_use_region[u] >= in.region_count) return bad("a side of a face lies in no region", {FaceId(u / 2)});
  }
  std::vector<bool> vertex_used(in.vertex_count, false);
  for (const auto& e : in.edges) vertex_used[e[0]] = vertex_used[e[1]] = true;
  for (const std::uint32_t v : in.loop_vertex) {
    if (v != none) vertex_used[v] = true;
  }
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    const std::uint32_t region = at(in.edge_region, e);
    if (first_use[e] != none ? region != none : region >= in.region_count) {
      return bad("a wire needs a region, an edge of a face must not have one", {EdgeId(e)});
    }
  }
  for (std::uint32_t v = 0; v < in.vertex_count; ++v) {
    const std::uint32_t region = at(in.vertex_region, v);
    if (vertex_used[v] ? region != none : region >= in.region_count) {
      return bad("an isolated vertex needs a region, any other must not have one", {VertexId(v)});
    }
  }
  return {};
}

}  // namespace

std::vector<std::uint32_t> face_of_loop(const Incidence& in) {
  std::vector<std::uint32_t> face(in.loop_count());
  for (std::uint32_t f = 0; f < in.face_count(); ++f) {
    for (std::uint32_t l = in.face_begin[f]; l < in.face_begin[f + 1]; ++l) face[l] = f;
  }
  return face;
}

std::vector<std::uint32_t> loop_of_coedge(const Incidence& in) {
  std::vector<std::uint32_t> loop(in.coedges.size());
  for (std::uint32_t l = 0; l < in.loop_count(); ++l) {
    for (std::uint32_t c = in.loop_begin[l]; c < in.loop_begin[l + 1]; ++c) loop[c] = l;
  }
  return loop;
}

static std::vector<std::uint32_t> face_of_coedge(const Incidence& in) {
  auto face = vector_in_large_pages(in.coedges.size(), none);
  for (std::uint32_t f = 0; f < in.face_count(); ++f) {
    const std::uint32_t end = in.loop_begin[in.face_begin[f + 1]];
    for (std::uint32_t c = in.loop_begin[in.face_begin[f]]; c < end; ++c) face[c] = f;
  }
  return face;
}

std::vector<std::uint32_t> side_components(const Incidence& in) {
  const auto face = face_of_coedge(in);
  UnionFind sides(2 * std::size_t{in.face_count()});
  for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
    const std::uint32_t next = in.radial_next[c];
    sides.unite(side_after(in, face[c], c), side_before(in, face[next], next));
  }
  std::vector<std::uint32_t> component(sides.size());
  for (std::uint32_t u = 0; u < component.size(); ++u) component[u] = sides.find(u);
  return component;
}

/// The smallest coedge of each edge; none for a wire.
static std::vector<std::uint32_t> first_use_of_edge(const Incidence& in) {
  auto first = vector_in_large_pages(in.edge_count(), none);
  for (auto c = static_cast<std::uint32_t>(in.coedges.size()); c-- > 0;) first[in.coedges[c] >> 1] = c;
  return first;
}

namespace {

/// What makes a shell, as items: face-uses, then edges (as wires), then vertices (isolated). Needs an incidence that
/// passed the checks above.
class ShellItems {
 public:
  ShellItems(const Incidence& in, const std::vector<std::uint32_t>& face_of_coedge)
      : in_(in), face_(face_of_coedge), sets_(item_count(in)) {}

  /// Joins what is connected. Goes on past an error, which is about sides of one sector in two regions.
  Status join() {
    Status status;
    for (std::uint32_t c = 0; c < in_.coedges.size(); ++c) {
      const std::uint32_t next = in_.radial_next[c];
      const std::uint32_t after = side_after(in_, face_[c], c), before = side_before(in_, face_[next], next);
      if (in_.face_use_region[after] != in_.face_use_region[before] && status.ok()) {
        status = bad("two sides of one sector about an edge lie in different regions",
                     {EdgeId(in_.coedges[c] >> 1), FaceId(face_[c]), FaceId(face_[next])});
      }
      sets_.unite(after, before);
    }
    if (!status.ok() || vertices_may_join()) join_at_vertices();
    return status;
  }

  static std::uint32_t face_uses(const Incidence& in) { return 2 * in.face_count(); }
  static std::uint32_t edge(const Incidence& in, std::uint32_t e) { return face_uses(in) + e; }
  static std::uint32_t vertex(const Incidence& in, std::uint32_t v) { return face_uses(in) + in.edge_count() + v; }

  /// The smallest item of the same shell.
  std::uint32_t smallest(std::uint32_t item) { return sets_.find(item); }
  std::size_t size() const { return sets_.size(); }

 private:
  struct Tie {
    std::uint32_t region, item;
  };

  /// Items of wires and vertices only where there are any: a mesh has none.
  static std::size_t item_count(const Incidence& in) {
    const auto is_used = [](std::uint32_t region) { return region != none; };
    const bool has_others = std::any_of(in.edge_region.begin(), in.edge_region.end(), is_used) ||
                            std::any_of(in.vertex_region.begin(), in.vertex_region.end(), is_used);
    return std::size_t{face_uses(in)} + (has_others ? std::size_t{in.edge_count()} + in.vertex_count : 0);
  }

  /// Has any region several components that could touch in a vertex?
  bool vertices_may_join() {
    std::vector<bool> has_one(in_.region_count, false);
    const auto is_second = [&](std::uint32_t region) {
      const bool second = has_one[region];
      has_one[region] = true;
      return second;
    };
    for (std::uint32_t use = 0; use < face_uses(in_); ++use) {
      if (sets_.find(use) == use && is_second(in_.face_use_region[use])) return true;
    }
    return std::any_of(in_.edge_region.begin(), in_.edge_region.end(),
                       [&](std::uint32_t region) { return region != none && is_second(region); });
  }

  /// A vertex ties the items of one region there.
  void join_at_vertices() {
    const auto loop_face = face_of_loop(in_);
    const auto for_all_ties = [&](auto&& visit) {
      for (std::uint32_t c = 0; c < in_.coedges.size(); ++c) {
        for (std::uint32_t side = 0; side < 2; ++side) {
          const std::uint32_t use = 2 * face_[c] + side;
          visit(coedge_start(in_, c), Tie{in_.face_use_region[use], use});
        }
      }
      for (std::uint32_t l = 0; l < in_.loop_vertex.size(); ++l) {
        if (in_.loop_vertex[l] == none) continue;
        for (std::uint32_t use = 2 * loop_face[l]; use < 2 * loop_face[l] + 2; ++use) {
          visit(in_.loop_vertex[l], Tie{in_.face_use_region[use], use});
        }
      }
      for (std::uint32_t e = 0; e < in_.edge_region.size(); ++e) {
        if (in_.edge_region[e] == none) continue;
        for (const std::uint32_t v : in_.edges[e]) visit(v, Tie{in_.edge_region[e], edge(in_, e)});
      }
    };
    std::vector<std::uint32_t> begin(in_.vertex_count + 1, 0);
    for_all_ties([&](std::uint32_t v, Tie) { ++begin[v + 1]; });
    for (std::uint32_t v = 0; v < in_.vertex_count; ++v) begin[v + 1] += begin[v];
    std::vector<Tie> ties(begin.back());
    std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
    for_all_ties([&](std::uint32_t v, Tie tie) { ties[fill[v]++] = tie; });

    std::vector<std::uint32_t> representative(in_.region_count, none);
    for (std::uint32_t v = 0; v < in_.vertex_count; ++v) {
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
        auto& first = representative[ties[i].region];
        if (first == none) {
          first = ties[i].item;
        } else {
          sets_.unite(first, ties[i].item);
        }
      }
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) representative[ties[i].region] = none;
    }
  }

  const Incidence& in_;
  const std::vector<std::uint32_t>& face_;
  UnionFind sets_;
};

}  // namespace

/// Writes the records of an incidence that passed the checks.
class Assembler {
 public:
  Assembler(const Incidence& in, const std::vector<std::uint32_t>& first_use, ShellItems& items)
      : in_(in), first_use_(first_use), items_(items) {}

  Complex build() {
    write_edges();
    write_faces();
    write_shells();
    return std::move(k_);
  }

 private:
  void write_edges() {
    k_.vertices_.generate(in_.vertex_count, [](std::size_t) { return Complex::VertexRecord{}; });
    k_.edges_.generate(in_.edge_count(), [&](std::size_t e) {
      return Complex::EdgeRecord{{in_.edges[e][0], in_.edges[e][1]}, {none, none}, {none, none}, first_use_[e]};
    });
    const auto vertices = k_.vertices_.write_all();
    const auto edges = k_.edges_.write_all();
    // Edge ends around each vertex: a cycle in growing order of edge and end.
    std::vector<std::uint32_t> last(in_.vertex_count, none);
    const auto link = [&](std::uint32_t from, std::uint32_t to) {
      edges[from >> 1].next[from & 1u] = to;
      edges[to >> 1].prev[to & 1u] = from;
    };
    for (std::uint32_t e = 0; e < in_.edge_count(); ++e) {
      for (std::uint32_t end = 0; end < 2; ++end) {
        const std::uint32_t v = in_.edges[e][end], code = 2 * e + end;
        if (last[v] == none) {
          vertices[v].first_end = code;
        } else {
          link(last[v], code);
        }
        last[v] = code;
      }
    }
    for (std::uint32_t v = 0; v < in_.vertex_count; ++v) {
      if (last[v] != none) link(last[v], vertices[v].first_end);
    }
  }

  void write_faces() {
    std::uint32_t l = 0, f = 0;  // of the item that is made
    k_.coedges_.generate(in_.coedges.size(), [&](std::size_t item) -> Complex::CoedgeRecord {
      const auto c = static_cast<std::uint32_t>(item);
      while (c >= in_.loop_begin[l + 1]) ++l;
      const std::uint32_t begin = in_.loop_begin[l], end = in_.loop_begin[l + 1];
      return {c + 1 < end ? c + 1 : begin, c > begin ? c - 1 : end - 1, in_.radial_next[c], in_.coedges[c], l};
    });
    k_.loops_.generate(in_.loop_count(), [&](std::size_t item) -> Complex::LoopRecord {
      const auto loop = static_cast<std::uint32_t>(item);
      while (loop >= in_.face_begin[f + 1]) ++f;
      const std::uint32_t begin = in_.face_begin[f], end = in_.face_begin[f + 1], vertex = at(in_.loop_vertex, loop);
      if (vertex != none) {
        auto& owner = k_.vertices_.edit(vertex).owner;
        k_.point_uses_.push_back({loop, owner});
        owner = static_cast<std::uint32_t>(k_.point_uses_.size() - 1);
      }
      return {vertex != none ? vertex | Complex::tag : in_.loop_begin[loop], loop + 1 < end ? loop + 1 : none,
              loop > begin ? loop - 1 : end - 1, f};
    });
  }

  /// Shells in the order of their smallest items; in each, face-uses and wires in growing order. Chains are linked both
  /// ways; the first member's prev is the last one.
  void write_shells() {
    k_.regions_.resize(in_.region_count);
    const auto regions = k_.regions_.write_all();
    for (std::uint32_t r = 0; r < in_.region_count; ++r) regions[r].filled = in_.region_filled[r] ? 1 : 0;

    k_.faces_.generate(in_.face_count(), [&](std::size_t f) { return Complex::FaceRecord{in_.face_begin[f]}; });
    const auto faces = k_.faces_.write_all();
    const std::uint32_t uses = ShellItems::face_uses(in_);
    std::vector<std::uint32_t> shell_of_other(items_.size() - uses, none);  // of a smallest item that is no face-use
    std::vector<Complex::ShellRecord> shells;
    const auto shell_of = [&](std::uint32_t item, std::uint32_t region) {
      const std::uint32_t smallest = items_.smallest(item);
      auto& shell = smallest < uses ? faces[smallest / 2].shell[smallest % 2] : shell_of_other[smallest - uses];
      if (shell == none) {
        shell = static_cast<std::uint32_t>(shells.size());
        auto& first = regions[region].first_shell;
        std::uint32_t prev = shell;
        if (first == none) {
          first = shell;
        } else {
          prev = std::exchange(shells[first].prev, shell);
          shells[prev].next = shell;
        }
        shells.push_back({});
        shells.back().region = region;
        shells.back().prev = prev;
      }
      return shell;
    };

    std::vector<std::uint32_t> last_use;  // per shell
    for (std::uint32_t u = 0; u < uses; ++u) {
      const std::uint32_t shell = shell_of(u, in_.face_use_region[u]);
      if (last_use.size() < shells.size()) last_use.push_back(none);
      faces[u / 2].shell[u % 2] = shell;
      const std::uint32_t last = std::exchange(last_use[shell], u);
      if (last == none) {
        shells[shell].first_face_use = u;
      } else {
        faces[u / 2].prev_in_shell[u % 2] = last;
        faces[last / 2].next_in_shell[last % 2] = u;
      }
    }
    for (std::uint32_t s = 0; s < last_use.size(); ++s) {
      const std::uint32_t first = shells[s].first_face_use;
      faces[first / 2].prev_in_shell[first % 2] = last_use[s];
    }
    for (std::uint32_t e = 0; e < in_.edge_region.size(); ++e) {
      if (in_.edge_region[e] == none) continue;
      const std::uint32_t shell = shell_of(ShellItems::edge(in_, e), in_.edge_region[e]);
      const auto wire = static_cast<std::uint32_t>(k_.wires_.size());
      k_.edges_.edit(e).first_use = wire | Complex::tag;
      auto& first = shells[shell].first_wire;
      if (first == none) {
        k_.wires_.push_back({e, shell, none, wire});
        first = wire;
      } else {
        const std::uint32_t last_wire = k_.wires_[first].prev;
        k_.wires_.push_back({e, shell, none, last_wire});
        k_.wires_.edit(last_wire).next = wire;
        k_.wires_.edit(first).prev = wire;
      }
    }
    for (std::uint32_t v = 0; v < in_.vertex_region.size(); ++v) {
      if (in_.vertex_region[v] == none) continue;
      const std::uint32_t shell = shell_of(ShellItems::vertex(in_, v), in_.vertex_region[v]);
      shells[shell].vertex = v;
      k_.vertices_.edit(v).owner = shell | Complex::tag;
    }
    k_.shells_.generate(shells.size(), [&](std::size_t s) { return shells[s]; });
  }

  const Incidence& in_;
  const std::vector<std::uint32_t>& first_use_;
  ShellItems& items_;
  Complex k_;
};

/// For tests of the checker: any incidence whose indices are in range.
Complex assemble_unchecked(const Incidence& in) {
  const auto first_use = first_use_of_edge(in);
  const auto face = face_of_coedge(in);
  ShellItems items(in, face);
  static_cast<void>(items.join());
  return Assembler(in, first_use, items).build();
}

Result<Complex> assemble(const Incidence& in) {
  ARESTA_CHECK(check_loops(in));
  if (in.radial_next.size() != in.coedges.size()) return bad("the radial order does not cover all coedges", {});
  const auto first_use = first_use_of_edge(in);
  ARESTA_CHECK(check_radial(in, first_use));
  ARESTA_CHECK(check_regions(in, first_use));
  const auto face = face_of_coedge(in);
  ShellItems items(in, face);
  ARESTA_CHECK(items.join());
  return Assembler(in, first_use, items).build();
}

}  // namespace aresta
