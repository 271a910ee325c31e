// SPDX-License-Identifier: Apache-2.0
#include "model_commands.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>

#include "document/info.h"
#include "model/check.h"
#include "model_files.h"
#include "model_json.h"

namespace aresta::app {

using document::Value;

namespace {

constexpr std::size_t max_lines = 20;  // of names, regions, findings shown to a person

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string point_text(Vec3 p) {
  return figure(p.x) + " " + figure(p.y) + " " + figure(p.z);
}

std::string kinds_text(const std::map<std::string, std::size_t>& kinds) {
  std::string text;
  for (const auto& [kind, n] : kinds) text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
  return text.empty() ? "none" : text;
}

std::string summary_line(const document::ModelInfo& info) {
  return counted(info.regions, "region", "regions") + ", " + counted(info.faces, "face", "faces") + ", " +
         counted(info.edges, "edge", "edges") + ", " + counted(info.vertices, "vertex", "vertices") + "; volume " +
         figure(info.volume) + ", area " + figure(info.area);
}

std::string info_text(const std::string& file, const document::ModelInfo& info) {
  const std::string unit = document::unit_name(info.length_unit);
  std::string text = file + "\n";
  const auto line = [&text](const char* what, const std::string& value) {
    text += "  " + std::string(what) + std::string(12 - std::string(what).size(), ' ') + value + "\n";
  };
  line("regions", std::to_string(info.regions) + " (" + counted(info.shells, "shell", "shells") + "), in " +
                      counted(info.components, "component", "components"));
  line("faces",
       std::to_string(info.faces) + ": " + kinds_text(info.surfaces) +
           (info.constraint_faces > 0 ? "; " + counted(info.constraint_faces, "constraint", "constraints") : ""));
  line("edges", std::to_string(info.edges) + ": " + kinds_text(info.curves) +
                    (info.wire_edges > 0 ? "; " + counted(info.wire_edges, "wire", "wires") : ""));
  line("vertices", std::to_string(info.vertices) +
                       (info.isolated_vertices > 0 ? "; " + std::to_string(info.isolated_vertices) + " isolated" : ""));
  if (!info.bounds.empty())
    line("bounds", point_text(info.bounds.low) + " to " + point_text(info.bounds.high) + " " + unit);
  line("volume", figure(info.volume));
  line("area", figure(info.area));
  line("length", figure(info.length) + " of all edges");
  line("unit", unit);
  line("tolerance", figure(info.tolerance) + " (largest of an entity: " + figure(info.largest_tolerance) + ")");
  std::size_t shown = 0;
  for (const auto& [entity, name] : info.names) {
    if (++shown > max_lines) break;
    line("name", std::string(to_string(entity.kind)) + " " + std::to_string(entity.index) + " '" + name + "'");
  }
  if (shown > max_lines)
    line("", "and " + std::to_string(info.names.size() - max_lines) + " more names; --json lists all");
  for (const auto& [name, size] : info.groups)
    line("group", "'" + name + "' of " + counted(size, "entity", "entities"));
  return text;
}

/// What was done: a line for a person, or the figures of the result as JSON; nothing when the result itself goes there.
Result<int> tell(Program& program, const Value& shape, const std::string& out) {
  if (out == "-" || program.common.quiet) return static_cast<int>(status_done);
  ARESTA_TRY(const document::ModelInfo info, document::model_info(Commands::model_of(shape), program.context));
  ARESTA_CHECK(
      program.output.write(program.common.json ? json_text(to_json(info)) : out + ": " + summary_line(info) + "\n"));
  return static_cast<int>(status_done);
}

std::string format_in(const std::string& file, const Formats& formats) {
  if (!formats.input_format.empty()) return formats.input_format;
  return file == "-" ? formats.format : std::string();
}

std::string format_out(const std::string& file, const std::string& in, const Formats& formats) {
  return file == "-" || in != "-" || !formats.input_format.empty() ? formats.format : std::string();
}

/// "0,0,5, 0,0,1": a plane's point and normal.
Result<std::vector<Value>> six_numbers(const std::string& text) {
  std::vector<Value> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data();; ++at) {
    while (at < end && *at == ' ') ++at;
    if (at < end && *at == '+') ++at;
    double number = 0;
    const auto read = std::from_chars(at, end, number);
    if (read.ec != std::errc()) break;
    numbers.emplace_back(number);
    at = read.ptr;
    while (at < end && *at == ' ') ++at;
    if (at == end && numbers.size() == 6) return numbers;
    if (at == end || *at != ',') break;
  }
  return Error{usage_error, "--plane takes six numbers px,py,pz,nx,ny,nz: a point and the normal, not '" + text + "'"};
}

}  // namespace

std::string figure(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

Result<int> show_info(Program& program, const FileOptions& options) {
  Commands commands(program);
  ARESTA_TRY(const Value shape,
             commands.import(options.file, options.input_format.empty() ? options.format : options.input_format));
  ARESTA_TRY(const document::ModelInfo info, document::model_info(Commands::model_of(shape), program.context));
  if (program.common.json) {
    Json json = to_json(info);
    json["file"] = options.file;
    ARESTA_CHECK(program.output.write(json_text(json)));
  } else {
    ARESTA_CHECK(program.output.write(info_text(options.file, info)));
  }
  return static_cast<int>(status_done);
}

Result<int> check_file(Program& program, const FileOptions& options) {
  Commands commands(program);
  ARESTA_TRY(
      const Value shape,
      commands.import(options.file, options.input_format.empty() ? options.format : options.input_format, false));
  ARESTA_TRY(const std::vector<Finding> findings, check(*Commands::model_of(shape), CheckLevel::full, program.context));
  if (program.common.json) {
    Json list = Json::array();
    for (const Finding& f : findings) {
      Json entities = Json::array();
      for (const EntityRef e : f.entities)
        entities.push_back(std::string(to_string(e.kind)) + " " + std::to_string(e.index));
      list.push_back({{"kind", to_string(f.kind)},
                      {"entities", entities},
                      {"place", {f.place.x, f.place.y, f.place.z}},
                      {"value", f.value},
                      {"allowed", f.allowed},
                      {"message", f.message}});
    }
    ARESTA_CHECK(program.output.write(json_text({{"file", options.file}, {"findings", list}})));
  } else {
    for (const Finding& f : findings) {
      std::string line = std::string(to_string(f.kind)) + ":";
      for (const EntityRef e : f.entities) line += std::string(" ") + to_string(e.kind) + " " + std::to_string(e.index);
      ARESTA_CHECK(program.output.write(line + " at " + point_text(f.place) + ": " + f.message + "\n"));
    }
    if (!program.common.quiet) {
      ARESTA_CHECK(program.output.write(
          options.file + ": " + (findings.empty() ? "all is well" : counted(findings.size(), "finding", "findings")) +
          "\n"));
    }
  }
  return static_cast<int>(findings.empty() ? status_done : status_findings);
}

Result<int> convert_file(Program& program, const ConvertOptions& options) {
  ARESTA_CHECK(check_output(Product::model, options.in, options.out, format_out(options.out, options.in, options)));
  Commands commands(program);
  ARESTA_TRY(const Value shape, commands.import(options.in, format_in(options.in, options)));
  ARESTA_CHECK(commands.write("export", shape, options.out, format_out(options.out, options.in, options)));
  return tell(program, shape, options.out);
}

Result<int> fragment_files(Program& program, const FragmentCommandOptions& options) {
  ARESTA_CHECK(check_inputs(options.in));
  const std::string& first = options.in.front();
  ARESTA_CHECK(check_output(Product::model, first, options.out, format_out(options.out, first, options)));
  Commands commands(program);
  std::vector<Value> parts;
  for (const std::string& file : options.in) {
    ARESTA_TRY(const Value shape, commands.import(file, format_in(file, options)));
    ARESTA_TRY(const Value components, commands.call("components", {shape}));
    parts.insert(parts.end(), components.items().begin(), components.items().end());
  }
  ARESTA_TRY(const Value result, commands.call("fragment", {Value::list(std::move(parts))}));
  ARESTA_CHECK(commands.write("export", result, options.out, format_out(options.out, first, options)));
  return tell(program, result, options.out);
}

Result<int> boolean_files(Program& program, const BooleanCommandOptions& options) {
  ARESTA_CHECK(check_inputs({options.a, options.b}));
  const std::string format = format_out(options.out, options.a == "-" ? options.a : options.b, options);
  ARESTA_CHECK(check_output(Product::model, options.a, options.out, format));
  Commands commands(program);
  ARESTA_TRY(const Value a, commands.import(options.a, format_in(options.a, options)));
  ARESTA_TRY(const Value b, commands.import(options.b, format_in(options.b, options)));
  ARESTA_TRY(Value result, commands.call(options.operation, {a, b}, {{"regularise", Value(options.regularise)}}));
  if (options.simplify) {
    ARESTA_TRY(result, commands.call("simplify", {result}));
  }
  ARESTA_CHECK(commands.write("export", result, options.out, format));
  return tell(program, result, options.out);
}

Result<int> mesh_file(Program& program, const MeshCommandOptions& options) {
  ARESTA_CHECK(check_output(Product::mesh, options.in, options.out, format_out(options.out, options.in, options)));
  Commands commands(program);
  ARESTA_TRY(const Value shape, commands.import(options.in, format_in(options.in, options)));
  ARESTA_TRY(const Value mesh,
             commands.call("mesh", {shape}, {{"size", Value(options.size)}, {"order", Value(options.order)}}));
  ARESTA_CHECK(commands.write("export", mesh, options.out, format_out(options.out, options.in, options)));
  if (options.out == "-" || program.common.quiet) return static_cast<int>(status_done);
  ARESTA_TRY(const Value nodes, commands.call("count", {mesh, Value("nodes")}));
  ARESTA_TRY(const Value elements, commands.call("count", {mesh, Value("elements")}));
  ARESTA_TRY(const Value quality, commands.call("quality", {mesh}));
  if (program.common.json) {
    Json json{{"nodes", nodes.integer()}, {"elements", elements.integer()}};
    for (const Value& pair : quality.items()) {
      const Value& v = pair.items()[1];
      if (v.is(Value::Kind::integer))
        json["quality"][pair.items()[0].string()] = v.integer();
      else
        json["quality"][pair.items()[0].string()] = v.real();
    }
    ARESTA_CHECK(program.output.write(json_text(json)));
  } else {
    std::string line = options.out + ": " + counted(static_cast<std::size_t>(nodes.integer()), "node", "nodes") + ", " +
                       counted(static_cast<std::size_t>(elements.integer()), "element", "elements");
    for (const Value& pair : quality.items()) {
      if (pair.items()[0].string() == "smallest angle")
        line += "; smallest angle " + figure(pair.items()[1].number()) + " degrees";
    }
    ARESTA_CHECK(program.output.write(line + "\n"));
  }
  return static_cast<int>(status_done);
}

Result<int> render_file(Program& program, const RenderCommandOptions& options) {
  ARESTA_CHECK(check_output(Product::picture, options.in, options.out, format_out(options.out, options.in, options)));
  Commands commands(program);
  ARESTA_TRY(const Value shape, commands.import(options.in, format_in(options.in, options)));
  ARESTA_CHECK(commands.write("render", shape, options.out, format_out(options.out, options.in, options),
                              {{"view", Value(options.view)},
                               {"hidden_lines", Value(options.hidden_lines)},
                               {"explode", Value(options.explode)},
                               {"perspective", Value(options.perspective)},
                               {"opacity", Value(options.opacity)},
                               {"width", Value(options.width)},
                               {"height", Value(options.height)}}));
  return static_cast<int>(status_done);
}

Result<int> cut_file(Program& program, const CutCommandOptions& options) {
  ARESTA_TRY(const std::vector<Value> plane, six_numbers(options.plane));
  if (options.above.empty() && options.below.empty() && options.section.empty()) {
    return Error{usage_error, "cut: say where results go: --above, --below or --section"};
  }
  std::vector<std::string> places;
  for (const std::string& out : {options.above, options.below, options.section}) {
    if (out.empty()) continue;
    ARESTA_CHECK(check_output(Product::model, options.in, out, format_out(out, options.in, options)));
    const std::string place = std::filesystem::weakly_canonical(std::filesystem::absolute(out)).string();
    if (std::find(places.begin(), places.end(), place) != places.end())
      return Error{usage_error, "cut: '" + out + "' is given for two results"};
    places.push_back(place);
  }
  Commands commands(program);
  const Value point = Value::tuple({plane[0], plane[1], plane[2]}),
              normal = Value::tuple({plane[3], plane[4], plane[5]});
  ARESTA_TRY(const Value shape, commands.import(options.in, format_in(options.in, options)));
  std::vector<ShapeOutput> outputs;
  const auto put = [&](const Value& result, const std::string& file) {
    if (!file.empty()) outputs.push_back({result, file, format_out(file, options.in, options)});
  };
  if (!options.above.empty() || !options.below.empty()) {
    ARESTA_TRY(const Value halves, commands.call("cut", {shape, point, normal}));
    put(halves.items()[0], options.above);
    put(halves.items()[1], options.below);
  }
  if (!options.section.empty()) {
    ARESTA_TRY(const Value section, commands.call("section", {shape, point, normal}));
    put(section, options.section);
  }
  ARESTA_CHECK(commands.export_all(outputs));
  for (const ShapeOutput& o : outputs) ARESTA_CHECK(tell(program, o.shape, o.file));
  return static_cast<int>(status_done);
}

}  // namespace aresta::app
