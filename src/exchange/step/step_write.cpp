// SPDX-License-Identifier: Apache-2.0
#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>

#include "exchange/errors.h"
#include "exchange/step/step_module.h"
#include "exchange/step/units.h"
#include "occt/guard.h"
#include "occt/shape_data.h"

namespace aresta {

namespace {

class StepMaker {
 public:
  explicit StepMaker(double length_unit) : document_(new TDocStd_Document("XmlXCAF")) {
    XCAFDoc_DocumentTool::Set(document_->Main(), Standard_False);
    XCAFDoc_DocumentTool::SetLengthUnit(document_, length_unit);
    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
    layers_ = XCAFDoc_DocumentTool::LayerTool(document_->Main());
    XCAFDoc_ShapeTool::SetAutoNaming(Standard_False);
  }

  void add_part(const LabelledShape& part) {
    const TDF_Label label = shapes_->AddShape(part.shape.data().shape, Standard_False);
    parts_.push_back(label);
    mark(label, part);
  }

  void add_subshape(const LabelledShape& subshape) {
    for (const TDF_Label& part : parts_) {
      TDF_Label label;
      if (!shapes_->IsSubShape(part, subshape.shape.data().shape)) continue;
      shapes_->AddSubShape(part, subshape.shape.data().shape, label);
      if (!label.IsNull()) mark(label, subshape);
    }
  }

  const Handle(TDocStd_Document) & document() const { return document_; }

 private:
  void mark(const TDF_Label& label, const LabelledShape& with) {
    if (!with.name.empty()) {
      TDataStd_Name::Set(label, TCollection_ExtendedString(with.name.c_str(), Standard_True));
    }
    if (!with.layer.empty()) {
      layers_->SetLayer(label, TCollection_ExtendedString(with.layer.c_str(), Standard_True));
    }
  }

  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_LayerTool) layers_;
  std::vector<TDF_Label> parts_;
};

/// One set of styles per part: its own colour, then those of its faces, edges and vertices.
void add_colors(const Handle(XSControl_WorkSession) & session, const StepParts& parts) {
  STEPConstruct_Styles styles(session);
  const Handle(Transfer_FinderProcess) finder = session->TransferWriter()->FinderProcess();
  const auto add = [&](const LabelledShape& with) {
    Quantity_Color color;
    const TopoDS_Shape& shape = with.shape.data().shape;
    const Handle(StepRepr_RepresentationItem) item = STEPConstruct::FindEntity(finder, shape);
    if (item.IsNull() || with.color.empty() || !Quantity_Color::ColorFromHex(with.color.c_str(), color)) return;
    const Handle(StepVisual_Colour) encoded = STEPConstruct_Styles::EncodeColor(color);
    styles.AddStyle(item, styles.MakeColorPSA(item, encoded, encoded, nullptr, 0), nullptr);
  };
  for (const LabelledShape& part : parts.parts) {
    styles.ClearStyles();
    add(part);
    TopTools_IndexedMapOfShape inside;
    TopExp::MapShapes(part.shape.data().shape, inside);
    for (const LabelledShape& subshape : parts.subshapes) {
      if (!subshape.shape.data().shape.IsSame(part.shape.data().shape) &&
          inside.Contains(subshape.shape.data().shape)) {
        add(subshape);
      }
    }
    if (styles.NbStyles() == 0) continue;
    Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) drawn;
    if (styles.CreateMDGPR(styles.FindContext(part.shape.data().shape), drawn)) session->Model()->AddWithRefs(drawn);
  }
}

Result<std::string> write(const StepParts& parts, const Context& context) {
  ARESTA_CHECK(context.step(0, "writing STEP"));
  const char* unit = unit_name(parts.length_unit);
  if (unit == nullptr) return Error{errors::export_failed, "STEP files cannot be written in this unit of length"};
  STEPControl_Controller::Init();  // parameters exist after this, and count when set before the writer is made
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("xstep.cascade.unit", unit);
  Interface_Static::SetCVal("write.step.unit", unit);
  Interface_Static::SetIVal("write.step.assembly", 0);
  Interface_Static::SetIVal("write.step.nonmanifold", 0);
  Interface_Static::SetIVal("write.surfacecurve.mode", 1);
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  STEPCAFControl_Writer writer;
  writer.SetColorMode(Standard_False);  // the library would write colours in the order of addresses
  writer.SetNameMode(Standard_True);
  writer.SetLayerMode(Standard_True);
  StepMaker maker(parts.length_unit);
  for (const LabelledShape& part : parts.parts) maker.add_part(part);
  for (const LabelledShape& subshape : parts.subshapes) maker.add_subshape(subshape);
  Handle(ContextIndicator) progress = new ContextIndicator(context, "writing STEP", 0, 0.8);
  const bool done = writer.Transfer(maker.document(), STEPControl_AsIs, nullptr, progress->Start());
  ARESTA_CHECK(context.step(0.8, "writing STEP"));
  if (!done) return Error{errors::export_failed, "the shapes cannot be translated to STEP"};

  add_colors(writer.ChangeWriter().WS(), parts);

  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model(Standard_False);
  APIHeaderSection_MakeHeader header(model);
  header.SetName(new TCollection_HAsciiString(parts.title.c_str()));
  header.SetTimeStamp(new TCollection_HAsciiString("2000-01-01T00:00:00"));  // the same model gives the same file
  header.SetAuthorValue(1, new TCollection_HAsciiString(""));
  header.SetOrganizationValue(1, new TCollection_HAsciiString(""));
  header.SetPreprocessorVersion(new TCollection_HAsciiString("Aresta"));
  header.SetOriginatingSystem(new TCollection_HAsciiString("Aresta"));
  header.SetDescriptionValue(1, new TCollection_HAsciiString(parts.description.c_str()));
  header.Apply(model);

  StepData_StepWriter text(model);
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.ChangeWriter().WS()->Protocol()));
  std::ostringstream stream;
  if (!text.Print(stream)) return Error{errors::export_failed, "the STEP file cannot be composed"};
  return std::move(stream).str();
}

}  // namespace

}  // namespace aresta

extern "C" void aresta_step_write(const aresta::StepParts& parts, const aresta::Context& context,
                                  aresta::Result<std::string>* text) {
  *text = aresta::guarded(aresta::errors::export_failed, "the STEP file cannot be written",
                          [&] { return aresta::write(parts, context); });
}
