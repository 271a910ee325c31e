// SPDX-License-Identifier: Apache-2.0
#include "planar/cells.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/box_tree.h"
#include "math/directions.h"
#include "planar/face_places.h"
#include "topology/loose_parts.h"

namespace aresta::planar {

namespace {

constexpr int most_rays = 24;

struct Component {
  double volume = 0;     // of the space that its sides look into; meaningful as such when positive
  bool is_sheet = true;  // every face comes with both sides
  Box3 box;
  Index first_use = none;
  Index cell = none;
};

class Nesting {
 public:
  Nesting(const PlaneFaces& faces, const Context& context) : faces_(faces), shape_(faces.shape), context_(context) {}

  Result<Cells> run() {
    gather();
    open_cells();
    cells_.of_face_use.assign(component_of_.size(), 0);
    for (Component& c : components_) {
      if (c.cell == none) ARESTA_CHECK(place(c));
    }
    for (std::size_t u = 0; u < component_of_.size(); ++u) cells_.of_face_use[u] = components_[component_of_[u]].cell;
    ARESTA_CHECK(place_wires());
    ARESTA_CHECK(place_points());
    return std::move(cells_);
  }

 private:
  void gather() {
    component_of_ = side_components(shape_);
    std::vector<Index> index(component_of_.size(), none);
    for (Index u = 0; u < component_of_.size(); ++u) {
      Index& i = index[component_of_[u]];
      if (i == none) {
        i = static_cast<Index>(components_.size());
        components_.emplace_back().first_use = u;
      }
      component_of_[u] = i;
    }
    boxes_.resize(shape_.face_count());
    for (Index f = 0; f < shape_.face_count(); ++f) {
      const auto coedges = faces_.coedges_of(f);
      const Vec3 origin = start(coedges[0]);
      Vec3 area;
      for (const Index c : coedges) {
        const Vec3 p = start(c);
        boxes_[f].add(p);
        area += cross(p - origin, start(c ^ 1u) - origin);
      }
      for (Index side = 0; side < 2; ++side) {
        Component& c = components_[component_of_[2 * f + side]];
        c.box.add(boxes_[f]);
        if (component_of_[2 * f] == component_of_[2 * f + 1]) continue;
        c.is_sheet = false;
        // Side 0 looks along the normal, away from what lies behind it; from a point of the component, for accuracy.
        const double flux = dot(origin - start(faces_.coedges_of(c.first_use / 2)[0]), area);
        c.volume += side == 0 ? -flux : flux;
      }
    }
  }

  Vec3 start(Index code_at) const { return faces_.points[shape_.edges[code_at / 2][code_at % 2]]; }

  void open_cells() {
    for (Index i = 0; i < components_.size(); ++i) {
      if (components_[i].is_sheet || !(components_[i].volume > 0)) continue;
      components_[i].cell = cells_.count++;
      outer_.push_back(i);
    }
  }

  Status place(Component& c) {
    std::vector<Index> candidates;
    for (const Index k : outer_) {
      const Box3& box = components_[k].box;
      if (box.contains(c.box.low) && box.contains(c.box.high)) candidates.push_back(k);
    }
    c.cell = 0;
    if (candidates.empty()) return {};
    // A cell whose boundary shares a face with the component lies on its other side.
    std::vector<Index> behind;
    for (Index u = 0; u < component_of_.size(); ++u) {
      if (&components_[component_of_[u]] == &c) behind.push_back(component_of_[u ^ 1u]);
    }
    std::sort(behind.begin(), behind.end());
    std::erase_if(candidates, [&](Index k) { return std::binary_search(behind.begin(), behind.end(), k); });
    if (candidates.empty()) return {};
    // From the middle of an edge: on the boundary of no candidate, which meet the component nowhere.
    const Index code = faces_.coedges_of(c.first_use / 2)[0];
    ARESTA_TRY(c.cell, cell_around(0.5 * (start(code) + start(code ^ 1u)), candidates, FaceId(c.first_use / 2)));
    return {};
  }

  struct Hit {
    double t = 0;
    Index facing = none;  // the face-use that looks towards the origin
  };

  /// What the ray meets, by distance; nothing when it passes too near an edge to be told.
  std::optional<std::vector<Hit>> cast(Vec3 origin, Vec3 direction) {
    if (!tree_) {
      std::vector<Box3> boxes(boxes_);
      for (Box3& b : boxes) b = b.grown(2 * faces_.tolerance);
      tree_.emplace(std::move(boxes));
      places_.emplace(faces_);
    }
    std::vector<Hit> hits;
    bool doubtful = false;
    tree_->along(origin, direction, [&](Index f) {
      if (doubtful) return;
      const Plane& plane = faces_.planes[f];
      const double slope = dot(plane.normal, direction), height = plane.distance(origin);
      if (std::abs(height) <= faces_.tolerance) return;  // it lies there, or beside it
      if (std::abs(slope) < 1e-3) {
        doubtful = true;
        return;
      }
      const double t = -height / slope;
      if (t <= 0) return;
      const Located at = places_->locate(f, origin + t * direction);
      if (at.place == Located::Place::inside)
        hits.push_back({t, 2 * f + (slope < 0 ? 0u : 1u)});
      else if (at.place != Located::Place::outside)
        doubtful = true;
    });
    if (doubtful) return {};
    std::sort(hits.begin(), hits.end(),
              [](const Hit& a, const Hit& b) { return a.t != b.t ? a.t < b.t : a.facing < b.facing; });
    return hits;
  }

  /// The smallest of the cells with these outer components that holds p.
  Result<Index> cell_around(Vec3 p, std::span<const Index> candidates, EntityRef what) {
    if (candidates.empty()) return Index{0};
    for (int i = 0; i < most_rays; ++i) {
      const auto hits = cast(p, general_direction(i, most_rays));
      if (!hits) continue;
      Index best = none;
      for (const Index k : candidates) {
        if (holds(k, *hits) && (best == none || components_[k].volume < components_[best].volume)) best = k;
      }
      return best == none ? 0 : components_[best].cell;
    }
    return Error{errors::nesting_undecided,
                 "no ray decides in which cell an entity lies",
                 {what},
                 {{p.x, p.y, p.z}},
                 "a larger --tolerance"};
  }

  /// The first face of the component on the ray says whether its inner side looks back.
  bool holds(Index component, std::span<const Hit> hits) const {
    for (const Hit& hit : hits) {
      if (component_of_[hit.facing] == component) return true;
      if (component_of_[hit.facing ^ 1u] == component) return false;
    }
    return false;
  }

  std::vector<Index> cells_with_box_around(Vec3 p) const {
    std::vector<Index> found;
    for (const Index k : outer_) {
      if (components_[k].box.grown(faces_.tolerance).contains(p)) found.push_back(k);
    }
    return found;
  }

  Status place_wires() {
    const std::vector<Index> groups = wire_groups(shape_);
    cells_.of_edge.assign(shape_.edge_count(), none);
    for (Index e = 0; e < shape_.edge_count(); ++e) {
      if (groups[e] == none) continue;
      if (groups[e] != e) {
        cells_.of_edge[e] = cells_.of_edge[groups[e]];
        continue;
      }
      ARESTA_CHECK(context_.step(static_cast<double>(e) / shape_.edge_count(), "placing wires"));
      const Vec3 p = 0.5 * (faces_.points[shape_.edges[e][0]] + faces_.points[shape_.edges[e][1]]);
      ARESTA_TRY(cells_.of_edge[e], cell_around(p, cells_with_box_around(p), EdgeId(e)));
    }
    return {};
  }

  Status place_points() {
    cells_.of_vertex.assign(shape_.vertex_count, none);
    for (const Index v : isolated_vertices(shape_)) {
      const Vec3 p = faces_.points[v];
      ARESTA_TRY(cells_.of_vertex[v], cell_around(p, cells_with_box_around(p), VertexId(v)));
    }
    return {};
  }

  PlaneFaces faces_;
  const Incidence& shape_;
  const Context& context_;
  std::vector<Index> component_of_;  // per face-use
  std::vector<Component> components_;
  std::vector<Index> outer_;  // components that enclose a cell, in the cells' order
  std::vector<Box3> boxes_;   // of faces
  std::optional<BoxTree> tree_;
  std::optional<FacePlaces> places_;
  Cells cells_;
};

}  // namespace

Result<Cells> find_cells(const PlaneFaces& faces, const Context& context) {
  return Nesting(faces, context).run();
}

}  // namespace aresta::planar
