// SPDX-License-Identifier: Apache-2.0
#include "topology/dump_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "topology/canonical.h"
#include "topology/lexer.h"
#include "topology/records.h"

namespace aresta {

namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

constexpr std::uint32_t largest_id = (1u << 30) - 1;

// --- writing

template <class Range>
OrderedJson ids(const Range& range) {
  OrderedJson list = OrderedJson::array();
  for (const auto id : range) list.push_back(id.value);
  return list;
}

OrderedJson json_of(const std::vector<Item>& items) {
  if (!items.empty() && items.front().kind == Item::Kind::point) return {{"vertex", items.front().index}};
  OrderedJson shell{{"front", OrderedJson::array()}, {"back", OrderedJson::array()}, {"wires", OrderedJson::array()}};
  for (const Item item : items) {
    if (item.kind == Item::Kind::wire) {
      shell["wires"].push_back(item.index);
    } else {
      shell[item.side().side() == 0 ? "front" : "back"].push_back(item.side().face().value);
    }
  }
  return shell;
}

OrderedJson json_of(const Complex& k, RegionId r) {
  OrderedJson shells = OrderedJson::array();
  for (const auto& items : canonical_shells(k, r)) shells.push_back(json_of(items));
  const char* kind = k.is_filled(r) ? "filled" : r == k.infinite_region() ? "infinite" : "empty";
  return {{"id", r.value}, {"kind", kind}, {"shells", std::move(shells)}};
}

OrderedJson json_of(const Complex& k, LoopId l) {
  if (k.is_vertex_loop(l)) return {{"id", l.value}, {"vertex", k.loop_vertex(l).value}};
  OrderedJson coedges = OrderedJson::array();
  for (const CoedgeId c : canonical_coedges(k, l)) {
    coedges.push_back({{"id", c.value},
                       {"edge", k.edge(c).value},
                       {"reversed", k.reversed(c)},
                       {"start", k.start(c).value},
                       {"end", k.end(c).value},
                       {"radial", k.radial(c).value}});
  }
  return {{"id", l.value}, {"coedges", std::move(coedges)}};
}

OrderedJson json_of(const Complex& k, FaceId f) {
  OrderedJson loops = OrderedJson::array();
  for (const LoopId l : canonical_loops(k, f)) loops.push_back(json_of(k, l));
  return {{"id", f.value},
          {"front", k.region(FaceUse(f, 0)).value},
          {"back", k.region(FaceUse(f, 1)).value},
          {"loops", std::move(loops)}};
}

OrderedJson json_of(const Complex& k, EdgeId e) {
  OrderedJson edge{{"id", e.value}, {"start", k.start(e).value}, {"end", k.end(e).value}};
  if (k.is_wire(e)) {
    edge["wire_in"] = k.region(k.wire_shell(e)).value;
  } else {
    edge["coedges"] = ids(canonical_coedges(k, e));
  }
  return edge;
}

OrderedJson json_of(const Complex& k, VertexId v) {
  OrderedJson vertex{{"id", v.value}};
  if (const ShellId s = k.isolated_in_shell(v); s.valid()) {
    vertex["isolated_in"] = k.region(s).value;
    return vertex;
  }
  vertex["starting"] = OrderedJson::array();
  vertex["ending"] = OrderedJson::array();
  for (const EdgeEnd end : canonical_edge_ends(k, v)) {
    vertex[end.end == 0 ? "starting" : "ending"].push_back(end.edge.value);
  }
  vertex["loops"] = ids(canonical_vertex_loops(k, v));
  return vertex;
}

template <class Range>
void put_list(std::string& text, const Complex& k, const char* name, const Range& range) {
  text += ",\n\"" + std::string(name) + "\": [";
  const char* separator = "\n";
  for (const auto id : range) {
    text += separator + json_of(k, id).dump();
    separator = ",\n";
  }
  text += "]";
}

// --- reading

/// Where a value is, as in /faces/0/loops; put into words for errors alone.
struct Path {
  const Path* parent = nullptr;
  const char* name = nullptr;
  std::size_t index = 0;

  std::string text() const {
    if (parent == nullptr) return "";
    return parent->text() + "/" + (name != nullptr ? std::string(name) : std::to_string(index));
  }
};

/// Reads values until the first error, which stays.
class Reader {
 public:
  Result<ComplexRecords> run(const Json& root) {
    const Path top;
    if (member(root, "format", top) != "aresta complex") fail({&top, "format"}, "\"aresta complex\"");
    const Json& version = member(root, "version", top);
    if (!failed() && version != 1) {
      error_ = Error{errors::dump_version, "/version: 1 is expected"};
    }
    each(root, "regions", top, [&](const Json& value, const Path& path) { read_region(value, path); });
    each(root, "faces", top, [&](const Json& value, const Path& path) { read_face(value, path); });
    each(root, "edges", top, [&](const Json& value, const Path& path) { read_edge(value, path); });
    each(root, "vertices", top,
         [&](const Json& value, const Path& path) { records_.vertices.push_back({id<VertexId>(value, path)}); });
    if (error_) return *std::move(error_);
    return std::move(records_);
  }

 private:
  bool failed() const { return error_.has_value(); }
  void fail(const Path& path, const std::string& wanted) {
    if (!failed())
      error_ = Error{errors::bad_dump, (path.parent == nullptr ? "/" : path.text()) + ": " + wanted + " is expected"};
  }

  /// A member of an object; null when there is none, which is an error.
  const Json& member(const Json& object, const char* name, const Path& path) {
    static const Json null;
    if (!failed() && object.is_object()) {
      if (const auto at = object.find(name); at != object.end()) return *at;
    }
    fail(path, "an object with \"" + std::string(name) + "\"");
    return null;
  }

  template <class Visit>
  void each(const Json& object, const char* name, const Path& path, Visit&& visit) {
    const Json& list = member(object, name, path);
    const Path here{&path, name};
    if (!list.is_array()) fail(here, "a list");
    for (std::size_t i = 0; !failed() && i < list.size(); ++i) visit(list[i], Path{&here, nullptr, i});
  }

  template <class IdType>
  IdType id(const Json& object, const Path& path, const char* name = "id") {
    return IdType(number(member(object, name, path), Path{&path, name}));
  }
  std::uint32_t number(const Json& value, const Path& path) {
    if (value.is_number_unsigned()) {
      return static_cast<std::uint32_t>(std::min<std::uint64_t>(value.get<std::uint64_t>(), largest_id));
    }
    fail(path, "an id");
    return 0;
  }

  void read_region(const Json& value, const Path& path) {
    const RegionId r = id<RegionId>(value, path);
    const Json& kind = member(value, "kind", path);
    if (kind != "infinite" && kind != "filled" && kind != "empty") {
      fail({&path, "kind"}, "\"infinite\", \"filled\" or \"empty\"");
    }
    records_.regions.push_back({r, kind == "filled"});
    each(value, "shells", path, [&](const Json& shell, const Path& here) { read_shell(shell, here, r); });
  }

  void read_shell(const Json& value, const Path& path, RegionId r) {
    const auto index = static_cast<std::uint32_t>(records_.shells.size());
    records_.shells.push_back({r});
    if (value.is_object() && value.contains("vertex")) {
      records_.items.push_back({id<VertexId>(value, path, "vertex"), index});
      return;
    }
    const auto read_side = [&](const char* name, int side) {
      each(value, name, path, [&](const Json& face, const Path& here) {
        records_.items.push_back({FaceUse(FaceId(number(face, here)), side), index});
      });
    };
    read_side("front", 0);
    read_side("back", 1);
    each(value, "wires", path, [&](const Json& edge, const Path& here) {
      records_.items.push_back({EdgeId(number(edge, here)), index});
    });
  }

  void read_face(const Json& value, const Path& path) {
    const auto index = static_cast<std::uint32_t>(records_.faces.size());
    records_.faces.push_back({id<FaceId>(value, path)});
    each(value, "loops", path, [&](const Json& loop, const Path& here) { read_loop(loop, here, index); });
  }

  void read_loop(const Json& value, const Path& path, std::uint32_t face) {
    const auto index = static_cast<std::uint32_t>(records_.loops.size());
    records_.loops.push_back({id<LoopId>(value, path), VertexId(), face});
    if (value.is_object() && value.contains("vertex")) {
      records_.loops.back().vertex = id<VertexId>(value, path, "vertex");
      return;
    }
    each(value, "coedges", path, [&](const Json& coedge, const Path& here) {
      const Json& reversed = member(coedge, "reversed", here);
      if (!reversed.is_boolean()) fail({&here, "reversed"}, "true or false");
      records_.coedges.push_back(
          {id<CoedgeId>(coedge, here), id<EdgeId>(coedge, here, "edge"), reversed == true, index});
    });
  }

  void read_edge(const Json& value, const Path& path) {
    const auto index = static_cast<std::uint32_t>(records_.edges.size());
    records_.edges.push_back(
        {id<EdgeId>(value, path), id<VertexId>(value, path, "start"), id<VertexId>(value, path, "end")});
    if (value.is_object() && value.contains("wire_in")) return;
    each(value, "coedges", path, [&](const Json& coedge, const Path& here) {
      records_.uses.push_back({CoedgeId(number(coedge, here)), index});
    });
  }

  ComplexRecords records_;
  std::optional<Error> error_;
};

Error differs(const std::string& path) {
  return Error{errors::dump_differs, path + ": not as the rest asks for"};
}

/// The path of the first thing in which two values differ; as deep as `wanted` is.
std::optional<std::string> find_difference(const OrderedJson& wanted, const Json& found) {
  if (wanted.type() != found.type()) return "";
  if (wanted.is_object()) {
    for (const auto& [name, value] : wanted.items()) {
      const auto at = found.find(name);
      if (at == found.end()) return "/" + name;
      if (auto inside = find_difference(value, *at)) return "/" + name + *inside;
    }
    for (const auto& [name, value] : found.items()) {
      if (!wanted.contains(name)) return "/" + name;
    }
    return {};
  }
  if (wanted.is_array()) {
    for (std::size_t i = 0; i < std::max(wanted.size(), found.size()); ++i) {
      if (i >= std::min(wanted.size(), found.size())) return "/" + std::to_string(i);
      if (auto inside = find_difference(wanted[i], found[i])) return "/" + std::to_string(i) + *inside;
    }
    return {};
  }
  if (Json(wanted) != found) return "";
  return {};
}

template <class Range>
Status compare_list(const Json& found, const Complex& k, const char* name, const Range& range) {
  const std::string path = "/" + std::string(name) + "/";
  const Json& list = found[name];
  std::size_t i = 0;
  for (const auto id : range) {
    const auto inside = i < list.size() ? find_difference(json_of(k, id), list[i]) : "";
    if (inside) return differs(path + std::to_string(i) + *inside);
    ++i;
  }
  return i < list.size() ? differs(path + std::to_string(i)) : Status();
}

/// What is said twice, and its order, is right when the result gives the same values.
Status compare(const Json& found, const Complex& k) {
  for (const auto& [name, value] : found.items()) {
    static const char* const known[] = {"format", "version", "regions", "faces", "edges", "vertices"};
    if (std::find(std::begin(known), std::end(known), name) == std::end(known)) return differs("/" + name);
  }
  ARESTA_CHECK(compare_list(found, k, "regions", k.regions()));
  ARESTA_CHECK(compare_list(found, k, "faces", k.faces()));
  ARESTA_CHECK(compare_list(found, k, "edges", k.edges()));
  return compare_list(found, k, "vertices", k.vertices());
}

/// How deep brackets are nested; the values of a deep text are not even made.
std::size_t depth(std::string_view text) {
  std::size_t now = 0, most = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == '[' || c == '{')) {
      most = std::max(most, ++now);
    } else if (!in_string && (c == ']' || c == '}') && now > 0) {
      --now;
    }
  }
  return most;
}

Result<Json> read_values(std::string_view text) {
  constexpr std::size_t deepest = 16;
  if (depth(text) > deepest) return Error{errors::bad_dump, "brackets are nested too deep"};
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::size_t byte = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
    return Error{errors::bad_dump, at_line(static_cast<std::uint32_t>(line)) + "this is no JSON"};
  } catch (const Json::exception&) {
    return Error{errors::bad_dump, "a number is too large"};
  }
}

}  // namespace

std::string dump_json(const Complex& k) {
  std::string text = "{\"format\": \"aresta complex\", \"version\": 1";
  put_list(text, k, "regions", k.regions());
  put_list(text, k, "faces", k.faces());
  put_list(text, k, "edges", k.edges());
  put_list(text, k, "vertices", k.vertices());
  return text + "}\n";
}

Result<Complex> parse_json(std::string_view text) {
  ARESTA_TRY(const Json found, read_values(text));
  ARESTA_TRY(const ComplexRecords records, Reader().run(found));
  ARESTA_TRY(Complex k, rebuild(records));
  ARESTA_CHECK(compare(found, k));
  return k;
}

}  // namespace aresta
