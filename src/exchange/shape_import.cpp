// SPDX-License-Identifier: Apache-2.0
#include "exchange/shape_import.h"

#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <map>

#include "exchange/errors.h"
#include "occt/guard.h"
#include "occt/shape_data.h"

namespace aresta {

namespace {

void mark(Labels& labels, EntityRef entity, const LabelledShape& with, const std::string& name) {
  if (entity.index == Incidence::none) return;
  if (!name.empty()) labels.set_name(entity, name);
  if (!with.color.empty()) labels.attributes[entity]["color"] = with.color;
  if (!with.layer.empty()) labels.attributes[entity]["layer"] = with.layer;
}

/// Equal names get "#2", "#3", ...: a name should lead to one entity.
class Names {
 public:
  std::string take(const std::string& name) {
    if (name.empty()) return {};
    const int count = ++uses_[name];
    return count == 1 ? name : name + "#" + std::to_string(count);
  }

 private:
  std::map<std::string, int> uses_;
};

// A part's name goes to what it is made of: its solids, else its faces, else its edges, else its vertices.
void add_labels(ModelOfShape& read, const std::vector<LabelledShape>& labelled) {
  Names names;
  Labels& labels = read.model.labels;
  for (const LabelledShape& entry : labelled) {
    const TopoDS_Shape& shape = entry.shape.data().shape;
    const EntityRef own = read.entity_of(entry.shape);
    if (own.index != Incidence::none) {
      mark(labels, own, entry, names.take(entry.name));
      continue;
    }
    for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      TopTools_IndexedMapOfShape parts;
      TopExp::MapShapes(shape, kind, parts);
      if (parts.IsEmpty()) continue;
      for (int i = 1; i <= parts.Extent(); ++i)
        mark(labels, read.entity_of(wrap(parts(i))), entry, names.take(entry.name));
      break;
    }
  }
}

}  // namespace

Result<Model> import_shape(const OcctShape& shape, const std::vector<LabelledShape>& labelled,
                           const ImportOptions& options, ImportReport& report, const Context& context) {
  ToModelOptions conversion;
  conversion.length_unit = options.length_unit;
  Result<ModelOfShape> read = to_model(shape, conversion, context);
  if (read.ok()) {
    add_labels(*read, labelled);
    return std::move(read->model);
  }
  if (!options.repair || read.error().code == errors::cancelled) return std::move(read).error();
  const std::string reason = read.error().message;
  return guarded(errors::invalid_import, "repairing the imported shape", [&]() -> Result<Model> {
    Handle(ShapeFix_Shape) fix = new ShapeFix_Shape(shape.data().shape);
    Handle(ContextIndicator) progress = new ContextIndicator(context, "repairing the imported shape");
    fix->Perform(progress->Start());
    ARESTA_CHECK(context.step(1, "repairing the imported shape"));
    Result<ModelOfShape> mended = to_model(wrap(fix->Shape()), conversion, context);
    if (!mended.ok()) return std::move(read).error();
    std::vector<LabelledShape> moved = labelled;
    for (LabelledShape& entry : moved) entry.shape = wrap(fix->Context()->Apply(entry.shape.data().shape));
    std::erase_if(moved, [](const LabelledShape& entry) { return entry.shape.null(); });
    add_labels(*mended, moved);
    report.notes.push_back("the shape was repaired, because as it stands in the file " + reason);
    return std::move(mended->model);
  });
}

}  // namespace aresta
