// SPDX-License-Identifier: Apache-2.0
// STEP files hold solids one by one, each with faces of its own; what two solids share is written twice, and edges and
// points inside faces not at all. So a file of ours says in its header how many regions, faces, edges and vertices
// there were, writes inner edges and points beside the solids, and reading imprints the parts on each other when the
// counts show that something was shared; the counts then prove the result. Files of others are taken as they are.
#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <cstdio>

#include "base/module.h"
#include "base/union_find.h"
#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/shape_import.h"
#include "exchange/step/step_module.h"
#include "fragment/fragment.h"
#include "fragment/identity.h"
#include "model/inherit.h"
#include "occt/model_shape.h"
#include "occt/shape_data.h"

namespace aresta {

namespace {

struct Counts {
  std::size_t regions = 0, faces = 0, edges = 0, vertices = 0;
  bool operator==(const Counts&) const = default;
};

Counts counts_of(const Model& model) {
  const Complex& k = model.topology();
  return {model.regions().size(), k.face_count(), k.edge_count(), k.vertex_count()};
}

constexpr const char* counts_format = "aresta cells=%zu/%zu/%zu/%zu";

std::optional<Counts> recorded_counts(const std::string& data) {
  const std::size_t end = std::min(data.find("ENDSEC"), data.size());
  const std::size_t at = data.find("aresta cells=");
  Counts c;
  if (at >= end || std::sscanf(data.c_str() + at, counts_format, &c.regions, &c.faces, &c.edges, &c.vertices) != 4)
    return {};
  return c;
}

Status require_whole(const std::string& data) {
  const std::size_t head = data.find("ISO-10303-21");
  if (head > 4096) {  // npos as well
    return Error{errors::bad_content, "this is not a STEP file: it does not begin with ISO-10303-21"};
  }
  if (data.find("END-ISO-10303-21", head) == std::string::npos) {
    return Error{errors::bad_content, "the STEP file is cut off: its end mark is missing"};
  }
  return {};
}

/// All parts imprinted on each other, as they were when the file was written; nothing when that does not give the
/// recorded counts.
Result<std::optional<Model>> share(const StepContents& contents, const Counts& recorded, const ImportOptions& options,
                                   ImportReport& report, const Context& context) {
  std::vector<std::shared_ptr<const Model>> parts;
  TopoDS_Iterator in_whole(contents.whole.data().shape);
  for (; in_whole.More(); in_whole.Next()) {
    std::vector<LabelledShape> labelled;
    TopTools_IndexedMapOfShape inside;
    TopExp::MapShapes(in_whole.Value(), inside);
    for (const LabelledShape& entry : contents.labelled) {
      if (inside.Contains(entry.shape.data().shape)) labelled.push_back(entry);
    }
    ARESTA_TRY(Model part, import_shape(wrap(in_whole.Value()), labelled, options, report, context));
    parts.push_back(std::make_shared<const Model>(std::move(part)));
  }
  // What the parts share they mostly have as wholes; intersecting is asked for only where that is not all.
  for (const FragmentEngine* engine : {&identity_engine(), &occt_engine()}) {
    FragmentOptions plain;
    plain.engine = engine;
    plain.detect_regions = false;
    Result<Fragment> joined = fragment(parts, plain, context);
    if (!joined.ok()) {
      if (joined.error().code == errors::cancelled) return std::move(joined).error();
      continue;
    }
    if (counts_of(*joined->model) != recorded) continue;
    Model model = *joined->model;
    inherit_labels(model);
    model.provenance = nullptr;
    model.length_unit = options.length_unit;
    return std::optional<Model>(std::move(model));
  }
  return std::optional<Model>();
}

}  // namespace

Result<Model> read_step(const ReadArguments& in) {
  ARESTA_CHECK(require_whole(in.data));
  ARESTA_TRY(void* function, module_function("step", "aresta_step_read"));
  const auto read = reinterpret_cast<StepReadFunction>(function);
  const std::optional<Counts> recorded = recorded_counts(in.data);
  Result<StepContents> outcome = StepContents();
  read(in.data, recorded.has_value(), in.options.length_unit, in.context, &outcome);
  ARESTA_TRY(const StepContents contents, std::move(outcome));
  in.report.file_unit = contents.file_unit;
  in.report.notes.insert(in.report.notes.end(), contents.notes.begin(), contents.notes.end());
  const bool has_vertices = !contents.whole.null() && contents.whole.counts().vertices > 0;
  if (!has_vertices && in.data.find("TESSELLATED_") != std::string::npos) {
    return Error{errors::unsupported_content,
                 "the STEP file holds only triangles (tessellated geometry), no boundary representation",
                 {},
                 {},
                 "export it with exact geometry"};
  }
  if (!has_vertices) return Error{errors::nothing_to_import, "the STEP file holds no shape"};
  Result<Model> plain = import_shape(contents.whole, contents.labelled, in.options, in.report, in.context);
  if (!recorded || (plain.ok() && counts_of(*plain) == *recorded)) return plain;
  ARESTA_TRY(std::optional<Model> shared, share(contents, *recorded, in.options, in.report, in.context));
  if (shared) {
    in.report.notes.push_back(
        "faces, edges and vertices that parts share were joined again, as the file's header records");
    return std::move(*shared);
  }
  in.report.notes.push_back("the header records shared faces, but joining the parts does not give what it records");
  return plain;
}

namespace {

class PartMaker {
 public:
  explicit PartMaker(const Model& model, const ModelShape::Data& shapes)
      : model_(model), k_(model.topology()), shapes_(shapes) {}

  StepParts run() {
    const Counts c = counts_of(model_);
    char record[128];
    std::snprintf(record, sizeof record, counts_format, c.regions, c.faces, c.edges, c.vertices);
    out_.description = record;
    out_.length_unit = model_.length_unit;
    out_.title = "model";
    std::size_t number = 0;
    for (const RegionId r : model_.regions()) {
      ++number;
      add(shapes_.regions[r.index()], r, "region " + std::to_string(number));
    }
    add_sheets();
    add_wires();
    add_points();
    for (const FaceId f : k_.faces()) add_subshape(shapes_.faces[f.index()], f);
    return std::move(out_);
  }

 private:
  std::string text(EntityRef entity, const char* key) const {
    const auto found = model_.labels.attributes.find(entity);
    if (found == model_.labels.attributes.end()) return {};
    const auto value = found->second.find(key);
    if (value == found->second.end()) return {};
    const auto* string = std::get_if<std::string>(&value->second);
    return string != nullptr ? *string : std::string();
  }

  void add(const TopoDS_Shape& shape, EntityRef entity, const std::string& fallback) {
    LabelledShape part{wrap(shape), text(entity, "name"), text(entity, "color"), text(entity, "layer")};
    if (part.name.empty()) part.name = fallback;
    out_.parts.push_back(std::move(part));
  }

  void add_subshape(const TopoDS_Shape& shape, EntityRef entity) {
    LabelledShape part{wrap(shape), text(entity, "name"), text(entity, "color"), text(entity, "layer")};
    if (!part.name.empty() || !part.color.empty() || !part.layer.empty()) out_.subshapes.push_back(std::move(part));
  }

  bool bounds_a_region(FaceId f) const {
    const RegionId front = k_.region(FaceUse(f, 0)), back = k_.region(FaceUse(f, 1));
    return front != back && (model_.is_region(front) || model_.is_region(back));
  }

  void add_sheets() {
    UnionFind sets(k_.face_count());
    for (const EdgeId e : k_.edges()) {
      FaceId last;
      for (const CoedgeId c : k_.coedges(e)) {
        const FaceId f = k_.face(c);
        if (bounds_a_region(f)) continue;
        if (last.valid()) sets.unite(last.index(), f.index());
        last = f;
      }
    }
    std::vector<std::vector<FaceId>> sheets(k_.face_count());
    for (const FaceId f : k_.faces()) {
      if (!bounds_a_region(f)) sheets[sets.find(f.index())].push_back(f);
    }
    std::size_t number = 0;
    for (const auto& sheet : sheets) {
      if (sheet.empty()) continue;
      TopoDS_Shell shell;
      build_.MakeShell(shell);
      for (const FaceId f : sheet) build_.Add(shell, shapes_.faces[f.index()]);
      add(shell, sheet.front(), "sheet " + std::to_string(++number));
    }
  }

  /// Wires, and the edges inside faces, which the format cannot hold there.
  void add_wires() {
    std::size_t number = 0;
    for (const EdgeId e : k_.edges()) {
      bool inside = !k_.is_wire(e);
      for (const CoedgeId c : k_.coedges(e)) inside = inside && is_inner(c);
      if (k_.is_wire(e) || inside) add(apart(shapes_.edges[e.index()]), e, "wire " + std::to_string(++number));
    }
  }

  /// The library does not write again what it has met inside a face: a copy is something else.
  static TopoDS_Shape apart(const TopoDS_Shape& shape) { return BRepBuilderAPI_Copy(shape).Shape(); }

  bool is_inner(CoedgeId c) const {
    for (const CoedgeId other : k_.coedges(k_.edge(c))) {
      if (other == c || k_.face(other) != k_.face(c)) continue;
      const double t = model_.range(k_.edge(c)).middle();
      return distance(model_.uv(c, t), model_.uv(other, t)) < 1e-6;
    }
    return false;
  }

  void add_points() {
    std::size_t number = 0;
    for (const VertexId v : k_.vertices()) {
      if (!k_.has_no_edge(v)) continue;
      add(apart(shapes_.vertices[v.index()]), v, "point " + std::to_string(++number));
    }
  }

  const Model& model_;
  const Complex& k_;
  const ModelShape::Data& shapes_;
  BRep_Builder build_;
  StepParts out_;
};

}  // namespace

Result<std::string> write_step(const Model& model, const ExportOptions&, const Context& context) {
  ARESTA_TRY(const ModelShape shape, to_shape(model, {}, context));
  const StepParts parts = PartMaker(model, shape.data()).run();
  if (parts.parts.empty()) return Error{errors::export_failed, "the model is empty: there is nothing to write to STEP"};
  ARESTA_TRY(void* function, module_function("step", "aresta_step_write"));
  Result<std::string> text = std::string();
  reinterpret_cast<StepWriteFunction>(function)(parts, context, &text);
  return text;
}

}  // namespace aresta
