// SPDX-License-Identifier: Apache-2.0
#include "fragment/identity.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/union_find.h"
#include "fragment/errors.h"
#include "geometry/image.h"
#include "model/query.h"

namespace aresta {

namespace {

/// An entity of an operand; entities of one kind of all operands are numbered through.
struct Item {
  std::uint32_t operand = 0, index = 0;
};

class Uniter {
 public:
  Uniter(std::span<const std::shared_ptr<const Model>> operands, double tolerance, const Context& context)
      : operands_(operands), tolerance_(tolerance), context_(context) {}

  Result<Identity> run() {
    number();
    ARESTA_CHECK(context_.step(0, "finding vertices that coincide"));
    ARESTA_CHECK(unite_vertices());
    ARESTA_CHECK(context_.step(0.02, "finding edges that coincide"));
    ARESTA_CHECK(unite_edges());
    ARESTA_CHECK(context_.step(0.04, "finding faces that coincide"));
    ARESTA_CHECK(unite_faces());
    nest_tolerances();
    ARESTA_CHECK(build());
    return std::move(out_);
  }

 private:
  /// Entities of one kind: which are one, and what their root has to answer for.
  struct Kind {
    EntityKind kind = EntityKind::vertex;
    std::vector<Item> items;
    std::vector<std::uint32_t> first;  // per operand
    std::vector<std::uint32_t> root;
    std::vector<bool> turned;         // against its root
    std::vector<double> tolerance;    // of roots: covers all that became them
    std::vector<std::uint32_t> made;  // of roots: the entity in the imprint

    std::uint32_t at(std::uint32_t operand, std::size_t index) const {
      return first[operand] + static_cast<std::uint32_t>(index);
    }
  };

  struct Match {
    double distance = 0;  ///< how far apart they are at most
    bool turned = false;
  };

  void number() {
    Kind* kinds[] = {&vertices_, &edges_, &faces_};
    for (std::uint32_t k = 0; k < 3; ++k) kinds[k]->kind = static_cast<EntityKind>(k);
    for (std::uint32_t o = 0; o < operands_.size(); ++o) {
      const Model& m = *operands_[o];
      tolerance_ = std::max(tolerance_, m.tolerance());
      const auto add = [&](Kind& kind, auto ids) {
        kind.first.push_back(static_cast<std::uint32_t>(kind.items.size()));
        for (const auto id : ids) {
          kind.items.push_back({o, id.value});
          kind.tolerance.push_back(m.tolerance(id));
        }
      };
      add(vertices_, m.topology().vertices());
      add(edges_, m.topology().edges());
      add(faces_, m.topology().faces());
    }
    for (Kind* kind : kinds) {
      kind->turned.assign(kind->items.size(), false);
      kind->root.resize(kind->items.size());
      for (std::uint32_t i = 0; i < kind->items.size(); ++i) kind->root[i] = i;
    }
  }

  const Model& model(Item item) const { return *operands_[item.operand]; }
  Vec3 point(std::uint32_t v) const { return model(vertices_.items[v]).point(VertexId(vertices_.items[v].index)); }
  double own(const Kind& kind, std::uint32_t i) const { return std::max(tolerance_, kind.tolerance[i]); }

  void join(Kind& kind, std::uint32_t root, std::uint32_t i, const Match& match) {
    kind.root[i] = root;
    kind.turned[i] = match.turned;
    kind.tolerance[root] = std::max(kind.tolerance[root], kind.tolerance[i] + match.distance);
    ++out_.united[static_cast<std::size_t>(kind.kind)];
  }

  /// Each candidate joins the first one of another operand that it coincides with, unless that one has somebody of its
  /// operand already. Candidates with one key are in growing order.
  template <class Key, class MatchOf>
  Status unite(Kind& kind, const std::map<Key, std::vector<std::uint32_t>>& candidates, MatchOf match) {
    for (const auto& [key, group] : candidates) {
      if (group.size() < 2) continue;
      ARESTA_CHECK(context_.step(0.04, "finding what coincides"));
      std::map<std::uint32_t, std::vector<std::uint32_t>> operands;  // of roots
      for (const std::uint32_t j : group) {
        const std::uint32_t operand = kind.items[j].operand;
        bool joined = false;
        for (auto& [root, there] : operands) {
          if (std::find(there.begin(), there.end(), operand) != there.end()) continue;
          const std::optional<Match> met = match(root, j);
          if (!met) continue;
          join(kind, root, j, *met);
          there.push_back(operand);
          joined = true;
          break;
        }
        if (!joined) operands.emplace(j, std::vector<std::uint32_t>{operand});
      }
    }
    return {};
  }

  Error too_wide(std::uint32_t root, const std::vector<std::uint32_t>& members) const {
    const Vec3 at = point(root);
    Error error{errors::cluster_too_wide,
                "vertices that coincide one by one are farther apart in all than the tolerance: ",
                {},
                {{at.x, at.y, at.z}},
                "a larger --tolerance, so that they become one, or a smaller one"};
    const auto name = [&](std::uint32_t v) {
      const Item item = vertices_.items[v];
      error.message += (v == root ? "vertex " : ", vertex ") + std::to_string(item.index) + " of operand " +
                       std::to_string(item.operand + 1);
      error.entities.push_back(VertexId(item.index));
    };
    name(root);
    constexpr std::size_t named = 5;
    for (std::size_t i = 0; i < std::min(named, members.size()); ++i) name(members[i]);
    return error;
  }

  // --- Vertices ------------------------------------------------------------------------------------------------------

  std::optional<Match> match_vertices(std::uint32_t a, std::uint32_t b) const {
    const double off = distance(point(a), point(b));
    if (off > std::max(own(vertices_, a), own(vertices_, b))) return std::nullopt;
    return Match{off};
  }

  // Points are put into cubes much larger than the tolerance; a point near a cube's side is in the neighbour, too.
  Status unite_vertices() {
    const auto count = static_cast<std::uint32_t>(vertices_.items.size());
    double radius = 0;
    for (std::uint32_t v = 0; v < count; ++v) radius = std::max(radius, own(vertices_, v));
    if (!(radius > 0)) radius = 1e-300;
    const double size = 64 * radius;
    std::map<std::array<double, 3>, std::vector<std::uint32_t>> cubes;
    UnionFind sets(count);
    for (std::uint32_t v = 0; v < count; ++v) {
      const Vec3 p = point(v);
      std::array<double, 3> low{}, high{};
      for (int i = 0; i < 3; ++i) {
        low[i] = std::floor((p[i] - radius) / size);
        high[i] = std::floor((p[i] + radius) / size);
      }
      for (int which = 0; which < 8; ++which) {
        std::array<double, 3> cube{};
        bool is_new = true;
        for (int i = 0; i < 3; ++i) {
          const bool upper = (which >> i & 1) != 0;
          is_new = is_new && !(upper && low[i] == high[i]);
          cube[i] = upper ? high[i] : low[i];
        }
        if (!is_new) continue;
        auto& inside = cubes[cube];
        for (const std::uint32_t w : inside) {
          if (vertices_.items[w].operand != vertices_.items[v].operand && match_vertices(w, v)) sets.unite(v, w);
        }
        inside.push_back(v);
      }
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> clusters;
    for (std::uint32_t v = 0; v < count; ++v) {
      if (sets.find(v) != v) clusters[sets.find(v)].push_back(v);
    }
    for (const auto& [root, members] : clusters) ARESTA_CHECK(settle(root, members));
    return {};
  }

  Status settle(std::uint32_t root, const std::vector<std::uint32_t>& members) {
    std::vector<std::uint32_t> operands{vertices_.items[root].operand};
    for (const std::uint32_t v : members) operands.push_back(vertices_.items[v].operand);
    std::sort(operands.begin(), operands.end());
    if (std::adjacent_find(operands.begin(), operands.end()) != operands.end()) return {};
    std::vector<Match> matches;
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!match_vertices(members[j], members[i])) return too_wide(root, members);
      }
      const auto met = match_vertices(root, members[i]);
      if (!met) return too_wide(root, members);
      matches.push_back(*met);
    }
    for (std::size_t i = 0; i < members.size(); ++i) join(vertices_, root, members[i], matches[i]);
    return {};
  }

  // --- Edges ---------------------------------------------------------------------------------------------------------

  struct Ends {
    std::uint32_t start = 0, end = 0;
  };

  Ends ends(std::uint32_t e) const {
    const Item item = edges_.items[e];
    const Complex& k = model(item).topology();
    const EdgeId id(item.index);
    return {vertices_.root[vertices_.at(item.operand, k.start(id).index())],
            vertices_.root[vertices_.at(item.operand, k.end(id).index())]};
  }

  std::optional<Match> match_edges(std::uint32_t a, std::uint32_t b) const {
    const Model &m = model(edges_.items[a]), &n = model(edges_.items[b]);
    const EdgeId x(edges_.items[a].index), y(edges_.items[b].index);
    const Ends p = ends(a), q = ends(b);
    if (m.is_straight(x) && n.is_straight(y)) {
      const bool turned = p.start != q.start;
      const Range r = n.range(y);
      const Vec3 a0 = m.edge_point(x, m.range(x).low), a1 = m.edge_point(x, m.range(x).high);
      const Vec3 b0 = n.edge_point(y, turned ? r.high : r.low), b1 = n.edge_point(y, turned ? r.low : r.high);
      return Match{std::max(distance(a0, b0), distance(a1, b1)), turned};
    }
    const double allowed = std::max(own(edges_, a), own(edges_, b));
    const Curve c = m.curve(x), d = n.curve(y);
    bool same = true;
    if (!coincident(c, m.range(x), d, allowed, &same)) return std::nullopt;
    double most = 0;
    for (const double s : {0.5, 0.25, 0.75, 0.1, 0.9}) {
      const double there = d.project(m.edge_point(x, m.range(x).at(s)), n.range(y)).distance;
      const double back = c.project(n.edge_point(y, n.range(y).at(s)), m.range(x)).distance;
      if (!(there <= allowed) || !(back <= allowed)) return std::nullopt;
      most = std::max({most, there, back});
    }
    return Match{most, p.start != p.end ? p.start != q.start : !same};
  }

  Status unite_edges() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> between;
    for (std::uint32_t e = 0; e < edges_.items.size(); ++e) {
      const Ends p = ends(e);
      between[std::minmax(p.start, p.end)].push_back(e);
    }
    return unite(edges_, between, [&](std::uint32_t a, std::uint32_t b) { return match_edges(a, b); });
  }

  // --- Faces ---------------------------------------------------------------------------------------------------------

  using Boundary = std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>>;  // edges, points; sorted

  Boundary boundary(std::uint32_t f) const {
    const Item item = faces_.items[f];
    const Complex& k = model(item).topology();
    Boundary result;
    for (const LoopId l : k.loops(FaceId(item.index))) {
      if (k.is_vertex_loop(l)) {
        result.second.push_back(vertices_.root[vertices_.at(item.operand, k.loop_vertex(l).index())]);
        continue;
      }
      for (const CoedgeId c : k.coedges(l)) {
        result.first.push_back(edges_.root[edges_.at(item.operand, k.edge(c).index())]);
      }
    }
    std::sort(result.first.begin(), result.first.end());
    std::sort(result.second.begin(), result.second.end());
    return result;
  }

  const FaceTrim& trim(std::uint32_t f) {
    if (trims_.empty()) trims_.resize(faces_.items.size());
    if (!trims_[f]) trims_[f].emplace(model(faces_.items[f]), FaceId(faces_.items[f].index));
    return *trims_[f];
  }

  /// Faces with the same boundary: do they agree inside?
  std::optional<Match> match_faces(std::uint32_t a, std::uint32_t b) {
    const Model &m = model(faces_.items[a]), &n = model(faces_.items[b]);
    const FaceId f(faces_.items[a].index), g(faces_.items[b].index);
    const Surface &s = m.surface(f), &t = n.surface(g);
    if (s.is_plane() && t.is_plane()) return Match{0, dot(m.normal(f, {}), n.normal(g, {})) < 0};
    double allowed = std::max(own(faces_, a), own(faces_, b));
    for (const std::uint32_t e : boundary(a).first) allowed = std::max(allowed, edges_.tolerance[e]);
    const auto inner = trim(a).interior_point();
    if (!inner.ok()) return std::nullopt;
    double most = 0;
    Vec2 hint{};
    bool has_hint = false;
    const auto on_other = [&](Vec2 uv) {
      const Vec3 p = s.point(uv);
      SurfaceProjection q = t.project(p, has_hint ? &hint : nullptr);
      if (!(q.distance <= allowed) && has_hint) q = t.project(p);
      if (!(q.distance <= allowed) || trim(b).locate(q.uv, allowed) == Position::outside) return false;
      most = std::max(most, q.distance);
      hint = q.uv;
      has_hint = true;
      return true;
    };
    if (!on_other(*inner)) return std::nullopt;
    const bool turned = dot(m.normal(f, *inner), n.normal(g, hint)) < 0;
    const bool free = s.get_if<FreeSurface>() != nullptr || t.get_if<FreeSurface>() != nullptr;
    const int count = free ? 24 : 8;
    const Range2 box = trim(a).box();
    if (!std::isfinite(box.u.length()) || !std::isfinite(box.v.length())) return std::nullopt;
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const Vec2 uv{box.u.at((i + 0.5) / count), box.v.at((j + 0.5) / count)};
        if (trim(a).locate(uv, allowed) == Position::inside && !on_other(uv)) return std::nullopt;
      }
    }
    return Match{most, turned};
  }

  Status unite_faces() {
    std::map<Boundary, std::vector<std::uint32_t>> within;
    for (std::uint32_t f = 0; f < faces_.items.size(); ++f) within[boundary(f)].push_back(f);
    return unite(faces_, within, [&](std::uint32_t a, std::uint32_t b) { return match_faces(a, b); });
  }

  // --- The imprint ---------------------------------------------------------------------------------------------------

  /// Faces no more than their edges, edges no more than their vertices. A straight edge goes where its vertices go.
  void nest_tolerances() {
    for (std::uint32_t f = 0; f < faces_.items.size(); ++f) {
      if (faces_.root[f] != f || !grew(f)) continue;
      const auto [edges, points] = boundary(f);
      for (const std::uint32_t e : edges) edges_.tolerance[e] = std::max(edges_.tolerance[e], faces_.tolerance[f]);
      for (const std::uint32_t v : points) {
        vertices_.tolerance[v] = std::max(vertices_.tolerance[v], faces_.tolerance[f]);
      }
    }
    for (std::uint32_t e = 0; e < edges_.items.size(); ++e) {
      if (edges_.root[e] != e) continue;
      const Item item = edges_.items[e];
      const Model& m = model(item);
      const EdgeId id(item.index);
      const Ends p = ends(e);
      if (!m.geometry(id).curve.valid()) {
        edges_.tolerance[e] += std::max(distance(m.point(m.topology().start(id)), point(p.start)),
                                        distance(m.point(m.topology().end(id)), point(p.end)));
      }
      for (const std::uint32_t v : {p.start, p.end}) {
        vertices_.tolerance[v] = std::max(vertices_.tolerance[v], edges_.tolerance[e]);
      }
    }
  }

  bool grew(std::uint32_t f) const {
    return faces_.tolerance[f] > model(faces_.items[f]).tolerance(FaceId(faces_.items[f].index));
  }

  Status build() {
    ModelBuilder& to = out_.imprint.builder;
    add_parents(vertices_, out_.imprint.vertex_parents,
                [&](std::uint32_t v) { return to.add_vertex(point(v), vertices_.tolerance[v]).value; });
    add_parents(edges_, out_.imprint.edge_parents, [&](std::uint32_t e) { return add_edge(to, e); });
    Status status;
    add_parents(faces_, out_.imprint.face_parents, [&](std::uint32_t f) {
      if (status.ok()) status = add_face(to, f);
      return static_cast<std::uint32_t>(to.face_count() - 1);
    });
    to.tolerance = tolerance_;
    return status;
  }

  /// Makes the roots in their order, and notes for each who became it.
  template <class Make>
  void add_parents(Kind& kind, std::vector<std::vector<Parent>>& parents, Make make) {
    kind.made.assign(kind.items.size(), 0);
    for (std::uint32_t i = 0; i < kind.items.size(); ++i) {
      if (kind.root[i] == i) {
        kind.made[i] = make(i);
        parents.emplace_back();
      }
      const std::uint32_t entity = kind.made[kind.root[i]];
      parents[entity].push_back({kind.items[i].operand, EntityRef(kind.kind, kind.items[i].index)});
      if (&kind != &faces_) continue;
      if (kind.root[i] == i) out_.opposite.emplace_back();
      out_.opposite[entity].push_back(kind.turned[i]);
    }
  }

  template <class Id, class Of, class Add>
  Id shared(std::map<std::pair<std::uint32_t, std::uint32_t>, Id>& known, std::uint32_t operand, Id id, Of of,
            Add add) {
    const auto [at, is_new] = known.try_emplace({operand, id.value}, Id());
    if (is_new) at->second = add(of(id));
    return at->second;
  }

  std::uint32_t add_edge(ModelBuilder& to, std::uint32_t e) {
    const Item item = edges_.items[e];
    const Model& m = model(item);
    const EdgeGeometry& g = m.geometry(EdgeId(item.index));
    const Ends p = ends(e);
    const VertexId start(vertices_.made[p.start]), end(vertices_.made[p.end]);
    if (!g.curve.valid()) return to.add_edge(start, end, edges_.tolerance[e]).value;
    const CurveId curve = shared(
        curves_, item.operand, g.curve, [&](CurveId c) { return m.curve(c); },
        [&](const Curve& c) { return to.add_curve(c); });
    return to.add_edge(start, end, curve, g.range, edges_.tolerance[e]).value;
  }

  Status add_face(ModelBuilder& to, std::uint32_t f) {
    const Item item = faces_.items[f];
    const Model& m = model(item);
    const Complex& k = m.topology();
    const FaceId face(item.index);
    const FaceGeometry& g = m.geometry(face);
    const SurfaceId surface = shared(
        surfaces_, item.operand, g.surface, [&](SurfaceId s) { return m.surface(s); },
        [&](const Surface& s) { return to.add_surface(s); });
    to.begin_face(surface, g.reversed, faces_.tolerance[f]);
    to.set_constraint(g.constraint);
    for (const LoopId l : k.loops(face)) {
      if (k.is_vertex_loop(l)) {
        const std::uint32_t v = vertices_.root[vertices_.at(item.operand, k.loop_vertex(l).index())];
        to.add_point_loop(VertexId(vertices_.made[v]));
        continue;
      }
      for (const CoedgeId c : k.coedges(l)) {
        const std::uint32_t e = edges_.at(item.operand, k.edge(c).index());
        const EdgeId made(edges_.made[edges_.root[e]]);
        const bool reversed = k.reversed(c) != edges_.turned[e];
        if (m.surface(face).is_plane()) {
          to.add_coedge(made, reversed);
        } else if (edges_.root[e] == e) {
          m.pcurve(c) != nullptr ? to.add_coedge(made, reversed, *m.pcurve(c)) : to.add_coedge(made, reversed);
        } else {
          ARESTA_TRY(Curve2 image, new_image(m, c, e));
          to.add_coedge(made, reversed, std::move(image));
        }
      }
      to.close_loop();
    }
    to.end_face();
    return {};
  }

  /// Of the edge that took this one's place.
  Result<Curve2> new_image(const Model& m, CoedgeId c, std::uint32_t e) const {
    const std::uint32_t root = edges_.root[e];
    const Model& n = model(edges_.items[root]);
    const EdgeId old(edges_.items[e].index), now(edges_.items[root].index);
    const Range range = n.range(now);
    const auto near = [&](double t) {
      const double share = (t - range.low) / range.length();
      return m.uv(c, m.range(old).at(edges_.turned[e] ? 1 - share : share));
    };
    const FaceId f = m.topology().face(c);
    const double allowed = std::max(tolerance_, edges_.tolerance[root]);
    const auto image = image_on(m.surface(f), n.curve(now), range, near, allowed);
    if (image) return image->image;
    const Vec3 p = n.edge_point(now, range.middle());
    return Error{errors::imprint_failed,
                 "an edge that coincides with another one has no image in the face that it bounds",
                 {old, f},
                 {{p.x, p.y, p.z}}};
  }

  std::span<const std::shared_ptr<const Model>> operands_;
  double tolerance_;
  const Context& context_;
  Kind vertices_, edges_, faces_;
  std::vector<std::optional<FaceTrim>> trims_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, CurveId> curves_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, SurfaceId> surfaces_;
  Identity out_;
};

class IdentityEngine final : public FragmentEngine {
 public:
  const char* name() const override { return "identity"; }
  Result<Imprint> imprint(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                          const Context& context) const override {
    ARESTA_TRY(Identity identity, unite_coincident(operands, tolerance, context));
    return std::move(identity.imprint);
  }
};

}  // namespace

Result<Identity> unite_coincident(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                                  const Context& context) {
  return Uniter(operands, tolerance, context).run();
}

const FragmentEngine& identity_engine() {
  static const IdentityEngine engine;
  return engine;
}

}  // namespace aresta
