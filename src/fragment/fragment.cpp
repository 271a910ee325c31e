// SPDX-License-Identifier: Apache-2.0
#include "fragment/fragment.h"

#include <algorithm>

#include "base/union_find.h"
#include "fragment/identity.h"
#include "fragment/parts.h"
#include "model/copy.h"
#include "model/inherit.h"
#include "model/measure.h"
#include "model/query.h"

namespace aresta {

namespace {

constexpr double conservation_relative = 1e-6;

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

class Labeller {
 public:
  Labeller(Fragment& result, const std::vector<std::vector<Parent>>& face_parents, const Context& context)
      : result_(result), k_(result.model->topology()), face_parents_(face_parents), context_(context) {}

  Status run() {
    ARESTA_CHECK(find_senses());
    for (std::uint32_t o = 0; o < result_.operands.size(); ++o) {
      ARESTA_CHECK(
          context_.step(static_cast<double>(o) / static_cast<double>(result_.operands.size()), "labelling cells"));
      ARESTA_CHECK(label(o));
    }
    return {};
  }

 private:
  // A face and its parent lie on the same surface; do their normals agree? Asked at a point inside the face.
  Status find_senses() {
    const Model& model = *result_.model;
    result_.same_sense.resize(k_.face_count());
    for (const FaceId f : k_.faces()) {
      Vec3 point, normal;
      bool have_point = false;
      for (const Parent& parent : face_parents_[f.index()]) {
        if (parent.entity.kind != EntityKind::face) continue;
        const Model& operand = *result_.operands[parent.source];
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
        result_.same_sense[f.index()].push_back(agreement > 0);
      }
    }
    return {};
  }

  Status label(std::uint32_t o) {
    const Complex& operand = result_.operands[o]->topology();
    UnionFind cells(k_.region_count());
    std::vector<bool> is_wall(k_.face_count(), false);
    for (const FaceId f : k_.faces()) {
      const auto& parents = face_parents_[f.index()];
      is_wall[f.index()] = std::any_of(parents.begin(), parents.end(), [&](const Parent& p) {
        return p.source == o && p.entity.kind == EntityKind::face;
      });
      if (!is_wall[f.index()]) cells.unite(k_.region(FaceUse(f, 0)).index(), k_.region(FaceUse(f, 1)).index());
    }
    std::vector<RegionId> label(k_.region_count());
    label[cells.find(0)] = Complex::infinite_region();
    for (const FaceId f : k_.faces()) {
      if (!is_wall[f.index()]) continue;
      std::size_t i = 0;
      for (const Parent& parent : face_parents_[f.index()]) {
        if (parent.entity.kind != EntityKind::face) continue;
        const bool same = result_.same_sense[f.index()][i++];
        if (parent.source != o) continue;
        for (int side = 0; side < 2; ++side) {
          const RegionId inside = operand.region(FaceUse(FaceId(parent.entity.index), same ? side : 1 - side));
          RegionId& known = label[cells.find(k_.region(FaceUse(f, side)).index())];
          if (known.valid() && known != inside) {
            return Error{
                errors::label_conflict,
                "the pieces of operand " + std::to_string(o) + " do not close: one cell lies in two of its regions",
                {f, k_.region(FaceUse(f, side))}};
          }
          known = inside;
        }
      }
    }
    auto& labels = result_.region_of.emplace_back(k_.region_count());
    for (std::size_t c = 0; c < k_.region_count(); ++c) {
      labels[c] = label[cells.find(c)];
      if (!labels[c].valid()) {
        return Error{errors::label_conflict,
                     "a cell cannot be told to lie in a region of operand " + std::to_string(o),
                     {RegionId(c)}};
      }
    }
    return {};
  }

  Fragment& result_;
  const Complex& k_;
  const std::vector<std::vector<Parent>>& face_parents_;
  const Context& context_;
};

void fill_piece_table(Fragment& result, const std::array<const std::vector<std::vector<Parent>>*, 3>& parents) {
  result.piece_table.resize(result.operands.size());
  for (std::size_t o = 0; o < result.operands.size(); ++o) {
    const Complex& k = result.operands[o]->topology();
    result.piece_table[o][0].resize(k.vertex_count());
    result.piece_table[o][1].resize(k.edge_count());
    result.piece_table[o][2].resize(k.face_count());
  }
  for (std::uint32_t dimension = 0; dimension < 3; ++dimension) {
    for (std::uint32_t i = 0; i < parents[dimension]->size(); ++i) {
      for (const Parent& p : (*parents[dimension])[i]) {
        if (static_cast<std::uint32_t>(p.entity.kind) == dimension) {
          result.piece_table[p.source][dimension][p.entity.index].push_back(i);
        }
      }
    }
  }
}

std::vector<bool> filled_cells(const Fragment& result, const std::vector<std::vector<Parent>>& face_parents,
                               bool detect_regions) {
  const Complex& k = result.model->topology();
  std::vector<bool> filled(k.region_count(), false);
  for (std::size_t o = 0; o < result.operands.size(); ++o) {
    for (std::size_t c = 1; c < filled.size(); ++c) {
      if (result.operands[o]->is_region(result.region_of[o][c])) filled[c] = true;
    }
  }
  if (!detect_regions) return filled;
  for (const FaceId f : k.faces()) {
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
void mark_constraints(Imprint& imprint, const Fragment& result) {
  for (std::uint32_t f = 0; f < imprint.face_parents.size(); ++f) {
    bool constraint = false, wall = false;
    for (const Parent& p : imprint.face_parents[f]) {
      if (p.entity.kind != EntityKind::face) continue;
      const Model& operand = *result.operands[p.source];
      const FaceId g{p.entity.index};
      const RegionId front = operand.topology().region(FaceUse(g, 0)), back = operand.topology().region(FaceUse(g, 1));
      const bool bounds = front != back && (operand.is_region(front) || operand.is_region(back));
      (operand.is_constraint(g) ? constraint : wall) |= operand.is_constraint(g) || bounds;
    }
    imprint.builder.set_constraint(FaceId(f), constraint && !wall);
  }
}

double perimeter(const Model& model, FaceId f) {
  double sum = 0;
  for (const LoopId l : model.topology().loops(f)) {
    for (const CoedgeId c : model.topology().coedges(l)) {
      const EdgeId e = model.topology().edge(c);
      sum += model.curve(e).length(model.range(e), 1e-3);
    }
  }
  return sum;
}

/// Areas of faces and volumes of regions before and after must agree.
Status check_conservation(const Fragment& result, const Context& context) {
  const Model& model = *result.model;
  const Complex& k = model.topology();
  MeasureOptions coarse;
  coarse.relative = 1e-8;
  std::vector<double> area(k.face_count()), outflow(k.face_count());
  const Vec3 reference = model.bounds().centre();
  double scale = 0;
  for (const FaceId f : k.faces()) {
    if (f.index() % 256 == 0)
      ARESTA_CHECK(context.step(static_cast<double>(f.index()) / static_cast<double>(k.face_count()),
                                "checking areas and volumes"));
    ARESTA_TRY(const Moments a, measure(model, f, coarse));
    ARESTA_TRY(const Moments v, flux(model, f, reference, coarse));
    area[f.index()] = a.measure;
    outflow[f.index()] = v.measure;
    scale = std::max(scale, model.tolerance(f));
  }
  const double tolerance = std::max(scale, model.tolerance());
  std::vector<double> cell_volume(k.region_count(), 0), cell_surface(k.region_count(), 0);
  for (const FaceId f : k.faces()) {
    for (int side = 0; side < 2; ++side) {
      const std::size_t cell = k.region(FaceUse(f, side)).index();
      cell_volume[cell] += side == 0 ? -outflow[f.index()] : outflow[f.index()];
      cell_surface[cell] += area[f.index()];
    }
  }
  for (std::uint32_t o = 0; o < result.operands.size(); ++o) {
    const Model& operand = *result.operands[o];
    for (const FaceId g : operand.topology().faces()) {
      ARESTA_TRY(const Moments whole, measure(operand, g, coarse));
      double sum = 0;
      for (const std::uint32_t piece : result.pieces(o, g)) sum += area[piece];
      const double allowed = conservation_relative * whole.measure + 10 * tolerance * perimeter(operand, g);
      if (std::abs(sum - whole.measure) > allowed) {
        return Error{errors::not_conserved,
                     "the pieces of a face of operand " + std::to_string(o) + " have area " + std::to_string(sum) +
                         ", the face has " + std::to_string(whole.measure),
                     {g},
                     {},
                     "a larger --tolerance, or cleaner input"};
      }
    }
    std::vector<double> volume(operand.topology().region_count(), 0), surface(operand.topology().region_count(), 0);
    for (std::size_t c = 1; c < k.region_count(); ++c) {
      volume[result.region_of[o][c].index()] += cell_volume[c];
      surface[result.region_of[o][c].index()] += cell_surface[c];
    }
    for (const RegionId r : operand.regions()) {
      ARESTA_TRY(const Moments whole, measure(operand, r, coarse));
      const double allowed = conservation_relative * whole.measure + 10 * tolerance * surface[r.index()];
      if (std::abs(volume[r.index()] - whole.measure) > allowed) {
        return Error{errors::not_conserved,
                     "the cells of a region of operand " + std::to_string(o) + " have volume " +
                         std::to_string(volume[r.index()]) + ", the region has " + std::to_string(whole.measure),
                     {r},
                     {},
                     "a larger --tolerance, or cleaner input"};
      }
    }
  }
  return {};
}

/// One operand whose parts share what they meet in needs no imprint: it is its own fragment.
Result<Imprint> copy_of(const Model& model) {
  Imprint copy{to_builder(model), {}, {}, {}};
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
    for (std::uint32_t o = 0; o < result.operands.size(); ++o) {
      const RegionId r = result.region_of[o][c];
      if (result.operands[o]->is_region(r)) provenance->parents[RegionId(c)].push_back({o, r});
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
    auto& region_of = result_.region_of.emplace_back();
    for (const RegionId c : k.regions()) {
      region_of.push_back(region_around(c));
      if (const auto parents = translated(c); !parents.empty()) provenance->parents[c] = parents;
    }
    fill_piece_table(result_, {&vertices, &edges, &faces});
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
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      const RegionId r = of_parts_.region_of[p][c.index()];
      if (r == Complex::infinite_region()) continue;
      const RegionId of_whole = parts_[p].from.regions[r.index()].front();
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

std::span<const std::uint32_t> Fragment::pieces(std::uint32_t operand, EntityRef entity) const {
  return piece_table[operand][static_cast<std::size_t>(entity.kind)][entity.index];
}

namespace {

Result<Fragment> finish(std::vector<std::shared_ptr<const Model>> operands, Imprint& imprint,
                        const FragmentOptions& options, const Context& context) {
  imprint.builder.length_unit = operands.front()->length_unit;
  imprint.builder.tolerance = options.tolerance;
  for (const auto& operand : operands)
    imprint.builder.tolerance = std::max(imprint.builder.tolerance, operand->tolerance());

  ARESTA_TRY(const Cells cells, imprint.builder.find_cells(context));
  Fragment result;
  result.operands = std::move(operands);
  ARESTA_TRY(Model unfilled, imprint.builder.build(cells, std::vector<bool>(cells.count, false)));
  result.model = std::make_shared<const Model>(std::move(unfilled));
  ARESTA_CHECK(Labeller(result, imprint.face_parents, context).run());
  fill_piece_table(result, {&imprint.vertex_parents, &imprint.edge_parents, &imprint.face_parents});
  ARESTA_CHECK(check_conservation(result, context));

  mark_constraints(imprint, result);
  imprint.builder.provenance = make_provenance(result, imprint);
  ARESTA_TRY(Model filled,
             imprint.builder.build(cells, filled_cells(result, imprint.face_parents, options.detect_regions)));
  result.conflicts = inherit_labels(filled);
  result.model = std::make_shared<const Model>(std::move(filled));
  return result;
}

/// What cannot be finished is imprinted once more, by an engine that can; the first error counts.
Result<Fragment> imprint_and_finish(const FragmentEngine& engine,
                                    const std::vector<std::shared_ptr<const Model>>& operands,
                                    const FragmentOptions& options, const Context& context) {
  ARESTA_TRY(Imprint imprint, engine.imprint(operands, options.tolerance, context));
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
    const FragmentEngine& engine = options.engine != nullptr ? *options.engine : occt_engine();
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
  const FragmentEngine& engine = options.engine != nullptr ? *options.engine : occt_engine();
  return imprint_and_finish(engine, operands, options, context);
}

}  // namespace aresta
