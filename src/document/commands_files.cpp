// SPDX-License-Identifier: Apache-2.0
// Files, meshes and pictures.
#include <algorithm>

#include "document/commands.h"
#include "document/errors.h"
#include "document/mesh_shape.h"
#include "document/shape.h"
#include "draw/html.h"
#include "draw/png.h"
#include "draw/svg.h"
#include "exchange/exchange.h"
#include "exchange/mesh_formats.h"
#include "mesh/mesh_model.h"
#include "mesh/quality.h"
#include "view/model_scene.h"

namespace aresta::document {

namespace {

const Parameter path{.name = "path", .type = Type::string};
const Parameter file_format{.name = "format",
                            .type = Type::string,
                            .doc = "in place of what the path's ending says",
                            .default_value = "",
                            .keyword_only = true};

/// "png" of "a/b.PNG"; empty when there is none.
std::string ending(const std::string& file) {
  const std::size_t slash = file.rfind('/'), dot = file.rfind('.');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
  std::string text = file.substr(dot + 1);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool is_mesh_format(const std::string& f) {
  return f == "msh" || f == "vtu" || f == "inp";
}
bool is_picture_format(const std::string& f) {
  return f == "png" || f == "svg" || f == "html";
}

std::string format_of_call(Call& call) {
  const std::string& given = call.string("format");
  return given.empty() ? ending(call.string("path")) : given;
}

Result<Value> import_shape(Call& call) {
  ImportOptions options;
  options.format = call.string("format");
  options.check = call.boolean("check");
  options.join = call.boolean("join");
  ARESTA_TRY(Model model, import_file(call.string("path"), options, call.context()));
  return Value(whole_shape(std::move(model)));
}

Status export_mesh(const Mesh& mesh, const std::string& file, const std::string& format) {
  if (format == "msh") return write_msh(mesh, file);
  if (format == "msh2") return write_msh(mesh, file, MshVersion::v22);
  if (format == "vtu") return write_vtu(mesh, file);
  if (format == "inp") return write_inp(mesh, file, {.shells = mesh.element_count(3) == 0});
  return Error{.code = errors::command_range,
               .message = "export: a mesh can be written as msh, vtu or inp, not as '" + format + "'",
               .hint = "a path that ends in .vtu, or format=\"msh2\" for MSH 2.2"};
}

Result<Value> export_shape(Call& call) {
  const std::string& file = call.string("path");
  const std::string format = format_of_call(call);
  if (const auto* m = dynamic_cast<const MeshShape*>(call.shape("x").get())) {
    ARESTA_CHECK(export_mesh(m->mesh(), file, format));
    return Value();
  }
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  if (is_mesh_format(format) || format == "msh2") {
    return Error{.code = errors::command_type,
                 .message = "export: '" + format + "' is a format of meshes, and this is <" + x->describe() + ">",
                 .hint = "export(mesh(x, size=1), \"" + file + "\")"};
  }
  if (is_picture_format(format)) {
    return Error{.code = errors::command_type,
                 .message = "export: '" + format + "' is a picture",
                 .hint = "render(x, \"" + file + "\")"};
  }
  ARESTA_TRY(const std::shared_ptr<Model> model, as_model(*x, call.context()));
  ExportOptions options;
  options.format = call.string("format");
  options.deflection = call.number("deflection");
  ARESTA_CHECK(export_file(*model, file, options, call.context()));
  return Value();
}

Result<Value> make_mesh(Call& call) {
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  ARESTA_TRY(const std::shared_ptr<Model> model, as_model(*x, call.context()));
  MeshOptions options;
  options.size = call.number("size");
  options.order = static_cast<int>(call.integer("order"));
  options.angle = call.number("angle");
  options.grading = call.number("grading");
  options.dimension = static_cast<int>(call.integer("dimension"));
  ARESTA_TRY(Mesh mesh, mesh_model(*model, options, call.context()));
  return Value(ShapePtr(std::make_shared<const MeshShape>(std::move(mesh))));
}

Result<Value> mesh_quality(Call& call) {
  const auto* m = dynamic_cast<const MeshShape*>(call.shape("m").get());
  if (m == nullptr)
    return Error{errors::command_type, "quality: m must be a mesh, not <" + call.shape("m")->describe() + ">"};
  const QualityReport report = quality_report(m->mesh(), m->mesh().element_count(3) > 0 ? 3 : 2);
  const auto pair = [](const char* name, Value v) { return Value::tuple({Value(name), std::move(v)}); };
  return Value::list({pair("elements", Value(static_cast<std::int64_t>(report.elements))),
                      pair("inverted", Value(static_cast<std::int64_t>(report.inverted))),
                      pair("smallest angle", Value(report.worst.smallest_angle)),
                      pair("mean smallest angle", Value(report.mean_smallest_angle)),
                      pair("largest angle", Value(report.worst.largest_angle)),
                      pair("worst aspect ratio", Value(report.worst.aspect_ratio)),
                      pair("worst scaled Jacobian", Value(report.worst.scaled_jacobian))});
}

Result<Value> render_shape(Call& call) {
  const std::string& file = call.string("path");
  const std::string format = format_of_call(call);
  if (!is_picture_format(format)) {
    if (format.empty()) {
      return Error{.code = errors::command_range,
                   .message = "render: the path '" + file + "' has no ending that tells the format",
                   .hint = "a path that ends in .png, .svg or .html, or format=\"png\""};
    }
    return Error{errors::command_range, "render: a picture is written as png, svg or html, not as '" + format + "'"};
  }
  ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
  ARESTA_TRY(const std::shared_ptr<Model> model, as_model(*x, call.context()));
  ARESTA_TRY(const draw::StandardView view, draw::standard_view(call.string("view")));
  draw::ViewOptions options;
  options.view = view;
  options.projection = call.boolean("perspective") ? draw::Projection::perspective : draw::Projection::parallel;
  options.width = static_cast<int>(call.integer("width"));
  options.height = static_cast<int>(call.integer("height"));
  options.explode = call.number("explode");
  // Curves are off by a quarter of a pixel at most.
  const double deflection = 0.25 * model->bounds().diagonal() / std::max(options.width, options.height);
  ARESTA_TRY(const draw::Scene scene,
             make_scene(*model, {.title = call.string("title"), .deflection = deflection}, call.context()));
  const draw::Coloring coloring = call.string("coloring") == "faces" ? draw::Coloring::faces : draw::Coloring::regions;
  if (format == "svg") {
    ARESTA_CHECK(
        draw::write_svg(scene, {.view = options, .hidden_lines = call.boolean("hidden_lines")}, file, call.context()));
  } else if (format == "html") {
    ARESTA_CHECK(draw::write_html(
        scene, {.view = view, .projection = options.projection, .explode = options.explode, .coloring = coloring}, file,
        call.context()));
  } else {
    ARESTA_CHECK(draw::render_png(scene, {.view = options, .coloring = coloring, .opacity = call.number("opacity")},
                                  file, call.context()));
  }
  return Value();
}

}  // namespace

std::string MeshShape::describe() const {
  const auto counted = [](std::size_t n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  return "mesh of " + counted(mesh_.nodes.size(), "node") + ", " + counted(element_count(), "element");
}

std::size_t MeshShape::element_count() const {
  for (int dimension = 3; dimension > 0; --dimension) {
    if (const std::size_t n = mesh_.element_count(dimension); n > 0) return n;
  }
  return mesh_.element_count(0);
}

void register_files(Registry& r) {
  const Parameter x{.name = "x", .type = Type::shape};
  r.add({.name = "import_file",
         .group = "files",
         .parameters =
             {path,
              file_format,
              {.name = "check",
               .type = Type::boolean,
               .doc = "refuse what the checker finds fault with",
               .default_value = true,
               .keyword_only = true},
              {.name = "join",
               .type = Type::boolean,
               .doc = "imprint parts on each other that touch without sharing faces; False: leave them as they are",
               .default_value = true,
               .keyword_only = true}},
         .returns = "a shape",
         .doc = "Reads a model: STEP, BREP, STL, OBJ, PLY, OFF, by the path's ending.",
         .example = "import_file(\"part.step\")",
         .errors = {errors::file_unreadable},
         .function = import_shape});
  r.add({.name = "export",
         .group = "files",
         .parameters =
             {{.name = "x", .type = Type::shape, .doc = "a shape or a mesh"},
              path,
              file_format,
              {.name = "deflection",
               .type = Type::number,
               .doc = "of formats of triangles: greatest distance from the true shape; 0: a thousandth of its size",
               .unit = "length",
               .default_value = 0,
               .limits = not_negative,
               .keyword_only = true}},
         .doc = "Writes a shape (STEP, BREP, STL, OBJ) or a mesh (MSH, VTU, INP), by the path's ending.",
         .example = "export(plate, \"plate.step\")",
         .errors = {errors::file_unwritable},
         .function = export_shape});
  r.add({.name = "mesh",
         .group = "files",
         .parameters = {x,
                        {.name = "size",
                         .type = Type::number,
                         .doc = "wished length of the elements' sides; 0: a twelfth of the shape's size",
                         .unit = "length",
                         .default_value = 0,
                         .limits = not_negative},
                        {.name = "order",
                         .type = Type::integer,
                         .doc = "1: straight elements, 2: with nodes in the middle of their sides",
                         .default_value = 1,
                         .limits = {1, 2}},
                        {.name = "angle",
                         .type = Type::number,
                         .doc = "most that a curve may turn along one element",
                         .unit = "degrees",
                         .default_value = 20,
                         .limits = {5, 90}},
                        {.name = "grading",
                         .type = Type::number,
                         .doc = "growth of the size with distance",
                         .default_value = 0.3,
                         .limits = {0.05, 1}},
                        {.name = "dimension",
                         .type = Type::integer,
                         .doc = "1: edges, 2: and faces, 3: and regions",
                         .default_value = 3,
                         .limits = {1, 3}}},
         .returns = "a mesh, in which what touches shares nodes; names and groups become sets",
         .doc = "Makes a finite element mesh.",
         .example = "export(mesh(plate, size=0.5), \"plate.inp\")",
         .function = make_mesh});
  r.add({.name = "quality",
         .group = "measures",
         .parameters = {{.name = "m", .type = Type::shape, .doc = "a mesh"}},
         .returns = "a list of pairs (what, value)",
         .doc = "How good the elements of a mesh are.",
         .example = "for what, value in quality(mesh(b, size=0.3)): print(what, value)",
         .function = mesh_quality});
  r.add(
      {.name = "render",
       .group = "files",
       .parameters =
           {x,
            path,
            {.name = "view",
             .type = Type::string,
             .default_value = "iso",
             .choices = {"iso", "front", "back", "left", "right", "top", "bottom"}},
            {.name = "hidden_lines",
             .type = Type::boolean,
             .doc = "in SVG: remove the lines that cannot be seen",
             .default_value = false},
            {.name = "explode",
             .type = Type::number,
             .doc = "how far regions move apart; 1: to twice their distance from the middle, nested ones clear of each "
                    "other",
             .default_value = 0,
             .limits = not_negative},
            {.name = "width", .type = Type::integer, .unit = "pixels", .default_value = 1600, .limits = {16, 16384}},
            {.name = "height", .type = Type::integer, .unit = "pixels", .default_value = 1200, .limits = {16, 16384}},
            {.name = "perspective", .type = Type::boolean, .default_value = false},
            {.name = "opacity", .type = Type::number, .doc = "in PNG: of faces", .default_value = 1, .limits = {0, 1}},
            {.name = "coloring",
             .type = Type::string,
             .doc = "a colour for each region, or for each face",
             .default_value = "regions",
             .choices = {"regions", "faces"}},
            {.name = "title", .type = Type::string, .default_value = ""},
            file_format},
       .doc = "Draws a shape: PNG (shaded), SVG (lines), HTML (a page that turns it), by the path's ending.",
       .example = "render(plate, \"plate.png\", view=\"iso\")",
       .errors = {errors::file_unwritable},
       .function = render_shape});
}

}  // namespace aresta::document
