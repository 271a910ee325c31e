// SPDX-License-Identifier: Apache-2.0
#include <BRep_Builder.hxx>
#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>

#include "exchange/errors.h"
#include "exchange/step/step_module.h"
#include "exchange/step/units.h"
#include "occt/guard.h"
#include "occt/shape_data.h"

namespace aresta {

namespace {

std::string to_text(const TCollection_ExtendedString& text) {
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter target = utf8.data();
  utf8.resize(static_cast<std::size_t>(text.ToUTF8CString(target)));
  return utf8;
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  return label.FindAttribute(TDataStd_Name::GetID(), name) ? to_text(name->Get()) : std::string();
}

class StepDocument {
 public:
  explicit StepDocument(const Handle(TDocStd_Document) & document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        layers_(XCAFDoc_DocumentTool::LayerTool(document->Main())) {}

  void collect(StepContents& contents) {
    BRep_Builder build;
    build.MakeCompound(whole_);
    TDF_LabelSequence free;
    shapes_->GetFreeShapes(free);
    for (const TDF_Label& label : free) add(label, TopLoc_Location(), "", "", true);
    contents.labelled = std::move(labelled_);
    if (!TopoDS_Iterator(whole_).More()) return;
    contents.whole = wrap(whole_);
  }

 private:
  std::string color_of(const TDF_Label& label) const {
    Quantity_Color color;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv}) {
      if (!colors_->GetColor(label, type, color)) continue;
      std::string hex = Quantity_Color::ColorToHex(color).ToCString();
      for (char& c : hex) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return hex;
    }
    return {};
  }

  std::string layer_of(const TDF_Label& label) const {
    Handle(TColStd_HSequenceOfExtendedString) names;
    return layers_->GetLayers(label, names) && !names.IsNull() && !names->IsEmpty() ? to_text(names->First()) : "";
  }

  // An instance's own name only tells it from its twins: the part's name counts.
  void add(const TDF_Label& label, const TopLoc_Location& place, const std::string& path, const std::string& color,
           bool is_root) {
    const TopLoc_Location here = place * (is_root ? TopLoc_Location() : XCAFDoc_ShapeTool::GetLocation(label));
    TDF_Label part = label;
    XCAFDoc_ShapeTool::GetReferredShape(label, part);
    std::string own_color = color_of(label);
    if (own_color.empty()) own_color = color_of(part);
    if (own_color.empty()) own_color = color;
    const std::string name = name_of(part);
    const std::string full = path.empty() ? name : name.empty() ? path : path + "/" + name;
    if (XCAFDoc_ShapeTool::IsAssembly(part)) {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(part, components);
      for (const TDF_Label& component : components) add(component, here, full, own_color, false);
      return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
    if (shape.IsNull()) return;
    const TopoDS_Shape placed = shape.Moved(here);
    BRep_Builder().Add(whole_, placed);
    labelled_.push_back({wrap(placed), full, own_color, layer_of(part)});
    TDF_LabelSequence inner;
    XCAFDoc_ShapeTool::GetSubShapes(part, inner);
    for (const TDF_Label& sub : inner) {
      const TopoDS_Shape piece = XCAFDoc_ShapeTool::GetShape(sub);
      if (piece.IsNull()) continue;
      LabelledShape entry{wrap(piece.Moved(here)), name_of(sub), color_of(sub), layer_of(sub)};
      if (!entry.name.empty() || !entry.color.empty() || !entry.layer.empty()) labelled_.push_back(std::move(entry));
    }
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  Handle(XCAFDoc_LayerTool) layers_;
  TopoDS_Compound whole_;
  std::vector<LabelledShape> labelled_;
};

std::string number_of(const Handle(Interface_InterfaceModel) & model, const Handle(Standard_Transient) & entity) {
  const Handle(StepData_StepModel) step = Handle(StepData_StepModel)::DownCast(model);
  return step.IsNull() ? std::to_string(model->Number(entity)) : std::to_string(step->IdentLabel(entity));
}

/// Does an image of an edge lead to a curve? The library asks no questions there.
bool has_curve(const StepGeom_Pcurve& image) {
  const Handle(StepRepr_DefinitionalRepresentation) held = image.ReferenceToCurve();
  if (held.IsNull() || held->Items().IsNull() || held->NbItems() < 1) return false;
  const Handle(StepRepr_RepresentationItem) first = held->ItemsValue(1);
  return !first.IsNull() && first->IsKind(STANDARD_TYPE(StepGeom_Curve));
}

/// Geometry or topology with missing or wrong references makes the library read through null handles.
Status require_sound(const Handle(Interface_InterfaceModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    if (entity.IsNull()) continue;
    const std::string type = entity->DynamicType()->Name();  // annotations and the like may be unknown to the library
    if (!type.starts_with("StepGeom_") && !entity->IsKind(STANDARD_TYPE(StepShape_TopologicalRepresentationItem)))
      continue;
    const Handle(StepGeom_Pcurve) image = Handle(StepGeom_Pcurve)::DownCast(entity);
    const bool is_blind = !image.IsNull() && !has_curve(*image);
    if (!is_blind && !model->IsErrorEntity(i) && !model->Check(i, Standard_True)->HasFailed()) continue;
    return Error{errors::bad_content, "the STEP file is damaged: entity #" + number_of(model, entity) + " (" +
                                          type.substr(type.find('_') + 1) + ") lacks something it refers to"};
  }
  return {};
}

/// A number beyond the range of double is infinite to the library, which then works on it without end.
Status require_finite_numbers(const std::string& data) {
  std::size_t line = 1;
  bool quoted = false;
  char before = ' ';
  for (std::size_t i = 0; i < data.size(); before = data[i++]) {
    const char c = data[i];
    line += c == '\n';
    if (c == '\'') quoted = !quoted;
    const bool starts = (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
    if (quoted || !starts || std::string_view("(,= \t\r\n").find(before) == std::string_view::npos) continue;
    const char* first = data.data() + i + (c == '+');
    double value = 0;
    const auto [end, error] = std::from_chars(first, data.data() + data.size(), value);
    if (error != std::errc::result_out_of_range) continue;
    const std::string_view number(first, static_cast<std::size_t>(end - first));
    if (number.find("E-") != std::string_view::npos || number.find("e-") != std::string_view::npos)
      continue;  // near zero
    return Error{errors::bad_content, "the STEP file is damaged: the number " + std::string(number.substr(0, 40)) +
                                          " in line " + std::to_string(line) + " is too large"};
  }
  return {};
}

Result<StepContents> read(const std::string& data, bool subshape_names, double length_unit, const Context& context) {
  const char* unit = unit_name(length_unit);
  if (unit == nullptr) return Error{errors::unsupported_content, "STEP files cannot be read into this unit of length"};
  STEPControl_Controller::Init();  // parameters exist after this, and count when set before the reader is made
  Interface_Static::SetCVal("xstep.cascade.unit", unit);
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", subshape_names ? 1 : 0);
  Interface_Static::SetIVal("read.step.nonmanifold", 1);
  STEPCAFControl_Reader reader;
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_True);
  std::istringstream stream(data);
  ARESTA_CHECK(context.step(0, "reading STEP"));
  ARESTA_CHECK(require_finite_numbers(data));
  if (reader.ChangeReader().ReadStream("file", stream) != IFSelect_RetDone) {
    return Error{errors::bad_content, "the STEP file cannot be parsed: it is damaged or not STEP at all"};
  }
  ARESTA_CHECK(require_sound(reader.ChangeReader().Model()));
  const int entities = reader.ChangeReader().NbRootsForTransfer();
  if (entities == 0) return StepContents{};
  StepContents contents;
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  std::set<std::string> names;
  for (const auto& name : lengths) names.insert(name.ToCString());
  for (const auto& name : names) contents.file_unit += (contents.file_unit.empty() ? "" : ", ") + name;
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  XCAFDoc_DocumentTool::Set(document->Main(), Standard_False);
  XCAFDoc_DocumentTool::SetLengthUnit(document, length_unit);
  Handle(ContextIndicator) progress = new ContextIndicator(context, "reading STEP", 0.1, 0.9);
  const bool done = reader.Transfer(document, progress->Start());
  ARESTA_CHECK(context.step(0.9, "reading STEP"));
  if (!done) return Error{errors::bad_content, "the shapes of the STEP file cannot be translated"};
  StepDocument(document).collect(contents);
  return contents;
}

}  // namespace

}  // namespace aresta

extern "C" void aresta_step_read(const std::string& data, bool subshape_names, double length_unit,
                                 const aresta::Context& context, aresta::Result<aresta::StepContents>* contents) {
  *contents = aresta::guarded(aresta::errors::bad_content, "the STEP file cannot be read",
                              [&] { return aresta::read(data, subshape_names, length_unit, context); });
}
