// SPDX-License-Identifier: Apache-2.0
#include "occt/general_fuse.h"

#include <BOPAlgo_Alerts.hxx>
#include <BOPAlgo_Builder.hxx>
#include <BOPAlgo_PaveFiller.hxx>
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
#include "occt/errors.h"
#include "occt/fuse_checks.h"
#include "occt/guard.h"
#include "occt/model_shape.h"
#include "occt/shape_reader.h"

namespace aresta {

namespace {

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

struct Operand {
  std::shared_ptr<const ModelShape::Data> shapes;
  TopTools_IndexedMapOfShape vertices, edges, faces;
};

class GeneralFuse {
 public:
  GeneralFuse(std::span<const std::shared_ptr<const Model>> models, double tolerance, const Context& context)
      : models_(models), tolerance_(tolerance), context_(context) {}

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
    operands_.resize(models_.size());
    for (std::size_t i = 0; i < models_.size(); ++i) {
      ARESTA_TRY(const ModelShape shape, to_shape(*models_[i], options, context_));
      Operand& operand = operands_[i];
      operand.shapes = std::shared_ptr<const ModelShape::Data>(std::make_shared<ModelShape::Data>(shape.data()));
      for (const auto& v : operand.shapes->vertices) operand.vertices.Add(v);
      for (const auto& e : operand.shapes->edges) operand.edges.Add(e);
      for (const auto& f : operand.shapes->faces) operand.faces.Add(f);
      add_arguments(*models_[i], *operand.shapes);
    }
    return {};
  }

  // The connected parts of an operand, in the order of their first members: vertices, then edges, then faces.
  void add_arguments(const Model& model, const ModelShape::Data& shapes) {
    const Complex& k = model.topology();
    const std::size_t edges = k.vertex_count(), faces = edges + k.edge_count();
    UnionFind sets(faces + k.face_count());
    for (const EdgeId e : k.edges()) {
      sets.unite(k.start(e).index(), edges + e.index());
      sets.unite(k.end(e).index(), edges + e.index());
    }
    for (const LoopId l : k.loops()) {
      const std::size_t face = faces + k.face(l).index();
      if (k.is_vertex_loop(l)) {
        sets.unite(k.loop_vertex(l).index(), face);
      } else {
        sets.unite(edges + k.edge(k.first_coedge(l)).index(), face);
      }
    }
    std::vector<TopoDS_Compound> parts(sets.size());
    BRep_Builder build;
    const auto add = [&](std::size_t item, const TopoDS_Shape& shape) {
      TopoDS_Compound& part = parts[sets.find(item)];
      if (part.IsNull()) build.MakeCompound(part);
      build.Add(part, shape);
    };
    for (const FaceId f : k.faces()) add(faces + f.index(), shapes.faces[f.index()]);
    for (const EdgeId e : k.edges()) {
      if (k.is_wire(e)) add(edges + e.index(), shapes.edges[e.index()]);
    }
    for (const VertexId v : k.vertices()) {
      if (k.isolated_in_shell(v).valid()) add(v.index(), shapes.vertices[v.index()]);
    }
    for (const TopoDS_Compound& part : parts) {
      if (!part.IsNull()) arguments_.Append(part);
    }
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
  bool collect(const TopoDS_Shape& shape, std::set<std::pair<std::uint32_t, EntityRef>>& named) const {
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      const Operand& o = operands_[i];
      const auto try_map = [&](const TopTools_IndexedMapOfShape& map, EntityKind kind) {
        const int index = map.FindIndex(shape);
        if (index > 0)
          named.emplace(static_cast<std::uint32_t>(i), EntityRef(kind, static_cast<std::uint32_t>(index - 1)));
        return index > 0;
      };
      if (try_map(o.faces, EntityKind::face) || try_map(o.edges, EntityKind::edge) ||
          try_map(o.vertices, EntityKind::vertex)) {
        return true;
      }
    }
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) collect(it.Value(), named);
    return false;
  }

  TopTools_ListOfShape images(const TopoDS_Shape& shape) {
    if (fused_) {
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
      const Operand& o = operands_[i];
      const auto index = static_cast<std::uint32_t>(i);
      for (int v = 1; v <= o.vertices.Extent(); ++v) {
        ARESTA_CHECK(claim(o.vertices(v), {index, VertexId(static_cast<std::size_t>(v - 1))}, on_vertices));
      }
      for (int e = 1; e <= o.edges.Extent(); ++e) {
        ARESTA_CHECK(claim(o.edges(e), {index, EdgeId(static_cast<std::size_t>(e - 1))}, on_edges));
      }
      for (int f = 1; f <= o.faces.Extent(); ++f) {
        ARESTA_CHECK(claim(o.faces(f), {index, FaceId(static_cast<std::size_t>(f - 1))}, on_faces));
      }
      const auto keep = [](std::vector<FuseParent>& to, std::initializer_list<const std::vector<FuseParent>*> choices) {
        for (const auto* choice : choices) {
          if (choice->empty()) continue;
          std::vector<FuseParent> sorted = *choice;
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

  Status claim(const TopoDS_Shape& shape, FuseParent parent, Lists& lists) {
    bool found = false;
    for (const TopoDS_Shape& image : images(shape)) {
      TopTools_IndexedMapOfShape parts;
      TopExp::MapShapes(image, parts);
      for (int p = 1; p <= parts.Extent(); ++p) {
        if (const int v = maps_.vertices.FindIndex(parts(p)); v > 0) {
          lists.by_vertex[static_cast<std::size_t>(v - 1)].push_back(parent);
          found = found || parent.entity.kind == EntityKind::vertex;
        } else if (const int e = maps_.edges.FindIndex(parts(p)); e > 0) {
          lists.by_edge[static_cast<std::size_t>(e - 1)].push_back(parent);
          found = found || parent.entity.kind == EntityKind::edge;
        } else if (const int f = maps_.faces.FindIndex(parts(p)); f > 0) {
          FuseParent of_face = parent;
          ARESTA_TRY(of_face.opposite, is_opposite(TopoDS::Face(maps_.faces(f)), parent));
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

  Result<bool> is_opposite(const TopoDS_Face& piece, const FuseParent& parent) {
    const TopoDS_Face source = TopoDS::Face(operands_[parent.operand].faces(static_cast<int>(parent.entity.index) + 1));
    TopLoc_Location here, there;
    if (BRep_Tool::Surface(piece, here) == BRep_Tool::Surface(source, there)) {
      return (piece.Orientation() == TopAbs_REVERSED) != (source.Orientation() == TopAbs_REVERSED);
    }
    gp_Pnt p;
    gp_Pnt2d uv;
    if (BOPTools_AlgoTools3D::PointInFace(piece, p, uv, tools_) != 0) {
      return Error{errors::general_fuse_failed, "a piece of a face is thinner than the tolerance", {parent.entity}};
    }
    gp_Dir normal;
    if (!BOPTools_AlgoTools3D::GetNormalToSurface(BRep_Tool::Surface(piece), uv.X(), uv.Y(), normal)) {
      return Error{
          errors::general_fuse_failed, "a piece of a face has no normal", {parent.entity}, {{p.X(), p.Y(), p.Z()}}};
    }
    if (piece.Orientation() == TopAbs_REVERSED) normal.Reverse();
    const Model& model = *models_[parent.operand];
    const FaceId f(parent.entity.index);
    const Vec3 other = model.normal(f, model.surface(f).project({p.X(), p.Y(), p.Z()}).uv);
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

  std::span<const std::shared_ptr<const Model>> models_;
  double tolerance_;
  const Context& context_;
  std::vector<Operand> operands_;
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

Result<FuseResult> general_fuse(std::span<const std::shared_ptr<const Model>> operands, double tolerance,
                                const Context& context) {
  return guarded(errors::general_fuse_failed, "fusing models",
                 [&]() -> Result<FuseResult> { return GeneralFuse(operands, tolerance, context).run(); });
}

}  // namespace aresta
