// SPDX-License-Identifier: Apache-2.0
#include "model/cells.h"

#include <algorithm>

#include "math/directions.h"
#include "model/measure.h"
#include "model/query.h"
#include "topology/loose_parts.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = Incidence::none;
constexpr int most_rays = 24;

struct Component {
  std::vector<std::uint32_t> uses;
  double volume = 0;  // of the space its sides look into; meaningful as such when positive
  double error = 0;
  bool two_sided = true;  // every face comes with both sides
  Box3 box;
  std::uint32_t cell = none;
};

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

class Nesting {
 public:
  Nesting(const Model& model, const Incidence& incidence, const Context& context)
      : model_(model), in_(incidence), context_(context) {}

  Result<Cells> run() {
    ARESTA_CHECK(gather());
    open_cells();
    cells_.of_face_use.assign(2 * in_.face_count(), 0);
    std::size_t done = 0;
    for (Component& c : components_) {
      if (done++ % 256 == 0)
        ARESTA_CHECK(
            context_.step(static_cast<double>(done) / static_cast<double>(components_.size()), "nesting shells"));
      if (c.cell == none) ARESTA_CHECK(place(c));
      for (const std::uint32_t use : c.uses) cells_.of_face_use[use] = c.cell;
    }
    ARESTA_CHECK(place_wires());
    ARESTA_CHECK(place_points());
    return std::move(cells_);
  }

 private:
  Status gather() {
    component_of_ = side_components(in_);
    std::vector<std::uint32_t> index(component_of_.size(), none);
    for (std::uint32_t u = 0; u < component_of_.size(); ++u) {
      std::uint32_t& i = index[component_of_[u]];
      if (i == none) {
        i = static_cast<std::uint32_t>(components_.size());
        components_.emplace_back();
      }
      component_of_[u] = i;
      components_[i].uses.push_back(u);
    }
    face_box_.resize(in_.face_count());
    for (std::uint32_t f = 0; f < in_.face_count(); ++f) {
      face_box_[f] = model_.bounds(FaceId(f));
      for (std::uint32_t u = 2 * f; u < 2 * f + 2; ++u) components_[component_of_[u]].box.add(face_box_[f]);
    }
    for (Component& c : components_) ARESTA_CHECK(measure_volume(c));
    return {};
  }

  bool both_sides_in_one(std::uint32_t use) const { return component_of_[use] == component_of_[use ^ 1u]; }

  Status measure_volume(Component& c) {
    const Vec3 reference = c.box.centre();
    double absolute = 0;
    for (const std::uint32_t use : c.uses) {
      if (both_sides_in_one(use)) continue;
      c.two_sided = false;
      ARESTA_TRY(const Moments m, flux(model_, FaceId(use / 2), reference));
      c.volume += use % 2 == 0 ? -m.measure : m.measure;  // side 0 looks along the normal
      c.error += m.error;
      absolute += std::abs(m.measure);
    }
    c.error += 1e-14 * absolute;
    if (!c.two_sided && std::abs(c.volume) <= c.error) {
      const Vec3 p = c.box.centre();
      return Error{errors::nesting_failed,
                   "a closed shell encloses no measurable volume",
                   {FaceId(c.uses.front() / 2)},
                   as_array(p),
                   "a larger --tolerance, so that its faces are merged"};
    }
    return {};
  }

  void open_cells() {
    for (Component& c : components_) {
      if (!c.two_sided && c.volume > 0) {
        c.cell = cells_.count++;
        outer_.push_back(&c);
      }
    }
  }

  Status place(Component& c) {
    std::vector<const Component*> candidates;
    std::vector<bool> shares(components_.size(), false);
    for (const std::uint32_t use : c.uses) shares[component_of_[use ^ 1u]] = true;
    for (const Component* k : outer_) {
      const auto i = static_cast<std::size_t>(k - components_.data());
      if (!shares[i] && k->box.grown(model_.tolerance()).contains(c.box.low) &&
          k->box.grown(model_.tolerance()).contains(c.box.high)) {
        candidates.push_back(k);
      }
    }
    c.cell = 0;
    if (candidates.empty()) return {};
    const FaceUse use = FaceUse::from_index(c.uses.front());
    ARESTA_TRY(const Vec2 uv, FaceTrim(model_, use.face()).interior_point());
    const Vec3 p = model_.surface(use.face()).point(uv);
    const Vec3 n = use.side() == 0 ? model_.normal(use.face(), uv) : -model_.normal(use.face(), uv);
    ARESTA_TRY(c.cell, cell_around(p, &n, candidates, use.face()));
    return {};
  }

  /// The smallest of the candidate cells that contains p; `outward`, when given, keeps rays in its half-space.
  Result<std::uint32_t> cell_around(Vec3 p, const Vec3* outward, const std::vector<const Component*>& candidates,
                                    EntityRef what) {
    if (!caster_) caster_.emplace(model_);
    for (int i = 0; i < most_rays; ++i) {
      Vec3 direction = general_direction(i, most_rays);
      if (outward != nullptr) {
        const double along = dot(direction, *outward);
        if (std::abs(along) < 0.15) continue;
        if (along < 0) direction = -direction;
      }
      const auto hits = caster_->cast(p, direction);
      if (std::any_of(hits.begin(), hits.end(), [](const RayHit& h) { return h.doubtful; })) continue;
      const Component* smallest = nullptr;
      for (const Component* k : candidates) {
        if (contains(*k, hits) && (smallest == nullptr || k->volume < smallest->volume)) smallest = k;
      }
      return smallest == nullptr ? 0u : smallest->cell;
    }
    return Error{errors::nesting_failed, "no ray decides in which cell an entity lies", {what}, as_array(p)};
  }

  bool contains(const Component& k, const std::vector<RayHit>& hits) const {
    const auto index = static_cast<std::uint32_t>(&k - components_.data());
    for (const RayHit& hit : hits) {
      const std::uint32_t facing = static_cast<std::uint32_t>(hit.facing.index());
      if (component_of_[facing] == index) return true;
      if (component_of_[facing ^ 1u] == index) return false;
    }
    return false;
  }

  std::vector<const Component*> cells_with_box_around(Vec3 p) const {
    std::vector<const Component*> found;
    for (const Component* k : outer_) {
      if (k->box.grown(model_.tolerance()).contains(p)) found.push_back(k);
    }
    return found;
  }

  Status place_wires() {
    const std::vector<std::uint32_t> groups = wire_groups(in_);
    cells_.of_edge.assign(in_.edge_count(), none);
    for (std::uint32_t e = 0; e < in_.edge_count(); ++e) {
      if (groups[e] == none) continue;
      if (groups[e] != e) {
        cells_.of_edge[e] = cells_.of_edge[groups[e]];
        continue;
      }
      const Vec3 p = model_.edge_point(EdgeId(e), model_.range(EdgeId(e)).at(0.5));
      ARESTA_TRY(cells_.of_edge[e], cell_around(p, nullptr, cells_with_box_around(p), EdgeId(e)));
    }
    return {};
  }

  Status place_points() {
    cells_.of_vertex.assign(in_.vertex_count, none);
    for (const std::uint32_t v : isolated_vertices(in_)) {
      const Vec3 p = model_.point(VertexId(v));
      ARESTA_TRY(cells_.of_vertex[v], cell_around(p, nullptr, cells_with_box_around(p), VertexId(v)));
    }
    return {};
  }

  const Model& model_;
  const Incidence& in_;
  const Context& context_;
  std::vector<std::uint32_t> component_of_;  // per face-use
  std::vector<Component> components_;
  std::vector<const Component*> outer_;
  std::vector<Box3> face_box_;
  std::optional<RayCaster> caster_;
  Cells cells_;
};

}  // namespace

Result<Cells> find_cells(const Model& model, const Incidence& incidence, const Context& context) {
  return Nesting(model, incidence, context).run();
}

}  // namespace aresta
