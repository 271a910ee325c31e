// SPDX-License-Identifier: Apache-2.0
// The non-manifold operators as commands on a complex, and the complex as text.
#include <charconv>

#include "document/commands.h"
#include "document/complex_shape.h"
#include "document/errors.h"
#include "document/shape.h"
#include "topology/betti.h"
#include "topology/dump.h"
#include "topology/dump_json.h"
#include "topology/notation.h"

namespace aresta::document {

namespace {

constexpr Limits from_zero{0, 4294967294.0};

const Parameter complex_parameter{.name = "m", .type = Type::shape, .doc = "a complex, from m_mr() or read_complex()"};

Parameter id(std::string name, std::string doc) {
  return {.name = std::move(name), .type = Type::integer, .doc = std::move(doc), .limits = from_zero};
}

Parameter optional_id(std::string name, std::string doc) {
  return {.name = std::move(name),
          .type = Type::integer,
          .doc = std::move(doc),
          .default_value = Value(),
          .limits = from_zero};
}

Parameter choice(std::string name, bool value, std::string doc) {
  return {.name = std::move(name), .type = Type::boolean, .doc = std::move(doc), .default_value = Value(value)};
}

Parameter side(std::string name, std::string doc) {
  return {.name = std::move(name),
          .type = Type::integer,
          .doc = std::move(doc),
          .default_value = Value(1),
          .limits = {0, 1}};
}

Parameter corner(std::string name) {
  return {.name = std::move(name),
          .type = Type::string,
          .doc = "a place on a face: \"c5\", where coedge 5 starts, or \"l3\", loop 3 that is a vertex"};
}

template <class IdType>
IdType id_of(const Call& call, std::string_view name) {
  return call[name].is_none() ? IdType() : IdType(static_cast<std::size_t>(call.integer(name)));
}

Error wrong_text(const Call& call, std::string_view name, const std::string& expected) {
  return Error{errors::command_type, call.command().name + ": " + std::string(name) + " must be " + expected +
                                         ", not " + given_text(call[name])};
}

/// "c12" after the letter; false when it is not that.
template <class IdType>
bool read_id(std::string_view text, char letter, IdType& id) {
  if (text.empty() || text.front() != letter) return false;
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == IdType::none) return false;
  id.value = value;
  return true;
}

Result<Corner> corner_of(const Call& call, std::string_view name) {
  Corner corner;
  const std::string& text = call.string(name);
  if (!read_id(text, 'c', corner.coedge) && !read_id(text, 'l', corner.vertex_loop)) {
    return wrong_text(call, name, "a corner as in \"c5\" or \"l3\"");
  }
  return corner;
}

/// Set apart by blanks.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(' ', at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

/// "e0 -e1 e2@c7 | v4": circuits of edges, "-" against the edge, "@c7" behind coedge 7; or a vertex.
Result<std::vector<Circuit>> circuits_of(const Call& call) {
  const std::string expected = "circuits of edges as in \"e0 -e1 e2@c7 | v4\"";
  std::vector<Circuit> circuits(1);
  for (std::string_view word : words_of(call.string("circuits"))) {
    Circuit& circuit = circuits.back();
    if (word == "|") {
      circuits.emplace_back();
      continue;
    }
    if (word.front() == 'v') {
      if (!circuit.uses.empty() || circuit.vertex.valid() || !read_id(word, 'v', circuit.vertex)) {
        return wrong_text(call, "circuits", expected);
      }
      continue;
    }
    EdgeUseSpec use;
    use.reversed = word.front() == '-';
    if (word.front() == '-' || word.front() == '+') word.remove_prefix(1);
    const std::size_t at = std::min(word.find('@'), word.size());
    if (!read_id(word.substr(0, at), 'e', use.edge) || circuit.vertex.valid() ||
        (at < word.size() && !read_id(word.substr(at + 1), 'c', use.after))) {
      return wrong_text(call, "circuits", expected);
    }
    circuit.uses.push_back(use);
  }
  for (const Circuit& circuit : circuits) {
    if (circuit.uses.empty() && !circuit.vertex.valid()) return wrong_text(call, "circuits", expected);
  }
  return circuits;
}

/// "-f3 e5 v7": sides of faces, wires and isolated vertices.
Result<std::vector<Item>> items_of(const Call& call, std::string_view name) {
  std::vector<Item> items;
  for (std::string_view word : words_of(call.string(name))) {
    const bool back = word.front() == '-';
    if (word.front() == '-' || word.front() == '+') word.remove_prefix(1);
    FaceId f;
    EdgeId e;
    VertexId v;
    if (read_id(word, 'f', f)) {
      items.emplace_back(FaceUse(f, back ? 1 : 0));
    } else if (read_id(word, 'e', e)) {
      items.emplace_back(e);
    } else if (read_id(word, 'v', v)) {
      items.emplace_back(v);
    } else {
      return wrong_text(call, name, "sides, wires and points as in \"-f3 e5 v7\"");
    }
  }
  return items;
}

Value number(std::uint32_t id) {
  return Value(static_cast<std::int64_t>(id));
}
template <class IdType>
Value number_or_none(IdType id) {
  return id.valid() ? number(id.value) : Value();
}

using Apply = std::function<Result<Applied>(Call&, Complex&)>;
using Answer = std::function<Value(const Applied&)>;

Value sub_case_of(const Applied& applied) {
  return Value(applied.sub_case);
}

Function function(Apply apply, Answer answer) {
  return [apply = std::move(apply), answer = std::move(answer)](Call& call) -> Result<Value> {
    ARESTA_TRY(const ComplexShape* const m, complex_shape(call, "m"));
    ComplexShape::State& state = m->state();
    ARESTA_TRY(Applied applied, apply(call, state.complex));
    Value result = answer(applied);
    state.done.push_back(std::move(applied));
    state.undone.clear();
    return result;
  };
}

Command operation(std::string name, std::vector<Parameter> parameters, std::string returns, std::string doc,
                  std::string example, Apply apply, Answer answer = sub_case_of) {
  parameters.insert(parameters.begin(), complex_parameter);
  return {.name = std::move(name),
          .group = "topology",
          .parameters = std::move(parameters),
          .returns = std::move(returns),
          .doc = std::move(doc),
          .example = std::move(example),
          .errors = {errors::unknown_part, errors::not_in_region, errors::ambiguous_place, errors::open_circuit,
                     errors::wrong_place, errors::in_use, errors::would_pinch, errors::senses_disagree,
                     errors::cuts_wire, errors::no_space},
          .function = function(std::move(apply), std::move(answer))};
}

const std::string what_happened =
    "what was made (m) and killed (k), as in \"kefl\": v vertex, e edge, f face, l loop, s shell, r region";

Result<Value> step(Call& call, bool back) {
  ARESTA_TRY(const ComplexShape* const m, complex_shape(call, "m"));
  ComplexShape::State& state = m->state();
  auto& from = back ? state.done : state.undone;
  auto& to = back ? state.undone : state.done;
  if (from.empty()) {
    return Error{errors::invalid_argument, back ? "undo: no operator was applied yet" : "redo: nothing was undone"};
  }
  Applied applied = std::move(from.back());
  from.pop_back();
  if (back) {
    take_back(state.complex, applied);
  } else {
    make_again(state.complex, applied);
  }
  Value name(applied.name + " " + applied.sub_case);
  to.push_back(std::move(applied));
  return name;
}

void register_making(Registry& r) {
  r.add(Command{.name = "m_mr",
                .group = "topology",
                .returns = "a complex: topology without coordinates, for the operators",
                .doc = "A new complex that holds nothing but infinite space, region 0.",
                .example = "m = m_mr()",
                .function = [](Call&) -> Result<Value> {
                  return Value(ShapePtr(std::make_shared<const ComplexShape>(m_mr())));
                }});
  r.add(operation(
      "m_sv", {id("region", "where the vertex lies")}, "the vertex's number", "Makes a vertex, alone in a region.",
      "v = m_sv(m, 0)", [](Call& c, Complex& k) { return m_sv(k, id_of<RegionId>(c, "region")); },
      [](const Applied& a) { return number(a.vertex.value); }));
  r.add(operation(
      "m_ev", {id("vertex", "where the edge starts"), optional_id("region", "needed where the vertex touches several")},
      "the numbers of the edge and of its new vertex", "Makes a wire from a vertex to a new one.", "e, w = m_ev(m, v)",
      [](Call& c, Complex& k) { return m_ev(k, id_of<VertexId>(c, "vertex"), id_of<RegionId>(c, "region")); },
      [](const Applied& a) {
        return Value::tuple({number(a.edge.value), number(a.vertex.value)});
      }));
  r.add(operation(
      "m_e",
      {id("start", "a vertex"), id("end", "a vertex; it may be the same"),
       optional_id("region", "needed where both touch several")},
      "the edge's number", "Makes a wire between two vertices that touch one region.", "e = m_e(m, v, w)",
      [](Call& c, Complex& k) {
        return m_e(k, id_of<VertexId>(c, "start"), id_of<VertexId>(c, "end"), id_of<RegionId>(c, "region"));
      },
      [](const Applied& a) { return number(a.edge.value); }));
  r.add(operation(
      "m_f",
      {{.name = "circuits",
        .type = Type::string,
        .doc = "edges head to tail, \"-\" against the edge, loops apart by \"|\", a vertex alone is a loop; \"e2@c7\": "
               "about "
               "edge 2 behind its coedge 7"},
       optional_id("region", "needed where the edges touch several"),
       choice("filled", true, "whether a region that the face closes off is a volume"),
       side("side", "the side of the face that looks into such a region: 0 front, 1 back"),
       {.name = "inside",
        .type = Type::string,
        .doc = "what else goes into such a region, as in \"-f3 e5 v7\"",
        .default_value = Value("")}},
      "the numbers of the face and of the region that it closes off, or None", "Makes a face into circuits of edges.",
      "f, r = m_f(m, \"e0 e1 -e2\")",
      [](Call& c, Complex& k) -> Result<Applied> {
        FaceSpec spec;
        ARESTA_TRY(spec.circuits, circuits_of(c));
        ARESTA_TRY(spec.division.others, items_of(c, "inside"));
        spec.region = id_of<RegionId>(c, "region");
        spec.division.filled = c.boolean("filled");
        spec.division.side = static_cast<int>(c.integer("side"));
        return m_f(k, spec);
      },
      [](const Applied& a) {
        return Value::tuple({number(a.face.value), number_or_none(a.region)});
      }));
  r.add(operation(
      "m_rsfl",
      {id("vertex", "the face's only corner"), optional_id("region", "needed where the vertex touches several"),
       choice("filled", true, "whether the inside is a volume")},
      "the numbers of the face and of the region inside", "Makes a closed face, a sphere, at a vertex.",
      "f, r = m_rsfl(m, v)",
      [](Call& c, Complex& k) {
        return m_rsfl(k, id_of<VertexId>(c, "vertex"), id_of<RegionId>(c, "region"), c.boolean("filled"));
      },
      [](const Applied& a) {
        return Value::tuple({number(a.face.value), number_or_none(a.region)});
      }));
  r.add(operation(
      "mm_vl", {id("face", "the face")}, "the numbers of the vertex and of the loop",
      "Makes a vertex inside a face, as a loop of it.", "v, l = mm_vl(m, f)",
      [](Call& c, Complex& k) { return mm_vl(k, id_of<FaceId>(c, "face")); },
      [](const Applied& a) {
        return Value::tuple({number(a.vertex.value), number(a.loop.value)});
      }));
  r.add(operation(
      "mm_ev", {corner("corner")}, "the numbers of the edge and of its new vertex",
      "Makes an edge from a corner into a face, to a new vertex.", "e, v = mm_ev(m, \"c0\")",
      [](Call& c, Complex& k) -> Result<Applied> {
        ARESTA_TRY(const Corner at, corner_of(c, "corner"));
        return mm_ev(k, at);
      },
      [](const Applied& a) {
        return Value::tuple({number(a.edge.value), number(a.vertex.value)});
      }));
  r.add(operation(
      "mm_e",
      {corner("start"),
       corner("end"),
       {.name = "moved",
        .type = Type::numbers,
        .doc = "loops that go to the new face",
        .default_value = Value::list({})}},
      "the numbers of the edge and of the new face, or None",
      "Makes an edge across a face between two corners: it divides the face, or makes two of its loops one.",
      "e, f = mm_e(m, \"c0\", \"c2\")",
      [](Call& c, Complex& k) -> Result<Applied> {
        ARESTA_TRY(const Corner from, corner_of(c, "start"));
        ARESTA_TRY(const Corner to, corner_of(c, "end"));
        std::vector<LoopId> moved;
        for (const double x : c.numbers("moved")) {
          if (x != std::floor(x) || !from_zero.holds(x)) return wrong_text(c, "moved", "a list of loop numbers");
          moved.emplace_back(static_cast<std::size_t>(x));
        }
        return mm_e(k, from, to, moved);
      },
      [](const Applied& a) {
        return Value::tuple({number(a.edge.value), number_or_none(a.face)});
      }));
}

void register_killing(Registry& r) {
  r.add(operation("k_v", {id("vertex", "the vertex")}, what_happened,
                  "Kills a vertex and all that needs it: a strut's edge, a loop, or every face and edge at it.",
                  "k_v(m, 3)", [](Call& c, Complex& k) { return k_v(k, id_of<VertexId>(c, "vertex")); }));
  r.add(operation(
      "k_e", {id("edge", "the edge"), optional_id("kept", "the face that stays where two become one")}, what_happened,
      "Kills an edge: a wire alone; between two faces these become one; in one loop twice this falls in two; else "
      "its faces go too.",
      "k_e(m, 2)", [](Call& c, Complex& k) { return k_e(k, id_of<EdgeId>(c, "edge"), id_of<FaceId>(c, "kept")); }));
  r.add(operation("k_f", {id("face", "the face"), optional_id("kept", "the region that stays where two become one")},
                  what_happened, "Kills a face; its edges stay, and the regions on its two sides become one.",
                  "k_f(m, 0)",
                  [](Call& c, Complex& k) { return k_f(k, id_of<FaceId>(c, "face"), id_of<RegionId>(c, "kept")); }));
  r.add(Command{.name = "k_m",
                .group = "topology",
                .parameters = {complex_parameter},
                .returns = "None",
                .doc = "Ends a complex, which must hold nothing but infinite space; an error says what is left.",
                .example = "k_m(m)",
                .errors = {errors::in_use},
                .function = [](Call& call) -> Result<Value> {
                  ARESTA_TRY(const ComplexShape* const m, complex_shape(call, "m"));
                  ARESTA_CHECK(k_m(m->complex()));
                  return Value();
                }});
}

void register_gluing(Registry& r) {
  r.add(operation("g_v", {id("kept", "the vertex that stays"), id("gone", "the vertex that goes")}, what_happened,
                  "Makes two vertices one that touch a common region.", "g_v(m, 0, 4)",
                  [](Call& c, Complex& k) { return g_v(k, id_of<VertexId>(c, "kept"), id_of<VertexId>(c, "gone")); }));
  r.add(operation(
      "g_e",
      {id("kept", "the edge that stays"), id("gone", "the edge that goes"),
       optional_id("kept_after", "the coedge behind which the sector of `kept` lies that is closed"),
       optional_id("gone_after", "the same of `gone`"), choice("opposite", false, "whether `gone` runs against `kept`"),
       choice("filled", true, "whether a region that is closed off is a volume"),
       side("side", "which sector looks into such a region: 0 behind kept_after, 1 the other")},
      what_happened, "Makes two edges one, and their ends too.", "g_e(m, 1, 5)", [](Call& c, Complex& k) {
        EdgeGluing gluing;
        gluing.kept_after = id_of<CoedgeId>(c, "kept_after");
        gluing.gone_after = id_of<CoedgeId>(c, "gone_after");
        gluing.opposite = c.boolean("opposite");
        gluing.division.filled = c.boolean("filled");
        gluing.division.side = static_cast<int>(c.integer("side"));
        return g_e(k, id_of<EdgeId>(c, "kept"), id_of<EdgeId>(c, "gone"), gluing);
      }));
  r.add(operation(
      "g_f",
      {id("kept", "the face that stays"),
       side("kept_side", "its side that looks at the other face: 0 front, 1 back"),
       id("gone", "the face that goes"),
       side("gone_side", "its side that looks at the first"),
       {.name = "pairs",
        .type = Type::sequence,
        .doc = "for each loop a coedge of `kept` and the one of `gone` that comes to lie on it, as in [(3, 17)]"}},
      what_happened, "Lays one face on another; the space between them goes.", "g_f(m, 0, 0, 6, 0, [(0, 24)])",
      [](Call& c, Complex& k) -> Result<Applied> {
        std::vector<std::pair<CoedgeId, CoedgeId>> pairs;
        if (!c["pairs"].is_sequence()) return wrong_text(c, "pairs", "a list of pairs of coedges");
        for (const Value& pair : c.items("pairs")) {
          const auto is_id = [](const Value& v) { return v.is(Value::Kind::integer) && from_zero.holds(v.number()); };
          if (!pair.is_sequence() || pair.items().size() != 2 || !is_id(pair.items()[0]) || !is_id(pair.items()[1])) {
            return wrong_text(c, "pairs", "a list of pairs of coedges");
          }
          pairs.emplace_back(static_cast<std::size_t>(pair.items()[0].integer()),
                             static_cast<std::size_t>(pair.items()[1].integer()));
        }
        const auto use = [&](const char* face, const char* face_side) {
          return FaceUse(id_of<FaceId>(c, face), static_cast<int>(c.integer(face_side)));
        };
        return g_f(k, use("kept", "kept_side"), use("gone", "gone_side"), pairs);
      }));
  r.add(operation(
      "esplit", {id("edge", "the edge")}, "the numbers of the new edge and of the vertex",
      "Makes a vertex in the middle of an edge; the old edge keeps its start.", "e, v = esplit(m, 0)",
      [](Call& c, Complex& k) { return esplit(k, id_of<EdgeId>(c, "edge")); },
      [](const Applied& a) {
        return Value::tuple({number(a.edge.value), number(a.vertex.value)});
      }));
  r.add(operation("esqueeze", {id("edge", "the edge"), optional_id("kept", "the end that stays; by default the start")},
                  what_happened, "Shrinks an edge to one of its vertices.", "esqueeze(m, 0)", [](Call& c, Complex& k) {
                    return esqueeze(k, id_of<EdgeId>(c, "edge"), id_of<VertexId>(c, "kept"));
                  }));
}

void register_text(Registry& r) {
  const auto undo_or_redo = [](bool back) {
    return Command{.name = back ? "undo" : "redo",
                   .group = "topology",
                   .parameters = {complex_parameter},
                   .returns = "the operator and its sub-case, as in \"M_E meks\"",
                   .doc = back ? "Takes back the last operator on a complex, as often as one likes."
                               : "Applies the operator again that was undone last.",
                   .example = back ? "undo(m)" : "redo(m)",
                   .errors = {errors::invalid_argument},
                   .function = [back](Call& call) { return step(call, back); }};
  };
  r.add(undo_or_redo(true));
  r.add(undo_or_redo(false));
  r.add(Command{
      .name = "dump",
      .group = "topology",
      .parameters = {{.name = "x", .type = Type::shape, .doc = "a complex, or a shape of one model"},
                     {.name = "format",
                      .type = Type::string,
                      .doc = "how it is written",
                      .default_value = Value("text"),
                      .choices = {"text", "json"}}},
      .returns = "the text, which read_complex() reads back",
      .doc = "The whole data structure: regions with their shells, faces with their loops, edges with their uses, "
             "vertices, and all links between them.",
      .example = "print(dump(m))",
      .function = [](Call& call) -> Result<Value> {
        const bool json = call.string("format") == "json";
        const auto text = [&](const Complex& k) { return Value(json ? dump_json(k) : dump(k)); };
        if (const auto* m = dynamic_cast<const ComplexShape*>(call.shape("x").get())) return text(m->complex());
        ARESTA_TRY(const ModelShapePtr x, model_shape(call, call.shape("x"), "x"));
        ARESTA_TRY(const auto model, as_model(*x, call.context()));
        return text(model->topology());
      }});
  r.add(Command{.name = "read_complex",
                .group = "topology",
                .parameters = {{.name = "text", .type = Type::string, .doc = "what dump() gave, or the short notation"},
                               {.name = "format",
                                .type = Type::string,
                                .doc = "what the text is",
                                .default_value = Value("text"),
                                .choices = {"text", "json", "notation"}}},
                .returns = "a complex",
                .doc = "Reads a complex back from its text; every invariant is checked.",
                .example = "m = read_complex(dump(block(1, 1, 1)))",
                .function = [](Call& call) -> Result<Value> {
                  const std::string& text = call.string("text");
                  ARESTA_TRY(Complex k, call.string("format") == "json"       ? parse_json(text)
                                        : call.string("format") == "notation" ? parse_notation(text)
                                                                              : parse_dump(text));
                  return Value(ShapePtr(std::make_shared<const ComplexShape>(std::move(k))));
                }});
  r.add(Command{.name = "betti",
                .group = "topology",
                .parameters = {complex_parameter},
                .returns = "three numbers: connected components, tunnels, voids",
                .doc = "The Betti numbers of a complex: of the union of its vertices, edges and faces in space.",
                .example = "components, tunnels, voids = betti(m)",
                .function = [](Call& call) -> Result<Value> {
                  ARESTA_TRY(const ComplexShape* const m, complex_shape(call, "m"));
                  const ComplexCounts n = counts(m->complex());
                  return Value::tuple({Value(static_cast<std::int64_t>(n.components)),
                                       Value(static_cast<std::int64_t>(n.tunnels)),
                                       Value(static_cast<std::int64_t>(n.voids))});
                }});
}

}  // namespace

std::string ComplexShape::describe() const {
  const Complex& k = complex();
  return "complex of " + std::to_string(k.vertex_count()) + " vertices, " + std::to_string(k.edge_count()) +
         " edges, " + std::to_string(k.face_count()) + " faces, " + std::to_string(k.region_count()) + " regions";
}

Result<const ComplexShape*> complex_shape(const Call& call, std::string_view parameter) {
  const ShapePtr shape = call.shape(parameter);
  if (const auto* m = dynamic_cast<const ComplexShape*>(shape.get())) return m;
  return Error{
      errors::command_type,
      call.command().name + ": " + std::string(parameter) + " must be a complex, not <" + shape->describe() + ">",
      {},
      {},
      "m_mr() makes a complex, read_complex(dump(x)) takes one from a shape"};
}

void register_topology(Registry& registry) {
  register_making(registry);
  register_killing(registry);
  register_gluing(registry);
  register_text(registry);
}

}  // namespace aresta::document
