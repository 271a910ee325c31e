// SPDX-License-Identifier: Apache-2.0
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <locale>
#include <sstream>

#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/shape_import.h"
#include "occt/guard.h"
#include "occt/shape_data.h"
#include "occt/to_shape.h"

namespace aresta {

Result<Model> read_brep(const ReadArguments& in) {
  // The library takes many texts for shapes: at least the head must be right.
  if (in.data.find("CASCADE Topology V") == std::string::npos) {
    return Error{errors::bad_content, "this is not a BREP file: its head is missing"};
  }
  return guarded(errors::bad_content, "the BREP file cannot be read", [&]() -> Result<Model> {
    std::istringstream stream(in.data);
    stream.imbue(std::locale::classic());
    TopoDS_Shape shape;
    Handle(ContextIndicator) progress = new ContextIndicator(in.context, "reading BREP");
    BRepTools::Read(shape, stream, BRep_Builder(), progress->Start());
    ARESTA_CHECK(in.context.step(0.5, "reading BREP"));
    if (shape.IsNull()) return Error{errors::bad_content, "the BREP file is damaged or cut off"};
    return import_shape(wrap(shape), {}, in.options, in.report, in.context);
  });
}

Result<std::string> write_brep(const Model& model, const ExportOptions&, const Context& context) {
  ToShapeOptions conversion;
  conversion.internal_faces_in_solids = false;
  ARESTA_TRY(const ModelShape shape, to_shape(model, conversion, context));
  return guarded(errors::export_failed, "the BREP file cannot be written", [&]() -> Result<std::string> {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    Handle(ContextIndicator) progress = new ContextIndicator(context, "writing BREP");
    BRepTools::Write(shape.whole().data().shape, stream, Standard_False, Standard_False,
                     TopTools_FormatVersion_VERSION_1, progress->Start());
    ARESTA_CHECK(context.step(1, "writing BREP"));
    if (!stream) return Error{errors::export_failed, "the BREP file cannot be composed"};
    return std::move(stream).str();
  });
}

}  // namespace aresta
