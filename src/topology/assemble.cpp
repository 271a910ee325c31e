// SPDX-License-Identifier: Apache-2.0
#include "topology/assemble.h"

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

Status check_loops(const Incidence& in) {
  if (in.loop_begin.size() != in.loop_vertex.size() + 1 || in.loop_begin.back() != in.coedges.size() ||
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
      if ((begin == end) != (in.loop_vertex[l] != none))
        return bad("a loop is neither coedges nor a vertex", {FaceId(f)});
      if (begin == end && in.loop_vertex[l] >= in.vertex_count)
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

Status check_radial(const Incidence& in) {
  if (in.radial_next.size() != in.coedges.size()) return bad("the radial order does not cover all coedges", {});
  std::vector<std::uint32_t> uses(in.edge_count(), 0), first(in.edge_count(), none);
  for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
    const std::uint32_t e = in.coedges[c] >> 1;
    ++uses[e];
    if (first[e] == none) first[e] = c;
  }
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (first[e] == none) continue;
    std::uint32_t c = first[e], length = 0;
    do {
      if (c >= in.coedges.size() || (in.coedges[c] >> 1) != e || length >= uses[e]) {
        return bad("the radial cycle of an edge does not go once through its coedges", {EdgeId(e)});
      }
      ++length;
      c = in.radial_next[c];
    } while (c != first[e]);
    if (length != uses[e]) return bad("the radial cycle of an edge leaves coedges out", {EdgeId(e)});
  }
  return {};
}

std::uint32_t side_after(const Incidence& in, std::uint32_t face, std::uint32_t c) {
  return 2 * face + (in.coedges[c] & 1u);
}
std::uint32_t side_before(const Incidence& in, std::uint32_t face, std::uint32_t c) {
  return 2 * face + (~in.coedges[c] & 1u);
}

Status check_regions(const Incidence& in, const std::vector<std::uint32_t>& face_of_coedge) {
  if (in.face_use_region.size() != 2 * std::size_t{in.face_count()} || in.edge_region.size() != in.edge_count() ||
      in.vertex_region.size() != in.vertex_count || in.region_filled.size() != in.region_count ||
      in.region_count == 0) {
    return bad("the regions do not cover all faces, edges and vertices", {});
  }
  for (std::uint32_t u = 0; u < in.face_use_region.size(); ++u) {
    if (in.face_use_region[u] >= in.region_count) return bad("a side of a face lies in no region", {FaceId(u / 2)});
  }
  for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
    const std::uint32_t next = in.radial_next[c];
    if (in.face_use_region[side_after(in, face_of_coedge[c], c)] !=
        in.face_use_region[side_before(in, face_of_coedge[next], next)]) {
      return bad("two sides of one sector about an edge lie in different regions",
                 {EdgeId(in.coedges[c] >> 1), FaceId(face_of_coedge[c]), FaceId(face_of_coedge[next])});
    }
  }
  std::vector<bool> edge_used(in.edge_count(), false), vertex_used(in.vertex_count, false);
  for (const std::uint32_t code : in.coedges) edge_used[code >> 1] = true;
  for (const auto& e : in.edges) vertex_used[e[0]] = vertex_used[e[1]] = true;
  for (const std::uint32_t v : in.loop_vertex) {
    if (v != none) vertex_used[v] = true;
  }
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (edge_used[e] ? in.edge_region[e] != none : in.edge_region[e] >= in.region_count) {
      return bad("a wire needs a region, an edge of a face must not have one", {EdgeId(e)});
    }
  }
  for (std::uint32_t v = 0; v < in.vertex_count; ++v) {
    if (vertex_used[v] ? in.vertex_region[v] != none : in.vertex_region[v] >= in.region_count) {
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
  const auto face = face_of_loop(in);
  auto result = loop_of_coedge(in);
  for (auto& item : result) item = face[item];
  return result;
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

/// Needs an incidence that passed the checks.
Complex assemble_unchecked(const Incidence& in) {
  Complex k;
  k.vertices_.resize(in.vertex_count);
  k.edges_.resize(in.edge_count());
  k.coedges_.resize(in.coedges.size());
  k.loops_.resize(in.loop_count());
  k.faces_.resize(in.face_count());

  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    auto& record = k.edges_.edit(e);
    for (std::uint32_t end = 0; end < 2; ++end) record.vertex[end] = in.edges[e][end];
  }
  // Edge ends around each vertex: a cycle in growing order of edge and end.
  std::vector<std::uint32_t> last(in.vertex_count, none);
  const auto link = [&](std::uint32_t from, std::uint32_t to) {
    k.edges_.edit(from >> 1).next[from & 1u] = to;
    k.edges_.edit(to >> 1).prev[to & 1u] = from;
  };
  for (std::uint32_t code = 0; code < 2 * in.edge_count(); ++code) {
    const std::uint32_t v = in.edges[code >> 1][code & 1u];
    if (last[v] == none) {
      k.vertices_.edit(v).first_end = code;
    } else {
      link(last[v], code);
    }
    last[v] = code;
  }
  for (std::uint32_t v = 0; v < in.vertex_count; ++v) {
    if (last[v] != none) link(last[v], k.vertices_[v].first_end);
  }

  for (std::uint32_t f = 0; f < in.face_count(); ++f) {
    k.faces_.edit(f).first_loop = in.face_begin[f];
    for (std::uint32_t l = in.face_begin[f]; l < in.face_begin[f + 1]; ++l) {
      const std::uint32_t begin = in.loop_begin[l], end = in.loop_begin[l + 1];
      const bool is_vertex = begin == end;
      auto& loop = k.loops_.edit(l);
      loop.face = f;
      loop.next = l + 1 < in.face_begin[f + 1] ? l + 1 : none;
      loop.prev = l > in.face_begin[f] ? l - 1 : in.face_begin[f + 1] - 1;
      loop.first = is_vertex ? in.loop_vertex[l] | Complex::tag : begin;
      if (is_vertex) {
        auto& owner = k.vertices_.edit(in.loop_vertex[l]).owner;
        k.point_uses_.push_back({l, owner});
        owner = static_cast<std::uint32_t>(k.point_uses_.size() - 1);
      }
      for (std::uint32_t c = begin; c < end; ++c) {
        auto& coedge = k.coedges_.edit(c);
        coedge = {c + 1 < end ? c + 1 : begin, c > begin ? c - 1 : end - 1, in.radial_next[c], in.coedges[c], l};
      }
    }
  }
  for (std::uint32_t c = static_cast<std::uint32_t>(in.coedges.size()); c-- > 0;) {
    k.edges_.edit(in.coedges[c] >> 1).first_use = c;  // the smallest coedge stays
  }

  // Shells. Items: face-uses, then edges (as wires), then vertices (isolated); a vertex ties the items of one region
  // there.
  const std::uint32_t uses = 2 * in.face_count(), items = uses + in.edge_count() + in.vertex_count;
  UnionFind sets(items);
  const auto face = face_of_coedge(in), loop_face = face_of_loop(in);
  for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
    const std::uint32_t next = in.radial_next[c];
    sets.unite(side_after(in, face[c], c), side_before(in, face[next], next));
  }
  struct Tie {
    std::uint32_t region, item;
  };
  std::vector<std::uint32_t> tie_begin(in.vertex_count + 1, 0);
  const auto for_all_ties = [&](auto&& visit) {
    for (std::uint32_t c = 0; c < in.coedges.size(); ++c) {
      for (std::uint32_t side = 0; side < 2; ++side) {
        const std::uint32_t use = 2 * face[c] + side;
        visit(coedge_start(in, c), Tie{in.face_use_region[use], use});
      }
    }
    for (std::uint32_t l = 0; l < in.loop_count(); ++l) {
      if (in.loop_vertex[l] == none) continue;
      for (std::uint32_t use = 2 * loop_face[l]; use < 2 * loop_face[l] + 2; ++use) {
        visit(in.loop_vertex[l], Tie{in.face_use_region[use], use});
      }
    }
    for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
      if (in.edge_region[e] == none) continue;
      for (const std::uint32_t v : in.edges[e]) visit(v, Tie{in.edge_region[e], uses + e});
    }
  };
  for_all_ties([&](std::uint32_t v, Tie) { ++tie_begin[v + 1]; });
  for (std::uint32_t v = 0; v < in.vertex_count; ++v) tie_begin[v + 1] += tie_begin[v];
  std::vector<Tie> ties(tie_begin.back());
  {
    std::vector<std::uint32_t> fill(tie_begin.begin(), tie_begin.end() - 1);
    for_all_ties([&](std::uint32_t v, Tie tie) { ties[fill[v]++] = tie; });
  }
  std::vector<std::uint32_t> representative(in.region_count, none);
  for (std::uint32_t v = 0; v < in.vertex_count; ++v) {
    for (std::uint32_t i = tie_begin[v]; i < tie_begin[v + 1]; ++i) {
      auto& first = representative[ties[i].region];
      if (first == none) {
        first = ties[i].item;
      } else {
        sets.unite(first, ties[i].item);
      }
    }
    for (std::uint32_t i = tie_begin[v]; i < tie_begin[v + 1]; ++i) representative[ties[i].region] = none;
  }

  k.regions_.resize(in.region_count);
  for (std::uint32_t r = 0; r < in.region_count; ++r) k.regions_.edit(r).filled = in.region_filled[r] ? 1 : 0;
  // Chains are linked both ways; the first member's prev is the last one.
  std::vector<std::uint32_t> shell_of_root(items, none);
  const auto shell_of = [&](std::uint32_t item, std::uint32_t region) {
    auto& shell = shell_of_root[sets.find(item)];
    if (shell == none) {
      shell = static_cast<std::uint32_t>(k.shells_.size());
      k.shells_.push_back({});
      auto& record = k.shells_.edit(shell);
      record.region = region;
      auto& first = k.regions_.edit(region).first_shell;
      if (first == none) {
        first = record.prev = shell;
      } else {
        auto& first_record = k.shells_.edit(first);
        record.prev = first_record.prev;
        k.shells_.edit(record.prev).next = shell;
        first_record.prev = shell;
      }
    }
    return shell;
  };
  for (std::uint32_t u = 0; u < uses; ++u) {
    const std::uint32_t shell = shell_of(u, in.face_use_region[u]);
    auto& record = k.faces_.edit(u / 2);
    record.shell[u % 2] = shell;
    auto& first = k.shells_.edit(shell).first_face_use;
    if (first == none) {
      first = record.prev_in_shell[u % 2] = u;
    } else {
      auto& last_use = k.faces_.edit(first / 2).prev_in_shell[first % 2];
      record.prev_in_shell[u % 2] = last_use;
      k.faces_.edit(last_use / 2).next_in_shell[last_use % 2] = u;
      last_use = u;
    }
  }
  for (std::uint32_t e = 0; e < in.edge_count(); ++e) {
    if (in.edge_region[e] == none) continue;
    const std::uint32_t shell = shell_of(uses + e, in.edge_region[e]);
    const auto wire = static_cast<std::uint32_t>(k.wires_.size());
    k.edges_.edit(e).first_use = wire | Complex::tag;
    auto& first = k.shells_.edit(shell).first_wire;
    if (first == none) {
      k.wires_.push_back({e, shell, none, wire});
      first = wire;
    } else {
      const std::uint32_t last_wire = k.wires_[first].prev;
      k.wires_.push_back({e, shell, none, last_wire});
      k.wires_.edit(last_wire).next = wire;
      k.wires_.edit(first).prev = wire;
    }
  }
  for (std::uint32_t v = 0; v < in.vertex_count; ++v) {
    if (in.vertex_region[v] == none) continue;
    const std::uint32_t shell = shell_of(uses + in.edge_count() + v, in.vertex_region[v]);
    k.shells_.edit(shell).vertex = v;
    k.vertices_.edit(v).owner = shell | Complex::tag;
  }
  return k;
}

Result<Complex> assemble(const Incidence& in) {
  ARESTA_CHECK(check_loops(in));
  ARESTA_CHECK(check_radial(in));
  ARESTA_CHECK(check_regions(in, face_of_coedge(in)));
  return assemble_unchecked(in);
}

}  // namespace aresta
