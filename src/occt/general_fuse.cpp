// SPDX-License-Identifier: Apache-2.0
#include "occt/general_fuse.h"

#include <BOPAlgo_Alerts.hxx>
#include <BOPAlgo_Builder.hxx>
#include <BOPAlgo_PaveFiller.hxx>
#include <BOPDS_DS.hxx>
#include <BOPTools_AlgoTools3D.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IntTools_Context.hxx>
#include <Message_Report.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_AlertWithShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <set>
#include <string_view>

#include "base/union_find.h"
#include "geometry/occt_handles.h"
#include "model/copy.h"
#include "occt/errors.h"
#include "occt/fuse_checks.h"
#include "occt/guard.h"
#include "occt/model_shape.h"
#include "occt/seat_seams.h"
#include "occt/shape_reader.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// What a message of the library means for a person; null for those that do no harm here.
const char* meaning(std::string_view alert) {
  struct Entry {
    const char *name, *text;
  };
  // Not listed: edges that a face's division left unused come from inner edges, which have their own check (an edge
  // without an image is an error); an empty operand is no fault.
  static constexpr Entry table[] = {
      {"BOPAlgo_AlertBadPositioning",
       "the position of entities to each other leads to pieces smaller than the tolerance"},
      {"BOPAlgo_AlertNotSplittableEdge", "an edge is too short to be divided"},
      {"BOPAlgo_AlertTooSmallEdge", "an edge is shorter than the tolerance"},
      {"BOPAlgo_AlertSelfInterferingShape", "an operand meets itself outside shared entities"},
      {"BOPAlgo_AlertAcquiredSelfIntersection", "separate entities of one operand are merged by the tolerance"},
      {"BOPAlgo_AlertIntersectionOfPairOfShapesFailed", "the intersection of two entities failed"},
      {"BOPAlgo_AlertBuildingPCurveFailed", "an edge found no image in the parameters of a face"},
      {"BOPAlgo_AlertUnableToMakeClosedEdgeOnFace", "a seam could not be made on a closed face"},
      {"BOPAlgo_AlertPostTreatFF", "intersection curves could not be connected"},
      {"BOPAlgo_AlertIntersectionFailed", "the intersection of the operands failed"},
      {"BOPAlgo_AlertBuilderFailed", "the result could not be built"},
      {"BOPAlgo_AlertUnsupportedType", "an operand holds something that cannot be intersected"},
  };
  for (const Entry& entry : table) {
    if (alert == entry.name) return entry.text;
  }
  return nullptr;
}

/// An operand's entities: which of the input's they are, and as what parents they appear in the result.
struct Operand {
  struct Member {
    std::uint32_t index;  ///< in the input's model
    FuseParent parent;
  };
  std::vector<Member> vertices, edges, faces;
};

class GeneralFuse {
 public:
  GeneralFuse(const FuseInput& input, double tolerance, const Context& context)
      : input_(input), tolerance_(tolerance), context_(context) {}

  Result<FuseResult> run() {
    ARESTA_CHECK(convert());
    ARESTA_CHECK(fuse());
    ARESTA_CHECK(read_shape(result_, out_.builder, maps_, context_));
    out_.builder.tolerance = tolerance_;
    ARESTA_CHECK(context_.step(0.9, "checking the fused model"));
    ARESTA_CHECK(require_distinct(maps_, tolerance_));
    ARESTA_CHECK(find_parents());
    return std::move(out_);
  }

 private:
  Status convert() {
    ToShapeOptions options;
    options.solids = false;
    const GeometryChanges changes = seat_seams(*input_.model);
    model_ = input_.model;
    if (!changes.surfaces.empty()) {
      ARESTA_TRY(Model seated, to_builder(*input_.model, changes).provisional());
      model_ = std::make_shared<const Model>(std::move(seated));
    }
    ARESTA_TRY(const ModelShape shape, to_shape(*model_, options, context_));
    shapes_ = std::make_shared<ModelShape::Data>(shape.data());
    for (const auto& v : shapes_->vertices) vertices_.Add(v);
    for (const auto& e : shapes_->edges) edges_.Add(e);
    for (const auto& f : shapes_->faces) faces_.Add(f);
    operands_.resize(input_.operands);
    const auto gather = [&](const auto& parents, std::vector<Operand::Member> Operand::*list) {
      for (std::uint32_t i = 0; i < parents.size(); ++i) {
        for (const FuseParent& p : parents[i]) (operands_[p.operand].*list).push_back({i, p});
      }
    };
    gather(input_.vertices, &Operand::vertices);
    gather(input_.edges, &Operand::edges);
    gather(input_.faces, &Operand::faces);
    place_.assign(vertex_count() + edge_count() + face_count(), none);
    std::set<std::vector<std::uint32_t>> known;
    for (const Operand& operand : operands_) add_arguments(operand, known);
    return {};
  }

  std::size_t vertex_count() const { return model_->topology().vertex_count(); }
  std::size_t edge_count() const { return model_->topology().edge_count(); }
  std::size_t face_count() const { return model_->topology().face_count(); }

  // The connected parts of an operand, in the order of their first members: vertices, then edges, then faces. Parts
  // that another operand has, too, are there already.
  void add_arguments(const Operand& operand, std::set<std::vector<std::uint32_t>>& known) {
    const Complex& k = model_->topology();
    const auto edge_item = [&](std::size_t e) { return static_cast<std::uint32_t>(vertex_count() + e); };
    const auto face_item = [&](std::size_t f) { return static_cast<std::uint32_t>(vertex_count() + edge_count() + f); };
    std::vector<std::uint32_t> items;
    const auto note = [&](std::uint32_t item) {
      if (place_[item] != none) return;
      place_[item] = static_cast<std::uint32_t>(items.size());
      items.push_back(item);
    };
    for (const auto& v : operand.vertices) note(v.index);
    for (const auto& e : operand.edges) note(edge_item(e.index));
    for (const auto& f : operand.faces) note(face_item(f.index));
    UnionFind sets(items.size());
    std::vector<bool> bounds(items.size(), false);  // something of the operand
    const auto unite = [&](std::uint32_t low, std::uint32_t high) {
      sets.unite(place_[low], place_[high]);
      bounds[place_[low]] = true;
    };
    for (const auto& e : operand.edges) {
      const EdgeId edge(e.index);
      unite(k.start(edge).value, edge_item(e.index));
      unite(k.end(edge).value, edge_item(e.index));
    }
    for (const auto& f : operand.faces) {
      for (const LoopId l : k.loops(FaceId(f.index))) {
        if (k.is_vertex_loop(l)) {
          unite(k.loop_vertex(l).value, face_item(f.index));
        } else {
          for (const CoedgeId c : k.coedges(l)) unite(edge_item(k.edge(c).index()), face_item(f.index));
        }
      }
    }
    std::vector<std::vector<std::uint32_t>> parts(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (!bounds[i]) parts[sets.find(i)].push_back(items[i]);
    }
    for (std::vector<std::uint32_t>& part : parts) {
      std::sort(part.begin(), part.end());
      if (part.empty() || !known.insert(part).second) continue;
      TopoDS_Compound argument;
      BRep_Builder build;
      build.MakeCompound(argument);
      for (const std::uint32_t item : part) build.Add(argument, shape_of(item));
      arguments_.Append(argument);
    }
    for (const std::uint32_t item : items) place_[item] = none;
  }

  const TopoDS_Shape& shape_of(std::size_t item) const {
    if (item < vertex_count()) return shapes_->vertices[item];
    if (item < vertex_count() + edge_count()) return shapes_->edges[item - vertex_count()];
    return shapes_->faces[item - vertex_count() - edge_count()];
  }

  Status fuse() {
    if (arguments_.Extent() < 2) {
      if (arguments_.IsEmpty()) {
        BRep_Builder().MakeCompound(TopoDS::Compound(result_ = TopoDS_Compound()));
      } else {
        result_ = arguments_.First();
      }
      return {};
    }
    // The library turns its own exceptions into messages.
    filler_.SetArguments(arguments_);
    filler_.SetRunParallel(Standard_False);
    filler_.SetNonDestructive(Standard_True);
    filler_.SetUseOBB(Standard_True);
    if (tolerance_ > 0) filler_.SetFuzzyValue(tolerance_);
    {
      Handle(ContextIndicator) progress = new ContextIndicator(context_, "intersecting", 0, 0.6);
      filler_.Perform(progress->Start());
    }
    ARESTA_CHECK(require_clean(filler_));
    builder_.SetArguments(arguments_);
    builder_.SetRunParallel(Standard_False);
    builder_.SetNonDestructive(Standard_True);
    builder_.SetUseOBB(Standard_True);
    if (tolerance_ > 0) builder_.SetFuzzyValue(tolerance_);
    {
      Handle(ContextIndicator) progress = new ContextIndicator(context_, "splitting", 0.6, 0.8);
      builder_.PerformWithFiller(filler_, progress->Start());
    }
    ARESTA_CHECK(require_clean(builder_));
    fused_ = true;
    result_ = builder_.Shape();
    return {};
  }

  Status require_clean(const BOPAlgo_Options& step) {
    ARESTA_CHECK(context_.step(0.6, "intersecting"));
    const Handle(Message_Report)& report = step.GetReport();
    for (const Message_Gravity gravity : {Message_Fail, Message_Alarm, Message_Warning}) {
      const Message_ListOfAlert& alerts = report->GetAlerts(gravity);
      for (Message_ListOfAlert::Iterator it(alerts); it.More(); it.Next()) {
        const std::string name = it.Value()->DynamicType()->Name();
        const char* text = meaning(name);
        if (text == nullptr && gravity == Message_Warning) continue;
        Error error{errors::general_fuse_failed, text != nullptr ? text : "the geometry kernel reports " + name};
        error.hint = "another --tolerance";
        if (const auto with_shape = Handle(TopoDS_AlertWithShape)::DownCast(it.Value())) {
          name_entities(with_shape->GetShape(), error);
        }
        return error;
      }
    }
    return {};
  }

  void name_entities(const TopoDS_Shape& shape, Error& error) const {
    std::set<std::pair<std::uint32_t, EntityRef>> named;
    collect(shape, named);
    std::string list;
    for (const auto& [operand, entity] : named) {
      if (list.size() > 200) {
        list += ", ...";
        break;
      }
      list += (list.empty() ? ": " : ", ") + std::string(to_string(entity.kind)) + " " + std::to_string(entity.index) +
              " of operand " + std::to_string(operand + 1);
      error.entities.push_back(entity);
    }
    error.message += list;
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
    if (!vertices.IsEmpty()) {
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices(1)));
      error.place = {{p.X(), p.Y(), p.Z()}};
    }
  }

  /// The entities that a shape is, else those that it is made of.
  void collect(const TopoDS_Shape& shape, std::set<std::pair<std::uint32_t, EntityRef>>& named) const {
    const auto found = [&](const TopTools_IndexedMapOfShape& map, const auto& parents) {
      const int index = map.FindIndex(shape);
      if (index == 0) return false;
      for (const FuseParent& p : parents[static_cast<std::size_t>(index - 1)]) named.emplace(p.operand, p.entity);
      return true;
    };
    if (found(faces_, input_.faces) || found(edges_, input_.edges) || found(vertices_, input_.vertices)) return;
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) collect(it.Value(), named);
  }

  TopTools_ListOfShape images(const TopoDS_Shape& shape) {
    if (fused_) {
      // A vertex that was made one with another, and this with a third: the history stops at the second.
      const BOPDS_DS& data = *filler_.PDS();
      int last = -1;
      if (const int own = data.Index(shape); own >= 0 && data.HasShapeSD(own, last)) {
        TopTools_ListOfShape merged;
        merged.Append(data.Shape(last));
        return merged;
      }
      const TopTools_ListOfShape& modified = builder_.Modified(shape);
      if (!modified.IsEmpty()) return modified;
    }
    TopTools_ListOfShape same;
    same.Append(shape);
    return same;
  }

  struct Lists {
    std::vector<std::vector<FuseParent>> by_vertex, by_edge, by_face;
    void clear(const ShapeMaps& maps) {
      by_vertex.assign(static_cast<std::size_t>(maps.vertices.Extent()), {});
      by_edge.assign(static_cast<std::size_t>(maps.edges.Extent()), {});
      by_face.assign(static_cast<std::size_t>(maps.faces.Extent()), {});
    }
  };

  // Entity after entity of an operand, lowest dimension first: it contains its images and what bounds or lies in them;
  // what an entity of lower dimension contains keeps that one.
  Status find_parents() {
    out_.vertices.resize(static_cast<std::size_t>(maps_.vertices.Extent()));
    out_.edges.resize(static_cast<std::size_t>(maps_.edges.Extent()));
    out_.faces.resize(static_cast<std::size_t>(maps_.faces.Extent()));
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      ARESTA_CHECK(context_.step(0.92, "tracing origins"));
      Lists on_vertices, on_edges, on_faces;
      on_vertices.clear(maps_);
      on_edges.clear(maps_);
      on_faces.clear(maps_);
      for (const auto& v : operands_[i].vertices) {
        ARESTA_CHECK(claim(shapes_->vertices[v.index], v, on_vertices));
      }
      for (const auto& e : operands_[i].edges) ARESTA_CHECK(claim(shapes_->edges[e.index], e, on_edges));
      for (const auto& f : operands_[i].faces) ARESTA_CHECK(claim(shapes_->faces[f.index], f, on_faces));
      const auto keep = [](std::vector<FuseParent>& to, std::initializer_list<const std::vector<FuseParent>*> choices) {
        for (const auto* choice : choices) {
          if (choice->empty()) continue;
          std::vector<FuseParent> sorted = *choice;
          const auto dimension = [](const FuseParent& p) { return p.entity.kind; };
          const EntityKind least = std::ranges::min(sorted, {}, dimension).entity.kind;
          std::erase_if(sorted, [&](const FuseParent& p) { return p.entity.kind != least; });
          std::sort(sorted.begin(), sorted.end());
          sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
          to.insert(to.end(), sorted.begin(), sorted.end());
          return;
        }
      };
      for (std::size_t v = 0; v < out_.vertices.size(); ++v) {
        keep(out_.vertices[v], {&on_vertices.by_vertex[v], &on_edges.by_vertex[v], &on_faces.by_vertex[v]});
      }
      for (std::size_t e = 0; e < out_.edges.size(); ++e) {
        keep(out_.edges[e], {&on_edges.by_edge[e], &on_faces.by_edge[e]});
      }
      for (std::size_t f = 0; f < out_.faces.size(); ++f) keep(out_.faces[f], {&on_faces.by_face[f]});
    }
    return require_parents();
  }

  Status claim(const TopoDS_Shape& shape, const Operand::Member& member, Lists& lists) {
    const FuseParent& parent = member.parent;
    bool found = false;
    for (const TopoDS_Shape& image : images(shape)) {
      TopTools_IndexedMapOfShape parts;
      TopExp::MapShapes(image, parts);
      for (int p = 1; p <= parts.Extent(); ++p) {
        if (const int v = maps_.vertices.FindIndex(parts(p)); v > 0) {
          lists.by_vertex[static_cast<std::size_t>(v - 1)].push_back(parent);
          found = found || shape.ShapeType() == TopAbs_VERTEX;
        } else if (const int e = maps_.edges.FindIndex(parts(p)); e > 0) {
          lists.by_edge[static_cast<std::size_t>(e - 1)].push_back(parent);
          found = found || shape.ShapeType() == TopAbs_EDGE;
        } else if (const int f = maps_.faces.FindIndex(parts(p)); f > 0) {
          FuseParent of_face = parent;
          ARESTA_TRY(const bool opposite, is_opposite(TopoDS::Face(maps_.faces(f)), member));
          of_face.opposite = opposite != parent.opposite;
          lists.by_face[static_cast<std::size_t>(f - 1)].push_back(of_face);
          found = true;
        }
      }
    }
    if (!found) {
      return Error{errors::general_fuse_failed,
                   std::string("an entity is lost: ") + to_string(parent.entity.kind) + " " +
                       std::to_string(parent.entity.index) + " of operand " + std::to_string(parent.operand + 1),
                   {parent.entity},
                   {},
                   "a smaller --tolerance"};
    }
    return {};
  }

  /// Of a piece and the input's face that it came from.
  Result<bool> is_opposite(const TopoDS_Face& piece, const Operand::Member& member) {
    const EntityRef entity = member.parent.entity;
    const TopoDS_Face& source = shapes_->faces[member.index];
    TopLoc_Location here, there;
    if (BRep_Tool::Surface(piece, here) == BRep_Tool::Surface(source, there)) {
      return (piece.Orientation() == TopAbs_REVERSED) != (source.Orientation() == TopAbs_REVERSED);
    }
    gp_Pnt p;
    gp_Pnt2d uv;
    if (BOPTools_AlgoTools3D::PointInFace(piece, p, uv, tools_) != 0) {
      return Error{errors::general_fuse_failed, "a piece of a face is thinner than the tolerance", {entity}};
    }
    gp_Dir normal;
    if (!BOPTools_AlgoTools3D::GetNormalToSurface(BRep_Tool::Surface(piece), uv.X(), uv.Y(), normal)) {
      return Error{errors::general_fuse_failed, "a piece of a face has no normal", {entity}, {{p.X(), p.Y(), p.Z()}}};
    }
    if (piece.Orientation() == TopAbs_REVERSED) normal.Reverse();
    const FaceId f(member.index);
    const Vec3 other = model_->normal(f, model_->surface(f).project({p.X(), p.Y(), p.Z()}).uv);
    return dot(other, {normal.X(), normal.Y(), normal.Z()}) < 0;
  }

  Status require_parents() const {
    const auto check = [](const auto& lists, EntityKind kind) -> Status {
      for (std::size_t i = 0; i < lists.size(); ++i) {
        if (lists[i].empty()) {
          return Error{errors::general_fuse_failed,
                       "an entity of the result lies in no operand",
                       {EntityRef(kind, static_cast<std::uint32_t>(i))}};
        }
      }
      return {};
    };
    ARESTA_CHECK(check(out_.vertices, EntityKind::vertex));
    ARESTA_CHECK(check(out_.edges, EntityKind::edge));
    return check(out_.faces, EntityKind::face);
  }

  const FuseInput& input_;
  double tolerance_;
  const Context& context_;
  std::shared_ptr<const Model> model_;  // the input's, its seams seated
  std::shared_ptr<const ModelShape::Data> shapes_;
  TopTools_IndexedMapOfShape vertices_, edges_, faces_;
  std::vector<Operand> operands_;
  std::vector<std::uint32_t> place_;  // of the operand being added: where an item stands among its items
  TopTools_ListOfShape arguments_;
  BOPAlgo_PaveFiller filler_;
  BOPAlgo_Builder builder_;
  bool fused_ = false;
  TopoDS_Shape result_;
  ShapeMaps maps_;
  FuseResult out_;
  Handle(IntTools_Context) tools_ = new IntTools_Context;
};

}  // namespace

Result<FuseInput> side_by_side(std::span<const std::shared_ptr<const Model>> operands) {
  FuseInput input;
  input.operands = operands.size();
  ModelBuilder all;
  for (std::uint32_t o = 0; o < operands.size(); ++o) {
    append(all, *operands[o]);
    const Complex& k = operands[o]->topology();
    for (const VertexId v : k.vertices()) input.vertices.push_back({{o, v}});
    for (const EdgeId e : k.edges()) input.edges.push_back({{o, e}});
    for (const FaceId f : k.faces()) input.faces.push_back({{o, f}});
  }
  ARESTA_TRY(Model model, all.provisional());
  input.model = std::make_shared<const Model>(std::move(model));
  return input;
}

Result<FuseResult> general_fuse(const FuseInput& input, double tolerance, const Context& context) {
  return guarded(errors::general_fuse_failed, "fusing models",
                 [&]() -> Result<FuseResult> { return GeneralFuse(input, tolerance, context).run(); });
}

}  // namespace aresta
