// SPDX-License-Identifier: Apache-2.0
#include "fragment/fragment.h"

#include <algorithm>

#include "fragment/conservation.h"
#include "fragment/identity.h"
#include "fragment/parts.h"
#include "model/copy.h"
#include "model/inherit.h"
#include "model/query.h"

namespace aresta {

namespace {

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// A face and its parent lie on the same surface; do their normals agree? Asked at a point inside the face.
Result<std::vector<std::vector<bool>>> find_senses(const Model& model, const std::vector<std::vector<Parent>>& parents,
                                                   std::span<const std::shared_ptr<const Model>> operands) {
  std::vector<std::vector<bool>> senses(parents.size());
  for (const FaceId f : model.topology().faces()) {
    Vec3 point, normal;
    bool have_point = false;
    for (const Parent& parent : parents[f.index()]) {
      if (parent.entity.kind != EntityKind::face) continue;
      const Model& operand = *operands[parent.source];
      const FaceId g{parent.entity.index};
      if (!have_point) {
        if (model.surface(f).is_plane()) {
          normal = model.normal(f, {});
        } else {
          ARESTA_TRY(const Vec2 uv, FaceTrim(model, f).interior_point());
          point = model.surface(f).point(uv);
          normal = model.normal(f, uv);
        }
        have_point = true;
      }
      const Surface& surface = operand.surface(g);
      const Vec3 other = surface.is_plane() ? operand.normal(g, {}) : operand.normal(g, surface.project(point).uv);
      const double agreement = dot(normal, other);
      if (std::abs(agreement) < 0.5) {
        return Error{
            errors::imprint_failed, "a piece of a face does not lie on the face it came from", {f}, as_array(point)};
      }
      senses[f.index()].push_back(agreement > 0);
    }
  }
  return senses;
}

std::vector<bool> filled_cells(const Fragment& result, const std::vector<std::vector<Parent>>& face_parents,
                               bool detect_regions) {
  const Complex& k = result.model->topology();
  std::vector<bool> filled(k.region_count(), false);
  for (std::size_t c = 1; c < filled.size(); ++c) {
    const auto labels = result.labels.of(RegionId(c));
    filled[c] = std::any_of(labels.begin(), labels.end(), [&](const Parent& p) {
      return result.operands[p.source]->is_region(RegionId(p.entity.index));
    });
  }
  if (!detect_regions) return filled;
  for (const FaceId f : k.faces()) {
    if (k.has_same_region_on_both_sides(f)) continue;  // encloses nothing
    const bool is_sheet =
        std::none_of(face_parents[f.index()].begin(), face_parents[f.index()].end(), [&](const Parent& p) {
          if (p.entity.kind != EntityKind::face) return false;
          const Model& operand = *result.operands[p.source];
          const FaceId g{p.entity.index};
          return operand.is_region(operand.topology().region(FaceUse(g, 0))) ||
                 operand.is_region(operand.topology().region(FaceUse(g, 1)));
        });
    if (!is_sheet) continue;
    for (int side = 0; side < 2; ++side) {
      const RegionId cell = k.region(FaceUse(f, side));
      if (cell != Complex::infinite_region()) filled[cell.index()] = true;
    }
  }
  return filled;
}

/// A piece of a constraint stays one, unless it is also a piece of a plain wall.
void mark_constraints(Imprint& imprint, std::span<const std::shared_ptr<const Model>> operands) {
  for (std::uint32_t f = 0; f < imprint.face_parents.size(); ++f) {
    bool constraint = false, wall = false;
    for (const Parent& p : imprint.face_parents[f]) {
      if (p.entity.kind != EntityKind::face) continue;
      const Model& operand = *operands[p.source];
      const FaceId g{p.entity.index};
      const RegionId front = operand.topology().region(FaceUse(g, 0)), back = operand.topology().region(FaceUse(g, 1));
      const bool bounds = front != back && (operand.is_region(front) || operand.is_region(back));
      (operand.is_constraint(g) ? constraint : wall) |= operand.is_constraint(g) || bounds;
    }
    imprint.builder.set_constraint(FaceId(f), constraint && !wall);
  }
}

/// One operand whose parts share what they meet in needs no imprint: it is its own fragment.
Result<Imprint> copy_of(const Model& model) {
  Imprint copy{to_builder(model), {}, {}, {}, {}};
  for (const VertexId v : model.topology().vertices()) copy.vertex_parents.push_back({{0, v}});
  for (const EdgeId e : model.topology().edges()) copy.edge_parents.push_back({{0, e}});
  for (const FaceId f : model.topology().faces()) copy.face_parents.push_back({{0, f}});
  return copy;
}

std::shared_ptr<const Provenance> make_provenance(const Fragment& result, const Imprint& imprint) {
  auto provenance = std::make_shared<Provenance>();
  provenance->sources = result.operands;
  for (std::uint32_t v = 0; v < imprint.vertex_parents.size(); ++v)
    provenance->parents[VertexId(v)] = imprint.vertex_parents[v];
  for (std::uint32_t e = 0; e < imprint.edge_parents.size(); ++e)
    provenance->parents[EdgeId(e)] = imprint.edge_parents[e];
  for (std::uint32_t f = 0; f < imprint.face_parents.size(); ++f)
    provenance->parents[FaceId(f)] = imprint.face_parents[f];
  for (std::size_t c = 1; c < result.model->topology().region_count(); ++c) {
    for (const Parent& p : result.labels.of(RegionId(c))) {
      if (result.operands[p.source]->is_region(RegionId(p.entity.index))) provenance->parents[RegionId(c)].push_back(p);
    }
  }
  return provenance;
}

/// The fragment of a model's parts as one of the model itself.
class Regrouping {
 public:
  Regrouping(const Fragment& of_parts, const std::vector<ModelPart>& parts, std::shared_ptr<const Model> whole)
      : of_parts_(of_parts), parts_(parts), whole_(std::move(whole)) {}

  Fragment run() {
    const Complex& k = of_parts_.model->topology();
    result_.operands = {whole_};
    auto provenance = std::make_shared<Provenance>();
    provenance->sources = result_.operands;
    std::vector<std::vector<Parent>> vertices, edges, faces;
    for (const VertexId v : k.vertices()) vertices.push_back(translated(v));
    for (const EdgeId e : k.edges()) edges.push_back(translated(e));
    for (const FaceId f : k.faces()) faces.push_back(translated(f));
    for (const VertexId v : k.vertices()) provenance->parents[v] = vertices[v.index()];
    for (const EdgeId e : k.edges()) provenance->parents[e] = edges[e.index()];
    for (const FaceId f : k.faces()) {
      provenance->parents[f] = faces[f.index()];
      result_.same_sense.push_back(senses(f, faces[f.index()]));
    }
    std::vector<std::vector<Parent>> labels;
    for (const RegionId c : k.regions()) {
      auto& of_cell = labels.emplace_back();
      if (const RegionId r = region_around(c); r != Complex::infinite_region()) of_cell.push_back({0, r});
      if (const auto parents = translated(c); !parents.empty()) provenance->parents[c] = parents;
    }
    result_.labels = CellLabels(std::move(labels));
    result_.piece_table = PieceTable(result_.operands, {&vertices, &edges, &faces});
    Model model = *of_parts_.model;
    model.provenance = std::move(provenance);
    result_.conflicts = inherit_labels(model);
    result_.model = std::make_shared<const Model>(std::move(model));
    return std::move(result_);
  }

 private:
  Parent translated(const Parent& p) const {
    const ExtractionMap& from = parts_[p.source].from;
    switch (p.entity.kind) {
      case EntityKind::vertex:
        return {0, from.vertices[p.entity.index]};
      case EntityKind::edge:
        return {0, from.edges[p.entity.index]};
      case EntityKind::face:
        return {0, from.faces[p.entity.index]};
      default:
        return {0, from.regions[p.entity.index].front()};
    }
  }

  std::vector<Parent> translated(EntityRef entity) const {
    std::vector<Parent> result;
    for (const Parent& p : of_parts_.parents(entity)) result.push_back(translated(p));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// Per parent that is a face, as the parts knew it.
  std::vector<bool> senses(FaceId f, const std::vector<Parent>& parents) const {
    std::vector<bool> result;
    for (const Parent& wanted : parents) {
      if (wanted.entity.kind != EntityKind::face) continue;
      std::size_t i = 0;
      for (const Parent& p : of_parts_.parents(f)) {
        if (p.entity.kind != EntityKind::face) continue;
        if (translated(p) == wanted) {
          result.push_back(of_parts_.same_sense[f.index()][i]);
          break;
        }
        ++i;
      }
    }
    return result;
  }

  RegionId region_around(RegionId c) const {
    RegionId found = Complex::infinite_region();
    for (const Parent& p : of_parts_.labels.of(c)) {
      const RegionId of_whole = parts_[p.source].from.regions[p.entity.index].front();
      if (whole_->is_region(of_whole)) return of_whole;
      if (found == Complex::infinite_region()) found = of_whole;
    }
    return found;
  }

  const Fragment& of_parts_;
  const std::vector<ModelPart>& parts_;
  std::shared_ptr<const Model> whole_;
  Fragment result_;
};

}  // namespace

PieceTable::PieceTable(std::span<const std::shared_ptr<const Model>> operands,
                       const std::array<const std::vector<std::vector<Parent>>*, 3>& parents) {
  std::array<std::uint32_t, 3> count{};
  for (const auto& operand : operands) {
    first_.push_back(count);
    const Complex& k = operand->topology();
    count[0] += static_cast<std::uint32_t>(k.vertex_count());
    count[1] += static_cast<std::uint32_t>(k.edge_count());
    count[2] += static_cast<std::uint32_t>(k.face_count());
  }
  for (std::uint32_t dimension = 0; dimension < 3; ++dimension) {
    std::vector<IndexPair> pairs;
    for (std::uint32_t i = 0; i < parents[dimension]->size(); ++i) {
      for (const Parent& p : (*parents[dimension])[i]) {
        if (static_cast<std::uint32_t>(p.entity.kind) == dimension)
          pairs.emplace_back(first_[p.source][dimension] + p.entity.index, i);
      }
    }
    pieces_[dimension] = group(count[dimension], pairs);
  }
}

namespace {

Result<Fragment> finish(std::vector<std::shared_ptr<const Model>> operands, Imprint& imprint,
                        const FragmentOptions& options, const Context& context) {
  imprint.builder.length_unit = operands.front()->length_unit;
  imprint.builder.tolerance = options.tolerance;
  for (const auto& operand : operands)
    imprint.builder.tolerance = std::max(imprint.builder.tolerance, operand->tolerance());

  if (!imprint.cells) {
    ARESTA_TRY(imprint.cells, imprint.builder.find_cells(context));
  }
  const Cells& cells = *imprint.cells;
  mark_constraints(imprint, operands);
  ARESTA_TRY(Model model, imprint.builder.build(cells, std::vector<bool>(cells.count, false)));

  Fragment result;
  result.operands = std::move(operands);
  ARESTA_CHECK(context.step(0, "labelling cells"));
  ARESTA_TRY(result.same_sense, find_senses(model, imprint.face_parents, result.operands));
  ARESTA_TRY(result.labels,
             label_cells(result.operands, cells.count, cells.of_face_use, imprint.face_parents, result.same_sense));
  result.piece_table =
      PieceTable(result.operands, {&imprint.vertex_parents, &imprint.edge_parents, &imprint.face_parents});
  result.model = std::make_shared<const Model>(model);
  ARESTA_CHECK(check_conservation(result, context));

  ModelBuilder::fill(model, filled_cells(result, imprint.face_parents, options.detect_regions));
  model.provenance = make_provenance(result, imprint);
  result.conflicts = inherit_labels(model);
  result.model = std::make_shared<const Model>(std::move(model));
  return result;
}

/// The one asked for; else the planar one wherever it serves.
const FragmentEngine& engine_for(std::span<const std::shared_ptr<const Model>> operands,
                                 const FragmentOptions& options) {
  if (options.engine != nullptr) return *options.engine;
  const bool planar = std::all_of(operands.begin(), operands.end(), [](const auto& m) { return m->is_planar(); });
  return planar ? planar_engine() : occt_engine();
}

/// What cannot be finished is imprinted once more, by an engine that can; the first error counts.
Result<Fragment> imprint_and_finish(const FragmentEngine& engine,
                                    const std::vector<std::shared_ptr<const Model>>& operands,
                                    const FragmentOptions& options, const Context& context) {
  ARESTA_TRY(Imprint imprint, engine.imprint(operands, options.tolerance, context));
  if (!engine.has_second_try()) return finish(operands, imprint, options, context);
  const Imprint first = imprint;
  Result<Fragment> done = finish(operands, imprint, options, context);
  if (done.ok() || done.error().code == errors::cancelled) return done;
  Result<Imprint> second = engine.again(first, operands.size(), options.tolerance, context);
  if (!second.ok())
    return second.error().code == errors::cancelled ? std::move(second).error() : std::move(done).error();
  Result<Fragment> redone = finish(operands, *second, options, context);
  return redone.ok() || redone.error().code == errors::cancelled ? std::move(redone) : std::move(done);
}

/// Parts that meet only in what they have as wholes need no intersecting.
Result<std::optional<Fragment>> by_identity(const std::vector<std::shared_ptr<const Model>>& operands,
                                            const FragmentOptions& options, const Context& context) {
  FragmentOptions identity = options;
  identity.engine = &identity_engine();
  Result<Fragment> joined = fragment(operands, identity, context);
  if (!joined.ok()) {
    if (joined.error().code == errors::cancelled) return std::move(joined).error();
    return std::optional<Fragment>();
  }
  ARESTA_TRY(const bool meets, meets_unshared(*joined->model, context));
  if (meets) return std::optional<Fragment>();
  return std::optional<Fragment>(std::move(*joined));
}

Result<Fragment> fragment_of_one(const std::shared_ptr<const Model>& model, const FragmentOptions& options,
                                 const Context& context) {
  ARESTA_TRY(const bool meets, meets_unshared(*model, context));
  if (!meets) {
    ARESTA_TRY(Imprint copy, copy_of(*model));
    return finish({model}, copy, options, context);
  }
  ARESTA_TRY(const std::vector<ModelPart> parts, split_into_parts(*model));
  if (parts.size() == 1) {
    // Whatever does not hang together in it is imprinted on each other.
    const FragmentEngine& engine = engine_for({&model, 1}, options);
    const std::vector<std::shared_ptr<const Model>> alone{model};
    return imprint_and_finish(engine, alone, options, context);
  }
  std::vector<std::shared_ptr<const Model>> operands;
  for (const ModelPart& part : parts) operands.push_back(part.model);
  if (options.engine == nullptr) {
    ARESTA_TRY(const auto joined, by_identity(operands, options, context));
    if (joined) return Regrouping(*joined, parts, model).run();
  }
  ARESTA_TRY(const Fragment imprinted, fragment(std::move(operands), options, context));
  return Regrouping(imprinted, parts, model).run();
}

}  // namespace

Result<Fragment> fragment(std::vector<std::shared_ptr<const Model>> operands, const FragmentOptions& options,
                          const Context& context) {
  if (operands.empty()) return Error{errors::no_operands, "there is nothing to fragment"};
  if (operands.size() == 1) return fragment_of_one(operands.front(), options, context);
  return imprint_and_finish(engine_for(operands, options), operands, options, context);
}

}  // namespace aresta
