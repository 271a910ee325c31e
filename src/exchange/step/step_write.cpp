// SPDX-License-Identifier: Apache-2.0
#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
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
  StepMaker() : document_(new TDocStd_Document("XmlXCAF")) {
    XCAFDoc_DocumentTool::Set(document_->Main(), Standard_False);
    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
    colors_ = XCAFDoc_DocumentTool::ColorTool(document_->Main());
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
    Quantity_Color color;
    if (!with.color.empty() && Quantity_Color::ColorFromHex(with.color.c_str(), color)) {
      colors_->SetColor(label, color, XCAFDoc_ColorSurf);
    }
    if (!with.layer.empty()) {
      layers_->SetLayer(label, TCollection_ExtendedString(with.layer.c_str(), Standard_True));
    }
  }

  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  Handle(XCAFDoc_LayerTool) layers_;
  std::vector<TDF_Label> parts_;
};

Result<std::string> write(const StepParts& parts, const Context& context) {
  ARESTA_CHECK(context.step(0, "writing STEP"));
  const char* unit = unit_name(parts.length_unit);
  if (unit == nullptr) return Error{errors::export_failed, "STEP files cannot be written in this unit of length"};
  STEPCAFControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("xstep.cascade.unit", unit);
  Interface_Static::SetCVal("write.step.unit", unit);
  Interface_Static::SetIVal("write.step.assembly", 0);
  Interface_Static::SetIVal("write.step.nonmanifold", 0);
  Interface_Static::SetIVal("write.surfacecurve.mode", 1);
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  writer.SetColorMode(Standard_True);
  writer.SetNameMode(Standard_True);
  writer.SetLayerMode(Standard_True);
  StepMaker maker;
  for (const LabelledShape& part : parts.parts) maker.add_part(part);
  for (const LabelledShape& subshape : parts.subshapes) maker.add_subshape(subshape);
  Handle(ContextIndicator) progress = new ContextIndicator(context, "writing STEP", 0, 0.8);
  const bool done = writer.Transfer(maker.document(), STEPControl_AsIs, nullptr, progress->Start());
  ARESTA_CHECK(context.step(0.8, "writing STEP"));
  if (!done) return Error{errors::export_failed, "the shapes cannot be translated to STEP"};

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

extern "C" aresta::Result<std::string> aresta_step_write(const aresta::StepParts& parts,
                                                         const aresta::Context& context) {
  return aresta::guarded(aresta::errors::export_failed, "the STEP file cannot be written",
                         [&] { return aresta::write(parts, context); });
}
