// SPDX-License-Identifier: Apache-2.0
#include "mesh/sizes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/errors.h"

namespace aresta::mesh {

namespace {

constexpr double radians = std::numbers::pi / 180;

std::array<double, 3> as_place(Vec3 p) {
  return {p.x, p.y, p.z};
}

double curvature(const CurveJet& jet) {
  const double speed = norm(jet.d1);
  return speed > 0 ? norm(cross(jet.d1, jet.d2)) / (speed * speed * speed) : 0;
}

/// Own size of an entity, or the largest there is.
double own_size(const MeshOptions& options, EntityRef entity) {
  const auto found = options.sizes.find(entity);
  return found == options.sizes.end() ? options.size : std::min(options.size, found->second);
}

void restrict_edge(const Model& model, EdgeId e, const MeshOptions& options, SizeField& field) {
  const double own = own_size(options, e);
  const bool straight = model.is_straight(e);
  if (straight && own >= options.size) return;
  const Range range = model.range(e);
  double t = range.low;
  // Steps of half the size found, but at least 16 and at most 20000 of them.
  for (int guard = 0; guard < 20000; ++guard) {
    const CurveJet jet = model.edge_jet(e, t);
    const double k = curvature(jet);
    const double size = std::min(own, k > 0 ? options.angle * radians / k : own);
    field.restrict(jet.point, size);
    if (t >= range.high) break;
    const double speed = norm(jet.d1);
    const double step = speed > 0 ? 0.5 * std::max(size, field.least()) / speed : range.length();
    t = std::min(range.high, t + std::clamp(step, range.length() / 20000, range.length() / 16));
  }
}

/// The boundary of a face in its parameter plane, coarsely, for telling whether a sample is about inside.
std::vector<std::vector<Vec2>> coarse_loops(const Model& model, FaceId f) {
  std::vector<std::vector<Vec2>> loops;
  const auto& topology = model.topology();
  for (const LoopId l : topology.loops(f)) {
    if (topology.is_vertex_loop(l)) continue;
    auto& loop = loops.emplace_back();
    for (const CoedgeId c : topology.coedges(l)) {
      const Range range = model.range(topology.edge(c));
      const bool one_step = model.is_straight(topology.edge(c)) && model.surface(f).is_plane();
      const int steps = one_step ? 1 : 16;
      for (int i = 0; i < steps; ++i) {
        const double s = static_cast<double>(i) / steps;
        loop.push_back(model.uv(c, range.at(topology.reversed(c) ? 1 - s : s)));
      }
    }
  }
  return loops;
}

bool about_inside(const std::vector<std::vector<Vec2>>& loops, Vec2 p) {
  bool inside = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside;
}

void restrict_face(const Model& model, FaceId f, const MeshOptions& options, SizeField& field) {
  const double own = own_size(options, f);
  const Surface& surface = model.surface(f);
  if (surface.is_plane() && own >= options.size) return;
  const auto loops = coarse_loops(model, f);
  const Range2 box = parameter_box(model, f);
  const auto size_at = [&](const SurfaceJet& jet) {
    const double k = largest_curvature(jet);
    return std::min(own, k > 0 ? options.angle * radians / k : own);
  };
  // As many samples as elements of the size found on a coarse grid, within bounds.
  double length_u = 0, length_v = 0, least = own;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      const SurfaceJet jet = surface.jet({box.u.at((i + 0.5) / 9), box.v.at((j + 0.5) / 9)});
      length_u = std::max(length_u, norm(jet.du) * box.u.length());
      length_v = std::max(length_v, norm(jet.dv) * box.v.length());
      least = std::min(least, std::max(size_at(jet), field.least()));
    }
  }
  const auto count = [&](double length) {
    return static_cast<int>(std::clamp(std::ceil(1.5 * length / least), 12.0, 150.0));
  };
  const int nu = count(length_u), nv = count(length_v);
  for (int i = 0; i < nu; ++i) {
    for (int j = 0; j < nv; ++j) {
      const Vec2 uv{box.u.at((i + 0.5) / nu), box.v.at((j + 0.5) / nv)};
      if (!about_inside(loops, uv)) continue;
      const SurfaceJet jet = surface.jet(uv);
      field.restrict(jet.point, size_at(jet));
    }
  }
}

/// Sizes of regions hold on their boundary as well.
MeshOptions with_region_sizes_on_faces(const Model& model, const MeshOptions& options) {
  MeshOptions spread = options;
  const auto& topology = model.topology();
  const auto lower = [&](EntityRef entity, double size) {
    const auto [it, added] = spread.sizes.emplace(entity, size);
    if (!added) it->second = std::min(it->second, size);
  };
  for (const FaceId f : topology.faces()) {
    for (int side = 0; side < 2; ++side) {
      const auto found = options.sizes.find(topology.region(FaceUse(f, side)));
      if (found != options.sizes.end()) lower(f, found->second);
    }
  }
  // A face's size holds on its edges too.
  for (const FaceId f : topology.faces()) {
    const auto found = spread.sizes.find(f);
    if (found == spread.sizes.end()) continue;
    const double size = found->second;
    for (const LoopId l : topology.loops(f)) {
      if (topology.is_vertex_loop(l)) continue;
      for (const CoedgeId c : topology.coedges(l)) lower(topology.edge(c), size);
    }
  }
  return spread;
}

/// The edge sampled so finely that sizes vary little between samples.
struct Samples {
  std::vector<double> parameters, elements;  ///< elements: how many sides from the start to here
  double length = 0;
};

Samples sample_edge(const Model& model, EdgeId e, const SizeField& field) {
  const Range range = model.range(e);
  const bool straight = model.is_straight(e);
  double rough = 0, least = field.largest();
  constexpr int first = 33;
  Vec3 before = model.edge_point(e, range.low);
  for (int i = 0; i <= first; ++i) {
    const Vec3 p = model.edge_point(e, range.at(static_cast<double>(i) / first));
    rough += distance(before, p);
    least = std::min(least, field.at(p));
    before = p;
  }
  if (!std::isfinite(rough) || !(least > 0)) return {};
  const double wished = std::clamp(std::ceil(6 * rough / least), straight ? 16.0 : 64.0, 40000.0);
  const auto count = static_cast<int>(wished);
  Samples samples;
  samples.parameters.reserve(static_cast<std::size_t>(count) + 1);
  double elements = 0;
  before = model.edge_point(e, range.low);
  for (int i = 0; i <= count; ++i) {
    const double t = i == count ? range.high : range.at(static_cast<double>(i) / count);
    const Vec3 p = model.edge_point(e, t);
    const double step = distance(before, p);
    samples.length += step;
    elements += step / field.at(0.5 * (before + p));
    samples.parameters.push_back(t);
    samples.elements.push_back(elements);
    before = p;
  }
  return samples;
}

}  // namespace

double largest_curvature(const SurfaceJet& jet) {
  const Vec3 normal = cross(jet.du, jet.dv);
  const double e = norm2(jet.du), f = dot(jet.du, jet.dv), g = norm2(jet.dv);
  const double area = e * g - f * f;
  if (!(area > 1e-12 * e * g) || !(area > 0)) return 0;
  const double scale = 1 / norm(normal);
  const double l = scale * dot(normal, jet.duu), m = scale * dot(normal, jet.duv), n = scale * dot(normal, jet.dvv);
  const double mean = (e * n - 2 * f * m + g * l) / (2 * area), gauss = (l * n - m * m) / area;
  return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

Range2 parameter_box(const Model& model, FaceId f) {
  const auto loops = coarse_loops(model, f);
  Range2 box{{HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, -HUGE_VAL}};
  for (const auto& loop : loops) {
    for (const Vec2& p : loop) {
      box.u = {std::min(box.u.low, p.x), std::max(box.u.high, p.x)};
      box.v = {std::min(box.v.low, p.y), std::max(box.v.high, p.y)};
    }
  }
  // The last point of each loop is the first of another coedge, except where the surface is singular: a pole's gap.
  // There the coedges' far ends count too.
  const auto& topology = model.topology();
  for (const LoopId l : topology.loops(f)) {
    if (topology.is_vertex_loop(l)) continue;
    for (const CoedgeId c : topology.coedges(l)) {
      const Range range = model.range(topology.edge(c));
      const Vec2 p = model.uv(c, topology.reversed(c) ? range.low : range.high);
      box.u = {std::min(box.u.low, p.x), std::max(box.u.high, p.x)};
      box.v = {std::min(box.v.low, p.y), std::max(box.v.high, p.y)};
    }
  }
  if (box.u.low > box.u.high) box = {};
  return box;
}

Result<MeshOptions> complete_options(const Model& model, const MeshOptions& options) {
  MeshOptions complete = options;
  const auto bad = [](const std::string& message) { return Error{errors::mesh_bad_options, message}; };
  if (!std::isfinite(options.size) || options.size < 0) return bad("the element size must be a positive length");
  if (!std::isfinite(options.least_size) || options.least_size < 0)
    return bad("the least element size must be a positive length");
  if (!(options.angle >= 5 && options.angle <= 90)) return bad("the angle per element must be 5 to 90 degrees");
  if (!(options.grading >= 0.05 && options.grading <= 1)) return bad("the grading must be 0.05 to 1");
  if (options.order != 1 && options.order != 2) return bad("the order of elements must be 1 or 2");
  if (options.dimension < 1 || options.dimension > 3) return bad("the dimension of the mesh must be 1, 2 or 3");
  for (const auto& [entity, size] : options.sizes) {
    if (!(std::isfinite(size) && size > 0))
      return Error{errors::mesh_bad_options, "an own size must be a positive length", {entity}};
  }
  const double diagonal = model.bounds().diagonal();
  if (complete.size == 0) complete.size = diagonal > 0 ? diagonal / 12 : 1;
  if (complete.least_size == 0) complete.least_size = 1e-3 * complete.size;
  complete.least_size = std::min(complete.least_size, complete.size);
  // Refuse what would not fit into memory, before hours are spent.
  const double cells = diagonal / complete.size;
  if (!std::isfinite(diagonal))
    return Error{errors::mesh_bad_input, "the model reaches to infinity or is not a number"};
  if (cells > 5000) {
    return Error{errors::mesh_bad_options,
                 "the element size is less than a 5000th of the model's size",
                 {},
                 {},
                 "a larger size"};
  }
  return complete;
}

Result<SizeField> model_sizes(const Model& model, const MeshOptions& given, const Context& context) {
  const MeshOptions options = with_region_sizes_on_faces(model, given);
  SizeField field(model.bounds(), options.size, options.least_size, options.grading);
  const auto& topology = model.topology();
  for (const VertexId v : topology.vertices()) {
    const double own = own_size(options, v);
    if (own < options.size) field.restrict(model.point(v), own);
  }
  for (const EdgeId e : topology.edges()) {
    ARESTA_CHECK(context.step(0, "element sizes"));
    restrict_edge(model, e, options, field);
  }
  if (options.dimension == 1) return field;
  for (const FaceId f : topology.faces()) {
    ARESTA_CHECK(
        context.step(static_cast<double>(f.index()) / static_cast<double>(topology.face_count()), "element sizes"));
    restrict_face(model, f, options, field);
  }
  return field;
}

namespace {

Result<EdgeMesh> subdivide_once(const Model& model, SizeField& field, double put_back_below, const Context& context) {
  EdgeMesh mesh;
  const auto& topology = model.topology();
  for (const VertexId v : topology.vertices()) mesh.nodes.push_back(model.point(v));
  mesh.chains.resize(topology.edge_count());
  for (const EdgeId e : topology.edges()) {
    ARESTA_CHECK(
        context.step(static_cast<double>(e.index()) / static_cast<double>(topology.edge_count()), "edge mesh"));
    const Samples samples = sample_edge(model, e, field);
    if (!(std::isfinite(samples.length) && samples.length > 0)) {
      return Error{errors::mesh_edge_failed,
                   "the edge has no length or its curve cannot be evaluated",
                   {e},
                   as_place(model.point(topology.start(e)))};
    }
    const double total = samples.elements.back();
    const int least = topology.is_closed(e) ? 3 : model.is_straight(e) ? 1 : 2;
    const int sides = std::max(least, static_cast<int>(std::ceil(total - 0.15)));
    EdgeChain& chain = mesh.chains[e.index()];
    chain.parameters.push_back(model.range(e).low);
    chain.nodes.push_back(topology.start(e).value);
    std::size_t i = 0;
    for (int k = 1; k < sides; ++k) {
      const double wanted = total * k / sides;
      while (samples.elements[i + 1] < wanted) ++i;
      const double width = samples.elements[i + 1] - samples.elements[i];
      const double s = width > 0 ? (wanted - samples.elements[i]) / width : 0;
      const double t = samples.parameters[i] + s * (samples.parameters[i + 1] - samples.parameters[i]);
      chain.parameters.push_back(t);
      chain.nodes.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
      mesh.nodes.push_back(model.edge_point(e, t));
    }
    chain.parameters.push_back(model.range(e).high);
    chain.nodes.push_back(topology.end(e).value);
  }
  for (const auto& chain : mesh.chains) {
    for (std::size_t i = 1; i < chain.nodes.size(); ++i) {
      const Vec3 a = mesh.nodes[chain.nodes[i - 1]], b = mesh.nodes[chain.nodes[i]];
      const Vec3 middle = 0.5 * (a + b);
      const double length = distance(a, b);
      if (length < put_back_below * field.at(middle)) field.restrict(middle, length);
    }
  }
  return mesh;
}

}  // namespace

Result<EdgeMesh> subdivide_edges(const Model& model, SizeField& field, const Context& context) {
  // Short edges show in the field only once they are there; the second time their neighbours are graded towards them.
  // Sides that are merely rounded down must not count the first time: they would shrink again.
  ARESTA_CHECK(subdivide_once(model, field, 0.6, context));
  return subdivide_once(model, field, 2, context);
}

}  // namespace aresta::mesh
