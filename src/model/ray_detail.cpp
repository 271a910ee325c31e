// SPDX-License-Identifier: Apache-2.0
// RayCaster: a tree of the faces' boxes, the surfaces' own intersection with lines, then the trims, prepared when first
// needed.
#include <cmath>
#include <mutex>
#include <optional>

#include "math/box_tree.h"
#include "model/query.h"

namespace aresta {

namespace {

/// A hit counts as doubtful nearer to an edge than this many tolerances.
constexpr double edge_margin = 4;
/// |cos| of the angle between ray and normal below which a hit is nearly tangent.
constexpr double tangent_plane = 1e-4, tangent_curved = 2e-3;

struct Prepared {
  FaceTrim trim;
  double margin = 0;
};

}  // namespace

struct RayCaster::Data {
  explicit Data(const Model& m) : model(m) {
    const std::size_t count = model.topology().face_count();
    std::vector<Box3> boxes(count);
    Box3 all;
    const double smallest = model.tolerance();
    for (const FaceId f : model.topology().faces()) {
      const Box3 box = model.bounds(f);
      all.add(box);
      boxes[f.index()] = box.grown(std::max({smallest, model.tolerance(f), 1e-12 * box.diagonal()}) * edge_margin);
    }
    tree = BoxTree(std::move(boxes));
    size = all.diagonal();
    prepared.resize(count);
    once = std::make_unique<std::once_flag[]>(count);
  }

  const Prepared& prepare(FaceId f) const {
    std::call_once(once[f.index()], [&] {
      const Complex& topology = model.topology();
      double tolerance = std::max({model.tolerance(), model.tolerance(f), 1e-13 * size});
      for (const LoopId l : topology.loops(f)) {
        for (const CoedgeId c : topology.coedges(l)) {
          tolerance = std::max({tolerance, model.tolerance(topology.edge(c)), model.tolerance(topology.start(c))});
        }
      }
      prepared[f.index()].emplace(FaceTrim(model, f), edge_margin * tolerance);
    });
    return *prepared[f.index()];
  }

  void cast(FaceId f, Vec3 origin, Vec3 direction, std::vector<RayHit>& hits) const {
    double enter = 0, leave = 0;
    if (!BoxTree::meets(tree.box(f.value), origin, direction, &enter, &leave)) return;
    const Surface& surface = model.surface(f);
    const Line line{origin, direction};
    const double start = 1e-12 * size;
    if (const Plane* plane = surface.get_if<Plane>()) {
      const Vec3 n =
          model.is_reversed(f) ? -cross(plane->frame.x, plane->frame.y) : cross(plane->frame.x, plane->frame.y);
      const double cosine = dot(n, direction), height = dot(plane->frame.origin - origin, n);
      if (std::abs(cosine) < tangent_plane) {
        const double at_enter = enter * cosine - height, at_leave = leave * cosine - height;
        if ((at_enter > 0) != (at_leave > 0) || std::min(std::abs(at_enter), std::abs(at_leave)) < prepare(f).margin) {
          const Vec3 q = plane->frame.to_local(origin + enter * direction);
          hits.push_back({enter, f, {q.x, q.y}, FaceUse(f, cosine < 0 ? 0 : 1), true});
        }
        return;
      }
      const double t = height / cosine;
      if (t <= start || t < enter - 1e-9 * size || t > leave + 1e-9 * size) return;
      const Vec3 q = plane->frame.to_local(origin + t * direction);
      const Prepared& p = prepare(f);
      const Position position = p.trim.locate({q.x, q.y}, p.margin / std::abs(cosine));
      if (position == Position::outside) return;
      hits.push_back({t, f, {q.x, q.y}, FaceUse(f, cosine < 0 ? 0 : 1), position == Position::boundary});
      return;
    }
    const Prepared& p = prepare(f);
    const std::vector<LineHit> found = surface.intersect(line, p.trim.box());
    if (found.empty()) {
      // Along a ruling, or touching: in doubt where the ray runs within tolerance of the surface.
      const SurfaceProjection near = surface.project(origin + 0.5 * (enter + leave) * direction);
      if (near.distance < p.margin) hits.push_back({0.5 * (enter + leave), f, near.uv, FaceUse(f, 0), true});
      return;
    }
    for (const LineHit& hit : found) {
      if (hit.t <= start || hit.t < enter - 1e-9 * size || hit.t > leave + 1e-9 * size) continue;
      const double cosine = dot(model.normal(f, hit.uv), direction);
      const bool tangent = std::abs(cosine) < tangent_curved;
      const Position position = p.trim.locate(hit.uv, p.margin / std::max(std::abs(cosine), tangent_curved));
      if (position == Position::outside) continue;
      hits.push_back({hit.t, f, hit.uv, FaceUse(f, cosine < 0 ? 0 : 1), tangent || position == Position::boundary});
    }
  }

  const Model& model;
  BoxTree tree;
  double size = 0;
  mutable std::vector<std::optional<Prepared>> prepared;
  std::unique_ptr<std::once_flag[]> once;
};

RayCaster::RayCaster(const Model& model) : data_(std::make_shared<const Data>(model)) {}

std::vector<RayHit> RayCaster::cast(Vec3 origin, Vec3 direction) const {
  std::vector<RayHit> hits;
  data_->tree.along(origin, direction, [&](std::uint32_t f) { data_->cast(FaceId(f), origin, direction, hits); });
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return a.t != b.t ? a.t < b.t : a.face != b.face ? a.face < b.face : a.facing < b.facing;
  });
  return hits;
}

}  // namespace aresta
