// SPDX-License-Identifier: Apache-2.0
#include "construct/move.h"

#include <algorithm>
#include <numeric>

#include "construct/arguments.h"
#include "construct/copy.h"

namespace aresta {

namespace {

/// The cell of everything: that of the source, shifted by `shift` (the infinite one stays 0).
void append_cells(const Model& model, std::uint32_t shift, Cells& cells, std::vector<bool>& filled) {
  const Complex& k = model.topology();
  const auto cell = [&](RegionId r) { return r == Complex::infinite_region() ? 0 : r.value + shift; };
  for (const FaceId f : k.faces()) {
    for (int side = 0; side < 2; ++side) cells.of_face_use.push_back(cell(k.region(FaceUse(f, side))));
  }
  for (const EdgeId e : k.edges())
    cells.of_edge.push_back(k.is_wire(e) ? cell(k.region(k.wire_shell(e))) : Incidence::none);
  for (const VertexId v : k.vertices()) {
    const ShellId s = k.isolated_in_shell(v);
    cells.of_vertex.push_back(s.valid() ? cell(k.region(s)) : Incidence::none);
  }
  for (const RegionId r : k.regions()) {
    if (r != Complex::infinite_region()) filled.push_back(k.is_filled(r));
  }
  cells.count += static_cast<std::uint32_t>(k.region_count()) - 1;
}

/// The model's coedges in the order of its loops, turned over or not: where each of them goes, from `first` on.
void append_radial_order(const Model& model, bool mirrored, std::vector<std::uint32_t>& radial_next) {
  const Complex& k = model.topology();
  const auto first = static_cast<std::uint32_t>(radial_next.size());
  std::vector<std::uint32_t> place(k.coedge_count());
  std::uint32_t next = first;
  for (const FaceId f : k.faces()) {
    for (const LoopId l : k.loops(f)) {
      std::vector<CoedgeId> loop;
      for (const CoedgeId c : k.coedges(l)) loop.push_back(c);
      if (mirrored) std::reverse(loop.begin(), loop.end());
      for (const CoedgeId c : loop) place[c.index()] = next++;
    }
  }
  radial_next.resize(next);
  // A mirror turns the order about every edge round.
  for (const CoedgeId c : k.coedges()) {
    const std::uint32_t a = place[c.index()], b = place[k.radial(c).index()];
    (mirrored ? radial_next[b] = a : radial_next[a] = b);
  }
}

/// Adds the whole model, entity by entity in its order.
Status append(const Model& model, ModelCopier& copier, ModelBuilder& builder, bool mirrored) {
  for (const VertexId v : model.topology().vertices()) copier.vertex(v);
  for (const EdgeId e : model.topology().edges()) ARESTA_CHECK(copier.edge(e));
  for (const FaceId f : model.topology().faces()) {
    ARESTA_TRY(FaceDraft face, copier.face(f));
    if (mirrored) turn_over(face);
    add_face(builder, face);
  }
  return {};
}

bool is_finite(const Transform& t) {
  return is_finite(t.rows[0]) && is_finite(t.rows[1]) && is_finite(t.rows[2]) && is_finite(t.offset);
}

}  // namespace

Result<Model> transform(const Model& model, const Transform& map) {
  const double largest = std::max({norm(map.rows[0]), norm(map.rows[1]), norm(map.rows[2])});
  const double determinant = map.determinant();
  Arguments arguments("transform");
  arguments.require(is_finite(map), "the matrix", "of finite numbers", "one with infinite or undefined ones");
  arguments.require(largest > 1e-30 && largest < 1e30 && std::abs(determinant) > 1e-12 * largest * largest * largest,
                    "the matrix", "regular (it must not flatten space)",
                    "one of determinant " + number_text(determinant));
  ARESTA_CHECK(arguments.status());
  double factor = std::cbrt(std::abs(determinant));
  const bool similar = map.is_similarity(&factor);
  const bool mirrored = determinant < 0;

  ModelBuilder builder;
  ModelCopier copier(model, builder, map);
  if (const Status status = append(model, copier, builder, mirrored); !status.ok()) {
    if (similar || status.error().code != errors::bad_transform) return status.error();
    return Error{
        errors::not_similar,
        "transform: the matrix stretches directions unequally, which curved analytic geometry cannot follow: " +
            status.error().message,
        status.error().entities,
        {},
        "use rigid motions, mirrors and uniform scalings for curved models"};
  }
  Box3 box;
  for (const VertexId v : model.topology().vertices()) box.add(map.point(model.point(v)));
  if (!box.empty()) {
    arguments.point("the moved model's corner", box.low);
    arguments.point("the moved model's corner", box.high);
    ARESTA_CHECK(arguments.status());
  }
  std::vector<std::uint32_t> radial_next;
  append_radial_order(model, mirrored, radial_next);
  builder.set_radial_order(std::move(radial_next));
  builder.tolerance = std::max(factor * model.tolerance(), rounding_tolerance(box));
  builder.length_unit = model.length_unit;
  builder.labels = model.labels;
  builder.provenance = model.provenance;
  Cells cells;
  std::vector<bool> filled{false};
  append_cells(model, 0, cells, filled);
  return builder.build(cells, filled);
}

Result<Model> translate(const Model& model, Vec3 offset) {
  Arguments arguments("translate");
  arguments.point("offset", offset);
  ARESTA_CHECK(arguments.status());
  return transform(model, Transform::translation(offset));
}

Result<Model> rotate(const Model& model, double angle, Vec3 axis, Vec3 about) {
  Arguments arguments("rotate");
  arguments.finite("angle", angle);
  arguments.direction("axis", axis);
  arguments.point("about", about);
  ARESTA_CHECK(arguments.status());
  return transform(model, Transform::rotation(angle, axis, about));
}

Result<Model> scale(const Model& model, double factor, Vec3 about) {
  Arguments arguments("scale");
  arguments.length("factor", factor);
  arguments.point("about", about);
  ARESTA_CHECK(arguments.status());
  return transform(model, Transform::scaling(factor, about));
}

Result<Model> mirror(const Model& model, Vec3 point, Vec3 normal) {
  Arguments arguments("mirror");
  arguments.point("point", point);
  arguments.direction("normal", normal);
  ARESTA_CHECK(arguments.status());
  return transform(model, Transform::reflection(point, normal));
}

Result<std::vector<Model>> grid(const Model& model, std::array<int, 3> count, Vec3 step) {
  Arguments arguments("grid");
  constexpr long long most = 1000000;
  for (int i = 0; i < 3; ++i) {
    arguments.count(std::string("n[") + "012"[i] + "]", count[static_cast<std::size_t>(i)], 1, most);
    if (arguments.ok() && count[static_cast<std::size_t>(i)] > 1) {
      arguments.require(step[i] != 0, std::string("step[") + "012"[i] + "]", "other than 0 where there are copies",
                        "0");
    }
  }
  arguments.point("step", step);
  if (arguments.ok()) {
    arguments.require(static_cast<long long>(count[0]) * count[1] <= most &&
                          static_cast<long long>(count[0]) * count[1] * count[2] <= most,
                      "the number of copies", "at most a million", "more");
  }
  ARESTA_CHECK(arguments.status());
  std::vector<Model> copies;
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        ARESTA_TRY(Model copy, translate(model, {i * step.x, j * step.y, k * step.z}));
        copies.push_back(std::move(copy));
      }
    }
  }
  return copies;
}

namespace {

/// The first two boxes (by index) that meet, found by sweeping along x.
std::optional<std::pair<std::size_t, std::size_t>> find_meeting(const std::vector<Box3>& boxes) {
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::pair(boxes[a].low.x, a) < std::pair(boxes[b].low.x, b); });
  std::optional<std::pair<std::size_t, std::size_t>> first;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].low.x <= boxes[order[i]].high.x; ++j) {
      if (!boxes[order[i]].overlaps(boxes[order[j]])) continue;
      const auto pair = std::minmax(order[i], order[j]);
      if (!first || std::pair<std::size_t, std::size_t>(pair) < *first) first = pair;
    }
  }
  return first;
}

std::uint32_t append_sources(const Provenance& from, Provenance& to) {
  const auto shift = static_cast<std::uint32_t>(to.sources.size());
  to.sources.insert(to.sources.end(), from.sources.begin(), from.sources.end());
  return shift;
}

}  // namespace

Result<Model> merge_disjoint(std::span<const Model* const> models, const Context& context) {
  Arguments arguments("merge");
  arguments.require(!models.empty(), "models", "a list of one or more", "an empty list");
  ARESTA_CHECK(arguments.status());
  std::vector<Box3> boxes;
  Box3 whole;
  double tolerance = 0;
  for (const Model* model : models) {
    if (model->length_unit != models[0]->length_unit) {
      return Error{errors::mixed_units,
                   "merge: the models have different length units: " + number_text(models[0]->length_unit) + " m and " +
                       number_text(model->length_unit) + " m"};
    }
    tolerance = std::max(tolerance, model->tolerance());
    boxes.push_back(model->bounds());
    whole.add(boxes.back());
  }
  tolerance = std::max(tolerance, 1e-9 * whole.diagonal());
  for (Box3& box : boxes) box = box.grown(0.5 * tolerance);
  if (const auto meeting = find_meeting(boxes)) {
    const Vec3 place = boxes[meeting->second].centre();
    return Error{errors::not_disjoint,
                 "items " + std::to_string(meeting->first) + " and " + std::to_string(meeting->second) +
                     " (counted from 0) may touch: their boxes meet",
                 {},
                 std::array{place.x, place.y, place.z},
                 "union or fragment, which join what meets"};
  }
  ModelBuilder builder;
  builder.tolerance = tolerance;
  builder.length_unit = models[0]->length_unit;
  auto provenance = std::make_shared<Provenance>();
  Cells cells;
  std::vector<bool> filled{false};
  std::vector<std::uint32_t> radial_next;
  std::array<std::uint32_t, 4> shift{};  // per kind of entity
  for (std::size_t i = 0; i < models.size(); ++i) {
    ARESTA_CHECK(context.step(static_cast<double>(i) / static_cast<double>(models.size()), "joining models"));
    const Model& model = *models[i];
    const Complex& k = model.topology();
    shift[3] = cells.count - 1;
    ModelCopier copier(model, builder);
    ARESTA_CHECK(append(model, copier, builder, false));
    append_radial_order(model, false, radial_next);
    append_cells(model, shift[3], cells, filled);
    const auto moved = [&](EntityRef e) {
      return EntityRef(e.kind, e.index + shift[static_cast<std::size_t>(e.kind)]);
    };
    std::map<EntityRef, EntityRef> image;
    for (const auto& [entity, unused] : model.labels.attributes) image[entity] = moved(entity);
    for (const Group& group : model.labels.groups) {
      for (const EntityRef entity : group.entities) image[entity] = moved(entity);
    }
    copy_labels(model.labels, image, builder.labels);
    if (model.provenance) {
      const std::uint32_t first_source = append_sources(*model.provenance, *provenance);
      for (const auto& [entity, parents] : model.provenance->parents) {
        auto& of = provenance->parents[moved(entity)];
        for (const Parent& parent : parents) of.push_back({parent.source + first_source, parent.entity});
      }
    }
    shift[0] += static_cast<std::uint32_t>(k.vertex_count());
    shift[1] += static_cast<std::uint32_t>(k.edge_count());
    shift[2] += static_cast<std::uint32_t>(k.face_count());
  }
  if (!provenance->sources.empty()) builder.provenance = provenance;
  builder.set_radial_order(std::move(radial_next));
  return builder.build(cells, filled);
}

}  // namespace aresta
