// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh_model.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/crossings.h"
#include "mesh/embed.h"
#include "mesh/errors.h"
#include "mesh/linear_mesh.h"
#include "mesh/quality.h"

namespace aresta {

namespace mesh {

namespace {

constexpr int attempts = 6;

class Mesher {
 public:
  Mesher(const Model& model, MeshOptions options, const Context& context)
      : model_(model), topology_(model.topology()), options_(std::move(options)), context_(context) {}

  Result<Mesh> run() {
    number_regions();
    ARESTA_TRY(SizeField wished, model_sizes(model_, options_, context_));
    for (int attempt = 0; attempt < attempts; ++attempt) {
      ARESTA_TRY(const bool good, mesh_surfaces(wished, attempt + 1 == attempts));
      if (good) break;
    }
    if (options_.dimension == 3) ARESTA_CHECK(mesh_regions());
    return finish();
  }

 private:
  /// Edges and faces. False: some checks failed and `wished` was made finer there.
  Result<bool> mesh_surfaces(SizeField& wished, bool last) {
    SizeField field = wished;
    ARESTA_TRY(EdgeMesh edges, subdivide_edges(model_, field, context_));
    linear_ = {};
    linear_.nodes = std::move(edges.nodes);
    linear_.chains = std::move(edges.chains);
    if (options_.dimension == 1) return true;
    edges.nodes = linear_.nodes;
    edges.chains = linear_.chains;
    bool good = true;
    for (const FaceId f : topology_.faces()) {
      ARESTA_CHECK(
          context_.step(static_cast<double>(f.index()) / static_cast<double>(topology_.face_count()), "surface mesh"));
      auto made = mesh_face(model_, f, edges, field, quiet());
      if (made.ok()) {
        add_face(*made);
        continue;
      }
      const ErrorCode code = made.error().code;
      if (last || !(code == errors::mesh_face_boundary || code == errors::mesh_face_failed))
        return std::move(made).error();
      linear_.faces.emplace_back();
      refine_around(f, wished);
      good = false;
    }
    if (!good) return false;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& face : linear_.faces)
      triangles.insert(triangles.end(), face.triangles.begin(), face.triangles.end());
    const std::vector<Crossing> crossings = find_crossings(linear_.nodes, triangles, 200);
    for (const Crossing& crossing : crossings) {
      const FaceId first = face_of(crossing.first), second = face_of(crossing.second);
      if (last || lie_on_each_other(first, second)) return crossing_error(first, second, crossing.place);
    }
    for (const Crossing& crossing : crossings) wished.restrict(crossing.place, 0.5 * field.at(crossing.place));
    if (!crossings.empty()) return false;
    if (options_.dimension == 2) return true;
    auto helpers = embed_all(std::move(triangles), field);
    if (helpers.ok()) {
      helpers_ = std::move(*helpers);
      return true;
    }
    if (last) return std::move(helpers).error();
    const auto& place = *helpers.error().place;
    const Vec3 p{place[0], place[1], place[2]};
    wished.restrict(p, 0.5 * field.at(p));
    return false;
  }

  /// No size helps where two faces have pieces of one surface in common.
  bool lie_on_each_other(FaceId a, FaceId b) const {
    if (a == b) return false;
    return coincident(model_.surface(a), parameter_box(model_, a), model_.surface(b),
                      1e-6 * model_.bounds().diagonal());
  }

  static Error crossing_error(FaceId a, FaceId b, Vec3 p) {
    Error error{errors::mesh_surfaces_cross, "the mesh of the face crosses itself", {a}, {{p.x, p.y, p.z}}};
    error.hint = "a smaller element size there, or fragment the model first if its parts touch or overlap";
    if (a == b) return error;
    error.message = "the meshes of two faces that touch, cross or come too close to each other intersect";
    error.entities = {std::min(a, b), std::max(a, b)};
    return error;
  }

  /// The face of a triangle counted through all faces.
  FaceId face_of(std::size_t triangle) const {
    std::size_t f = 0;
    while (triangle >= linear_.faces[f].triangles.size()) triangle -= linear_.faces[f++].triangles.size();
    return FaceId(f);
  }

  /// Cancels as the caller's context does but keeps the progress of faces to the loop over them.
  Context quiet() const {
    Context context = context_;
    context.progress = {};
    return context;
  }

  void refine_around(FaceId f, SizeField& wished) const {
    for (const LoopId l : topology_.loops(f)) {
      if (topology_.is_vertex_loop(l)) continue;
      for (const CoedgeId c : topology_.coedges(l)) {
        const auto& nodes = linear_.chains[topology_.edge(c).index()].nodes;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
          const Vec3 a = linear_.nodes[nodes[i - 1]], b = linear_.nodes[nodes[i]];
          wished.restrict(0.5 * (a + b), 0.5 * distance(a, b));
        }
      }
    }
  }

  void add_face(const FaceMesh& made) {
    LinearFace& face = linear_.faces.emplace_back();
    const auto first = static_cast<std::uint32_t>(linear_.nodes.size());
    const auto boundary_count = static_cast<std::uint32_t>(made.boundary.size());
    const auto whole = [&](std::uint32_t local) {
      return local < boundary_count ? made.boundary[local] : first + local - boundary_count;
    };
    linear_.nodes.insert(linear_.nodes.end(), made.inner.begin(), made.inner.end());
    for (const auto& t : made.triangles) face.triangles.push_back({whole(t[0]), whole(t[1]), whole(t[2])});
    std::vector<std::uint32_t> order(boundary_count);
    for (std::uint32_t i = 0; i < boundary_count; ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return made.boundary[a] < made.boundary[b]; });
    for (const std::uint32_t i : order) {
      face.nodes.push_back(made.boundary[i]);
      face.uv.push_back(made.boundary_uv[i]);
      face.inner.push_back(false);
    }
    for (std::uint32_t i = 0; i < made.inner.size(); ++i) {
      face.nodes.push_back(first + i);
      face.uv.push_back(made.inner_uv[i]);
      face.inner.push_back(true);
    }
  }

  // --- regions ---

  void number_regions() {
    regions_ = model_.regions();
    number_.assign(topology_.region_count(), 0);
    for (std::size_t i = 0; i < regions_.size(); ++i) number_[regions_[i].index()] = static_cast<std::uint32_t>(i + 1);
  }

  /// Helper triangles for the wires and points inside regions.
  Result<Helpers> embed_all(std::vector<std::array<std::uint32_t, 3>> triangles, const SizeField& field) const {
    EmbedInput input;
    for (const RegionId r : regions_) {
      const std::uint32_t number = number_[r.index()];
      for (const ShellId s : topology_.shells(r)) {
        for (const EdgeId e : topology_.wires(s)) {
          const auto& nodes = linear_.chains[e.index()].nodes;
          for (std::size_t i = 1; i < nodes.size(); ++i) input.sides.push_back({nodes[i - 1], nodes[i], e, number});
        }
        if (const VertexId v = topology_.shell_vertex(s); v.valid()) {
          input.isolated.push_back({v.value, v, number, field.at(model_.point(v))});
        }
      }
    }
    if (input.sides.empty() && input.isolated.empty()) return Helpers{linear_.nodes, {}};
    input.points = linear_.nodes;
    input.surface = std::move(triangles);
    return embed(input);
  }

  Status mesh_regions() {
    if (regions_.empty()) return {};
    VolumeInput input;
    input.region_count = static_cast<std::uint32_t>(regions_.size());
    for (const RegionId r : regions_) {
      const auto own = options_.sizes.find(r);
      input.region_sizes.push_back(own == options_.sizes.end() ? options_.size : std::min(options_.size, own->second));
    }
    input.grading = options_.grading;
    linear_.nodes = std::move(helpers_.points);
    std::vector<std::uint32_t> point_of(linear_.nodes.size(), 0xffffffffu), node_of;
    const auto add = [&](VolumeTriangle t) {
      for (std::uint32_t& n : t.nodes) {
        if (point_of[n] == 0xffffffffu) {
          point_of[n] = static_cast<std::uint32_t>(input.points.size());
          input.points.push_back(linear_.nodes[n]);
          node_of.push_back(n);
        }
        n = point_of[n];
      }
      input.triangles.push_back(t);
    };
    for (const FaceId f : topology_.faces()) {
      const std::uint32_t front = number_[topology_.region(FaceUse(f, 0)).index()],
                          back = number_[topology_.region(FaceUse(f, 1)).index()];
      if (front == 0 && back == 0) continue;
      for (const auto& t : linear_.faces[f.index()].triangles) add({t, f.value, front, back});
    }
    for (const auto& helper : helpers_.triangles) add(helper);
    auto filled = fill_volumes(input, context_);
    if (!filled.ok()) return translate(std::move(filled).error(), regions_);
    if (auto status = check_volumes(input, *filled); !status.ok())
      return translate(std::move(status).error(), regions_);
    for (std::size_t i = input.points.size(); i < filled->points.size(); ++i) {
      node_of.push_back(static_cast<std::uint32_t>(linear_.nodes.size()));
      linear_.nodes.push_back(filled->points[i]);
    }
    linear_.tetras = std::move(filled->tetras);
    for (Tetra& t : linear_.tetras) {
      for (std::uint32_t& n : t.nodes) n = node_of[n];
      t.region = regions_[t.region - 1].value + 1;
    }
    std::stable_sort(linear_.tetras.begin(), linear_.tetras.end(),
                     [](const Tetra& a, const Tetra& b) { return a.region < b.region; });
    return {};
  }

  /// Regions in errors of the volume mesher are counted; here they get their model's number.
  static Error translate(Error error, const std::vector<RegionId>& regions) {
    for (EntityRef& entity : error.entities) {
      if (entity.kind == EntityKind::region && entity.index < regions.size()) entity = regions[entity.index];
    }
    return error;
  }

  // --- the answer ---

  Result<Mesh> finish() {
    const bool second = options_.order == 2;
    std::optional<SecondOrder> curved;
    if (second) curved.emplace(model_, linear_);
    Mesh result;
    for (const VertexId v : topology_.vertices()) result.blocks.push_back({ElementType::point1, v, {v.value}});
    for (const EdgeId e : topology_.edges()) {
      ElementBlock block{second ? ElementType::line3 : ElementType::line2, e, {}};
      const auto& nodes = linear_.chains[e.index()].nodes;
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        block.nodes.insert(block.nodes.end(), {nodes[i - 1], nodes[i]});
        if (second) block.nodes.push_back(curved->mid(nodes[i - 1], nodes[i]));
      }
      result.blocks.push_back(std::move(block));
    }
    for (std::size_t f = 0; f < linear_.faces.size(); ++f) {
      ElementBlock block{second ? ElementType::triangle6 : ElementType::triangle3, FaceId(f), {}};
      for (const auto& t : linear_.faces[f].triangles) {
        block.nodes.insert(block.nodes.end(), t.begin(), t.end());
        if (second)
          block.nodes.insert(block.nodes.end(),
                             {curved->mid(t[0], t[1]), curved->mid(t[1], t[2]), curved->mid(t[2], t[0])});
      }
      result.blocks.push_back(std::move(block));
    }
    for (std::size_t i = 0; i < linear_.tetras.size();) {
      const std::uint32_t region = linear_.tetras[i].region;
      ElementBlock block{second ? ElementType::tetra10 : ElementType::tetra4, RegionId(region - 1), {}};
      for (; i < linear_.tetras.size() && linear_.tetras[i].region == region; ++i) {
        const auto& n = linear_.tetras[i].nodes;
        block.nodes.insert(block.nodes.end(), n.begin(), n.end());
        if (second) {
          block.nodes.insert(block.nodes.end(),
                             {curved->mid(n[0], n[1]), curved->mid(n[1], n[2]), curved->mid(n[2], n[0]),
                              curved->mid(n[0], n[3]), curved->mid(n[1], n[3]), curved->mid(n[2], n[3])});
        }
      }
      result.blocks.push_back(std::move(block));
    }
    result.nodes = std::move(linear_.nodes);
    add_sets(result);
    if (options_.dimension == 3) {
      const QualityReport report = quality_report(result, 3, 1);
      if (report.inverted > 0) {
        const auto& worst = report.worst_elements.front();
        return Error{errors::mesh_check_failed,
                     "a volume element is turned inside out",
                     {worst.entity},
                     {{worst.centre.x, worst.centre.y, worst.centre.z}}};
      }
    }
    return result;
  }

  void add_sets(Mesh& result) const {
    std::vector<EntityRef> present;
    for (const auto& block : result.blocks) present.push_back(block.entity);
    const auto add = [&](const std::string& name, const std::vector<EntityRef>& entities) {
      auto set = std::find_if(result.sets.begin(), result.sets.end(), [&](const MeshSet& s) { return s.name == name; });
      std::vector<EntityRef> kept;
      for (const EntityRef entity : entities) {
        if (std::binary_search(present.begin(), present.end(), entity)) kept.push_back(entity);
      }
      if (kept.empty()) return;
      if (set == result.sets.end()) set = result.sets.insert(set, MeshSet{name, {}});
      set->entities.insert(set->entities.end(), kept.begin(), kept.end());
      std::sort(set->entities.begin(), set->entities.end());
      set->entities.erase(std::unique(set->entities.begin(), set->entities.end()), set->entities.end());
    };
    for (const auto& [entity, attributes] : model_.labels.attributes) {
      const std::string name = model_.labels.name(entity);
      if (!name.empty()) add(name, {entity});
    }
    for (const Group& group : model_.labels.groups) add(group.name, group.entities);
  }

  const Model& model_;
  const Complex& topology_;
  MeshOptions options_;
  const Context& context_;
  LinearMesh linear_;
  std::vector<RegionId> regions_;
  std::vector<std::uint32_t> number_;  ///< per region of the model: from 1, 0 for none
  Helpers helpers_;
};

}  // namespace

}  // namespace mesh

Result<Mesh> mesh_model(const Model& model, const MeshOptions& options, const Context& context) {
  ARESTA_TRY(MeshOptions complete, mesh::complete_options(model, options));
  return mesh::Mesher(model, std::move(complete), context).run();
}

}  // namespace aresta
