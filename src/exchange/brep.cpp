// SPDX-License-Identifier: Apache-2.0
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <iostream>
#include <locale>
#include <sstream>

#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/shape_import.h"
#include "exchange/text.h"
#include "occt/guard.h"
#include "occt/shape_data.h"
#include "occt/to_shape.h"

namespace aresta {

namespace {

/// The library's reader talks to std::cout when it stumbles.
class QuietOutput {
 public:
  QuietOutput() : old_(std::cout.rdbuf(sink_.rdbuf())) {}
  ~QuietOutput() { std::cout.rdbuf(old_); }
  QuietOutput(const QuietOutput&) = delete;
  QuietOutput& operator=(const QuietOutput&) = delete;

 private:
  std::ostringstream sink_;
  std::streambuf* old_;
};

/// Each of the shapes ends in a star, and the whole is named after the last one.
bool is_whole(const std::string& data) {
  const std::size_t at = data.find("\nTShapes ");
  if (at == std::string::npos) return false;
  std::string_view rest = std::string_view(data).substr(at + 1);
  take_word(rest);
  std::int64_t expected = 0, stars = 0;
  if (!to_number(take_word(rest), expected) || expected < 0) return false;
  int after = 0;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    if (word == "*") {
      ++stars;
      after = 0;
    } else {
      ++after;
    }
  }
  return stars == expected && after == 2;
}

}  // namespace

Result<Model> read_brep(const ReadArguments& in) {
  // The library takes many texts for shapes: at least the head must be right.
  if (in.data.find("CASCADE Topology V") == std::string::npos) {
    return Error{errors::bad_content, "this is not a BREP file: its head is missing"};
  }
  if (!is_whole(in.data)) return Error{errors::bad_content, "the BREP file is cut off or damaged"};
  return guarded(errors::bad_content, "the BREP file cannot be read", [&]() -> Result<Model> {
    std::istringstream stream(in.data);
    stream.imbue(std::locale::classic());
    stream.exceptions(std::ios::failbit | std::ios::badbit);  // else the reader goes round and round
    TopoDS_Shape shape;
    const QuietOutput quiet;
    Handle(ContextIndicator) progress = new ContextIndicator(in.context, "reading BREP");
    BRepTools::Read(shape, stream, BRep_Builder(), progress->Start());
    ARESTA_CHECK(in.context.step(0.5, "reading BREP"));
    if (shape.IsNull()) return Error{errors::bad_content, "the BREP file is damaged or cut off"};
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
      if (BRep_Tool::Surface(TopoDS::Face(it.Current())).IsNull()) {
        return Error{errors::bad_content, "the BREP file is damaged: a face has no surface"};
      }
    }
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
