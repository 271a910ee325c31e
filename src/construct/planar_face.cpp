// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "construct/arguments.h"
#include "construct/copy.h"
#include "construct/planar.h"
#include "construct/profiles.h"
#include "model/check.h"

namespace aresta {

namespace {

constexpr int samples_per_edge = 32;

struct WireEdge {
  EdgeId edge;
  VertexId ends[2];
  std::vector<Vec3> points;  ///< along the edge, both ends included
};

std::array<double, 3> place_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// The edges of all wires over common vertices: ends nearer than the tolerance are one.
class WireJoiner {
 public:
  WireJoiner(ModelBuilder& builder, double tolerance) : builder_(builder), tolerance_(tolerance) {}

  Status add(const Model& wire) {
    const Complex& k = wire.topology();
    ModelCopier copier(wire, builder_);
    for (const EdgeId e : k.edges()) {
      for (const VertexId v : {k.start(e), k.end(e)}) {
        if (!copier.vertices[v.index()].valid()) copier.vertices[v.index()] = vertex(wire.point(v));
      }
      ARESTA_TRY(const EdgeId copy, copier.edge(e));
      WireEdge& made = edges.emplace_back(
          WireEdge{copy, {copier.vertices[k.start(e).index()], copier.vertices[k.end(e).index()]}, {}});
      for (int i = 0; i <= samples_per_edge; ++i)
        made.points.push_back(wire.edge_point(e, wire.range(e).at(static_cast<double>(i) / samples_per_edge)));
    }
    return {};
  }

  Vec3 point(VertexId v) const { return points_[v.index()]; }
  std::size_t vertex_count() const { return points_.size(); }
  std::vector<WireEdge> edges;

 private:
  VertexId vertex(Vec3 p) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (distance(points_[i], p) <= tolerance_) return VertexId(i);
    }
    points_.push_back(p);
    return builder_.add_vertex(p, 0);
  }

  ModelBuilder& builder_;
  double tolerance_;
  std::vector<Vec3> points_;
};

struct WireLoop {
  std::vector<CoedgeDraft> coedges;
  IndexLoop points;  ///< of the sampled outline
};

/// Follows edges from vertex to vertex; every vertex has two ends.
Result<std::vector<WireLoop>> follow_loops(const WireJoiner& wires, std::vector<Vec3>& outline) {
  struct End {
    std::size_t edge;
    int end;
  };
  std::vector<std::vector<End>> at(wires.vertex_count());
  for (std::size_t e = 0; e < wires.edges.size(); ++e) {
    for (int end = 0; end < 2; ++end) at[wires.edges[e].ends[end].index()].push_back({e, end});
  }
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (at[v].size() == 2) continue;
    return Error{errors::not_closed,
                 "face: " + std::to_string(at[v].size()) + (at[v].size() == 1 ? " edge ends" : " edges end") +
                     " in a point of the wires; in a closed outline two meet",
                 {},
                 place_of(wires.point(VertexId(v)))};
  }
  std::vector<WireLoop> loops;
  std::vector<bool> done(wires.edges.size(), false);
  for (std::size_t first = 0; first < wires.edges.size(); ++first) {
    if (done[first]) continue;
    WireLoop& loop = loops.emplace_back();
    for (End from{first, 0}; !done[from.edge];) {
      const WireEdge& e = wires.edges[from.edge];
      done[from.edge] = true;
      loop.coedges.push_back({e.edge, from.end == 1});
      for (int i = 0; i < samples_per_edge; ++i) {
        loop.points.push_back(outline.size());
        outline.push_back(e.points[static_cast<std::size_t>(from.end == 0 ? i : samples_per_edge - i)]);
      }
      const auto& ends = at[e.ends[1 - from.end].index()];
      const bool first_is_here = ends[0].edge == from.edge && ends[0].end == 1 - from.end;
      from = ends[first_is_here ? 1 : 0];
    }
  }
  return loops;
}

void reverse(WireLoop& loop) {
  std::reverse(loop.coedges.begin(), loop.coedges.end());
  for (CoedgeDraft& c : loop.coedges) c.reversed = !c.reversed;
}

}  // namespace

Result<Model> planar_face(std::span<const Model* const> wires, const ConstructOptions& options,
                          const Context& context) {
  Arguments arguments("face");
  arguments.require(!wires.empty(), "wires", "a list of one or more", "an empty list");
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  Box3 box;
  double tolerance = 0;
  for (const Model* wire : wires) {
    arguments.require(wire->topology().face_count() == 0 && wire->topology().edge_count() > 0, "each of the wires",
                      "made of edges only",
                      "a model with " + std::to_string(wire->topology().face_count()) + " faces and " +
                          std::to_string(wire->topology().edge_count()) + " edges");
    box.add(wire->bounds());
    tolerance = std::max(tolerance, wire->tolerance());
  }
  ARESTA_CHECK(arguments.status());
  tolerance = std::max(tolerance, working_tolerance(box, options));

  ModelBuilder builder;
  builder.tolerance = tolerance;
  builder.length_unit = wires[0]->length_unit;
  WireJoiner joined(builder, tolerance);
  for (const Model* wire : wires) ARESTA_CHECK(joined.add(*wire));
  std::vector<Vec3> outline;
  ARESTA_TRY(std::vector<WireLoop> loops, follow_loops(joined, outline));
  std::stable_sort(loops.begin(), loops.end(), [&](const WireLoop& a, const WireLoop& b) {
    return norm(newell(outline, a.points)) > norm(newell(outline, b.points));
  });
  const Vec3 area = newell(outline, loops[0].points);
  arguments.require(norm(area) > tolerance * box.diagonal(), "the outline", "around some area", "on one line");
  ARESTA_CHECK(arguments.status());
  const Frame plane = plane_of(outline, loops[0].points);
  for (const Vec3& p : outline) {
    const double height = std::abs(plane.to_local(p).z);
    if (height <= tolerance) continue;
    return Error{errors::not_planar,
                 "face: the wires do not lie in one plane: one deviates by " + number_text(height) + ", allowed is " +
                     number_text(tolerance),
                 {},
                 place_of(p)};
  }
  FaceDraft face{.surface = builder.add_surface(Plane{plane}), .loops = {}};
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (l > 0 && !inside_loop(outline, loops[0].points, plane, outline[loops[l].points[0]])) {
      return Error{errors::bad_profile,
                   "face: one outline lies outside the largest one",
                   {},
                   place_of(outline[loops[l].points[0]]),
                   "make a face of each"};
    }
    if (l > 0 && dot(newell(outline, loops[l].points), plane.z) > 0) reverse(loops[l]);
    face.loops.push_back({std::move(loops[l].coedges)});
  }
  add_face(builder, face);
  ARESTA_TRY(Model model, builder.build(no_solid(1, std::vector<bool>(joined.edges.size()),
                                                 std::vector<bool>(joined.vertex_count())),
                                        {false}));
  const Status valid = require_valid(model, CheckLevel::full, context);
  if (valid.ok() || valid.error().code.failure == Failure::cancelled) {
    ARESTA_CHECK(valid);
    return model;
  }
  return Error{errors::self_intersection, "face: the outlines meet: " + valid.error().message, {}, valid.error().place};
}

}  // namespace aresta
